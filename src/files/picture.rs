//! The size of a picture from the first bytes of its file, be it PNG, JPEG, GIF or BMP.

/// Width and height in pixels, or what is wrong with the file.
pub fn size(bytes: &[u8]) -> Result<[u32; 2], String> {
    let found = match bytes {
        [0x89, b'P', b'N', b'G', ..] => big(bytes, 16).zip(big(bytes, 20)),
        [0xff, 0xd8, ..] => jpeg(bytes),
        [b'G', b'I', b'F', b'8', ..] => little(bytes, 6).zip(little(bytes, 8)),
        [b'B', b'M', ..] => bmp(bytes),
        _ => return Err("is no picture whose size can be read: PNG, JPEG, GIF and BMP can".into()),
    };
    match found {
        Some((width, height)) if width > 0 && height > 0 => Ok([width, height]),
        _ => Err("ends before its size, or has none".into()),
    }
}

/// The frame header (`SOF`) comes after segments that say how long they are.
fn jpeg(bytes: &[u8]) -> Option<(u32, u32)> {
    let mut at = 2;
    loop {
        let [0xff, marker] = *bytes.get(at..at + 2)? else { return None };
        at += 2;
        match marker {
            // Filling and markers without content.
            0xff => at -= 1,
            0x01 | 0xd0..=0xd8 => {}
            0xc4 | 0xc8 | 0xcc => at += short(bytes, at)? as usize,
            0xc0..=0xcf => return short(bytes, at + 5).zip(short(bytes, at + 3)),
            // The picture itself or its end: the header should have come.
            0xd9 | 0xda => return None,
            _ => at += short(bytes, at)? as usize,
        }
    }
}

/// Rows from the top have a negative height.
fn bmp(bytes: &[u8]) -> Option<(u32, u32)> {
    let number = |at: usize| Some(i32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?).unsigned_abs());
    number(18).zip(number(22))
}

fn big(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}

fn short(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?)))
}

fn little(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from(u16::from_le_bytes(bytes.get(at..at + 2)?.try_into().ok()?)))
}

#[cfg(test)]
mod tests {
    use super::size;

    #[test]
    fn headers_say_the_size() {
        let png = [&b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"[..], &[0, 0, 1, 0, 0, 0, 0, 128]].concat();
        assert_eq!(size(&png), Ok([256, 128]));
        let jpeg = [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 1, 0xff, 0xff, 0xc2, 0, 11, 8, 2, 0, 1, 0x40, 3];
        assert_eq!(size(&jpeg), Ok([320, 512]));
        assert_eq!(size(b"GIF89a\x0a\0\x05\0"), Ok([10, 5]));
    }

    #[test]
    fn cut_files_are_survived() {
        for end in 0..40 {
            let jpeg = [[0xff, 0xd8].as_slice(), &[0xff, 0xe0, 0, 9].repeat(9)].concat();
            assert!(size(&jpeg[..end.min(jpeg.len())]).is_err());
        }
        assert!(size(&[0xff, 0xd8, 0xff, 0xe0, 0, 0, 0xff]).is_err());
    }
}
