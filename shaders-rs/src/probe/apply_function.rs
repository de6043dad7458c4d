//! A building block, applied to every record of a buffer.

use crate::abi::probe::ProbeUniforms;
use crate::abi::record::probe;
use crate::field::access::read;
use crate::probe::functions::apply;

/// The results of the function that the uniforms choose, for the arguments of index (x, y).
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &ProbeUniforms, _mode: u32, arguments: &[f32]) -> [f32; probe::SIZE] {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let at = (y * u.dispatch.width + x) as i32;
    let argument = |c: i32| read(arguments, c * count + at);
    let a = [argument(0), argument(1), argument(2), argument(3), argument(4), argument(5), argument(6), argument(7)];
    apply(u.function, a)
}
