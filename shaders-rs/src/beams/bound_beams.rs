//! The nodes of the tree over beams ([`super::tree`]): boxes around the beams of some texels.

use super::store_beam::{beam_of, has_flux};
use super::tree::{Node, nodes, nodes_below, top};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Bundle, bundle};
use crate::math::{absolute_vector, max, min};
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

/// A box; one that is inside out holds nothing.
#[derive(Clone, Copy)]
struct Extent {
    low: Vec3,
    high: Vec3,
}

impl Extent {
    const NOTHING: Self = Self { low: Vec3::new(FAR, FAR, FAR), high: Vec3::new(-FAR, -FAR, -FAR) };

    /// The box with a box around `middle`, half as wide as `half` tells, in it.
    #[inline(always)]
    fn with(self, middle: Vec3, half: Vec3) -> Self {
        let (low, high) = (middle - half, middle + half);
        Self {
            low: Vec3::new(min(self.low.x, low.x), min(self.low.y, low.y), min(self.low.z, low.z)),
            high: Vec3::new(max(self.high.x, high.x), max(self.high.y, high.y), max(self.high.z, high.z)),
        }
    }
}

/// Half the extent of a beam's cross-section at a distance along it, along the axes.
#[inline(always)]
fn across(beam: &Beam, distance: f32) -> Vec3 {
    let first = beam.position_u + beam.direction_u * distance;
    let second = beam.position_v + beam.direction_v * distance;
    (absolute_vector(first) + absolute_vector(second)) * 0.5
}

/// The node's record: invocations count the nodes of the tree, row by row.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, beams: &[f32]) -> [f32; bundle::SIZE] {
    let count = u.lattice.count;
    let root = top(count);
    let index = y * u.dispatch.width + x;
    let mut level = 0;
    while (level < root) & (index >= nodes_below(count, level + 1)) {
        level += 1;
    }
    let (column, row) = Node { level, number: index - nodes_below(count, level) }.place();
    let size = 1 << level;
    let (first_column, first_row) = (column * size, row * size);
    let mut volume = Extent::NOTHING;
    let mut positions = Extent::NOTHING;
    let mut directions = Extent::NOTHING;
    let mut ends = Extent::NOTHING;
    let records = (count * count) as i32;
    let first = (u.limits.round * u.limits.pitch) as i32;
    let mut j = first_row;
    while (j < first_row + size) & (j < count) & (index < nodes(count)) {
        let mut i = first_column;
        while (i < first_column + size) & (i < count) {
            let number = (j * count + i) as i32;
            if has_flux(beams, first, number, records) {
                let beam = beam_of(beams, first, number, records);
                let begins = across(&beam, 0.0);
                // A ray sees a point of the cross-section where it comes nearest to the middle, up to the point's distance times the change of direction
                // farther on.
                let wider = 1.0 / (1.0 - min(beam.opening, 0.5));
                volume = volume.with(beam.position, begins * wider);
                let at_end = across(&beam, beam.length) * wider;
                volume = volume.with(beam.position + beam.direction * beam.length, at_end);
                positions = positions.with(beam.position, begins);
                directions = directions.with(
                    beam.direction,
                    (absolute_vector(beam.direction_u) + absolute_vector(beam.direction_v)) * 0.5,
                );
                if beam.reach < 0.5 * FAR {
                    let half = across(&beam, beam.reach);
                    // As deep along the beam as an oblique or curved surface may be.
                    let deep = absolute_vector(beam.direction) * ((half.x + half.y) + half.z);
                    ends = ends.with(beam.position + beam.direction * beam.reach, half + deep);
                }
            }
            i += 1;
        }
        j += 1;
    }
    Bundle {
        low: volume.low,
        high: volume.high,
        position: (positions.low + positions.high) * 0.5,
        position_half: (positions.high - positions.low) * 0.5,
        direction: (directions.low + directions.high) * 0.5,
        direction_half: (directions.high - directions.low) * 0.5,
        end_low: ends.low,
        end_high: ends.high,
    }
    .store()
}
