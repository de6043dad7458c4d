//! The environment's uniforms and its mip chain (sweep §4.4).

use super::ambient::{Irradiance, ambient};
use super::{View, from_angles};
use crate::scene::{Environment, EnvironmentKind, Rgb, Scene};
use glam::DVec3;
use vitrum_io::Picture;
use vitrum_kernels::abi::ambient::Ambient;
use vitrum_kernels::abi::environment::{Environment as Block, MAX_LEVELS, kind};
use vitrum_kernels::abi::vector::Vec3;

/// The environment's equirectangular picture with its mip chain, as kernels read it.
pub(in crate::method) struct EnvironmentMap {
    /// Width and height of the finest level, and the number of levels.
    size: [u32; 3],
    /// Mean radiance of the map over all directions, linear RGB; 0 if there is no map.
    mean: Rgb,
    /// Ambient light of the map; `None` if there is no map.
    pub(in crate::method) irradiance: Option<Irradiance>,
    /// RGB floats of all levels; one black texel if there is no map.
    pub(in crate::method) texels: Vec<f32>,
}

impl EnvironmentMap {
    /// The map of an environment with the picture `picture`.
    pub(in crate::method) fn new(environment: &Environment, picture: Option<&Picture>) -> Self {
        let (mean, (texels, width, height, levels)) = match (environment.kind, picture) {
            (EnvironmentKind::Map, Some(picture)) => (mean(picture), chain(picture)),
            _ => (Rgb::default(), (vec![0.0; 3], 1, 1, 1)),
        };
        let is_map = environment.kind == EnvironmentKind::Map;
        let irradiance = picture.filter(|_| is_map).map(Irradiance::of_map);
        Self { size: [width, height, levels], mean, irradiance, texels }
    }
}

/// The uniforms of an environment, and its axes.
pub(in crate::method) struct EnvironmentUniforms {
    /// Uniforms of the environment, for rays in the view frame.
    pub(in crate::method) block: Block,
    /// The environment's axes in the world: its side, its middle, up.
    pub(in crate::method) axes: [DVec3; 3],
    /// Mean radiance over all directions, linear RGB.
    pub(in crate::method) mean: Rgb,
    /// Ambient light.
    pub(in crate::method) ambient: Ambient,
}

/// The axes of an environment in the world, where the camera has `up` and azimuth 0 looks from `front`: its side, its middle, up.
pub(in crate::method) fn axes(environment: &Environment, up: DVec3, front: DVec3) -> [DVec3; 3] {
    let facing = from_angles(up, front, environment.rotation, 0.0);
    [up.cross(facing), facing, up]
}

/// The uniforms of an environment that say how bright it is, for rays in its own frame and an intensity of 1; without a map.
pub(in crate::method) fn pattern(environment: &Environment) -> Block {
    let kind = match environment.kind {
        EnvironmentKind::Color => kind::COLOR,
        EnvironmentKind::Gradient => kind::GRADIENT,
        EnvironmentKind::Checkerboard => kind::CHECKERBOARD,
        EnvironmentKind::Map => kind::MAP,
    };
    Block {
        kind,
        color: environment.color.into(),
        horizon: environment.horizon.into(),
        nadir: environment.nadir.into(),
        square: environment.square.to_radians(),
        intensity: 1.0,
        ..Block::default()
    }
}

fn scaled(color: Rgb, factor: f32) -> Vec3 {
    color.map(|channel| channel * factor).into()
}

impl EnvironmentUniforms {
    /// Those of a scene's environment, and its ambient light.
    pub(in crate::method) fn new(scene: &Scene, map: &EnvironmentMap, view: &View) -> Self {
        let environment = &scene.environment;
        let [width, height, levels] = map.size;
        let axes = axes(environment, view.up, view.front);
        let row = |axis: DVec3| Vec3::from(view.direction(axis).as_vec3());
        let factor = environment.intensity;
        Self {
            block: Block {
                map_width: width,
                map_height: height,
                map_levels: levels,
                row_x: row(axes[0]),
                row_y: row(axes[1]),
                row_z: row(axes[2]),
                color: scaled(environment.color, factor),
                horizon: scaled(environment.horizon, factor),
                nadir: scaled(environment.nadir, factor),
                intensity: factor,
                visible: if environment.visible { 1.0 } else { 0.0 },
                ..pattern(environment)
            },
            axes,
            mean: mean_radiance(environment, map),
            ambient: ambient(scene.shading.ambient, environment, map.irradiance.as_ref()),
        }
    }
}

/// The mean radiance of an environment over all directions.
fn mean_radiance(environment: &Environment, map: &EnvironmentMap) -> Rgb {
    let Environment { color, horizon, nadir, .. } = *environment;
    let channel = |i: usize| match environment.kind {
        EnvironmentKind::Color => color[i],
        // Over all directions the mean of √|z| is ⅔.
        EnvironmentKind::Gradient => (horizon[i] + color[i] + nadir[i]) / 3.0,
        // What has one colour in one direction has the other one on the other side of a meridian.
        EnvironmentKind::Checkerboard => 0.5 * (color[i] + horizon[i]),
        EnvironmentKind::Map => map.mean[i],
    };
    std::array::from_fn(|i| channel(i) * environment.intensity)
}

