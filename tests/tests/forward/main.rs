//! The light of a sweep that [`CARRIER`] carries, judged by pictures alone: what a camera sees on receivers and in particles, against
//! references in double precision that share no code with the kernels.

mod absorption;
mod ball;
mod caustic;
mod edges;
mod fit;
mod grazing;
mod penumbra;
mod places;
mod shot;
mod slab;
mod soft_inside;
mod sources;

use vitrum::backend::{Backend, CpuBackend};
use vitrum_conformance::{Failure, adapter};

/// The carrier of light that is judged: a value of `sweep.light`.
const CARRIER: &str = "forward";

/// The steepest angle between light and viewing direction that the carrier takes, in degrees: carriers that go with the planes of the
/// view take no light towards the camera.
fn steepest() -> f64 {
    if CARRIER == "forward" { 180.0 } else { 85.0 }
}

/// Calls `check` with each backend, and with what has been held to bounds there; all bounds are tried before the test fails.
fn on_both(check: impl Fn(&mut dyn Backend, &mut Held) -> Result<(), Failure>) -> Result<(), Failure> {
    let mut held = Held::default();
    check(&mut CpuBackend::new(None)?, &mut held)?;
    if let Some(mut gpu) = adapter::for_test() {
        check(&mut gpu, &mut held)?;
    }
    held.end();
    Ok(())
}

/// As [`on_both`], on the CPU alone: where frames are many or large. Kernels write the same bits on both.
fn on_the_cpu(check: impl Fn(&mut dyn Backend, &mut Held) -> Result<(), Failure>) -> Result<(), Failure> {
    let mut held = Held::default();
    check(&mut CpuBackend::new(None)?, &mut held)?;
    held.end();
    Ok(())
}

/// Whether the number-th of a row of frames is rendered: on the CPU all of them are, elsewhere each third one.
fn is_tried(backend: &dyn Backend, number: usize) -> bool {
    backend.name() == "cpu" || number.is_multiple_of(3)
}

/// The bounds that did not hold, in words.
#[derive(Default)]
struct Held(Vec<String>);

impl Held {
    /// Holds an error to a bound; one that is not a number holds to none.
    fn at_most(&mut self, backend: &dyn Backend, what: &str, error: f64, bound: f64) {
        let line = format!("{}: {what}: {error:.3e}, the bound is {bound:.1e}", backend.name());
        let holds = error <= bound;
        println!("{} {line}", if holds { "holds " } else { "BREACH" });
        if !holds {
            self.0.push(line);
        }
    }

    /// # Panics
    /// If a bound did not hold.
    fn end(self) {
        assert!(self.0.is_empty(), "light as {CARRIER}:\n{}", self.0.join("\n"));
    }
}
