//! The CPU dispatch of every kernel, generated from the list.
//!
//! Rows are run in blocks of [`LANES`] invocations. A block's records live in local arrays, so that the loop over its lanes has
//! no aliasing stores and becomes vector code. A block runs at the union of the levels that its lanes need.

use super::host::{Access, Binding, Chunk, Declaration, Element, FOREVER, InstructionSet, Kernel, LANES};
use crate::abi::grid::format;
use crate::abi::probe::ProbeUniforms;
use crate::abi::record::{
    absorption, attributes, film, irradiance, light, mirror, path, probe, ray, sheet, sums, trace, view,
};
use crate::abi::shadow::ShadowUniforms;
use crate::abi::sweep::SweepUniforms;
use crate::abi::voxelize::VoxelizeUniforms;
use crate::abi::voxels::VoxelsUniforms;
use crate::field::sums::SharedSums;
use crate::for_each_kernel;
use crate::math::select;

/// How often a block that rests looks ahead, each time from the end of what it knows to be empty.
const LOOKS: u32 = 8;

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
    (adds) => {
        Access::Add
    };
}

macro_rules! rests {
    () => {
        false
    };
    (rests) => {
        true
    };
    (unoccluded) => {
        false
    };
}

macro_rules! keeps_unoccluded {
    () => {
        false
    };
    (rests) => {
        false
    };
    (unoccluded) => {
        true
    };
}

/// Calls a kernel's function for a lane. Not a closure: one that is called from several places is not inlined, and then the loop
/// around it does not become vector code.
macro_rules! call {
    (writes, $function:expr, $lane:ident, $x:ident, $y:ident, $u:ident, $mode:ident, $inputs:ident, ($($read:ident),*)) => {
        $function(column($x, $lane), $y, $u, $mode $(, $read)*)
    };
    (updates, $function:expr, $lane:ident, $x:ident, $y:ident, $u:ident, $mode:ident, $inputs:ident, ($($read:ident),*)) => {
        $function(column($x, $lane), $y, $u, $mode, take(&$inputs, $lane) $(, $read)*)
    };
}

/// What a lane that needs `$needed` makes of its record: one that updates leaves it alone at the levels 0 and 1, though its block may run
/// at a higher one.
macro_rules! after {
    (writes, $size:expr, $needed:ident, $lane:ident, $inputs:ident, $record:ident) => {
        $record
    };
    (updates, $size:expr, $needed:ident, $lane:ident, $inputs:ident, $record:ident) => {
        choose::<{ $size }>(level_of(&$needed, $lane) > 1, $record, take(&$inputs, $lane))
    };
}

/// Runs the lanes of one block and copies their records out; whether any had work to do.
///
/// Each level has arrays of its own: LLVM looks at no more than 100 uses of an array to find out that nothing else points to it,
/// and without knowing that it does not make vector code.
macro_rules! block {
    ($access:ident, $size:expr, $folder:ident::$module:ident [$($generic:expr),*], plain, $n:ident, $x:ident, $y:ident, $u:ident, $mode:ident,
     $inputs:ident, $reads:tt) => {{
        let mut outputs = [[0.0f32; LANES]; $size];
        for lane in 0..$n {
            let record = call!($access, crate::$folder::$module::invoke, lane, $x, $y, $u, $mode, $inputs, $reads);
            put(&mut outputs, lane, record);
        }
        copy_out(&outputs, &$inputs, $n);
        true
    }};
    ($access:ident, $size:expr, $folder:ident::$module:ident $generics:tt, levels [$($level:literal)*] gpu $gpu:literal, $n:ident, $x:ident, $y:ident, $u:ident,
     $mode:ident, $inputs:ident, $reads:tt) => {{
        let (mut needed, mut levels) = (0, [0; LANES]);
        for lane in 0..$n {
            let level: u32 = block!(@level $access, $folder::$module $generics, lane, $x, $y, $u, $mode, $inputs, $reads);
            needed |= level;
            put_level(&mut levels, lane, level);
        }
        match needed {
            $($level => {
                let mut outputs = [[0.0f32; LANES]; $size];
                for lane in 0..$n {
                    let record =
                        block!(@invoke $access, $folder::$module $generics, $level, lane, $x, $y, $u, $mode, $inputs, $reads);
                    put(&mut outputs, lane, after!($access, $size, levels, lane, $inputs, record));
                }
                copy_out(&outputs, &$inputs, $n);
            })*
            _ => debug_assert!(needed <= 1, "level {needed} is not in the list of kernels"),
        }
        needed > 0
    }};
    (@level $access:ident, $folder:ident::$module:ident [$($generic:expr),*], $lane:ident, $x:ident, $y:ident, $u:ident, $mode:ident,
     $inputs:ident, $reads:tt) => {
        call!($access, crate::$folder::$module::level::<$({ $generic }),*>, $lane, $x, $y, $u, $mode, $inputs, $reads)
    };
    (@rest updates, $folder:ident::$module:ident [$($generic:expr),*], $ahead:ident, $lane:ident, $x:ident, $y:ident, $u:ident, $mode:ident,
     $inputs:ident, ($($read:ident),*)) => {
        crate::$folder::$module::rest::<$({ $generic }),*>(column($x, $lane), $y, $u, $mode, take(&$inputs, $lane) $(, $read)*, $ahead)
    };
    (@free_steps $folder:ident::$module:ident [$format:expr, $second:expr], $lane:ident, $x:ident, $y:ident, $u:ident,
     ($voxels:ident, $ior_voxels:ident, $occupancy:ident, $tables:ident, $trace:ident)) => {
        crate::$folder::$module::free_steps::<{ $second }>(column($x, $lane), $y, $u, $occupancy)
    };
    (@invoke $access:ident, $folder:ident::$module:ident [$($generic:expr),*], $level:literal, $lane:ident, $x:ident, $y:ident, $u:ident,
     $mode:ident, $inputs:ident, $reads:tt) => {
        call!($access, crate::$folder::$module::invoke::<$({ $generic },)* $level>, $lane, $x, $y, $u, $mode, $inputs, $reads)
    };
}

