//! `setbackToArea`: a setback whose distance follows from the area that shall be left.

use crate::geometry::{self, Area, Polygon};
use crate::ops::declare::operation;
use crate::ops::spec::PerEdge;
use crate::ops::{Apply, Component, Given, Pieces, Problem, Remark, rim};
use crate::shape::Shape;
use crate::value::Size;

operation! {
    /// Moves the selected edges of a flat shape inwards until the remainder has an area.
    ///
    /// All edges move by the same distance, or by their least distances and a common one on top, none beyond its
    /// greatest. The area is met to a millionth of a square metre where polygons are convex, else to the grid of a
    /// micrometre on which they are cut. Where it cannot be met, the remainder comes as near as it can, and a warning
    /// says so. All else is as in `setback`.
    /// ```cga
    /// Lot --> setbackToArea(600) { all = Gravel | remainder : Lawn }
    /// ```
    "setbackToArea" (CityEngine, Selectors(&["remainder"])) => pub struct SetbackToArea {
        /// The area of the remainder in m², or with `'` a share of the shape's.
        area: Size,
        /// An array with the least distance of each edge (metres). A number here or in the next place is the set of
        /// texture coordinates that `uv.…` words look at, as CityEngine has it.
        min: PerEdge = PerEdge::Same(0.0) => "0",
        /// An array with the greatest distance of each edge (metres).
        max: PerEdge = PerEdge::Same(0.0) => "any",
        /// The set of texture coordinates that `uv.…` words look at.
        uv_set: u32 = 0 => "0",
    }
}

/// So near to the wanted area (m²) the search ends.
const NEAR: f64 = 1e-8;

/// The search ends after so many halvings: far below a micrometre.
const MOST_STEPS: usize = 80;

impl Apply for SetbackToArea {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let (plane, area) = rim::flat("setbackToArea", shape)?;
        Ok(rim::components(shape, plane, area, self.uv_set()?))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (_, area) = rim::flat("setbackToArea", shape)?;
        let wanted = match self.area {
            Size::Relative(share) | Size::Floating(share) => share * area.area(),
            Size::Absolute(metres) => metres,
        };
        if !(wanted >= 0.0 && wanted.is_finite()) {
            return Err(Problem::new(format!("a remainder of {wanted} m² cannot be left")));
        }
        let limits = self.limits(area.edges().count())?;
        let left =
            |more: f64| left(area, |edge| if given.chosen[edge].is_some() { limits.at(edge, more) } else { 0.0 });
        let size = area.bounds().size();
        let more = search(left, wanted, size.x + size.y);
        let parts = rim::set_back(shape, given, |edge| limits.at(edge, more))?;
        let missed = left(more) - wanted;
        Ok(if missed.abs() > 1e-3 { Pieces::Noted(parts, vec![remark(wanted, missed)]) } else { Pieces::Parts(parts) })
    }
}

/// Between which distances each edge may move.
struct Limits {
    least: Vec<f64>,
    most: Vec<f64>,
}

impl Limits {
    fn at(&self, edge: usize, more: f64) -> f64 {
        (self.least[edge] + more).min(self.most[edge])
    }
}

impl SetbackToArea {
    /// The set of texture coordinates: a number among the distances is it.
    fn uv_set(&self) -> Result<u32, Problem> {
        let number = [&self.min, &self.max].into_iter().find_map(|distances| match distances {
            PerEdge::Same(number) if *number != 0.0 => Some(*number),
            _ => None,
        });
        match number {
            Some(number) if number.fract() != 0.0 || !(0.0..=9.0).contains(&number) => {
                let message = format!("there is no set {number} of texture coordinates");
                Err(Problem::new(message).hint("they are 0 to 9; least and greatest distances are arrays"))
            }
            Some(number) => Ok(number as u32),
            None => rim::known_uv_set(self.uv_set).map(|()| self.uv_set),
        }
    }

    fn limits(&self, edges: usize) -> Result<Limits, Problem> {
        let each = |distances: &PerEdge, otherwise: f64| -> Vec<f64> {
            let one = |edge| if distances.is_array() { distances.at(edge) } else { otherwise };
            (0..edges).map(one).collect()
        };
        let limits = Limits { least: each(&self.min, 0.0), most: each(&self.max, f64::INFINITY) };
        match limits.least.iter().zip(&limits.most).find(|(least, most)| !(**least >= 0.0 && least <= most)) {
            Some((least, most)) => {
                let message = format!("an edge cannot move between {least} m and {most} m");
                Err(Problem::new(message).hint("`min` is from 0 up, and `max` no less"))
            }
            None => Ok(limits),
        }
    }
}

/// The area that setbacks by edge leave.
fn left(area: &Area, distance: impl Fn(usize) -> f64) -> f64 {
    let mut first = 0;
    let of_polygon = |polygon: &Polygon| {
        let left = geometry::set_in(polygon, |edge| distance(first + edge)).area();
        first += polygon.points().len();
        left
    };
    area.polygons().iter().map(of_polygon).sum()
}

/// The distance up to `farthest` where a falling area has a value, or comes nearest to it.
fn search(area: impl Fn(f64) -> f64, wanted: f64, farthest: f64) -> f64 {
    let (mut low, mut high) = (0.0, farthest);
    if area(low) <= wanted {
        return low;
    }
    for _ in 0..MOST_STEPS {
        let middle = 0.5 * (low + high);
        let over = area(middle) - wanted;
        if over.abs() <= NEAR {
            return middle;
        }
        if over > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

fn remark(wanted: f64, missed: f64) -> Remark {
    let [found, wanted] = [wanted + missed, wanted].map(|area| crate::text::number(area, 3));
    let message = format!("{found} m² are left instead of {wanted} m²: no distance of the chosen edges leaves that");
    Remark { message, parameter: Some("area"), is_note: false }
}
