//! A finished frame.

use crate::backend::KernelTime;
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
    /// Names and meanings of the outputs.
    pub const AOVS: &'static [(&'static str, &'static str)] = &[
        ("color", "linear radiance and coverage (RGBA)"),
        ("opacity", "opacity A of particles and receivers, 0 to 1"),
        ("medium", "transmittance M of the medium, RGB, 0 to 1"),
        (
            "depth",
            "opacity-weighted mean depth from the eye along the viewing direction, world units; 0 where nothing is opaque; of a mesh that of the first surface",
        ),
        ("direction", "final unit direction of the ray in view space (looking along -z)"),
        ("position", "final position of the ray in view space, world units"),
        (
            "status",
            "0 the ray went through, 1 it became opaque or met a receiver, 2 it turned back or grazed; through a mesh: 1 it left, 2 it was still inside, 3 it met an opaque body or a receiver",
        ),
        ("normal", "of a mesh: unit normal at the first surface in view space, 0 where there is none"),
        ("bounces", "of a mesh: surfaces at which the ray was refracted or reflected"),
        ("path_length", "of a mesh: length of the ray's way inside, world units"),
        ("transmittance", "of a mesh: what absorption and reflection leave of the light, RGB, 0 to 1"),
        ("reflectance", "of a mesh: share of the light that the first surface reflects, 0 to 1"),
        ("light", "light on the last plane, in the light grid's own texels, RGB"),
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

    /// One channel of an output, e.g. `color` and `R`.
    pub fn channel(&self, layer: &str, channel: &str) -> Option<&[f32]> {
        let layer = self.layers.iter().find(|found| found.name == layer)?;
        layer.channels.iter().find(|found| found.name == channel).map(|found| found.data.as_slice())
    }
}

/// A layer from planar records: `channels` are names and component numbers; `edge` × `edge` rays make a pixel.
pub(crate) fn layer(name: &str, records: &[f32], size: [u32; 2], edge: u32, channels: &[(&str, usize)]) -> Layer {
    Layer {
        name: name.to_owned(),
        channels: channels
            .iter()
            .map(|&(channel, component)| Channel {
                name: channel.to_owned(),
                data: average(records, size, edge, component),
            })
            .collect(),
    }
}

/// One component, averaged over `edge` × `edge` rays a pixel.
fn average(records: &[f32], size: [u32; 2], edge: u32, component: usize) -> Vec<f32> {
    let [width, height] = size.map(|n| n as usize);
    let edge = edge as usize;
    let across = width * edge;
    let plane = &records[component * across * height * edge..][..across * height * edge];
    if edge == 1 {
        return plane.to_vec();
    }
    let share = 1.0 / (edge * edge) as f32;
    (0..width * height)
        .map(|pixel| {
            let (x, y) = (pixel % width * edge, pixel / width * edge);
            let sum: f32 = (0..edge).flat_map(|dy| &plane[(y + dy) * across + x..][..edge]).sum();
            sum * share
        })
        .collect()
}
