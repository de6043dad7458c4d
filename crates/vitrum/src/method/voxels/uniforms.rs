//! The uniform block, from the scene.

use super::shadow::Lookup;
use super::uploaded::Uploaded;
use crate::method::view::View;
use crate::method::view::environment::Prepared;
use crate::method::view::receivers::Receivers;
use crate::method::voxelize::Grid;
use crate::scene::{Rgb, Scene, Surfaces};
use glam::{DVec3, DVec4, UVec4};
use vitrum_kernels::abi::vector::Vec4;
use vitrum_kernels::abi::voxels::{VoxelsUniforms, flag, mode};

/// Voxels around the triangles in which a smoothed surface may still be.
const AROUND: f64 = 2.0;
/// The distance in voxels within which a surface is taken for the last one.
const AGAIN: f32 = 2.0;

fn vector(v: DVec3, w: f64) -> Vec4 {
    v.extend(w).as_vec4().into()
}

/// What is around the mesh.
pub(super) struct Seen {
    pub environment: Prepared,
    pub receivers: Receivers,
    /// Unit direction in which light travels, in the world.
    pub light: DVec3,
    pub shadow: Lookup,
}

/// A plane of the sweep frame in the grid's; distances are in voxels.
fn plane(plane: DVec4, view: &View, grid: Grid) -> Vec4 {
    let normal = view.axes * plane.truncate();
    let origin = DVec3::from_array(grid.origin) - view.eye;
    vector(normal, (normal.dot(origin) + plane.w) / grid.voxel_size)
}

/// The block of a frame; dispatches differ in their mode alone.
pub(super) fn block(scene: &Scene, uploaded: &Uploaded, view: &View, seen: &Seen, flags: u32) -> VoxelsUniforms {
    let grid = uploaded.grid;
    let environment = &seen.environment;
    let edge = scene.film.supersampling;
    let eye = (view.eye - DVec3::from_array(grid.origin)) / grid.voxel_size;
    let bounds = uploaded.bounds.map(|corner| DVec3::from_array(grid.to_voxels(corner)));
    let [x, y, z] = grid.dimensions;
    let [bx, by, bz] = super::bricks::count(grid.dimensions);
    let voxels = &scene.voxels;
    // Triangles have no mode of their own for that, where there are none that refract.
    let two = voxels.surfaces == Surfaces::Two && uploaded.voxels().is_some();
    let bounces = if two { 2 } else { voxels.bounces };
    let mode = if two { mode::TWO_SURFACES } else { mode::MULTI_SURFACE };
    let flags = if voxels.reflection { flags | flag::FRESNEL } else { flags };
    let across = if view.orthographic { 1.0 / grid.voxel_size } else { 1.0 };
    let row = |axis: DVec3| vector(axis, 0.0);
    let color = |[r, g, b]: Rgb, factor: f32| Vec4::new(r * factor, g * factor, b * factor, 0.0);
    let absent = [0.0; 3];
    let [shadow_x, shadow_y, shadow_z] = seen.shadow.rows;
    VoxelsUniforms {
        dispatch: UVec4::new(scene.film.width * edge, scene.film.height * edge, mode, flags),
        size: UVec4::new(x, y, z, uploaded.clear as u32),
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
        ground: plane(seen.receivers.ground, view, grid),
        ground_color: color(scene.ground.as_ref().map_or(absent, |ground| ground.color), 1.0),
        wall: plane(seen.receivers.wall, view, grid),
        wall_color: color(scene.wall.as_ref().map_or(absent, |wall| wall.color), 1.0),
        light: row(seen.light),
        light_color: color(scene.first_light().color, scene.first_light().intensity),
        ambient: color(scene.shading.ambient, 1.0),
        shadow: seen.shadow.size,
        shadow_x,
        shadow_y,
        shadow_z,
        shadow_filter: seen.shadow.filter,
    }
}
