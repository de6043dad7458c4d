//! A bounding volume hierarchy of triangles, in depth-first order, so that a ray walks it without a stack.

use super::bodies::Body;
use super::normals::of_corners;
use crate::error::Error;
use crate::method::voxelize::Grid;
use crate::unrenderable::Unrenderable;
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use bvh::flat_bvh::FlatNode;
use nalgebra::Point3;
use rayon::prelude::*;
use vitrum_kernels::abi::voxels::{corner, node};

/// Least margin of a box around its triangles, in voxels: above the rounding errors of rays.
pub(super) const MARGIN: f32 = 2e-3;

/// The only node of a tree without triangles: a box that no ray enters.
const NOTHING: [f32; node::SIZE] = [1e30, 1e30, 1e30, -1e30, -1e30, -1e30, -1.0, 1.0];

/// A tree, as kernels read it.
pub(super) struct Tree {
    pub nodes: Vec<f32>,
    pub corners: Vec<f32>,
}

struct Shape {
    bounds: Aabb<f32, 3>,
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// Largest number of triangles of a tree: kernels keep the numbers of its nodes, two a triangle, as floats, which hold whole numbers to
/// 2²⁴.
const MOST_TRIANGLES: usize = 1 << 23;

impl Tree {
    /// The number of nodes.
    pub fn count(&self) -> u32 {
        (self.nodes.len() / node::SIZE) as u32
    }
}

/// The margin around triangles where rays look for them up to `reach` voxels beside their boxes.
pub(super) fn margin(reach: f32) -> f32 {
    reach.max(MARGIN)
}

/// Checks the number of triangles against [`MOST_TRIANGLES`].
fn check(triangles: usize) -> Result<(), Error> {
    if triangles < MOST_TRIANGLES {
        return Ok(());
    }
    Err(Unrenderable::TooManyTriangles { count: triangles, limit: MOST_TRIANGLES }.into())
}

/// Builds the tree of the triangles of `bodies` from number `first` on; `smooth` makes normals for a mesh that has none. Rays look for triangles
/// up to `reach` voxels beside their boxes.
///
/// # Errors
/// If there are too many.
pub(super) fn build(bodies: &[Body], first: usize, grid: Grid, smooth: bool, reach: f32) -> Result<Tree, Error> {
    check(bodies.iter().skip(first).map(|body| body.mesh.triangles.len()).sum())?;
    let corners = corners(bodies, first, grid, smooth);
    if corners.is_empty() {
        return Ok(Tree { nodes: NOTHING.to_vec(), corners: vec![0.0; corner::SIZE] });
    }
    let margin = margin(reach);
    let mut shapes: Vec<Shape> = corners
        .chunks_exact(corner::SIZE)
        .map(|triangle| Shape { bounds: bounds(triangle, margin), node: 0 })
        .collect();
    let flat = Bvh::build(&mut shapes).flatten();
    Ok(Tree { nodes: threaded(&flat, &shapes), corners })
}

/// The records of the triangles of `bodies` from number `first` on, in the order of the bodies' triangles.
pub(super) fn corners(bodies: &[Body], first: usize, grid: Grid, smooth: bool) -> Vec<f32> {
    let mut floats = Vec::new();
    for (number, body) in bodies.iter().enumerate().skip(first) {
        let begin = floats.len();
        floats.resize(begin + body.mesh.triangles.len() * corner::SIZE, 0.0);
        let records = floats[begin..].par_chunks_exact_mut(corner::SIZE);
        let normals = of_corners(&body.mesh, smooth);
        records.zip(&body.mesh.triangles).zip(&normals).for_each(|((record, triangle), normals)| {
            let at = |vertex: u32| grid.to_voxels(body.mesh.positions[vertex as usize]).map(|x| x as f32);
            record[corner::POSITIONS..][..9].copy_from_slice(triangle.map(at).as_flattened());
            record[corner::NORMALS..][..9].copy_from_slice(normals.as_flattened());
            record[corner::MATERIAL] = number as f32;
        });
    }
    floats
}

/// The box around the triangle of a record, and `margin` voxels around it.
pub(super) fn bounds(triangle: &[f32], margin: f32) -> Aabb<f32, 3> {
    let mut bounds = Aabb::empty();
    for corner in triangle[..9].chunks_exact(3) {
        bounds.grow_mut(&Point3::new(corner[0] - margin, corner[1] - margin, corner[2] - margin));
        bounds.grow_mut(&Point3::new(corner[0] + margin, corner[1] + margin, corner[2] + margin));
    }
    bounds
}

/// The nodes in depth-first order. A leaf of the library has no box, and a node above it that has: these become one.
fn threaded(flat: &[FlatNode<f32, 3>], shapes: &[Shape]) -> Vec<f32> {
    let leads_to_leaf = |node: &FlatNode<f32, 3>| !node.is_leaf() && flat[node.entry_index as usize].is_leaf();
    // Where each node goes.
    let mut places = Vec::with_capacity(flat.len() + 1);
    let mut count = 0;
    for node in flat {
        places.push(count);
        count += u32::from(!leads_to_leaf(node));
    }
    places.push(count);
    let mut floats = Vec::with_capacity(count as usize * node::SIZE);
    for node in flat.iter().filter(|node| !leads_to_leaf(node)) {
        let (bounds, triangle) = if node.is_leaf() {
            (shapes[node.shape_index as usize].bounds, node.shape_index as f32)
        } else {
            (node.aabb, -1.0)
        };
        floats.extend(bounds.min.iter().chain(bounds.max.iter()));
        floats.extend([triangle, places[node.exit_index as usize] as f32]);
    }
    floats
}
