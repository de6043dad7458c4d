//! The SPIR-V entry points, generated from the list of kernels: they read their record, call the kernel, store its record.

use crate::abi::Dispatched as _;
use crate::abi::grid::format;
use crate::abi::probe::ProbeUniforms;
use crate::abi::record::{film, irradiance, light, mirror, path, probe, ray, sheet, sums, trace, view};
use crate::abi::shadow::ShadowUniforms;
use crate::abi::sweep::SweepUniforms;
use crate::abi::voxelize::VoxelizeUniforms;
use crate::abi::voxels::VoxelsUniforms;
use crate::for_each_kernel;
use crate::kernel::record;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

macro_rules! out_element {
    (adds) => {
        u32
    };
    ($access:ident) => {
        f32
    };
}

/// A kernel that rests runs over several planes in one dispatch: it gets the uniform blocks of all.
macro_rules! blocks {
    ($uniforms:ident rests) => {
        [$uniforms]
    };
    ($uniforms:ident $($keeps:ident)?) => {
        $uniforms
    };
}

macro_rules! first {
    ($blocks:ident rests) => {
        &$blocks[0]
    };
    ($blocks:ident $($keeps:ident)?) => {
        $blocks
    };
}

macro_rules! body {
    (updates [$size:expr], $folder:ident::$module:ident [$($generic:expr),*], levels $levels:tt gpu $all:literal rests, $id:ident, $blocks:ident,
     $count:ident, $index:ident, $out:ident, ($($read:ident),*)) => {
        let mut record = record::load::<{ $size }>($out, $index, $count);
        let mut changed = false;
        let mut block = 0;
        while block < $blocks.len() {
            let u = &$blocks[block];
            let level = crate::$folder::$module::level::<$({ $generic }),*>($id.x, $id.y, u, u.dispatch.z, record $(, $read)*);
            if level > 1 {
                record = crate::$folder::$module::invoke::<$({ $generic },)* $all>($id.x, $id.y, u, u.dispatch.z, record $(, $read)*);
                changed = true;
            }
            block += 1;
        }
        if changed {
            record::store::<{ $size }>($out, $index, $count, record);
        }
    };
    (adds [$size:expr], $folder:ident::$module:ident [], plain, $id:ident, $u:ident, $count:ident, $index:ident,
     $out:ident, ($($read:ident),*)) => {
        let _ = ($count, $index);
        crate::$folder::$module::invoke($id.x, $id.y, $u, $u.dispatch.z $(, $read)*, $out);
    };
    (writes [$size:expr], $folder:ident::$module:ident [$($generic:expr),*], plain, $id:ident, $u:ident, $count:ident, $index:ident,
     $out:ident, ($($read:ident),*)) => {
        record::store::<{ $size }>($out, $index, $count,
            crate::$folder::$module::invoke($id.x, $id.y, $u, $u.dispatch.z $(, $read)*));
    };
    (writes [$size:expr], $folder:ident::$module:ident [$($generic:expr),*], levels $levels:tt gpu $all:literal $($keeps:ident)?, $id:ident, $u:ident,
     $count:ident, $index:ident, $out:ident, ($($read:ident),*)) => {
        record::store::<{ $size }>($out, $index, $count,
            crate::$folder::$module::invoke::<$({ $generic },)* $all>($id.x, $id.y, $u, $u.dispatch.z $(, $read)*));
    };
    (updates [$size:expr], $folder:ident::$module:ident [$($generic:expr),*], levels $levels:tt gpu $all:literal $($keeps:ident)?, $id:ident, $u:ident,
     $count:ident, $index:ident, $out:ident, ($($read:ident),*)) => {
        let before = record::load::<{ $size }>($out, $index, $count);
        let level = crate::$folder::$module::level::<$({ $generic }),*>($id.x, $id.y, $u, $u.dispatch.z, before $(, $read)*);
        if level > 1 {
            record::store::<{ $size }>($out, $index, $count,
                crate::$folder::$module::invoke::<$({ $generic },)* $all>($id.x, $id.y, $u, $u.dispatch.z, before $(, $read)*));
        }
    };
}

macro_rules! entry_points {
    ($($name:ident: $uniforms:ident, [$($number:literal $read:ident: $element:ident),*],
       $access:ident $out:literal $size:tt,
       $folder:ident::$module:ident $generics:tt, $levels:ident $([$($level:literal)*] gpu $gpu:literal $($rests:ident)?)?, modes $modes:tt;)*) => {
        $(
            #[doc = concat!("Runs [`", stringify!($module), "`](crate::", stringify!($folder), "::", stringify!($module), ") for one index.")]
            #[spirv(compute(threads(8, 8)))]
            pub fn $name(
                #[spirv(global_invocation_id)] id: UVec3,
                #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] u: &blocks!($uniforms $($($rests)?)?),
                $(#[spirv(storage_buffer, descriptor_set = 0, binding = $number)] $read: &[$element],)*
                #[spirv(storage_buffer, descriptor_set = 0, binding = $out)] out: &mut [out_element!($access)],
            ) {
                let first = first!(u $($($rests)?)?);
                let window = first.window();
                let id = UVec3::new(id.x + window.x, id.y + window.y, 0);
                if id.x < window.z && id.y < window.w {
                    let count = first.dispatch.x * first.dispatch.y;
                    let index = id.y * first.dispatch.x + id.x;
                    body!($access $size, $folder::$module $generics, $levels $([$($level)*] gpu $gpu $($rests)?)?, id, u, count, index, out, ($($read),*));
                }
            }
        )*
    };
}

for_each_kernel!(entry_points);
