//! Viewing rays from the plane behind to this one (sweep §4.3, Eq. 14, Algorithm 1, lines 21 to 36).

use crate::abi::format::VoxelFormat;
use crate::abi::record::{Ray, ray, status};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::colors::tint_of;
use crate::field::stencil::{front_of, scalar, voxel_coordinates};
use crate::field::tables::{ior, segment, segment_of_particles};
use crate::math::{length, lerp, max, min, select, select_vector};
use crate::optics::ambient::mean_radiance;
use crate::optics::composite::{Gathered, layer, layer_of_particles, over};
use crate::optics::diffuse::cosine;
use crate::optics::isosurfaces::{Sheet, sheet};
use crate::optics::medium::{medium, span_inside};
use crate::optics::receiver::{Hit, first_between, free_steps};
use crate::optics::span::Span;
use crate::optics::specular::lobe;
use crate::optics::step::flight;
use crate::sweep::bodies::{first_body, may_be_met};
use crate::sweep::border::{
    Crossing, MARGIN, Volumes, bending_grid, cross, is_far_inside, is_inside, meet, share_ahead,
};
use crate::sweep::clip::keep;
use crate::sweep::empty::{step_is_empty, steps_are_empty};
use crate::sweep::isosurfaces::are_looked_for;
use crate::sweep::light::body::light_on_body;
use crate::sweep::light::look_up::{Light, direction, light, radiance, shade, shift, texel_coordinates, unoccluded};
use crate::sweep::light::matter::{NEARER, Seen, light_in_matter};
use crate::sweep::light::receiver_map::light_on;
use crate::sweep::surface::{Crossed, Reflected, added, layer_ior, surface};
use crate::sweep::turn::turn;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The ray has ended.
    pub const ENDED: u32 = 0;
    /// It flies on through empty space, meets no receiver, and its record stays as it is.
    pub const EMPTY: u32 = 1;
    /// The scalar at its position is known, and its segment is well inside the grid.
    pub const FULL: u32 = 3;
    /// It comes from empty space, where its scalar was not sampled.
    pub const ENTERING: u32 = 7;
    /// It meets a receiver, or perhaps a body or an isosurface.
    pub const MEETING: u32 = 15;
    /// Its segment, or the one behind it, may be outside in part, or it may begin in a volume.
    pub const BORDER: u32 = 31;
}

/// Rays that let less than this through have ended.
pub(super) const OPAQUE: f32 = 1.0 / 1024.0;

/// One plane's step.
struct Flight {
    from: Vec3,
    to: Vec3,
    v: Vec3,
}

#[inline(always)]
fn fly(u: &SweepUniforms, ray: &Ray) -> Flight {
    let (v, last) = (ray.direction, ray.position);
    let sigma = flight(v, u.step.distance);
    let straight = flight(v, u.step.behind - last.z);
    let from = Vec3::new(last.x + v.x * straight, last.y + v.y * straight, u.step.behind);
    let to = Vec3::new(from.x + v.x * sigma, from.y + v.y * sigma, u.step.ahead);
    Flight { from, to, v }
}

/// Whether the scalar on the plane behind was not sampled.
#[inline(always)]
fn is_unknown(u: &SweepUniforms, ray: &Ray) -> bool {
    ray.sampled != u.step.behind
}

/// The level that a ray needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    _light: &[u32],
) -> u32 {
    let ray = Ray::load(&record);
    let flight = fly(u, &ray);
    let hit = first_between(&u.receivers, flight.from, flight.to);
    let empty = step_is_empty::<V>(u, occupancy, flight.from, flight.to);
    let within = is_far_inside::<V>(u, chosen, flight.from, flight.to, MARGIN);
    let begins = mode::bends(chosen) & (ray.sampled == ray::NOWHERE);
    let sampled = if is_unknown(u, &ray) { level::ENTERING } else { level::FULL };
    let body = may_be_met::<V>(u, occupancy, flight.from, flight.to);
    let met = if hit.hit | body | (u.flags & flag::ISOSURFACES != 0) { level::MEETING } else { sampled };
    let crossing = if within & !begins { met } else { level::BORDER };
    let in_empty = if hit.hit { level::MEETING } else { level::EMPTY };
    let needed = if empty { in_empty } else { crossing };
    if ray.status == status::ACTIVE { needed } else { level::ENDED }
}

