//! The uniform block, from the scene.

use super::shadow::Lookup;
use super::uploaded::Uploaded;
use crate::method::view::View;
use crate::method::view::environment::Prepared;
use crate::method::view::receivers::Receivers;
use crate::method::voxelize::Grid;
use crate::scene::{Rgb, Scene, Surfaces};
use glam::{DVec3, DVec4};
use vitrum_kernels::abi::camera::Camera;
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::environment::Environment;
use vitrum_kernels::abi::light::LightSource;
use vitrum_kernels::abi::receivers::{self, Receiver};
use vitrum_kernels::abi::vector::{Affine, Counts, Vec3};
use vitrum_kernels::abi::voxels::{VoxelsUniforms, flag, mode};

/// Voxels around the triangles in which a smoothed surface may still be.
const AROUND: f64 = 2.0;
/// The distance in voxels within which a surface is taken for the last one.
const AGAIN: f32 = 2.0;

fn vector(v: DVec3) -> Vec3 {
    v.as_vec3().into()
}

/// What is around the mesh.
pub(super) struct Seen {
    pub environment: Prepared,
    pub receivers: Receivers,
    pub light: LightSource,
    pub shadow: Lookup,
}

/// A plane of the view frame in the grid's; distances are in voxels.
fn plane(plane: DVec4, view: &View, grid: Grid) -> Affine {
    let normal = view.axes * plane.truncate();
    let origin = DVec3::from_array(grid.origin) - view.eye;
    normal.extend((normal.dot(origin) + plane.w) / grid.voxel_size).as_vec4().into()
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
    let [row_x, row_y, row_z] = environment.axes.map(vector);
    let receiver = |equation: DVec4, color: Option<Rgb>| Receiver {
        plane: plane(equation, view, grid),
        color: color.map_or(Vec3::ZERO, Vec3::from),
    };
    VoxelsUniforms {
        dispatch: Dispatch { width: scene.film.width * edge, height: scene.film.height * edge, mode },
        flags,
        size: Counts::new(x, y, z),
        materials: uploaded.clear as u32,
        bricks: Counts::new(bx, by, bz),
        most_bounces: bounces,
        camera: Camera {
            half_width: (view.half_size[0] * across) as f32,
            half_height: (view.half_size[1] * across) as f32,
            start: 0.0,
            orthographic: u32::from(view.orthographic),
        },
        right: vector(view.axes.x_axis),
        up: vector(view.axes.y_axis),
        away: vector(view.axes.z_axis),
        eye: vector(eye),
        voxel: grid.voxel_size as f32,
        same_cosine: libm::cos(f64::from(voxels.threshold).to_radians()) as f32,
        same_distance: AGAIN,
        low: vector(bounds[0] - AROUND),
        high: vector(bounds[1] + AROUND),
        environment: Environment { row_x, row_y, row_z, ..environment.block },
        receivers: receivers::Receivers {
            ground: receiver(seen.receivers.ground, scene.ground.as_ref().map(|ground| ground.color)),
            wall: receiver(seen.receivers.wall, scene.wall.as_ref().map(|wall| wall.color)),
        },
        light: seen.light,
        ambient: scene.shading.ambient.into(),
        shadow: seen.shadow,
    }
}
