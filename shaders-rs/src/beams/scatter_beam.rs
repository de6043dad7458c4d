//! Drawing of beams: the light that the medium scatters out of each beam towards the eye (single scattering; Jarosz et al. 2011, with the beam's own
//! cross-section in place of a blur).
//!
//! A pixel gets Φ σ_s p(θ) τ_light τ_view |w'| K, where K is the flux's density across the beam's picture, averaged over the pixel: the edge function
//! N' of the light ray is 0 on its picture, and spreads over the texel as the convolution of two boxes. Along the axis on which N' changes
//! faster pixels are filtered one wide, so that the sum over them is the beam's flux, exactly, however narrow the beam is.
//!
//! A wide beam is drawn in coarse pixels of a pyramid, block by block of 16 columns, and [`super::resolve`] interpolates between their centres. Where coarse
//! pixels end, at the border of a block of another level or where a surface stands in the beam, interpolation would spread light across the
//! border: there the single rays get the rest of their light, which may be negative, so that levels add up to 1 everywhere.

use super::look_around::depths_around;
use super::medium::{phase, transmittance};
use super::nearest::Nearest;
use super::picture::{Edge, Edges};
use super::pyramid::{size, sums_of};
use super::store_beam::{beam_of, has_flux};
use super::trapezoid::filtered;
use super::viewing::{on_plane, through};
use crate::abi::beams::{BLOCK, BeamsUniforms};
use crate::abi::record::{Around, Beam, sight};
use crate::field::access::read;
use crate::field::sums::{Sums, add_large};
use crate::math::{absolute, clamp, dot, floor_to_int, length, limit, max, min, select, xyz};
use spirv_std::glam::Vec3;

/// Depth in front of the eye from which on a beam is projected, in voxels.
const NEAR: f32 = 1e-3;
/// Width of a beam's picture in blocks that have an end of the beam, over the width for which its level is chosen, inverted.
const AT_ENDS: f32 = 1.0 / 8.0;
/// Share by which a beam is taken to be farther from the eye a viewing ray beside, at most: where no surface comes so near, all coarse pixels around one are
/// drawn.
const FARTHER: f32 = 0.02;
/// Farther columns than any picture has.
const BEYOND: f32 = 1e6;

/// An edge function along the picture's axes in the order of a beam: the major axis first, along which it changes more slowly.
#[derive(Clone, Copy)]
struct Across {
    major: f32,
    minor: f32,
    constant: f32,
}

impl Across {
    #[inline(always)]
    fn new(edge: Edge, steep: bool) -> Self {
        Self { major: select(steep, edge.y, edge.x), minor: select(steep, edge.x, edge.y), constant: edge.constant }
    }

    #[inline(always)]
    fn at(&self, major: f32, minor: f32) -> f32 {
        self.major * major + (self.minor * minor + self.constant)
    }
}

/// A beam in the picture.
#[derive(Clone, Copy)]
struct Drawn {
    /// Whether the major axis is that of the columns' own direction, downwards.
    steep: bool,
    middle: Across,
    change_u: Across,
    change_v: Across,
    /// Change of the edge function from pixel to pixel along the minor axis.
    filter: f32,
}

/// A beam at one place along the major axis.
#[derive(Clone, Copy)]
struct Section {
    /// Its middle along the minor axis.
    middle: f32,
    /// Width of one box across the edge function.
    first: f32,
    /// Width of the other one.
    second: f32,
}

impl Drawn {
    #[inline(always)]
    fn new(u: &BeamsUniforms, beam: &Beam) -> Self {
        let edges = Edges::new(u, beam);
        let steep = absolute(edges.middle.x) > absolute(edges.middle.y);
        let middle = Across::new(edges.middle, steep);
        Self {
            steep,
            middle,
            change_u: Across::new(edges.change_u, steep),
            change_v: Across::new(edges.change_v, steep),
            filter: absolute(middle.minor),
        }
    }

    #[inline(always)]
    fn section(&self, major: f32) -> Section {
        let middle = -(self.middle.major * major + self.middle.constant) / self.middle.minor;
        self.section_at(major, middle)
    }

