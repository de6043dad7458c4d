//! The CPU dispatch of every kernel, generated from the list.
//!
//! Rows are run in blocks of [`LANES`] invocations. A block's records live in local arrays, so that the loop over its lanes has
//! no aliasing stores and becomes vector code. A block runs at the highest level that one of its lanes needs.

use super::host::{Access, Binding, Chunk, Declaration, Element, InstructionSet, Kernel, LANES};
use crate::abi::grid::format;
use crate::abi::record::{film, light, ray, trace};
use crate::abi::sweep::SweepUniforms;
use crate::for_each_kernel;

macro_rules! element {
    (u32) => {
        Element::U32
    };
    (f32) => {
        Element::F32
    };
}

macro_rules! access {
    (writes) => {
        Access::Write
    };
    (updates) => {
        Access::Update
    };
}

/// The lanes of one block at one level.
macro_rules! lanes {
    (writes, $n:ident, $x:ident, $inputs:ident, $outputs:ident, $call:expr) => {
        for lane in 0..$n {
            let record = $call($x + lane as u32);
            put(&mut $outputs, lane, record);
        }
    };
    (updates, $n:ident, $x:ident, $inputs:ident, $outputs:ident, $call:expr) => {
        for lane in 0..$n {
            let record = $call($x + lane as u32, take(&$inputs, lane));
            put(&mut $outputs, lane, record);
        }
    };
}

/// The highest level that a lane of the block needs.
macro_rules! needed {
    (writes, $n:ident, $x:ident, $inputs:ident, $call:expr) => {{
        let mut needed = 0;
        for lane in 0..$n {
            let level: u32 = $call($x + lane as u32);
            needed = if level > needed { level } else { needed };
        }
        needed
    }};
    (updates, $n:ident, $x:ident, $inputs:ident, $call:expr) => {{
        let mut needed = 0;
        for lane in 0..$n {
            let level: u32 = $call($x + lane as u32, take(&$inputs, lane));
            needed = if level > needed { level } else { needed };
        }
        needed
    }};
}

macro_rules! block {
    ($access:ident, $module:ident [$($generic:expr),*], plain, $n:ident, $x:ident, $y:ident, $u:ident, $mode:ident,
     $inputs:ident, $outputs:ident, ($($read:ident),*)) => {{
        lanes!($access, $n, $x, $inputs, $outputs, |x| {
            crate::sweep::$module::invoke(x, $y, $u, $mode $(, $read)*)
        });
        true
    }};
    (writes, $module:ident [$($generic:expr),*], levels [$($level:literal)*], $n:ident, $x:ident, $y:ident, $u:ident,
     $mode:ident, $inputs:ident, $outputs:ident, $reads:tt) => {
        block!(@levelled writes, $module [$($generic),*], [$($level)*], $n, $x, $y, $u, $mode, $inputs, $outputs, (), $reads)
    };
    (updates, $module:ident [$($generic:expr),*], levels [$($level:literal)*], $n:ident, $x:ident, $y:ident, $u:ident,
     $mode:ident, $inputs:ident, $outputs:ident, $reads:tt) => {
        block!(@levelled updates, $module [$($generic),*], [$($level)*], $n, $x, $y, $u, $mode, $inputs, $outputs, (record), $reads)
    };
    (@levelled $access:ident, $module:ident $generics:tt, [$($level:literal)*], $n:ident, $x:ident, $y:ident,
     $u:ident, $mode:ident, $inputs:ident, $outputs:ident, $record:tt, $reads:tt) => {{
        let needed = needed!($access, $n, $x, $inputs,
            call!(@level $module $generics, $y, $u, $mode, $record, $reads));
        $(if needed == $level {
            lanes!($access, $n, $x, $inputs, $outputs,
                call!(@invoke $module $generics, $level, $y, $u, $mode, $record, $reads));
        })*
        needed > 0
    }};
}

/// A closure that calls the kernel's `level` or `invoke`.
macro_rules! call {
    (@level $module:ident [$($generic:expr),*], $y:ident, $u:ident, $mode:ident, ($($record:ident)?), ($($read:ident),*)) => {
        |x $(, $record)?| {
            crate::sweep::$module::level::<$({ $generic }),*>(x, $y, $u, $mode $(, $record)? $(, $read)*)
        }
    };
    (@invoke $module:ident [$($generic:expr),*], $level:literal, $y:ident, $u:ident, $mode:ident, ($($record:ident)?),
     ($($read:ident),*)) => {
        |x $(, $record)?| {
            crate::sweep::$module::invoke::<$({ $generic },)* $level>(x, $y, $u, $mode $(, $record)? $(, $read)*)
        }
    };
}

