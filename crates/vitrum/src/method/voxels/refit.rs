//! Refits a tree of triangles to corners that have moved: the order of triangles and nodes stays, boxes are made anew.
//!
//! The nodes of a subtree follow its own node, so that a tree falls into ranges of nodes that need nothing of one another, and a walk back through a
//! range meets every node after those inside it.

use super::tree::bounds;
use bvh::aabb::Aabb;
use rayon::prelude::*;
use std::ops::Range;
use vitrum_kernels::abi::voxels::{corner, node};

/// Nodes of the largest range that one thread refits: some hundred ranges for a hundred thousand triangles, each long enough that handing it
/// over costs nothing.
const MOST: usize = 2048;

/// Floats of a node before the number of its triangle.
const BOX: usize = 6;

/// Makes all boxes anew for `corners`, with `margin` voxels around triangles. The boxes are those, to the bit, that a tree with this
/// order is built with.
pub(super) fn refit(nodes: &mut [f32], corners: &[f32], margin: f32) {
    let (ranges, above) = cut(nodes);
    let mut rest = &mut *nodes;
    let mut first = 0;
    let mut parts = Vec::with_capacity(ranges.len());
    for Range { start, end } in ranges {
        let (_, behind) = std::mem::take(&mut rest).split_at_mut((start - first) * node::SIZE);
        let (part, behind) = behind.split_at_mut((end - start) * node::SIZE);
        parts.push((start, part));
        (rest, first) = (behind, end);
    }
    parts.into_par_iter().for_each(|(start, part)| {
        for index in (0..part.len() / node::SIZE).rev() {
            refit_one(part, start, index, corners, margin);
        }
    });
    for index in above.into_iter().rev() {
        refit_one(nodes, 0, index, corners, margin);
    }
}

/// The subtrees of at most [`MOST`] nodes that are in no other such one, and the nodes above them, both in the order of nodes.
fn cut(nodes: &[f32]) -> (Vec<Range<usize>>, Vec<usize>) {
    let (mut ranges, mut above) = (Vec::new(), Vec::new());
    let mut index = 0;
    while index < nodes.len() / node::SIZE {
        let end = exit(nodes, 0, index);
        if end - index <= MOST {
            ranges.push(index..end);
            index = end;
        } else {
            above.push(index);
            index += 1;
        }
    }
    (ranges, above)
}

/// The number of the node behind a subtree, among `nodes`, of which the first has the number `start`.
fn exit(nodes: &[f32], start: usize, index: usize) -> usize {
    nodes[index * node::SIZE + BOX + 1] as usize - start
}

fn refit_one(nodes: &mut [f32], start: usize, index: usize, corners: &[f32], margin: f32) {
    let triangle = nodes[index * node::SIZE + BOX];
    let around = if triangle >= 0.0 {
        bounds(&corners[triangle as usize * corner::SIZE..], margin)
    } else {
        let mut all = Aabb::empty();
        let (mut inside, end) = (index + 1, exit(nodes, start, index));
        while inside < end {
            all.join_mut(&aabb(nodes, inside));
            inside = exit(nodes, start, inside);
        }
        all
    };
    let floats = nodes[index * node::SIZE..][..BOX].iter_mut();
    floats.zip(around.min.iter().chain(around.max.iter())).for_each(|(float, edge)| *float = *edge);
}

fn aabb(nodes: &[f32], index: usize) -> Aabb<f32, 3> {
    let [a, b, c, d, e, f] = std::array::from_fn(|float| nodes[index * node::SIZE + float]);
    Aabb::with_bounds([a, b, c].into(), [d, e, f].into())
}

