//! The visible voxels of a volume, as runs along x, and the parts that hang together.

use super::visible::Visible;
use rayon::prelude::*;
use vitrum_io::{Volume, Voxels};

/// Visible voxels side by side: those of a row from `start` to before `end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    /// The row, y + z · height.
    pub(crate) row: u32,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// All runs of a volume, row by row.
pub(crate) fn runs(volume: &Volume, visible: &Visible) -> Vec<Run> {
    let shows = |stored: f32| visible.holds(stored * volume.value_scale + volume.value_offset);
    match &volume.voxels {
        Voxels::U8(voxels) => {
            let table: Vec<bool> = (0..=u8::MAX).map(|stored| shows(f32::from(stored))).collect();
            of_rows(voxels, volume.dimensions[0], |stored: u8| table[usize::from(stored)])
        }
        Voxels::U16(voxels) => {
            let table: Vec<bool> = (0..=u16::MAX).map(|stored| shows(f32::from(stored))).collect();
            of_rows(voxels, volume.dimensions[0], |stored: u16| table[usize::from(stored)])
        }
        Voxels::F32(voxels) => of_rows(voxels, volume.dimensions[0], shows),
    }
}

fn of_rows<T: Copy + Sync>(voxels: &[T], width: u32, shows: impl Fn(T) -> bool + Sync) -> Vec<Run> {
    let rows = voxels.par_chunks(width as usize).enumerate();
    rows.flat_map_iter(|(row, voxels)| {
        let mut runs: Vec<Run> = Vec::new();
        for (x, _) in (0..).zip(voxels).filter(|(_, voxel)| shows(**voxel)) {
            match runs.last_mut() {
                Some(run) if run.end == x => run.end += 1,
                _ => runs.push(Run { row: row as u32, start: x, end: x + 1 }),
            }
        }
        runs
    })
    .collect()
}

/// For each run the number of voxels of the part that it belongs to; voxels hang together by their faces.
pub(crate) fn part_sizes(runs: &[Run], [_, height, depth]: [u32; 3]) -> Vec<u64> {
    let rows = height as usize * depth as usize;
    // The first run of each row, and the end of the last.
    let mut first = vec![0_usize; rows + 1];
    runs.iter().for_each(|run| first[run.row as usize + 1] += 1);
    (0..rows).for_each(|row| first[row + 1] += first[row]);
    let mut parts = Parts { above: (0..runs.len() as u32).collect() };
    for row in 0..rows {
        let beside = (row % height as usize > 0).then(|| row - 1);
        for other in beside.into_iter().chain(row.checked_sub(height as usize)) {
            join(runs, first[row]..first[row + 1], first[other]..first[other + 1], &mut parts);
        }
    }
    let mut sizes = vec![0_u64; runs.len()];
    for (index, run) in runs.iter().enumerate() {
        sizes[parts.root(index as u32) as usize] += u64::from(run.end - run.start);
    }
    (0..runs.len() as u32).map(|index| sizes[parts.root(index) as usize]).collect()
}

/// Joins runs of two neighbouring rows that lie beside each other.
fn join(runs: &[Run], mut here: std::ops::Range<usize>, mut there: std::ops::Range<usize>, parts: &mut Parts) {
    while !here.is_empty() && !there.is_empty() {
        let (a, b) = (runs[here.start], runs[there.start]);
        if a.start < b.end && b.start < a.end {
            parts.join(here.start as u32, there.start as u32);
        }
        if a.end < b.end {
            here.start += 1;
        } else {
            there.start += 1;
        }
    }
}

/// Sets of runs: each names one above it, the topmost itself.
struct Parts {
    above: Vec<u32>,
}

impl Parts {
    fn root(&mut self, mut of: u32) -> u32 {
        while self.above[of as usize] != of {
            let above = self.above[self.above[of as usize] as usize];
            self.above[of as usize] = above;
            of = above;
        }
        of
    }

    fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.root(a), self.root(b)];
        self.above[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{OpacityPoint, Scene};
    use crate::shown::visible::By;

    #[test]
    fn parts_hang_together_by_their_faces() {
        // Two slices: a ring over both, a lone voxel, and one that touches the ring by an edge.
        let picture = ["###..#", "#.#...", "###...", "...#..", "......", ".#.#..", "......", "......"];
        let voxels: Vec<u8> = picture.iter().flat_map(|row| row.bytes().map(|byte| u8::from(byte == b'#'))).collect();
        let volume = Volume::new("parts", [6, 4, 2], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        let mut scene = Scene::default();
        scene.transfer.opacity =
            vec![OpacityPoint { value: 0.5, opacity: 0.0 }, OpacityPoint { value: 0.6, opacity: 1.0 }];
        let visible = Visible::new(&scene, By::Both, (volume.extent(), volume.range, 1.0));
        let runs = runs(&volume, &visible);
        assert_eq!(runs.len(), 8);
        assert_eq!(runs[1], Run { row: 0, start: 5, end: 6 });
        let sizes = part_sizes(&runs, volume.dimensions);
        // Row by row; below the ring's left bottom… (1, 1) of the second slice touches nothing.
        assert_eq!(sizes, [8, 1, 8, 8, 8, 1, 1, 1]);
    }
}
