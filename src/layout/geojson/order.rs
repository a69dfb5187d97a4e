//! Lists with a value for each edge, brought into the order of the edges.
//!
//! A ring that runs clockwise is turned round, and repeated points are dropped: then the edges of the polygon are no
//! longer those of the file, and what is said of them has to follow.

use crate::geometry::Polygon;
use crate::value::{Array, Cells, Value};
use glam::DVec2;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// The edges of a polygon as the file has them.
pub struct Order {
    /// Edges of the outline in the file.
    count: usize,
    /// For each edge of the polygon's outline the file's; `None` where one is new.
    edges: Option<Vec<usize>>,
}

impl Order {
    /// Where the edges of a polygon's outline come from, by the ring that the file has, without its closing point.
    pub fn of(ring: &[DVec2], polygon: &Polygon) -> Order {
        if polygon.outer() == ring {
            return Order { count: ring.len(), edges: Some((0..ring.len()).collect()) };
        }
        let bits = |p: DVec2| [p.x.to_bits(), p.y.to_bits()];
        let ends = ring.iter().zip(ring.iter().cycle().skip(1)).filter(|(a, b)| a != b);
        let numbers = (0..ring.len()).filter(|index| ring[*index] != ring[(index + 1) % ring.len()]);
        let pairs = ends.flat_map(|(a, b)| [[bits(*a), bits(*b)], [bits(*b), bits(*a)]]);
        let known: HashMap<[[u64; 2]; 2], usize> = pairs.zip(numbers.flat_map(|number| [number, number])).collect();
        let outline = polygon.edges().take(polygon.outer().len());
        let edges = outline.map(|(a, b)| known.get(&[bits(a), bits(b)]).copied()).collect();
        Order { count: ring.len(), edges }
    }

    /// Brings the lists that are as long as the ring into the order of the edges; whether that could be done.
    pub fn settle(&self, attributes: &mut BTreeMap<Arc<str>, Value>) -> bool {
        let is_each = |value: &&mut Value| value.as_array().is_some_and(|a| a.rows() == 1 && a.len() == self.count);
        let mut lists = attributes.values_mut().filter(is_each).peekable();
        match &self.edges {
            None => lists.peek().is_none(),
            Some(edges) if edges.len() == self.count && edges.is_sorted() => true,
            Some(edges) => {
                lists.for_each(|value| *value = moved(value, edges));
                true
            }
        }
    }
}

/// A list in another order.
fn moved(value: &Value, edges: &[usize]) -> Value {
    let Some(array) = value.as_array() else { return value.clone() };
    let cells = match array.cells() {
        Cells::Numbers(numbers) => Cells::Numbers(edges.iter().map(|edge| numbers[*edge]).collect()),
        Cells::Truths(truths) => Cells::Truths(edges.iter().map(|edge| truths[*edge]).collect()),
        Cells::Texts(texts) => Cells::Texts(edges.iter().map(|edge| texts[*edge].clone()).collect()),
    };
    Value::Array(Arc::new(Array::row(cells)))
}
