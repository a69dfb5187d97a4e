//! The way between plan metres and the world: from a layout's coordinates to the plan, and back.
//!
//! A plan is metres around a centre, x east, y north. WGS84 degrees get a transverse Mercator of their own, true to
//! scale at the centre. A projected system whose metres are metres there keeps its grid and is only moved. Web
//! Mercator, feet and foreign degrees go through WGS84. All three come back to better than a tenth of a millimetre.
//! Knows no file.

use crate::layout::mercator::TransverseMercator;
use crate::layout::{Crs, CrsError};
use glam::DVec2;
use proj4rs::Proj;
use proj4rs::adaptors::transform_xy;
use std::sync::Arc;

/// WGS84 in PROJ's words.
const DEGREES: &str = "+proj=longlat +datum=WGS84 +no_defs";
/// A grid is kept where a metre of it is a metre on the ground to this share (UTM: 0.0004; Web Mercator at Paris: 0.5).
const SCALE_TOLERANCE: f64 = 0.003;
/// A grid is kept where its north is true north to this many radians (Křovák's: 0.17).
const TURN_TOLERANCE: f64 = 0.35;

/// The way from the layout's own coordinates to plan metres and back.
#[derive(Clone, Debug)]
pub struct Georeference {
    /// The layout's system.
    pub crs: Crs,
    /// The plan's origin in the layout's own coordinates (x or longitude, y or latitude).
    pub centre: [f64; 2],
    way: Way,
}

/// How plan and layout are tied together.
#[derive(Clone, Debug)]
enum Way {
    /// Only moved; the system is there to say where on earth it is.
    Moved(Option<Arc<System>>),
    /// Degrees on WGS84.
    Degrees(TransverseMercator),
    /// Another system, by way of WGS84.
    Through(Arc<System>, TransverseMercator),
}

/// A system of the register and WGS84, ready for computing.
#[derive(Debug)]
struct System {
    own: Proj,
    degrees: Proj,
}

impl Georeference {
    /// The way for coordinates in `crs` around `centre`.
    pub fn new(crs: Crs, centre: [f64; 2]) -> Result<Georeference, CrsError> {
        let way = match &crs {
            Crs::Wgs84 => Way::Degrees(TransverseMercator::around(centre)),
            Crs::Local => Way::Moved(None),
            Crs::Epsg(_) => Way::of(&crs, centre)?,
        };
        Ok(Georeference { crs, centre, way })
    }

    /// The layout's own coordinates → plan metres; not finite where they have no place in the plan.
    pub fn to_plan(&self, world: [f64; 2]) -> DVec2 {
        match &self.way {
            Way::Moved(_) => DVec2::from(world) - DVec2::from(self.centre),
            Way::Degrees(mercator) => mercator.forward(world),
            Way::Through(system, mercator) => system.to_degrees(world).map_or(DVec2::NAN, |d| mercator.forward(d)),
        }
    }

    /// Plan metres → the layout's own coordinates; not finite where the plan leaves the system.
    pub fn to_world(&self, plan: DVec2) -> [f64; 2] {
        match &self.way {
            Way::Moved(_) => (plan + DVec2::from(self.centre)).to_array(),
            Way::Degrees(mercator) => mercator.inverse(plan),
            Way::Through(system, mercator) => system.from_degrees(mercator.inverse(plan)).unwrap_or([f64::NAN; 2]),
        }
    }

    /// Plan metres → longitude and latitude in degrees on WGS84; none for local metres.
    pub fn lonlat(&self, plan: DVec2) -> Option<[f64; 2]> {
        match &self.way {
            Way::Moved(None) => None,
            Way::Moved(Some(system)) => system.to_degrees(self.to_world(plan)),
            Way::Degrees(mercator) | Way::Through(_, mercator) => Some(mercator.inverse(plan)),
        }
    }
}

/// Metres without a place on earth.
impl Default for Georeference {
    fn default() -> Georeference {
        Georeference { crs: Crs::Local, centre: [0.0; 2], way: Way::Moved(None) }
    }
}

/// The same system and origin; the way follows from them.
impl PartialEq for Georeference {
    fn eq(&self, other: &Georeference) -> bool {
        self.crs == other.crs && self.centre == other.centre
    }
}

impl Way {
    /// The way of a system of the register: moved where its grid is true enough, else through WGS84.
    fn of(crs: &Crs, centre: [f64; 2]) -> Result<Way, CrsError> {
        let system = Arc::new(System::of(crs)?);
        let outside = || CrsError::Unsupported {
            name: crs.to_string(),
            reason: format!("the place {}, {} lies outside of it", centre[0], centre[1]),
        };
        let mercator = TransverseMercator::around(system.to_degrees(centre).ok_or_else(outside)?);
        let kept = system.is_true_grid(&mercator, centre);
        Ok(if kept { Way::Moved(Some(system)) } else { Way::Through(system, mercator) })
    }
}

impl System {
    fn of(crs: &Crs) -> Result<System, CrsError> {
        let definition = crs.definition().ok_or_else(|| CrsError::Unknown(crs.to_string()))?;
        let proj = |words: &str| {
            let refused =
                |e: proj4rs::errors::Error| CrsError::Unsupported { name: crs.to_string(), reason: e.to_string() };
            Proj::from_proj_string(words).map_err(refused)
        };
        Ok(System { own: proj(definition)?, degrees: proj(DEGREES)? })
    }

