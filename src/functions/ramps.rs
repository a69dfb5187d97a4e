//! Colour ramps: even steps from one colour to the next, of our own choosing under CityEngine's names.

/// Red, green and blue, 0 to 255.
type Stop = [u8; 3];

static RAMPS: &[(&str, &[Stop])] = &[
    ("whiteToBlack", &[[255, 255, 255], [0, 0, 0]]),
    ("whiteToBlue", &[[255, 255, 255], [150, 200, 225], [20, 70, 150]]),
    ("greenToRed", &[[35, 140, 60], [165, 205, 85], [255, 240, 130], [240, 145, 70], [200, 30, 35]]),
    ("yellowToRed", &[[255, 245, 160], [250, 175, 75], [230, 90, 45], [160, 15, 35]]),
    ("redToBlue", &[[190, 30, 45], [240, 165, 130], [245, 245, 245], [140, 190, 220], [35, 95, 165]]),
    ("orangeToBlue", &[[215, 100, 15], [250, 185, 105], [245, 245, 245], [145, 180, 215], [40, 75, 140]]),
    ("brownToBlue", &[[125, 75, 20], [210, 175, 110], [245, 240, 225], [130, 195, 205], [15, 90, 130]]),
    (
        "spectrum",
        &[[200, 30, 40], [245, 150, 40], [250, 235, 75], [80, 175, 75], [45, 150, 195], [60, 70, 160], [125, 55, 145]],
    ),
];

/// The stops of a ramp.
pub(super) fn find(name: &str) -> Option<&'static [Stop]> {
    RAMPS.iter().find(|(known, _)| *known == name).map(|(_, stops)| *stops)
}

/// Every ramp.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    RAMPS.iter().map(|(name, _)| *name)
}

/// The colour at a place, in shares; places beyond 0 and 1 take the ends, what is not a number the beginning.
pub(super) fn at(stops: &[Stop], place: f64) -> [f64; 3] {
    let place = place.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let from = (place.floor() as usize).min(stops.len() - 2);
    let share = if place.is_nan() { 0.0 } else { place - from as f64 };
    std::array::from_fn(|channel| {
        let [a, b] = [stops[from], stops[from + 1]].map(|stop| f64::from(stop[channel]) / 255.0);
        a + (b - a) * share
    })
}
