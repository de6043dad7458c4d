//! Search for curved texels: those in whose light the wavefront bends so much that the beam, a linear function of the texel, shows it in the picture.
//! They are split ([`super::split_texels`]), which halves the texel's edge and quarters what curvature adds to the edge function.
//!
//! What the texel's derivatives predict for the next texels is compared with the beams there. A texel whose light took another way has no such
//! beam, or one that is many widths off, and says nothing about curvature.

use super::drawn::{Across, Drawn};
use super::picture::Edges;
use super::project_beam::{end, in_front};
use super::store_beam::{beam_of, has_flux};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Curved, curved};
use crate::math::{absolute, max, min, select};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// Places along a beam at which its curvature is looked at, evenly spaced.
const PLACES: i32 = 5;
/// The least curvature of a texel that is split, in pixels: the difference from the prediction a texel away. The beam's own edges are off by a quarter of
/// it.
const CURVED: f32 = 0.5;
/// The least curvature over the beam's width, times the beam's share of the light.
const BENT: f32 = 0.1;
/// The largest difference from the prediction on one way, in widths of the two beams.
const SAME_WAY: f32 = 2.0;

/// The level of work: whether the texel has a beam in this round, and was not found to be curved.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, before: [f32; curved::SIZE], beams: &[f32]) -> u32 {
    let number = (y * u.dispatch.width + x) as i32;
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let shows = has_flux(beams, (u.limits.round * u.limits.pitch) as i32, number, count);
    if shows & (Curved::load(&before).is_curved <= 0.0) { level::WORK } else { level::ENDED }
}

/// The part of a beam's major axis in the picture.
#[derive(Clone, Copy)]
struct Visible {
    begin: f32,
    end: f32,
}

impl Visible {
    /// The part of the middle line that is in the picture, or so near that the beam is.
    #[inline(always)]
    fn new(u: &BeamsUniforms, beam: &Beam, drawn: &Drawn) -> Self {
        let (low, high) = in_front(u, beam);
        let (a, b) = (end(u, beam, drawn, low).major, end(u, beam, drawn, high).major);
        let (columns, rows) = drawn.along_axes(u.picture);
        let (right, bottom) = ((columns - 1) as f32, (rows - 1) as f32);
        let (begin, end) = (max(min(a, b), 0.0), min(max(a, b), right));
        let half = max(drawn.half_width(&drawn.section(begin), 1.0), drawn.half_width(&drawn.section(end), 1.0));
        let beside = min(half, bottom);
        // The middle line: minor = slope · major + start.
        let slope = -drawn.middle.major / drawn.middle.minor;
        let slope = select(absolute(slope) < 1e-6, 1e-6, slope);
        let start = -drawn.middle.constant / drawn.middle.minor;
        let (top, bottom) = ((-beside - start) / slope, (bottom + beside - start) / slope);
        let shows = high > low;
        Self { begin: max(begin, min(top, bottom)), end: select(shows, min(end, max(top, bottom)), begin - 1.0) }
    }
}

/// A beam's change of the edge function from one texel to the next, along one of the texel's coordinates, at a place.
#[derive(Clone, Copy)]
struct Step {
    along: Across,
    other: Across,
}

/// Whether the beam beside, `towards` (1 or −1) along the first of the two changes, shows that the beam is curved at a place; `share` is the beam's share
/// of the light that came to the texel's first surface.
#[inline(always)]
fn bends(drawn: &Drawn, own: Step, middle: Across, beside: Step, towards: f32, share: f32, major: f32) -> bool {
    let section = drawn.section(major);
    let at = |across: &Across| across.at(major, section.middle);
    let (along, other) = (at(&own.along), at(&own.other));
    let (along_beside, other_beside) = (at(&beside.along), at(&beside.other));
    let difference = absolute(at(&middle) - towards * along);
    let twist = absolute(other_beside - other);
    let pixel = drawn.filter;
    let width = absolute(along) + absolute(other);
    let widths = width + absolute(along_beside) + absolute(other_beside);
    let curvature = max(difference, twist);
    let wide = max(width, pixel);
    let is_same_way = difference <= SAME_WAY * (widths + pixel);
    is_same_way & (curvature > CURVED * pixel) & (share * curvature > BENT * wide)
}

/// The sum of the channels.
#[inline(always)]
fn sum(flux: Vec3) -> f32 {
    (flux.x + flux.y) + flux.z
}

/// Whether the texel is curved, by the beams of a round as well as by those of the rounds before.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; curved::SIZE],
    beams: &[f32],
) -> [f32; curved::SIZE] {
    let (width, height) = (u.dispatch.width as i32, u.dispatch.height as i32);
    let (x, y, count) = (x as i32, y as i32, width * height);
    let first = (u.limits.round * u.limits.pitch) as i32;
    let number = y * width + x;
    let beam = beam_of(beams, first, number, count);
    let share = sum(beam.flux) / max(sum(beam_of(beams, 0, number, count).flux), f32::MIN_POSITIVE);
    let drawn = Drawn::new(u, &beam);
    let visible = Visible::new(u, &beam, &drawn);
    let mut is_curved = false;
    if (drawn.filter > 0.0) & (visible.begin <= visible.end) {
        let mut side = 0;
        while side < 4 {
            let along_u = side < 2;
            let towards = 1 - 2 * (side & 1);
            let (column, row) = if along_u { (x + towards, y) } else { (x, y + towards) };
            let is_texel = (column >= 0) & (column < width) & (row >= 0) & (row < height);
            let beside = row * width + column;
            if is_texel && has_flux(beams, first, beside, count) {
                let edges = Edges::new(u, &beam_of(beams, first, beside, count));
                let middle = Across::new(edges.middle, drawn.steep);
                let (by_u, by_v) = (Across::new(edges.change_u, drawn.steep), Across::new(edges.change_v, drawn.steep));
                let (own, beside) = if along_u {
                    (Step { along: drawn.change_u, other: drawn.change_v }, Step { along: by_u, other: by_v })
                } else {
                    (Step { along: drawn.change_v, other: drawn.change_u }, Step { along: by_v, other: by_u })
                };
                let sign = towards as f32;
                let mut place = 0;
                while place < PLACES {
                    let along = place as f32 / (PLACES - 1) as f32;
                    let major = visible.begin + (visible.end - visible.begin) * along;
                    is_curved |= bends(&drawn, own, middle, beside, sign, share, major);
                    place += 1;
                }
            }
            side += 1;
        }
    }
    Curved { is_curved: select(is_curved, 1.0, Curved::load(&before).is_curved) }.store()
}
