//! `splitAndSetbackPerimeter`: bands of given length and depth around a shape.

use crate::geometry::{self, Area, Polygon};
use crate::ops::declare::operation;
use crate::ops::gather::Gathered;
use crate::ops::spec::Truths;
use crate::ops::split::{self, Interval};
use crate::ops::{Apply, Component, Cut, Given, Part, Pieces, Problem, Selectors, fit, rim};
use crate::shape::Shape;
use crate::value::Size;
use glam::DVec2;

operation! {
    /// Lays bands of given length and depth along the outline of a flat shape, and leaves the rest.
    ///
    /// First the outline is split into sections: lengths are absolute, relative to the whole length (`'0.25`) or
    /// floating, a `*` repeats them, all as in `split`. Then every section is set back by its depth, which is
    /// evaluated for each with its own `split.index`; one of 0 leaves a gap. Where bands overlap the deeper one has it;
    /// bands of equal depth meet in the mitre. The x of a band runs along its longest edge.
    ///
    /// With a first edge and a mask the split runs along the chosen edges only, as if they were one line.
    /// ```cga
    /// Lot --> splitAndSetbackPerimeter(3) { ~12 : 3 : Bed | 6 : 1.5 : Hedge }* { remainder : Lawn }
    /// ```
    "splitAndSetbackPerimeter" (CityEngine, Perimeter) => pub struct SplitAndSetbackPerimeter {
        /// How far from the start of the first edge the first section begins: metres, or with `'` a share of the whole
        /// length.
        offset: Size,
        /// The number of the first edge, from 0; beyond the last it starts again, below 0 it counts from the end.
        first_edge: f64 = 0.0 => "0",
        /// Which edges belong to it: an array with `true` or `false` for each; those beyond its end do not.
        mask: Option<Truths> = None => "all",
    }
}

/// Cuts nearer than this (metres) to a corner are at the corner.
const AT_CORNER: f64 = 1e-6;

impl Apply for SplitAndSetbackPerimeter {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(vec![Component { shape: shape.clone(), selectors: Selectors::none(), words: &["remainder"] }])
    }

    fn sections(&self, shape: &Shape, cuts: &[Cut], most: usize) -> Result<Vec<u16>, Problem> {
        let lines = self.lines(shape)?;
        let mut entries = Vec::new();
        for line in &lines {
            entries.extend(split::intervals(cuts, line.length, most)?.iter().map(|section| section.entry));
        }
        Ok(entries)
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area) = rim::flat("splitAndSetbackPerimeter", shape)?;
        let (mut first, mut parts) = (0, Vec::new());
        let mut rest = Gathered::new(shape, plane);
        for (polygon, line) in area.polygons().iter().zip(self.lines(shape)?) {
            let sections = split::intervals(given.cuts, line.length, given.most)?;
            let depths = &given.depths[first..first + sections.len()];
            let start = match self.offset {
                Size::Absolute(metres) => metres,
                Size::Relative(share) | Size::Floating(share) => share * line.length,
            };
            let banded = line.banded(polygon, &sections, depths, start)?;
            for (index, (section, band)) in (first as u32..).zip(sections.iter().zip(&banded.bands)) {
                let child = fit::aligned(shape, plane, &band.area, band.along);
                parts.extend(child.map(|shape| (index, Part::new(section.entry, shape))));
            }
            if let Some(choice) = given.chosen[0] {
                rest.rest(choice, banded.remainder);
            }
            first += sections.len();
        }
        let total = first as u32;
        parts.iter_mut().for_each(|(index, part)| part.shape.ordinals.split = (*index, total));
        Ok(Pieces::Parts(parts.into_iter().map(|(_, part)| part).chain(rest.parts()).collect()))
    }
}

impl SplitAndSetbackPerimeter {
    /// The line to split around each polygon.
    fn lines(&self, shape: &Shape) -> Result<Vec<Line>, Problem> {
        let (_, area) = rim::flat("splitAndSetbackPerimeter", shape)?;
        let numbers = [self.first_edge, if let Size::Absolute(n) | Size::Relative(n) = self.offset { n } else { 0.0 }];
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(Problem::new(format!("a perimeter cannot be split from {number} on")));
        }
        let mut first = 0;
        let line = |polygon: &Polygon| {
            let count = polygon.outer().len();
            let begin = self.first_edge.floor().rem_euclid(count as f64) as usize;
            let chosen = |edge: &usize| self.mask.as_ref().is_none_or(|mask| mask.at(first + edge));
            let edges: Vec<usize> = (0..count).map(|i| (begin + i) % count).filter(chosen).collect();
            first += polygon.points().len();
            Line::new(polygon, edges)
        };
        Ok(area.polygons().iter().map(line).collect())
    }
}

/// The chosen edges of an outline, one after the other.
struct Line {
    /// By their index in the polygon.
    edges: Vec<usize>,
    /// Where each begins on the line.
    starts: Vec<f64>,
    length: f64,
}

