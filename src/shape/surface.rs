//! What the surface of a shape carries beside its colour: charts, projections, the rest of its material, tags.
//!
//! Everything lies in the world, behind one shared pointer in the style, and moves with the geometry. Most shapes have
//! none of it.

use crate::shape::chart::{self, Chart};
use crate::shape::{Frame, Shape, Tag};
use crate::value::Value;
use glam::{DAffine3, DMat3, DQuat};
use std::sync::Arc;

/// Charts, projections, material values, tags and pivot of a shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Texture coordinates by set, ascending.
    pub charts: Vec<(u32, Chart)>,
    /// What `setupProjection` prepared, by set.
    pub projections: Vec<(u32, Chart)>,
    /// `set(material.…)` but for name and colour: names without `material.`, ascending.
    pub material: Vec<(Arc<str>, Value)>,
    /// `tag()` and what operations tag by themselves.
    pub tags: Vec<Tag>,
    /// `setPivot`: where the pivot lies and how it is turned; the scope's own origin and axes where it is not set.
    pub pivot: Option<Frame>,
    /// `trim.horizontal` and `trim.vertical`, where they were set.
    pub trim: [Option<bool>; 2],
}

impl Surface {
    /// The chart of a set.
    pub fn chart(&self, set: u32) -> Option<&Chart> {
        self.charts.iter().find(|(number, _)| *number == set).map(|(_, chart)| chart)
    }

    /// Gives a set another chart.
    pub fn put_chart(&mut self, set: u32, chart: Chart) {
        put(&mut self.charts, set, chart);
    }

    /// Prepares the projection of a set.
    pub fn put_projection(&mut self, set: u32, chart: Chart) {
        put(&mut self.projections, set, chart);
    }

    /// The value of a material attribute, named without `material.`.
    pub fn material(&self, name: &str) -> Option<&Value> {
        self.material.iter().find(|(own, _)| **own == *name).map(|(_, value)| value)
    }

    /// Sets a material attribute.
    pub fn put_material(&mut self, name: Arc<str>, value: Value) {
        put(&mut self.material, name, value);
    }

    /// Moves all that lies in the world; what a motion flattens is lost.
    pub fn carried(&mut self, motion: &DAffine3) {
        let back = motion.inverse();
        if !back.is_finite() {
            *self = Surface { material: std::mem::take(&mut self.material), ..Surface::default() };
            return;
        }
        let charts = self.charts.iter_mut().chain(&mut self.projections);
        charts.for_each(|(_, chart)| chart.plane *= back);
        self.tags.iter_mut().for_each(|tag| tag.carried(motion));
        if let Some(pivot) = &mut self.pivot {
            pivot.origin = motion.transform_point3(pivot.origin);
            let is_turn = (motion.matrix3 * motion.matrix3.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-9);
            let turn = if is_turn { DQuat::from_mat3(&motion.matrix3) } else { DQuat::IDENTITY };
            pivot.rotation = (turn * pivot.rotation).normalize();
        }
    }
}

impl Shape {
    /// What its surface carries, if anything.
    pub fn attached(&self) -> Option<&Surface> {
        self.style.surface.as_deref()
    }

    /// What its surface carries, to be changed: the style is copied where others share it.
    pub fn surface_mut(&mut self) -> &mut Surface {
        let style = Arc::make_mut(&mut self.style);
        Arc::make_mut(style.surface.get_or_insert_default())
    }

    /// After its scope was moved or turned from another frame, with its geometry: what lies in the world follows.
    pub fn followed(&mut self, before: Frame) {
        if self.style.surface.is_some() {
            let motion = affine(&self.scope.frame) * affine(&before).inverse();
            self.carried(&motion);
        }
    }

    /// After its geometry was changed by a map of local coordinates: what lies in the world follows.
    pub fn stretched(&mut self, local: &DAffine3) {
        if self.style.surface.is_some() {
            let frame = affine(&self.scope.frame);
            self.carried(&(frame * *local * frame.inverse()));
        }
    }

    /// The chart of a set; the native one where it has none. `None` for what has no surface.
    ///
    /// Cost where there is none yet: that of [`crate::geometry::Ribbon::along`].
    pub fn chart(&self, set: u32) -> Option<Chart> {
        let surface = self.attached();
        let own = surface.and_then(|s| s.chart(set).or_else(|| s.chart(0)));
        own.cloned().or_else(|| {
            let [first, second, third] = chart::native(self)?;
            Some(match set {
                1 => second,
                2 => third,
                _ => first,
            })
        })
    }

    /// Gives the shape its native charts where it has none, so that all that comes of it shares them.
    pub fn charted(&mut self) {
        if self.attached().is_some_and(|surface| !surface.charts.is_empty()) {
            return;
        }
        if let Some(charts) = chart::native(self) {
            self.surface_mut().charts = (0..).zip(charts).collect();
        }
    }

    /// About what it turns: the pivot where one is set, else its scope's origin and axes.
    pub fn pivot(&self) -> Frame {
        self.attached().and_then(|surface| surface.pivot).unwrap_or(self.scope.frame)
    }

    fn carried(&mut self, motion: &DAffine3) {
        if *motion != DAffine3::IDENTITY {
            self.surface_mut().carried(motion);
        }
    }
}

fn put<K: Ord, V>(list: &mut Vec<(K, V)>, key: K, value: V) {
    match list.binary_search_by(|(own, _)| own.cmp(&key)) {
        Ok(index) => list[index].1 = value,
        Err(index) => list.insert(index, (key, value)),
    }
}

/// Local → world.
fn affine(frame: &Frame) -> DAffine3 {
    DAffine3::from_rotation_translation(frame.rotation, frame.origin)
}
