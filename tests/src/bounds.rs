//! The bounds of conformance by adapter, with their reasons.
//!
//! Everything is in one table, [`FAMILIES`]; `docs/conformance.md` shows it, and a test holds the page to it.

use vitrum::backend::Backend;
use vitrum_compare::{Bound, Tolerance};

use crate::table;

/// Frames where division and square root may be off by a few units in the last place: at an edge that moves a ray from one
/// surface to another.
const NEARLY: Bound = Bound::Tolerance(Tolerance {
    relative_to_peak: true,
    max_abs: None,
    rmse: Some(1e-4),
    share_above: Some((1e-3, 1e-3)),
    mean_flip: Some(1e-3),
});

/// Some four quotients and roots in a row are off by up to 30 ULP. A difference of like numbers loses three bits of that, which
/// makes 256 ULP, in one of eight cases.
const SEVERAL_STEPS: Bound = Bound::MostlyUlp(256, 0.125);

/// The operations of a building block, which decide its bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// Comparisons, bits, and products with powers of two: nothing is rounded.
    Selection,
    /// One sum or product.
    Rounded,
    /// Sums of products: equal where they are not contracted to fused operations.
    Sum,
    /// One division at the end.
    Quotient,
    /// One square root at the end.
    Root,
    /// Several of these, with differences of like numbers among them.
    Several,
}

impl Class {
    /// Every class, and the building blocks that are in it.
    pub const ALL: [(Self, &'static [&'static str]); 6] = [
        (Self::Selection, &["absolute_value", "minimum", "maximum", "clamped", "selected", "floored", "half"]),
        (Self::Rounded, &["add", "multiply"]),
        (
            Self::Sum,
            &["multiply_add", "linear", "dot_product", "exponential", "euler_kick", "quantised", "sum_of_words"],
        ),
        (Self::Quotient, &["divide", "straight_flight"]),
        (Self::Root, &["square_root", "vector_length"]),
        (
            Self::Several,
            &[
                "binary_logarithm",
                "arc_tangent",
                "arc_sine",
                "fresnel_reflectance",
                "reflected_radiance",
                "symplectic_kick",
                "segment_layer",
                "composited",
            ],
        ),
    ];

    /// The class of a building block; one that is in no list is the last class's.
    #[must_use]
    pub fn of(function: &str) -> Self {
        Self::ALL.into_iter().find(|(_, names)| names.contains(&function)).map_or(Self::Several, |(class, _)| class)
    }
}

/// Adapters that are held to the same bounds.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// Name of the family.
    pub name: &'static str,
    /// Parts of an adapter's description, in lower case, that show that it is one of these. The first family of the table that has
    /// one is the adapter's.
    words: &'static [&'static str],
    /// The bound on frames and on what kernels wrote (T1, T2); FLIP counts only for colours.
    pub frames: Bound,
    /// The bounds on building blocks (T0), by class.
    pub functions: [Bound; 6],
    /// Why.
    pub reason: &'static str,
}

const EXACT: [Bound; 6] = [Bound::BitEqual; 6];
/// ÷ is within 2.5 ULP, and the CPU's within ½. √ is 1 / inversesqrt: 2 ULP of that are up to 4 of the result.
const VULKAN: [Bound; 6] =
    [Bound::BitEqual, Bound::BitEqual, Bound::BitEqual, Bound::Ulp(3), Bound::Ulp(7), SEVERAL_STEPS];
/// The bounds on Vulkan, but for two things: sums of products may be contracted, and the argument of a root may be off by 1 ULP.
const CONTRACTED: [Bound; 6] =
    [Bound::BitEqual, Bound::Ulp(1), SEVERAL_STEPS, Bound::Ulp(3), Bound::Ulp(8), SEVERAL_STEPS];

const BY_VULKAN: &str =
    "Vulkan: + − × round as IEEE 754 and are not contracted, ÷ is within 2.5 ULP, √ is that of 1 ÷ inversesqrt (2 ULP)";
const TRANSLATED: &str = "translated by naga: a × b + c may be contracted, ÷ and √ are those of fast mathematics";

/// Every family; the last takes what no other does, and whatever has its shaders translated. Metal stands before the makers of adapters.
#[rustfmt::skip]
pub const FAMILIES: [Family; 6] = [
    Family { name: "lavapipe", words: &["llvmpipe", "lavapipe"], frames: Bound::BitEqual, functions: EXACT,
             reason: "÷ and √ are the processor's, and nothing is contracted" },
    Family { name: "Apple, Metal", words: &["(metal", "apple", "moltenvk"], frames: NEARLY, functions: CONTRACTED, reason: TRANSLATED },
    Family { name: "NVIDIA", words: &["nvidia", "geforce", "nvk"], frames: NEARLY, functions: VULKAN, reason: BY_VULKAN },
    Family { name: "AMD", words: &["amd", "radeon", "radv"], frames: NEARLY, functions: VULKAN, reason: BY_VULKAN },
    Family { name: "Intel", words: &["intel"], frames: NEARLY, functions: VULKAN, reason: BY_VULKAN },
    Family { name: "other, Direct3D 12, translated", words: &[], frames: NEARLY, functions: CONTRACTED, reason: TRANSLATED },
];

