//! A kernel's functions as the loops of [`drive`](super::drive) call them.

/// Implements the loops' traits for `Body`, which holds a kernel's arguments.
macro_rules! adaptor {
    (@body adds [] [] [], $folder:ident $module:ident [] [$($read:ident)*]) => {
        impl<const FEW: bool> drive::Scatter for Body<'_, FEW> {
            #[inline(always)]
            fn scatter(&self, x: u32, y: u32, sums: &mut SharedSums<'_>) {
                call!(adds, crate::$folder::$module::invoke, (x, y, self.u, self.mode), (), [$(self.$read),*], sums);
            }
        }
    };
    (@body $access:ident [] [] [], $folder:ident $module:ident [] [$($read:ident)*]) => {
        impl<const FEW: bool> drive::Plain<SIZE> for Body<'_, FEW> {
            #[inline(always)]
            fn record(&self, x: u32, y: u32, before: [f32; SIZE]) -> [f32; SIZE] {
                call!($access, crate::$folder::$module::invoke, (x, y, self.u, self.mode), before, [$(self.$read),*])
            }
        }
    };
    (@body $access:ident $levels:tt [] $skip:tt, $($rest:tt)*) => { adaptor!(@body $access $levels $levels $skip, $($rest)*); };
    (@body $access:ident [$($level:ident)+] [$($few:ident)+] [$($skip:ident)*],
     $folder:ident $module:ident [$($format:ident)?] [$($read:ident)*]) => {
        impl<const FEW: bool> drive::Leveled<SIZE> for Body<'_, FEW> {
            const UPDATES: bool = adaptor!(@updates $access);

            #[inline(always)]
            fn level(&self, x: u32, y: u32, before: [f32; SIZE]) -> u32 {
                call!($access, crate::$folder::$module::level::<$(crate::abi::format::$format)?>,
                    (x, y, self.u, self.mode), before, [$(self.$read),*])
            }

            #[inline(always)]
            fn record<const LEVEL: u32>(&self, x: u32, y: u32, before: [f32; SIZE]) -> [f32; SIZE] {
                call!($access, crate::$folder::$module::invoke::<$(crate::abi::format::$format,)? LEVEL>,
                    (x, y, self.u, self.mode), before, [$(self.$read),*])
            }

            #[inline(always)]
            fn run(&self, needed: u32, block: &drive::Block<SIZE>, levels: &[u32; LANES]) {
                if FEW {
                    match needed {
                        $(..=crate::$folder::$module::level::$few =>
                            drive::run::<_, SIZE, { crate::$folder::$module::level::$few }>(self, block, levels),)+
                        _ => debug_assert!(false, "level {needed} is not in the list of kernels"),
                    }
                } else {
                    match needed {
                        $(..=crate::$folder::$module::level::$level =>
                            drive::run::<_, SIZE, { crate::$folder::$module::level::$level }>(self, block, levels),)+
                        _ => debug_assert!(false, "level {needed} is not in the list of kernels"),
                    }
                }
            }
        }
        adaptor!(@skips [$($skip)*] $access $folder $module [$($format)?] [$($read)*]);
    };
    (@skips [] $($rest:tt)*) => {};
    (@skips [$first:ident $($skip:ident)*] $($rest:tt)*) => {
        adaptor!(@$first $($rest)*);
        adaptor!(@skips [$($skip)*] $($rest)*);
    };
    (@updates updates) => { true };
    (@updates $access:ident) => { false };
    (@until $access:ident $folder:ident $module:ident [$($format:ident)?] [$($read:ident)*]) => {
        impl<const FEW: bool> drive::Until<SIZE> for Body<'_, FEW> {
            #[inline(always)]
            fn until(&self, x: u32, y: u32, before: [f32; SIZE], known: f32) -> f32 {
                call!($access, crate::$folder::$module::until::<$(crate::abi::format::$format)?>,
                    (x, y, self.u, self.mode), before, [$(self.$read),*], known)
            }
        }
    };
    (@same $access:ident $folder:ident $module:ident $format:tt $reads:tt) => {
        impl<const FEW: bool> drive::Keeps<SIZE> for Body<'_, FEW> {
            #[inline(always)]
            fn same(&self) -> Option<skip::Same<SIZE>> {
                crate::$folder::$module::same(self.u)
            }

            #[inline(always)]
            fn position(&self) -> (f32, f32) {
                self.u.position()
            }
        }
    };
}