/// Runs all rows of a chunk, for a mode that is a constant where this is inlined; whether any invocation had work to do.
macro_rules! all_rows {
    // Sums are scattered: there is no record to put in order, and nothing to gain from blocks.
    (adds, $size:expr, $folder:ident::$module:ident [], plain, $u:ident, $chunk:ident, $mode:ident, ($($read:ident),*)) => {{
        let mut sums = SharedSums($chunk.sums);
        for row in $chunk.inside.clone() {
            for x in $chunk.columns.clone() {
                crate::$folder::$module::invoke(x, $chunk.first_row + row, $u, $mode $(, $read)*, &mut sums);
            }
        }
        true
    }};
    (updates, $size:expr, $folder:ident::$module:ident $generics:tt, levels [$($level:literal)*] gpu $gpu:literal rests,
     $u:ident, $chunk:ident, $mode:ident, $reads:tt) => {{
        let record = Records::<{ $size }>::new($chunk.output, $chunk.rows as usize * $chunk.width as usize);
        let mut any = false;
        for row in $chunk.inside.clone() {
            let y = $chunk.first_row + row;
            let mut x = $chunk.columns.start;
            while x < $chunk.columns.end {
                let n = LANES.min(($chunk.columns.end - x) as usize);
                let at = (row * $chunk.width + x) as usize;
                let first = x;
                x += n as u32;
                let number = $chunk.block(row, first);
                let Some(rest) = $chunk.rests.get_mut(number) else { break };
                if *rest > 0 {
                    any |= *rest != FOREVER;
                    *rest -= (*rest != FOREVER) as u32;
                    continue;
                }
                // SAFETY: rows of the chunk have `width` records, so `at + n` is at most their number.
                let inputs = unsafe { record.at(at) };
                let (mut needed, mut levels) = (0, [0; LANES]);
                for lane in 0..n {
                    let level: u32 = block!(@level updates, $folder::$module $generics, lane, first, y, $u, $mode, inputs, $reads);
                    needed |= level;
                    put_level(&mut levels, lane, level);
                }
                match needed {
                    0 => *rest = FOREVER,
                    1 => {
                        let mut known = 0;
                        for _ in 0..LOOKS {
                            let ahead = known as f32;
                            // Numbers that are not negative have the order of their bits, whose least one vector code finds.
                            let mut least = u32::MAX;
                            for lane in 0..n {
                                let passes: f32 =
                                    block!(@rest updates, $folder::$module $generics, ahead, lane, first, y, $u, $mode, inputs, $reads);
                                least = least.min(passes.to_bits());
                            }
                            // The cast cuts off and saturates.
                            let found = f32::from_bits(least) as u32;
                            let farther = found > known;
                            known = known.max(found);
                            if !farther || known == FOREVER {
                                break;
                            }
                        }
                        *rest = known;
                    }
                    $($level => {
                        let mut outputs = [[0.0f32; LANES]; $size];
                        for lane in 0..n {
                            let record =
                                block!(@invoke updates, $folder::$module $generics, $level, lane, first, y, $u, $mode, inputs, $reads);
                            put(&mut outputs, lane, after!(updates, $size, levels, lane, inputs, record));
                        }
                        copy_out(&outputs, &inputs, n);
                    })*
                    _ => debug_assert!(false, "level {needed} is not in the list of kernels"),
                }
                any |= needed > 0;
            }
        }
        any
    }};
    (writes, $size:expr, $folder:ident::$module:ident $generics:tt, levels $levels:tt gpu $gpu:literal unoccluded,
     $u:ident, $chunk:ident, $mode:ident, $reads:tt) => {{
        let record = Records::<{ $size }>::new($chunk.output, $chunk.rows as usize * $chunk.width as usize);
        let unoccluded = crate::$folder::$module::unoccluded($u);
        let mut any = false;
        for row in $chunk.inside.clone() {
            let y = $chunk.first_row + row;
            let mut x = $chunk.columns.start;
            while x < $chunk.columns.end {
                let n = LANES.min(($chunk.columns.end - x) as usize);
                let at = (row * $chunk.width + x) as usize;
                let first = x;
                x += n as u32;
                let number = $chunk.block(row, first);
                // SAFETY: rows of the chunk have `width` records, so `at + n` is at most their number.
                let inputs = unsafe { record.at(at) };
                if let Some(kept) = &unoccluded
                    && $chunk.marks.around(&kept.reach, first, y, $chunk.width)
                {
                    if !$chunk.marks.is_set(number) {
                        fill(&inputs, &kept.record, n);
                        $chunk.marks.set(number, true);
                    }
                    continue;
                }
                let worked = block!(writes, $size, $folder::$module $generics, levels $levels gpu $gpu, n, first, y, $u, $mode,
                    inputs, $reads);
                any |= worked;
                let untouched = unoccluded.as_ref().is_some_and(|kept| all_are(&inputs, &kept.record, n));
                $chunk.marks.set(number, untouched);
            }
        }
        any
    }};
    (updates, $size:expr, $folder:ident::$module:ident [$format:expr, $second:expr], levels $levels:tt gpu $gpu:literal unoccluded,
     $u:ident, $chunk:ident, $mode:ident, ($($read:ident),*)) => {{
        let record = Records::<{ $size }>::new($chunk.output, $chunk.rows as usize * $chunk.width as usize);
        let unoccluded = crate::$folder::$module::unoccluded($u);
        let mut any = false;
        for row in $chunk.inside.clone() {
            let y = $chunk.first_row + row;
            let mut x = $chunk.columns.start;
            while x < $chunk.columns.end {
                let n = LANES.min(($chunk.columns.end - x) as usize);
                let at = (row * $chunk.width + x) as usize;
                let first = x;
                x += n as u32;
                let number = $chunk.block(row, first);
                // SAFETY: rows of the chunk have `width` records, so `at + n` is at most their number.
                let inputs = unsafe { record.at(at) };
                let kept = unoccluded.as_ref().filter(|_| $chunk.marks.is_set(number));
                let kept = kept.filter(|kept| $chunk.marks.around(&kept.reach, first, y, $chunk.width));
                if kept.is_some() {
                    if $chunk.marks.is_free_to(number, $u.plane.y) {
                        continue;
                    }
                    let mut needed = 0;
                    for lane in 0..n {
                        let level: u32 =
                            block!(@level updates, $folder::$module [$format, $second], lane, first, y, $u, $mode, inputs, ($($read),*));
                        needed |= level;
                    }
                    if needed <= 1 {
                        // As for `rest`, the order of bits.
                        let mut least = u32::MAX;
                        for lane in 0..n {
                            let steps: f32 =
                                block!(@free_steps $folder::$module [$format, $second], lane, first, y, $u, ($($read),*));
                            least = least.min(steps.to_bits());
                        }
                        $chunk.marks.set_free_to(number, $u.plane.y + f32::from_bits(least) * $u.plane.z);
                        any |= needed > 0;
                        continue;
                    }
                }
                let worked = block!(updates, $size, $folder::$module [$format, $second], levels $levels gpu $gpu, n, first, y, $u, $mode,
                    inputs, ($($read),*));
                any |= worked;
                let untouched = unoccluded.as_ref().is_some_and(|kept| all_are(&inputs, &kept.record, n));
                $chunk.marks.set(number, untouched);
            }
        }
        any
    }};
    ($access:ident, $size:expr, $folder:ident::$module:ident $generics:tt, $levels:ident $([$($level:literal)*] gpu $gpu:literal)?,
     $u:ident, $chunk:ident, $mode:ident, $reads:tt) => {{
        let record = Records::<{ $size }>::new($chunk.output, $chunk.rows as usize * $chunk.width as usize);
        let mut any = false;
        for row in $chunk.inside.clone() {
            let y = $chunk.first_row + row;
            let mut x = $chunk.columns.start;
            while x < $chunk.columns.end {
                let n = LANES.min(($chunk.columns.end - x) as usize);
                let at = (row * $chunk.width + x) as usize;
                // SAFETY: rows of the chunk have `width` records, so `at + n` is at most their number.
                let inputs = unsafe { record.at(at) };
                let worked = block!($access, $size, $folder::$module $generics, $levels $([$($level)*] gpu $gpu)?, n, x, y, $u, $mode,
                    inputs, $reads);
                any |= worked;
                x += n as u32;
            }
        }
        any
    }};
}

