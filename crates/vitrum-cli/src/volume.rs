//! The flags that say how a volume file is read.

use clap::Args;
use std::str::FromStr;
use vitrum::io::{RawLayout, Up};
use vitrum::scene::VolumeSource;

/// How the volume is read; each but the last sets the scene's key of the same name.
#[derive(Debug, Clone, Args)]
pub struct VolumeArguments {
    /// Read a file without a header: WxHxD:TYPE, then :le or :be and :skip=BYTES if need be, such as 256x256x109:u8
    #[arg(long, value_name = "LAYOUT")]
    pub raw: Option<RawLayout>,

    /// Distances of voxels along x, y and z instead of the file's, such as 0.5,0.5,1.2
    #[arg(long, value_name = "X,Y,Z")]
    pub spacing: Option<Spacing>,

    /// Array to take of a file with several, or number of a channel; else the active scalars or the first
    #[arg(long, value_name = "NAME")]
    pub array: Option<String>,

    /// Point in time to take of a file with several: its number, counted from 0, or its moment in seconds, such as 0.5s; else the first
    #[arg(long, value_name = "N|SECONDSs", allow_hyphen_values = true)]
    pub time: Option<Time>,

    /// Turn the volume so that this points up: x, -x, y, -y, z, -z or right, left, anterior, posterior, superior, inferior
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,

    /// Most memory for a volume, such as 4GiB; else what is free now
    #[arg(long, value_name = "SIZE")]
    pub max_bytes: Option<ByteCount>,
}

impl VolumeArguments {
    /// The keys that are set, in a source without a file.
    pub fn source(&self) -> VolumeSource {
        let Self { raw, spacing, array, time, up, max_bytes: _ } = self;
        VolumeSource {
            raw: raw.map(|raw| raw.to_string()),
            spacing: spacing.map(|Spacing(spacing)| spacing),
            array: array.clone(),
            time: time.and_then(Time::number),
            seconds: time.and_then(Time::seconds),
            up: up.map(|up| up.to_string()),
            ..VolumeSource::default()
        }
    }

    /// The limit in bytes.
    pub fn limit(&self) -> Option<u64> {
        self.max_bytes.map(|ByteCount(bytes)| bytes)
    }
}

/// `--time N` or `--time SECONDSs`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Time {
    Number(u32),
    Seconds(f64),
}

impl Time {
    fn number(self) -> Option<u32> {
        match self {
            Self::Number(number) => Some(number),
            Self::Seconds(_) => None,
        }
    }

    fn seconds(self) -> Option<f64> {
        match self {
            Self::Number(_) => None,
            Self::Seconds(seconds) => Some(seconds),
        }
    }
}

impl FromStr for Time {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let time = match text.strip_suffix('s') {
            Some(seconds) => seconds.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite()).map(Self::Seconds),
            None => text.parse().ok().map(Self::Number),
        };
        time.ok_or_else(|| {
            "expected a number of a point in time, such as 3, or a moment in seconds, such as 0.5s".to_owned()
        })
    }
}

/// `--spacing X,Y,Z`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spacing(pub [f32; 3]);

impl FromStr for Spacing {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parsed = text.split(',').map(|word| word.trim().parse()).collect::<Result<Vec<f32>, _>>();
        let valid = |spacing: &[f32; 3]| spacing.iter().all(|value| value.is_finite() && *value > 0.0);
        let spacing = parsed.ok().and_then(|values| values.try_into().ok()).filter(valid);
        spacing.map(Self).ok_or_else(|| "expected three numbers above 0, such as 0.5,0.5,1.2".to_owned())
    }
}

/// `--max-bytes SIZE`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ByteCount(pub u64);

impl FromStr for ByteCount {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let end = text.find(|character: char| !character.is_ascii_digit() && character != '.').unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        let unit: f64 = match unit.trim().to_ascii_lowercase().as_str() {
            "" | "b" => 1.0,
            "kib" | "k" => 1024.0,
            "mib" | "m" => (1u64 << 20) as f64,
            "gib" | "g" => (1u64 << 30) as f64,
            "tib" | "t" => (1u64 << 40) as f64,
            "kb" => 1e3,
            "mb" => 1e6,
            "gb" => 1e9,
            "tb" => 1e12,
            _ => f64::NAN,
        };
        // Every count that a machine has is exact in a float64.
        let bytes = number.parse::<f64>().ok().map(|number| number * unit);
        let bytes = bytes.filter(|bytes| (1.0..=1e18).contains(bytes));
        bytes.map(|bytes| Self(bytes as u64)).ok_or_else(|| {
            "expected a number of bytes with or without a unit, KiB, MiB, GiB, TiB, kB, MB, GB or TB, such as 4GiB"
                .to_owned()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_counts_have_units() {
        for (text, bytes) in [("17", 17), ("4GiB", 4 << 30), ("4 gib", 4 << 30), ("1.5k", 1536), ("2MB", 2_000_000)] {
            assert_eq!(text.parse(), Ok(ByteCount(bytes)), "{text}");
        }
        for wrong in ["", "GiB", "0", "-1", "4 GiB more", "1e3", "nan", "9999999TiB", "1.2.3"] {
            assert!(wrong.parse::<ByteCount>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn times_are_numbers_or_seconds() {
        assert_eq!("3".parse(), Ok(Time::Number(3)));
        assert_eq!("0.5s".parse(), Ok(Time::Seconds(0.5)));
        assert_eq!("-2 s".parse(), Ok(Time::Seconds(-2.0)));
        for wrong in ["", "s", "0.5", "-1", "nans", "infs", "1min"] {
            assert!(wrong.parse::<Time>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn spacings_are_three_numbers_above_0() {
        assert_eq!("0.5,0.5, 1.2".parse(), Ok(Spacing([0.5, 0.5, 1.2])));
        for wrong in ["", "1", "1,1", "1,1,0", "1,1,-1", "1,1,nan", "1,1,inf", "1,1,1,1", "a,b,c"] {
            assert!(wrong.parse::<Spacing>().is_err(), "{wrong}");
        }
    }
}
