//! What the volume does along a segment: where it lies, how it bends.

use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::abi::sweep::mode;
use crate::field::stencil::{Stencil, central_differences, scalar, stencil, to_view_frame};
use crate::field::tables::{ior, ior_and_slope};
use crate::math::{absolute, clamp, max, min, select};
use crate::optics::span::Span;
use spirv_std::glam::Vec3;

/// The medium at a point.
#[derive(Clone, Copy)]
pub struct Medium {
    /// Normalised scalar.
    pub scalar: f32,
    /// ∇f of the volume that bends, in the view frame. Zero where rays are straight.
    pub scalar_gradient: Vec3,
    /// ∇f of the volume that is shown, in the view frame. Zero where rays are straight, but in mode [`mode::SHADED_BY_GRADIENT`].
    pub shown_gradient: Vec3,
    /// η.
    pub ior: f32,
    /// ½∇(η²) in the view frame.
    pub acceleration: Vec3,
    /// ∇η in the view frame.
    pub ior_gradient: Vec3,
}

/// The share of the segment between voxel coordinates `from` and `to` that lies inside the grid.
#[inline(always)]
pub fn share_inside(grid: &Grid, from: Vec3, to: Vec3) -> f32 {
    span_inside(grid, from, to).length()
}

/// The part of the segment between voxel coordinates `from` and `to` that lies inside the grid.
#[inline(always)]
pub fn span_inside(grid: &Grid, from: Vec3, to: Vec3) -> Span {
    let (ax, bx) = slab(from.x, to.x, grid.low.x, grid.high.x);
    let (ay, by) = slab(from.y, to.y, grid.low.y, grid.high.y);
    let (az, bz) = slab(from.z, to.z, grid.low.z, grid.high.z);
    Span { start: max(max(ax, ay), az), end: min(min(bx, by), bz) }
}

/// Whether voxel coordinates `from` and `to` are half a voxel or more inside the grid's border: [`share_inside`] is then exactly 1.
#[inline(always)]
pub fn is_well_inside(grid: &Grid, from: Vec3, to: Vec3) -> bool {
    is_between_voxels(grid, from) & is_between_voxels(grid, to)
}

/// Whether `at` is half a voxel or more inside the grid's box.
#[inline(always)]
fn is_between_voxels(grid: &Grid, at: Vec3) -> bool {
    (at.x >= grid.low.x + 0.5)
        & (at.x <= grid.high.x - 0.5)
        & (at.y >= grid.low.y + 0.5)
        & (at.y <= grid.high.y - 0.5)
        & (at.z >= grid.low.z + 0.5)
        & (at.z <= grid.high.z - 0.5)
}

/// Where a segment enters and leaves `low` … `high` along one axis, 0 to 1.
#[inline(always)]
fn slab(from: f32, to: f32, low: f32, high: f32) -> (f32, f32) {
    let along = to - from;
    let tiny = absolute(along) < 1e-12;
    let inverse = 1.0 / select(tiny, 1.0, along);
    let (p, q) = ((low - from) * inverse, (high - from) * inverse);
    let within = (from >= low) & (from <= high);
    (select(tiny, select(within, 0.0, 2.0), clamp(min(p, q), 0.0, 1.0)), select(tiny, 1.0, clamp(max(p, q), 0.0, 1.0)))
}

/// 1 inside the grid, 0 outside.
#[inline(always)]
fn inside(grid: &Grid, at: Vec3) -> f32 {
    let within = (at.x >= grid.low.x)
        & (at.x <= grid.high.x)
        & (at.y >= grid.low.y)
        & (at.y <= grid.high.y)
        & (at.z >= grid.low.z)
        & (at.z <= grid.high.z);
    select(within, 1.0, 0.0)
}

/// η and its gradients from the scalars around a point; ∇ in voxel coordinates.
#[inline(always)]
fn refraction(tables: &[u32], s: &Stencil, chosen: u32) -> (f32, Vec3, Vec3) {
    let (eta, slope) = ior_and_slope(tables, s.centre);
    if mode::by_chain_rule(chosen) {
        let gradient = central_differences(s) * slope;
        (eta, gradient, gradient * eta)
    } else {
        let (x0, x1) = (ior(tables, s.x.0), ior(tables, s.x.1));
        let (y0, y1) = (ior(tables, s.y.0), ior(tables, s.y.1));
        let (z0, z1) = (ior(tables, s.z.0), ior(tables, s.z.1));
        let gradient = Vec3::new(0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.5 * (z1 - z0));
        // ½ the difference of η²/2: what a ray gains is then exactly the difference of potentials.
        let acceleration =
            Vec3::new(0.25 * ((x1 - x0) * (x1 + x0)), 0.25 * ((y1 - y0) * (y1 + y0)), 0.25 * ((z1 - z0) * (z1 + z0)));
        (eta, gradient, acceleration)
    }
}

/// The medium at voxel coordinates `at` of the grid (`at_ior` of the second one). Outside the grid nothing bends.
#[inline(always)]
pub fn medium<V: VoxelFormat>(
    grids: (&Grid, &Grid),
    chosen: u32,
    voxels: &[u32],
    ior_voxels: &[u32],
    tables: &[u32],
    at: Vec3,
    at_ior: Vec3,
) -> Medium {
    let (grid, ior_grid) = grids;
    if !mode::bends(chosen) {
        let zero = Vec3::new(0.0, 0.0, 0.0);
        let (scalar, shown_gradient) = if chosen == mode::SHADED_BY_GRADIENT {
            let shown = stencil::<V>(voxels, grid, at);
            (shown.centre, to_view_frame(grid, central_differences(&shown)))
        } else {
            (scalar::<V>(voxels, grid, at), zero)
        };
        Medium { scalar, scalar_gradient: zero, shown_gradient, ior: 1.0, acceleration: zero, ior_gradient: zero }
    } else if V::SECOND {
        let shown = stencil::<V>(voxels, grid, at);
        let bending = stencil::<V>(ior_voxels, ior_grid, at_ior);
        let (eta, gradient, acceleration) = refraction(tables, &bending, chosen);
        let within = inside(ior_grid, at_ior);
        Medium {
            scalar: shown.centre,
            scalar_gradient: to_view_frame(ior_grid, central_differences(&bending)) * within,
            shown_gradient: to_view_frame(grid, central_differences(&shown)),
            ior: eta,
            acceleration: to_view_frame(ior_grid, acceleration) * within,
            ior_gradient: to_view_frame(ior_grid, gradient) * within,
        }
    } else {
        let shown = stencil::<V>(voxels, grid, at);
        let (eta, gradient, acceleration) = refraction(tables, &shown, chosen);
        let within = inside(grid, at);
        let shown_gradient = to_view_frame(grid, central_differences(&shown));
        Medium {
            scalar: shown.centre,
            scalar_gradient: shown_gradient * within,
            shown_gradient,
            ior: eta,
            acceleration: to_view_frame(grid, acceleration) * within,
            ior_gradient: to_view_frame(grid, gradient) * within,
        }
    }
}
