//! The plane sweep's kernels (Magnus & Bruckner 2017, Algorithm 1), one file a kernel.
//!
//! For every plane: [`filter_light`] where light is soft, [`trace_light`], [`gather_light`], [`refract_light`] within the volume,
//! [`concentrate_light`], and, once the planes are in front of the eye, [`propagate_rays`], which reads the light of the plane
//! behind.
//! [`initialize_light`] and [`initialize_rays`] come first, then, behind the last plane, [`follow_rays`] and [`resolve`]; [`tiles`] says which pixel a ray belongs to.
//!
//! Instead of the light on each texel, light can be carried forward as sheets of rays (not in the paper): [`initialize_sheet`] once,
//! then [`advance_sheet`], [`clear_sums`], [`scatter_sheet`], [`collect_light`] for every plane.

pub mod advance_sheet;
pub mod border;
pub mod clear_sums;
pub mod clip;
pub mod collect_light;
pub mod concentrate_light;
pub mod empty;
pub mod filter_light;
pub mod follow_rays;
pub mod gather_light;
pub mod initialize_light;
pub mod initialize_rays;
pub mod initialize_sheet;
pub mod light;
pub mod propagate_rays;
pub mod refract_light;
pub mod resolve;
pub mod scatter_sheet;
pub mod tiles;
pub mod trace_light;
pub mod turn;
