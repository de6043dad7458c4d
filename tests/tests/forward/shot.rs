//! A scene whose picture is judged, and where its pixels look.

use vitrum::backend::Backend;
use vitrum::io::Volume;
use vitrum::method::View;
use vitrum::scene::Scene;
use vitrum::{Assets, Frame};
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::straight_on;
use vitrum_kernels::glam::DVec3;

use crate::{CARRIER, steepest};

/// A scene of a volume in one crisp light of the world, seen in parallel rays.
pub struct Shot {
    pub scene: Scene,
    assets: Assets,
    view: View,
}

/// A picture's pixels: red radiance, and where the viewing ray ended, in the world.
pub struct Pixels {
    pub red: Vec<f64>,
    pub ends: Vec<DVec3>,
}

impl Shot {
    /// The shot of `volume` as a picture of `edge` × `edge` pixels, changed by `settings`.
    pub fn new(volume: Volume, edge: u32, settings: &[String]) -> Result<Self, Failure> {
        let mut scene = straight_on(edge);
        let usual = [
            format!("sweep.light={CARRIER}"),
            "light.0.attachment=world".to_owned(),
            "shading.specular=0".to_owned(),
            "environment.intensity=0".to_owned(),
        ];
        for setting in usual.iter().chain(settings) {
            scene.set(setting)?;
        }
        let view = View::new(&scene, &volume);
        Ok(Self { scene, assets: Assets::from(volume), view })
    }

    /// The same picture with other settings.
    pub fn with(&self, settings: &[String]) -> Result<Self, Failure> {
        let mut scene = self.scene.clone();
        for setting in settings {
            scene.set(setting)?;
        }
        let volume = self.assets.subject.volume().expect("the shot shows a volume");
        let view = View::new(&scene, volume);
        Ok(Self { scene, assets: self.assets.clone(), view })
    }

    /// The angle between the direction in which light travels and the viewing direction, in degrees.
    pub fn angle(&self, light: DVec3) -> f64 {
        self.view.axes.z_axis.dot(light.normalize()).clamp(-1.0, 1.0).acos().to_degrees()
    }

    /// Whether the carrier takes light that travels in this direction. One that takes all light takes this one.
    pub fn takes(&self, light: DVec3) -> bool {
        self.angle(light) < steepest() + 1e-9
    }

    /// The frame.
    pub fn frame(&self, backend: &mut dyn Backend) -> Result<Frame, Failure> {
        Ok(vitrum::render(&self.scene, &self.assets, backend, &mut |_| true)?)
    }

    /// The picture.
    pub fn render(&self, backend: &mut dyn Backend) -> Result<Pixels, Failure> {
        let frame = self.frame(backend)?;
        let channel = |layer: &str, channel: &str| {
            frame.channel(layer, channel).ok_or_else(|| Failure::Setup(format!("a frame has no {layer}.{channel}")))
        };
        let (x, y, z) = (channel("position", "X")?, channel("position", "Y")?, channel("position", "Z")?);
        let end = |at: usize| {
            let [right, up, back] = [x[at], y[at], z[at]].map(f64::from);
            self.view.eye + self.view.axes * DVec3::new(right, up, -back)
        };
        let red = channel("color", "R")?.iter().map(|&red| f64::from(red)).collect();
        Ok(Pixels { red, ends: (0..x.len()).map(end).collect() })
    }

    /// The ray of a pixel, at column and row in pixels (a pixel's middle is at a half), before anything bends it: a point and its unit
    /// direction.
    pub fn ray(&self, column: f64, row: f64) -> (DVec3, DVec3) {
        let across = (column / f64::from(self.scene.film.width) * 2.0 - 1.0) * self.view.half_size[0];
        let up = (1.0 - row / f64::from(self.scene.film.height) * 2.0) * self.view.half_size[1];
        (self.view.eye + self.view.axes.x_axis * across + self.view.axes.y_axis * up, self.view.axes.z_axis)
    }

    /// The rays of all pixels, row by row.
    pub fn rays(&self) -> impl Iterator<Item = (DVec3, DVec3)> {
        let (width, height) = (self.scene.film.width, self.scene.film.height);
        let of_row = move |row| (0..width).map(move |column| (f64::from(column) + 0.5, f64::from(row) + 0.5));
        (0..height).flat_map(of_row).map(|(column, row)| self.ray(column, row))
    }

    /// The area of a pixel, across the viewing rays.
    pub fn pixel_area(&self) -> f64 {
        let [half_width, half_height] = self.view.half_size;
        4.0 * half_width * half_height / (f64::from(self.scene.film.width) * f64::from(self.scene.film.height))
    }
}

/// The direction from the middle towards an azimuth and an elevation of the world, in degrees.
pub fn from_angles(azimuth: f64, elevation: f64) -> DVec3 {
    let ((sin, cos), (height, level)) = (azimuth.to_radians().sin_cos(), elevation.to_radians().sin_cos());
    DVec3::new(-sin * level, cos * level, height)
}

/// A setting with three numbers.
pub fn vector(key: &str, v: DVec3) -> String {
    format!("{key}=[{},{},{}]", v.x as f32, v.y as f32, v.z as f32)
}

/// A box along the axes of the world.
#[derive(Debug, Clone, Copy)]
pub struct Cuboid {
    pub low: DVec3,
    pub high: DVec3,
}

impl Cuboid {
    /// The box with the half edges `half` around `middle`.
    pub fn around(middle: DVec3, half: DVec3) -> Self {
        Self { low: middle - half, high: middle + half }
    }

    /// The box with all faces moved outwards.
    pub fn grown(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    pub fn contains(&self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    /// The ray parameters at which a ray, ahead of its start, enters and leaves the box; `None` if it misses it.
    pub fn crossing(&self, from: DVec3, along: DVec3) -> Option<(f64, f64)> {
        let (mut enters, mut leaves) = (0.0f64, f64::INFINITY);
        for axis in 0..3 {
            if along[axis].abs() < 1e-12 {
                if from[axis] < self.low[axis] || from[axis] > self.high[axis] {
                    return None;
                }
                continue;
            }
            let (a, b) = ((self.low[axis] - from[axis]) / along[axis], (self.high[axis] - from[axis]) / along[axis]);
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
        (enters < leaves).then_some((enters, leaves))
    }
}