    #[inline(always)]
    fn section_at(&self, major: f32, minor: f32) -> Section {
        Section {
            middle: minor,
            first: absolute(self.change_u.at(major, minor)),
            second: absolute(self.change_v.at(major, minor)),
        }
    }

    /// Half the width of the beam's picture along the minor axis, with pixels `edge` wide.
    #[inline(always)]
    fn half_width(&self, section: &Section, edge: f32) -> f32 {
        0.5 * (section.first + section.second) / self.filter + 0.5 * edge
    }

    /// The pixel's density of flux, K.
    #[inline(always)]
    fn density(&self, section: &Section, minor: f32, edge: f32) -> f32 {
        filtered((minor - section.middle) * self.filter, section.first, section.second, self.filter * edge)
    }

    /// Column and row of a place in the picture.
    #[inline(always)]
    fn place(&self, major: f32, minor: f32) -> (f32, f32) {
        (select(self.steep, minor, major), select(self.steep, major, minor))
    }
}

/// An end of a beam along the major axis.
#[derive(Clone, Copy)]
struct End {
    major: f32,
    /// How much farther its edges reach than its middle.
    reach: f32,
}

/// Projects the point of a beam `along` it.
#[inline(always)]
fn end(u: &BeamsUniforms, beam: &Beam, drawn: &Drawn, along: f32) -> End {
    let offset = beam.position + beam.direction * along - xyz(u.eye);
    let depth = max(dot(xyz(u.away), offset), NEAR);
    let inverse = select(u.camera.orthographic != 0, 1.0, 1.0 / depth);
    let (width, height) = (u.picture.width as i32 as f32, u.picture.height as i32 as f32);
    let column = (dot(xyz(u.right), offset) * inverse / u.camera.half_width + 1.0) * (0.5 * width) - 0.5;
    let row = (1.0 - dot(xyz(u.up), offset) * inverse / u.camera.half_height) * (0.5 * height) - 0.5;
    let (column, row) = (clamp(column, -BEYOND, BEYOND), clamp(row, -BEYOND, BEYOND));
    let (major, minor) = (select(drawn.steep, row, column), select(drawn.steep, column, row));
    let section = drawn.section_at(major, minor);
    let slope = absolute(drawn.middle.major) / drawn.filter;
    End { major, reach: min(drawn.half_width(&section, 1.0) * slope, BEYOND) + 1.0 }
}

/// The part of a beam in front of the eye: distances along it.
#[inline(always)]
fn in_front(u: &BeamsUniforms, beam: &Beam) -> (f32, f32) {
    let depth = dot(xyz(u.away), beam.position - xyz(u.eye)) - NEAR;
    let speed = dot(xyz(u.away), beam.direction);
    if u.camera.orthographic != 0 {
        (0.0, beam.length)
    } else {
        let crossing = -depth / select(speed == 0.0, 1e-30, speed);
        let low = select(speed > 0.0, max(crossing, 0.0), 0.0);
        let high = select(speed < 0.0, min(crossing, beam.length), beam.length);
        (low, select((speed == 0.0) & (depth < 0.0), -1.0, high))
    }
}

/// Light that a beam sends along a viewing ray.
#[derive(Clone, Copy)]
struct Scattered {
    /// Distance from the eye, in voxels; 0 or less where the ray does not meet the beam.
    distance: f32,
    /// Radiance over the density of the flux and its transmittance up to where the ray enters the medium.
    radiance: Vec3,
}

/// The light that a beam sends along the viewing ray through the place (`column`, `row`) of the picture, which enters the medium at the distance
/// `enters`.
#[inline(always)]
fn scattered(u: &BeamsUniforms, beam: &Beam, column: f32, row: f32, enters: f32) -> Scattered {
    let (across, upwards) = on_plane(u, column, row);
    let (from, aim) = through(u, across, upwards);
    let size = length(aim);
    let w = aim * (1.0 / size);
    let Nearest { t, s, cosine } = Nearest::new(beam.position - from, w, beam.direction);
    let meets = (s >= 0.0) & (s < beam.length) & (t > 0.0);
    let dimmed = transmittance(&u.medium, s + max(t - enters, 0.0));
    let strength = size * phase(&u.medium, -cosine);
    let radiance = beam.flux * xyz(u.medium.scattering) * dimmed * strength;
    Scattered { distance: select(meets, t, 0.0), radiance }
}

