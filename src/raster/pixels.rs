//! The samples of a picture, as its file has them, and what they say from 0 to 1.

use crate::raster::{Flaw, MOST_PIXELS};

/// Samples, all bands of a pixel together, row by row from the top.
#[derive(Clone, Debug)]
pub enum Samples {
    /// Bytes: 255 is full.
    U8(Vec<u8>),
    /// Words: 65535 is full.
    U16(Vec<u16>),
    /// Numbers that mean what they mean.
    F32(Vec<f32>),
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Pixels {
    size: [usize; 2],
    bands: usize,
    has_alpha: bool,
    samples: Samples,
    /// What a sample is divided by.
    full: f32,
    /// A sample of this value says nothing.
    no_data: Option<f32>,
    /// Some pixel is not opaque.
    is_clear_somewhere: bool,
}

/// The number of pixels, where a raster may have so many.
pub fn expect_size(width: u32, height: u32) -> Result<usize, Flaw> {
    match u64::from(width) * u64::from(height) {
        0 => Err(Flaw::Empty),
        count if count > MOST_PIXELS => Err(Flaw::TooManyPixels(count)),
        count => Ok(count as usize),
    }
}

impl Samples {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Samples::U8(values) => values.len(),
            Samples::U16(values) => values.len(),
            Samples::F32(values) => values.len(),
        }
    }

    fn at(&self, index: usize) -> f32 {
        match self {
            Samples::U8(values) => values[index].into(),
            Samples::U16(values) => values[index].into(),
            Samples::F32(values) => values[index],
        }
    }

    /// What a full sample is. Grey pictures of nothing but 0 and 1 are masks: their 1 is full.
    fn full(&self, bands: usize) -> f32 {
        let is_mask = bands == 1
            && match self {
                Samples::U8(values) => values.iter().all(|v| *v <= 1),
                Samples::U16(values) => values.iter().all(|v| *v <= 1),
                Samples::F32(_) => true,
            };
        match self {
            _ if is_mask => 1.0,
            Samples::U8(_) => u8::MAX.into(),
            Samples::U16(_) => u16::MAX.into(),
            Samples::F32(_) => 1.0,
        }
    }
}

impl Pixels {
    /// A picture of that size; an error where the samples do not fill it.
    pub fn new([width, height]: [u32; 2], bands: usize, has_alpha: bool, samples: Samples) -> Result<Pixels, Flaw> {
        let count = expect_size(width, height)?;
        if bands == 0 || samples.len() != count * bands {
            return Err(Flaw::Damaged(format!("{} samples do not fill {width} × {height} pixels", samples.len())));
        }
        let size = [width as usize, height as usize];
        let full = samples.full(bands);
        let mut pixels = Pixels { size, bands, has_alpha, samples, full, no_data: None, is_clear_somewhere: false };
        pixels.is_clear_somewhere =
            has_alpha && (0..count).any(|pixel| pixels.samples.at(pixel * bands + bands - 1) < full);
        Ok(pixels)
    }

    /// The same, where samples of this value say nothing.
    pub fn without(self, value: f64) -> Pixels {
        Pixels { no_data: Some(value as f32), ..self }
    }

    /// Columns and rows.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Samples of a pixel, opacity among them.
    pub fn bands(&self) -> usize {
        self.bands
    }

    /// Its colours are red, green and blue.
    pub fn is_coloured(&self) -> bool {
        self.bands == 3 || self.bands == 4 && self.has_alpha
    }

    /// The last band is the opacity.
    pub fn has_alpha(&self) -> bool {
        self.has_alpha
    }

    /// Some pixel is not opaque.
    pub fn is_clear_somewhere(&self) -> bool {
        self.is_clear_somewhere
    }

    /// A sample, from 0 to 1 where it comes from a byte or word; none where it says nothing.
    pub fn value(&self, column: usize, row: usize, band: usize) -> Option<f32> {
        let sample = self.samples.at((row * self.size[0] + column) * self.bands + band);
        (sample.is_finite() && Some(sample) != self.no_data).then(|| sample / self.full)
    }
}
