//! Fixed-point sums that any invocation may add to. Integers can be added in any order with the same result, so that both
//! backends get the same bits whichever invocation comes first.
//!
//! A sum has two words, 64 bits in two's complement: what the low word cannot hold is carried to the high one, so that no number
//! of contributions makes it wrap.

use super::access::read;
use crate::math::{absolute, floor_to_int, select};

/// Words that are added to atomically.
pub trait Sums {
    /// Adds `value` to the word at `index` and returns what was there before; does nothing beyond the end.
    fn add(&mut self, index: usize, value: u32) -> u32;
}

#[cfg(target_arch = "spirv")]
impl Sums for [u32] {
    #[inline(always)]
    fn add(&mut self, index: usize, value: u32) -> u32 {
        use spirv_std::arch::{IndexUnchecked as _, atomic_i_add};
        use spirv_std::memory::{Scope, Semantics};
        const SCOPE: u32 = Scope::QueueFamily as u32;
        const SEMANTICS: u32 = Semantics::NONE.bits();
        if index < self.len() {
            // SAFETY: the index is below the length; all words are only added to while the kernel runs.
            unsafe { atomic_i_add::<u32, SCOPE, SEMANTICS>(self.index_unchecked_mut(index), value) }
        } else {
            0
        }
    }
}

/// The words as the CPU's threads share them.
#[cfg(not(target_arch = "spirv"))]
pub struct SharedSums<'a>(pub &'a [core::sync::atomic::AtomicU32]);

#[cfg(not(target_arch = "spirv"))]
impl Sums for SharedSums<'_> {
    #[inline(always)]
    fn add(&mut self, index: usize, value: u32) -> u32 {
        // Nothing is read until the pass has ended, which synchronises the threads.
        self.0.get(index).map_or(0, |word| word.fetch_add(value, core::sync::atomic::Ordering::Relaxed))
    }
}

/// `x` in units of 1 / `scale`, rounded to the nearest; |x · scale| must be below 2³⁰.
#[inline(always)]
pub fn quantise(x: f32, scale: f32) -> i32 {
    floor_to_int(x * scale + 0.5, -1_073_741_824.0, 1_073_741_824.0)
}

/// Adds `value` to the sum whose low word is at `index`.
#[inline(always)]
pub fn add<S: Sums + ?Sized>(sums: &mut S, index: i32, value: i32) {
    if value != 0 {
        let low = value as u32;
        let before = sums.add(index as usize, low);
        let carry = (before.wrapping_add(low) < low) as u32;
        let high = ((value >> 31) as u32).wrapping_add(carry);
        if high != 0 {
            sums.add(index as usize + 1, high);
        }
    }
}

/// The sum whose low word is at `index`, in units.
#[inline(always)]
pub fn sum(sums: &[u32], index: i32) -> f32 {
    to_number(read(sums, index), read(sums, index + 1))
}

/// A number of 64 bits in two's complement, rounded to a float.
#[inline(always)]
pub fn to_number(low: u32, high: u32) -> f32 {
    let negative = high >> 31 != 0;
    // The magnitude, whose leading bits must not cancel.
    let borrowed = (low == 0) as u32;
    let low = if negative { (!low).wrapping_add(1) } else { low };
    let high = if negative { (!high).wrapping_add(borrowed) } else { high };
    // Sixteen bits at a time: conversions are then exact on every device.
    let half = |word: u32| (word & 0xffff) as i32 as f32;
    let size = (half(high >> 16) * 65536.0 + half(high)) * 4_294_967_296.0 + (half(low >> 16) * 65536.0 + half(low));
    select(negative, -absolute(size), size)
}