macro_rules! declare {
    ($($name:ident: $uniforms:ident, [$($number:literal $read:ident: $element:ident),*],
       $access:ident $out:literal [$size:expr],
       $folder:ident::$module:ident $generics:tt, $levels:ident $([$($level:literal)*] gpu $gpu:literal $($keeps:ident)?)?, modes [$($mode:literal)*];)*) => {
        /// The kernels, by name.
        pub mod kernels {
            use super::*;
            $(
                #[doc = concat!("See [`", stringify!($module), "`](crate::", stringify!($folder), "::", stringify!($module), ").")]
                #[allow(non_upper_case_globals)]
                pub static $name: Kernel = Kernel {
                    declaration: Declaration {
                        name: stringify!($name),
                        uniform_bytes: size_of::<$uniforms>(),
                        components: $size,
                        rests: rests!($($($keeps)?)?),
                        keeps_unoccluded: keeps_unoccluded!($($($keeps)?)?),
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
                fn rows(u: &$uniforms, chunk: &mut Chunk<'_>, mode: u32) -> bool {
                    let mut reads = chunk.reads.iter();
                    $(let $read: &[$element] = bytemuck::cast_slice(reads.next().copied().unwrap_or(&[0]));)*
                    all_rows!($access, $size, $folder::$module $generics, $levels $([$($level)*] gpu $gpu $($keeps)?)?, u, chunk, mode, ($($read),*))
                }

                #[inline(always)]
                fn specialised(u: &$uniforms, chunk: &mut Chunk<'_>) -> bool {
                    match u.dispatch.z {
                        $($mode => rows(u, chunk, $mode),)*
                        other => unreachable!("{} has no mode {other}", stringify!($name)),
                    }
                }

                #[cfg(target_arch = "x86_64")]
                #[target_feature(enable = "avx2")]
                fn avx2(u: &$uniforms, chunk: &mut Chunk<'_>) -> bool {
                    specialised(u, chunk)
                }

                #[cfg(target_arch = "x86_64")]
                #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
                fn avx512(u: &$uniforms, chunk: &mut Chunk<'_>) -> bool {
                    specialised(u, chunk)
                }

                fn baseline(u: &$uniforms, chunk: &mut Chunk<'_>) -> bool {
                    rows(u, chunk, u.dispatch.z)
                }

                pub fn run(set: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
                    assert!(set.is_available(), "{set:?} is not available on this machine");
                    // An argument of its own: a reference in a structure may, to LLVM, point into the output, and then everything
                    // that is derived from uniforms is computed anew for every block.
                    let u: &$uniforms = bytemuck::from_bytes(chunk.uniforms);
                    match set {
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
        )*
    };
}

/// The column of a lane.
#[inline(always)]
fn column(x: u32, lane: usize) -> u32 {
    debug_assert!(x.checked_add(lane as u32).is_some());
    // SAFETY: `x + lane` is below the dispatch's width, a `u32`. Knowing that the sum does not wrap lets neighbouring lanes' reads
    // become one contiguous load.
    unsafe { x.unchecked_add(lane as u32) }
}

/// The chunk's part of a planar buffer: for each component, where its floats start.
#[derive(Clone, Copy)]
struct Records<const N: usize>([*mut f32; N]);

impl<const N: usize> Records<N> {
    /// All records of the chunk: `count` of them.
    #[inline(always)]
    fn new(output: &mut [&mut [f32]], count: usize) -> Self {
        assert!(output.len() == N && output.iter().all(|component| component.len() >= count));
        let mut starts = [core::ptr::null_mut(); N];
        for (start, component) in starts.iter_mut().zip(output) {
            *start = component.as_mut_ptr();
        }
        Self(starts)
    }

    /// Those from number `at` on.
    ///
    /// # Safety
    /// `at` must be at most their number.
    #[inline(always)]
    unsafe fn at(&self, at: usize) -> Self {
        // SAFETY: the caller's promise.
        Self(self.0.map(|start| unsafe { start.add(at) }))
    }
}

/// The record of a lane, straight from the buffer: only components that a level uses are read.
#[inline(always)]
fn take<const N: usize>(before: &Records<N>, lane: usize) -> [f32; N] {
    let mut record = [0.0; N];
    for (component, start) in record.iter_mut().zip(before.0) {
        // SAFETY: lanes count the invocations of a block, for each of which there is a record.
        *component = unsafe { *start.add(lane) };
    }
    record
}

#[inline(always)]
fn put<const N: usize>(lanes: &mut [[f32; LANES]; N], lane: usize, record: [f32; N]) {
    for (lanes, component) in lanes.iter_mut().zip(record) {
        // SAFETY: `lane` counts to at most `LANES`. See `take`.
        unsafe { *lanes.get_unchecked_mut(lane) = component };
    }
}

/// Remembers the level that a lane needs.
#[inline(always)]
fn put_level(levels: &mut [u32; LANES], lane: usize, level: u32) {
    // SAFETY: as in `put`.
    unsafe { *levels.get_unchecked_mut(lane) = level };
}

/// The level that a lane needs.
#[inline(always)]
fn level_of(levels: &[u32; LANES], lane: usize) -> u32 {
    // SAFETY: as in `put`.
    unsafe { *levels.get_unchecked(lane) }
}

/// `record`, or what it was before.
#[inline(always)]
fn choose<const N: usize>(changed: bool, mut record: [f32; N], before: [f32; N]) -> [f32; N] {
    for (component, before) in record.iter_mut().zip(before) {
        *component = select(changed, *component, before);
    }
    record
}

#[inline(always)]
fn copy_out<const N: usize>(lanes: &[[f32; LANES]; N], output: &Records<N>, n: usize) {
    // Of a length that is known, a copy is two instructions instead of a call.
    if n < LANES {
        // A copy is handed over: the array itself must not leave this function, see `block`.
        let lanes = *lanes;
        return copy_some(&lanes, output, n);
    }
    for (lanes, start) in lanes.iter().zip(output.0) {
        // SAFETY: there is a record for each of the block's `LANES` invocations; nothing else refers to the chunk's part of the
        // buffer while the kernel runs.
        unsafe { start.cast::<[f32; LANES]>().write_unaligned(*lanes) };
    }
}

/// Writes `record` to `n` invocations.
#[inline(always)]
fn fill<const N: usize>(output: &Records<N>, record: &[f32; N], n: usize) {
    for (component, start) in record.iter().zip(output.0) {
        for lane in 0..n {
            // SAFETY: as in `copy_out`, for `n` invocations.
            unsafe { *start.add(lane) = *component };
        }
    }
}

/// Whether `n` invocations have the bits of `record`.
#[inline(always)]
fn all_are<const N: usize>(output: &Records<N>, record: &[f32; N], n: usize) -> bool {
    let mut differs = 0;
    for (component, start) in record.iter().zip(output.0) {
        for lane in 0..n {
            // SAFETY: as in `take`.
            differs |= unsafe { *start.add(lane) }.to_bits() ^ component.to_bits();
        }
        // Most blocks that differ do so in their first component.
        if differs != 0 {
            return false;
        }
    }
    true
}

#[inline(never)]
fn copy_some<const N: usize>(lanes: &[[f32; LANES]; N], output: &Records<N>, n: usize) {
    for (lanes, start) in lanes.iter().zip(output.0) {
        // SAFETY: as in `copy_out`, for `n` invocations.
        unsafe { start.copy_from_nonoverlapping(lanes.as_ptr(), n) };
    }
}

for_each_kernel!(declare);
