//! The transparent shadow map (Chang et al. 2010, §3): how much of a light gets to a point in a mesh.
//!
//! The mesh is turned so that light travels along x, and cut into voxels. The light of a point is taken to infinity before that, by a projective
//! map that keeps triangles ([`crate::voxelize::columns::depth`]). [`count_crossings`] adds to a voxel's optical depth what
//! each triangle of an opaque material absorbs there, [`absorb_solid`] what a clear body does, [`accumulate`] sums both up along the
//! light. What comes out is looked up by [`look_up`].
//!
//! What several invocations write is in integers and does not depend on their order.

pub mod absorb_solid;
pub mod accumulate;
pub mod count_crossings;
pub mod look_up;
pub mod spread;
