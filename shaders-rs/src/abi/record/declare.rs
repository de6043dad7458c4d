//! `record!`: what the declaration of a record's fields becomes.

/// A record: a struct whose fields are stored as components, one behind the other in the order of the declaration.
///
/// A field is an `f32`, an `i32` that is stored as a number, a `Vec3`, or a `Color`, a `Vec3` of red, green and blue. Its module has the
/// struct, `SIZE`, `NAMES` of the components, and for each field by its name in capitals the number of its first component. A record of more
/// components than a kernel can store does not compile.
macro_rules! record {
    ($(#[$about:meta])* $module:ident: $record:ident { $($(#[$doc:meta])* $field:ident: $kind:ident,)* } $($more:item)*) => {
        pastey::paste! {
            $(#[$about])*
            pub mod $module {
                $(#[$about])*
                #[derive(Clone, Copy)]
                #[cfg_attr(not(target_arch = "spirv"), derive(Debug, PartialEq))]
                pub struct $record {
                    $($(#[$doc])* pub $field: record!(@type $kind),)*
                }

                record! { @numbers (0); $($(#[$doc])* [<$field:upper>]: $kind,)* }

                const _: () = assert!(SIZE <= crate::kernel::record::MOST, "kernels store fewer components");

                /// The components' names.
                #[cfg(not(target_arch = "spirv"))]
                pub const NAMES: [&str; SIZE] = crate::abi::record::declare::flatten(&[$(&record!(@names $field $kind) as &[&str]),*]);

                impl $record {
                    /// From its components.
                    #[inline(always)]
                    pub fn load(record: &[f32; SIZE]) -> Self {
                        Self { $($field: record!(@load $kind record [<$field:upper>])),* }
                    }

                    /// Its components.
                    #[inline(always)]
                    pub fn store(self) -> [f32; SIZE] {
                        let mut record = [0.0; SIZE];
                        $(record!(@store $kind record [<$field:upper>] (self.$field));)*
                        record
                    }
                }

                $($more)*
            }
        }
        pub use $module::$record;
    };

    (@numbers ($size:expr);) => {
        /// Components.
        pub const SIZE: usize = $size;
    };
    (@numbers ($at:expr); $(#[$doc:meta])* $name:ident: $kind:ident, $($rest:tt)*) => {
        $(#[$doc])*
        pub const $name: usize = $at;
        record! { @numbers ($name + record!(@size $kind)); $($rest)* }
    };

    (@type f32) => { f32 };
    (@type i32) => { i32 };
    (@type Vec3) => { spirv_std::glam::Vec3 };
    (@type Color) => { spirv_std::glam::Vec3 };
    (@size f32) => { 1 };
    (@size i32) => { 1 };
    (@size Vec3) => { 3 };
    (@size Color) => { 3 };
    (@names $field:ident f32) => { [stringify!($field)] };
    (@names $field:ident i32) => { [stringify!($field)] };
    (@names $field:ident Vec3) => {
        [concat!(stringify!($field), ".x"), concat!(stringify!($field), ".y"), concat!(stringify!($field), ".z")]
    };
    (@names $field:ident Color) => {
        [concat!(stringify!($field), ".red"), concat!(stringify!($field), ".green"), concat!(stringify!($field), ".blue")]
    };
    (@load f32 $record:ident $at:ident) => { $record[$at] };
    (@load i32 $record:ident $at:ident) => { $record[$at] as i32 };
    (@load Vec3 $record:ident $at:ident) => {
        spirv_std::glam::Vec3::new($record[$at], $record[$at + 1], $record[$at + 2])
    };
    (@load Color $record:ident $at:ident) => { record!(@load Vec3 $record $at) };
    (@store f32 $record:ident $at:ident $value:expr) => { $record[$at] = $value };
    (@store i32 $record:ident $at:ident $value:expr) => { $record[$at] = $value as f32 };
    (@store Vec3 $record:ident $at:ident $value:expr) => {
        $record[$at] = $value.x;
        $record[$at + 1] = $value.y;
        $record[$at + 2] = $value.z;
    };
    (@store Color $record:ident $at:ident $value:expr) => { record!(@store Vec3 $record $at $value) };
}

/// Names in groups, one behind the other.
#[cfg(not(target_arch = "spirv"))]
pub(super) const fn flatten<const N: usize>(groups: &[&[&'static str]]) -> [&'static str; N] {
    let mut names = [""; N];
    let (mut count, mut group) = (0, 0);
    while group < groups.len() {
        let mut at = 0;
        while at < groups[group].len() {
            names[count] = groups[group][at];
            count += 1;
            at += 1;
        }
        group += 1;
    }
    assert!(count == N, "each component has a name");
    names
}
