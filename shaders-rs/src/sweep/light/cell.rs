//! Cells of the wavefront on a plane, between four projected nodes.

use crate::abi::record::{course, projected};
use crate::abi::wavefront::Wavefront;
use crate::field::access::read;
use crate::math::{absolute, max, min, select};
use crate::sweep::light::wavefront::{columns, nodes};
use spirv_std::glam::{Vec2, Vec3};

/// The least area, in samples, of a cell whose light the samples inside find.
pub const SMALLEST: f32 = 0.5;
/// Farther than any sample.
pub const FAR: f32 = 65536.0;

/// A node on the plane.
#[derive(Clone, Copy)]
pub struct Corner {
    /// Place among the samples of the plane.
    pub at: Vec2,
    /// Fluence over that of unoccluded light.
    pub fluence: Vec3,
    /// Difference of the unit direction from the direction of unrefracted light, x and y.
    pub aside: Vec2,
    /// One of [`course`].
    pub course: f32,
}

/// Node (x, y).
#[inline(always)]
pub fn corner(w: &Wavefront, buffer: &[f32], x: u32, y: u32) -> Corner {
    let count = nodes(w) as i32;
    let at = (y * columns(w) + x) as i32;
    let component = |c: usize| read(buffer, c as i32 * count + at);
    Corner {
        at: Vec2::new(component(projected::X), component(projected::Y)),
        fluence: Vec3::new(
            component(projected::FLUENCE),
            component(projected::FLUENCE + 1),
            component(projected::FLUENCE + 2),
        ),
        aside: Vec2::new(component(projected::ASIDE_X), component(projected::ASIDE_Y)),
        course: component(projected::COURSE),
    }
}

impl Corner {
    /// Fluence, mean of the colours, times the difference of the direction.
    #[inline(always)]
    pub fn fluence_aside(&self) -> Vec2 {
        self.aside * ((self.fluence.x + self.fluence.y + self.fluence.z) * (1.0 / 3.0))
    }
}

/// Twice the signed area of a triangle.
#[inline(always)]
fn turn(a: Vec2, b: Vec2, c: Vec2) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// Four nodes: b beside a, c above a, d above b.
#[derive(Clone, Copy)]
pub struct Cell {
    /// The first node.
    pub a: Corner,
    /// The node beside it.
    pub b: Corner,
    /// The node above it.
    pub c: Corner,
    /// The node above the second one.
    pub d: Corner,
}

/// Cell (x, y).
#[inline(always)]
pub fn cell(w: &Wavefront, buffer: &[f32], x: u32, y: u32) -> Cell {
    Cell {
        a: corner(w, buffer, x, y),
        b: corner(w, buffer, x + 1, y),
        c: corner(w, buffer, x, y + 1),
        d: corner(w, buffer, x + 1, y + 1),
    }
}

/// Whether a corner is less than half a sample from where unrefracted light would be.
#[inline(always)]
fn is_near(corner: &Corner, x: f32, y: f32) -> bool {
    (absolute(corner.at.x - x) < 0.5) & (absolute(corner.at.y - y) < 0.5) & (corner.course != course::TURNED)
}

/// The range of places at which edges cross the line of samples at height `y`, widened by the edge from `p` to `q`.
#[inline(always)]
pub fn crossed(p: Vec2, q: Vec2, y: f32, range: (f32, f32)) -> (f32, f32) {
    let x = p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
    let crosses = (p.y <= y) != (q.y <= y);
    (select(crosses, min(range.0, x), range.0), select(crosses, max(range.1, x), range.1))
}

/// The range of places at which the edges of a quadrilateral cross the line of samples at height `y`; its ends are in the wrong order if none does.
#[inline(always)]
pub fn crossed_by(cell: &Cell, y: f32) -> (f32, f32) {
    let Cell { a, b, c, d } = cell;
    let range = crossed(b.at, d.at, y, crossed(a.at, b.at, y, (FAR, -FAR)));
    crossed(c.at, a.at, y, crossed(d.at, c.at, y, range))
}

impl Cell {
    /// The least and the largest place of its corners.
    #[inline(always)]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        let (a, b, c, d) = (self.a.at, self.b.at, self.c.at, self.d.at);
        let low = Vec2::new(min(min(a.x, b.x), min(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
        let high = Vec2::new(max(max(a.x, b.x), max(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
        (low, high)
    }

    /// Its area, in samples.
    #[inline(always)]
    pub fn area(&self) -> f32 {
        let (ad, bc) = (self.d.at - self.a.at, self.c.at - self.b.at);
        0.5 * absolute(ad.x * bc.y - ad.y * bc.x)
    }

    /// Whether cell (x, y) covers the sample in its place and no other one: that sample then finds its light without a sum.
    #[inline(always)]
    pub fn stays(&self, x: u32, y: u32) -> bool {
        let (left, below) = (x as i32 as f32 - 0.5, y as i32 as f32 - 0.5);
        let near = is_near(&self.a, left, below)
            & is_near(&self.b, left + 1.0, below)
            & is_near(&self.c, left, below + 1.0)
            & is_near(&self.d, left + 1.0, below + 1.0);
        near & (self.area() >= SMALLEST)
    }

    /// Whether nothing has bent its light.
    #[inline(always)]
    pub fn is_straight(&self) -> bool {
        (self.a.course + self.b.course) + (self.c.course + self.d.course) == course::STRAIGHT
    }

    /// Whether it is a convex quadrilateral, none of whose light turned back.
    #[inline(always)]
    pub fn is_convex(&self) -> bool {
        let Self { a, b, c, d } = self;
        let (at_a, at_b) = (turn(c.at, a.at, b.at), turn(a.at, b.at, d.at));
        let (at_d, at_c) = (turn(b.at, d.at, c.at), turn(d.at, c.at, a.at));
        let left = (at_a > 0.0) & (at_b > 0.0) & (at_c > 0.0) & (at_d > 0.0);
        let right = (at_a < 0.0) & (at_b < 0.0) & (at_c < 0.0) & (at_d < 0.0);
        let returns = |corner: &Corner| corner.course == course::TURNED;
        (left | right) & !(returns(a) | returns(b) | returns(c) | returns(d))
    }

    /// The sum of its corners' fluence times the difference of the direction.
    #[inline(always)]
    pub fn fluence_aside(&self) -> Vec2 {
        (self.a.fluence_aside() + self.b.fluence_aside()) + (self.c.fluence_aside() + self.d.fluence_aside())
    }

    /// The sum of its corners' fluence.
    #[inline(always)]
    pub fn fluence(&self) -> Vec3 {
        (self.a.fluence + self.b.fluence) + (self.c.fluence + self.d.fluence)
    }
}
