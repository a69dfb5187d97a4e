//! Derivation + layout → scene: every leaf becomes a cover, a solid, a line, a plant or an object.
//!
//! In: what rules made and what the layout holds. Out: the scene, with materials looked up and places in the plan, and
//! what had to be left out of it.
//! A leaf's material is its `material.name`, else a ground cover that its symbol names, else its bare colour.

use crate::diag::{Diagnostic, Place, Severity};
use crate::element::{Catalogue, Entry, Material, PlantFigures, Texture};
use crate::geometry::{self, Area};
use crate::layout::{Feature, Kind, Layout, Shapes};
use crate::scene::{Cover, Line, LotOutline, Object, Origin, Plant, Report, Scene, Solid};
use crate::shape::{Derivation, Extent, Geometry, Grown, LeafOf, Lot, Placed, Shape, on_plan};
use crate::value::Value;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The height of buildings whose height is not known, metres.
const USUAL_BUILDING: f64 = 8.0;
/// How thick an upright face is drawn, metres.
const THIN: f64 = 0.08;

/// What lies or reaches farther than this (metres) is a slip of the rules, and beyond what formats can carry.
const FARTHEST: f64 = 1e7;

/// Resolves a derivation on its layout; what is left out is told once for each rule and lot.
///
/// Cost: linear in leaves; meshes cost a union of their faces.
pub fn resolve(
    layout: &Layout,
    derivation: &Derivation,
    catalogue: &Catalogue,
    title: &str,
) -> (Scene, Vec<Diagnostic>) {
    let mut resolver =
        Resolver { catalogue, materials: BTreeMap::new(), scene: Scene::default(), lost: BTreeMap::new() };
    resolver.scene.title = title.into();
    resolver.scene.georeference = layout.georeference.clone();
    resolver.scene.lots = layout.regions.iter().map(outline).collect();
    let under = |feature: &&Feature| matches!(feature.kind, Kind::Street | Kind::Footway);
    layout.features.iter().filter(under).for_each(|feature| resolver.feature(feature));
    derivation.lots.iter().for_each(|lot| resolver.lot(derivation, lot));
    layout.features.iter().filter(|feature| !under(feature)).for_each(|feature| resolver.feature(feature));
    // The layout's plants stand first, whatever else of it was drawn when.
    resolver.scene.plants.sort_by_key(|plant| !plant.existing);
    resolver.scene.reports = reports(derivation);
    let lost = resolver.lost.iter().map(|((lot, rule), count)| left_out(lot, rule, *count)).collect();
    (resolver.scene, lost)
}

fn left_out(lot: &Arc<str>, rule: &str, count: usize) -> Diagnostic {
    let shapes = crate::text::counted(count, "shape");
    let message = format!("{shapes} of `{rule}` left out: farther than 10,000 km from the centre, or larger");
    let diagnostic = Diagnostic::new(Severity::Error, "geometry", Place::Run, message);
    Diagnostic { lot: Some(lot.clone()), ..diagnostic }
}

fn outline(region: &crate::layout::Region) -> LotOutline {
    LotOutline {
        id: region.id.clone(),
        name: region.name.clone(),
        kind: region.kind.word().into(),
        zone: region.zone.clone(),
        area: region.polygon.clone().into(),
    }
}

fn reports(derivation: &Derivation) -> Vec<Report> {
    let mut reports: BTreeMap<Arc<str>, Report> = BTreeMap::new();
    for (key, value) in derivation.lots.iter().flat_map(|lot| &lot.outcome.reports) {
        reports.entry(key.clone()).or_insert_with(|| Report::new(key.clone())).add(value);
    }
    reports.into_values().collect()
}

/// What a material is looked up by: word, symbol, colour bits.
type MaterialKey = (Option<Arc<str>>, Arc<str>, Option<[u32; 4]>);

struct Resolver<'a> {
    catalogue: &'a Catalogue,
    materials: BTreeMap<MaterialKey, Arc<Material>>,
    scene: Scene,
    /// Leaves that are too far away or too large, by lot and rule.
    lost: BTreeMap<(Arc<str>, Arc<str>), usize>,
}

