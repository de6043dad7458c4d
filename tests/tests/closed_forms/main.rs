//! Closed forms: what physics says, on both backends, through the public scene API.
//!
//! Numbers at the top of the files count the closed forms; `docs/accuracy.md` has what was measured. A voxelized field is not the analytic one: each test
//! states its grid, and the bound belongs to that grid.

mod attenuation;
mod ball;
mod flux;
mod gradients;
mod layer;
mod lights;
mod luneburg;
mod porter_duff;
mod prism;
mod saddle;
mod setup;
mod slab;
mod spot;
mod step;