    fn to_degrees(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let (x, y) = if self.own.is_latlong() { (x.to_radians(), y.to_radians()) } else { (x, y) };
        let (longitude, latitude) = transform_xy(&self.own, &self.degrees, x, y).ok()?;
        finite([longitude.to_degrees(), latitude.to_degrees()])
    }

    fn from_degrees(&self, [longitude, latitude]: [f64; 2]) -> Option<[f64; 2]> {
        let (x, y) = transform_xy(&self.degrees, &self.own, longitude.to_radians(), latitude.to_radians()).ok()?;
        finite(if self.own.is_latlong() { [x.to_degrees(), y.to_degrees()] } else { [x, y] })
    }

    /// Whether a unit of the grid is a metre at the centre, its x points east, and its y north.
    fn is_true_grid(&self, mercator: &TransverseMercator, centre: [f64; 2]) -> bool {
        let reach = 100.0;
        let step = |x: f64, y: f64| {
            let there = self.to_degrees([centre[0] + x, centre[1] + y])?;
            Some(mercator.forward(there) / reach)
        };
        let is_near = |got: Option<DVec2>, axis: DVec2| {
            got.is_some_and(|v| {
                (v.length() - 1.0).abs() < SCALE_TOLERANCE
                    && v.perp_dot(axis).abs() < TURN_TOLERANCE
                    && v.dot(axis) > 0.0
            })
        };
        is_near(step(reach, 0.0), DVec2::X) && is_near(step(0.0, reach), DVec2::Y)
    }
}

fn finite(pair: [f64; 2]) -> Option<[f64; 2]> {
    pair.iter().all(|v| v.is_finite()).then_some(pair)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A place in each system, and where PROJ 9 puts it (longitude, latitude).
    const PLACES: [(u16, [f64; 2], [f64; 2]); 7] = [
        (2154, [652_469.0, 6_862_035.0], [2.352_199_719_5, 48.856_597_665_4]),
        (3857, [1_603_599.22, 6_464_369.82], [14.405_376_889_3, 50.104_365_825_8]),
        (2263, [990_000.0, 200_000.0], [-73.979_258_038_3, 40.715_628_629_5]),
        (25833, [392_000.0, 5_820_000.0], [13.408_275_440_3, 52.519_395_318_4]),
        (27700, [530_000.0, 180_000.0], [-0.128_353_940_5, 51.503_990_827_6]),
        (5514, [-740_000.0, -1_040_000.0], [14.454_431_598_6, 50.117_740_602_6]),
        (28992, [121_000.0, 487_000.0], [4.887_970_764_8, 52.369_826_210]),
    ];

    #[test]
    fn places_are_where_proj_puts_them() {
        for (code, place, [longitude, latitude]) in PLACES {
            let georeference = Georeference::new(Crs::Epsg(code), place).expect("a system of the register");
            let got = georeference.lonlat(DVec2::ZERO).expect("a place on earth");
            let off = TransverseMercator::around([longitude, latitude]).forward(got);
            // The register's short datum shifts are good to some metres; systems tied to WGS84 are exact.
            let tolerance = if [2154, 3857, 25833, 2263].contains(&code) { 0.01 } else { 12.0 };
            assert!(off.length() < tolerance, "EPSG:{code}: {got:?}, {off} m off");
        }
    }

    #[test]
    fn metres_of_the_plan_are_metres_on_the_ground() {
        let side = |code, place: [f64; 2], step: f64| {
            let georeference = Georeference::new(Crs::Epsg(code), place).expect("a system of the register");
            georeference.to_plan([place[0] + step, place[1]]).length()
        };
        assert_eq!(side(2154, PLACES[0].1, 100.0), 100.0, "a metric grid is kept");
        let mercator = side(3857, PLACES[1].1, 100.0);
        assert!((mercator - 64.2).abs() < 0.2, "web mercator is not: {mercator}");
        let feet = side(2263, PLACES[2].1, 100.0);
        assert!((feet - 30.48).abs() < 0.01, "nor are feet: {feet}");
    }

    #[test]
    fn threads_may_share_it() {
        fn shared<T: Send + Sync>() {}
        shared::<Georeference>();
    }

    #[test]
    fn local_metres_have_no_place() {
        let local = Georeference::new(Crs::Local, [10.0, 20.0]).expect("always");
        assert_eq!(local.to_plan([12.0, 25.0]), DVec2::new(2.0, 5.0));
        assert_eq!(local.lonlat(DVec2::ZERO), None);
    }

    proptest! {
        #[test]
        fn there_and_back(which in 0..PLACES.len() + 1, x in -5e3..5e3, y in -5e3..5e3) {
            let (crs, place) = match PLACES.get(which) {
                Some((code, place, _)) => (Crs::Epsg(*code), *place),
                None => (Crs::Wgs84, [2.12, 48.8]),
            };
            let georeference = Georeference::new(crs, place).expect("a system of the register");
            let plan = DVec2::new(x, y);
            let back = georeference.to_plan(georeference.to_world(plan));
            prop_assert!(back.distance(plan) < 1e-4, "{plan} comes back as {back}");
        }
    }
}
