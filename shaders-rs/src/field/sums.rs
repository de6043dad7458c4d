//! Fixed-point sums that any invocation may add to. Integers can be added in any order with the same result, so that both
//! backends get the same bits whichever invocation comes first.
//!
//! Bits can be set, and words raised to the largest of many values, in any order as well.
//!
//! A sum has two words, 64 bits in two's complement: what the low word cannot hold is carried to the high one, so that no number
//! of contributions makes it wrap.

#[cfg(all(not(target_arch = "spirv"), target_has_atomic = "64"))]
use core::sync::atomic::AtomicU64;
#[cfg(not(target_arch = "spirv"))]
use core::sync::atomic::Ordering;

use super::access::read;
use crate::math::{absolute, floor_to_int, select};

/// Words that are changed atomically, each in ways that may come in any order.
pub trait Sums {
    /// Adds `value` to the word at `index` and returns the word before that; does nothing beyond the end.
    fn add(&mut self, index: usize, value: u32) -> u32;

    /// Adds a number of 64 bits to the one whose low word is at `index`, which is even; does nothing beyond the end.
    #[inline(always)]
    fn add_pair(&mut self, index: usize, low: u32, high: u32) {
        let before = self.add(index, low);
        let high = high.wrapping_add((before.wrapping_add(low) < low) as u32);
        if high != 0 {
            self.add(index + 1, high);
        }
    }

    /// As [`Self::add_pair`], for a number to which only invocations of one row of the dispatch add: a processor runs these one after the other.
    #[inline(always)]
    fn add_pair_of_row(&mut self, index: usize, low: u32, high: u32) {
        self.add_pair(index, low, high);
    }

    /// Sets the bits of `value` in the word at `index`; does nothing beyond the end.
    fn set(&mut self, index: usize, value: u32);

    /// Raises the word at `index` to `value` if it is below; does nothing beyond the end.
    fn raise(&mut self, index: usize, value: u32);
}

#[cfg(target_arch = "spirv")]
const SCOPE: u32 = spirv_std::memory::Scope::QueueFamily as u32;
#[cfg(target_arch = "spirv")]
const SEMANTICS: u32 = spirv_std::memory::Semantics::NONE.bits();

#[cfg(target_arch = "spirv")]
impl Sums for [u32] {
    #[inline(always)]
    fn add(&mut self, index: usize, value: u32) -> u32 {
        use spirv_std::arch::{IndexUnchecked as _, atomic_i_add};
        if index < self.len() {
            // SAFETY: the index is below the length; all words are only changed atomically while the kernel runs.
            unsafe { atomic_i_add::<u32, SCOPE, SEMANTICS>(self.index_unchecked_mut(index), value) }
        } else {
            0
        }
    }

    #[inline(always)]
    fn set(&mut self, index: usize, value: u32) {
        use spirv_std::arch::{IndexUnchecked as _, atomic_or};
        if index < self.len() {
            // SAFETY: as in `add`.
            unsafe { atomic_or::<u32, SCOPE, SEMANTICS>(self.index_unchecked_mut(index), value) };
        }
    }

