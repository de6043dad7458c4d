//! Between floats and integers.

use super::clamp;

/// ⌊x⌋ for x limited to `low`…`high` (both within ±2³⁰); `low` if `x` is NaN.
#[inline(always)]
pub fn floor_to_int(x: f32, low: f32, high: f32) -> i32 {
    let limited = clamp(x, low, high);
    let truncated = truncate(limited);
    truncated - (limited < truncated as f32) as i32
}

/// `index` limited to 0…`count` − 1; `count` must be positive.
#[inline(always)]
pub fn limit(index: i32, count: i32) -> i32 {
    let index = if index < 0 { 0 } else { index };
    if index >= count { count - 1 } else { index }
}

/// Rounds towards zero; |x| must be below 2³¹ and not NaN, which [`floor_to_int`]'s clamp guarantees.
#[inline(always)]
fn truncate(x: f32) -> i32 {
    #[cfg(target_arch = "spirv")]
    {
        x as i32
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        // SAFETY: the only caller limits `x` to ±2³⁰, and its clamp turns NaN into a number. A plain `as` costs two
        // compares and selects a lane and halves the speed of a trilinear look-up.
        unsafe { x.to_int_unchecked() }
    }
}

/// The lower half of `word` as an IEEE half float, times 2^−`exponent`; for 0 and positive normal halves.
#[inline(always)]
pub fn half_to_f32(word: u32, exponent: u32) -> f32 {
    // The half's exponent bias is 15, the float's 127: moving the bits by 13 leaves a float 2^112 too small.
    f32::from_bits((word & 0x7fff) << 13) * f32::from_bits((127 + 112 - exponent) << 23)
}
