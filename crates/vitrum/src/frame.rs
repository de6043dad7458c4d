//! A finished frame.

use crate::backend::{Backend, KernelTime};
use crate::scene::{Method, Scene};
use serde::Serialize;
use vitrum_io::{Channel, Layer, Picture};

/// How a frame was made. What is not known is `None`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Statistics {
    /// The method, `sweep` or `voxels`.
    pub method: String,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// The processor or graphics adapter.
    pub adapter: String,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Voxels along x, y and z that a mesh was turned into.
    pub voxels: Option<[u32; 3]>,
    /// Rows of those voxels that go through holes of the mesh's surface and were left empty.
    pub open_rows: Option<u64>,
    /// Planes swept; dispatches, of rays through a mesh.
    pub planes: u32,
    /// Texels of the light grid, across and up.
    pub light_texels: [u32; 2],
    /// Rays that turned back or grazed and could not be followed; through a mesh, that were still inside after as many surfaces as
    /// they may meet.
    pub rays_turned: u64,
    /// Time of each frame, without uploads, in milliseconds.
    pub frame_ms: Vec<f64>,
    /// Time to build tables and fill buffers, in milliseconds.
    pub upload_ms: Option<f64>,
    /// What each kernel took in the last frame; empty where the device has no clock.
    pub kernels: Vec<KernelTime>,
    /// The most memory the process had, in bytes.
    pub peak_rss_bytes: Option<u64>,
    /// Bytes of graphics memory in buffers.
    pub gpu_bytes: Option<u64>,
    /// Vitrum's version.
    pub version: String,
}

impl Statistics {
    /// Those of a frame that a backend has just finished, while its buffers are still there.
    pub(crate) fn of(scene: &Scene, backend: &mut dyn Backend) -> Self {
        Self {
            method: scene.method.name().to_owned(),
            backend: backend.name().to_owned(),
            adapter: backend.adapter(),
            width: scene.film.width,
            height: scene.film.height,
            kernels: backend.take_kernel_times(),
            peak_rss_bytes: peak_rss_bytes(),
            gpu_bytes: backend.device_bytes(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            ..Self::default()
        }
    }
}

/// The most memory this process had, where the system tells (Linux).
fn peak_rss_bytes() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kibibytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes * 1024)
}

/// A finished frame: named outputs, row 0 on top, linear.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// All outputs that have the picture's size, `color` (RGBA) first.
    pub layers: Vec<Layer>,
    /// The light on the last plane, in the light grid's texels, row 0 on top, if it was wanted.
    pub light: Option<Picture>,
    /// How it was made.
    pub statistics: Statistics,
}

impl Frame {
    /// The outputs. Where a pixel has several rays (`film.supersampling`) it shows their mean: of depths that of the rays that have one, of
    /// directions and normals the unit vector; `position`, `status` and `bounces` are of the ray next to the pixel's centre.
    pub const OUTPUTS: &'static [Output] = &[
        output("color", BOTH, "linear radiance and coverage (RGBA)"),
        output("opacity", SWEEP, "opacity A of particles and receivers, 0 to 1"),
        output("medium", SWEEP, "transmittance M of the medium, RGB, 0 to 1"),
        output(
            "depth",
            BOTH,
            "opacity-weighted mean depth from the eye along the viewing direction, world units; 0 where nothing is opaque; of a mesh that of the first surface",
        ),
        vector("direction", BOTH, "final unit direction of the ray in view space (looking along -z)"),
        vector("position", SWEEP, "final position of the ray in view space, world units"),
        output(
            "status",
            BOTH,
            "0 the ray went through, 1 it became opaque or met a receiver, 2 it turned back or grazed; through a mesh: 1 it left, 2 it was still inside, 3 it met an opaque body or a receiver",
        ),
        vector("normal", VOXELS, "of a mesh: unit normal at the first surface in view space, 0 where there is none"),
        output("bounces", VOXELS, "of a mesh: surfaces at which the ray was refracted or reflected"),
        output("path_length", VOXELS, "of a mesh: length of the ray's way inside, world units"),
        output("transmittance", VOXELS, "of a mesh: what absorption and reflection leave of the light, RGB, 0 to 1"),
        output("reflectance", VOXELS, "of a mesh: share of the light that the first surface reflects, 0 to 1"),
        output("light", SWEEP, "light on the last plane, in the light grid's own texels, RGB"),
    ];

    /// An output as a picture of its own; `None` if there is no output of that name, or it was not wanted.
    pub fn aov(&self, name: &str) -> Option<Picture> {
        if name == "light" {
            return self.light.clone();
        }
        let layer = self.layers.iter().find(|layer| layer.name == name)?;
        Some(Picture { width: self.width, height: self.height, layers: vec![layer.clone()] })
    }

    /// All outputs of the picture's size in one picture.
    pub fn picture(&self) -> Picture {
        Picture { width: self.width, height: self.height, layers: self.layers.clone() }
    }

    /// Multiplies the colour by 2^`stops`.
    pub(crate) fn expose(mut self, stops: f32) -> Self {
        let color = self.layers.iter_mut().filter(|layer| layer.name == "color");
        for channel in color.flat_map(|layer| layer.channels.iter_mut().filter(|channel| channel.name != "A")) {
            channel.data.iter_mut().for_each(|value| *value *= stops.exp2());
        }
        self
    }

    /// One channel of an output, e.g. `color` and `R`.
    pub fn channel(&self, layer: &str, channel: &str) -> Option<&[f32]> {
        let layer = self.layers.iter().find(|found| found.name == layer)?;
        layer.channels.iter().find(|found| found.name == channel).map(|found| found.data.as_slice())
    }
}

