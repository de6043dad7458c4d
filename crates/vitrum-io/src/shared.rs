//! Numbers in memory that several can hold at once: one copy of a volume serves the caller and the kernels.

use bytemuck::Pod;
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// Bytes behind the numbers, so that four can be read from each of them on.
const TAIL: usize = 4;

/// Numbers behind which there is room: see [`Shared::room`].
#[derive(Clone)]
struct Roomy<T> {
    /// The numbers, then zeros.
    values: Vec<T>,
    count: usize,
}

/// Numbers in shared memory, copied only when one of several owners changes them. A clone shares the memory.
#[derive(Clone)]
pub struct Shared<T>(Arc<Roomy<T>>);

impl<T: Pod> Shared<T> {
    /// Capacity that a vector of `count` numbers needs to become shared without a copy.
    #[must_use]
    pub const fn room(count: usize) -> usize {
        let bytes = (count.saturating_mul(size_of::<T>())).next_multiple_of(4).saturating_add(TAIL);
        bytes.div_ceil(size_of::<T>())
    }

    /// Mutable access to the numbers, which are copied first if they have another owner.
    pub fn make_mut(&mut self) -> &mut [T] {
        let Roomy { values, count } = Arc::make_mut(&mut self.0);
        &mut values[..*count]
    }

    /// The numbers as whole little-endian words, with zeros behind them; `None` where they do not lie at a word's address.
    pub(crate) fn words(&self) -> Option<&[u32]> {
        bytemuck::try_cast_slice(&self.0.values).ok()
    }
}

impl<T: Pod> From<Vec<T>> for Shared<T> {
    fn from(mut values: Vec<T>) -> Self {
        let count = values.len();
        let room = Self::room(count);
        values.reserve_exact(room - count);
        values.resize(room, T::zeroed());
        Self(Arc::new(Roomy { values, count }))
    }
}

impl<T: Pod> FromIterator<T> for Shared<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        values.into_iter().collect::<Vec<T>>().into()
    }
}

impl<T> Deref for Shared<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.0.values[..self.0.count]
    }
}

impl<T: PartialEq> PartialEq for Shared<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: fmt::Debug> fmt::Debug for Shared<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::Shared;

    #[test]
    fn words_hold_the_numbers_and_room_behind() {
        for count in 1..20_usize {
            let bytes: Shared<u8> = (0..count).map(|byte| byte as u8 + 1).collect();
            let words = bytes.words().expect("allocators align to words");
            assert!(words.len() * 4 >= count + 4 && words.len() * 4 < count + 8, "{count}");
            let all: &[u8] = bytemuck::cast_slice(words);
            assert_eq!((&all[..count], bytes.len()), (&*bytes, count));
            assert!(all[count..].iter().all(|&byte| byte == 0));
            let halves: Shared<u16> = (0..count as u16).collect();
            assert_eq!(halves.words().map(<[u32]>::len), Some((2 * count).div_ceil(4) + 1));
        }
    }

    #[test]
    fn a_vector_with_room_stays_where_it_is() {
        let mut values = Vec::with_capacity(Shared::<u16>::room(1001));
        values.resize(1001, 7_u16);
        let before = values.as_ptr();
        assert_eq!(Shared::from(values).as_ptr(), before);
    }

    #[test]
    fn changing_one_leaves_its_clone() {
        let mut one: Shared<f32> = [1.0, 2.0].into_iter().collect();
        let other = one.clone();
        assert_eq!(one.as_ptr(), other.as_ptr());
        one.make_mut()[0] = 5.0;
        assert_eq!((&*one, &*other), ([5.0, 2.0].as_slice(), [1.0, 2.0].as_slice()));
    }
}
