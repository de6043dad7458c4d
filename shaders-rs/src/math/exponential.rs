//! The exponential function.

use super::{clamp, floor_to_int};

/// e^x; relative error below 1.5e-7 (2 ULP) for −87 ≤ x ≤ 88, constant beyond. `exp(0)` is exactly 1.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    let x = clamp(x, -87.0, 88.0);
    let n = floor_to_int(x * core::f32::consts::LOG2_E + 0.5, -127.0, 128.0);
    // ln 2 in two parts (Cody & Waite): the first has few enough bits that n · part is exact.
    let r = (x - n as f32 * 0.693_359_4) - n as f32 * -2.121_944_4e-4;
    let p = 1.388_889e-3 + r * 1.984_127e-4;
    let p = 8.333_334e-3 + r * p;
    let p = 4.166_666_8e-2 + r * p;
    let p = 1.666_666_7e-1 + r * p;
    let p = 0.5 + r * p;
    let p = 1.0 + r * p;
    (1.0 + r * p) * f32::from_bits(((n + 127) as u32) << 23)
}
