//! The committed SPIR-V modules.

use vitrum_kernels::for_each_kernel;

macro_rules! modules {
    ($($name:ident: $uniforms:ident, $reads:tt, $access:ident $out:literal $size:tt,
       $folder:ident::$module:ident $generics:tt, $levels:ident $([$($level:literal)*] gpu $gpu:literal $($rests:ident)?)?, modes $modes:tt;)*) => {
        /// The SPIR-V of a kernel, by name.
        pub(super) fn module(kernel: &str) -> Option<&'static [u8]> {
            match kernel {
                $(stringify!($name) => Some(include_bytes!(concat!(
                    env!("CARGO_MANIFEST_DIR"),
                    "/../../shaders-rs/spirv/",
                    stringify!($name),
                    ".spv"
                ))),)*
                _ => None,
            }
        }
    };
}

for_each_kernel!(modules);
