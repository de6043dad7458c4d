//! The uniform block of rays through a mesh, from the scene.

use super::shadow::Lookup;
use super::uploaded::UploadedMesh;
use crate::method::view::View;
use crate::method::view::environment::EnvironmentUniforms;
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
use vitrum_kernels::abi::wavefront::Wavefront;

/// Distance from the triangles within which a smoothed surface may be, in voxels.
const AROUND: f64 = 2.0;
/// Distance below which a surface of voxels is taken for the last one, in voxels.
const AGAIN: f32 = 2.0;
/// Distance up to which surfaces of triangles are in contact, over the longest edge of the mesh: above what rounding and two meshes that were
/// written with seven digits are off by, below what is a gap or a body of its own (a hundred-thousandth).
const CONTACT: f64 = 3e-6;

/// The distance up to which surfaces of triangles are in contact, in voxels, where a mesh with these corners is in a grid.
pub(in crate::method) fn contact(bounds: [[f32; 3]; 2], grid: Grid) -> f64 {
    let [low, high] = bounds;
    let longest = (0..3).map(|axis| f64::from(high[axis]) - f64::from(low[axis])).fold(0.0, f64::max);
    CONTACT * longest / grid.voxel_size
}

fn vector(v: DVec3) -> Vec3 {
    v.as_vec3().into()
}

/// The surroundings of the mesh.
pub(super) struct Surroundings {
    pub environment: EnvironmentUniforms,
    pub receivers: Receivers,
    pub light: LightSource,
    pub shadow: Lookup,
    /// The wavefront that has carried light to the receivers, if one has.
    pub caustics: Option<Wavefront>,
}

/// A plane of the view frame in the frame of the grid, distances in voxels.
fn plane(plane: DVec4, view: &View, grid: Grid) -> Affine {
    let normal = view.axes * plane.truncate();
    let origin = DVec3::from_array(grid.origin) - view.eye;
    normal.extend((normal.dot(origin) + plane.w) / grid.voxel_size).as_vec4().into()
}

/// The camera of a view, lengths in voxels of a grid.
pub(in crate::method) fn camera_in(grid: Grid, view: &View) -> Camera {
    let across = if view.orthographic { 1.0 / grid.voxel_size } else { 1.0 };
    Camera {
        half_width: (view.half_size[0] * across) as f32,
        half_height: (view.half_size[1] * across) as f32,
        start: 0.0,
        orthographic: u32::from(view.orthographic),
    }
}

/// The receivers of a scene in the frame of a grid.
pub(in crate::method) fn receivers_in(
    grid: Grid,
    of_view: &Receivers,
    scene: &Scene,
    view: &View,
) -> receivers::Receivers {
    let receiver = |equation: DVec4, color: Option<Rgb>| Receiver {
        plane: plane(equation, view, grid),
        color: color.map_or(Vec3::ZERO, Vec3::from),
    };
    receivers::Receivers {
        ground: receiver(of_view.ground, scene.ground.as_ref().map(|ground| ground.color)),
        wall: receiver(of_view.wall, scene.wall.as_ref().map(|wall| wall.color)),
    }
}

/// The block of a frame; dispatches differ in their mode alone.
pub(super) fn block(
    scene: &Scene,
    uploaded: &UploadedMesh,
    view: &View,
    surroundings: &Surroundings,
    flags: u32,
) -> VoxelsUniforms {
    let grid = uploaded.grid;
    let environment = &surroundings.environment;
    let edge = scene.film.supersampling;
    let eye = grid.at(view.eye);
    let bounds = uploaded.bounds.map(|corner| DVec3::from_array(grid.to_voxels(corner)));
    let [x, y, z] = grid.dimensions;
    let [bx, by, bz] = super::bricks::count(grid.dimensions);
    let voxels = &scene.voxels;
    // Triangles have no mode of their own for that, where there are none that refract.
    let two = voxels.surfaces == Surfaces::Two && uploaded.voxels().is_some();
    let bounces = if two { 2 } else { voxels.bounces };
    let mode = if two { mode::TWO_SURFACES } else { mode::MULTI_SURFACE };
    let flags = if voxels.reflection { flags | flag::FRESNEL } else { flags };
    let flags = if surroundings.caustics.is_some() { flags | flag::CAUSTICS } else { flags };
    let [row_x, row_y, row_z] = environment.axes.map(vector);
    VoxelsUniforms {
        dispatch: Dispatch { width: scene.film.width * edge, height: scene.film.height * edge, mode },
        flags,
        size: Counts::new(x, y, z),
        materials: uploaded.clear as u32,
        bricks: Counts::new(bx, by, bz),
        most_bounces: bounces,
        camera: camera_in(grid, view),
        right: vector(view.axes.x_axis),
        up: vector(view.axes.y_axis),
        away: vector(view.axes.z_axis),
        eye: vector(eye),
        voxel: grid.voxel_size as f32,
        same_cosine: libm::cos(f64::from(voxels.threshold).to_radians()) as f32,
        same_distance: if uploaded.voxels().is_some() { AGAIN } else { contact(uploaded.bounds, grid) as f32 },
        low: vector(bounds[0] - AROUND),
        high: vector(bounds[1] + AROUND),
        environment: Environment { row_x, row_y, row_z, ..environment.block },
        mean_radiance: environment.mean.into(),
        receivers: receivers_in(grid, &surroundings.receivers, scene, view),
        light: surroundings.light,
        ambient: environment.ambient,
        shadow: surroundings.shadow,
        wavefront: surroundings.caustics.unwrap_or_default(),
    }
}
