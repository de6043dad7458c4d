//! Chebyshev distances of bricks to the nearest brick that is not empty.

/// Turns a word of 0 for each brick that is not empty, and of a large number for the others, into the Chebyshev distance to the nearest
/// brick that is not empty, in bricks.
pub(super) fn spread(words: &mut [u32], bricks: [usize; 3]) {
    let [width, height, depth] = bricks;
    let row = |y: usize, z: usize| (z * height + y) * width;
    // The rows before one, in the order of `words`; behind it, counted from the end.
    let before = |y: usize, z: usize| {
        let same = (y > 0).then(|| (y - 1, z));
        let below = (z > 0).then(|| (y.saturating_sub(1)..=(y + 1).min(height - 1)).map(move |y| (y, z - 1)));
        same.into_iter().chain(below.into_iter().flatten())
    };
    for _ in 0..2 {
        for (z, y) in (0..depth).flat_map(|z| (0..height).map(move |y| (z, y))) {
            for other in before(y, z) {
                let (done, rest) = words.split_at_mut(row(y, z));
                let done = &done[row(other.0, other.1)..][..width];
                for x in 0..width {
                    let near = done[x.saturating_sub(1)..=(x + 1).min(width - 1)]
                        .iter()
                        .min()
                        .copied()
                        .unwrap_or(u32::MAX - 1);
                    rest[x] = rest[x].min(near + 1);
                }
            }
            let this = &mut words[row(y, z)..][..width];
            for x in 1..width {
                this[x] = this[x].min(this[x - 1] + 1);
            }
        }
        words.reverse();
    }
}
