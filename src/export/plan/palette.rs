//! A picture's pixels → the same in few colours: near ones are put together, and the most frequent stay.
//!
//! What is equally frequent is taken in the order of the colours, so that equal pictures stay equal.

use std::cmp::Reverse;
use std::collections::BTreeMap;

/// How near colours are put together, in 1/255 of a channel: less is not seen.
const STEP: u8 = 8;

type Colour = [u8; 3];

/// Replaces each pixel (three bytes) by the nearest of `most` colours. Cost: colours times `most`, and the pixels.
pub fn reduce(rgb: &mut [u8], most: usize) {
    let mut counts: BTreeMap<Colour, usize> = BTreeMap::new();
    rgb.as_chunks::<3>().0.iter().for_each(|pixel| *counts.entry(*pixel).or_default() += 1);
    let palette = frequent(&counts, most);
    let nearest: BTreeMap<Colour, Colour> = counts.into_keys().map(|colour| (colour, near(&palette, colour))).collect();
    for pixel in rgb.as_chunks_mut::<3>().0 {
        *pixel = nearest.get(pixel).copied().unwrap_or(*pixel);
    }
}

/// The most frequent colours; of those that are near each other, the one that stands for them.
fn frequent(counts: &BTreeMap<Colour, usize>, most: usize) -> Vec<Colour> {
    let mut groups: BTreeMap<Colour, (usize, usize, Colour)> = BTreeMap::new();
    for (colour, count) in counts {
        let (sum, best, stands) = groups.entry(colour.map(|channel| channel / STEP)).or_insert((0, 0, *colour));
        *sum += count;
        if count > best {
            (*best, *stands) = (*count, *colour);
        }
    }
    let mut colours: Vec<(usize, usize, Colour)> = groups.into_values().collect();
    colours.sort_by_key(|(sum, _, colour)| (Reverse(*sum), *colour));
    colours.into_iter().take(most).map(|(_, _, colour)| colour).collect()
}

fn near(palette: &[Colour], colour: Colour) -> Colour {
    let distance =
        |other: &Colour| -> i32 { colour.iter().zip(other).map(|(a, b)| (i32::from(*a) - i32::from(*b)).pow(2)).sum() };
    palette.iter().copied().min_by_key(distance).unwrap_or(colour)
}
