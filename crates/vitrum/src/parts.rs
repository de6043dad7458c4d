//! The parts of a picture that are rendered one after another, so that the memory of its rays has a bound.

use crate::method::RayTile;

/// A rectangle of a picture's pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rectangle {
    /// Its first column and row.
    pub first: [u32; 2],
    /// Pixels across and down.
    pub size: [u32; 2],
}

/// The parts of a picture of `size` pixels of `edge` × `edge` rays: nearly squares of at most `most` rays, but of a pixel at least, row by row.
/// Rays that are near one another run together.
pub(crate) fn parts(size: [u32; 2], edge: u32, most: u32) -> Vec<Rectangle> {
    let most = (most / (edge * edge)).max(1);
    let [width, height] = size;
    if u64::from(width) * u64::from(height) <= u64::from(most) {
        return vec![Rectangle { first: [0, 0], size }];
    }
    let across = width.div_ceil(most.isqrt().max(most / height));
    let down = height.div_ceil((most / width.div_ceil(across)).max(1));
    // Parts of one size, as far as pixels are whole.
    let edges = |count: u32, length: u32| -> Vec<u32> {
        (0..=count).map(|at| (u64::from(at) * u64::from(length) / u64::from(count)) as u32).collect()
    };
    let (columns, rows) = (edges(across, width), edges(down, height));
    let span = |pair: &[u32]| (pair[0], pair[1] - pair[0]);
    rows.windows(2)
        .flat_map(|row| columns.windows(2).map(move |column| (span(column), span(row))))
        .map(|((left, across), (top, down))| Rectangle { first: [left, top], size: [across, down] })
        .collect()
}

impl Rectangle {
    /// The rays of its pixels, and one more beside each of them that has one on the picture: what a ray sees of the environment is as wide as its neighbours
    /// say.
    pub fn tile(self, picture: [u32; 2], edge: u32) -> RayTile {
        let first = self.first.map(|first| (first * edge).saturating_sub(1));
        let end = |axis: usize| ((self.first[axis] + self.size[axis]) * edge + 1).min(picture[axis] * edge);
        RayTile { first, size: [end(0) - first[0], end(1) - first[1]] }
    }

    /// Leaves the rays of its pixels of planar records of the rays of its [`Self::tile`].
    pub fn trim(self, tile: RayTile, edge: u32, records: &mut Vec<f32>) {
        let [width, height] = tile.size.map(|n| n as usize);
        let [left, top] = [0, 1].map(|axis| (self.first[axis] * edge - tile.first[axis]) as usize);
        let [across, down] = self.size.map(|n| (n * edge) as usize);
        let planes = records.len() / (width * height).max(1);
        let rows = (0..planes).flat_map(|plane| (0..down).map(move |row| (plane * height + top + row) * width + left));
        // Rows move towards the front.
        for (row, from) in rows.enumerate() {
            records.copy_within(from..from + across, row * across);
        }
        records.truncate(planes * across * down);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_every_pixel_once_and_are_small() {
        for (size, edge, most) in [
            ([64, 48], 1, 4000),
            ([64, 48], 1, 500),
            ([64, 48], 3, 500),
            ([7, 1000], 2, 90),
            ([999, 1], 1, 10),
            ([5, 5], 4, 3),
        ] {
            let parts = parts(size, edge, most);
            let mut covered = vec![0; (size[0] * size[1]) as usize];
            for part in &parts {
                assert!(part.size[0] * part.size[1] <= (most / (edge * edge)).max(1), "{part:?} of {size:?}");
                for y in part.first[1]..part.first[1] + part.size[1] {
                    for x in part.first[0]..part.first[0] + part.size[0] {
                        covered[(y * size[0] + x) as usize] += 1;
                    }
                }
            }
            assert!(covered.iter().all(|&times| times == 1), "{size:?} in parts of {most} rays");
            let fewest = (size[0] * size[1]).div_ceil((most / (edge * edge)).max(1)) as usize;
            assert!(parts.len() <= 2 * fewest, "{} parts of {size:?}, where {fewest} would do", parts.len());
        }
    }

    #[test]
    fn a_tile_has_its_part_and_a_ray_around_it() {
        let picture = [9, 7];
        for part in parts(picture, 2, 32) {
            let tile = part.tile(picture, 2);
            // Two planes: the column and the row of each ray.
            let all = |axis: usize| {
                (0..tile.size[1])
                    .flat_map(move |y| (0..tile.size[0]).map(move |x| (tile.first[axis] + [x, y][axis]) as f32))
            };
            let mut records: Vec<f32> = all(0).chain(all(1)).collect();
            part.trim(tile, 2, &mut records);
            let rays = [part.size[0] * 2, part.size[1] * 2];
            let expected = |axis: usize| {
                (0..rays[1]).flat_map(move |y| (0..rays[0]).map(move |x| (part.first[axis] * 2 + [x, y][axis]) as f32))
            };
            assert_eq!(records, expected(0).chain(expected(1)).collect::<Vec<_>>());
            for axis in [0, 1] {
                let before = u32::from(part.first[axis] > 0);
                let behind = u32::from(part.first[axis] + part.size[axis] < picture[axis]);
                assert_eq!(tile.size[axis], part.size[axis] * 2 + before + behind);
            }
        }
    }
}
