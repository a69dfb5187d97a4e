//! A formal garden of 330 by 230 metres with everything a plan can show: palace, terrace, embroidery parterres with a
//! basin, an avenue, a bosquet behind hedges with a room in it, a meadow of mixed trees, furniture.

use bosquet::element::{Catalogue, Entry, Words};
use bosquet::geometry::{Area, Mesh, Polygon, difference, inset};
use bosquet::scene::{Cover, Line, LotOutline, Material, Object, Origin, Plant, Scene, Solid};
use bosquet::seed::Seed;
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// The garden.
pub fn formal_garden() -> Scene {
    let mut garden = Garden { scene: Scene { title: "Jardin de Bellevue".into(), ..Scene::default() }, seed: Seed(7) };
    garden.ground();
    garden.parterres();
    garden.palace();
    garden.avenue();
    garden.bosquet();
    garden.meadow();
    garden.furniture();
    garden.scene
}

struct Garden {
    scene: Scene,
    seed: Seed,
}

pub fn rectangle(x: f64, y: f64, width: f64, depth: f64) -> Area {
    Polygon::rectangle(DVec2::new(x, y), DVec2::new(x + width, y + depth)).map(Area::from).unwrap_or_default()
}

pub fn disc(x: f64, y: f64, radius: f64) -> Area {
    Polygon::regular(DVec2::new(x, y), radius, 72).map(Area::from).unwrap_or_default()
}

pub fn material(word: &str) -> Arc<Material> {
    Catalogue::built_in().cover(word).unwrap_or_else(|| panic!("no cover `{word}`")).material.clone()
}

pub fn element(id: &str) -> &'static Entry {
    Catalogue::built_in().by_id(id).unwrap_or_else(|| panic!("no element `{id}`"))
}

/// A plant of the catalogue's type.
pub fn plant(id: &str, kind: &str, position: DVec2, seed: u64) -> Plant {
    let entry = element(id);
    let variant = entry.variant(kind).unwrap_or_else(|| entry.usual());
    let figures = variant.plant.expect("a plant");
    let vigour = Seed(seed).draw("vigour").uniform(0.88, 1.12);
    Plant {
        origin: Origin { lot: "garden".into(), rule: "Tree".into(), id: format!("{seed:016x}").into() },
        position,
        elevation: 0.0,
        heading: 0.0,
        kind: Words::word(entry.kind).into(),
        category: entry.category.clone(),
        age_class: variant.name.clone(),
        appearance: 0,
        species: entry.species.clone(),
        common_name: entry.common_name.clone(),
        code: entry.code.clone(),
        spacing_radius: figures.spacing_radius,
        crown_radius: figures.crown_radius * vigour,
        age: figures.age,
        height: figures.height * vigour,
        trunk_diameter: figures.trunk_diameter * vigour,
        crown_height: 0.0,
        leaf_area: 0.0,
        pruning: 1.0,
        measured: false,
        seed,
        managed: true,
        existing: false,
        symbol: variant.symbol,
        color: entry.color,
    }
}

/// A cover of one of the catalogue's materials.
pub fn cover(word: &str, area: Area) -> Cover {
    let origin = Origin { lot: "garden".into(), rule: "Cover".into(), id: format!("cover {word}").into() };
    Cover { origin, material: material(word), area, elevation: 0.0, surface: None }
}

/// A square pavilion under a pyramid.
fn pavilion(middle: DVec2, half: f64) -> Mesh {
    let corner = |x: f64, y: f64, height: f64| DVec3::new(middle.x + x * half, height, -(middle.y + y * half));
    let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let mut mesh = Mesh::default();
    for height in [0.0, 6.0] {
        mesh.positions.extend(square.map(|(x, y)| corner(x, y, height)));
    }
    mesh.positions.push(corner(0.0, 0.0, 12.0));
    for i in 0..4 {
        let next = (i + 1) % 4;
        mesh.push_face([[i, next, next + 4, i + 4].as_slice()]);
        mesh.push_face([[i + 4, next + 4, 8].as_slice()]);
    }
    mesh.push_face([[3, 2, 1, 0].as_slice()]);
    mesh
}

impl Garden {
    fn origin(&self, id: String) -> Origin {
        Origin { lot: "garden".into(), rule: "Cover".into(), id: id.into() }
    }

