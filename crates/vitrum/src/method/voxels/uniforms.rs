//! The uniform block, from the scene.

use crate::method::sweep::View;
use crate::method::sweep::environment::Prepared;
use crate::method::voxelize::Grid;
use crate::scene::{Scene, Surfaces};
use glam::{DVec3, UVec4};
use vitrum_kernels::abi::vector::Vec4;
use vitrum_kernels::abi::voxels::{VoxelsUniforms, flag, mode};

/// Voxels around the triangles in which a smoothed surface may still be.
const AROUND: f64 = 2.0;
/// The distance in voxels within which a surface is taken for the last one.
const AGAIN: f32 = 2.0;

fn vector(v: DVec3, w: f64) -> Vec4 {
    v.extend(w).as_vec4().into()
}

/// The block of a frame; dispatches differ in nothing.
pub(super) fn block(
    scene: &Scene,
    bounds: [[f32; 3]; 2],
    grid: Grid,
    bodies: usize,
    view: &View,
    environment: &Prepared,
) -> VoxelsUniforms {
    let edge = scene.film.supersampling;
    let eye = (view.eye - DVec3::from_array(grid.origin)) / grid.voxel_size;
    let bounds = bounds.map(|corner| DVec3::from_array(grid.to_voxels(corner)));
    let [x, y, z] = grid.dimensions;
    let [bx, by, bz] = super::bricks::count(grid.dimensions);
    let voxels = &scene.voxels;
    let bounces = if voxels.surfaces == Surfaces::Two { 2 } else { voxels.bounces };
    let mode = if voxels.surfaces == Surfaces::Two { mode::TWO_SURFACES } else { mode::MULTI_SURFACE };
    let flags = if voxels.reflection { flag::FRESNEL } else { 0 };
    let across = if view.orthographic { 1.0 / grid.voxel_size } else { 1.0 };
    let row = |axis: DVec3| vector(axis, 0.0);
    VoxelsUniforms {
        dispatch: UVec4::new(scene.film.width * edge, scene.film.height * edge, mode, flags),
        size: UVec4::new(x, y, z, bodies as u32),
        bricks: UVec4::new(bx, by, bz, bounces),
        camera: Vec4::new(
            (view.half_size[0] * across) as f32,
            (view.half_size[1] * across) as f32,
            0.0,
            if view.orthographic { 1.0 } else { 0.0 },
        ),
        right: vector(view.axes.x_axis, eye.x),
        up: vector(view.axes.y_axis, eye.y),
        away: vector(view.axes.z_axis, eye.z),
        scale: Vec4::new(grid.voxel_size as f32, f64::from(voxels.threshold).to_radians().cos() as f32, AGAIN, 0.0),
        low: vector(bounds[0] - AROUND, 0.0),
        high: vector(bounds[1] + AROUND, 0.0),
        environment: environment.shape,
        environment_x: row(environment.axes[0]),
        environment_y: row(environment.axes[1]),
        environment_z: row(environment.axes[2]),
        environment_color: environment.color,
        environment_horizon: environment.horizon,
        environment_nadir: environment.nadir,
    }
}