impl Resolver<'_> {
    fn lot(&mut self, derivation: &Derivation, lot: &Lot) {
        for leaf in &lot.outcome.leaves {
            let symbol = lot.outcome.nodes[leaf.node.0 as usize].symbol;
            let rule = derivation.symbols[symbol as usize].clone();
            if !is_placeable(&leaf.shape) {
                *self.lost.entry((lot.id.clone(), rule)).or_default() += 1;
                continue;
            }
            let id = format!("{:016x}", leaf.shape.seed.0).into();
            self.leaf(leaf, Origin { lot: lot.id.clone(), rule, id });
        }
    }

    fn leaf(&mut self, leaf: &LeafOf, origin: Origin) {
        let shape = &leaf.shape;
        match &shape.geometry {
            Geometry::Empty | Geometry::Point => {}
            Geometry::Element(placed) => self.element(shape, placed, origin),
            Geometry::Path(points) => {
                let material = self.material(shape, &origin.rule);
                let points: Vec<DVec3> = points.iter().map(|p| shape.scope.frame.to_world(*p)).collect();
                let elevation = points[0].y;
                let points = points.into_iter().map(on_plan).collect();
                self.scene.lines.push(Line { origin, material, points, elevation });
            }
            Geometry::Flat(..) | Geometry::Prism(..) | Geometry::Mesh(_) => self.surface(shape, origin),
        }
    }

    /// A flat shape that lies level is a cover, all else a solid.
    fn surface(&mut self, shape: &Shape, origin: Origin) {
        let (material, surface) = (self.material(shape, &origin.rule), shape.style.surface.clone());
        let footprint = shape.footprint();
        let height = footprint.high - footprint.low;
        let area = match footprint.extent {
            Extent::Area(area) => area,
            Extent::Line(points) => geometry::stroke(&points, THIN),
            Extent::Nothing | Extent::Point(_) => Area::empty(),
        };
        let level = matches!(shape.geometry, Geometry::Flat(..)) && height < 1e-6;
        if level {
            self.scene.covers.push(Cover { origin, material, area, elevation: footprint.low, surface });
            return;
        }
        let upright = matches!(shape.geometry, Geometry::Prism(..)) && is_upright(shape);
        let mesh = if upright { None } else { shape.world_mesh().map(Arc::new) };
        let (base, footprint) = (footprint.low, area);
        self.scene.solids.push(Solid { origin, material, footprint, base, height, mesh, surface });
    }

    fn element(&mut self, shape: &Shape, placed: &Placed, origin: Origin) {
        let Some(entry) = self.catalogue.by_id(&placed.entry) else { return };
        let Some(variant) = entry.variant(&placed.kind) else { return };
        match variant.plant {
            Some(figures) => self.scene.plants.push(plant(shape, placed, entry, figures, origin)),
            None => {
                let object = object(shape, placed, entry, origin, variant.model.clone());
                self.scene.objects.push(object);
            }
        }
    }

    /// What a leaf is made of.
    fn material(&mut self, shape: &Shape, symbol: &Arc<str>) -> Arc<Material> {
        let style = &shape.style;
        let color = style.color;
        let key = (style.material.clone(), symbol.clone(), color.map(|c| c.map(f32::to_bits)));
        let catalogue = self.catalogue;
        let make = || {
            let word = style.material.as_ref().unwrap_or(symbol);
            let known = catalogue.cover(word).map(|cover| cover.material.clone());
            match (known, color) {
                (Some(material), None) => material,
                (Some(material), Some(fill)) => Arc::new(Material { fill, line: darker(fill), ..(*material).clone() }),
                (None, color) => Arc::new(plain(word, color)),
            }
        };
        self.materials.entry(key).or_insert_with(make).clone()
    }

    /// A feature of the layout, as it stands.
    fn feature(&mut self, feature: &Feature) {
        let origin = Origin { lot: "".into(), rule: "".into(), id: feature.id.clone() };
        match (&feature.kind, &feature.shapes) {
            (Kind::Tree, Shapes::Points(points)) => {
                for point in points {
                    let plant = standing(self.catalogue, feature, *point, origin.clone());
                    self.scene.plants.push(plant);
                }
            }
            (_, Shapes::Points(points)) => {
                points.iter().for_each(|point| self.marker(feature, *point, origin.clone()));
            }
            (_, Shapes::Areas(polygons)) => {
                let area: Area = polygons.iter().cloned().collect();
                self.ground(feature, area, origin);
            }
            (Kind::Street | Kind::Footway | Kind::Driveway | Kind::Water, Shapes::Lines(lines, width))
                if *width > 0.0 =>
            {
                let strokes: Vec<Area> = lines.iter().map(|line| geometry::stroke(line, *width)).collect();
                self.ground(feature, geometry::union_all(&strokes), origin);
            }
            (_, Shapes::Lines(lines, _)) => {
                let material = self.word(feature.kind.word());
                for line in lines {
                    let (origin, material, points) = (origin.clone(), material.clone(), line.clone());
                    self.scene.lines.push(Line { origin, material, points, elevation: feature.elevation });
                }
            }
        }
    }

    fn ground(&mut self, feature: &Feature, area: Area, origin: Origin) {
        let own = feature.attributes.get("material").and_then(Value::as_str);
        let material = self.word(own.unwrap_or(feature.kind.word()));
        let height = match feature.kind {
            Kind::Building if feature.height <= 0.0 => USUAL_BUILDING,
            _ => feature.height,
        };
        if height > 0.0 && feature.kind != Kind::Water {
            let base = feature.elevation;
            self.scene.solids.push(Solid {
                origin,
                material,
                footprint: area,
                base,
                height,
                mesh: None,
                surface: None,
            });
        } else {
            self.scene.covers.push(Cover { origin, material, area, elevation: feature.elevation, surface: None });
        }
    }

    /// A marker that the catalogue knows (a statue, a jet) is drawn; others only tell rules where something is.
    fn marker(&mut self, feature: &Feature, at: DVec2, origin: Origin) {
        let variant = feature.attributes.get("variant").and_then(Value::as_str).unwrap_or_default();
        let Ok(found) = self.catalogue.find(feature.kind.word(), variant) else { return };
        if found.variant.plant.is_some() {
            return;
        }
        let size = found.variant.size;
        let heading = feature.attributes.get("heading").and_then(Value::as_float).unwrap_or(0.0);
        let turn = DVec2::from_angle(heading.to_radians());
        let footprint = found.entry.form.footprint(size[0], size[2]).map(|p| p.mapped(|q| at + turn.rotate(q)));
        self.scene.objects.push(Object {
            origin,
            entry: found.entry.id.clone(),
            category: found.entry.category.clone(),
            variant: found.variant.name.clone(),
            label: found.entry.label.clone(),
            footprint: footprint.into_iter().collect(),
            position: at,
            heading,
            base: feature.elevation,
            size,
            color: found.entry.color,
            model: found.variant.model.clone(),
        });
    }

    fn word(&mut self, word: &str) -> Arc<Material> {
        let key = (Some(word.into()), "".into(), None);
        let known = self.catalogue.cover(word).map(|cover| cover.material.clone());
        self.materials.entry(key).or_insert_with(|| known.unwrap_or_else(|| Arc::new(plain(word, None)))).clone()
    }
}

