//! Vitrum's kernels as graphics adapters take them: one module a kernel, in SPIR-V (feature `spirv`) and in WGSL (feature `wgsl`).
//!
//! `cargo xtask shaders` compiles crate `vitrum-kernels` and writes `spirv`, `wgsl`, `manifest.json` and `src/list.rs`. The modules are a
//! package of their own because the shader compiler needs the kernels' declarations before it has a module, and because a new module
//! is no reason to compile the kernels for the CPU once more (docs/adr/0017).

/// Makes [`NAMES`], [`spirv`] and [`wgsl`] of the kernels' names.
macro_rules! modules {
    ($($name:ident)*) => {
        /// Names of the kernels that have modules, in alphabetical order.
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];

        /// A kernel's module in SPIR-V, by the kernel's name. Its entry point is [`ENTRY_POINT`](crate::ENTRY_POINT).
        #[cfg(feature = "spirv")]
        #[must_use]
        pub fn spirv(kernel: &str) -> Option<&'static [u8]> {
            match kernel {
                $(stringify!($name) => Some(include_bytes!(concat!("../spirv/", stringify!($name), ".spv"))),)*
                _ => None,
            }
        }

        /// A kernel's module in WGSL, by the kernel's name. Its entry point is [`ENTRY_POINT`](crate::ENTRY_POINT).
        #[cfg(feature = "wgsl")]
        #[must_use]
        pub fn wgsl(kernel: &str) -> Option<&'static str> {
            match kernel {
                $(stringify!($name) => Some(include_str!(concat!("../wgsl/", stringify!($name), ".wgsl"))),)*
                _ => None,
            }
        }
    };
}

mod list;

pub use list::*;

/// The name of every module's entry point. Translators append an underscore to a name that ends in a digit, as names of kernels do.
pub const ENTRY_POINT: &str = "main";
