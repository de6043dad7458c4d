//! Light carried forward by a wavefront, along its own direction and before the viewing rays (not in the paper): its nodes are traced from plane to
//! plane, and cells between them carry the light, wherever it goes.
//!
//! Light is looked at where there are particles, where η changes, and on receivers, and kept there alone: in bricks of samples, and in a map of each
//! receiver.

mod blur;
mod bricks;
mod frame;
mod landing;
mod passes;
mod point;

pub(super) use frame::Frame;
pub(super) use passes::WavefrontBuffers;
pub(super) use point::check as check_point;

use super::planes::Planes;
use super::uniforms::set_clips;
use super::voxels::rows;
use crate::error::Error;
use crate::method::view::receivers::Receivers;
use crate::method::view::{Bounds, View};
use crate::scene::Scene;
use crate::subject::Volumes;
use bricks::{Bricks, Looked};
use glam::DVec3;
use vitrum_io::Volume;
use vitrum_kernels::abi::camera::Camera;
use vitrum_kernels::abi::environment::Environment;
use vitrum_kernels::abi::grid::Grid;
use vitrum_kernels::abi::light::LightGrid;
use vitrum_kernels::abi::record::{carried, carried_clear, carried_straight, landed};
use vitrum_kernels::abi::sweep::{SweepUniforms, mode};
use vitrum_kernels::abi::vector::{Affine, Counts, Size};
use vitrum_kernels::abi::wavefront::{self as abi, BRICK, PLANE_ALIGNMENT, ReceiverMap, SpotCone, WIDE};

/// The most bytes of the light around a volume.
const MOST_BYTES: u64 = 192 << 20;
/// The fewest cells across and up, where there is too little memory for any light.
const FEWEST_CELLS: [u32; 2] = [3, 3];
/// By how much cells grow until their light fits.
const COARSER: f64 = 1.189_207_115;
/// Texels of a receiver's map along the edge of a cell, for crisp light.
const TEXELS: u32 = 2;
/// Texels of a receiver's map along the edge of a cell, for soft light, whose edges are wider than a cell but for contacts.
const SOFT_TEXELS: u32 = 1;
/// The margin of a receiver's map on each side, over the grid's size.
const MARGIN: u32 = 4;

/// The plan of a wavefront: everything that is the same for all its planes.
pub(super) struct Wavefront {
    pub(super) frame: Frame,
    bricks: Bricks,
    /// The first word of the map of the plane on which the light is an output.
    observed: u32,
    /// Words of the buffer of light.
    words: u32,
    /// [`mode`] of the nodes.
    mode: u32,
    /// Whether light falls on the ground, and on the wall.
    receivers: [bool; 2],
    /// The uniform block of the passes that carry light.
    block: SweepUniforms,
    /// The wavefront as viewing rays know it.
    pub(super) seen: abi::Wavefront,
}

/// All that the light of a wavefront depends on, besides the volumes and their tables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LightKey {
    block: SweepUniforms,
    planes: Planes,
    stride: u32,
    bricks: Vec<u32>,
    receivers: [bool; 2],
    mode: u32,
}

/// A part of a uniform block that stands for a grid without light: viewing rays then look at unoccluded light.
pub(super) fn unoccluded(view: &View, frame: &Frame) -> abi::Wavefront {
    abi::Wavefront { bricks: Counts::default(), ..as_seen(view, frame, 0.0) }
}

/// The wavefront's frame and grid, seen from the view frame.
fn as_seen(view: &View, frame: &Frame, first_sample: f32) -> abi::Wavefront {
    let turned = frame.view.axes.transpose() * view.axes;
    let start = frame.view.point(view.eye);
    let row = |axis: usize| Affine::from(turned.row(axis).as_vec3().extend(start[axis] as f32));
    abi::Wavefront {
        row_x: row(0),
        row_y: row(1),
        row_z: row(2),
        spherical: u32::from(frame.source.is_some()),
        source: DVec3::new(0.0, 0.0, frame.source.map_or(0.0, |source| source.depth)).as_vec3().into(),
        cone: frame.source.map_or_else(SpotCone::default, |source| source.cone),
        cells: Size { width: frame.cells[0], height: frame.cells[1] },
        corner_x: frame.corner.x as f32,
        corner_y: frame.corner.y as f32,
        cell: frame.cell as f32,
        inverse_cell: (1.0 / frame.cell) as f32,
        first_depth: frame.planes.depth(0) as f32,
        inverse_step: (1.0 / (frame.planes.distance * f64::from(frame.stride))) as f32,
        first_sample,
        wide: wide_samples(frame.cells),
        ..abi::Wavefront::default()
    }
}

