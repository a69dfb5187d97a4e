//! What CityEngine has and bosquet has not yet: the one list that checker and manual read.

/// An operation or function of CityEngine that is known by name only.
#[derive(Debug)]
pub struct Unbuilt {
    /// Its name.
    pub name: &'static str,
    /// What it does there, in a few words.
    pub does: &'static str,
}

const fn unbuilt(name: &'static str, does: &'static str) -> Unbuilt {
    Unbuilt { name, does }
}

/// Operations.
pub static UNBUILT_OPERATIONS: &[Unbuilt] = &[
    unbuilt("insertAlongUV", "bends an asset along texture coordinates"),
    unbuilt("envelope", "makes a zoning envelope"),
    unbuilt("translate", "moves within a chosen coordinate system"),
    unbuilt("rotate", "turns within a chosen coordinate system"),
    unbuilt("alignScopeToGeometry", "turns the scope along a face and an edge"),
    unbuilt("alignScopeToGeometryBBox", "turns the scope along the least box"),
    unbuilt("rotateScope", "turns the scope without the geometry"),
    unbuilt("mirrorScope", "mirrors the scope without the geometry"),
    unbuilt("setPivot", "moves the pivot"),
    unbuilt("trim", "cuts along trim planes"),
    unbuilt("resetGeometry", "undoes changes of the geometry"),
    unbuilt("modify", "changes components in place"),
    unbuilt("tag", "tags components"),
    unbuilt("deleteTags", "removes tags"),
    unbuilt("setTagsFromEdgeAttrs", "tags edges by their attributes"),
    unbuilt("texture", "sets a texture"),
    unbuilt("setupProjection", "sets up texture projection"),
    unbuilt("projectUV", "projects texture coordinates"),
    unbuilt("translateUV", "moves texture coordinates"),
    unbuilt("scaleUV", "scales texture coordinates"),
    unbuilt("normalizeUV", "normalises texture coordinates"),
    unbuilt("tileUV", "tiles texture coordinates"),
    unbuilt("rotateUV", "turns texture coordinates"),
    unbuilt("deleteUV", "removes texture coordinates"),
    unbuilt("copyUV", "copies texture coordinates"),
    unbuilt("offsetUV", "moves texture coordinates"),
    unbuilt("setMaterial", "sets all of a material"),
    unbuilt("resetMaterial", "resets the material"),
];

/// Functions.
pub static UNBUILT_FUNCTIONS: &[Unbuilt] = &[
    unbuilt("geometry.du", "the extent along u"),
    unbuilt("geometry.dv", "the extent along v"),
    unbuilt("geometry.groups", "the number of groups"),
    unbuilt("geometry.hasTags", "whether there are tags"),
    unbuilt("geometry.hasUVs", "whether there are texture coordinates"),
    unbuilt("geometry.materials", "the number of materials"),
    unbuilt("geometry.tags", "the tags"),
    unbuilt("geometry.uMin", "the least u"),
    unbuilt("geometry.uMax", "the greatest u"),
    unbuilt("geometry.vMin", "the least v"),
    unbuilt("geometry.vMax", "the greatest v"),
    unbuilt("isTagged", "selects by tag"),
    unbuilt("getMaterial", "reads the material"),
    unbuilt("readMaterial", "reads a material file"),
    unbuilt("edgeAttr.getFloat", "the attribute of an edge"),
    unbuilt("edgeAttr.getString", "the attribute of an edge"),
    unbuilt("edgeAttr.getBool", "the attribute of an edge"),
];
