//! Differences of the methods from physics, as tables and plots for `docs/accuracy.md`.
//!
//! `cargo xtask accuracy` measures anew and writes both; nothing in them is typed by hand.

mod convergence;
mod page;
mod photons;
mod plot;
mod refraction;
mod shadow;

pub use page::{replace, rewrite, write};
pub use plot::{Axis, Corner, Plot, Scale, Series};

use vitrum::backend::Backend;

use crate::Failure;

/// A section of the page: the measurements of one quantity.
#[derive(Debug, Clone)]
pub struct Section {
    /// Markdown tables.
    pub text: String,
    /// The plot of the measurements.
    pub plot: Plot,
}

/// Measures a thing.
pub type Measure = fn(&mut dyn Backend) -> Result<Section, Failure>;

/// The measurements, by name.
pub const ALL: [(&str, Measure); 8] = [
    ("step", convergence::step),
    ("luneburg", convergence::luneburg),
    ("ball", convergence::ball),
    ("areas", convergence::areas),
    ("slab", convergence::slab),
    ("photons", photons::photons),
    ("refraction", refraction::refraction),
    ("shadow", shadow::shadow),
];