fn is_placeable(shape: &Shape) -> bool {
    let (at, size) = (shape.scope.frame.origin, shape.scope.size);
    [at, size].iter().all(|v| v.is_finite() && v.abs().max_element() <= FARTHEST)
}

fn is_upright(shape: &Shape) -> bool {
    match &shape.geometry {
        Geometry::Prism(plane, ..) => (shape.scope.frame.rotation * plane.normal()).y.abs() > 1.0 - 1e-9,
        _ => false,
    }
}

/// A material of a bare colour; without one, that of unprinted paper.
fn plain(word: &str, color: Option<[f32; 4]>) -> Material {
    let fill = color.unwrap_or([0.93, 0.91, 0.86, 1.0]);
    Material {
        name: word.into(),
        label: word.into(),
        fill,
        line: darker(fill),
        line_width: 0.1,
        texture: Texture::Plain,
    }
}

fn darker(fill: [f32; 4]) -> [f32; 4] {
    [fill[0] * 0.72, fill[1] * 0.72, fill[2] * 0.72, fill[3]]
}

fn plant(shape: &Shape, placed: &Placed, entry: &Entry, figures: PlantFigures, origin: Origin) -> Plant {
    let size = shape.scope.size;
    let foot = shape.scope.frame.to_world(DVec3::new(size.x * 0.5, 0.0, size.z * 0.5));
    let crown_radius = size.x.max(size.z) * 0.5;
    // A larger or smaller appearance keeps as much more or less clear.
    let scale = if figures.crown_radius > 0.0 { crown_radius / figures.crown_radius } else { 1.0 };
    let reserved = shape.ordinals.place.radius;
    let grown = placed.grown.unwrap_or(Grown {
        trunk_diameter: figures.trunk_diameter * scale,
        crown_height: 0.0,
        leaf_area: 0.0,
        pruning: 1.0,
        measured: false,
    });
    Plant {
        origin,
        position: on_plan(foot),
        elevation: foot.y,
        heading: heading(shape),
        kind: kind_word(entry),
        category: entry.category.clone(),
        age_class: placed.kind.clone(),
        appearance: placed.appearance,
        species: entry.species.clone(),
        common_name: entry.common_name.clone(),
        code: entry.code.clone(),
        spacing_radius: if reserved > 0.0 { reserved } else { figures.spacing_radius * scale },
        crown_radius,
        age: placed.age,
        height: size.y,
        trunk_diameter: grown.trunk_diameter,
        crown_height: grown.crown_height,
        leaf_area: grown.leaf_area,
        pruning: grown.pruning,
        measured: grown.measured,
        seed: shape.seed.0,
        managed: true,
        existing: false,
        symbol: entry.variant(&placed.kind).map_or(entry.symbol, |v| v.symbol),
        color: shape.style.color.unwrap_or(entry.color),
    }
}

