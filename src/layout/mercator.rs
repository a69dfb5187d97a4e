//! The transverse Mercator projection on the WGS84 ellipsoid, centred where the layout is.
//!
//! Degrees in, metres out, and back. True to scale at the centre and within 1 in 10,000 up to 90 km east or west of
//! it. The mathematics is `libm`'s, so a plan has the same bytes on every platform. Knows no coordinate system by
//! name and no file.
//!
//! Krüger's series in the third flattening, fourth order: Karney 2011, "Transverse Mercator with an accuracy of a few
//! nanometers", J. Geodesy 85(8), equations 7-9, 14, 35, 36. What is left out stays below 0.1 micrometres.

use glam::DVec2;

/// The larger half axis of WGS84, metres.
const HALF_AXIS: f64 = 6_378_137.0;
/// The flattening of WGS84.
const FLATTENING: f64 = 1.0 / 298.257_223_563;
/// The third flattening.
const N: f64 = FLATTENING / (2.0 - FLATTENING);
/// A quarter meridian by a right angle, metres.
const RADIUS: f64 = HALF_AXIS / (1.0 + N) * (1.0 + N * N / 4.0 + N * N * N * N / 64.0);
/// From the conformal to the projected.
const ALPHA: [f64; 4] = [
    N * (1.0 / 2.0 + N * (-2.0 / 3.0 + N * (5.0 / 16.0 + N * 41.0 / 180.0))),
    N * N * (13.0 / 48.0 + N * (-3.0 / 5.0 + N * 557.0 / 1440.0)),
    N * N * N * (61.0 / 240.0 - N * 103.0 / 140.0),
    N * N * N * N * 49561.0 / 161_280.0,
];
/// From the projected to the conformal.
const BETA: [f64; 4] = [
    N * (1.0 / 2.0 + N * (-2.0 / 3.0 + N * (37.0 / 96.0 - N / 360.0))),
    N * N * (1.0 / 48.0 + N * (1.0 / 15.0 - N * 437.0 / 1440.0)),
    N * N * N * (17.0 / 480.0 - N * 37.0 / 840.0),
    N * N * N * N * 4397.0 / 161_280.0,
];

/// The projection with its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TransverseMercator {
    longitude: f64,
    /// Northing of the centre's latitude, in units of [`RADIUS`].
    northing: f64,
}

impl TransverseMercator {
    /// The projection around a longitude and latitude in degrees.
    pub(super) fn around(centre: [f64; 2]) -> TransverseMercator {
        let at_equator = TransverseMercator { longitude: centre[0], northing: 0.0 };
        TransverseMercator { longitude: centre[0], northing: at_equator.forward(centre).y / RADIUS }
    }

    /// Longitude and latitude in degrees → metres east and north of the centre; not finite a quarter round the globe.
    pub(super) fn forward(&self, [longitude, latitude]: [f64; 2]) -> DVec2 {
        let tau = libm::tan(latitude.to_radians());
        let (sin, cos) = libm::sincos(turn(longitude - self.longitude).to_radians());
        let conformal = conformal(tau);
        let xi = libm::atan2(conformal, cos);
        let eta = libm::asinh(sin / libm::hypot(conformal, cos));
        let (up, across) = series(&ALPHA, xi, eta);
        RADIUS * DVec2::new(eta + across, xi + up - self.northing)
    }

    /// Metres east and north of the centre → longitude and latitude in degrees.
    pub(super) fn inverse(&self, plan: DVec2) -> [f64; 2] {
        let (eta, xi) = (plan.x / RADIUS, plan.y / RADIUS + self.northing);
        let (up, across) = series(&BETA, xi, eta);
        let (xi, eta) = (xi - up, eta - across);
        let (sin, cos) = libm::sincos(xi);
        let sinh = libm::sinh(eta);
        let tau = geodetic(sin / libm::hypot(sinh, cos));
        [turn(self.longitude + libm::atan2(sinh, cos).to_degrees()), libm::atan(tau).to_degrees()]
    }
}

/// The sums of the series: the sine terms along the meridian, the cosine terms across it.
fn series(coefficients: &[f64; 4], xi: f64, eta: f64) -> (f64, f64) {
    let terms = coefficients.iter().zip([2.0, 4.0, 6.0, 8.0]).map(|(c, k)| {
        let (sin, cos) = libm::sincos(k * xi);
        (c * sin * libm::cosh(k * eta), c * cos * libm::sinh(k * eta))
    });
    terms.fold((0.0, 0.0), |(up, across), (u, a)| (up + u, across + a))
}

/// The tangent of the conformal latitude from that of the geodetic.
fn conformal(tau: f64) -> f64 {
    let eccentricity = (FLATTENING * (2.0 - FLATTENING)).sqrt();
    let secant = libm::hypot(1.0, tau);
    let sigma = libm::sinh(eccentricity * libm::atanh(eccentricity * tau / secant));
    tau * libm::hypot(1.0, sigma) - sigma * secant
}

/// The tangent of the geodetic latitude from that of the conformal: Newton's method, to full precision in three steps.
fn geodetic(wanted: f64) -> f64 {
    let e2 = FLATTENING * (2.0 - FLATTENING);
    let mut tau = wanted / (1.0 - e2);
    for _ in 0..4 {
        let got = conformal(tau);
        let slope = (1.0 - e2) * libm::hypot(1.0, tau) * libm::hypot(1.0, got) / (1.0 + (1.0 - e2) * tau * tau);
        tau += (wanted - got) / slope;
    }
    tau
}

/// An angle in degrees brought into ±180.
fn turn(degrees: f64) -> f64 {
    if degrees.abs() <= 180.0 { degrees } else { degrees - 360.0 * (degrees / 360.0).round() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Metres by PROJ 9 (`+proj=tmerc +lat_0=48.8 +lon_0=2.12 +datum=WGS84`).
    const PROJ: [([f64; 2], [f64; 2]); 4] = [
        ([2.12, 48.8], [0.000000, 0.000000]),
        ([2.102635, 48.814415], [-1275.342281, 1603.179952]),
        ([3.5, 47.9], [103180.854285, -99155.359764]),
        ([-0.75, 50.25], [-204682.284842, 165211.706345]),
    ];

    #[test]
    fn agrees_with_proj() {
        let mercator = TransverseMercator::around([2.12, 48.8]);
        for (degrees, metres) in PROJ {
            let got = mercator.forward(degrees);
            assert!(got.distance(DVec2::from(metres)) < 1e-5, "{degrees:?}: {got} instead of {metres:?}");
        }
    }

    #[test]
    fn comes_back_everywhere() {
        for centre in [[2.12, 48.8], [-71.1, 42.4], [179.99, -16.5], [18.0, 78.0], [0.0, 0.0], [-70.0, -55.0]] {
            let mercator = TransverseMercator::around(centre);
            for plan in [DVec2::ZERO, DVec2::new(3.0e3, -2.0e3), DVec2::new(-9.0e4, 4.0e4), DVec2::new(0.5, 2.0e5)] {
                let back = mercator.forward(mercator.inverse(plan));
                assert!(back.distance(plan) < 1e-6, "{centre:?} {plan}: {back}");
            }
        }
    }
}