/// The mean of an equirectangular picture over all directions: rows by the solid angle that they cover.
fn mean(picture: &Picture) -> Rgb {
    let texels = picture.color();
    let (width, height) = (picture.width as usize, picture.height as usize);
    let height_above = |row: usize| libm::cos(std::f64::consts::PI * row as f64 / height as f64);
    let mut sum = [0.0f64; 3];
    for (row, texels) in texels.chunks_exact(width).enumerate() {
        // Archimedes: the area of a zone of the unit sphere is 2π times its height.
        let share = 0.5 * (height_above(row) - height_above(row + 1)) / width as f64;
        for (sum, channel) in sum.iter_mut().zip(0..) {
            *sum += share * texels.iter().map(|texel| f64::from(texel[channel])).sum::<f64>();
        }
    }
    sum.map(|channel| channel as f32)
}

/// The mip chain of a picture, each level the mean of the one before over 2 × 2 texels: (texels, width, height, levels).
fn chain(picture: &Picture) -> (Vec<f32>, u32, u32, u32) {
    let mut level: Vec<[f32; 3]> = picture.color();
    let (mut width, mut height) = (picture.width as usize, picture.height as usize);
    let mut all: Vec<f32> = level.iter().flatten().copied().collect();
    let mut levels = 1;
    while (width > 1 || height > 1) && levels < MAX_LEVELS {
        let (wide, high) = ((width / 2).max(1), (height / 2).max(1));
        level = (0..wide * high)
            .map(|index| {
                let (x, y) = (index % wide, index / wide);
                // With an odd edge the last texel is left out; a single row or column counts twice.
                let texel =
                    |dx: usize, dy: usize| level[(2 * y + dy).min(height - 1) * width + (2 * x + dx).min(width - 1)];
                let (a, b, c, d) = (texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1));
                std::array::from_fn(|i| 0.25 * ((a[i] + b[i]) + (c[i] + d[i])))
            })
            .collect();
        (width, height) = (wide, high);
        all.extend(level.iter().flatten());
        levels += 1;
    }
    (all, picture.width, picture.height, levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean of an environment's map whose texels are `gray`.
    fn of_map(width: u32, height: u32, gray: impl Fn(u32, u32) -> f32) -> Rgb {
        let texels = (0..width * height).map(|at| [gray(at % width, at / width); 3]);
        mean(&Picture::rgb(width, height, texels.collect()))
    }

    #[test]
    fn rows_count_by_the_solid_angle_that_they_cover() {
        let near = |found: Rgb, expected: f32| found.iter().all(|channel| (channel - expected).abs() < 1e-6);
        assert!(near(of_map(7, 5, |_, _| 0.75), 0.75));
        assert!(near(of_map(8, 6, |_, y| if y < 3 { 1.0 } else { 0.0 }), 0.5), "the upper half");
        assert!(near(of_map(8, 6, |x, _| if x < 2 { 1.0 } else { 0.0 }), 0.25), "a quarter of the longitudes");
        // A cap of 30° around the zenith.
        let cap = 0.5 * (1.0 - 0.75f32.sqrt());
        assert!(near(of_map(3, 6, |_, y| if y == 0 { 1.0 } else { 0.0 }), cap));
    }

    #[test]
    fn a_gradient_and_a_checkerboard_have_the_mean_of_their_directions() {
        let (color, horizon, nadir) = ([0.9, 0.6, 0.3], [0.5, 0.1, 0.4], [0.2, 0.0, 0.8]);
        let scene = |kind| Environment { kind, color, horizon, nadir, intensity: 2.0, ..Environment::default() };
        let gradient = scene(EnvironmentKind::Gradient);
        let checkerboard = scene(EnvironmentKind::Checkerboard);
        let none = EnvironmentMap::new(&gradient, None);
        let count = 10_000;
        for i in 0..3 {
            // Directions are uniform in z.
            let heights = (0..count).map(|n| (2.0 * f64::from(n) + 1.0) / f64::from(count) - 1.0);
            let sum: f64 = heights
                .map(|z| {
                    let end = f64::from(if z > 0.0 { color[i] } else { nadir[i] });
                    let horizon = f64::from(horizon[i]);
                    2.0 * (horizon + (end - horizon) * z.abs().sqrt())
                })
                .sum();
            let found = f64::from(mean_radiance(&gradient, &none)[i]);
            assert!((found - sum / f64::from(count)).abs() < 1e-5, "{found}");
            assert_eq!(mean_radiance(&checkerboard, &none)[i], color[i] + horizon[i]);
        }
    }
}
