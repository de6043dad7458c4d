//! The environment's uniforms and its mip chain (sweep §4.4).

use super::{View, from_angles};
use crate::scene::{Environment, EnvironmentKind, Rgb};
use glam::DVec3;
use vitrum_io::Picture;
use vitrum_kernels::abi::environment::{Environment as Block, MAX_LEVELS, kind};
use vitrum_kernels::abi::vector::Vec3;

/// The environment's equirectangular picture with its mip chain, as kernels read it.
pub(in crate::method) struct EnvironmentMap {
    /// Width and height of the finest level, and the number of levels.
    size: [u32; 3],
    /// RGB floats of all levels; one black texel if there is no map.
    pub(in crate::method) texels: Vec<f32>,
}

impl EnvironmentMap {
    /// The map of an environment whose picture is `picture`.
    pub(in crate::method) fn new(environment: &Environment, picture: Option<&Picture>) -> Self {
        let (texels, width, height, levels) = match (environment.kind, picture) {
            (EnvironmentKind::Map, Some(picture)) => chain(picture),
            _ => (vec![0.0; 3], 1, 1, 1),
        };
        Self { size: [width, height, levels], texels }
    }
}

/// An environment as kernels read it.
pub(in crate::method) struct Prepared {
    /// Uniforms of the environment, for rays in the view frame.
    pub(in crate::method) block: Block,
    /// The environment's axes in the world: its side, its middle, up.
    pub(in crate::method) axes: [DVec3; 3],
}

fn scaled(color: Rgb, factor: f32) -> Vec3 {
    color.map(|channel| channel * factor).into()
}

impl Prepared {
    pub(in crate::method) fn new(environment: &Environment, map: &EnvironmentMap, view: &View) -> Self {
        let pattern = match environment.kind {
            EnvironmentKind::Color => kind::COLOR,
            EnvironmentKind::Gradient => kind::GRADIENT,
            EnvironmentKind::Checkerboard => kind::CHECKERBOARD,
            EnvironmentKind::Map => kind::MAP,
        };
        let [width, height, levels] = map.size;
        let facing = from_angles(view.up, view.front, environment.rotation, 0.0);
        let side = view.up.cross(facing);
        let row = |axis: DVec3| Vec3::from(view.direction(axis).as_vec3());
        let factor = environment.intensity;
        Self {
            block: Block {
                kind: pattern,
                map_width: width,
                map_height: height,
                map_levels: levels,
                row_x: row(side),
                row_y: row(facing),
                row_z: row(view.up),
                color: scaled(environment.color, factor),
                horizon: scaled(environment.horizon, factor),
                nadir: scaled(environment.nadir, factor),
                square: environment.square.to_radians(),
                intensity: factor,
                visible: if environment.visible { 1.0 } else { 0.0 },
            },
            axes: [side, facing, view.up],
        }
    }
}

/// The picture and its levels, each the mean of the one before over 2 × 2 texels; (texels, width, height, levels).
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