/// Adds radiance to a pixel of a level.
#[inline(always)]
fn put<S: Sums + ?Sized>(u: &BeamsUniforms, level: u32, column: i32, row: i32, radiance: Vec3, sums: &mut S) {
    let at = sums_of(u, level, column, row);
    add_large(sums, at, radiance.x * u.sums.scale);
    add_large(sums, at + 2, radiance.y * u.sums.scale);
    add_large(sums, at + 4, radiance.z * u.sums.scale);
}

/// Adds a share of the beam's light to a single viewing ray, if the ray does not end before it.
#[inline(always)]
fn draw_fine<S: Sums + ?Sized>(
    u: &BeamsUniforms,
    beam: &Beam,
    drawn: &Drawn,
    section: &Section,
    major: i32,
    minor: i32,
    share: f32,
    sights: &[f32],
    sums: &mut S,
) {
    let (column, row) = if drawn.steep { (minor, major) } else { (major, minor) };
    let count = (u.picture.width * u.picture.height) as i32;
    let at = row * u.picture.width as i32 + column;
    let (depth, enters) =
        (read(sights, sight::DEPTH as i32 * count + at), read(sights, sight::ENTERS as i32 * count + at));
    let light = scattered(u, beam, column as f32, row as f32, enters);
    if (light.distance > 0.0) & (light.distance < depth) {
        let density = drawn.density(section, minor as f32, 1.0) * share;
        put(u, 0, column, row, light.radiance * density, sums);
    }
}

/// The level in whose pixels a beam is drawn that is `width` pixels wide: at least four pixels of that level.
#[inline(always)]
fn level_for(width: f32, levels: u32) -> u32 {
    let mut level = 0;
    let mut least = 8.0;
    while (level < levels) & (width >= least) {
        level += 1;
        least *= 2.0;
    }
    level
}

/// The levels of a block of columns and of the blocks beside it.
#[derive(Clone, Copy)]
struct Levels {
    /// The first column of the block.
    first: i32,
    left: u32,
    own: u32,
    right: u32,
}

impl Levels {
    /// The level in which a column along the major axis is drawn; columns are at most one block away.
    #[inline(always)]
    fn at(&self, column: i32) -> u32 {
        if column < self.first {
            self.left
        } else if column >= self.first + BLOCK as i32 {
            self.right
        } else {
            self.own
        }
    }

    /// Whether a column of single rays lies so near to a border that coarse pixels beyond it reach there.
    #[inline(always)]
    fn is_near_border(&self, column: i32) -> bool {
        let (before, behind) = (column - self.first, self.first + BLOCK as i32 - 1 - column);
        let reached = |beside: u32, distance: i32| (beside > 0) & (2 * distance < (1 << beside));
        reached(self.left, before) | reached(self.right, behind)
    }
}

/// A beam and what the passes of its drawing read.
#[derive(Clone, Copy)]
struct Drawing<'a> {
    u: &'a BeamsUniforms,
    beam: Beam,
    drawn: Drawn,
    levels: Levels,
    /// Records of [`crate::abi::record::Sight`].
    sights: &'a [f32],
    /// Records of [`crate::abi::record::Around`].
    depths: &'a [f32],
}

