//! The light inside matter, as a viewing ray sees it along a segment.
//!
//! Light that is carried is known at samples, between which dense matter may attenuate it by any factor. It is looked up nearer to its source, where little
//! matter is in the way, and attenuated from there on. Inside the segment it falls with depth just as what is seen of it does, by another factor.

use crate::abi::format::VoxelFormat;
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::stencil::{central_differences, scalar, stencil, to_view_frame, voxel_coordinates};
use crate::field::tables::{Segment, attenuation, attenuation_of_particles};
use crate::math::{absolute, clamp, dot, exp, length, lerp, log2, max, min, select};
use crate::optics::composite::{layer, layer_of_particles};
use crate::optics::isosurfaces::{Sheet, transmittance};
use crate::optics::medium::span_inside;
use crate::optics::span::Span;
use crate::sweep::bodies::is_met;
use crate::sweep::clip::keep;
use crate::sweep::light::carried::light_at;
use crate::sweep::light::look_up::Light;
use crate::sweep::light::wavefront::{edge, from_frame, in_frame, unrefracted_direction};
use spirv_std::glam::Vec3;

/// How far nearer to the source the light inside dense matter is looked up, over the distance of samples.
pub const NEARER: f32 = 1.5;
/// The least optical depth along the light over the one along the viewing ray: light from behind falls towards the eye.
const LEAST_RATIO: f32 = -0.5;
/// The largest one: of a surface that light grazes.
const LARGEST_RATIO: f32 = 8.0;
/// Within a layer of a smaller optical depth the light is the same everywhere.
const THIN: f32 = 0.05;

/// A segment of a viewing ray.
pub struct Seen<'a> {
    /// Its front, in the view frame.
    pub from: Vec3,
    /// Its back.
    pub to: Vec3,
    /// Normalised scalar at its front.
    pub front: f32,
    /// Normalised scalar at its back.
    pub back: f32,
    /// Optical depths between the two.
    pub segment: &'a Segment,
    /// The part of it with particles.
    pub span: Span,
    /// The share that it lets through, 1 − α.
    pub clear: f32,
    /// The isosurfaces that it crosses.
    pub sheet: Sheet,
    /// The share that these have in what is seen.
    pub share: f32,
    /// Whether there may be isosurfaces.
    pub looks_for_isosurfaces: bool,
    /// The factor of extinction that its voxels have.
    pub extinction: f32,
}

/// Where particles are seen in a segment.
struct Place {
    /// Their optical depth along the viewing ray.
    depth: f32,
    /// The optical depth in front of their mean place.
    before: f32,
    /// Their mean place, 0 at the front of the segment and 1 at its back.
    at: f32,
}

/// The mean place of what is seen of a segment's particles.
///
/// They are taken for a layer that has the same mean place and is uniform over a part of the segment, at its front or at its back. What is seen of a uniform
/// layer of depth D has the mean depth ∫ t e^(−t) dt over ∫ e^(−t) dt from 0 to D.
#[inline(always)]
fn place(seen: &Seen<'_>) -> Place {
    let opacity = 1.0 - seen.clear;
    let depth = -log2(max(seen.clear, 1e-6)) * core::f32::consts::LN_2;
    // Up to the third power of the depth, where the difference below is lost in rounding.
    let thin = 0.5 - depth * (1.0 / 12.0);
    let within = select(opacity < THIN, thin, 1.0 / max(depth, 1e-3) - seen.clear / max(opacity, 1e-3));
    let Segment { particles, moment, .. } = *seen.segment;
    let middle = select(particles > 1e-9, clamp(moment / max(particles, 1e-9), 0.0, 1.0), 0.5);
    let empty = max(2.0 * middle - 1.0, 0.0);
    let at = empty + min(2.0 * middle, 2.0 - 2.0 * middle) * within;
    let at = seen.span.at(at);
    let at = select(seen.share > 0.0, lerp(at, seen.sheet.at, seen.share), at);
    Place { depth, before: depth * within, at }
}

