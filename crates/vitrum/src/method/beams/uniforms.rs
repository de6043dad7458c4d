//! The uniform block of a frame of beams, from the scene.

use crate::method::view::environment::EnvironmentUniforms;
use crate::method::view::receivers::Receivers;
use crate::method::voxelize::Grid;
use crate::method::voxels::UploadedMesh;
use crate::method::voxels::uniforms::{camera_in, contact, receivers_in};
use crate::method::{Bounds, View};
use crate::scene::{Estimator, Scene};
use glam::DVec3;
use vitrum_kernels::abi::beams::{BeamsUniforms, LEVELS, Lattice, Limits, Medium, Sums, estimator};
use vitrum_kernels::abi::environment::Environment;
use vitrum_kernels::abi::light::LightSource;
use vitrum_kernels::abi::vector::{Size, Vec3};
use vitrum_kernels::beams::pyramid::{pixels_below, rows_before};

/// Distance from the triangles up to which their box reaches, in voxels.
const AROUND: f64 = 0.5;
/// Units of the sums in what a beam one pixel wide adds to a pixel at the depth of the bodies: wide beams and dim ones have enough, and contributions
/// up to 2²⁶ times as large fit (see [`vitrum_kernels::field::sums::words`]).
const UNITS: f64 = 16_777_216.0;

/// Step of a march along viewing rays over the radius of the sphere around the bodies, where the scene does not say: the paper's, whose bodies are about as
/// large as their unit.
const STEP: f64 = 0.2;

/// Share of a viewing ray's radiance below which a part of it is not followed: less than the eye sees.
const VIEW_THRESHOLD: f32 = 0.005;

fn vector(v: DVec3) -> Vec3 {
    v.as_vec3().into()
}

/// The surroundings of the bodies.
pub(super) struct Surroundings {
    pub(super) environment: EnvironmentUniforms,
    pub(super) receivers: Receivers,
    pub(super) light: LightSource,
    pub(super) lattice: Lattice,
    pub(super) medium: Medium,
}

/// The width of a pixel at the distance of the bodies, in voxels.
fn pixel(block: &BeamsUniforms, view: &View, bounds: Bounds, grid: Grid) -> f64 {
    let (centre, radius) = bounds.sphere();
    let distance = if view.orthographic { 1.0 } else { (centre - view.eye).length().max(radius) / grid.voxel_size };
    distance * (2.0 * f64::from(block.camera.half_height) / f64::from(block.picture.height))
}

/// The flux of a texel in the light's brightest channel: irradiance over π at a distance of a voxel, or of a distant light, times the area of a texel there.
pub(super) fn flux_of_texel(block: &BeamsUniforms) -> f64 {
    let (lattice, color) = (&block.lattice, block.light.color);
    let texel = f64::from(lattice.step_across) * f64::from(lattice.step_upwards);
    f64::from(color.x.max(color.y).max(color.z)) * texel
}

/// Units of fixed-point sums in 1, of which a `usual` contribution has `units`; 1 where there is no light.
pub(super) fn units_in_one(units: f64, usual: f64) -> f32 {
    if usual > 0.0 { (units / usual).min(1e30) as f32 } else { 1.0 }
}

/// Units of the sums in a radiance of 1.
fn scale(block: &BeamsUniforms, view: &View, bounds: Bounds, grid: Grid) -> f32 {
    let scattering = block.medium.scattering;
    let most = scattering.x.max(scattering.y).max(scattering.z);
    // π E A σ_s / (4 π f)
    let usual = 0.25 * flux_of_texel(block) * f64::from(most) / pixel(block, view, bounds, grid);
    units_in_one(UNITS, usual)
}

/// The places of the levels of a picture's pyramid among their sums and their depths.
fn sums(picture: Size, levels: u32) -> Sums {
    let [pixels_1, pixels_2, pixels_3, pixels_4] = [1, 2, 3, 4].map(|level| pixels_below(picture, level));
    let [rows_2, rows_3, rows_4, rows] = [2, 3, 4, levels + 1].map(|level| rows_before(picture, level));
    Sums { scale: 1.0, levels, pixels_1, pixels_2, pixels_3, pixels_4, rows_2, rows_3, rows_4, rows }
}

/// The block of a frame; passes differ in their dispatch and their round.
pub(super) fn block(
    scene: &Scene,
    uploaded: &UploadedMesh,
    view: &View,
    bounds: Bounds,
    surroundings: &Surroundings,
    flags: u32,
) -> BeamsUniforms {
    let grid = uploaded.grid;
    let environment = &surroundings.environment;
    let edge = scene.film.supersampling;
    let [low, high] = uploaded.bounds.map(|corner| DVec3::from_array(grid.to_voxels(corner)));
    let [row_x, row_y, row_z] = environment.axes.map(vector);
    let beams = &scene.beams;
    let mut block = BeamsUniforms {
        picture: Size { width: scene.film.width * edge, height: scene.film.height * edge },
        camera: camera_in(grid, view),
        right: vector(view.axes.x_axis),
        up: vector(view.axes.y_axis),
        away: vector(view.axes.z_axis),
        eye: vector(grid.at(view.eye)),
        voxel: grid.voxel_size as f32,
        low: vector(low - AROUND),
        high: vector(high + AROUND),
        light: surroundings.light,
        lattice: surroundings.lattice,
        limits: Limits {
            same_distance: contact(uploaded.bounds, grid) as f32,
            threshold: beams.threshold,
            view_threshold: VIEW_THRESHOLD.max(beams.threshold),
            bounces: beams.bounces,
            estimator: match beams.estimator {
                Estimator::Beams => estimator::BEAMS,
                Estimator::Lines => estimator::LINES,
                Estimator::Hu2010 => estimator::MARCH,
            },
            ..Limits::default()
        },
        medium: surroundings.medium,
        receivers: receivers_in(grid, &surroundings.receivers, scene, view),
        environment: Environment { row_x, row_y, row_z, ..environment.block },
        ambient: environment.ambient,
        flags,
        ..BeamsUniforms::default()
    };
    let step = beams.step.map_or(STEP * bounds.sphere().1, f64::from) / grid.voxel_size;
    block.limits.step = step as f32;
    block.limits.filter_radius = (step * f64::from(beams.filter_radius)) as f32;
    block.limits.line_weight = (1.0 / pixel(&block, view, bounds, grid)) as f32;
    block.sums = sums(block.picture, if beams.pyramid { LEVELS } else { 0 });
    block.sums.scale = scale(&block, view, bounds, grid);
    block
}
