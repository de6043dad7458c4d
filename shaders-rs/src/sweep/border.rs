//! Refraction at the border of the space in which a volume bends light: the faces of its box, and the cuts of clipping planes that remove
//! everything (Snell's law).
//!
//! That space is convex: a straight way enters it at most once and leaves it at most once. Outside, η is 1, since tables hold η over the
//! index of the surroundings. An optical direction v keeps its component along the border, and |v| = η on either side, so that the square
//! of its component across the border changes by the difference of η².

use crate::abi::clip::Clip;
use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::field::tables::ior;
use crate::math::{affine, dot, length, max, normalize, select, select_vector, sqrt, xyz};
use crate::optics::medium::{is_well_inside, share_inside};
use crate::optics::step::flight;
use spirv_std::glam::Vec3;

/// Distance from the border, in voxels, within which a position does not tell on which side of the border a ray is: rounding could.
const RIM: f32 = 1.0 / 64.0;

/// A share of a way that no way has: it does not meet the border.
const NEVER: f32 = 2.0;

/// The grid of the volume that bends.
#[inline(always)]
pub fn bending_grid<V: VoxelFormat>(u: &SweepUniforms) -> &Grid {
    if V::SECOND { &u.ior_grid } else { &u.grid }
}

/// The least distance from the border, in voxels, of what is far inside.
pub const MARGIN: f32 = 0.5;

/// Whether a point of the view frame is `margin` voxels or more inside the border.
#[inline(always)]
pub fn is_inside_by<V: VoxelFormat>(u: &SweepUniforms, at: Vec3, margin: f32) -> bool {
    let grid = bending_grid::<V>(u);
    let voxels = voxel_coordinates(grid, at);
    let (low, high) = (grid.low, grid.high);
    let along = |at: f32, low: f32, high: f32| (at >= low + margin) & (at <= high - margin);
    let mut inside = along(voxels.x, low.x, high.x) & along(voxels.y, low.y, high.y) & along(voxels.z, low.z, high.z);
    if u.flags & flag::CLIP != 0 {
        let depth = margin / length(xyz(grid.row_x.factors));
        let kept = |clip: &Clip| (affine(clip.plane, at) <= -depth) | (clip.everything == 0);
        inside &= kept(&u.clip_0) & kept(&u.clip_1) & kept(&u.clip_2) & kept(&u.clip_3);
    }
    inside
}