/// The share of the light that is left in a segment that crosses isosurfaces, the mean over what is seen. `depth` is the optical depth of particles on the
/// light's way, and `ratio` that along the light over that along the view.
///
/// Isosurfaces are taken for a thin layer of matter, whose depth along the light is to that along the view as the cosines to its normal, the `gradient` of the
/// scalar, are: below 0 if the light comes from the other side.
#[inline(always)]
fn left_in_sheet(place: &Place, seen: &Seen<'_>, gradient: Vec3, light: Vec3, (depth, ratio): (f32, f32)) -> f32 {
    let view = seen.to - seen.from;
    let along_view = dot(gradient, view) / max(length(view), 1e-20);
    let along_light = dot(gradient, light) / max(length(light), 1e-20);
    let least = absolute(along_view) * (1.0 / LARGEST_RATIO);
    let slope = select(along_light < 0.0, min(along_light, -least), max(along_light, least));
    let own = clamp(along_view / select(absolute(slope) < 1e-20, 1e-20, slope), -LARGEST_RATIO, LARGEST_RATIO);
    let particles = max(depth - (1.0 - seen.share) * (ratio * place.before), 0.0);
    let first = particles + seen.share * (max(-own, 0.0) * place.depth);
    let behind = place.depth * (1.0 + lerp(ratio, own, seen.share));
    let same = absolute(behind) < 1e-2;
    let fallen = (exp(-first) - exp(-(first + behind))) / select(same, 1.0, behind);
    let mean = select(same, exp(-first) * (1.0 - 0.5 * behind), fallen);
    mean * (place.depth / max(1.0 - seen.clear, 1e-6))
}