impl Family {
    /// The family of an adapter, by its description: name, interface, driver.
    #[must_use]
    pub fn of(adapter: &str) -> &'static Self {
        let description = adapter.to_lowercase();
        let [named @ .., rest] = &FAMILIES;
        // Whoever made it, through Direct3D 12 its modules are translated, as through Metal; elsewhere where that was asked for.
        let translated = ["(dx12", "shaders translated"].iter().any(|word| description.contains(word));
        let of_family = |family: &&Self| family.words.iter().any(|word| description.contains(word));
        named.iter().filter(|family| !translated || family.reason == TRANSLATED).find(of_family).unwrap_or(rest)
    }

    fn cells(&self) -> [String; 9] {
        let [selection, rounded, sum, quotient, root, several] = self.functions.map(|bound| bound.to_string());
        let (name, frames, reason) = (self.name.to_owned(), self.frames.to_string(), self.reason.to_owned());
        [name, selection, rounded, sum, quotient, root, several, frames, reason]
    }
}

/// Families as a Markdown table.
#[must_use]
pub fn markdown(families: &[Family]) -> String {
    let header = ["family", "selection", "rounded", "sum", "quotient", "root", "several", "T1, T2", "reason"];
    table::aligned(header.map(str::to_owned), families.iter().map(Family::cells))
}

/// Whether a backend is held to the last bit of everything.
pub fn is_exact(backend: &dyn Backend) -> bool {
    backend.name() == "cpu" || Family::of(&backend.adapter()).frames == Bound::BitEqual
}

/// The bound on a backend's rendering of a scene against the CPU's. All builds for CPUs give the same bits.
pub fn of_backend(backend: &dyn Backend, shown: bool) -> Bound {
    if backend.name() == "cpu" { Bound::BitEqual } else { of_frame(&backend.adapter(), shown) }
}

/// The bound on a building block on a backend, against the CPU.
pub fn of_function(backend: &dyn Backend, function: &str) -> Bound {
    let class = Class::of(function) as usize;
    if backend.name() == "cpu" { Bound::BitEqual } else { Family::of(&backend.adapter()).functions[class] }
}

/// The bound on the CPU against a golden picture, on every platform: kernels give the same bits everywhere, and so does the host, whose
/// sines and exponentials are those of the crate `libm` and not of the platform's C library.
#[must_use]
pub fn of_golden(_shown: bool) -> Bound {
    Bound::BitEqual
}

/// The bound on a scene's frame on an adapter, against the CPU. `shown` says that the values are colours, which FLIP judges.
#[must_use]
pub fn of_frame(adapter: &str, shown: bool) -> Bound {
    of_values(Family::of(adapter).frames, shown)
}

/// A bound on colours, without what only colours have where the values are none.
fn of_values(bound: Bound, shown: bool) -> Bound {
    match bound {
        Bound::Tolerance(tolerance) if !shown => Bound::Tolerance(Tolerance { mean_flip: None, ..tolerance }),
        bound => bound,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_compare::compare_buffers;
    use vitrum_kernels::probe::functions::NAMES;

    #[test]
    fn adapters_are_known_by_their_descriptions() {
        for (adapter, family) in [
            ("llvmpipe (LLVM 15.0.6, 256 bits) (Vulkan, llvmpipe Mesa 22.3.6 (LLVM 15.0.6))", "lavapipe"),
            ("NVIDIA H100 80GB HBM3 (Vulkan, NVIDIA 570.86)", "NVIDIA"),
            ("AMD Radeon RX 6800 (RADV NAVI21) (Vulkan, radv Mesa 24.2.8)", "AMD"),
            ("Intel(R) Arc(tm) A770 Graphics (DG2) (Vulkan, Intel open-source Mesa driver Mesa 24.0)", "Intel"),
            ("Apple M2 (Metal, )", "Apple, Metal"),
            ("AMD Radeon Pro 5500M (Metal, )", "Apple, Metal"),
            ("AMD Radeon Pro 5500M (Metal, ; shaders translated)", "Apple, Metal"),
            ("NVIDIA GeForce RTX 4080 (Dx12, 32.0.15.6094)", "other, Direct3D 12, translated"),
            ("SwiftShader Device (LLVM 16.0.0) (Vulkan, SwiftShader driver)", "other, Direct3D 12, translated"),
            (
                "llvmpipe (LLVM 15.0.6, 256 bits) (Vulkan, Mesa 22.3.6; shaders translated)",
                "other, Direct3D 12, translated",
            ),
            ("NVIDIA H100 80GB HBM3 (Vulkan, NVIDIA 570.86; shaders translated)", "other, Direct3D 12, translated"),
        ] {
            assert_eq!(Family::of(adapter).name, family, "{adapter}");
        }
    }

    #[test]
    fn lavapipe_is_held_to_the_last_bit() {
        assert_eq!(of_frame("llvmpipe (LLVM 15.0.6, 256 bits)", true), Bound::BitEqual);
    }

    #[test]
    fn every_building_block_is_in_one_class() {
        let mut listed: Vec<&str> = Class::ALL.iter().flat_map(|(_, names)| names.iter().copied()).collect();
        let mut names = NAMES.to_vec();
        listed.sort_unstable();
        names.sort_unstable();
        assert_eq!(listed, names);
        assert!(Class::ALL.iter().enumerate().all(|(index, (class, _))| *class as usize == index));
    }

    #[test]
    fn another_adapter_fails_beyond_its_tolerance() {
        let bound = of_frame("NVIDIA H100", false);
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