    #[inline(always)]
    fn raise(&mut self, index: usize, value: u32) {
        use spirv_std::arch::{IndexUnchecked as _, atomic_u_max};
        if index < self.len() {
            // SAFETY: as in `add`.
            unsafe { atomic_u_max::<u32, SCOPE, SEMANTICS>(self.index_unchecked_mut(index), value) };
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
        self.0.get(index).map_or(0, |word| word.fetch_add(value, Ordering::Relaxed))
    }

    #[cfg(target_has_atomic = "64")]
    #[inline(always)]
    fn add_pair(&mut self, index: usize, low: u32, high: u32) {
        let Some(words) = self.0.get(index..).and_then(|words| words.first_chunk::<2>()) else { return };
        let pair = core::ptr::from_ref(words).cast::<AtomicU64>();
        if pair.is_aligned() {
            // SAFETY: the two words are alive for as long as the slice, aligned, and have the size of the pair; while the kernel runs all threads
            // change them as the same pair. Little-endian hosts, which `kernel` asserts, have the low word first. One locked instruction
            // instead of two or three.
            unsafe { &*pair }.fetch_add((u64::from(high) << 32) | u64::from(low), Ordering::Relaxed);
            return;
        }
        let before = self.add(index, low);
        self.add(index + 1, high.wrapping_add(u32::from(before.wrapping_add(low) < low)));
    }

    #[cfg(target_has_atomic = "64")]
    #[inline(always)]
    fn add_pair_of_row(&mut self, index: usize, low: u32, high: u32) {
        let Some(words) = self.0.get(index..).and_then(|words| words.first_chunk::<2>()) else { return };
        let pair = core::ptr::from_ref(words).cast::<AtomicU64>();
        if pair.is_aligned() {
            // SAFETY: as in `add_pair`. Without a locked instruction, which takes longer than all the arithmetic of a beam's pixel.
            let pair = unsafe { &*pair };
            let value = (u64::from(high) << 32) | u64::from(low);
            pair.store(pair.load(Ordering::Relaxed).wrapping_add(value), Ordering::Relaxed);
        } else {
            self.add_pair(index, low, high);
        }
    }

    #[inline(always)]
    fn set(&mut self, index: usize, value: u32) {
        // A look first: most bits are set more than once, and a locked instruction costs ten loads.
        if let Some(word) = self.0.get(index)
            && word.load(Ordering::Relaxed) & value != value
        {
            word.fetch_or(value, Ordering::Relaxed);
        }
    }

    #[inline(always)]
    fn raise(&mut self, index: usize, value: u32) {
        if let Some(word) = self.0.get(index)
            && word.load(Ordering::Relaxed) < value
        {
            word.fetch_max(value, Ordering::Relaxed);
        }
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
    add_words(sums, index, value as u32, (value >> 31) as u32);
}

/// Adds to two sums of 32 bits each that share the 64 bits at `index`.
#[inline(always)]
pub fn add_both<S: Sums + ?Sized>(sums: &mut S, index: i32, first: i32, second: i32) {
    add_words(sums, index, first as u32, second.wrapping_add(first >> 31) as u32);
}

/// The two sums that share the 64 bits at `index`, in units, as numbers.
#[inline(always)]
pub fn both(sums: &[u32], index: i32) -> (f32, f32) {
    let first = read(sums, index) as i32;
    // A negative first sum has borrowed from the second one.
    let second = (read(sums, index + 1) as i32).wrapping_sub(first >> 31);
    (first as f32, second as f32)
}

/// The two words, the low one first, that `value` units add to a sum: rounded to the nearest unit, or from 2³⁰ units on to the nearest 2²⁰; at most
/// 2⁵⁰ units.
#[inline(always)]
pub fn words(value: f32) -> (u32, u32) {
    let large = absolute(value) >= 1_073_741_824.0;
    let number = quantise(value, select(large, 1.0 / 1_048_576.0, 1.0));
    let shift = if large { 20 } else { 0 };
    // Two shifts, since a shift by 32 is undefined.
    ((number as u32) << shift, ((number >> 1) >> (31 - shift)) as u32)
}

/// Adds a number of two words to the sum whose low word is at `index`, to which only invocations of one row of the dispatch add.
#[inline(always)]
pub fn add_words_of_row<S: Sums + ?Sized>(sums: &mut S, index: i32, low: u32, high: u32) {
    if (low | high) != 0 {
        sums.add_pair_of_row(index as usize, low, high);
    }
}

/// Adds a number of two words to the sum whose low word is at `index`.
#[inline(always)]
pub fn add_words<S: Sums + ?Sized>(sums: &mut S, index: i32, low: u32, high: u32) {
    if (low | high) != 0 {
        sums.add_pair(index as usize, low, high);
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