macro_rules! declare {
    ($($name:ident: $uniforms:ident, [$($number:literal $read:ident: $element:ident),*],
       $access:ident $out:literal [$size:expr],
       $module:ident $generics:tt, $levels:ident $([$($level:literal)*])?, modes [$($mode:literal)*];)*) => {
        /// The kernels, by name.
        pub mod kernels {
            use super::*;
            $(
                #[doc = concat!("See [`", stringify!($module), "`](crate::sweep::", stringify!($module), ").")]
                #[allow(non_upper_case_globals)]
                pub static $name: Kernel = Kernel {
                    declaration: Declaration {
                        name: stringify!($name),
                        uniform_bytes: size_of::<$uniforms>(),
                        components: $size,
                        bindings: &[
                            Binding { binding: 0, name: "uniforms", element: Element::U32, access: Access::Uniform },
                            $(Binding {
                                binding: $number,
                                name: stringify!($read),
                                element: element!($element),
                                access: Access::Read,
                            },)*
                            Binding { binding: $out, name: "record", element: Element::F32, access: access!($access) },
                        ],
                    },
                    run: super::$name::run,
                };
            )*
        }

        /// Every kernel.
        pub static ALL: &[&Kernel] = &[$(&kernels::$name),*];

        $(
            mod $name {
                use super::*;

                /// All rows of the chunk, for a mode that is a constant where this is inlined.
                #[inline(always)]
                #[allow(unused_mut, unused_variables)]
                fn rows(chunk: &mut Chunk<'_>, mode: u32) -> bool {
                    let u: &$uniforms = bytemuck::from_bytes(chunk.uniforms);
                    let mut reads = chunk.reads.iter();
                    $(let $read: &[$element] = bytemuck::cast_slice(reads.next().copied().unwrap_or(&[0]));)*
                    let mut any = false;
                    for row in 0..chunk.rows {
                        let y = chunk.first_row + row;
                        let mut x = 0;
                        while x < chunk.width {
                            let n = LANES.min((chunk.width - x) as usize);
                            let at = (row * chunk.width + x) as usize;
                            let mut inputs = [[0.0f32; LANES]; $size];
                            let mut outputs = [[0.0f32; LANES]; $size];
                            if matches!(access!($access), Access::Update) {
                                copy_in(&mut inputs, chunk.output, at, n);
                            }
                            let worked = block!($access, $module $generics, $levels $([$($level)*])?, n, x, y, u, mode,
                                inputs, outputs, ($($read),*));
                            if worked {
                                copy_out(&outputs, chunk.output, at, n);
                            }
                            any |= worked;
                            x += n as u32;
                        }
                    }
                    any
                }

                #[inline(always)]
                fn specialised(chunk: &mut Chunk<'_>) -> bool {
                    match bytemuck::from_bytes::<$uniforms>(chunk.uniforms).dispatch.z {
                        $($mode => rows(chunk, $mode),)*
                        other => unreachable!("{} has no mode {other}", stringify!($name)),
                    }
                }

                #[cfg(target_arch = "x86_64")]
                #[target_feature(enable = "avx2")]
                fn avx2(chunk: &mut Chunk<'_>) -> bool {
                    specialised(chunk)
                }

                #[cfg(target_arch = "x86_64")]
                #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
                fn avx512(chunk: &mut Chunk<'_>) -> bool {
                    specialised(chunk)
                }

                fn baseline(chunk: &mut Chunk<'_>) -> bool {
                    let mode = bytemuck::from_bytes::<$uniforms>(chunk.uniforms).dispatch.z;
                    rows(chunk, mode)
                }

                pub fn run(set: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
                    assert!(set.is_available(), "{set:?} is not available on this machine");
                    match set {
                        #[cfg(target_arch = "x86_64")]
                        // SAFETY: the machine has the instruction set, by the assertion above.
                        InstructionSet::Avx512 => unsafe { avx512(chunk) },
                        #[cfg(target_arch = "x86_64")]
                        // SAFETY: as above.
                        InstructionSet::Avx2 => unsafe { avx2(chunk) },
                        _ => baseline(chunk),
                    }
                }
            }
        )*
    };
}

#[inline(always)]
fn take<const N: usize>(lanes: &[[f32; LANES]; N], lane: usize) -> [f32; N] {
    let mut record = [0.0; N];
    for (component, lanes) in record.iter_mut().zip(lanes) {
        // SAFETY: `lane` counts to at most `LANES`. A check here would be a branch in the loop that is to become vector code.
        *component = unsafe { *lanes.get_unchecked(lane) };
    }
    record
}

#[inline(always)]
fn put<const N: usize>(lanes: &mut [[f32; LANES]; N], lane: usize, record: [f32; N]) {
    for (lanes, component) in lanes.iter_mut().zip(record) {
        // SAFETY: as in `take`.
        unsafe { *lanes.get_unchecked_mut(lane) = component };
    }
}

#[inline(always)]
fn copy_in<const N: usize>(lanes: &mut [[f32; LANES]; N], output: &[&mut [f32]], at: usize, n: usize) {
    for (lanes, component) in lanes.iter_mut().zip(output) {
        lanes[..n].copy_from_slice(&component[at..at + n]);
    }
}

#[inline(always)]
fn copy_out<const N: usize>(lanes: &[[f32; LANES]; N], output: &mut [&mut [f32]], at: usize, n: usize) {
    for (lanes, component) in lanes.iter().zip(output) {
        component[at..at + n].copy_from_slice(&lanes[..n]);
    }
}

for_each_kernel!(declare);
