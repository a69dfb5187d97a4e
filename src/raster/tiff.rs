//! TIFF → pixels and georeferencing tags. The first image of the file counts; overviews behind it are not looked at.

use crate::raster::geotiff::Tags;
use crate::raster::pixels::{Pixels, Samples, expect_size};
use crate::raster::{Flaw, MOST_BYTES};
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

/// How a TIFF or BigTIFF begins, little and big endian.
pub const SIGNATURES: [&[u8]; 4] = [b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"];

/// A tag is at most this long (bytes): offsets of the strips of the largest raster.
const MOST_TAG_BYTES: usize = 64 << 20;

type Reader<'a> = Decoder<Cursor<&'a [u8]>>;

/// Reads a TIFF.
pub fn read(bytes: &[u8]) -> Result<(Pixels, Tags), Flaw> {
    let decoder = Decoder::new(Cursor::new(bytes)).map_err(flaw)?;
    let mut decoder = decoder.with_limits(limits());
    let (width, height) = decoder.dimensions().map_err(flaw)?;
    let count = expect_size(width, height)?;
    let color = decoder.colortype().map_err(flaw)?;
    expect_readable(color)?;
    let mut result = DecodingResult::U8(Vec::new());
    let layout = decoder.read_image_to_buffer(&mut result).map_err(flaw)?;
    if result.as_buffer(0).byte_len() < layout.complete_len {
        return Err(Flaw::TooManyBytes);
    }
    let mut samples = samples(result);
    if color.bit_depth() < 8 {
        samples = unpacked(samples, color.bit_depth(), [width as usize, height as usize]);
    }
    let bands = samples.len() / count;
    if layout.planes > 1 {
        samples = interleaved(samples, bands, count);
    }
    let has_alpha = has_alpha(&mut decoder, color, bands);
    let mut pixels = Pixels::new([width, height], bands, has_alpha, samples)?;
    if let Some(value) = no_data(&mut decoder) {
        pixels = pixels.without(value);
    }
    Ok((pixels, tags(&mut decoder)))
}

fn limits() -> Limits {
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MOST_BYTES;
    limits.intermediate_buffer_size = MOST_BYTES;
    limits.ifd_value_size = MOST_TAG_BYTES;
    limits
}

fn flaw(error: TiffError) -> Flaw {
    match error {
        TiffError::LimitsExceeded => Flaw::TooManyBytes,
        TiffError::UnsupportedError(what) => Flaw::Unsupported(format!("TIFF files of this sort ({what})")),
        other => Flaw::Damaged(other.to_string()),
    }
}

fn expect_readable(color: ColorType) -> Result<(), Flaw> {
    let whole = matches!(color.bit_depth(), 8 | 16 | 32 | 64);
    let small = matches!(color.bit_depth(), 1 | 2 | 4);
    match color {
        ColorType::Gray(_) if whole || small => Ok(()),
        ColorType::GrayA(_) | ColorType::RGB(_) | ColorType::RGBA(_) | ColorType::Multiband { .. } if whole => Ok(()),
        other => Err(Flaw::Unsupported(format!("TIFF files of {other:?}"))),
    }
}

/// Bytes and words as they are, everything else as a number.
fn samples(result: DecodingResult) -> Samples {
    match result {
        DecodingResult::U8(values) => Samples::U8(values),
        DecodingResult::U16(values) => Samples::U16(values),
        DecodingResult::U32(values) => Samples::F32(values.into_iter().map(|v| v as f32).collect()),
        DecodingResult::U64(values) => Samples::F32(values.into_iter().map(|v| v as f32).collect()),
        DecodingResult::F16(values) => Samples::F32(values.into_iter().map(f32::from).collect()),
        DecodingResult::F32(values) => Samples::F32(values),
        DecodingResult::F64(values) => Samples::F32(values.into_iter().map(|v| v as f32).collect()),
        DecodingResult::I8(values) => Samples::F32(values.into_iter().map(f32::from).collect()),
        DecodingResult::I16(values) => Samples::F32(values.into_iter().map(f32::from).collect()),
        DecodingResult::I32(values) => Samples::F32(values.into_iter().map(|v| v as f32).collect()),
        DecodingResult::I64(values) => Samples::F32(values.into_iter().map(|v| v as f32).collect()),
    }
}

/// Greys of less than a byte, each in a byte of its own and spread over its range. Rows begin with a byte.
fn unpacked(samples: Samples, bits: u8, [width, height]: [usize; 2]) -> Samples {
    let Samples::U8(packed) = samples else { return samples };
    let bits = usize::from(bits);
    let (each, most) = (8 / bits, u8::MAX >> (8 - bits));
    let spread = u8::MAX / most;
    let stride = width.div_ceil(each);
    let sample = |i: usize| {
        let (row, column) = (i / width, i % width);
        let byte = packed.get(row * stride + column / each).copied().unwrap_or(0);
        (byte >> (8 - bits * (column % each + 1)) & most) * spread
    };
    Samples::U8((0..width * height).map(sample).collect())
}

/// Planes one after the other → the samples of each pixel together.
fn interleaved(samples: Samples, bands: usize, count: usize) -> Samples {
    fn mixed<T: Copy>(planes: &[T], bands: usize, count: usize) -> Vec<T> {
        (0..count).flat_map(|pixel| (0..bands).map(move |band| planes[band * count + pixel])).collect()
    }
    match samples {
        Samples::U8(planes) => Samples::U8(mixed(&planes, bands, count)),
        Samples::U16(planes) => Samples::U16(mixed(&planes, bands, count)),
        Samples::F32(planes) => Samples::F32(mixed(&planes, bands, count)),
    }
}

fn has_alpha(decoder: &mut Reader, color: ColorType, bands: usize) -> bool {
    let mut extra = || decoder.find_tag_unsigned_vec::<u16>(Tag::ExtraSamples).ok().flatten().unwrap_or_default();
    match color {
        ColorType::RGBA(_) | ColorType::GrayA(_) => true,
        ColorType::Multiband { .. } => bands == 2 && matches!(extra()[..], [1 | 2]),
        _ => false,
    }
}

/// GDAL writes the number that means nothing as a text.
fn no_data(decoder: &mut Reader) -> Option<f64> {
    let text = decoder.find_tag(Tag::GdalNodata).ok()??.into_string().ok()?;
    text.trim_matches(|c: char| c == '\0' || c.is_whitespace()).parse().ok()
}

fn tags(decoder: &mut Reader) -> Tags {
    let mut numbers = |tag: Tag| decoder.get_tag_f64_vec(tag).unwrap_or_default();
    let scale = numbers(Tag::ModelPixelScaleTag);
    let ties = numbers(Tag::ModelTiepointTag);
    let matrix = numbers(Tag::ModelTransformationTag);
    let keys = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
    Tags { scale, ties, matrix, keys }
}
