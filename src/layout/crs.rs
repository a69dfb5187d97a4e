//! Coordinate systems by name: what a layout's numbers are numbers of.
//!
//! Names come in as GeoJSON's old `crs` member writes them, and go out the same way. The definitions are the EPSG
//! register's; the way between systems is [`crate::layout::Georeference`].

/// A coordinate system.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum Crs {
    /// Degrees on WGS84: GeoJSON's own.
    #[default]
    Wgs84,
    /// Metres without a place on earth.
    Local,
    /// Any other system by its EPSG code, in its own units.
    Epsg(u16),
}

/// Why a coordinate system cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CrsError {
    /// It is not known by that name.
    #[error("the coordinate system `{0}` is not known")]
    Unknown(String),
    /// It is known, but nobody has told us how to compute it.
    #[error("coordinates in `{name}` cannot be transformed: {reason}")]
    Unsupported {
        /// The system.
        name: String,
        /// What is missing.
        reason: String,
    },
}

impl Crs {
    /// The system called `name`: `EPSG:2154`, `urn:ogc:def:crs:EPSG::2154`, `urn:ogc:def:crs:OGC:1.3:CRS84`,
    /// `http://www.opengis.net/def/crs/EPSG/0/2154`, `WGS84`, or `local` for plain metres. Case does not count.
    ///
    /// Coordinates are always longitude (or easting) first, as GeoJSON wants them, whatever the register says.
    pub fn parse(name: &str) -> Result<Crs, CrsError> {
        let unknown = || CrsError::Unknown(name.trim().to_owned());
        let upper = name.trim().to_ascii_uppercase();
        let last = upper.rsplit([':', '/']).next().unwrap_or_default();
        match last {
            "LOCAL" => Ok(Crs::Local),
            "CRS84" | "CRS84H" | "WGS84" | "4326" | "4979" => Ok(Crs::Wgs84),
            code if upper == code || upper.contains("EPSG") => {
                let code: u16 = code.parse().map_err(|_| unknown())?;
                crs_definitions::from_code(code).map(|_| Crs::Epsg(code)).ok_or_else(unknown)
            }
            _ => Err(unknown()),
        }
    }

    /// The name for a GeoJSON `crs` member; none for WGS84, which needs no member.
    pub fn name(&self) -> Option<String> {
        match self {
            Crs::Wgs84 => None,
            Crs::Local => Some("local".to_owned()),
            Crs::Epsg(code) => Some(format!("urn:ogc:def:crs:EPSG::{code}")),
        }
    }

    /// Its definition in PROJ's words; none where there is nothing to compute.
    pub(super) fn definition(&self) -> Option<&'static str> {
        match self {
            Crs::Epsg(code) => crs_definitions::from_code(*code).map(|d| d.proj4),
            Crs::Wgs84 | Crs::Local => None,
        }
    }
}

/// The short name people use in messages.
impl std::fmt::Display for Crs {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Crs::Wgs84 => f.write_str("WGS84"),
            Crs::Local => f.write_str("local"),
            Crs::Epsg(code) => write!(f, "EPSG:{code}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_use_are_understood() {
        let cases = [
            ("urn:ogc:def:crs:OGC:1.3:CRS84", Crs::Wgs84),
            ("urn:ogc:def:crs:EPSG::4326", Crs::Wgs84),
            ("EPSG:4326", Crs::Wgs84),
            ("urn:ogc:def:crs:EPSG::2154", Crs::Epsg(2154)),
            ("urn:ogc:def:crs:EPSG:6.9:2154", Crs::Epsg(2154)),
            ("http://www.opengis.net/def/crs/EPSG/0/3857", Crs::Epsg(3857)),
            ("epsg:25833", Crs::Epsg(25833)),
            ("2154", Crs::Epsg(2154)),
            ("local", Crs::Local),
        ];
        for (name, crs) in cases {
            assert_eq!(Crs::parse(name), Ok(crs), "{name}");
        }
    }

    #[test]
    fn strangers_are_refused_by_name() {
        for name in ["EPSG:1", "EPSG:999999", "mars", "urn:ogc:def:crs:IAU::2154", "", "EPSG:"] {
            assert_eq!(Crs::parse(name), Err(CrsError::Unknown(name.to_owned())));
        }
    }

    #[test]
    fn a_written_name_reads_back() {
        for crs in [Crs::Local, Crs::Epsg(2154), Crs::Epsg(3857)] {
            assert_eq!(crs.name().as_deref().map(Crs::parse), Some(Ok(crs)));
        }
        assert_eq!(Crs::Wgs84.name(), None);
    }
}