    fn cover(&mut self, word: &str, area: Area) {
        let origin = self.origin(format!("cover {}", self.scene.covers.len()));
        self.scene.covers.push(Cover { origin, ..cover(word, area) });
    }

    fn solid(&mut self, word: &str, footprint: Area, height: f64) {
        let origin = self.origin(format!("solid {}", self.scene.solids.len()));
        let solid = Solid { origin, material: material(word), footprint, base: 0.0, height, mesh: None, surface: None };
        self.scene.solids.push(solid);
    }

    fn plant(&mut self, id: &str, kind: &str, x: f64, y: f64) {
        let seed = self.seed.child(self.scene.plants.len() as u64).0;
        self.scene.plants.push(plant(id, kind, DVec2::new(x, y), seed));
    }

    fn object(&mut self, id: &str, kind: &str, x: f64, y: f64, heading: f64) {
        let entry = element(id);
        let variant = entry.variant(kind).unwrap_or_else(|| entry.usual());
        self.scene.objects.push(Object {
            origin: self.origin(format!("object {}", self.scene.objects.len())),
            entry: entry.id.clone(),
            category: entry.category.clone(),
            variant: variant.name.clone(),
            label: entry.label.clone(),
            footprint: Area::default(),
            position: DVec2::new(x, y),
            heading,
            base: 0.0,
            size: variant.size,
            color: entry.color,
            model: "".into(),
        });
    }

    fn lot(&mut self, name: &str, area: Area) {
        let id = format!("lot {}", self.scene.lots.len());
        let zone = "park".into();
        self.scene.lots.push(LotOutline { id: id.into(), name: name.into(), kind: "region".into(), zone, area });
    }

    fn ground(&mut self) {
        self.cover("gravel", rectangle(-165.0, -115.0, 330.0, 230.0));
        self.cover("lawn", rectangle(-160.0, 32.0, 196.0, 78.0));
        self.cover("meadow", rectangle(-160.0, -110.0, 196.0, 78.0));
        self.cover("lawn", rectangle(-158.0, -9.0, 150.0, 18.0));
        self.lot("", rectangle(-165.0, -115.0, 330.0, 230.0));
        self.lot("Tapis Vert", rectangle(-158.0, -9.0, 150.0, 18.0));
        self.scene.lines.push(Line {
            origin: Origin::default(),
            material: material("axis"),
            points: vec![DVec2::new(-165.0, 0.0), DVec2::new(118.0, 0.0)],
            elevation: 0.0,
        });
    }

    fn parterres(&mut self) {
        for side in [-1.0, 1.0] {
            let y = if side > 0.0 { 8.0 } else { -40.0 };
            self.cover("embroidery", rectangle(52.0, y, 60.0, 32.0));
            self.cover("bed", rectangle(52.0, side * 46.0 - 2.0, 60.0, 4.0));
            for i in 0..9 {
                self.plant("taxus-baccata", "cone", 54.0 + 7.0 * f64::from(i), side * 46.0);
                self.plant("citrus-aurantium", "caisse", 54.0 + 7.0 * f64::from(i), side * 53.0);
            }
            let lawn = difference(&rectangle(52.0, side * 82.0 - 25.0, 60.0, 50.0), &disc(82.0, side * 82.0, 16.0));
            self.cover("lawn", lawn);
            self.cover("water", disc(82.0, side * 82.0, 10.0));
            self.object("fountain", "jet", 82.0, side * 82.0, 0.0);
            for i in 0..40 {
                let at = if i < 20 { side * 59.5 } else { side * 104.5 };
                self.plant("rosa-gallica", "adult", 54.0 + 2.9 * f64::from(i % 20), at);
            }
        }
        self.lot("Parterre du Nord", rectangle(52.0, 8.0, 60.0, 32.0));
        self.lot("Parterre du Midi", rectangle(52.0, -40.0, 60.0, 32.0));
        self.cover("stone", disc(22.0, 0.0, 22.0));
        self.cover("water", disc(22.0, 0.0, 21.0));
        self.lot("Bassin d'Apollon", disc(22.0, 0.0, 21.0));
        self.object("fountain", "jet", 22.0, 0.0, 0.0);
    }