/// Whether the way between two points of the view frame, and as long a way behind it, are [`MARGIN`] or more inside the volume's grid, and
/// `margin` voxels or more, at least [`MARGIN`], inside the border: nothing here then concerns it.
#[inline(always)]
pub fn is_far_inside<V: VoxelFormat>(u: &SweepUniforms, chosen: u32, from: Vec3, to: Vec3, margin: f32) -> bool {
    let mut far = is_well_inside(&u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    if mode::bends(chosen) {
        far &= is_inside_by::<V>(u, from, margin) & is_inside_by::<V>(u, to + (to - from), margin);
    }
    far
}

/// Where a straight way meets the border.
#[derive(Clone, Copy)]
pub struct Meeting {
    /// The share of the way up to where it enters, if it begins outside; above 1 if it does not.
    pub enters: f32,
    /// Normal of the face through which it enters, of any length.
    pub entered: Vec3,
    /// The share of the way up to where it leaves, if it begins inside; above 1 if it does not.
    pub leaves: f32,
    /// Normal of the face through which it leaves, of any length.
    pub left: Vec3,
    /// Signed distance of the way's beginning from the border, in voxels; positive outside.
    pub distance: f32,
    /// Signed distance of the way's end.
    pub end: f32,
    /// Normal of the face that is nearest to the way's beginning, of any length.
    pub nearest: Vec3,
}

impl Meeting {
    /// The way with the half-space behind one more face: `a` and `b` are the signed distances of its ends, positive outside.
    #[inline(always)]
    fn with(self, a: f32, b: f32, normal: Vec3) -> Self {
        let crossed = max(a, -a) / max(max(a - b, b - a), 1e-30);
        let enters = select(a > 0.0, select(b < 0.0, crossed, NEVER), 0.0);
        let leaves = select(b > 0.0, select(a < 0.0, crossed, 0.0), NEVER);
        let nearer = a > self.distance;
        // Of faces that it is beyond at its beginning already, the nearest one counts.
        let later = (enters > self.enters) | ((enters == self.enters) & nearer);
        let sooner = leaves < self.leaves;
        Self {
            enters: select(later, enters, self.enters),
            entered: select_vector(later, normal, self.entered),
            leaves: select(sooner, leaves, self.leaves),
            left: select_vector(sooner, normal, self.left),
            distance: select(nearer, a, self.distance),
            end: max(b, self.end),
            nearest: select_vector(nearer, normal, self.nearest),
        }
    }

    #[inline(always)]
    fn with_faces(self, from: f32, to: f32, (low, high): (f32, f32), normal: Vec3) -> Self {
        self.with(low - from, low - to, normal).with(from - high, to - high, normal)
    }

    #[inline(always)]
    fn with_cut(self, clip: &Clip, from: Vec3, to: Vec3, voxels: f32) -> Self {
        let everything = clip.everything != 0;
        let (a, b) = (affine(clip.plane, from) * voxels, affine(clip.plane, to) * voxels);
        self.with(select(everything, a, -1e6), select(everything, b, -1e6), xyz(clip.plane.factors))
    }

    /// Whether the way meets the border, given the side on which it begins.
    #[inline(always)]
    pub fn happens(&self, inside: bool) -> bool {
        let enters = (self.enters <= 1.0) & (self.enters < self.leaves);
        // A way that begins beyond a face, by rounding, leaves at once.
        if inside { self.leaves <= 1.0 } else { enters }
    }
}

/// Where the way between two points of the view frame meets the border.
#[inline(always)]
pub fn meet<V: VoxelFormat>(u: &SweepUniforms, from: Vec3, to: Vec3) -> Meeting {
    let grid = bending_grid::<V>(u);
    let (a, b) = (voxel_coordinates(grid, from), voxel_coordinates(grid, to));
    let none = Vec3::new(0.0, 0.0, 1.0);
    let (x, y, z) = (xyz(grid.row_x.factors), xyz(grid.row_y.factors), xyz(grid.row_z.factors));
    let nothing =
        Meeting { enters: -1.0, entered: none, leaves: NEVER, left: none, distance: -1e30, end: -1e30, nearest: none };
    let (low, high) = (grid.low, grid.high);
    let mut meeting = nothing
        .with_faces(a.x, b.x, (low.x, high.x), x)
        .with_faces(a.y, b.y, (low.y, high.y), y)
        .with_faces(a.z, b.z, (low.z, high.z), z);
    if u.flags & flag::CLIP != 0 {
        let voxels = length(x);
        meeting = meeting.with_cut(&u.clip_0, from, to, voxels);
        meeting = meeting.with_cut(&u.clip_1, from, to, voxels);
        meeting = meeting.with_cut(&u.clip_2, from, to, voxels);
        meeting = meeting.with_cut(&u.clip_3, from, to, voxels);
    }
    meeting
}

/// Whether a ray is inside at the beginning of a way: by its position, and within `RIM` of the border as it was `known` before.
#[inline(always)]
pub fn is_inside(meeting: &Meeting, known: bool) -> bool {
    let near = (meeting.distance > -RIM) & (meeting.distance < RIM);
    if near { known } else { meeting.distance < 0.0 }
}

/// A direction behind a border.
#[derive(Clone, Copy)]
pub struct Bent {
    /// The optical direction.
    pub direction: Vec3,
    /// Whether it was reflected totally.
    pub reflected: bool,
}

/// Snell's law: the optical direction `v` behind a border with a normal of any length, where η² is larger by `gain`.
#[inline(always)]
pub fn bend(v: Vec3, normal: Vec3, gain: f32) -> Bent {
    let n = normalize(normal);
    let along = dot(v, n);
    let squared = along * along + gain;
    let size = sqrt(squared);
    let after = select(along < 0.0, -size, size);
    let reflected = squared <= 0.0;
    let change = select(reflected, -2.0 * along, after - along);
    Bent { direction: select_vector(gain == 0.0, v, v + n * change), reflected: reflected & (gain != 0.0) }
}

/// The largest cosine between a face and light along it.
const ALONG: f32 = 0.1;

/// Snell's law for light on a texel, which is a mixture of light from both sides of the border: the direction whose component along the
/// border is that of `v`, with |v| = `eta`. Light that cannot be there is reflected. Light that flies along the border and does not cross
/// it keeps its direction.
#[inline(always)]
pub fn settle(v: Vec3, normal: Vec3, eta: f32, crosses: bool) -> (Vec3, bool) {
    let across = dot(v, normalize(normal));
    let squared = dot(v, v);
    let bent = bend(v, normal, eta * eta - squared);
    let keeps = !crosses & (bent.reflected | (across * across < ALONG * ALONG * squared));
    let scaled = v * (eta / sqrt(max(squared, 1e-12)));
    let direction = select_vector(bent.reflected, v, bent.direction);
    (select_vector(keeps, scaled, direction), bent.reflected & crosses)
}

/// A ray's way to the next plane over the border.
#[derive(Clone, Copy)]
pub struct Crossing {
    /// Where it ends, on the next plane, or where it turned.
    pub to: Vec3,
    /// The optical direction with which it gets there.
    pub direction: Vec3,
    /// Length of the way inside the volume that is shown, world units.
    pub path: f32,
    /// dσ of the step of which half is due as a kick at its end: twice that of its part inside if it entered, when the first half was
    /// not due on the plane behind.
    pub sigma: f32,
    /// Whether it ends inside.
    pub inside: bool,
    /// Whether its direction changed.
    pub bent: bool,
    /// Whether the plane sweep cannot follow it.
    pub turned: bool,
    /// Normal of the face at which it was bent first, of any length.
    pub face: Vec3,
    /// η in front of that face, and behind it.
    pub iors: (f32, f32),
}

/// The part of a way behind a point of the border.
struct Part {
    at: Vec3,
    v: Vec3,
    to: Vec3,
    inside: bool,
    bent: bool,
    turned: bool,
    iors: (f32, f32),
}

/// η at a point of the view frame on the border, or next to it, on its inner side.
#[inline(always)]
pub fn border_ior<V: VoxelFormat>(
    u: &SweepUniforms,
    voxels: &[u32],
    ior_voxels: &[u32],
    tables: &[u32],
    at: Vec3,
) -> f32 {
    let grid = bending_grid::<V>(u);
    let voxels = if V::SECOND { ior_voxels } else { voxels };
    ior(tables, scalar::<V>(voxels, grid, voxel_coordinates(grid, at)))
}

/// The buffers of the volumes.
#[derive(Clone, Copy)]
pub struct Volumes<'a> {
    /// Voxels of the volume.
    pub voxels: &'a [u32],
    /// Voxels of the second one.
    pub ior_voxels: &'a [u32],
    /// Transfer function tables.
    pub tables: &'a [u32],
}

