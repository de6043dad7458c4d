//! Viewing rays that the plane sweep cannot follow, since they turn back or graze the planes: one by one, in steps along the ray, until they
//! leave the volume (not in the paper, whose sweep ends them).
//!
//! The step is kick–drift–kick over dσ = ds/η ([`crate::optics::step`] for steps from plane to plane), and shorter where η changes fast. Of
//! light on texels the latest planes alone are known: what the ray meets on its way is then lit as if nothing were in the way. No surface shows a
//! highlight on it: a ray that is guided along a surface would gather one at each step.

use crate::abi::format::VoxelFormat;
use crate::abi::record::{Ray, ray, status};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::colors::tint_of;
use crate::field::stencil::{front_of, voxel_coordinates};
use crate::field::tables::segment;
use crate::math::{clamp, length, lerp, max, select, select_vector, xyz};
use crate::optics::ambient::mean_radiance;
use crate::optics::composite::{Gathered, layer, over};
use crate::optics::diffuse::cosine;
use crate::optics::isosurfaces::{Sheet, sheet};
use crate::optics::medium::{Medium, medium, span_inside};
use crate::optics::receiver::{Hit, first_between};
use crate::optics::span::Span;
use crate::optics::step::flight;
use crate::sweep::bodies::first_body;
use crate::sweep::border::{bend, border_ior, meet, share_ahead};
use crate::sweep::clip::keep;
use crate::sweep::isosurfaces::are_looked_for;
use crate::sweep::light::look_up::{radiance, shade, unoccluded};
use crate::sweep::light::matter::{Seen, light_in_matter};
use crate::sweep::propagate_rays::{OPAQUE, end_on_receiver, light_on_surface};
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The ray is none that is followed.
    pub const ENDED: u32 = 0;
    /// The ray is followed.
    pub const WORK: u32 = 3;
}

/// Steps of a ray in one pass.
pub const STEPS: i32 = 64;
/// The largest share of |v| by which a step changes v.
const TURN: f32 = 0.05;
/// The shortest step over the planes' distance.
const SHORTEST: f32 = 1.0 / 16.0;

/// The level that a ray needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    _u: &SweepUniforms,
    _mode: u32,
    record: [f32; ray::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    _occupancy: &[u32],
    _tables: &[u32],
    _light: &[u32],
) -> u32 {
    let fate = record[ray::STATUS];
    if (fate == status::TURNED) | (fate == status::FOLLOWED) { level::WORK } else { level::ENDED }
}

/// A length that no way through the volume has, world units.
#[inline(always)]
fn beyond(u: &SweepUniforms) -> f32 {
    let size = u.grid.size;
    4.0 * (size.x + size.y + size.z) / length(xyz(u.grid.row_x.factors))
}

/// The medium at a point of the view frame.
#[inline(always)]
fn around<V: VoxelFormat>(
    u: &SweepUniforms,
    chosen: u32,
    voxels: &[u32],
    ior_voxels: &[u32],
    tables: &[u32],
    at: Vec3,
) -> Medium {
    let (shown, bending) = (voxel_coordinates(&u.grid, at), voxel_coordinates(&u.ior_grid, at));
    medium::<V>((&u.grid, &u.ior_grid), chosen, voxels, ior_voxels, tables, shown, bending)
}

