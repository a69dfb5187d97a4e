//! GeoJSON → layout.
use crate::diag::Diagnostic;
use crate::layout::Layout;

/// Reads a GeoJSON text. Never fails: what cannot be used is reported with its feature and left out.
pub fn read_geojson(_path: &str, _bytes: &[u8]) -> (Layout, Vec<Diagnostic>) {
    unimplemented!()
}
