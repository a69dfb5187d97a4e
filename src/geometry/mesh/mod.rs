//! Polygonal faces in space, flat buffers.

use glam::DVec3;

/// A mesh of planar polygonal faces with holes, metres. Faces run counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub positions: Vec<DVec3>,
    /// Vertex indices of all rings, one after the other.
    pub corners: Vec<u32>,
    /// Where each ring ends in `corners`; a face's first ring is its outline, the others its holes.
    pub rings: Vec<u32>,
    /// Where each face ends in `rings`.
    pub faces: Vec<u32>,
}