fn object(shape: &Shape, placed: &Placed, entry: &Entry, origin: Origin, model: Arc<str>) -> Object {
    let (frame, size) = (&shape.scope.frame, shape.scope.size);
    let middle = frame.to_world(DVec3::new(size.x * 0.5, 0.0, size.z * 0.5));
    let heading = heading(shape);
    let turn = DVec2::from_angle(heading.to_radians());
    let at = on_plan(middle);
    let footprint = entry.form.footprint(size.x, size.z).map(|p| p.mapped(|q| at + turn.rotate(q)));
    Object {
        origin,
        entry: entry.id.clone(),
        category: entry.category.clone(),
        variant: placed.kind.clone(),
        label: entry.label.clone(),
        footprint: footprint.into_iter().collect(),
        position: at,
        heading,
        base: middle.y,
        size: size.to_array(),
        color: shape.style.color.unwrap_or(entry.color),
        model,
    }
}

/// The angle of a scope's x axis on the plan, degrees counter-clockwise from east.
fn heading(shape: &Shape) -> f64 {
    let along = on_plan(shape.scope.frame.rotation * DVec3::X);
    // Plus zero, since nobody wants to read −0.
    libm::atan2(along.y, along.x).to_degrees() + 0.0
}

/// A tree of the layout: what its attributes say, the rest from the catalogue's figures for its species and height.
fn standing(catalogue: &Catalogue, feature: &Feature, at: DVec2, origin: Origin) -> Plant {
    let number =
        |name: &str| feature.attributes.get(name).and_then(Value::as_float).filter(|n| *n > 0.0 && *n <= FARTHEST);
    let species = ["species", "genus", "taxon"].iter().find_map(|n| feature.attributes.get(*n)?.as_str());
    let found = species.and_then(|name| catalogue.find(name, "").ok());
    let entry = found.map(|f| f.entry);
    let height = number("height").or((feature.height > 0.0).then_some(feature.height));
    let variant = entry.map(|e| height.map_or(e.usual(), |h| e.nearest_height(h)));
    let figures = variant.and_then(|v| v.plant).unwrap_or_default();
    let crown = number("crown_radius").or(number("crown_diameter").map(|d| d * 0.5));
    let crown_radius = crown.unwrap_or(if figures.crown_radius > 0.0 { figures.crown_radius } else { 2.0 });
    Plant {
        position: at,
        elevation: feature.elevation,
        heading: number("heading").unwrap_or(0.0),
        kind: entry.map_or_else(|| "tree".into(), kind_word),
        category: entry.map_or_else(|| "".into(), |e| e.category.clone()),
        age_class: variant.map_or_else(|| "".into(), |v| v.name.clone()),
        appearance: 0,
        species: entry.map_or_else(|| species.unwrap_or_default().into(), |e| e.species.clone()),
        common_name: entry.map_or_else(|| "".into(), |e| e.common_name.clone()),
        code: entry.map_or_else(|| "".into(), |e| e.code.clone()),
        spacing_radius: number("spacing_radius").unwrap_or(crown_radius),
        crown_radius,
        age: number("age").unwrap_or(figures.age),
        height: height.unwrap_or(figures.height),
        trunk_diameter: number("trunk_diameter").unwrap_or(figures.trunk_diameter),
        crown_height: number("crown_height").unwrap_or(0.0),
        leaf_area: number("leaf_area").unwrap_or(0.0),
        pruning: number("pruning").map_or(1.0, |share| share.min(1.0)),
        measured: false,
        seed: crate::seed::Seed(0).named(&origin.id).0,
        managed: true,
        existing: true,
        symbol: variant.map_or(Default::default(), |v| v.symbol),
        color: entry.map_or([0.55, 0.66, 0.45, 0.7], |e| e.color),
        origin,
    }
}

fn kind_word(entry: &Entry) -> Arc<str> {
    use crate::element::Words;
    entry.kind.word().into()
}
