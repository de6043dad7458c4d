//! A beam in the picture: its edge functions by the axes along which it is drawn, and its width across them.

use super::picture::{Edge, Edges};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, projection};
use crate::abi::vector::Size;
use crate::field::access::read;
use crate::math::{absolute, select};
use spirv_std::glam::Vec3;

/// An edge function along the picture's axes in the order of a beam: the major axis first, along which it changes more slowly.
#[derive(Clone, Copy)]
pub struct Across {
    /// Factor of the coordinate along the major axis.
    pub major: f32,
    /// Factor of the coordinate along the minor axis.
    pub minor: f32,
    /// The value at the first pixel's centre.
    pub constant: f32,
}

impl Across {
    /// The edge function by these axes; `steep` where the major axis points downwards.
    #[inline(always)]
    pub fn new(edge: Edge, steep: bool) -> Self {
        Self { major: select(steep, edge.y, edge.x), minor: select(steep, edge.x, edge.y), constant: edge.constant }
    }

    /// The factors along the major and the minor axis, and the constant.
    #[inline(always)]
    pub fn vector(&self) -> Vec3 {
        Vec3::new(self.major, self.minor, self.constant)
    }

    /// The value at a place.
    #[inline(always)]
    pub fn at(&self, major: f32, minor: f32) -> f32 {
        self.major * major + (self.minor * minor + self.constant)
    }
}

/// A beam in the picture.
#[derive(Clone, Copy)]
pub struct Drawn {
    /// Whether the major axis is that of the columns' own direction, downwards.
    pub steep: bool,
    /// 0 where the beam's middle is.
    pub middle: Across,
    /// Change over the texel along its first coordinate.
    pub change_u: Across,
    /// Change along its second coordinate.
    pub change_v: Across,
    /// Change of the edge function from pixel to pixel along the minor axis.
    pub filter: f32,
}

/// A beam at one place along the major axis.
#[derive(Clone, Copy)]
pub struct Section {
    /// Its middle along the minor axis.
    pub middle: f32,
    /// Width of one box across the edge function.
    pub first: f32,
    /// Width of the other one.
    pub second: f32,
}

impl Drawn {
    /// The beam in the picture.
    #[inline(always)]
    pub fn new(u: &BeamsUniforms, beam: &Beam) -> Self {
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

    /// The projection of beam number `number` of `count`; projections begin at float `first`.
    #[inline(always)]
    pub fn of(projections: &[f32], first: i32, number: i32, count: i32) -> Self {
        let component = |component: usize| read(projections, first + component as i32 * count + number);
        let across = |at: usize| Across { major: component(at), minor: component(at + 1), constant: component(at + 2) };
        let middle = across(projection::MIDDLE);
        Self {
            steep: component(projection::STEEP) > 0.0,
            middle,
            change_u: across(projection::CHANGE_U),
            change_v: across(projection::CHANGE_V),
            filter: absolute(middle.minor),
        }
    }

    /// The beam at the place `major` along the major axis.
    #[inline(always)]
    pub fn section(&self, major: f32) -> Section {
        let middle = -(self.middle.major * major + self.middle.constant) / self.middle.minor;
        self.section_at(major, middle)
    }

    /// The beam at a place, whose middle is taken to be there.
    #[inline(always)]
    pub fn section_at(&self, major: f32, minor: f32) -> Section {
        Section {
            middle: minor,
            first: absolute(self.change_u.at(major, minor)),
            second: absolute(self.change_v.at(major, minor)),
        }
    }

    /// Half the width of the beam's picture along the minor axis, with pixels `edge` wide.
    #[inline(always)]
    pub fn half_width(&self, section: &Section, edge: f32) -> f32 {
        0.5 * (section.first + section.second) / self.filter + 0.5 * edge
    }

    /// Column and row of a place in the picture.
    #[inline(always)]
    pub fn place(&self, major: f32, minor: f32) -> (f32, f32) {
        (select(self.steep, minor, major), select(self.steep, major, minor))
    }

    /// Column and row of a pixel.
    #[inline(always)]
    pub fn pixel(&self, major: i32, minor: i32) -> (i32, i32) {
        if self.steep { (minor, major) } else { (major, minor) }
    }

    /// Pixels of a size along the major axis and along the minor one.
    #[inline(always)]
    pub fn along_axes(&self, size: Size) -> (i32, i32) {
        self.pixel(size.width as i32, size.height as i32)
    }
}