/// The shares of the way between two points of the view frame that have particles, and the medium.
#[inline(always)]
fn filled(u: &SweepUniforms, from: Vec3, to: Vec3) -> (f32, f32) {
    let kept = keep(u, from, to);
    let inside = span_inside(&u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    (kept.particles.within(inside).length(), kept.medium.within(inside).length())
}

/// A way of light through matter.
pub(super) struct Way {
    /// Normalised scalar at its beginning.
    pub(super) scalar: f32,
    /// The share of it that has particles.
    filled: f32,
    /// Optical depth of particles between its scalars, for the reference length.
    particles: f32,
    /// Their optical depth.
    depth: f32,
    /// The share of light that they let through.
    pub(super) clear: f32,
    /// The share that the medium lets through.
    pub(super) medium: Vec3,
}

/// The way of light from `start` to a point and its scalar, `length` world units behind. Voxels' factor of `extinction` is taken to be the same on it.
#[inline(always)]
pub(super) fn behind<V: VoxelFormat>(
    u: &SweepUniforms,
    chosen: u32,
    (voxels, tables): (&[u32], &[u32]),
    start: Vec3,
    (end, back): (Vec3, f32),
    (length, extinction): (f32, f32),
) -> Way {
    let front = scalar::<V>(voxels, &u.grid, voxel_coordinates(&u.grid, start));
    let path = length * u.step.inverse_reference_length;
    let (filled, medium) = filled(u, start, end);
    let attenuation = if mode::is_clear(chosen) {
        attenuation_of_particles(tables, front, back)
    } else {
        attenuation(tables, front, back)
    };
    let attenuation = attenuation.thinned::<V>(extinction);
    let left = if mode::is_clear(chosen) {
        layer_of_particles(&attenuation, path * filled)
    } else {
        layer(&attenuation, path * filled, path * medium)
    };
    let depth = attenuation.particles * (path * filled);
    Way { scalar: front, filled, particles: attenuation.particles, depth, clear: left.clear, medium: left.medium }
}

/// Whether a body is before or behind a point of the view frame, at a distance of `way` along the light.
#[inline(always)]
fn is_beside_body<V: VoxelFormat>(u: &SweepUniforms, bodies: &[u32], at: Vec3, way: Vec3) -> bool {
    is_met::<V>(u, bodies, at - way, at + way)
}

/// The light that a viewing ray sees in a segment: as [`light_at`], the mean over the segment, each place weighted by what is seen of its particles.
#[inline(always)]
pub fn light_in_matter<V: VoxelFormat>(
    u: &SweepUniforms,
    chosen: u32,
    (voxels, second, tables, light): (&[u32], &[u32], &[u32], &[u32]),
    seen: &Seen<'_>,
) -> Light {
    let w = &u.wavefront;
    let place = place(seen);
    let at = seen.from + (seen.to - seen.from) * place.at;
    let back = lerp(seen.front, seen.back, place.at);

    let inside = in_frame(w, at);
    let apart = max(1.0 / w.inverse_step, edge(w, inside.z)) * NEARER;
    let unit = u.step.inverse_reference_length;
    // In thin matter, which may show caustics, it is looked up in place.
    // Between labels there is nothing to attenuate by.
    let dense = select(u.grid.nearest != 0, 0.0, min(2.0 * seen.segment.particles * apart * unit, 1.0));
    let dense = select(seen.sheet.depth > 0.0, 1.0, dense);
    let towards = from_frame(w, unrefracted_direction(w, inside));
    // Some of the samples around a point beside a body are inside the body, or on its other side.
    let beside_body = V::BODIES && is_beside_body::<V>(u, second, at, towards * apart);
    let dense = select(beside_body, 1.0, dense);
    let nearer = apart * dense;
    let start = at - towards * nearer;
    let near = behind::<V>(u, chosen, (voxels, tables), start, (at, back), (nearer, seen.extinction));
    let far = start - (at - start);
    let beyond = behind::<V>(u, chosen, (voxels, tables), far, (start, near.scalar), (nearer, seen.extinction));
    let path = nearer * unit;
    let clear = near.clear * beyond.clear;
    let medium = near.medium * beyond.medium;

    // Scalars change along the light and along the viewing ray as the depths below a surface do. Below a cut the ways through matter tell.
    let along_view = (seen.back - seen.front) / max(length(seen.to - seen.from), 1e-20);
    let along_light = (back - near.scalar) / max(nearer, 1e-20);
    let below_surface = select(along_light > 1e-6 * along_view, along_view / max(along_light, 1e-20), 0.0);
    let cut = near.filled - filled(u, seen.from + (start - at), seen.from).0;
    let below_cut = near.particles * (path * cut) / max(place.before, 1e-6);
    let is_cut = absolute(cut) > 1e-4;
    let ratio = clamp(select(is_cut, below_cut, below_surface), LEAST_RATIO, LARGEST_RATIO);
    let first = max(near.depth + beyond.depth - ratio * place.before, 0.0);
    let both = 1.0 + ratio;
    // What is left at the mean place of what is seen, and the mean of what is left there.
    let fading = (1.0 - exp(-(place.depth * both))) / (both * max(1.0 - seen.clear, 1e-6));
    let mean = select(place.depth < THIN, clear, exp(-first) * fading);

    let light = light_at(u, light, far, chosen);
    let mut left = lerp(clear, mean, dense);
    if seen.looks_for_isosurfaces {
        let crosses = seen.sheet.depth > 0.0;
        let mut in_sheet = left;
        // On a CPU a branch around scattered reads is no vector code.
        if !cfg!(target_arch = "spirv") | crosses {
            let around = stencil::<V>(voxels, &u.grid, voxel_coordinates(&u.grid, at));
            let gradient = to_view_frame(&u.grid, central_differences(&around));
            let depth = near.depth + beyond.depth;
            in_sheet = left_in_sheet(&place, seen, gradient, light.direction, (depth, ratio));
        }
        // Beside the isosurfaces that the segment crosses others may be in the light's way, but for one that comes over a cut.
        let (low, high) = (min(seen.front, seen.back), max(seen.front, seen.back));
        let others = transmittance(tables, beyond.scalar, near.scalar, Span::WHOLE)
            * transmittance(tables, near.scalar, clamp(near.scalar, low, high), Span::WHOLE);
        let others = select(min(near.filled, beyond.filled) < 1.0, 1.0, others);
        left = select(crosses, in_sheet, left) * others;
    }
    if V::BODIES {
        left = select(beside_body & is_met::<V>(u, second, far, at), 0.0, left);
    }
    Light { flux: light.flux * (medium * left), direction: light.direction }
}
