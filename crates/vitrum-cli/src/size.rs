//! `--size WxH`.

use std::str::FromStr;

/// Pixels across and down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    pub width: u32,
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const MOST: u64 = 16384;
        let edges = text.split_once(['x', 'X', '×']);
        let parsed = edges.and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
        let (width, height): (u64, u64) = parsed.ok_or("expected WIDTHxHEIGHT in pixels, such as 1024x768")?;
        let edge = |name: &str, pixels: u64| match u32::try_from(pixels) {
            Ok(pixels) if (1..=MOST).contains(&u64::from(pixels)) => Ok(pixels),
            _ => Err(format!("the {name} is {pixels} pixels, expected 1 to {MOST}")),
        };
        Ok(Self { width: edge("width", width)?, height: edge("height", height)? })
    }
}

#[cfg(test)]
mod tests {
    use super::Size;

    #[test]
    fn sizes_are_two_edges_within_limits() {
        assert_eq!("1024x768".parse(), Ok(Size { width: 1024, height: 768 }));
        assert_eq!("16384X1".parse(), Ok(Size { width: 16384, height: 1 }));
        for wrong in ["", "512", "x", "1x", "-1x5", "1.5x2", "0x5", "5x0", "16385x1", "99999999999x1", "1x2x3"] {
            assert!(wrong.parse::<Size>().is_err(), "{wrong}");
        }
    }
}