    fn palace(&mut self) {
        self.cover("terrace", rectangle(116.0, -75.0, 44.0, 150.0));
        self.cover("court", rectangle(140.0, -30.0, 20.0, 60.0));
        let wing = |y: f64| rectangle(126.0, y, 14.0, 42.0);
        self.solid("roof", rectangle(122.0, -28.0, 18.0, 56.0), 18.0);
        self.solid("roof", wing(28.0), 14.0);
        self.solid("roof", wing(-70.0), 14.0);
        self.solid("roof", rectangle(140.0, 54.0, 18.0, 12.0), 10.0);
        self.solid("roof", rectangle(140.0, -66.0, 18.0, 12.0), 10.0);
        for y in [-93.0, 93.0] {
            self.solid("roof", rectangle(130.0, y - 8.0, 16.0, 16.0), 9.0);
            self.scene.solids.last_mut().expect("just added").mesh =
                Some(Arc::new(pavilion(DVec2::new(138.0, y), 8.0)));
        }
        self.solid("wall", rectangle(159.0, -54.0, 0.6, 108.0), 2.5);
    }

    fn avenue(&mut self) {
        for i in 0..50 {
            for y in [-26.0, -18.0, 18.0, 26.0] {
                self.plant("tilia-europaea", "medium", -158.0 + 3.1 * f64::from(i), y);
            }
        }
    }

    /// A wood behind palissades, crossed by paths that meet in a room.
    fn bosquet(&mut self) {
        let (room, all) = (disc(-62.0, 71.0, 17.0), rectangle(-156.0, 36.0, 188.0, 70.0));
        let cross = [rectangle(-156.0, 68.5, 188.0, 5.0), rectangle(-64.5, 36.0, 5.0, 70.0), room.clone()];
        let wood = cross.iter().fold(all.clone(), |wood, cut| difference(&wood, cut));
        self.cover("gravel", all.clone());
        self.cover("forest-floor", wood.clone());
        let hedge = difference(&inset(&wood, 0.8), &inset(&wood, 2.2));
        hedge.polygons().iter().for_each(|part| self.solid("palissade", part.clone().into(), 4.0));
        self.cover("water", disc(-62.0, 71.0, 7.0));
        self.lot("Bosquet de l'Étoile", all);
        let (inside, mut random) = (inset(&wood, 3.6), self.seed.draw("bosquet"));
        let ids =
            ["carpinus-betulus", "carpinus-betulus", "aesculus-hippocastanum", "ulmus-hollandica", "quercus-robur"];
        for row in 0..17 {
            for column in 0..46 {
                let jitter = DVec2::new(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9));
                let at = DVec2::new(-153.0 + 4.1 * f64::from(column), 39.0 + 4.1 * f64::from(row)) + jitter;
                let id = ids[random.below(5) as usize];
                if inside.contains(at) {
                    self.plant(id, "young", at.x, at.y);
                }
            }
        }
    }

    fn meadow(&mut self) {
        let mut random = self.seed.draw("meadow");
        let kinds = [
            ("betula-pendula", "adult"),
            ("pinus-sylvestris", "adult"),
            ("quercus-robur", "adult"),
            ("malus-domestica", "medium"),
            ("cedrus-libani", "adult"),
            ("fagus-sylvatica", "medium"),
            ("corylus-avellana", "adult"),
            ("trachycarpus-fortunei", "adult"),
            ("abies-alba", "medium"),
        ];
        let mut placed: Vec<(DVec2, f64)> = Vec::new();
        let mut tries = 0;
        while placed.len() < 110 && tries < 5_000 {
            tries += 1;
            let (id, kind) = kinds[random.below(9) as usize];
            let at = DVec2::new(random.uniform(-153.0, 29.0), random.uniform(-104.0, -37.0));
            let radius = plant(id, kind, at, 0).crown_radius;
            if placed.iter().all(|(p, r)| p.distance(at) > (r + radius) * 0.8) {
                placed.push((at, radius));
                self.plant(id, kind, at.x, at.y);
            }
        }
        self.lot("La Prairie", rectangle(-160.0, -110.0, 196.0, 78.0));
    }

    fn furniture(&mut self) {
        for side in [-1.0, 1.0] {
            for i in 0..5 {
                self.object("bench", "stone", -140.0 + 28.0 * f64::from(i), side * 13.0, 0.0);
                self.object("statue", "figure", -126.0 + 28.0 * f64::from(i), side * 12.0, 0.0);
            }
            self.object("vase", "large", 50.0, side * 5.0, 0.0);
            self.object("vase", "large", 114.0, side * 5.0, 0.0);
        }
    }
}
