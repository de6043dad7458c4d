//! Sheets of light on the first plane: a node at every corner between texels.

use crate::abi::record::sheet;
use crate::abi::sweep::SweepUniforms;
use crate::sweep::light::sheet::source;

/// Node (x, y mod rows) of sheet y / rows.
#[inline(always)]
pub fn invoke(_x: u32, y: u32, u: &SweepUniforms, _mode: u32, sources: &[f32]) -> [f32; sheet::SIZE] {
    let v = source(u, sources, y);
    let flux = u.sheet_share;
    [0.0, 0.0, 0.0, 0.0, v.x, v.y, v.z, flux, flux, flux, 0.0]
}
