//! What a declaration in the [list](super::list) becomes: a SPIR-V entry point, and a [`Kernel`](super::Kernel) that the CPU runs.
//!
//! `kernels!` matches the grammar. For each declaration `family!` makes the names, one for each format of voxels if it is of a family;
//! `number!` makes the bindings; `entry_point!` and `host!` make the two results, which call the kernel's functions through `call!`.

macro_rules! kernels {
    ($($folder:ident: $uniforms:ident {
        $($module:ident $(<$family:ident>)? ($($read:ident $(: $element:ident)?),*) $access:ident $record:ident
          $(, levels [$($level:ident)*] $(few [$($few:ident)*])?)?
          $(, modes $group:ident [$($mode:ident $(= $general:ident)?),*])?
          $(, skip [$($skip:ident)*])?
          $(, reports $report:ident)?;)*
    })*) => {
        $($(family! {
            [$($family)?] [$($report)?] $folder $uniforms $module ($($read $(: $element)?),*) $access $record
            [$($($level)*)?] [$($($($few)*)?)?] [$($group [$($mode $(= $general)?),*])?] [$($($skip)*)?]
        })*)*

        /// The kernels of each declaration.
        #[cfg(not(target_arch = "spirv"))]
        const DECLARED: &[&[&Kernel]] = &[$($(declared!([$($family)?] $folder $module)),*),*];
    };
}

/// Names a declaration's kernel, or its kernels for each format of voxels. Features select the entry points of a SPIR-V module; the host has all kernels.
macro_rules! family {
    ([] $report:tt $folder:ident $uniforms:ident $module:ident $($rest:tt)*) => {
        #[cfg(any(not(target_arch = "spirv"), feature = "kernels-without-voxels"))]
        pastey::paste! { number! { $report [<$folder _ $module>] [] $folder $uniforms $module $($rest)* } }
    };
    ([$family:ident] $report:tt $folder:ident $uniforms:ident $module:ident $($rest:tt)*) => {
        pastey::paste! {
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u8>] [U8] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u16>] [U16] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-floats"))]
            number! { $report [<$folder _ $module _f32>] [F32] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-floats"))]
            number! { $report [<$folder _ $module _f32_with_ior>] [F32WithIor] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u16_with_color>] [U16WithColor] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u16_with_bodies>] [U16WithBodies] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u8_paged>] [U8Paged] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-integers"))]
            number! { $report [<$folder _ $module _u16_paged>] [U16Paged] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-floats"))]
            number! { $report [<$folder _ $module _f32_paged>] [F32Paged] $folder $uniforms $module $($rest)* }
            #[cfg(any(not(target_arch = "spirv"), feature = "kernels-of-floats"))]
            number! { $report [<$folder _ $module _f32_with_ior_paged>] [F32WithIorPaged] $folder $uniforms $module $($rest)* }

            #[doc = concat!("See [`", stringify!($module), "`](crate::", stringify!($folder), "::", stringify!($module), ").")]
            #[cfg(not(target_arch = "spirv"))]
            #[allow(non_upper_case_globals)]
            pub static [<$folder _ $module>]: Family = Family(declared!([$family] $folder $module));
        }
    };
}

/// A declaration's kernels, those of a family in the order of [`Format::ALL`](crate::abi::format::Format::ALL).
#[cfg(not(target_arch = "spirv"))]
macro_rules! declared {
    ([] $folder:ident $module:ident) => {
        pastey::paste! { &[&[<$folder _ $module>]] }
    };
    ([$family:ident] $folder:ident $module:ident) => {
        pastey::paste! {
            &[
                &[<$folder _ $module _u8>],
                &[<$folder _ $module _u16>],
                &[<$folder _ $module _f32>],
                &[<$folder _ $module _f32_with_ior>],
                &[<$folder _ $module _u16_with_color>],
                &[<$folder _ $module _u16_with_bodies>],
                &[<$folder _ $module _u8_paged>],
                &[<$folder _ $module _u16_paged>],
                &[<$folder _ $module _f32_paged>],
                &[<$folder _ $module _f32_with_ior_paged>],
            ]
        }
    };
}

/// Numbers the buffers that a kernel reads, the one that it writes and the one in which it reports work, if it does; `volume` stands for the
/// four buffers of voxels.
macro_rules! number {
    ($report:tt $name:ident $format:tt $folder:ident $uniforms:ident $module:ident ($($reads:tt)*) $($rest:tt)*) => {
        number! { @reads $report [$name $format $folder $uniforms $module $($rest)*] [] [1 2 3 4 5 6 7] $($reads)* }
    };
    (@reads $report:tt $head:tt [$($done:tt)*] [$a:literal $b:literal $c:literal $d:literal $($free:literal)*] volume $(, $($reads:tt)*)?) => {
        number! {
            @reads $report $head [$($done)* $a voxels: u32, $b ior_voxels: u32, $c occupancy: u32, $d tables: u32,] [$($free)*] $($($reads)*)?
        }
    };
    (@reads $report:tt $head:tt [$($done:tt)*] [$next:literal $($free:literal)*] $read:ident: $element:ident $(, $($reads:tt)*)?) => {
        number! { @reads $report $head [$($done)* $next $read: $element,] [$($free)*] $($($reads)*)? }
    };
    (@reads [] $head:tt $reads:tt [$out:literal $($free:literal)*]) => {
        number! { @done $head $reads $out [] }
    };
    (@reads [work] $head:tt $reads:tt [$out:literal $workgroups:literal $($free:literal)*]) => {
        number! { @done $head $reads $out [$workgroups] }
    };
    (@done [$($head:tt)*] $reads:tt $out:literal $workgroups:tt) => {
        #[cfg(target_arch = "spirv")]
        entry_point! { $($head)* $reads $out $workgroups }
        #[cfg(not(target_arch = "spirv"))]
        host! { $($head)* $reads $out $workgroups }
    };
}

/// Calls one of a kernel's functions: with the record so far if it updates, with `last` if there is one.
macro_rules! call {
    (updates, $function:expr, ($($first:expr),*), $before:expr, [$($read:expr),*] $(, $last:expr)?) => {
        $function($($first,)* $before, $($read,)* $($last)?)
    };
    ($access:ident, $function:expr, ($($first:expr),*), $before:expr, [$($read:expr),*] $(, $last:expr)?) => {{
        let _ = $before;
        $function($($first,)* $($read,)* $($last)?)
    }};
}
