//! Light that cells of the medium scatter to one another ([`super::cells`]), or from everywhere to one of them and from there to the eye.
//!
//! A cell gets σ_s Φ p(ω) ∫ e^(−τ) / r² dV of each cell, where Φ is the fluence there; the integral, averaged over the cell that gets the light, is in a table by
//! the distance of the two cells along the axes. Where light is exchanged once more, what has been scattered so far is scattered again.

use super::bend::mean;
use super::cells::{COUNT, cell_of, directed, henyey_greenstein, middle};
use super::medium::phase;
use crate::abi::beams::{BeamsUniforms, CELLS, target};
use crate::abi::record::{Cell, cell};
use crate::field::access::read;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::lanes::whole;
use crate::math::{PI, dot, exp, length, max, select, select_vector, xyz};
use spirv_std::glam::Vec3;

/// Rows of cells.
const ROWS: u32 = CELLS * CELLS;

/// Light that arrives: its fluence, RGB, and its fluence times its direction.
type Arriving = [f32; 6];

/// The cell that gets light.
struct Destination<'a> {
    u: &'a BeamsUniforms,
    direct: &'a [f32],
    scattered: &'a [f32],
    materials: &'a [f32],
    i: u32,
    j: u32,
    k: u32,
    middle: Vec3,
    density: f32,
    /// Unit vector from the cell to the eye.
    to_eye: Vec3,
}

/// The distance of two numbers.
#[inline(always)]
fn apart(a: u32, b: u32) -> i32 {
    let difference = a as i32 - b as i32;
    if difference < 0 { -difference } else { difference }
}

impl Destination<'_> {
    /// Light that a cell scatters towards a direction, over the coefficient and a phase function of 1.
    #[inline(always)]
    fn sent(&self, from: &Cell, towards: Vec3, is_self: bool) -> Vec3 {
        let g = select(is_self, 0.0, self.u.cells.mean_cosine * from.directed);
        from.fluence * (henyey_greenstein(g, dot(from.direction, towards)) * from.density)
    }

    /// The light from the cell in column `i` of row number `row`, by its way on `TARGET`.
    #[inline(always)]
    fn arriving_from<const TARGET: u32>(&self, row: u32, i: u32) -> Arriving {
        let u = self.u;
        let (j, k) = (row % CELLS, row / CELLS);
        let number = (row * CELLS + i) as i32;
        let way = self.middle - middle(u, i, j, k);
        let is_self = (i == self.i) & (j == self.j) & (k == self.k);
        let towards = way * (1.0 / max(length(way), 1e-20));
        let (direct, scattered) = (cell_of(self.direct, number), cell_of(self.scattered, number));
        let sent = self.sent(&direct, towards, is_self) + self.sent(&scattered, towards, is_self);
        let at = (apart(k, self.k) * CELLS as i32 + apart(j, self.j)) * CELLS as i32 + apart(i, self.i);
        let factor = |component: i32| read(self.materials, u.cells.first as i32 + component * COUNT as i32 + at);
        let factors = Vec3::new(factor(0), factor(1), factor(2));
        // In a medium of varying density: the table is the one of density 1.
        let denser = (0.5 * (direct.density + self.density) - 1.0) * factor(3);
        let extinction = xyz(u.medium.extinction);
        let excess = |extinction: f32| exp(-(extinction * denser));
        let dimmed = Vec3::new(excess(extinction.x), excess(extinction.y), excess(extinction.z));
        let dimmed = if u.medium.nodes == 0 { Vec3::new(1.0, 1.0, 1.0) } else { dimmed };
        let arrives = sent * factors * dimmed * xyz(u.medium.scattering) * (0.25 / PI);
        if TARGET == target::EYE {
            let to_eye = phase(&u.medium, self.materials, dot(towards, self.to_eye));
            let seen = arrives * (PI * select(is_self, 0.25 / PI, to_eye));
            [seen.x, seen.y, seen.z, 0.0, 0.0, 0.0]
        } else {
            let flow = towards * mean(arrives);
            [arrives.x, arrives.y, arrives.z, flow.x, flow.y, flow.z]
        }
    }

    /// The light from all cells: sums over the rows for each column, and then over the columns.
    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    fn arriving_from_all<const TARGET: u32>(&self) -> Arriving {
        let mut all = [0.0; 6];
        let mut i = 0;
        while i < CELLS {
            let mut sums = [0.0; 6];
            let mut row = 0;
            while row < ROWS {
                add(&mut sums, self.arriving_from::<TARGET>(row, i));
                row += 1;
            }
            add(&mut all, sums);
            i += 1;
        }
        all
    }

    /// The light from all cells: sums over the rows for each column, and then over the columns. The loop over columns is vector code.
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    fn arriving_from_all<const TARGET: u32>(&self) -> Arriving {
        let mut sums = [[0.0f32; CELLS as usize]; 6];
        for row in 0..ROWS {
            let mut of_row = [[0.0f32; CELLS as usize]; 6];
            for i in 0..whole() {
                let arrives = self.arriving_from::<TARGET>(row, i as u32);
                for (of_row, arrives) in of_row.iter_mut().zip(arrives) {
                    // SAFETY: lanes are counted to at most the number of columns.
                    unsafe { *of_row.get_unchecked_mut(i) = arrives };
                }
            }
            for (sums, of_row) in sums.iter_mut().zip(&of_row) {
                for (sum, arrives) in sums.iter_mut().zip(of_row) {
                    *sum += arrives;
                }
            }
        }
        let mut all = [0.0; 6];
        for i in 0..CELLS {
            add(&mut all, core::array::from_fn(|component| sums[component][i as usize]));
        }
        all
    }
}

#[inline(always)]
fn add(sums: &mut Arriving, values: Arriving) {
    let mut component = 0;
    while component < 6 {
        sums[component] += values[component];
        component += 1;
    }
}

/// The scattered light in the cell in column `x`; `y` counts rows and layers. Of the target [`target::EYE`]: the radiance towards the eye over the scattering
/// coefficient where the density is 1, as the fluence.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    mode: u32,
    direct: &[f32],
    scattered: &[f32],
    materials: &[f32],
) -> [f32; cell::SIZE] {
    let (j, k) = (y % CELLS, y / CELLS);
    let middle = middle(u, x, j, k);
    let own = cell_of(direct, (y * CELLS + x) as i32);
    let way = xyz(u.eye) - middle;
    let orthographic = u.camera.orthographic != 0;
    let to_eye = select_vector(orthographic, -xyz(u.away), way * (1.0 / max(length(way), 1e-20)));
    let destination = Destination { u, direct, scattered, materials, i: x, j, k, middle, density: own.density, to_eye };
    let [r, g, b, flow_x, flow_y, flow_z] = if mode == target::EYE {
        destination.arriving_from_all::<{ target::EYE }>()
    } else {
        destination.arriving_from_all::<{ target::CELLS }>()
    };
    directed(Vec3::new(r, g, b), Vec3::new(flow_x, flow_y, flow_z), own.density).store()
}