/// The number of nodes whose boxes a ray enters on average, of rays from everywhere through the box around all: the sum of the boxes' areas over its
/// area. Each costs such a ray one step.
pub(super) fn steps(nodes: &[f32]) -> f64 {
    let area = |node: &[f32]| {
        let [x, y, z] = std::array::from_fn(|axis| f64::from(node[3 + axis]) - f64::from(node[axis]));
        x * y + y * z + z * x
    };
    // Sums of ranges, so that the number is the same on any number of threads.
    let sums: Vec<f64> =
        nodes.par_chunks(MOST * node::SIZE).map(|part| part.chunks_exact(node::SIZE).map(area).sum()).collect();
    let mut all = Aabb::empty();
    let mut index = 0;
    while index < nodes.len() / node::SIZE {
        all.join_mut(&aabb(nodes, index));
        index = exit(nodes, 0, index);
    }
    let whole: Vec<f32> = all.min.iter().chain(all.max.iter()).copied().collect();
    sums.into_iter().sum::<f64>() / area(&whole)
}

#[cfg(test)]
mod tests {
    use super::super::bodies::bodies;
    use super::super::tree::{Tree, build};
    use super::*;
    use crate::builtin;
    use crate::method::voxelize::{Grid, Settings};
    use vitrum_io::Mesh;

    const REACH: f32 = 1e-3;

    fn tree(mesh: &Mesh) -> Tree {
        let grid = Grid::around(mesh, &Settings::new(256)).unwrap();
        build(&bodies(mesh, &[]).unwrap(), 0, grid, true, REACH).unwrap()
    }

    fn sea(seconds: f64) -> Mesh {
        builtin::moving_mesh("waves", seconds, 5.0).unwrap()
    }

    #[test]
    fn a_tree_that_has_not_moved_keeps_its_boxes_to_the_bit() {
        for name in ["waves", "gem", "vase", "still-life", "statue"] {
            let Tree { nodes, corners } = tree(&builtin::mesh(name).unwrap());
            let mut refitted = nodes.clone();
            refitted.chunks_exact_mut(node::SIZE).for_each(|node| node[..BOX].fill(f32::NAN));
            refit(&mut refitted, &corners, REACH.max(super::super::tree::MARGIN));
            assert!(nodes == refitted, "{name}");
        }
    }

    /// Every box has its triangle, or the boxes of its nodes, inside it and at its faces.
    #[test]
    fn boxes_of_a_refitted_tree_fit() {
        let (before, after) = (tree(&sea(0.0)), tree(&sea(0.4)));
        let margin = super::super::tree::MARGIN;
        let mut nodes = before.nodes.clone();
        refit(&mut nodes, &after.corners, margin);
        let mut seen = vec![false; after.corners.len() / corner::SIZE];
        for index in 0..nodes.len() / node::SIZE {
            // All triangles below, one by one.
            let mut expected = Aabb::empty();
            for inside in index..exit(&nodes, 0, index) {
                let triangle = nodes[inside * node::SIZE + BOX];
                if triangle >= 0.0 {
                    expected.join_mut(&bounds(&after.corners[triangle as usize * corner::SIZE..], margin));
                    seen[triangle as usize] = true;
                }
            }
            assert_eq!(aabb(&nodes, index), expected, "node {index}");
            assert_eq!(nodes[index * node::SIZE + BOX..][..2], before.nodes[index * node::SIZE + BOX..][..2]);
        }
        assert!(seen.into_iter().all(|seen| seen));
    }

    /// Two boxes of a unit cube each in a row: the sum of areas is 10 + 6 + 6 for a whole of 10.
    #[test]
    fn steps_are_areas_over_the_whole() {
        let nodes = [
            [0.0, 0.0, 0.0, 2.0, 1.0, 1.0, -1.0, 3.0],
            [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 2.0],
            [1.0, 0.0, 0.0, 2.0, 1.0, 1.0, 1.0, 3.0],
        ];
        assert!((steps(nodes.as_flattened()) - 2.2).abs() < 1e-12);
    }

    /// The triangles of the sea stay neighbours: a tree that is refitted for a minute is as good as a new one.
    #[test]
    fn waves_do_not_wear_out_a_tree() {
        let built = tree(&sea(0.0));
        for seconds in [0.5, 7.0, 60.0] {
            let new = tree(&sea(seconds));
            let mut nodes = built.nodes.clone();
            refit(&mut nodes, &new.corners, super::super::tree::MARGIN);
            let ratio = steps(&nodes) / steps(&new.nodes);
            assert!((0.9..1.1).contains(&ratio), "{seconds} s: {ratio}");
        }
    }
}
