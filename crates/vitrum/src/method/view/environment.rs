//! The environment's uniforms and its mip chain (sweep §4.4).

use super::{View, from_angles};
use crate::scene::{Environment, EnvironmentKind, Rgb};
use glam::{DVec3, UVec4};
use vitrum_io::Picture;
use vitrum_kernels::abi::environment::{MAX_LEVELS, kind};
use vitrum_kernels::abi::vector::Vec4;

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
    /// Pattern, width, height, levels.
    pub(in crate::method) shape: UVec4,
    /// The environment's axes in the world: its side, its middle, up.
    pub(in crate::method) axes: [DVec3; 3],
    /// Rows of the rotation from the sweep frame to the environment's frame.
    pub(in crate::method) rows: [Vec4; 3],
    pub(in crate::method) color: Vec4,
    pub(in crate::method) horizon: Vec4,
    pub(in crate::method) nadir: Vec4,
}

fn scaled(color: Rgb, factor: f32, w: f32) -> Vec4 {
    Vec4::new(color[0] * factor, color[1] * factor, color[2] * factor, w)
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
        let row = |axis: DVec3| Vec4::from(view.direction(axis).as_vec3().extend(0.0));
        let factor = environment.intensity;
        Self {
            shape: UVec4::new(pattern, width, height, levels),
            axes: [side, facing, view.up],
            rows: [row(side), row(facing), row(view.up)],
            color: scaled(environment.color, factor, environment.square.to_radians()),
            horizon: scaled(environment.horizon, factor, factor),
            nadir: scaled(environment.nadir, factor, if environment.visible { 1.0 } else { 0.0 }),
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
