//! The passes that blur the nodes of a soft light, as shadows inside a volume widen behind what threw them.

use super::bricks::Layer;
use super::passes::WavefrontBuffers;
use super::{Frame, Wavefront};
use crate::backend::Pass;
use vitrum_kernels::abi::sweep::{SweepUniforms, blurred as blurring};
use vitrum_kernels::kernel::kernels;
use vitrum_kernels::sweep::blur_nodes::MOST;

/// The least share that is worth a pass: such a blur widens what is a cell wide by a twentieth of a cell.
const LEAST_BLUR: f64 = 0.05;
/// The most passes that blur the nodes on one plane. Shadows of a light that needs more are less soft far behind the obstacle.
const MOST_ROUNDS: f64 = 32.0;

impl Wavefront {
    /// The share of its light that a node gives to a neighbour on the way between two planes, if it was absorbed on the first plane of all: the largest
    /// share.
    fn widest_blur(&self, [from, to]: [u32; 2]) -> f64 {
        let planes = &self.frame.planes;
        let (first, behind, ahead) = (planes.depth(0), planes.depth(from), planes.depth(to));
        let radius = f64::from(self.seen.softness) / self.frame.cell;
        0.125 * radius * radius * ((ahead - behind) * (ahead + behind - 2.0 * first))
    }

    /// Whether the nodes, which are blurred up to plane `from`, are blurred on plane `to`: on the last one, and as soon as it is worth a pass.
    pub(super) fn is_blurred(&self, from: u32, to: u32) -> bool {
        let last = to + 1 == self.frame.planes.count;
        self.seen.blur > 0.0 && to > from && (last || self.widest_blur([from, to]) >= LEAST_BLUR)
    }

    /// Appends the passes that blur the nodes on plane `plane`, which are blurred up to plane `from`.
    pub(super) fn blur(&self, [from, plane]: [u32; 2], buffers: &WavefrontBuffers, passes: &mut Vec<Pass>) {
        let Frame { cells: [width, height], planes, .. } = &self.frame;
        let rounds = (self.widest_blur([from, plane]) / f64::from(MOST)).ceil().clamp(1.0, MOST_ROUNDS);
        let WavefrontBuffers { nodes, blurred, .. } = buffers;
        let none = Layer::default();
        let size = [width + 1, height + 1];
        for round in 0..rounds as usize {
            let which = if round == 0 { blurring::NODES } else { blurring::AGAIN };
            let bound = [nodes, &blurred[(round + 1) % 2], &blurred[round % 2]];
            let edit = |block: &mut SweepUniforms| {
                block.step.behind = planes.depth(from) as f32;
                block.wavefront.blur = (1.0 / rounds) as f32;
            };
            passes.push(self.edited(&kernels::sweep_blur_nodes, size, which, plane, &none, &bound, edit));
        }
        let last = &blurred[(rounds as usize + 1) % 2];
        passes.push(self.pass(&kernels::sweep_take_blurred, size, 0, plane, &none, &[last, nodes]));
    }
}
