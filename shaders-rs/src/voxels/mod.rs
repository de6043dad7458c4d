//! Rays through a mesh of clear materials (Chang et al. 2010, §4), and the same through its triangles.
//!
//! [`march`] follows a ray through voxels whose surface is smoothed over the neighbourhood, [`march_paper`] as the paper does,
//! [`trace_triangles`] through the triangles themselves. Each does some steps and leaves the rest to the next dispatch; what they
//! do at a surface is the same ([`surface`]).
//!
//! Opaque bodies are triangles to all of them: before a ray marches through voxels, [`seek`] finds the one ahead. Where rays end is
//! shaded by [`resolve`] ([`shade`]).

pub mod add_way;
pub mod contact;
pub mod crease;
pub mod ending;
pub mod follow;
pub mod initialize_rays;
pub mod march;
pub mod march_paper;
pub mod mirror;
pub mod ray;
pub mod reflect;
pub mod resolve;
pub mod seek;
pub mod shade;
pub mod solid;
pub mod surface;
pub mod trace_triangles;
pub mod tree;
pub mod triangle;
