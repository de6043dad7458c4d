//! The plane sweep's kernels (Magnus & Bruckner 2017, Algorithm 1), one file a kernel.
//!
//! For every plane: [`filter_light`] where light is soft, [`trace_light`], [`gather_light`], [`refract_light`] within the volume,
//! [`concentrate_light`], and, once the planes are in front of the eye, [`propagate_rays`], which reads the light of the plane
//! behind.
//! [`initialize_light`] and [`initialize_rays`] come first, then, behind the last plane, [`follow_rays`] and [`resolve`]; [`tiles`] says which place a ray has, and [`place`](mod@place) where on the picture that is.
//!
//! Where the maximum, minimum or mean of the scalar is shown, there is no light: [`project_rays`] follows the rays, and [`color_projected`] comes
//! before [`resolve`] (not in the paper).
//!
//! Instead of on texels, light can be carried forward by a wavefront, along its own direction and before the viewing rays (not in the paper):
//! [`initialize_nodes`] once, then for each of its planes [`advance_nodes`], [`blur_nodes`] and [`take_blurred`] where particles throw soft shadows, and, where something looks at the light, [`clear_sums`],
//! [`project_nodes`], [`cover_samples`], [`scatter_cells`] and [`collect_light`] (or [`collect_clear`], [`collect_straight`]); behind the last one [`clear_landed`], [`land_cells`],
//! [`integrate_landed`] where light is soft, and [`collect_receiver`] for each receiver.

pub mod advance_nodes;
pub mod blur_nodes;
pub mod bodies;
pub mod border;
pub mod clear_landed;
pub mod clear_sums;
pub mod clip;
pub mod collect_clear;
pub mod collect_light;
pub mod collect_receiver;
pub mod collect_straight;
pub mod color_projected;
pub mod concentrate_light;
pub mod cover_samples;
pub mod empty;
pub mod filter_light;
pub mod follow_rays;
pub mod gather_light;
pub mod initialize_light;
pub mod initialize_nodes;
pub mod initialize_rays;
pub mod integrate_landed;
pub mod isosurfaces;
pub mod land_cells;
pub mod light;
pub mod place;
pub mod project_nodes;
pub mod project_rays;
pub mod propagate_rays;
pub mod refract_light;
pub mod resolve;
pub mod scatter_cells;
pub mod surface;
pub mod take_blurred;
pub mod tiles;
pub mod trace_light;
pub mod turn;
