//! A volume without the small parts of what a scene shows of it.

use super::runs::{Run, part_sizes, runs};
use super::visible::Visible;
use vitrum_io::{Shared, Volume, Voxels};

/// The volume with the visible parts of fewer than `least` voxels made invisible: they get the value that lies beside them.
pub(crate) fn without_specks(volume: &Volume, visible: &Visible, least: u32) -> Volume {
    let all = runs(volume, visible);
    let sizes = part_sizes(&all, volume.dimensions);
    let specks: Vec<Run> =
        all.iter().zip(sizes).filter(|(_, size)| *size < u64::from(least)).map(|(run, _)| *run).collect();
    let mut made = volume.clone();
    match &mut made.voxels {
        Voxels::U8(voxels) => fill(voxels, volume.dimensions, &specks, &all),
        Voxels::U16(voxels) => fill(voxels, volume.dimensions, &specks, &all),
        Voxels::F32(voxels) => fill(voxels, volume.dimensions, &specks, &all),
    }
    made
}

/// A row that is all speck has nothing invisible beside it: the value before it or behind it among all voxels that are invisible.
fn fill<T: bytemuck::Pod>(voxels: &mut Shared<T>, [width, ..]: [u32; 3], specks: &[Run], all: &[Run]) {
    let Some(nothing) = invisible(voxels, width, all) else { return };
    if specks.is_empty() {
        return;
    }
    let width = width as usize;
    let voxels = voxels.make_mut();
    for &Run { row, start, end } in specks {
        let row = &mut voxels[row as usize * width..][..width];
        let (start, end) = (start as usize, end as usize);
        // Runs end where something is invisible.
        let value = start.checked_sub(1).map(|before| row[before]).or_else(|| row.get(end).copied());
        row[start..end].fill(value.unwrap_or(nothing));
    }
}

/// The value of the first voxel that is not visible.
fn invisible<T: Copy>(voxels: &[T], width: u32, all: &[Run]) -> Option<T> {
    let rows = voxels.len() / width as usize;
    let mut next = 0;
    for row in 0..rows {
        let mut x = 0;
        while let Some(run) = all.get(next).filter(|run| run.row as usize == row) {
            if run.start > x {
                break;
            }
            (x, next) = (run.end, next + 1);
        }
        if x < width {
            return voxels.get(row * width as usize + x as usize).copied();
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{OpacityPoint, Scene};
    use crate::shown::visible::By;

    #[test]
    fn specks_go_and_the_rest_stays() {
        // A ball of some thousand voxels, one voxel, two that touch, and a whole row.
        let size = 24_u32;
        let mut voxels = vec![3_u8; size.pow(3) as usize];
        let at = |x: u32, y: u32, z: u32| (x + size * (y + size * z)) as usize;
        for z in 4..16 {
            for y in 4..16 {
                for x in 4..16 {
                    voxels[at(x, y, z)] = 200;
                }
            }
        }
        let without = voxels.clone();
        voxels[at(20, 20, 20)] = 200;
        (voxels[at(2, 20, 7)], voxels[at(2, 21, 7)]) = (180, 220);
        (0..size).for_each(|x| voxels[at(x, 23, 23)] = 200);
        let volume = Volume::new("specks", [size; 3], [1.0; 3], Voxels::from(voxels.clone())).expect("a volume");
        let mut scene = Scene::default();
        let opacity = |value, opacity| OpacityPoint { value, opacity };
        scene.transfer.opacity = vec![opacity(100.0, 0.0), opacity(150.0, 1.0)];
        let visible = Visible::new(&scene, By::Both, (volume.extent(), volume.range, 1.0));
        let left = |least| match without_specks(&volume, &visible, least).voxels {
            Voxels::U8(voxels) => voxels.to_vec(),
            other => panic!("{other:?}"),
        };
        assert_eq!(left(1), voxels);
        assert_eq!(left(25), without);
        assert_eq!(left(1728), without);
        assert!(left(1729).iter().all(|&voxel| voxel == 3));
        let two = left(3);
        assert_eq!((two[at(20, 20, 20)], two[at(2, 20, 7)], two[at(5, 23, 23)]), (3, 3, 200));
    }
}
