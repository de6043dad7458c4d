//! Volume caustics: light that clear and mirroring bodies send through a scattering medium (Hu et al. 2010), by beams.
//!
//! [`trace`] follows pencils of light, and viewing rays, through the bodies: a pencil is a ray with its derivatives ([`emission`],
//! [`viewing`], [`bend`], [`spread`]). For light, maps of the bodies may take the place of their triangles ([`maps`], [`trace_maps`]).
//! Each straight piece in air becomes a beam ([`store_beam`]), and [`scatter_beam`] adds the light that
//! the medium scatters out of it to the pixels that look through it. What viewing rays see behind the first surface, and
//! the light that beams throw on surfaces, is gathered ([`gather`], [`light_surface`]). [`see`] adds up the rest of the picture, [`resolve`] composes it.

pub mod add_depths;
pub mod airlight;
pub mod bend;
pub mod bound_beams;
pub mod cells;
pub mod covered;
pub mod density;
pub mod deposit_beam;
pub mod drawn;
pub mod drop_beam;
pub mod emission;
pub mod exchange_light;
pub mod exit;
pub mod facet;
pub mod find_curved;
pub mod find_depths;
pub mod find_light;
pub mod gather;
pub mod integrate_beam;
pub mod integrate_view;
pub mod light_cell;
pub mod light_surface;
pub mod look_around;
pub mod map_faces;
pub mod maps;
pub mod marched;
pub mod medium;
pub mod nearest;
pub mod picture;
pub mod project_beam;
pub mod pyramid;
pub mod refract_maps;
pub mod resolve;
pub mod scatter_beam;
pub mod scattered;
pub mod see;
pub mod see_cells;
pub mod shade;
pub mod shares;
pub mod split_texels;
pub mod spread;
pub mod store_beam;
pub mod strip;
pub mod trace;
pub mod trace_light;
pub mod trace_maps;
pub mod trace_view;
pub mod trapezoid;
pub mod tree;
pub mod viewing;
