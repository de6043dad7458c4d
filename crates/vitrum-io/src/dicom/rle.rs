//! DICOM's run lengths: a segment for each byte of a pixel, the most significant first.
//!
//! The format: <https://dicom.nema.org/medical/dicom/current/output/chtml/part05/chapter_G.html>.

/// The header in front of the segments: their number, and where each starts.
const HEADER: usize = 64;

/// `count` pixels of `size` bytes, little-endian; the problem where `frame` does not hold them.
pub(super) fn decode(frame: &[u8], count: usize, size: usize) -> Result<Vec<u8>, String> {
    let word = |index: usize| frame.get(4 * index..4 * index + 4).and_then(|word| word.try_into().ok());
    let number = |index: usize| word(index).map(u32::from_le_bytes).map(|number| number as usize);
    let segments = number(0).filter(|_| frame.len() >= HEADER).ok_or("its header of 64 bytes is cut off")?;
    if segments != size {
        return Err(format!("it has {segments} segments, and pixels have {size} bytes"));
    }
    let mut pixels = vec![0; count * size];
    for segment in 0..segments {
        let start = number(1 + segment).unwrap_or(usize::MAX);
        let packed = frame.get(start..).filter(|_| start >= HEADER).ok_or("a segment starts outside of it")?;
        let place = size - 1 - segment;
        let filled = unpack(packed, pixels.iter_mut().skip(place).step_by(size));
        if filled < count {
            return Err(format!("a segment has {filled} of {count} bytes"));
        }
    }
    Ok(pixels)
}

/// Unpacks bytes into places, as far as both go; how many were filled.
fn unpack<'a>(mut packed: &[u8], mut places: impl Iterator<Item = &'a mut u8>) -> usize {
    let mut filled = 0;
    while let [control, rest @ ..] = packed {
        let (bytes, repeats): (&[u8], usize) = match (control, rest) {
            // Nothing: it fills up.
            (128, _) => (&[], 1),
            (0..=127, _) => (&rest[..rest.len().min(usize::from(*control) + 1)], 1),
            (_, [_, ..]) => (&rest[..1], 257 - usize::from(*control)),
            _ => return filled,
        };
        packed = &rest[bytes.len()..];
        for &byte in bytes.iter().flat_map(|byte| std::iter::repeat_n(byte, repeats)) {
            let Some(place) = places.next() else { return filled };
            *place = byte;
            filled += 1;
        }
    }
    filled
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(segments: &[&[u8]]) -> Vec<u8> {
        let mut offset = HEADER as u32;
        let mut header = vec![segments.len() as u32];
        for segment in segments {
            header.push(offset);
            offset += segment.len() as u32;
        }
        header.resize(16, 0);
        [header.iter().flat_map(|word| word.to_le_bytes()).collect(), segments.concat()].concat()
    }

    #[test]
    fn runs_and_literals_fill_the_bytes_of_pixels() {
        // Three times 7, one literal 9; and 1, 2, 3, 4.
        let frame = frame(&[&[0xfe, 7, 0, 9], &[128, 3, 1, 2, 3, 4]]);
        assert_eq!(decode(&frame, 4, 2), Ok(vec![1, 7, 2, 7, 3, 7, 4, 9]));
    }

    #[test]
    fn what_does_not_fill_them_is_told_so() {
        assert!(decode(&[0; 8], 1, 1).unwrap_err().contains("cut off"));
        assert!(decode(&frame(&[&[0, 1]]), 1, 2).unwrap_err().contains("1 segments, and pixels have 2 bytes"));
        assert!(decode(&frame(&[&[3, 1, 2]]), 4, 1).unwrap_err().contains("2 of 4 bytes"));
        assert!(decode(&frame(&[&[0x81]]), 4, 1).unwrap_err().contains("0 of 4 bytes"));
        let mut outside = frame(&[&[0, 1]]);
        outside[4] = 255;
        assert!(decode(&outside, 1, 1).unwrap_err().contains("outside"));
    }
}
