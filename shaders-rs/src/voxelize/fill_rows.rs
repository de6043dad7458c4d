//! Follows rows of voxels from end to end and finds how much of each voxel is inside.

use crate::abi::voxelize::{VoxelizeUniforms, mode};
use crate::field::access::read;
use crate::field::sums::Sums;

/// How much of a voxel is inside, in 255ths, where the winding's mean over it is `winding`, in units of which a voxel has
/// 2^`scale`.
#[inline(always)]
fn inside(winding: i32, scale: u32, rule: u32) -> u32 {
    let whole = 1 << scale;
    let amount = if winding < 0 { -winding } else { winding };
    let amount = if rule == mode::EVEN_ODD {
        // Up for an odd winding, down again for an even one.
        let rest = amount & (2 * whole - 1);
        if rest > whole { 2 * whole - rest } else { rest }
    } else if amount > whole {
        whole
    } else {
        amount
    };
    ((amount * 255 + (whole >> 1)) >> scale) as u32
}

/// Does row y · width + x: a byte for each voxel, four in a word. A row at whose end the winding is not 0 goes through a hole of the
/// surface, which does not say what is inside there: it is left empty and counted in the last word, behind all rows.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &VoxelizeUniforms, rule: u32, changes: &[u32], coverage: &mut S) {
    let row = y * u.dispatch.x + x;
    if row < u.dispatch.w {
        let base = (row * (u.size.x + 1)) as i32;
        let mut total = 0;
        let mut i = 0;
        while i <= u.size.x as i32 {
            // Sums wrap on their way; where they end does not depend on it.
            total = (total as u32).wrapping_add(read(changes, base + i)) as i32;
            i += 1;
        }
        if total == 0 {
            let mut winding = 0;
            let mut word = 0;
            while word < u.size.w as i32 {
                let mut bytes = 0;
                let mut lane = 0;
                while lane < 4 {
                    let voxel = word * 4 + lane;
                    if voxel < u.size.x as i32 {
                        winding = (winding as u32).wrapping_add(read(changes, base + voxel)) as i32;
                        bytes |= inside(winding, u.columns.w, rule) << (8 * lane) as u32;
                    }
                    lane += 1;
                }
                if bytes != 0 {
                    coverage.add((row * u.size.w) as usize + word as usize, bytes);
                }
                word += 1;
            }
        } else {
            coverage.add((u.dispatch.w * u.size.w) as usize, 1);
        }
    }
}
