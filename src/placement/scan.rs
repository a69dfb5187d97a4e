//! The cells of a lattice that an area touches, found row by row along its edges.

use crate::geometry::Area;
use crate::placement::PlacementError;
use crate::placement::places::few_enough;
use glam::DVec2;

/// Rows and columns of a lattice in the plan.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// The place of row 0 and column 0.
    pub origin: DVec2,
    /// Unit direction of the rows.
    pub axis: DVec2,
    /// From place to place in a row, and from row to row, metres.
    pub step: DVec2,
    /// How many columns and rows there are; shifted rows have one more, number -1.
    pub count: [usize; 2],
    /// By how much of a step the odd rows are shifted on.
    pub stagger: f64,
}

impl Grid {
    /// A place of the lattice in the plan.
    pub fn place(&self, row: i64, column: i64) -> DVec2 {
        self.origin + self.axis.rotate(DVec2::new(column as f64 + self.shift(row), row as f64) * self.step)
    }

    /// The cells, each a row and a column, that come within `reach` (half their size in steps, and a little more) of
    /// the area, row by row. Costs what it finds and the edges, each for the rows it crosses.
    pub fn cells(&self, area: &Area, reach: DVec2) -> Result<Vec<[i64; 2]>, PlacementError> {
        let mut spans = Vec::new();
        for (a, b) in area.edges() {
            self.span(self.own(a), self.own(b), reach, &mut spans);
            few_enough(spans.len() as f64)?;
        }
        spans.sort_unstable_by(|a, b| (a.row, a.parity).cmp(&(b.row, b.parity)).then(a.from.total_cmp(&b.from)));
        self.fill(&close(spans), reach.x)
    }

    /// A place of the plan in steps, stagger left aside.
    fn own(&self, p: DVec2) -> DVec2 {
        let q = p - self.origin;
        DVec2::new(self.axis.dot(q), self.axis.perp_dot(q)) / self.step
    }

    fn shift(&self, row: i64) -> f64 {
        if row.rem_euclid(2) == 1 { self.stagger } else { 0.0 }
    }

    /// Adds what an edge covers of each row, and where it crosses the row's middle.
    fn span(&self, a: DVec2, b: DVec2, reach: DVec2, spans: &mut Vec<Span>) {
        let last = self.count[1] as f64 - 1.0;
        let (low, high) = (a.y.min(b.y), a.y.max(b.y));
        let first = (low - reach.y).ceil().max(0.0);
        let end = (high + reach.y).floor().min(last);
        if first > end {
            return;
        }
        let at = |y: f64| if high > low { a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0) } else { a.x };
        for row in first as i64..=end as i64 {
            let y = row as f64;
            let ends = if high > low { [at(y - reach.y), at(y + reach.y)] } else { [a.x, b.x] };
            spans.push(Span { row, parity: false, from: ends[0].min(ends[1]), to: ends[0].max(ends[1]) });
            if (a.y > y) != (b.y > y) {
                spans.push(Span { row, parity: true, from: at(y), to: at(y) });
            }
        }
    }

    /// The columns of sorted spans, each once.
    fn fill(&self, spans: &[Span], reach: f64) -> Result<Vec<[i64; 2]>, PlacementError> {
        let mut cells = Vec::new();
        let mut next = [-1, 0];
        for span in spans {
            let shift = self.shift(span.row);
            if span.row != next[0] {
                // A shifted row has room for one more at its start.
                next = [span.row, if shift > 0.0 { -1 } else { 0 }];
            }
            let from = (span.from - shift - reach).ceil() as i64;
            let to = (span.to - shift + reach).floor().min(self.count[0] as f64 - 1.0) as i64;
            few_enough(cells.len() as f64 + (to - from.max(next[1])) as f64)?;
            cells.extend((from.max(next[1])..=to).map(|column| [span.row, column]));
            next[1] = next[1].max(to + 1);
        }
        Ok(cells)
    }
}

/// A stretch of a row, in steps.
#[derive(Clone, Copy)]
struct Span {
    row: i64,
    /// Whether it is a crossing of the row's middle.
    parity: bool,
    from: f64,
    to: f64,
}

/// Crossings joined by pairs, all sorted by row and start.
fn close(spans: Vec<Span>) -> Vec<Span> {
    let (mut whole, crossings): (Vec<Span>, Vec<Span>) = spans.into_iter().partition(|span| !span.parity);
    // Rings are closed, so that a row crosses them an even number of times.
    whole.extend(crossings.chunks_exact(2).map(|pair| Span { to: pair[1].from, ..pair[0] }));
    whole.sort_unstable_by(|a, b| a.row.cmp(&b.row).then(a.from.total_cmp(&b.from)).then(a.to.total_cmp(&b.to)));
    whole
}
