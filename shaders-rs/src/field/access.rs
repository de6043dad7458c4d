//! The one way a kernel reads a buffer: the index is limited to the buffer, so that no index is out of bounds and no bounds
//! check with its panic path gets into the loop.

use spirv_std::glam::Vec3;

/// `buffer[index]`, the index limited to the buffer. The buffer must not be empty (backends refuse empty ones).
#[inline(always)]
pub fn read<T: Copy>(buffer: &[T], index: i32) -> T {
    let last = buffer.len() as i32 - 1;
    let index = if index < last { index } else { last };
    let index = if index > 0 { index } else { 0 };
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::arch::IndexUnchecked as _;
        // SAFETY: limited to the buffer above.
        unsafe { *buffer.index_unchecked(index as usize) }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        debug_assert!(!buffer.is_empty());
        // SAFETY: limited to the buffer above, and backends refuse empty buffers. A checked access keeps the loop from
        // becoming vector code; the signed offset makes it a 32-bit gather.
        unsafe { *buffer.as_ptr().offset(index as isize) }
    }
}

/// The float in word `index` of `buffer`, the index limited to the buffer.
#[inline(always)]
pub fn read_float(buffer: &[u32], index: i32) -> f32 {
    f32::from_bits(read(buffer, index))
}

/// Three floats of `buffer` from `index` on, each index limited to the buffer.
#[inline(always)]
pub fn read_vector(buffer: &[f32], index: i32) -> Vec3 {
    Vec3::new(read(buffer, index), read(buffer, index + 1), read(buffer, index + 2))
}

/// `buffer[base + column]` without limiting the index: where `base` is the same for neighbouring invocations, their reads become
/// one contiguous load.
///
/// # Safety
/// `base + column` must lie inside the buffer.
#[inline(always)]
pub unsafe fn read_inside<T: Copy>(buffer: &[T], base: i32, column: u32) -> T {
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::arch::IndexUnchecked as _;
        // SAFETY: the caller's promise.
        unsafe { *buffer.index_unchecked((base + column as i32) as usize) }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        debug_assert!((0..buffer.len() as i32).contains(&(base + column as i32)));
        // SAFETY: the caller's promise. `wrapping_offset`, because `base` alone may lie before the buffer.
        unsafe { *buffer.as_ptr().wrapping_offset(base as isize).wrapping_add(column as usize) }
    }
}

/// The four bytes that start at byte `offset` of `buffer`, little endian, limited to the buffer.
#[inline(always)]
pub fn read_bytes(buffer: &[u32], offset: i32) -> u32 {
    #[cfg(target_arch = "spirv")]
    {
        let word = offset >> 2;
        let shift = ((offset & 3) * 8) as u32;
        let low = read(buffer, word) >> shift;
        // Two shifts, since a shift by 32 is undefined.
        let high = (read(buffer, word + 1) << 1) << (31 - shift);
        low | high
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        debug_assert!(!buffer.is_empty());
        let last = (buffer.len() as i32).wrapping_mul(4).wrapping_sub(4);
        let offset = if offset < last { offset } else { last };
        let offset = if offset > 0 { offset } else { 0 };
        // SAFETY: four bytes from `offset` lie inside the buffer. One unaligned load instead of two and a shift; the hosts'
        // byte order is little endian, which `kernel` asserts at compile time.
        unsafe { buffer.as_ptr().cast::<u8>().offset(offset as isize).cast::<u32>().read_unaligned() }
    }
}

/// The two 16-bit numbers from number `at` of `buffer` on, little endian, limited to the buffer: as [`read_bytes`] in a buffer of twice
/// the size.
#[inline(always)]
pub fn read_halves(buffer: &[u32], at: i32) -> u32 {
    #[cfg(target_arch = "spirv")]
    {
        let word = at >> 1;
        let shift = ((at & 1) * 16) as u32;
        let low = read(buffer, word) >> shift;
        // Two shifts, since a shift by 32 is undefined.
        let high = (read(buffer, word + 1) << 1) << (31 - shift);
        low | high
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        debug_assert!(!buffer.is_empty());
        let last = (buffer.len() as i32).wrapping_mul(2).wrapping_sub(2);
        let at = if at < last { at } else { last };
        let at = if at > 0 { at } else { 0 };
        // SAFETY: four bytes from there lie inside the buffer. See `read_bytes`.
        unsafe { buffer.as_ptr().cast::<u16>().offset(at as isize).cast::<u32>().read_unaligned() }
    }
}
