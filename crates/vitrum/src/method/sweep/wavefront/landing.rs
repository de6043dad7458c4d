//! The passes that make the maps of the light on receivers, and the light on a plane as an output.

use super::bricks::Layer;
use super::passes::WavefrontBuffers;
use super::point::Source;
use super::{Frame, Wavefront};
use crate::backend::Pass;
use std::ops::Range;
use vitrum_kernels::abi::sweep::{along, mode, receiver};
use vitrum_kernels::abi::vector::Size;
use vitrum_kernels::kernel::kernels;

impl Wavefront {
    /// The receivers on which light lands, with the first word of each one's map.
    pub(super) fn lands(&self) -> impl Iterator<Item = (u32, u32)> {
        let map = self.seen.map;
        let [ground, wall] = self.receivers;
        let on_ground = ground.then_some((receiver::GROUND, map.ground));
        on_ground.into_iter().chain(wall.then_some((receiver::WALL, map.wall)))
    }

    /// The words of the buffer of light that have the maps of receivers.
    pub(in crate::method::sweep) fn maps(&self) -> Range<u64> {
        u64::from(self.seen.map.ground)..u64::from(self.observed)
    }

    fn is_soft(&self) -> bool {
        self.seen.softness > 0.0
    }

    /// Appends the passes that make the map of receiver `which`, which starts at word `map`.
    pub(super) fn land(&self, which: u32, map: u32, plane: u32, buffers: &WavefrontBuffers, passes: &mut Vec<Pass>) {
        let [width, height] = self.frame.cells;
        let size = self.seen.map.size;
        let texels = [size.width, size.height];
        let none = Layer::default();
        let WavefrontBuffers { nodes, landed, light, .. } = buffers;
        if mode::bends(self.mode) || self.is_soft() {
            passes.push(self.pass(&kernels::sweep_clear_landed, texels, 0, plane, &none, &[landed]));
            let land = &kernels::sweep_land_cells;
            passes.push(self.pass(land, [width, height], which, plane, &none, &[nodes, landed]));
        }
        if self.is_soft() {
            let integrate = &kernels::sweep_integrate_landed;
            for (lines, along) in [(size.height, along::ROWS), (size.width, along::COLUMNS)] {
                passes.push(self.pass(integrate, [1, lines], along, plane, &none, &[landed]));
            }
        }
        let collect = &kernels::sweep_collect_receiver;
        let pass = self.pass(collect, texels, 0, plane, &none, &[landed, nodes, light]);
        passes.push(Pass { start: u64::from(map), ..pass });
    }

    /// The passes that make the map of the light on plane `plane`, once the nodes are there, and the bytes of the buffer of light in which the map then is.
    pub(in crate::method::sweep) fn observe(&self, plane: u32, buffers: &WavefrontBuffers) -> (Vec<Pass>, Range<u64>) {
        let mut passes = Vec::new();
        self.land(receiver::OBSERVED, self.observed, plane, buffers, &mut passes);
        let map = self.seen.map.size;
        let (start, words) = (u64::from(self.observed), u64::from(map.width * map.height * 3));
        (passes, start * 4..(start + words) * 4)
    }

    /// The irradiance of the cells' places on plane `plane` over that of unoccluded light, red, green and blue one behind the other, from a map; of a point
    /// or spot, over that at a distance of 1.
    pub(in crate::method::sweep) fn of_cells(&self, map: &[f32], plane: u32) -> Vec<f32> {
        let [width, height] = self.frame.cells;
        let Size { width: columns, height: rows } = self.seen.map.size;
        let (margin, edge) = (self.seen.map.margin as u32, self.seen.map.texels as u32);
        let share = 1.0 / (edge * edge) as f32;
        let depth = self.frame.planes.depth(plane);
        let (bare, open) = (Frame { source: self.frame.source.map(Source::bare), ..self.frame }, self.frame);
        let is_placed = self.frame.source.is_some();
        let mut found = Vec::with_capacity((3 * width * height) as usize);
        for channel in map.chunks_exact((columns * rows) as usize) {
            for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
                let texels = (0..edge).flat_map(|j| (0..edge).map(move |i| (i, j)));
                let at = |(i, j): (u32, u32)| (margin + y * edge + j) * columns + margin + x * edge + i;
                let mean = texels.map(|texel| channel[at(texel) as usize]).sum::<f32>() * share;
                let place = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                // A map has the difference from unoccluded light of a point or spot.
                let of = |frame: &Frame| frame.irradiance(place[0], place[1], depth) as f32;
                found.push(if is_placed { (mean * of(&bare) + of(&open)).max(0.0) } else { mean });
            }
        }
        found
    }
}
