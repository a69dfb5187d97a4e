//! A picture's pixels → the same in few colours: the most frequent ones, after near ones have been put together.
//!
//! What is equally frequent is taken in the order of the colours, so that equal pictures stay equal.

use std::collections::BTreeMap;

/// How near colours are put together, in 1/255 of a channel: less is not seen.
const STEP: i32 = 8;

/// Replaces each pixel (three bytes) by the nearest of `most` colours. Cost: colours times `most`, and the pixels.
pub fn reduce(rgb: &mut [u8], most: usize) {
    let mut counts: BTreeMap<[u8; 3], usize> = BTreeMap::new();
    rgb.as_chunks::<3>().0.iter().for_each(|pixel| *counts.entry(rounded(*pixel)).or_default() += 1);
    let palette = frequent(&counts, most);
    let nearest: BTreeMap<[u8; 3], [u8; 3]> = counts.keys().map(|colour| (*colour, near(&palette, *colour))).collect();
    for pixel in rgb.as_chunks_mut::<3>().0 {
        *pixel = nearest.get(&rounded(*pixel)).copied().unwrap_or(*pixel);
    }
}

fn frequent(counts: &BTreeMap<[u8; 3], usize>, most: usize) -> Vec<[u8; 3]> {
    let mut colours: Vec<([u8; 3], usize)> = counts.iter().map(|(colour, count)| (*colour, *count)).collect();
    colours.sort_by_key(|(colour, count)| (std::cmp::Reverse(*count), *colour));
    colours.into_iter().take(most).map(|(colour, _)| colour).collect()
}

fn near(palette: &[[u8; 3]], colour: [u8; 3]) -> [u8; 3] {
    let distance =
        |other: &[u8; 3]| -> i32 { (0..3).map(|i| (i32::from(other[i]) - i32::from(colour[i])).pow(2)).sum() };
    palette.iter().copied().min_by_key(distance).unwrap_or(colour)
}

fn rounded(pixel: [u8; 3]) -> [u8; 3] {
    pixel.map(|channel| ((i32::from(channel) + STEP / 2) / STEP * STEP).min(255) as u8)
}
