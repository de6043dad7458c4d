//! The wavefront that carries light forward: its frame, its grid of nodes, the bricks of the light that viewing rays look up, and the maps of
//! the light on receivers.

use super::vector::{Affine, Counts, Size, Vec3};

/// A wavefront. In its own frame light travels along z: from far away along the axis itself, from a point on the axis to all sides of it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Wavefront {
    /// x in the wavefront's frame of a point of the view frame.
    pub row_x: Affine,
    /// y in the wavefront's frame.
    pub row_y: Affine,
    /// z in the wavefront's frame: the depth of a plane.
    pub row_z: Affine,
    /// 1 if light comes from a point on the axis of the frame; 0 if it comes from far away.
    pub spherical: u32,
    /// Cells between nodes across and up.
    pub cells: Size,
    /// Coordinate of the first column of nodes, over the depth from the source if the wavefront is spherical.
    pub corner_x: f32,
    /// Coordinate of the first row of nodes, over the depth from the source if the wavefront is spherical.
    pub corner_y: f32,
    /// Edge of a cell, over the depth from the source if the wavefront is spherical.
    pub cell: f32,
    /// 1 / `cell`.
    pub inverse_cell: f32,
    /// Depth of the first plane.
    pub first_depth: f32,
    /// 1 / the planes' distance.
    pub inverse_step: f32,
    /// Position of the first sample of the light among the nodes: 0 at the first node, ½ in the middle of the first cell.
    pub first_sample: f32,
    /// Colours of a sample: 1 in a clear medium, else 3.
    pub colors: u32,
    /// Words of a sample: its colours and, where light bends, its direction as the last one.
    pub components: u32,
    /// Bricks of light along x, y and z.
    pub bricks: Counts,
    /// The bricks, counted along z, whose samples lie on the plane.
    pub layer: u32,
    /// The first word of the list of the bricks to which a plane is written, in the buffer of bricks.
    pub list: u32,
    /// Wide samples of a plane across and up: [`WIDE`] samples apart, and all over the grid. Their sums come before the ones of the bricks.
    pub wide: Size,
    /// The maps of receivers.
    pub map: ReceiverMap,
    /// Position of the source, on the axis, if the wavefront is spherical.
    pub source: Vec3,
    /// The cone of a spot.
    pub cone: SpotCone,
    /// Depth of the plane on which the light is an output.
    pub observed: f32,
    /// Units in 1 of the sums of light on a plane: so few that the light of all cells together is no number of more than 31 bits.
    pub units: f32,
    /// Tangent of the light's angular radius; 0 for a crisp light.
    pub softness: f32,
    /// The share of the blur between two planes on which light is kept that one pass of [`blur_nodes`](crate::sweep::blur_nodes) gives; 0 if nodes are
    /// not blurred.
    pub blur: f32,
}

/// The cone of a spot, told by tangents, so that all is linear on a wall across its axis.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct SpotCone {
    /// The cone's unit axis in the wavefront's frame.
    pub axis: Vec3,
    /// Tangent of the half-angle at which the light ends.
    pub tangent: f32,
    /// 1 over the difference of the tangents between which the light fades; 0 for a light that shines to all sides.
    pub slope: f32,
}

/// The maps of the light on ground and wall, which have the same size.
///
/// The coordinates of a point of a receiver are those of the unrefracted light that falls on it, in cells. Behind the ends of the grid texels widen,
/// so that a map reaches as far as light does.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ReceiverMap {
    /// Texels across and up.
    pub size: Size,
    /// Texels along the edge of a cell.
    pub texels: f32,
    /// Texels beyond each end of the grid.
    pub margin: f32,
    /// The first word of the ground's map in the buffer of light.
    pub ground: u32,
    /// The first word of the wall's map in the buffer of light.
    pub wall: u32,
}

/// Samples along the edge of a brick of light, besides the ones that it shares with the next brick.
pub const BRICK: u32 = 8;
/// Samples along the edge of a brick as it is stored: look-ups need no other brick.
pub const STORED: u32 = BRICK + 1;
/// Samples from a wide sample to the next one.
pub const WIDE: u32 = 4;
/// Samples of a brick on a plane.
pub const LAYER: u32 = STORED * STORED;
/// Words of a brick's entry in the buffer of bricks: its first word in the buffer of light, the bricks of its planes, and its number among them,
/// counted from 1.
pub const ENTRY: u32 = 3;
/// The number of bricks on a plane is a multiple of this number.
pub const BRICKS_TOGETHER: u32 = 16;
/// The alignment of the words of a plane in the buffer of light.
pub const PLANE_ALIGNMENT: u32 = 64;

/// The words from a plane to the next one of `bricks` bricks with `components` words a sample.
#[must_use]
#[inline(always)]
pub const fn plane_words(bricks: u32, components: u32) -> u32 {
    (bricks * LAYER * components + PLANE_ALIGNMENT - 1) & !(PLANE_ALIGNMENT - 1)
}
