//! Closed forms: what physics says, on both backends, through the public scene API.
//!
//! Numbers at the top of the files count the closed forms. A voxelized field is not the analytic one: each test states its grid, and the
//! bound belongs to that grid. Measured errors and their bounds stand in one table, `closed_forms::table`, which `docs/accuracy.md` shows.

mod ambient;
mod attenuation;
mod ball;
mod bodies;
mod border;
mod colors;
mod crop;
mod flux;
mod gradients;
mod isosurfaces;
mod layer;
mod lights;
mod luneburg;
mod matter;
mod outliers;
mod porter_duff;
mod prism;
mod projection;
mod saddle;
mod setup;
mod slab;
mod spot;
mod step;
mod surfaces;
mod turned;
