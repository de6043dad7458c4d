//! Conformance: both backends against each other, against closed forms and against golden pictures.
//!
//! The tests in `tests/` and the programs `conformance` (`cargo xtask diff`), `bench` and `accuracy` share what
//! is here. `docs/conformance.md` describes the tiers:
//!
//! | tier | module | what is compared |
//! |---|---|---|
//! | T0 | [`functions`] | building blocks by themselves |
//! | T1 | [`kernels`] | what each kernel wrote, in the midst of a frame |
//! | T2 | [`frames`] | every output of whole frames |
//! | T3 | [`golden`] | frames with committed pictures |
//!
//! Each takes a [`case::Case`], turns what it compares into [`raster`]s and gives them to a [`run::Run`], which holds them
//! to one of the [`bounds`], keeps a row of the [`table`] and leaves [`evidence`] of a breach; [`report`] makes a page of it.
//! [`photons`] are an independent reference for light, [`closed_forms`] set-ups of which physics knows the outcome, [`refraction`]
//! rays through meshes, [`shadow`] their shadows, [`scattering`] an independent reference for light that a medium scatters
//! once and more than once;
//! [`accuracy`] makes tables and plots of both, [`docs`] what documents take from the code. [`bench`](mod@bench) times frames instead, [`paper`] those of the papers' tables.

pub mod accuracy;
pub mod adapter;
pub mod altered;
pub mod bench;
pub mod bounds;
pub mod case;
pub mod closed_forms;
pub mod data;
pub mod docs;
pub mod evidence;
pub mod failure;
pub mod frames;
pub mod functions;
pub mod golden;
pub mod kernels;
mod left_out;
pub mod machine;
pub mod paper;
pub mod photons;
pub mod raster;
pub mod rays;
pub mod refraction;
pub mod report;
pub mod roofline;
pub mod run;
pub mod scaling;
pub mod scattering;
pub mod shadow;
pub mod table;

pub use failure::Failure;

use std::path::{Path, PathBuf};

/// The workspace's root folder.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this package lies in the workspace").to_owned()
}