/// A named output of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Output {
    /// Its name.
    pub name: &'static str,
    /// The methods whose frames have it.
    pub methods: &'static [Method],
    /// What it is, with its unit and range.
    pub description: &'static str,
    /// Whether it holds vectors, which may be negative.
    pub is_vector: bool,
}

const SWEEP: &[Method] = &[Method::Sweep];
const VOXELS: &[Method] = &[Method::Voxels];
const BOTH: &[Method] = &[Method::Sweep, Method::Voxels];

const fn output(name: &'static str, methods: &'static [Method], description: &'static str) -> Output {
    Output { name, methods, description, is_vector: false }
}

const fn vector(name: &'static str, methods: &'static [Method], description: &'static str) -> Output {
    Output { name, methods, description, is_vector: true }
}

/// The channels of a colour whose components begin at `from`.
pub(crate) fn rgb(from: usize) -> [(&'static str, usize); 3] {
    [("R", from), ("G", from + 1), ("B", from + 2)]
}

/// The channels of a colour and its coverage.
pub(crate) fn rgba(from: usize) -> [(&'static str, usize); 4] {
    [("R", from), ("G", from + 1), ("B", from + 2), ("A", from + 3)]
}

/// The channels of a vector.
pub(crate) fn xyz(from: usize) -> [(&'static str, usize); 3] {
    [("X", from), ("Y", from + 1), ("Z", from + 2)]
}

/// What a pixel of several rays shows of an output.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Pixel {
    /// The mean.
    Mean,
    /// The mean, weighted by another component; 0 where that is 0 everywhere.
    WeightedBy(usize),
    /// The mean of the rays for which it is not 0.
    Present,
    /// The unit vector of the mean's direction; 0 where the mean is.
    Direction,
    /// That of one ray, the next one to the pixel's centre: numbers between which there is nothing.
    Central,
}

/// Planar records of `edge` × `edge` rays for each pixel.
#[derive(Clone, Copy)]
pub(crate) struct Rays<'a> {
    pub records: &'a [f32],
    /// Pixels across and down.
    pub size: [u32; 2],
    pub edge: u32,
}

impl Rays<'_> {
    /// An output: `channels` are names and component numbers.
    pub fn layer<const N: usize>(&self, name: &str, pixel: Pixel, channels: [(&str, usize); N]) -> Layer {
        let mut data: [Vec<f32>; N] = std::array::from_fn(|channel| self.resolve(pixel, channels[channel].1));
        if let (Pixel::Direction, 2..) = (pixel, self.edge) {
            for at in 0..data.first().map_or(0, Vec::len) {
                let length = data.iter().map(|data| data[at] * data[at]).sum::<f32>().sqrt();
                data.iter_mut().filter(|_| length > 0.0).for_each(|data| data[at] /= length);
            }
        }
        let channels = channels.iter().zip(data).map(|(&(name, _), data)| Channel { name: name.to_owned(), data });
        Layer { name: name.to_owned(), channels: channels.collect() }
    }

    /// One component, a number a pixel.
    fn resolve(&self, pixel: Pixel, component: usize) -> Vec<f32> {
        let [width, height] = self.size.map(|n| n as usize);
        let edge = self.edge as usize;
        let across = width * edge;
        let plane = |component: usize| &self.records[component * across * height * edge..][..across * height * edge];
        let values = plane(component);
        if edge == 1 {
            return values.to_vec();
        }
        let weights = if let Pixel::WeightedBy(component) = pixel { plane(component) } else { &[] };
        let weight = |at: usize| match pixel {
            Pixel::Mean | Pixel::Direction => 1.0,
            Pixel::WeightedBy(_) => weights[at],
            Pixel::Present => f32::from(u8::from(values[at] != 0.0)),
            Pixel::Central => f32::from(u8::from((at % across % edge, at / across % edge) == (edge / 2, edge / 2))),
        };
        (0..width * height)
            .map(|pixel| {
                let (x, y) = (pixel % width * edge, pixel / width * edge);
                let rays = (0..edge).flat_map(|dy| (0..edge).map(move |dx| (y + dy) * across + x + dx));
                let (sum, whole) =
                    rays.fold((0.0, 0.0), |(sum, whole), at| (sum + values[at] * weight(at), whole + weight(at)));
                if whole > 0.0 { sum / whole } else { 0.0 }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One pixel of four rays with two components, and a second pixel of nothing.
    fn resolved(pixel: Pixel) -> [f32; 2] {
        let first = [2.0, 0.0, 4.0, 8.0];
        let weights = [1.0, 1.0, 0.0, 3.0];
        let rows = |rays: [f32; 4]| [rays[0], rays[1], 0.0, 0.0, rays[2], rays[3], 0.0, 0.0];
        let records = [rows(first), rows(weights)].concat();
        let rays = Rays { records: &records, size: [2, 1], edge: 2 };
        let layer = rays.layer("x", pixel, [("Y", 0)]);
        [layer.channels[0].data[0], layer.channels[0].data[1]]
    }

    #[test]
    fn pixels_of_several_rays_follow_their_outputs_rule() {
        assert_eq!(resolved(Pixel::Mean), [3.5, 0.0]);
        assert_eq!(resolved(Pixel::WeightedBy(1)), [26.0 / 5.0, 0.0]);
        assert_eq!(resolved(Pixel::Present), [14.0 / 3.0, 0.0]);
        assert_eq!(resolved(Pixel::Central), [8.0, 0.0]);
        assert_eq!(resolved(Pixel::Direction), [1.0, 0.0]);
    }
}
