//! Drawing of beams: the light that the medium scatters out of each beam towards the eye (single scattering; Jarosz et al. 2011, with the beam's own
//! cross-section in place of a blur).
//!
//! A pixel gets Φ σ_s p(θ) τ_light τ_view |w'| K, where K is the flux's density across the beam's picture, averaged over the pixel: the edge function
//! N' of the light ray is 0 on its picture, and spreads over the texel as the convolution of two boxes. Along the axis on which N' changes
//! faster pixels are filtered one wide, so that the sum over them is the beam's flux, exactly, however narrow the beam is.
//!
//! A wide beam is drawn in coarse pixels of a pyramid, block by block of 16 columns; single rays get what these leave them ([`super::shares`]).

use super::covered::{Covered, Levels, reaches_block};
use super::drawn::Drawn;
use super::pyramid::size;
use super::shares::Drawing;
use super::store_beam::beam_of;
use super::strip::{Light, Lit, Rows, Shared};
use crate::abi::beams::{BLOCK, BeamsUniforms, axis, medium};
use crate::field::sums::Sums;
use crate::math::{absolute, floor_to_int, max, min};

/// Share by which a beam is taken to be farther from the eye a viewing ray beside, at most: where no surface comes so near, all coarse pixels around one are
/// drawn.
const FARTHER: f32 = 0.02;
/// Share of a beam's light that is too small to be seen.
const NOTHING: f32 = 1e-6;

/// Single rays, which get what at most `COARSE` coarse levels leave them.
struct Single<const COARSE: u32, const MODE: u32>;

impl<const COARSE: u32, const MODE: u32> Lit for Single<COARSE, MODE> {
    #[inline(always)]
    fn light(&self, drawing: &Drawing<'_>, major: i32, minor: i32) -> Light {
        let (column, row) = drawing.drawn.pixel(major, minor);
        let line = drawing.sightline(column, row);
        let light = drawing.scattered::<MODE>(column as f32, row as f32, &line);
        let share = drawing.rest::<COARSE>(major, minor);
        let is_seen = (light.distance > 0.0) & (light.distance < line.depth) & (absolute(share) > NOTHING);
        Light { is_seen, radiance: light.radiance * share, is_shared: false }
    }
}

/// Coarse pixels.
struct Coarse<const MODE: u32>;

impl<const MODE: u32> Lit for Coarse<MODE> {
    #[inline(always)]
    fn light(&self, drawing: &Drawing<'_>, major: i32, minor: i32) -> Light {
        let levels = &drawing.levels;
        let edge = 1 << levels.own;
        let (light, around) = drawing.look::<MODE>(levels.own, major, minor);
        let meets = light.distance > 0.0;
        let is_seen = meets & (light.distance < around.nearest);
        // Beside pixels that are drawn, too, there is nothing left.
        let (left, right) = levels.borders();
        let first = major * edge == levels.first;
        let last = (major + 1) * edge == levels.first + BLOCK as i32;
        let alike = !((first & left) | (last & right));
        let is_free = light.distance * (1.0 + FARTHER * edge as f32) < around.least;
        let is_whole = is_seen & alike & is_free;
        Light { is_seen, radiance: light.radiance, is_shared: !is_whole & (light.distance <= around.farthest) }
    }
}

/// The pixels of a level in a block of columns.
#[inline(always)]
fn rows(drawing: &Drawing<'_>, covered: &Covered, level: u32) -> Rows {
    let Drawing { u, drawn, levels, .. } = drawing;
    let (columns, rows) = drawn.along_axes(size(u.picture, level));
    let (left, right) = (levels.first as f32, (levels.first + BLOCK as i32 - 1) as f32);
    let last = floor_to_int(min(covered.end, right), left, right) >> level;
    Rows {
        level,
        first: floor_to_int(max(covered.begin, left), left, right) >> level,
        last: if last < columns { last } else { columns - 1 },
        low: 0,
        high: rows - 1,
    }
}

/// Gives single rays what coarse pixels leave them.
#[inline(always)]
fn draw_single<const MODE: u32, S: Sums + ?Sized>(drawing: &Drawing<'_>, rows: &Rows, sums: &mut S) {
    let [first, second, third] = drawing.levels.coarse();
    let coarse = (first > 0) as u32 + (second > 0) as u32 + (third > 0) as u32;
    if coarse == 0 {
        rows.draw(drawing, &Single::<0, MODE>, sums);
    } else if coarse == 1 {
        rows.draw(drawing, &Single::<1, MODE>, sums);
    } else {
        rows.draw(drawing, &Single::<3, MODE>, sums);
    }
}

/// Draws the beam in a block of columns.
#[inline(always)]
fn draw<const MODE: u32, S: Sums + ?Sized>(drawing: &Drawing<'_>, covered: &Covered, sums: &mut S) {
    let own = drawing.levels.own;
    let fine = rows(drawing, covered, 0);
    if own == 0 {
        draw_single::<MODE, S>(drawing, &fine, sums);
        return;
    }
    let Shared { first, last } = rows(drawing, covered, own).draw(drawing, &Coarse::<MODE>, sums);
    if first <= last {
        let end = (last + 1) << own;
        let high = if end <= fine.high { end - 1 } else { fine.high };
        draw_single::<MODE, S>(drawing, &Rows { low: first << own, high, ..fine }, sums);
    }
}

/// Draws the beam number `x` in block number `y` of the columns along its major axis, if that is the axis of the pass. So no two rows of invocations
/// draw in the same pixels, and beams that lie side by side are drawn in the same pixels one soon after the other.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    mode: u32,
    beams: &[f32],
    projections: &[f32],
    sights: &[f32],
    depths: &[f32],
    materials: &[f32],
    optical_depths: &[f32],
    sums: &mut S,
) {
    let (number, count) = (x as i32, u.dispatch.width as i32);
    let round = u.limits.round;
    let start = (round * u.limits.projection_pitch) as i32;
    let first = (y * BLOCK) as i32;
    if !reaches_block(projections, start, number, count, first) {
        return;
    }
    let covered = Covered::of(projections, start, number, count);
    let drawn = Drawn::of(projections, start, number, count);
    let (columns, _) = drawn.along_axes(u.picture);
    if (drawn.steep != (u.limits.axis == axis::DOWNWARDS)) | (first >= columns) {
        return;
    }
    let beam = beam_of(beams, (round * u.limits.pitch) as i32, number, count);
    let levels = Levels::new(u, &drawn, &covered, first, columns);
    let drawing = Drawing { u, beam, drawn, levels, sights, depths, number, materials, optical_depths };
    if mode == medium::MARCHED {
        // Lines are as wide as a pixel: none is drawn in coarse ones.
        rows(&drawing, &covered, 0).draw(&drawing, &Single::<0, { medium::MARCHED }>, sums);
    } else if mode == medium::VARYING {
        draw::<{ medium::VARYING }, S>(&drawing, &covered, sums);
    } else {
        draw::<{ medium::HOMOGENEOUS }, S>(&drawing, &covered, sums);
    }
}
