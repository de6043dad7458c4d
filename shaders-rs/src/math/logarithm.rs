//! The binary logarithm.

/// log₂ x; absolute error below 4e-7 + 1e-7 |log₂ x| for positive normal x. Below the smallest normal number: −126.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    let x = super::max(x, f32::MIN_POSITIVE);
    // x = m 2^e with m in [√½, √2): log₂ x = e + log₂ m, and atanh converges fast there.
    let bits = x.to_bits();
    let above = ((bits & 0x007f_ffff) > 0x0035_04f3) as u32;
    let exponent = (bits >> 23) as i32 - 127 + above as i32;
    let m = f32::from_bits((bits & 0x007f_ffff) | ((127 - above) << 23));
    let t = (m - 1.0) / (m + 1.0);
    let t2 = t * t;
    let p = 0.222_222_22 + t2 * 0.181_818_18;
    let p = 0.285_714_3 + t2 * p;
    let p = 0.4 + t2 * p;
    let p = 0.666_666_7 + t2 * p;
    exponent as f32 + (2.0 * t + t * t2 * p) * core::f32::consts::LOG2_E
}
