//! Records in planar buffers: component `c` of record `index` out of `count` lies at `c · count + index`.
//!
//! Unrolled by hand: an array indexed by a variable would live in memory on the GPU.

/// Components that [`load`] and [`store`] are unrolled for.
pub const MOST: usize = 44;

/// Reads the record at `index`. One of more components than that does not compile.
#[inline(always)]
pub fn load<const N: usize>(buffer: &[f32], index: u32, count: u32) -> [f32; N] {
    const { assert!(N <= MOST, "load and store are unrolled for fewer components") };
    let mut record = [0.0; N];
    macro_rules! component {
        ($($c:literal)*) => {
            $(if N > $c {
                record[$c] = crate::field::access::read(buffer, ($c * count + index) as i32);
            })*
        };
    }
    component!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41 42 43);
    record
}

/// Writes the record at `index`; `index` must be below `count`, and the buffer hold `N · count` floats.
#[inline(always)]
pub fn store<const N: usize>(buffer: &mut [f32], index: u32, count: u32, record: [f32; N]) {
    const { assert!(N <= MOST, "load and store are unrolled for fewer components") };
    macro_rules! component {
        ($($c:literal)*) => {
            $(if N > $c {
                put(buffer, ($c * count + index) as usize, record[$c]);
            })*
        };
    }
    component!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41 42 43);
}

#[inline(always)]
fn put(buffer: &mut [f32], at: usize, value: f32) {
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::arch::IndexUnchecked as _;
        // SAFETY: entry points run for indices below `count` only, and backends check the buffer's size before a pass.
        unsafe { *buffer.index_unchecked_mut(at) = value }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        buffer[at] = value;
    }
}
