//! The sRGB transfer function (IEC 61966-2-1), and its quantisation.

/// Display-linear light to the sRGB code value, both nominally 0 to 1.
///
/// Not clamped: beyond 1 the power law goes on, below 0 its linear start does. NaN stays NaN.
#[must_use]
pub fn linear_to_srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::powf(linear, 1.0 / 2.4) - 0.055 }
}

/// The inverse of [`linear_to_srgb`].
#[must_use]
pub fn srgb_to_linear(code: f32) -> f32 {
    if code <= 0.040_45 { code / 12.92 } else { libm::powf((code + 0.055) / 1.055, 2.4) }
}

/// The nearest 8-bit code; values out of range take the nearest end, and NaN takes 0.
pub(super) fn to_8_bits(value: f32) -> u8 {
    // `as` saturates, and turns NaN into 0.
    (value * 255.0 + 0.5) as u8
}

/// The nearest 16-bit code, as [`to_8_bits`].
pub(super) fn to_16_bits(value: f32) -> u16 {
    (value * 65535.0 + 0.5) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_8_bit_code_comes_back() {
        for code in 0..=255_u8 {
            let linear = srgb_to_linear(f32::from(code) / 255.0);
            assert_eq!(to_8_bits(linear_to_srgb(linear)), code);
        }
    }

    #[test]
    fn known_values() {
        assert!((linear_to_srgb(0.5) - 0.735_357).abs() < 1e-5);
        assert!((srgb_to_linear(0.5) - 0.214_041).abs() < 1e-5);
        assert_eq!([to_8_bits(-1.0), to_8_bits(7.0), to_8_bits(f32::NAN)], [0, 255, 0]);
    }
}
