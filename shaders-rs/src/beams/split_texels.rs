//! Pencils of light of the finer lattice: those of texels whose parent is curved begin ([`super::find_curved`]), those of all others have ended.
//!
//! Along the outline of the bodies the middles of some texels miss them though a part of the texel does not, and the middles of others do not though a
//! part does: over many texels this adds up to nothing. Split texels know better. So that it still does, the texels that miss the bodies are split
//! where they touch a curved one.

use super::store_beam::has_flux;
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::pencil::{self, stage};
use crate::abi::vector::Size;
use crate::field::access::read;

/// Whether a texel of a lattice is curved; none is beyond its edges.
#[inline(always)]
fn is_curved(curved: &[f32], lattice: Size, column: i32, row: i32) -> bool {
    let (width, height) = (lattice.width as i32, lattice.height as i32);
    let is_texel = (column >= 0) & (column < width) & (row >= 0) & (row < height);
    is_texel & (read(curved, if is_texel { row * width + column } else { 0 }) > 0.0)
}

/// The pencil of texel (x, y) of a lattice with twice as many texels along each edge as that of `curved` and `beams`.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, curved: &[f32], beams: &[f32]) -> [f32; pencil::SIZE] {
    let (width, height) = ((u.dispatch.width >> 1) as i32, (u.dispatch.height >> 1) as i32);
    let (column, row) = ((x >> 1) as i32, (y >> 1) as i32);
    // The parents that the texel touches, on the side on which it lies in its own.
    let (beside, above) = (column + 2 * (x & 1) as i32 - 1, row + 2 * (y & 1) as i32 - 1);
    let lattice = Size { width: u.dispatch.width >> 1, height: u.dispatch.height >> 1 };
    let touches = is_curved(curved, lattice, beside, row)
        | is_curved(curved, lattice, column, above)
        | is_curved(curved, lattice, beside, above);
    // The first round has the shadow of whatever meets a body.
    let misses = !has_flux(beams, 0, row * width + column, width * height);
    let begins = is_curved(curved, lattice, column, row) | (misses & touches);
    let mut pencil = [0.0; pencil::SIZE];
    pencil[pencil::STAGE] = if begins { stage::NEW } else { stage::DONE };
    pencil
}
