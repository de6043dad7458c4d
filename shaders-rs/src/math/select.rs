//! Selections whose result does not depend on a backend's NaN rules.

/// `yes` if `condition`, else `no`; both are evaluated.
#[inline(always)]
pub fn select(condition: bool, yes: f32, no: f32) -> f32 {
    if condition { yes } else { no }
}

/// The larger; `b` if either is NaN.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller; `b` if either is NaN.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// `x` limited to `low`…`high`; `low` if `x` is NaN.
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}

/// |x|, the sign bit cleared.
#[inline(always)]
pub fn absolute(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7fff_ffff)
}

/// `a` at `t` = 0, `b` at `t` = 1, exact where `a` = `b`.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// Square root, 0 for negative `x`. Correctly rounded on the CPU and on lavapipe; about 3 ULP on other devices.
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::num_traits::Float as _;
        max(x, 0.0).sqrt()
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        max(x, 0.0).sqrt()
    }
}
