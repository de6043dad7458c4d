//! Sheets of light on the first plane: a node at every corner between texels.

use crate::abi::record::{SheetNode, sheet};
use crate::abi::sweep::SweepUniforms;
use crate::sweep::light::sheet::source;
use spirv_std::glam::Vec3;

/// Node (x, y mod rows) of sheet y / rows.
#[inline(always)]
pub fn invoke(_x: u32, y: u32, u: &SweepUniforms, _mode: u32, sources: &[f32]) -> [f32; sheet::SIZE] {
    let flux = u.sheet_share;
    let node = SheetNode {
        displacement_x: 0.0,
        displacement_y: 0.0,
        unrefracted_x: 0.0,
        unrefracted_y: 0.0,
        direction: source(u, sources, y),
        flux: Vec3::new(flux, flux, flux),
        turned: 0.0,
        inside: 0.0,
    };
    node.store()
}