/// The way from `from` to `to` behind the border, which it meets at `share` of its length if it `happens`.
#[inline(always)]
fn over<V: VoxelFormat>(
    u: &SweepUniforms,
    volumes: Volumes<'_>,
    (from, to, v): (Vec3, Vec3, Vec3),
    (share, normal): (f32, Vec3),
    (inside, happens): (bool, bool),
) -> Part {
    let at = from + (to - from) * select(happens, share, 1.0);
    let eta = border_ior::<V>(u, volumes.voxels, volumes.ior_voxels, volumes.tables, at);
    let iors = if inside { (eta, 1.0) } else { (1.0, eta) };
    let bent = bend(v, normal, iors.1 * iors.1 - iors.0 * iors.0);
    let direction = select_vector(happens, bent.direction, v);
    let slope = u.step.smallest_cosine * u.step.smallest_cosine * dot(direction, direction);
    let changed = happens & (iors.0 != iors.1);
    let turned = changed & ((direction.z <= 0.0) | (direction.z * direction.z <= slope));
    let rest = (u.step.ahead - at.z) / select(turned, 1.0, direction.z);
    let end = Vec3::new(at.x + direction.x * rest, at.y + direction.y * rest, u.step.ahead);
    Part {
        at,
        v: direction,
        to: select_vector(turned, at, select_vector(changed, end, to)),
        inside: inside != (happens & !bent.reflected),
        bent: changed,
        turned,
        iors,
    }
}