impl Drawing<'_> {
    /// The light of the beam at the middle of a pixel of a level, by its place along the beam's axes, and the depths around it.
    #[inline(always)]
    fn look(&self, level: u32, major: i32, minor: i32) -> (Scattered, Around) {
        let fine = (1 << level) as f32;
        let (along, across) = ((major as f32 + 0.5) * fine - 0.5, (minor as f32 + 0.5) * fine - 0.5);
        let (x, y) = self.drawn.place(along, across);
        let (column, row) = if self.drawn.steep { (minor, major) } else { (major, minor) };
        let around = depths_around(self.u, self.depths, level, column, row);
        (scattered(self.u, &self.beam, x, y, around.enters), around)
    }

    /// Whether the beam is drawn in a pixel of a level.
    #[inline(always)]
    fn is_drawn(&self, level: u32, major: i32, minor: i32) -> bool {
        let (light, around) = self.look(level, major, minor);
        let of_level = self.levels.at(major << level) == level;
        of_level & (light.distance > 0.0) & (light.distance < around.nearest)
    }

    /// The weight that interpolation gives a pixel of a level, if the beam is drawn there. The pixel is limited to the level as the look-up limits it.
    #[inline(always)]
    fn tap(&self, level: u32, columns: i32, rows: i32, major: i32, minor: i32, weight: f32) -> f32 {
        if self.is_drawn(level, limit(major, columns), limit(minor, rows)) { weight } else { 0.0 }
    }

    /// `share` without the share of its light that a single ray gets from the pixels of a coarse level. Without a loop: drivers that end long
    /// ones count this one in all loops around it.
    #[inline(always)]
    fn without(&self, share: f32, level: u32, major: i32, minor: i32) -> f32 {
        if level == 0 {
            return share;
        }
        let of_level = size(self.u.picture, level);
        let (columns, rows) = if self.drawn.steep {
            (of_level.height as i32, of_level.width as i32)
        } else {
            (of_level.width as i32, of_level.height as i32)
        };
        let inverse = 1.0 / (1 << level) as f32;
        let (x, y) = ((major as f32 + 0.5) * inverse - 0.5, (minor as f32 + 0.5) * inverse - 0.5);
        let (left, top) = (floor_to_int(x, -1.0, 1e6), floor_to_int(y, -1.0, 1e6));
        let (fx, fy) = (x - left as f32, y - top as f32);
        let share = share - self.tap(level, columns, rows, left, top, (1.0 - fx) * (1.0 - fy));
        let share = share - self.tap(level, columns, rows, left + 1, top, fx * (1.0 - fy));
        let share = share - self.tap(level, columns, rows, left, top + 1, (1.0 - fx) * fy);
        share - self.tap(level, columns, rows, left + 1, top + 1, fx * fy)
    }

    /// The share of its light that a single ray does not get from coarse pixels.
    #[inline(always)]
    fn rest(&self, major: i32, minor: i32) -> f32 {
        let Levels { left, own, right, .. } = self.levels;
        let share = self.without(1.0, own, major, minor);
        let share = self.without(share, if left == own { 0 } else { left }, major, minor);
        self.without(share, if (right == own) | (right == left) { 0 } else { right }, major, minor)
    }

    /// Draws the beam in a pixel of the block's level, and gives single rays of the pixel what interpolation leaves them.
    #[inline(always)]
    fn draw<S: Sums + ?Sized>(&self, section: &Section, major: i32, minor: i32, sums: &mut S) {
        let Self { u, drawn, .. } = self;
        let level = self.levels.own;
        let edge = 1 << level;
        let mut shared = self.levels.is_near_border(major);
        if level > 0 {
            let (light, around) = self.look(level, major, minor);
            if light.distance > around.farthest {
                return;
            }
            let visible = (light.distance > 0.0) & (light.distance < around.nearest);
            if visible {
                let across = (minor as f32 + 0.5) * edge as f32 - 0.5;
                let density = drawn.density(section, across, edge as f32);
                let (column, row) = if drawn.steep { (minor, major) } else { (major, minor) };
                put(u, level, column, row, light.radiance * density, sums);
            }
            // Beside pixels that are drawn, too, there is nothing left.
            let first = major * edge == self.levels.first;
            let last = (major + 1) * edge == self.levels.first + BLOCK as i32;
            let alike = (!first | (self.levels.left == level)) & (!last | (self.levels.right == level));
            if visible & alike & (light.distance * (1.0 + FARTHER * edge as f32) < around.least) {
                return;
            }
            shared = true;
        }
        let (width, height) = (u.picture.width as i32, u.picture.height as i32);
        let (columns, rows) = if drawn.steep { (height, width) } else { (width, height) };
        let mut i = major * edge;
        while (i < (major + 1) * edge) & (i < columns) {
            let section = if level == 0 { *section } else { drawn.section(i as f32) };
            let mut j = minor * edge;
            while (j < (minor + 1) * edge) & (j < rows) {
                let share = if shared { self.rest(i, j) } else { 1.0 };
                if (level == 0) | (absolute(share) > 1e-6) {
                    draw_fine(u, &self.beam, drawn, &section, i, j, share, self.sights, sums);
                }
                j += 1;
            }
            i += 1;
        }
    }
}