impl Wavefront {
    /// The plan of a wavefront for a frame whose viewing rays have the uniform block `seen_by`, in the mode `chosen`. `looked_at` are boxes, each given by
    /// its corners in the world, in which something looks at the light.
    ///
    /// # Errors
    /// [`Error::Unrenderable`] where a clipping plane has no normal.
    pub(super) fn new(
        scene: &Scene,
        volumes: Volumes<'_>,
        (view, frame): (&View, Frame),
        (seen_by, chosen): (&SweepUniforms, u32),
        looked_at: &[[DVec3; 8]],
        largest_buffer: u64,
    ) -> Result<Self, Error> {
        let bends = mode::bends(chosen);
        let first_sample = if bends { 0.5f32 } else { 0.0 };
        let (colors, components) = match (mode::is_clear(chosen), bends) {
            (true, false) => (1, carried_straight::SIZE),
            (true, true) => (1, carried_clear::SIZE),
            (false, _) => (3, carried::SIZE),
        };
        let components = components as u32;
        let texels = if scene.first_light().disc() > 0.0 { SOFT_TEXELS } else { TEXELS };
        let mut frame = frame;
        let (looked, map) = loop {
            let looked = Looked::new(&frame, f64::from(first_sample), looked_at);
            let map = map(&frame, texels);
            let landed = u64::from(map.size.width * map.size.height) * landed::SIZE as u64 * 4;
            // The buffer of light has three maps, each half as large as the sums that are made into it.
            let bytes = (looked.words(components) + looked.entries()) * 4 + 2 * landed;
            if (bytes <= MOST_BYTES + 2 * landed && bytes.max(landed) <= largest_buffer) || frame.cells == FEWEST_CELLS
            {
                break (looked, map);
            }
            frame = frame.coarser(COARSER);
        };
        let map_words = (map.size.width * map.size.height * 3).next_multiple_of(PLANE_ALIGNMENT);
        // The entries of the bricks come first, then the maps.
        let maps = (looked.bricks(components, 0).entries as u32).next_multiple_of(PLANE_ALIGNMENT);
        let first = maps + 3 * map_words;
        let words = first + looked.words(components) as u32;
        let bricks = looked.bricks(components, first);
        let [x, y, z] = bricks.counts;
        let seen = abi::Wavefront {
            bricks: Counts { x, y, z },
            map: ReceiverMap { ground: maps, wall: maps + map_words, ..map },
            colors,
            components,
            units: units(&frame),
            softness: libm::tan(f64::from(scene.first_light().disc()).to_radians()) as f32,
            ..as_seen(view, &frame, first_sample)
        };
        let blurs = frame.has_particles && seen.softness > 0.0;
        let seen = abi::Wavefront { blur: if blurs { 1.0 } else { 0.0 }, ..seen };
        let block = block(scene, volumes, &frame, seen_by, seen)?;
        let receivers = [scene.ground.is_some(), scene.wall.is_some()];
        Ok(Self { frame, bricks, observed: maps + 2 * map_words, words, mode: chosen, receivers, block, seen })
    }
}

impl Wavefront {
    /// Bytes of the light that it keeps.
    pub(super) fn bytes(&self) -> u64 {
        u64::from(self.words) * 4
    }

    /// All that the light depends on, besides the volumes and their tables.
    pub(super) fn key(&self) -> LightKey {
        LightKey {
            block: self.block,
            planes: self.frame.planes,
            stride: self.frame.stride,
            bricks: self.bricks.words.clone(),
            receivers: self.receivers,
            mode: self.mode,
        }
    }
}

/// The uniform block of the passes that carry light: that of viewing rays, in the wavefront's frame.
fn block(
    scene: &Scene,
    volumes: Volumes<'_>,
    frame: &Frame,
    seen_by: &SweepUniforms,
    seen: abi::Wavefront,
) -> Result<SweepUniforms, Error> {
    let bounds = Bounds::from(volumes.shown);
    let turned = |of: &Grid, volume: &Volume| {
        let [row_x, row_y, row_z] = rows(volume, &frame.view);
        Grid { row_x, row_y, row_z, ..*of }
    };
    let planes = Receivers::new(scene, &frame.view, bounds);
    // Nothing of the camera, so that light stays what it is while the camera moves.
    let mut block = SweepUniforms {
        picture: Size::default(),
        sensor: Size::default(),
        refined: 0,
        camera: Camera::default(),
        environment: Environment::default(),
        light_grid: LightGrid::default(),
        ..*seen_by
    };
    block.grid = turned(&seen_by.grid, volumes.shown);
    block.ior_grid = turned(&seen_by.ior_grid, volumes.second().unwrap_or(volumes.shown));
    block.receivers.ground.plane = planes.ground.as_vec4().into();
    block.receivers.wall.plane = planes.wall.as_vec4().into();
    block.light.direction = glam::Vec3::Z.into();
    block.wavefront =
        abi::Wavefront { row_x: Affine::default(), row_y: Affine::default(), row_z: Affine::default(), ..seen };
    set_clips(&mut block, scene, &frame.view, volumes.shown)?;
    Ok(block)
}

/// The wide samples of a plane: so many in a row that their sums fill places of bricks.
fn wide_samples(cells: [u32; 2]) -> Size {
    let [width, height] = cells.map(|count| (count / WIDE + 3).next_multiple_of(BRICK));
    Size { width, height }
}

/// Units of sums of light: light of all cells at once, twice as much where it is oblique, has fewer than 2³¹ of them.
fn units(frame: &Frame) -> f32 {
    let cells = f64::from(frame.cells[0]) * f64::from(frame.cells[1]);
    (1..24)
        .map(|bits| f64::from(1u32 << bits))
        .take_while(|units| units * cells * 2.0 < f64::from(1u32 << 31))
        .last()
        .unwrap_or(1.0) as f32
}

/// The size of the maps of receivers.
fn map(frame: &Frame, texels: u32) -> ReceiverMap {
    let [width, height] = frame.cells;
    let margin = (width.max(height) * texels).div_ceil(MARGIN);
    ReceiverMap {
        size: Size { width: width * texels + 2 * margin, height: height * texels + 2 * margin },
        texels: texels as f32,
        margin: margin as f32,
        ..ReceiverMap::default()
    }
}