/// How many planes behind the next one a ray at level `EMPTY` will be at that level for certain, if they are as far apart and it is so on the
/// first `known` of them; without end if that is all planes there are.
#[inline(always)]
pub fn until<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    _mode: u32,
    record: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    _light: &[u32],
    known: f32,
) -> f32 {
    let ray = Ray::load(&record);
    let Flight { from, to, .. } = fly(u, &ray);
    let step = to - from;
    let empty = known + steps_are_empty::<V>(u, occupancy, from + step * known, to + step * known);
    let free = min(min(empty, free_steps(&u.receivers, from, to)), u.step.alike);
    let to_the_end = (u.flags & flag::LAST_STRETCH != 0) & (free >= u.step.alike);
    select((ray.status == status::ACTIVE) & !to_the_end, free, f32::MAX)
}

/// The ray one plane further.
#[inline(always)]
pub fn invoke<V: VoxelFormat, const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; ray::SIZE],
    voxels: &[u32],
    ior_voxels: &[u32],
    _occupancy: &[u32],
    tables: &[u32],
    light_buffer: &[u32],
) -> [f32; ray::SIZE] {
    let ray = Ray::load(&record);
    let Flight { from, to, v } = fly(u, &ray);
    let none = Hit { hit: false, is_wall: false, is_body: false, at: 1.0, normal: v, color: v };
    let mut hit = if LEVEL >= level::MEETING { first_between(&u.receivers, from, to) } else { none };
    if LEVEL >= level::MEETING && V::BODIES {
        hit = hit.or_nearer(first_body::<V>(u, ior_voxels, from, to));
    }
    let hit = hit;
    let voxel_from = voxel_coordinates(&u.grid, from);
    let mut front = ray.scalar;
    let mut ior_front = ray.ior;
    if LEVEL >= level::ENTERING {
        let unknown = is_unknown(u, &ray);
        let sampled = scalar::<V>(voxels, &u.grid, voxel_from);
        front = select(unknown, sampled, front);
        if mode::bends(chosen) {
            let bending = if V::SECOND {
                scalar::<V>(ior_voxels, &u.ior_grid, voxel_coordinates(&u.ior_grid, from))
            } else {
                sampled
            };
            ior_front = select(unknown, ior(tables, bending), ior_front);
        }
    }
    let mut crossing = Crossing::none(u, to, v, length(to - from));
    // The ray as it sets out from the plane behind.
    let mut departing = v;
    let mut began_inside = true;
    let mut filled = Span::WHOLE;
    if LEVEL >= level::MEETING {
        filled = span_inside(&u.grid, voxel_from, voxel_coordinates(&u.grid, to));
        crossing.path *= filled.length();
    }
    if LEVEL >= level::BORDER && mode::bends(chosen) {
        let meeting = meet::<V>(u, from, to);
        began_inside = is_inside(&meeting, ray.ior != 0.0);
        ior_front = select(began_inside, ior_front, 1.0);
        // A ray that begins inside: |v| = η from there on.
        let begins = (ray.sampled == ray::NOWHERE) & began_inside;
        departing = v * select(begins, ior_front, 1.0);
        let way = (from, to, departing);
        crossing = cross::<V>(u, Volumes { voxels, ior_voxels, tables }, way, &meeting, began_inside);
    }
    let (to, arriving) = (crossing.to, crossing.direction);
    let voxel_to = voxel_coordinates(&u.grid, to);
    let ior_to = voxel_coordinates(&u.ior_grid, to);
    let here = medium::<V>((&u.grid, &u.ior_grid), chosen, voxels, ior_voxels, tables, voxel_to, ior_to);

    let front_of_layer = front_of(&u.grid, front, here.scalar);
    // The segment ends on a receiver if it meets one.
    let part = select(hit.hit, min(hit.at, 1.0), 1.0);
    let kept = keep(u, from, to);
    let path = crossing.path * part * u.step.inverse_reference_length;
    let segment = if mode::is_clear(chosen) {
        segment_of_particles(tables, front_of_layer, here.scalar)
    } else {
        segment(tables, front_of_layer, here.scalar)
    };
    let tint = tint_of::<V>(ior_voxels, &u.grid, (voxel_from, voxel_to), &segment);
    let segment = segment.tinted::<V>(&tint);
    let layer = if mode::is_clear(chosen) {
        layer_of_particles(&segment, path * kept.particles.length())
    } else {
        layer(&segment, path * kept.particles.length(), path * kept.medium.length())
    };
    let looks_for_isosurfaces = LEVEL >= level::MEETING && are_looked_for(u);
    let mut sheet_in = Sheet::NONE;
    let (mut layer, mut share) = (layer, 0.0);
    if looks_for_isosurfaces {
        let before_receiver = kept.particles.within(Span { start: 0.0, end: part });
        let found = sheet(tables, front_of_layer, here.scalar, before_receiver);
        // Outside of the volume there is none.
        sheet_in = found.only_if(filled.length() > 0.0).within(filled).tinted::<V>(&tint);
        (layer, share) = layer.with(&sheet_in, segment.particles * (path * kept.particles.length()));
    }

    let met = if LEVEL >= level::MEETING { from + (to - from) * select(hit.hit, part, 0.0) } else { from };
    let light = if mode::is_unoccluded(chosen) {
        unoccluded(u, met)
    } else if mode::is_on_texels(chosen) {
        // The texels at a body's surface are in part inside it.
        let aside = hit.normal * select(hit.is_body, NEARER * u.light_grid.texel, 0.0);
        let (mut texel_x, mut texel_y) = texel_coordinates(u, met + aside);
        if LEVEL >= level::MEETING {
            // From the plane behind the light goes on to the receiver.
            let (x, y) = shift(u, direction(u, light_buffer, texel_x, texel_y), met.z - from.z);
            (texel_x, texel_y) = (texel_x - x, texel_y - y);
        }
        light(u, light_buffer, texel_x, texel_y, mode::is_clear(chosen))
    } else {
        let span = kept.particles.within(filled);
        let clear = layer.clear;
        let seen = Seen {
            from,
            to: from + (to - from) * part,
            front: front_of_layer,
            back: here.scalar,
            segment: &segment,
            span,
            clear,
            sheet: sheet_in.before(part),
            share,
            looks_for_isosurfaces,
            extinction: tint.extinction,
        };
        light_in_matter::<V>(u, chosen, (voxels, ior_voxels, tables, light_buffer), &seen)
    };
    let radiance = radiance(u, &light);
    let mut specular = Vec3::new(0.0, 0.0, 0.0);
    let mut reflected = Reflected::of(&ray);
    if mode::bends(chosen) && u.specular != 0.0 {
        let normal = select_vector(crossing.bent, crossing.face, here.scalar_gradient);
        let (before, behind) = if crossing.bent { crossing.iors } else { (ior_front, here.ior) };
        // A ray that ends on a receiver meets no surface, and outside of the volume its record has no η.
        let before = select(hit.hit, behind, before);
        let voxels = voxel_coordinates(bending_grid::<V>(u), to) - voxel_coordinates(bending_grid::<V>(u), from);
        let step = Crossed { normal, v: departing, before, behind, voxels: length(voxels), jumps: crossing.bent };
        let unknown = LEVEL >= level::ENTERING && is_unknown(u, &ray);
        let surface = surface(&ray, layer_ior(&ray, before, unknown), &step);
        let counts = select(hit.hit, 0.0, kept.refraction);
        let lobe = lobe(normal, light.direction, departing, u.roughness);
        let towards = lobe.radiance * added(&surface, &step, lobe.cosine);
        specular = radiance * (towards * u.specular * counts);
        reflected = reflected.with(&ray, &surface, min(u.specular, 1.0) * counts);
    }
    // Behind the first surface there is less light, by what it reflects.
    let before =
        Gathered { color: ray.color, opacity: ray.opacity, medium: ray.transmittance * (1.0 - ray.reflectance) };
    let by_gradient =
        if mode::bends(chosen) { u.flags & flag::SHADED_BY_GRADIENT != 0 } else { chosen == mode::SHADED_BY_GRADIENT };
    let facing = if by_gradient { cosine(&u.grid, here.shown_gradient, light.direction, v, share) } else { 1.0 };
    let after = over(before, &layer, radiance * facing + mean_radiance(&u.ambient), specular);
    let after = Gathered { medium: ray.transmittance * layer.medium, ..after };
    let seen_at = lerp(0.5, sheet_in.at, share);
    let depth = ray.depth + (after.opacity - before.opacity) * lerp(from.z, to.z, seen_at);
    let (after, depth) = if LEVEL >= level::MEETING {
        let received = if mode::is_on_texels(chosen) | mode::is_unoccluded(chosen) {
            light
        } else {
            light_on_surface::<V>(u, chosen, (voxels, tables, light_buffer), &hit, met)
        };
        let seen = shade(u, hit.normal, hit.color, &received) * (1.0 - reflected.reflectance);
        end_on_receiver(&hit, after, depth, seen, met.z)
    } else {
        (after, depth)
    };

    let mut out = arriving;
    let mut turned = false;
    if mode::bends(chosen) {
        let ahead = if LEVEL >= level::BORDER { share_ahead::<V>(u, to, arriving) } else { 0.5 };
        let bends = kept.refraction * select(crossing.inside, 1.0, 0.0);
        let kicked = turn(u, arriving, &here, bends, crossing.sigma, ahead);
        turned = kicked.turned | crossing.turned;
        out = select_vector(crossing.turned, arriving, kicked.direction);
    }
    let moved = hit.hit | crossing.bent | (out.x != v.x) | (out.y != v.y) | (out.z != v.z);
    let clearest = max(max(after.medium.x, after.medium.y), after.medium.z);
    let ended = hit.hit | ((1.0 - after.opacity) * clearest < OPAQUE);
    let fate = select(ended, status::ENDED, select(turned, status::TURNED, status::ACTIVE));
    // A ray that this step turns stays on the plane behind, from where `follow_rays` takes it on.
    let stays = (fate == status::TURNED) & !crossing.turned;

    let last = ray.position;
    let moved_to = Vec3::new(
        select(moved, stay(&hit, met.x, to.x), last.x),
        select(moved, stay(&hit, met.y, to.y), last.y),
        select(moved, stay(&hit, met.z, to.z), last.z),
    );
    let ior_after = select(crossing.inside & !hit.hit, here.ior, 0.0);
    let after = Ray {
        position: select_vector(stays, from, moved_to),
        direction: select_vector(stays, departing, out),
        scalar: select(stays, front, here.scalar),
        status: fate,
        depth: select(stays, ray.depth, depth),
        color: select_vector(stays, ray.color, after.color),
        opacity: select(stays, ray.opacity, after.opacity),
        transmittance: select_vector(stays, ray.transmittance, after.medium),
        ior: select(stays, select(began_inside, ior_front, 0.0), ior_after),
        sampled: select(stays, from.z, select(crossing.turned, ray::NOWHERE, to.z)),
        layer_ior: select(stays | hit.hit, ray.layer_ior, reflected.layer_ior),
        reflectance: select(stays, ray.reflectance, reflected.reflectance),
        mirrored: select_vector(stays, ray.mirrored, reflected.mirrored),
    };
    after.store()
}