/// Whether the way behind a point of the border that was met, if it `happened`, leaves again, and the share and the normal where it does.
#[inline(always)]
fn again<V: VoxelFormat>(u: &SweepUniforms, happened: bool, part: &Part) -> (bool, (f32, Vec3)) {
    let meeting = meet::<V>(u, part.at, part.to);
    let leaves = happened & part.inside & !part.turned & meeting.happens(true);
    (leaves, (meeting.leaves, meeting.left))
}

/// Length of a straight way inside the volume that is shown, world units.
#[inline(always)]
fn length_shown(u: &SweepUniforms, a: Vec3, b: Vec3) -> f32 {
    length(b - a) * share_inside(&u.grid, voxel_coordinates(&u.grid, a), voxel_coordinates(&u.grid, b))
}

impl Crossing {
    /// The way to `to` of a ray that is far inside.
    #[inline(always)]
    pub fn none(u: &SweepUniforms, to: Vec3, direction: Vec3, path: f32) -> Self {
        let sigma = flight(direction, u.step.distance);
        let (bent, turned) = (false, false);
        Self { to, direction, path, sigma, inside: true, bent, turned, face: direction, iors: (1.0, 1.0) }
    }
}

/// The way of a ray from `from` with optical direction `v`, which would end at `to` on the next plane if there were no border.
#[inline(always)]
pub fn cross<V: VoxelFormat>(
    u: &SweepUniforms,
    volumes: Volumes<'_>,
    (from, to, v): (Vec3, Vec3, Vec3),
    meeting: &Meeting,
    inside: bool,
) -> Crossing {
    let met = if inside { (meeting.leaves, meeting.left) } else { (meeting.enters, meeting.entered) };
    let happens = meeting.happens(inside);
    let first = over::<V>(u, volumes, (from, to, v), met, (inside, happens));
    let (leaves, second_met) = again::<V>(u, happens, &first);
    let second = over::<V>(u, volumes, (first.at, first.to, first.v), second_met, (first.inside, leaves));
    // A face that it meets there after a reflection at the second one, and at an edge yet another one.
    let (leaves_late, third_met) = again::<V>(u, leaves, &second);
    let third = over::<V>(u, volumes, (second.at, second.to, second.v), third_met, (second.inside, leaves_late));
    let (lost, _) = again::<V>(u, leaves_late, &third);

    let straight = length_shown(u, from, to);
    let before = length_shown(u, from, first.at) + length_shown(u, first.at, second.at);
    let way = before + length_shown(u, second.at, third.at);
    let pieces = way + select(leaves_late, length_shown(u, third.at, third.to), 0.0);
    let bent = (first.bent | second.bent) | third.bent;
    let entered = happens & !inside & first.inside & !leaves;
    let within = (first.to.z - first.at.z) / first.v.z;
    let turned = (first.turned | second.turned) | third.turned;
    Crossing {
        // There it waits to be followed.
        to: select_vector(lost, third.at, third.to),
        direction: third.v,
        path: select(bent, pieces, straight),
        sigma: select(entered, 2.0 * within, flight(third.v, u.step.distance)),
        inside: third.inside,
        bent,
        turned: turned | lost,
        face: if first.bent { met.1 } else { second_met.1 },
        iors: if first.bent { first.iors } else { second.iors },
    }
}

/// The end of a straight step of one plane's distance from `at` along the optical direction `v`.
#[inline(always)]
pub fn step_on(u: &SweepUniforms, at: Vec3, v: Vec3) -> Vec3 {
    at + v * (u.step.distance / max(v.z, 1e-6))
}

/// The share of a kick's first half, ½, that is due at the beginning of the step from `to` on: all that is inside, if the ray leaves within
/// that step, since there is no second half then.
#[inline(always)]
pub fn share_ahead<V: VoxelFormat>(u: &SweepUniforms, to: Vec3, v: Vec3) -> f32 {
    let leaves = meet::<V>(u, to, step_on(u, to, v)).leaves;
    select(leaves < 1.0, leaves, 0.5)
}
