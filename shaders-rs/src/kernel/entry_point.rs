//! The SPIR-V entry point of a declaration.

/// The SPIR-V entry point: it reads its record, calls the kernel at the highest level, stores its record.
macro_rules! entry_point {
    ($name:ident $format:tt $folder:ident $uniforms:ident $module:ident $access:ident $record:ident
     $levels:tt $few:tt $modes:tt $skip:tt [$($number:literal $read:ident: $element:ident,)*] $out:literal [$($next:literal)?]) => {
        #[doc = concat!("Runs [`", stringify!($module), "`](crate::", stringify!($folder), "::", stringify!($module), ") for one index.")]
        #[spirv(compute(threads(8, 8)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] u: &entry_point!(@blocks $folder $uniforms $skip),
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $number)] $read: &[$element],)*
            #[spirv(storage_buffer, descriptor_set = 0, binding = $out)] out: &mut [entry_point!(@element $access)],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $next)] workgroups: &mut [u32],)?
        ) {
            let first = entry_point!(@first u $skip);
            let (region, Dispatch { width, height, .. }) = (first.region(), first.dispatch());
            let id = UVec3::new(id.x + region.first_column, id.y + region.first_row, 0);
            if id.x < region.end_column && id.y < region.end_row {
                let count = width * height;
                let index = id.y * width + id.x;
                entry_point!(@body $access $levels $skip, $folder $module $format $record, id, u, count, index, out, [$($read),*]
                    $(, $next workgroups region)?);
            }
        }
    };
    // A kernel that skips until a later pass runs over several passes in one dispatch: it gets the uniform blocks of all.
    (@blocks $folder:ident $uniforms:ident [until]) => { [crate::abi::$folder::$uniforms] };
    (@blocks $folder:ident $uniforms:ident $skip:tt) => { crate::abi::$folder::$uniforms };
    (@first $u:ident [until]) => { &$u[0] };
    (@first $u:ident $skip:tt) => { $u };
    (@element adds) => { u32 };
    (@element $access:ident) => { f32 };
    (@body adds [] [], $folder:ident $module:ident [] $record:ident,
     $id:ident, $u:ident, $count:ident, $index:ident, $out:ident, $reads:tt) => {
        let _ = ($count, $index);
        call!(adds, crate::$folder::$module::invoke, ($id.x, $id.y, $u, $u.dispatch().mode), (), $reads, $out);
    };
    (@body writes [] [], $folder:ident $module:ident [] $record:ident,
     $id:ident, $u:ident, $count:ident, $index:ident, $out:ident, $reads:tt) => {
        let record = call!(writes, crate::$folder::$module::invoke, ($id.x, $id.y, $u, $u.dispatch().mode), (), $reads);
        record::store::<{ crate::abi::record::$record::SIZE }>($out, $index, $count, record);
    };
    (@body writes [$($level:ident)+] $skip:tt, $folder:ident $module:ident [] $record:ident,
     $id:ident, $u:ident, $count:ident, $index:ident, $out:ident, $reads:tt) => {
        const ALL: u32 = last(&[$(crate::$folder::$module::level::$level),+]);
        let record = call!(writes, crate::$folder::$module::invoke::<ALL>, ($id.x, $id.y, $u, $u.dispatch().mode), (), $reads);
        record::store::<{ crate::abi::record::$record::SIZE }>($out, $index, $count, record);
    };
    (@body updates [$($level:ident)+] [until], $folder:ident $module:ident [$($format:ident)?] $record:ident,
     $id:ident, $blocks:ident, $count:ident, $index:ident, $out:ident, $reads:tt) => {
        const ALL: u32 = last(&[$(crate::$folder::$module::level::$level),+]);
        let mut record = record::load::<{ crate::abi::record::$record::SIZE }>($out, $index, $count);
        let mut changed = false;
        let mut block = 0;
        while block < $blocks.len() {
            let u = &$blocks[block];
            let level = call!(updates, crate::$folder::$module::level::<$(crate::abi::format::$format)?>,
                ($id.x, $id.y, u, u.dispatch().mode), record, $reads);
            if level > 1 {
                record = call!(updates, crate::$folder::$module::invoke::<$(crate::abi::format::$format,)? ALL>,
                    ($id.x, $id.y, u, u.dispatch().mode), record, $reads);
                changed = true;
            }
            block += 1;
        }
        if changed {
            record::store::<{ crate::abi::record::$record::SIZE }>($out, $index, $count, record);
        }
    };
    (@body updates [$($level:ident)+] $skip:tt, $folder:ident $module:ident [$($format:ident)?] $record:ident,
     $id:ident, $u:ident, $count:ident, $index:ident, $out:ident, $reads:tt $(, $next:literal $workgroups:ident $region:ident)?) => {
        const ALL: u32 = last(&[$(crate::$folder::$module::level::$level),+]);
        let before = record::load::<{ crate::abi::record::$record::SIZE }>($out, $index, $count);
        let level = call!(updates, crate::$folder::$module::level::<$(crate::abi::format::$format)?>,
            ($id.x, $id.y, $u, $u.dispatch().mode), before, $reads);
        $(if level > 0 {
            workgroups::raise($workgroups, $region);
        })?
        if level > 1 {
            let record = call!(updates, crate::$folder::$module::invoke::<$(crate::abi::format::$format,)? ALL>,
                ($id.x, $id.y, $u, $u.dispatch().mode), before, $reads);
            record::store::<{ crate::abi::record::$record::SIZE }>($out, $index, $count, record);
        }
    };
}