/// A polygon taken apart.
struct Banded {
    /// One for each section.
    bands: Vec<Band>,
    remainder: Area,
}

#[derive(Clone)]
struct Band {
    area: Area,
    /// Its longest edge.
    along: DVec2,
}

impl Line {
    fn new(polygon: &Polygon, edges: Vec<usize>) -> Line {
        let mut length = 0.0;
        let start = |edge: &usize| {
            let (a, b) = polygon.edge(*edge);
            length += a.distance(b);
            length - a.distance(b)
        };
        let starts = edges.iter().map(start).collect();
        Line { edges, starts, length }
    }

    /// The bands of the sections, which begin `start` metres along the line.
    fn banded(&self, polygon: &Polygon, sections: &[Interval], depths: &[f64], start: f64) -> Result<Banded, Problem> {
        if let Some(depth) = depths.iter().find(|depth| !(depth.is_finite() && **depth >= 0.0)) {
            return Err(Problem::new(format!("a band {depth} m deep cannot be laid")).hint("0 leaves a gap"));
        }
        let (cut, owners) = self.cut(polygon, sections, start);
        let mut levels: Vec<f64> = depths.iter().copied().filter(|depth| *depth > 0.0).collect();
        levels.sort_by(|a, b| b.total_cmp(a));
        levels.dedup();
        let mut strips: Vec<Vec<Area>> = vec![Vec::new(); sections.len()];
        let mut taken = Area::empty();
        for level in levels {
            let owner = |edge: usize| owners[edge].filter(|section| depths[*section] == level);
            let moved = geometry::setback(&cut, |edge| if owner(edge).is_some() { level } else { 0.0 });
            let swept = geometry::union_all(moved.strips.iter().map(|strip| &strip.area));
            for strip in moved.strips {
                let free = geometry::difference(&strip.area, &taken);
                owner(strip.edge).into_iter().for_each(|section| strips[section].push(free.clone()));
            }
            taken = geometry::union(&taken, &swept);
        }
        let along = longest(&cut, &owners, sections.len());
        let band = |(strips, along): (&Vec<Area>, DVec2)| Band { area: geometry::union_all(strips), along };
        let remainder = geometry::difference(&polygon.clone().into(), &taken);
        Ok(Banded { bands: strips.iter().zip(along).map(band).collect(), remainder })
    }

    /// The polygon with a vertex wherever a section begins or ends, and the section of each of its edges.
    fn cut(&self, polygon: &Polygon, sections: &[Interval], start: f64) -> (Polygon, Vec<Option<usize>>) {
        let (mut ring, mut owners) = (Vec::new(), Vec::new());
        for (edge, corner) in polygon.outer().iter().enumerate() {
            let (from, to) = polygon.edge(edge);
            let length = from.distance(to);
            let place = self.edges.iter().position(|chosen| *chosen == edge).map(|index| self.starts[index]);
            let mut at = vec![0.0];
            at.extend(place.into_iter().flat_map(|place| self.ends(sections, start, place, length)));
            for (index, along) in at.iter().enumerate() {
                let middle = 0.5 * (along + at.get(index + 1).unwrap_or(&length));
                ring.push(if index == 0 { *corner } else { from.lerp(to, along / length) });
                owners.push(place.and_then(|place| self.section(sections, place + middle - start)));
            }
        }
        let holes: Vec<Vec<DVec2>> = polygon.holes().map(<[DVec2]>::to_vec).collect();
        owners.resize(ring.len() + holes.iter().map(Vec::len).sum::<usize>(), None);
        (Polygon::new(&ring, &holes).unwrap_or_else(|| polygon.clone()), owners)
    }

    /// Where sections begin or end on an edge, metres from its start, in order.
    fn ends(&self, sections: &[Interval], start: f64, place: f64, length: f64) -> Vec<f64> {
        let ends = sections.iter().flat_map(|section| [section.from, section.to]);
        let mut found: Vec<f64> = ends.map(|end| (end + start - place).rem_euclid(self.length)).collect();
        found.retain(|along| *along > AT_CORNER && *along < length - AT_CORNER);
        found.sort_by(f64::total_cmp);
        found.dedup_by(|b, a| *b - *a < AT_CORNER);
        found
    }

    /// The section at a place of the pattern.
    fn section(&self, sections: &[Interval], at: f64) -> Option<usize> {
        let at = at.rem_euclid(self.length);
        let index = sections.partition_point(|section| section.to <= at);
        (index < sections.len() && sections[index].from <= at).then_some(index)
    }
}

/// For each section the longest of its edges.
fn longest(cut: &Polygon, owners: &[Option<usize>], sections: usize) -> Vec<DVec2> {
    let mut longest = vec![DVec2::ZERO; sections];
    for ((a, b), owner) in cut.edges().zip(owners) {
        let Some(best) = owner.map(|section| &mut longest[section]) else { continue };
        // A hair of slack, so that rounding does not choose among equals.
        if (b - a).length() > best.length() * (1.0 + 1e-9) {
            *best = b - a;
        }
    }
    longest
}
