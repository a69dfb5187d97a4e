//! Points in polygons. Knows polygons and seeds and no language.
