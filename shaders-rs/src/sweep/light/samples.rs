//! The light at a sample of a plane: of the cell in whose place it is, and of cells that were scattered.

use crate::abi::record::{cover, covered, sums};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::abi::wavefront::{WIDE, Wavefront};
use crate::field::access::read;
use crate::field::sums::both;
use crate::math::{max, select, select_vector};
use crate::sweep::light::bricks::{place, sample, wide_place};
use crate::sweep::light::offset::pack_difference;
use crate::sweep::light::placed::{cone_of, density_of_cell};
use crate::sweep::light::wavefront::flux;
use spirv_std::glam::{Vec2, Vec3};

/// Light around a sample.
#[derive(Clone, Copy)]
pub struct Sample {
    /// Fluence over that of unoccluded light.
    pub share: Vec3,
    /// The direction's difference from the direction of unrefracted light, as [`crate::sweep::light::offset`] packs it.
    pub direction: f32,
}

/// Where light is unoccluded.
const UNOCCLUDED: Vec3 = Vec3::new(1.0, 1.0, 1.0);

#[inline(always)]
fn mean(color: Vec3) -> f32 {
    (color.x + color.y + color.z) * (1.0 / 3.0)
}

/// Light of the cell in whose place sample (x, y) is, if it stays there, and the fluence times the difference of its direction.
#[inline(always)]
fn of_cell(u: &SweepUniforms, covered_in: &[f32], x: i32, y: i32) -> (Vec3, Vec2) {
    let (width, height) = (u.wavefront.cells.width as i32, u.wavefront.cells.height as i32);
    let inside = (x >= 0) & (x < width) & (y >= 0) & (y < height);
    let at = if inside { y * width + x } else { 0 };
    let count = width * height;
    let stays = read(covered_in, covered::SAMPLES as i32 * count + at) == cover::STAYS;
    let counts = select(inside & stays, 1.0, 0.0);
    let fluence = Vec3::new(
        read(covered_in, covered::FLUENCE as i32 * count + at),
        read(covered_in, (covered::FLUENCE + 1) as i32 * count + at),
        read(covered_in, (covered::FLUENCE + 2) as i32 * count + at),
    );
    let aside = Vec2::new(
        read(covered_in, covered::ASIDE_X as i32 * count + at),
        read(covered_in, covered::ASIDE_Y as i32 * count + at),
    );
    (select_vector(inside, fluence * counts, UNOCCLUDED), aside * counts)
}

/// Light of the node in whose place sample (x, y) is, where nothing bends it.
#[inline(always)]
fn of_node(u: &SweepUniforms, nodes: &[f32], x: i32, y: i32) -> Vec3 {
    let w = &u.wavefront;
    let inside = (x >= 0) & (x <= w.cells.width as i32) & (y >= 0) & (y <= w.cells.height as i32);
    let (i, j) = if inside { (x as u32, y as u32) } else { (0, 0) };
    select_vector(inside, flux(w, nodes, i, j), UNOCCLUDED)
}

/// Light that cells brought, and the fluence times the difference of its direction, in units.
#[derive(Clone, Copy)]
struct Brought {
    fluence: Vec3,
    aside: Vec2,
}

/// The sums in a place, times `weight`.
#[inline(always)]
fn brought(chosen: u32, sums_in: &[u32], place: i32, weight: f32) -> Brought {
    let base = place * sums::SIZE as i32;
    let (red, green) = both(sums_in, base + sums::RED_AND_GREEN as i32);
    let (x, y) = both(sums_in, base + sums::DIRECTION as i32);
    let fluence = if mode::is_clear(chosen) {
        Vec3::new(red, red, red)
    } else {
        Vec3::new(red, green, both(sums_in, base + sums::BLUE as i32).0)
    };
    let weight = select(place >= 0, weight, 0.0);
    Brought { fluence: fluence * weight, aside: Vec2::new(x, y) * weight }
}

#[inline(always)]
fn sum(a: Brought, b: Brought) -> Brought {
    Brought { fluence: a.fluence + b.fluence, aside: a.aside + b.aside }
}

/// Light that far-stretched cells brought to sample (x, y): between the four wide samples around it.
#[inline(always)]
fn brought_widely(w: &Wavefront, chosen: u32, sums_in: &[u32], x: i32, y: i32) -> Brought {
    let shift = WIDE.trailing_zeros();
    let (i, j) = (x >> shift, y >> shift);
    let across = (x - (i << shift)) as f32 * (1.0 / WIDE as f32);
    let up = (y - (j << shift)) as f32 * (1.0 / WIDE as f32);
    let below = sum(
        brought(chosen, sums_in, wide_place(w, i, j), (1.0 - across) * (1.0 - up)),
        brought(chosen, sums_in, wide_place(w, i + 1, j), across * (1.0 - up)),
    );
    let above = sum(
        brought(chosen, sums_in, wide_place(w, i, j + 1), (1.0 - across) * up),
        brought(chosen, sums_in, wide_place(w, i + 1, j + 1), across * up),
    );
    sum(below, above)
}

/// The light at sample `index` of the bricks in the plane's list. `light` are the wavefront's nodes where nothing bends it, else
/// the samples that its cells cover.
///
/// Where nothing bends the light of a spot, its cone is not in it.
#[inline(always)]
pub fn light(u: &SweepUniforms, chosen: u32, sums_in: &[u32], light: &[f32], bricks: &[u32], index: u32) -> Sample {
    let w = &u.wavefront;
    let (x, y) = sample(w, bricks, index);
    if mode::bends(chosen) {
        let (own, its_aside) = of_cell(u, light, x, y);
        let (column, row) = (x as f32, y as f32);
        let density = density_of_cell(w, column, row);
        let inside = (x >= 0) & (x < w.cells.width as i32) & (y >= 0) & (y < w.cells.height as i32);
        let there = own * select(inside, 1.0, density * cone_of(w, column + 0.5, row + 0.5));
        let near = brought(chosen, sums_in, place(w, bricks, x, y), 1.0);
        let found = sum(near, brought_widely(w, chosen, sums_in, x, y));
        let unit = 1.0 / w.units;
        let flux = there + found.fluence * unit;
        let weight = mean(flux);
        // Less than a few units of light tell no direction.
        let inverse = select(weight > 1e-4, 1.0 / max(weight, 1e-4), 0.0);
        let across = (its_aside.x + found.aside.x * unit) * inverse;
        let up = (its_aside.y + found.aside.y * unit) * inverse;
        Sample { share: flux * (1.0 / density), direction: pack_difference(across, up) }
    } else {
        Sample { share: of_node(u, light, x, y), direction: pack_difference(0.0, 0.0) }
    }
}
