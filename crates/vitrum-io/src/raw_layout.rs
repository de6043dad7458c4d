//! Layout of voxels without a header, as `256x256x109:u16:be:skip=512`.

use std::fmt;
use std::str::FromStr;

use crate::samples::{Endian, SampleType};

/// The layout of voxels without a header: `WxHxD:TYPE`, then perhaps `:le` or `:be` and `:skip=BYTES`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RawLayout {
    pub(crate) dimensions: [u32; 3],
    pub(crate) sample: SampleType,
    /// `None` is little-endian, and said so.
    pub(crate) endian: Option<Endian>,
    /// Bytes in front of the first voxel.
    pub(crate) skip: u64,
}

impl FromStr for RawLayout {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const EXPECTED: &str = "expected WxHxD:TYPE[:le|be][:skip=BYTES], such as 256x256x109:u8 or 64x64x32:i16:be";
        let lower = text.trim().to_ascii_lowercase();
        let mut words = lower.split(':');
        let first = words.next().unwrap_or_default();
        let dimensions = dimensions(first).ok_or_else(|| format!("`{first}` is no size; {EXPECTED}"))?;
        let second = words.next().ok_or_else(|| format!("`{text}` names no sample type; {EXPECTED}"))?;
        let sample = sample_type(second).ok_or_else(|| {
            format!("`{second}` is no sample type; expected one of u8, i8, u16, i16, u32, i32, u64, i64, f16, f32, f64")
        })?;
        let mut layout = Self { dimensions, sample, endian: None, skip: 0 };
        let (mut order_given, mut skip_given) = (false, false);
        for word in words {
            let skip = word.strip_prefix("skip=").map(str::parse::<u64>);
            match (endian(word), skip) {
                (Some(endian), _) if !order_given => (layout.endian, order_given) = (Some(endian), true),
                (None, Some(Ok(skip))) if !skip_given => (layout.skip, skip_given) = (skip, true),
                _ => return Err(format!("`{word}` is neither le, be nor skip=BYTES, or is there twice; {EXPECTED}")),
            }
        }
        Ok(layout)
    }
}

impl fmt::Display for RawLayout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.dimensions;
        write!(f, "{x}x{y}x{z}:{}", self.sample.name())?;
        match self.endian {
            Some(Endian::Little) => f.write_str(":le")?,
            Some(Endian::Big) => f.write_str(":be")?,
            None => {}
        }
        if self.skip > 0 { write!(f, ":skip={}", self.skip) } else { Ok(()) }
    }
}

/// `256x256x109`.
pub(crate) fn dimensions(word: &str) -> Option<[u32; 3]> {
    let mut sizes = word.split('x');
    let mut size = || sizes.next()?.parse().ok().filter(|&size| size > 0);
    let found = [size()?, size()?, size()?];
    sizes.next().is_none().then_some(found)
}

pub(crate) fn endian(word: &str) -> Option<Endian> {
    match word {
        "le" | "little" | "lsb" => Some(Endian::Little),
        "be" | "big" | "msb" => Some(Endian::Big),
        _ => None,
    }
}

pub(crate) fn sample_type(word: &str) -> Option<SampleType> {
    match word {
        "int8" | "i8" | "schar" => Some(SampleType::I8),
        "uint8" | "u8" | "uchar" | "byte" => Some(SampleType::U8),
        "int16" | "i16" | "short" => Some(SampleType::I16),
        "uint16" | "u16" | "ushort" => Some(SampleType::U16),
        "int32" | "i32" => Some(SampleType::I32),
        "uint32" | "u32" => Some(SampleType::U32),
        "int64" | "i64" => Some(SampleType::I64),
        "uint64" | "u64" => Some(SampleType::U64),
        "float16" | "f16" => Some(SampleType::F16),
        "float" | "float32" | "f32" => Some(SampleType::F32),
        "double" | "float64" | "f64" => Some(SampleType::F64),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layouts_are_read_and_written() {
        for (text, shown) in [
            ("256x256x109:u8", "256x256x109:uint8"),
            ("64X64X32:I16:BE", "64x64x32:int16:be"),
            ("3x2x2:float:le:skip=512", "3x2x2:float32:le:skip=512"),
            ("3x2x2:f16:be", "3x2x2:float16:be"),
            (" 3x2x2:u16:skip=7:be ", "3x2x2:uint16:be:skip=7"),
        ] {
            let layout: RawLayout = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
            assert_eq!(layout.to_string(), shown);
            assert_eq!(shown.parse(), Ok(layout));
        }
    }

    #[test]
    fn what_is_no_layout_is_told_so() {
        for (text, problem) in [
            ("", "`` is no size"),
            ("3x2:u8", "`3x2` is no size"),
            ("3x2x0:u8", "`3x2x0` is no size"),
            ("3x2x2x2:u8", "is no size"),
            ("3x2x99999999999:u8", "is no size"),
            ("3x2x2", "names no sample type"),
            ("3x2x2:u7", "`u7` is no sample type; expected one of u8"),
            ("3x2x2:u8:le:be", "`be` is neither"),
            ("3x2x2:u8:skip=-1", "`skip=-1` is neither"),
            ("3x2x2:u8:skip=1:skip=2", "there twice"),
            ("3x2x2:u8:", "`` is neither"),
        ] {
            let error = text.parse::<RawLayout>().expect_err(text);
            assert!(error.contains(problem), "{text}: {error}");
        }
    }
}
