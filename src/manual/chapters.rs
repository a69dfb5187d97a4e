//! What operations are for: the parts of the manual, and the one place that says which operation belongs to which.

use crate::ops::{OPERATIONS, Origin, Spec};

/// A part of the manual: a heading, what stands under it, and its operations.
pub struct Part {
    /// The heading.
    pub title: &'static str,
    /// A sentence about what they have in common.
    pub about: &'static str,
    names: &'static [&'static str],
}

/// The parts in the order of the manual. What none of them names stands at the end, under `OTHERS`.
pub static PARTS: &[Part] = &[
    Part {
        title: "Divide",
        about: "One shape becomes several that together are the whole.",
        names: &[
            "split",
            "splitArea",
            "setback",
            "setbackPerEdge",
            "setbackToArea",
            "splitAndSetbackPerimeter",
            "shapeL",
            "shapeU",
            "shapeO",
            "innerRectangle",
            "innerRect",
            "offset",
            "comp",
            "coverage",
        ],
    },
    Part {
        title: "Put together and take away",
        about: "What is derived in place, or what stands already, changes the shape.",
        names: &["without", "union", "subtract", "intersect", "inline"],
    },
    Part {
        title: "Place plants and things",
        about: "Points that keep clear of each other and of what stands; then what grows there.",
        names: &[
            "plant",
            "i",
            "I",
            "along",
            "rows",
            "quincunx",
            "regular",
            "semirandom",
            "boundary",
            "cluster",
            "single",
            "equidistant",
            "scatter",
            "Distr",
        ],
    },
    Part {
        title: "Raise and build",
        about: "Flat shapes become hedges, walls, houses; or a shape becomes another.",
        names: &[
            "extrude",
            "taper",
            "roofHip",
            "roofGable",
            "roofPyramid",
            "roofRidge",
            "roofShed",
            "primitiveQuad",
            "primitiveDisk",
            "primitiveCube",
            "primitiveCylinder",
            "primitiveCone",
            "primitiveSphere",
            "footprint",
        ],
    },
    Part {
        title: "Move, turn, size",
        about: "The scope says where a shape is and how large.",
        names: &[
            "t",
            "s",
            "r",
            "center",
            "translate",
            "rotate",
            "mirror",
            "alignScopeToAxes",
            "alignScopeToGeometry",
            "alignScopeToGeometryBBox",
            "rotateScope",
            "mirrorScope",
            "setPivot",
        ],
    },
    Part {
        title: "Mend outlines",
        about: "Corners, holes and edges as surveys bring them.",
        names: &["cleanupGeometry", "rectify", "convexify", "deleteHoles", "resetGeometry", "reverseNormals", "trim"],
    },
    Part {
        title: "Looks",
        about: "What a shape is made of.",
        names: &["set", "color", "setMaterial", "resetMaterial", "texture"],
    },
    Part {
        title: "Name and tell",
        about: "Names by which others find a shape, and numbers for the reader.",
        names: &["label", "tag", "deleteTags", "setTagsFromEdgeAttrs", "report", "print"],
    },
];

/// The heading of what no part names: texture coordinates and meshes, which plans do not show.
pub const OTHERS: &str = "CityEngine's others";

impl Part {
    /// Its operations, in its order.
    pub fn operations(&self) -> impl Iterator<Item = &'static Spec> {
        let find = |name: &&str| OPERATIONS.iter().map(|o| o.spec).find(|spec| spec.name == *name);
        self.names.iter().filter_map(find)
    }

    /// The names it lists, whether or not there are such operations.
    pub fn names(&self) -> &'static [&'static str] {
        self.names
    }
}

/// The operations that no part names: CityEngine's alone, since ours belong somewhere.
pub fn others() -> impl Iterator<Item = &'static Spec> {
    OPERATIONS.iter().map(|o| o.spec).filter(|spec| part_of(spec).is_none() && spec.origin == Origin::CityEngine)
}

/// The part that names an operation.
pub fn part_of(spec: &Spec) -> Option<&'static Part> {
    PARTS.iter().find(|part| part.names.contains(&spec.name))
}
