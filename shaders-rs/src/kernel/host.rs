//! The [`Kernel`](super::Kernel) of a declaration, which the CPU runs.

/// The kernel as the CPU runs it: for each instruction set a function with a body for each mode and level.
///
/// With AVX-512 a kernel has a body for each of its modes and levels. With AVX2, and for voxels in pages, which are rare on the CPU, it has
/// bodies for the `few` levels and for the modes that are not another's special case. At the baseline, and for rows of fewer than
/// [`LANES`](super::LANES) columns, the mode is a variable.
macro_rules! host {
    ($name:ident $format:tt $folder:ident $uniforms:ident $module:ident $access:ident $record:ident
     [$($level:ident)*] $few:tt $modes:tt $skip:tt [$($number:literal $read:ident: $element:ident,)*] $out:literal [$($workgroups:literal)?]) => {
        #[doc = concat!("See [`", stringify!($module), "`](crate::", stringify!($folder), "::", stringify!($module), ").")]
        #[allow(non_upper_case_globals)]
        pub static $name: Kernel = Kernel {
            declaration: Declaration {
                name: stringify!($name),
                family: concat!(stringify!($folder), "_", stringify!($module)),
                uniform_bytes: size_of::<crate::abi::$folder::$uniforms>(),
                components: $name::SIZE,
                names: host!(@names $access $record),
                levels: &[$(crate::$folder::$module::level::$level),*],
                modes: host!(@modes $folder $modes),
                skip: host!(@skip $skip),
                bindings: &[
                    Binding { binding: 0, name: "uniforms", element: Element::U32, access: Access::Uniform },
                    $(Binding {
                        binding: $number,
                        name: stringify!($read),
                        element: host!(@element $element),
                        access: Access::Read,
                    },)*
                    Binding { binding: $out, name: "record", element: Element::F32, access: host!(@access $access) },
                    $(Binding {
                        binding: $workgroups,
                        name: "workgroups",
                        element: Element::U32,
                        access: Access::Workgroups,
                    },)?
                ],
            },
            run: $name::run,
        };

        mod $name {
            use super::*;

            type Uniforms = crate::abi::$folder::$uniforms;
            pub const SIZE: usize = crate::abi::record::$record::SIZE;

            /// A kernel and its arguments.
            struct Body<'a, const FEW: bool> {
                u: &'a Uniforms,
                mode: u32,
                $($read: &'a [$element],)*
            }

            adaptor!(@body $access [$($level)*] $few $skip, $folder $module $format [$($read)*]);

            /// All rows of the chunk, for a mode that is a constant where this is inlined.
            #[inline(always)]
            #[allow(unused_mut, unused_variables)]
            fn rows<const FEW: bool>(u: &Uniforms, chunk: &mut Chunk<'_>, mode: u32, lanes: usize) -> bool {
                let mut reads = chunk.reads.iter();
                let kernel = Body::<FEW> {
                    u,
                    mode,
                    $($read: bytemuck::cast_slice(reads.next().copied().unwrap_or(&[0])),)*
                };
                host!(@drive $access [$($level)*] $skip, kernel, chunk, lanes)
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn many(u: &Uniforms, chunk: &mut Chunk<'_>) -> bool {
                host!(@many $folder $modes, $name, u, chunk)
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            #[allow(unreachable_patterns)]
            fn few(u: &Uniforms, chunk: &mut Chunk<'_>) -> bool {
                host!(@few $folder $modes, $name, u, chunk)
            }

            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            fn avx2(u: &Uniforms, chunk: &mut Chunk<'_>) -> bool {
                few(u, chunk)
            }

            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
            fn avx512(u: &Uniforms, chunk: &mut Chunk<'_>) -> bool {
                if host!(@is_paged $format) { few(u, chunk) } else { many(u, chunk) }
            }

            fn baseline(u: &Uniforms, chunk: &mut Chunk<'_>) -> bool {
                rows::<true>(u, chunk, u.dispatch().mode, drive::lanes_in(chunk.width))
            }

            pub fn run(set: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
                assert!(set.is_available(), "{set:?} is not available on this machine");
                // An argument of its own: a reference in a structure may, to LLVM, point into the output, and then everything
                // that is derived from uniforms is computed anew for every block.
                let u: &Uniforms = bytemuck::from_bytes(chunk.uniforms);
                match set {
                    // Kernels that add have lanes of their own, if any.
                    _ if (chunk.width as usize) < LANES && chunk.sums.is_empty() => baseline(u, chunk),
                    #[cfg(target_arch = "x86_64")]
                    // SAFETY: the machine has the instruction set, by the assertion above.
                    InstructionSet::Avx512 => unsafe { avx512(u, chunk) },
                    #[cfg(target_arch = "x86_64")]
                    // SAFETY: as above.
                    InstructionSet::Avx2 => unsafe { avx2(u, chunk) },
                    _ => baseline(u, chunk),
                }
            }
        }
    };

    (@names adds $record:ident) => { &[] };
    (@names $access:ident $record:ident) => { &crate::abi::record::$record::NAMES };
    (@element u32) => { Element::U32 };
    (@element f32) => { Element::F32 };
    (@access writes) => { Access::Write };
    (@access updates) => { Access::Update };
    (@access adds) => { Access::Add };
    (@skip []) => { Skip::Never };
    (@skip [until]) => { Skip::Until };
    (@skip [same $($until:ident)?]) => { Skip::Same };
    (@is_paged []) => { false };
    (@is_paged [$format:ident]) => { <crate::abi::format::$format as crate::abi::format::VoxelFormat>::PAGED };

    // Modes; a kernel without has the mode 0.
    (@modes $folder:ident []) => { &[0] };
    (@modes $folder:ident [$group:ident [$($mode:ident $(= $general:ident)?),*]]) => { &[$(crate::abi::$folder::$group::$mode),*] };
    (@many $folder:ident [], $name:ident, $u:ident, $chunk:ident) => { rows::<false>($u, $chunk, 0, crate::kernel::lanes::whole()) };
    (@many $folder:ident [$group:ident [$($mode:ident $(= $general:ident)?),*]], $name:ident, $u:ident, $chunk:ident) => {
        match $u.dispatch().mode {
            $(crate::abi::$folder::$group::$mode => rows::<false>($u, $chunk, crate::abi::$folder::$group::$mode, crate::kernel::lanes::whole()),)*
            other => unreachable!("{} has no mode {other}", stringify!($name)),
        }
    };
    (@few $folder:ident [], $name:ident, $u:ident, $chunk:ident) => { rows::<true>($u, $chunk, 0, crate::kernel::lanes::whole()) };
    (@few $folder:ident [$group:ident [$($mode:ident $(= $general:ident)?),*]], $name:ident, $u:ident, $chunk:ident) => {{
        let general = match $u.dispatch().mode {
            $(crate::abi::$folder::$group::$mode => host!(@general $folder $group $mode $($general)?),)*
            other => other,
        };
        match general {
            $(host!(@general $folder $group $mode $($general)?) =>
                rows::<true>($u, $chunk, host!(@general $folder $group $mode $($general)?), crate::kernel::lanes::whole()),)*
            other => unreachable!("{} has no mode {other}", stringify!($name)),
        }
    }};
    (@general $folder:ident $group:ident $mode:ident) => { crate::abi::$folder::$group::$mode };
    (@general $folder:ident $group:ident $mode:ident $general:ident) => { crate::abi::$folder::$group::$general };

    // Loops.
    (@drive adds [] [], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::scatter(&$kernel, $chunk, $lanes) };
    (@drive $access:ident [] [], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::plain(&$kernel, $chunk, $lanes) };
    (@drive $access:ident $levels:tt [], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::leveled(&$kernel, $chunk, $lanes) };
    (@drive $access:ident $levels:tt [until], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::skip_until(&$kernel, $chunk, $lanes) };
    (@drive $access:ident $levels:tt [same], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::skip_same(&$kernel, $chunk, $lanes) };
    (@drive $access:ident $levels:tt [same until], $kernel:ident, $chunk:ident, $lanes:ident) => { drive::skip_same_until(&$kernel, $chunk, $lanes) };
}
