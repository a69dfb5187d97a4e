//! PNG → pixels. Palettes and bits below eight come out as colours of eight bits.

use crate::raster::pixels::{Pixels, Samples, expect_size};
use crate::raster::{Flaw, MOST_BYTES};
use image::codecs::png::PngDecoder;
use image::{DynamicImage, ImageDecoder, Limits};
use std::io::Cursor;

/// How a PNG begins.
pub const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Reads a PNG.
pub fn read(bytes: &[u8]) -> Result<Pixels, Flaw> {
    let damaged = |error: image::ImageError| Flaw::Damaged(error.to_string());
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits()).map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    expect_size(width, height)?;
    if decoder.total_bytes() > MOST_BYTES as u64 {
        return Err(Flaw::TooManyBytes);
    }
    let color = decoder.color_type();
    let samples = match DynamicImage::from_decoder(decoder).map_err(damaged)? {
        DynamicImage::ImageLuma8(image) => Samples::U8(image.into_raw()),
        DynamicImage::ImageLumaA8(image) => Samples::U8(image.into_raw()),
        DynamicImage::ImageRgb8(image) => Samples::U8(image.into_raw()),
        DynamicImage::ImageRgba8(image) => Samples::U8(image.into_raw()),
        DynamicImage::ImageLuma16(image) => Samples::U16(image.into_raw()),
        DynamicImage::ImageLumaA16(image) => Samples::U16(image.into_raw()),
        DynamicImage::ImageRgb16(image) => Samples::U16(image.into_raw()),
        DynamicImage::ImageRgba16(image) => Samples::U16(image.into_raw()),
        _ => return Err(Flaw::Unsupported(format!("PNG files of {color:?}"))),
    };
    Pixels::new([width, height], color.channel_count().into(), color.has_alpha(), samples)
}

fn limits() -> Limits {
    let mut limits = Limits::default();
    limits.max_alloc = Some(MOST_BYTES as u64);
    limits
}
