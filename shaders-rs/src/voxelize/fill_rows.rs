//! Solid voxelization: follows rows of voxels from end to end and finds the coverage of each voxel (not in Chang et al. 2010).

use crate::abi::voxelize::{VoxelizeUniforms, mode};
use crate::field::access::read_inside;
use crate::field::sums::Sums;

/// Coverage of a voxel in 255ths, by the mean `winding` over it, in units of which a voxel has 2^`scale`, and the fill rule.
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
    let row = y * u.dispatch.width + x;
    let length = u.size.x;
    let base = (row * (length + 1)) as i32;
    if (row < u.work) & (base >= 0) & (base + (length as i32) < changes.len() as i32) {
        // SAFETY: a row has a place for each voxel and one behind them, and that one lies in the buffer.
        let change = |voxel: u32| unsafe { read_inside(changes, base, voxel) };
        let (mut total, mut any) = (0u32, 0);
        let mut voxel = 0;
        while voxel <= length {
            // Sums wrap on their way; where they end does not depend on it.
            total = total.wrapping_add(change(voxel));
            any |= change(voxel);
            voxel += 1;
        }
        if total != 0 {
            coverage.add((u.work * u.row_words) as usize, 1);
        } else if any != 0 {
            fill(row, u, rule, change, coverage);
        }
    }
}

/// Writes a row that closes.
#[inline(always)]
fn fill<S: Sums + ?Sized>(row: u32, u: &VoxelizeUniforms, rule: u32, change: impl Fn(u32) -> u32, coverage: &mut S) {
    let (mut winding, mut level) = (0u32, 0);
    let mut word = 0;
    while word < u.row_words {
        let first = word * 4;
        let whole = first + 3 < u.size.x;
        // Most voxels are as their neighbours.
        let alike = whole && (change(first) | change(first + 1) | change(first + 2) | change(first + 3)) == 0;
        let mut bytes = level * 0x0101_0101;
        if !alike {
            bytes = 0;
            let mut lane = 0;
            while lane < 4 {
                if first + lane < u.size.x {
                    winding = winding.wrapping_add(change(first + lane));
                    level = inside(winding as i32, u.voxel_units, rule);
                    bytes |= level << (8 * lane);
                }
                lane += 1;
            }
        }
        if bytes != 0 {
            coverage.add((row * u.row_words + word) as usize, bytes);
        }
        word += 1;
    }
}