/// A ray that ended on a receiver stays there.
#[inline(always)]
fn stay(hit: &Hit, there: f32, next: f32) -> f32 {
    select(hit.hit, there, next)
}

/// The light at `met` on the receiver that a ray hits, where a wavefront has carried it.
#[inline(always)]
pub(super) fn light_on_surface<V: VoxelFormat>(
    u: &SweepUniforms,
    chosen: u32,
    (voxels, tables, light): (&[u32], &[u32], &[u32]),
    hit: &Hit,
    met: Vec3,
) -> Light {
    let received = light_on(u, light, met, hit.is_wall);
    if !V::BODIES {
        return received;
    }
    let on_body = light_on_body::<V>(u, chosen, (voxels, tables, light), met, hit.normal);
    Light {
        flux: select_vector(hit.is_body, on_body.flux, received.flux),
        direction: select_vector(hit.is_body, on_body.direction, received.direction),
    }
}

/// Composites a receiver, which is opaque, behind a ray that ends on it.
#[inline(always)]
pub(super) fn end_on_receiver(hit: &Hit, g: Gathered, depth: f32, seen: Vec3, hit_depth: f32) -> (Gathered, f32) {
    let clear = 1.0 - g.opacity;
    let color = g.color + (g.medium * seen) * clear;
    (
        Gathered {
            color: select_vector(hit.hit, color, g.color),
            opacity: select(hit.hit, 1.0, g.opacity),
            medium: g.medium,
        },
        select(hit.hit, depth + clear * hit_depth, depth),
    )
}