/// The part of the major axis that a beam covers: the columns of any of it, and the columns across which it has no end.
#[derive(Clone, Copy)]
struct Covered {
    begin: f32,
    end: f32,
    inner_begin: f32,
    inner_end: f32,
}

/// The level of the block whose first column is `left`; `own` for a block without any of the beam.
#[inline(always)]
fn level_of_block(u: &BeamsUniforms, drawn: &Drawn, covered: &Covered, left: i32, own: u32) -> u32 {
    let right = left + BLOCK as i32;
    let middle = drawn.section(left as f32 + 0.5 * (BLOCK as f32 - 1.0));
    let width = 2.0 * drawn.half_width(&middle, 1.0);
    let level = level_for(width, u.sums.levels);
    let margin = (1 << level) as f32;
    let within = (left as f32 - margin > covered.inner_begin) & (right as f32 + margin < covered.inner_end);
    // Coarse pixels do not show where exactly a beam ends: in blocks with an end they are finer.
    let level = if within { level } else { level_for(width * AT_ENDS, u.sums.levels) };
    let missed = (covered.end < left as f32) | (covered.begin > (right - 1) as f32);
    if missed { own } else { level }
}

/// Draws the beam number `y` in block number `x` of the columns along its major axis.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    beams: &[f32],
    sights: &[f32],
    depths: &[f32],
    sums: &mut S,
) {
    let count = u.dispatch.height as i32;
    let first = (u.limits.round * u.limits.pitch) as i32;
    if !has_flux(beams, first, y as i32, count) {
        return;
    }
    let beam = beam_of(beams, first, y as i32, count);
    let drawn = Drawn::new(u, &beam);
    let (low, high) = in_front(u, &beam);
    // A ray of light that goes through the eye is a point in the picture.
    if (drawn.filter <= 0.0) | (high <= low) {
        return;
    }
    let (a, b) = (end(u, &beam, &drawn, low), end(u, &beam, &drawn, high));
    let size_of_major = if drawn.steep { u.picture.height } else { u.picture.width } as i32;
    let size_of_minor = if drawn.steep { u.picture.width } else { u.picture.height } as i32;
    let left = (x * BLOCK) as i32;
    let right = left + BLOCK as i32;
    let backwards = b.major < a.major;
    let covered = Covered {
        begin: min(a.major - a.reach, b.major - b.reach),
        end: max(a.major + a.reach, b.major + b.reach),
        inner_begin: select(backwards, b.major + b.reach, a.major + a.reach),
        inner_end: select(backwards, a.major - a.reach, b.major - b.reach),
    };
    if (covered.end < left as f32) | (covered.begin > (right - 1) as f32) {
        return;
    }
    let own = level_of_block(u, &drawn, &covered, left, 0);
    let levels = Levels {
        first: left,
        left: if left > 0 { level_of_block(u, &drawn, &covered, left - BLOCK as i32, own) } else { own },
        own,
        right: if right < size_of_major { level_of_block(u, &drawn, &covered, right, own) } else { own },
    };
    let drawing = Drawing { u, beam, drawn, levels, sights, depths };
    let edge = 1 << own;
    let fine = edge as f32;
    let mut column = max(covered.begin, left as f32) as i32 >> own;
    let last = ((if right < size_of_major { right } else { size_of_major }) - 1) >> own;
    let end = ((size_of_minor - 1) >> own) as f32;
    while column <= last {
        let major = (column as f32 + 0.5) * fine - 0.5;
        let section = drawn.section(major);
        let half = drawn.half_width(&section, fine);
        let lowest = (section.middle - half + 0.5) / fine - 0.5;
        let highest = (section.middle + half + 0.5) / fine - 0.5;
        let mut row = floor_to_int(lowest + 1.0, 0.0, end + 1.0);
        let stop = floor_to_int(highest, -1.0, end);
        while row <= stop {
            drawing.draw(&section, column, row, sums);
            row += 1;
        }
        column += 1;
    }
}