/// The ray after some steps.
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
    let mut ray = Ray::load(&record);
    let mut here = around::<V>(u, chosen, voxels, ior_voxels, tables, ray.position);
    let mut kept = keep(u, ray.position, ray.position).refraction;
    if ray.status == status::TURNED {
        ray.status = status::FOLLOWED;
        // On its plane the ray got the first half of the kick of a step that it did not do.
        let due = select(ray.sampled == ray::NOWHERE, 0.0, share_ahead::<V>(u, ray.position, ray.direction));
        let sigma = flight(ray.direction, u.step.distance) * select(ray.ior == 0.0, 0.0, kept);
        ray.direction -= here.acceleration * (due * sigma);
    }
    let none = Vec3::new(0.0, 0.0, 0.0);
    let open = unoccluded(u, ray.position);
    let mut step = 0;
    while (step < STEPS) & (ray.status == status::FOLLOWED) {
        step += 1;
        let inside = ray.ior != 0.0;
        let (from, v) = (ray.position, ray.direction);
        let acceleration = here.acceleration * select(inside, kept, 0.0);
        let speed = max(length(v), 1e-6);
        let straight = TURN * speed * speed / max(length(acceleration), 1e-20);
        let short = clamp(straight, SHORTEST * u.step.distance, u.step.distance);
        let sigma = select(inside, short, beyond(u)) / speed;
        let flying = v + acceleration * (0.5 * sigma);
        let whole = from + flying * sigma;
        let meeting = meet::<V>(u, from, whole);
        let crosses = meeting.happens(inside);
        if !inside & !crosses {
            ray.status = status::LEFT;
        } else {
            let (share, face) = if inside { (meeting.leaves, meeting.left) } else { (meeting.enters, meeting.entered) };
            let to = from + (whole - from) * select(crosses, share, 1.0);
            let mut hit = first_between(&u.receivers, from, to);
            if V::BODIES {
                // Steps outside of the volume are too long to find a body in.
                let body = first_body::<V>(u, ior_voxels, from, to);
                hit = hit.or_nearer(Hit { hit: body.hit & inside, ..body });
            }
            let hit = hit;
            let next = around::<V>(u, chosen, voxels, ior_voxels, tables, to);
            let shares = keep(u, from, to);
            // On the border the whole kick of the way so far is due, inside the second half.
            let arriving = flying + acceleration * (select(crosses, share - 0.5, 0.0) * sigma);
            let eta = border_ior::<V>(u, voxels, ior_voxels, tables, to);
            let iors = if inside { (eta, 1.0) } else { (1.0, eta) };
            let bent = bend(arriving, face, iors.1 * iors.1 - iors.0 * iors.0);
            let stays_inside = inside != (crosses & !bent.reflected);
            let kicked = arriving + next.acceleration * (0.5 * sigma * shares.refraction);
            let out = select_vector(crosses, bent.direction, kicked);

            let front = front_of(&u.grid, select(inside, ray.scalar, next.scalar), next.scalar);
            let (voxel_from, voxel_to) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
            let part = select(hit.hit, hit.at, 1.0);
            let filled = span_inside(&u.grid, voxel_from, voxel_to);
            let path = length(to - from) * filled.length() * part;
            let path = path * u.step.inverse_reference_length;
            let segment = segment(tables, front, next.scalar);
            let tint = tint_of::<V>(ior_voxels, &u.grid, (voxel_from, voxel_to), &segment);
            let segment = segment.tinted::<V>(&tint);
            let layer = layer(&segment, path * shares.particles.length(), path * shares.medium.length());
            let looks_for_isosurfaces = are_looked_for(u);
            let mut sheet_in = Sheet::NONE;
            let (mut layer, mut share) = (layer, 0.0);
            if looks_for_isosurfaces {
                let before_receiver = shares.particles.within(Span { start: 0.0, end: part });
                let found = sheet(tables, front, next.scalar, before_receiver);
                sheet_in = found.only_if(filled.length() > 0.0).within(filled).tinted::<V>(&tint);
                (layer, share) = layer.with(&sheet_in, segment.particles * (path * shares.particles.length()));
            }
            let light = if mode::is_on_texels(chosen) {
                open
            } else {
                let span = shares.particles.within(filled);
                let (clear, to) = (layer.clear, from + (to - from) * part);
                let sheet = sheet_in.before(part);
                let back = next.scalar;
                let seen = Seen {
                    from,
                    to,
                    front,
                    back,
                    segment: &segment,
                    span,
                    clear,
                    sheet,
                    share,
                    looks_for_isosurfaces,
                    extinction: tint.extinction,
                };
                light_in_matter::<V>(u, chosen, (voxels, ior_voxels, tables, light_buffer), &seen)
            };
            let radiance = radiance(u, &light);
            let through = 1.0 - ray.reflectance;
            let before = Gathered { color: ray.color, opacity: ray.opacity, medium: ray.transmittance * through };
            let by_gradient = u.flags & flag::SHADED_BY_GRADIENT != 0;
            let facing =
                if by_gradient { cosine(&u.grid, next.shown_gradient, light.direction, v, share) } else { 1.0 };
            let after = over(before, &layer, radiance * facing + mean_radiance(&u.ambient), none);
            let after = Gathered { medium: ray.transmittance * layer.medium, ..after };
            let seen_at = lerp(0.5, sheet_in.at, share);
            let depth = ray.depth + (after.opacity - before.opacity) * lerp(from.z, to.z, seen_at);
            let met = from + (to - from) * part;
            let received = light_on_surface::<V>(u, chosen, (voxels, tables, light_buffer), &hit, met);
            let (after, depth) =
                end_on_receiver(&hit, after, depth, shade(u, hit.normal, hit.color, &received) * through, met.z);
            let clearest = max(max(after.medium.x, after.medium.y), after.medium.z);
            let ended = hit.hit | ((1.0 - after.opacity) * clearest < OPAQUE);
            ray = Ray {
                position: select_vector(hit.hit, met, to),
                direction: out,
                scalar: next.scalar,
                status: select(ended, status::ENDED, status::FOLLOWED),
                depth,
                color: after.color,
                opacity: after.opacity,
                transmittance: after.medium,
                ior: select(stays_inside, next.ior, 0.0),
                sampled: ray::NOWHERE,
                ..ray
            };
            here = next;
            kept = shares.refraction;
        }
    }
    ray.store()
}
