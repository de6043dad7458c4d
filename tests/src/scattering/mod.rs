//! An independent reference for light that a medium scatters once and more than once: light paths, drawn at random, in
//! double precision.
//!
//! It shares no code with the kernels, nor with the method `beams`. The scene is a box of a homogeneous medium, one
//! source of light and at most one clear ball; outside of the box there is nothing. There are two estimators, one the
//! reverse of the other:
//!
//! | estimator | paths start at | what is joined | ball |
//! |---|---|---|---|
//! | [`radiance`], [`pixel`] | the eye | each vertex and the source | no |
//! | [`picture`] | the source | each straight part and the eye | yes |
//!
//! Both give means with standard errors, and the same bits whatever the number of threads. `tests/tests/scattering`
//! holds them to closed forms and to each other.
//!
//! Units: lengths in world units, coefficients in 1 / world unit, radiant intensity in W/sr, irradiance in W / world
//! unit², radiance in W / (sr · world unit²). A scene's `light.intensity` of the program is the radiant intensity, or
//! the irradiance, over π.

mod angles;
mod ball;
mod camera;
mod estimate;
mod medium;
mod photon;
mod picture;
mod radiance;
mod random;
pub mod table;

pub use ball::Ball;
pub use camera::Camera;
pub use estimate::{Estimate, Orders};
pub use medium::Medium;
pub use photon::{End, Photon};
pub use picture::{Ledger, Picture, picture};
pub use radiance::{pixel, radiance};
pub use random::Random;

use vitrum_kernels::glam::DVec3;

/// A source of light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lamp {
    /// A point that shines equally to all sides.
    Point {
        /// Its place, within the medium or outside.
        position: DVec3,
        /// Radiant intensity, in W/sr.
        intensity: f64,
    },
    /// Parallel light. The medium attenuates it from where it enters the box.
    Distant {
        /// Unit direction in which it goes.
        direction: DVec3,
        /// Irradiance of a plane across it in front of the box, in W / world unit².
        irradiance: f64,
    },
}

/// A medium and what is in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scene {
    /// The medium.
    pub medium: Medium,
    /// The source of light.
    pub lamp: Lamp,
    /// A clear ball within the medium's box. The source is outside of it.
    pub ball: Option<Ball>,
}
