//! Which bound holds on which adapter.

use vitrum::backend::Backend;
use vitrum_compare::{Bound, Tolerance};

/// Scenes that are not yet equal to the last bit on lavapipe, each with the reason.
pub const NOT_YET_EQUAL: &[(&str, &str)] = &[];

/// What lavapipe is held to in a scene of [`NOT_YET_EQUAL`].
const NEARLY_EQUAL: Tolerance =
    Tolerance { relative_to_peak: true, max_abs: Some(1e-4), rmse: Some(1e-5), share_above: None, mean_flip: None };

/// What every other adapter is held to: its division and square root may be off by a few units in the last place, and at
/// an edge that moves a ray from one surface to another.
const OTHER_ADAPTERS: Tolerance = Tolerance {
    relative_to_peak: true,
    max_abs: None,
    rmse: Some(1e-4),
    share_above: Some((1e-3, 1e-3)),
    mean_flip: None,
};

/// The largest mean FLIP error of what is shown, on adapters other than lavapipe.
const OTHER_ADAPTERS_FLIP: f64 = 1e-3;

/// Whether an adapter is Mesa's software Vulkan driver, by the name it gives itself.
#[must_use]
pub fn is_lavapipe(adapter: &str) -> bool {
    adapter.to_lowercase().contains("llvmpipe") || adapter.to_lowercase().contains("lavapipe")
}

/// The bound on what a backend makes of a scene, against the CPU. All CPU builds give the same bits.
pub fn of_backend(backend: &dyn Backend, scene: &str, shown: bool) -> Bound {
    if backend.name() == "cpu" { Bound::BitEqual } else { of_frame(&backend.adapter(), scene, shown) }
}

/// The bound on the CPU against a golden picture.
///
/// Kernels give the same bits everywhere, but what the host prepares for them (directions, table entries) needs functions
/// such as the sine, which are the C library's: golden pictures are exact where they were made, on x86-64 Linux.
#[must_use]
pub fn of_golden(shown: bool) -> Bound {
    let at_home = cfg!(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu"));
    if at_home { Bound::BitEqual } else { other_adapters(shown) }
}

/// The bound on a scene's frame on an adapter, against the CPU. `shown` says that the values are colours, which FLIP judges.
#[must_use]
pub fn of_frame(adapter: &str, scene: &str, shown: bool) -> Bound {
    match (is_lavapipe(adapter), NOT_YET_EQUAL.iter().any(|&(name, _)| name == scene)) {
        (true, false) => Bound::BitEqual,
        (true, true) => Bound::Tolerance(NEARLY_EQUAL),
        (false, _) => other_adapters(shown),
    }
}

fn other_adapters(shown: bool) -> Bound {
    Bound::Tolerance(Tolerance { mean_flip: shown.then_some(OTHER_ADAPTERS_FLIP), ..OTHER_ADAPTERS })
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_compare::compare_buffers;

    #[test]
    fn lavapipe_is_held_to_the_last_bit() {
        assert!(is_lavapipe("llvmpipe (LLVM 15.0.6, 256 bits)"));
        assert_eq!(of_frame("llvmpipe (LLVM 15.0.6, 256 bits)", "ball", true), Bound::BitEqual);
    }

    #[test]
    fn another_adapter_fails_beyond_its_tolerance() {
        let bound = of_frame("NVIDIA H100", "ball", false);
        let reference = vec![1.0; 1000];
        let with = |count: usize, error: f32| {
            let mut other = reference.clone();
            other[..count].iter_mut().for_each(|value| *value += error);
            bound.check(&compare_buffers(&reference, &other).unwrap()).passed()
        };
        assert!(with(1, 2e-3) && with(1000, 5e-5));
        assert!(!with(2, 2e-3), "two of a thousand pixels are too many");
        assert!(!with(1000, 2e-4), "the RMSE is too large");
    }
}
