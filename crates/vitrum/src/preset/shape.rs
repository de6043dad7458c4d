//! Measures of a volume's shape: its thickness along rays, and its ruggedness.

use super::subject::Subject;
use vitrum_io::Volume;

/// The most samples along an edge: enough for statistics, quick for any volume.
const SAMPLES: u32 = 64;

/// Voxels between samples, and samples, along each axis.
pub(super) fn sampling(volume: &Volume) -> ([u32; 3], [u32; 3]) {
    let step = volume.dimensions.map(|size| size.div_ceil(SAMPLES));
    (step, std::array::from_fn(|axis| volume.dimensions[axis].div_ceil(step[axis])))
}

/// Density along rays through the grid, in reference lengths: the mean over the axes of the 95th percentile.
pub(super) fn thickness(volume: &Volume, subject: &Subject) -> f32 {
    let (step, count) = sampling(volume);
    let [nx, ny, nz] = count.map(|count| count as usize);
    let mut sums = [vec![0.0_f32; ny * nz], vec![0.0; nx * nz], vec![0.0; nx * ny]];
    for z in 0..nz {
        for y in 0..ny {
            for x in 0..nx {
                let index = [x as u32 * step[0], y as u32 * step[1], z as u32 * step[2]];
                let density = subject.density(volume.value(index[0], index[1], index[2]));
                sums[0][y + ny * z] += density;
                sums[1][x + nx * z] += density;
                sums[2][x + nx * y] += density;
            }
        }
    }
    let thick = |axis: usize, sums: &mut Vec<f32>| {
        sums.sort_by(f32::total_cmp);
        let typical = sums[(sums.len() - 1) * 95 / 100];
        typical * step[axis] as f32 * volume.spacing[axis] / subject.reference_length
    };
    sums.iter_mut().enumerate().map(|(axis, sums)| thick(axis, sums)).sum::<f32>() / 3.0
}

/// The index contrast that the shape bears, 0 to 1: rays stay together in a compact body, but thin branches, pores and noise each
/// refract them anew until nothing can be recognised.
///
/// The measure is the surface's area over the volume it encloses, times the longest edge: 6 for a ball that fills the
/// grid, some dozens for organs and machines, hundreds for vessels and noise.
pub(super) fn clarity(volume: &Volume, surface: f32) -> f32 {
    const BEARABLE: f32 = 40.0;
    const LEAST: f32 = 0.1;
    let (step, [nx, ny, nz]) = sampling(volume);
    let [sx, sy, sz] = volume.spacing;
    // A face is part of the boundary if matter is on one side of it only.
    let faces = [sy * sz, sx * sz, sx * sy];
    let (mut area, mut inside) = (0.0_f64, 0_u32);
    for z in (0..nz).map(|index| index * step[2]) {
        for y in (0..ny).map(|index| index * step[1]) {
            for x in (0..nx).map(|index| index * step[0]) {
                let matter = |x, y, z| volume.value(x, y, z) >= surface;
                let here = matter(x, y, z);
                inside += u32::from(here);
                let beside = [matter(x + 1, y, z), matter(x, y + 1, z), matter(x, y, z + 1)];
                let crossed = faces.iter().zip(beside).filter(|&(_, other)| other != here);
                area += crossed.map(|(face, _)| f64::from(*face)).sum::<f64>();
            }
        }
    }
    let enclosed = f64::from(inside) * f64::from(sx) * f64::from(sy) * f64::from(sz);
    let longest = volume.extent().into_iter().fold(0.0, f32::max);
    // Faces of voxels are half as much again as the smooth surface that they stand for.
    let ruggedness = (area / 1.5 / enclosed) as f32 * longest;
    // A volume without matter gives no number to divide by.
    if ruggedness.is_finite() { (BEARABLE / ruggedness).clamp(LEAST, 1.0) } else { LEAST }
}

#[cfg(test)]
mod tests {
    use super::clarity;
    use vitrum_io::{Volume, Voxels};

    fn volume(size: u32, matter: impl Fn(u32, u32, u32) -> bool) -> Volume {
        let voxel = |index: u32| u8::from(matter(index % size, index / size % size, index / (size * size)));
        let voxels = Voxels::U8((0..size.pow(3)).map(voxel).collect());
        Volume::new("test", [size; 3], [0.1; 3], voxels).expect("the volume is valid")
    }

    #[test]
    fn a_ball_is_clear_at_any_resolution_and_scattered_matter_is_not() {
        for size in [16, 48, 100] {
            let ball = |x: u32, y: u32, z: u32| {
                let squared = |coordinate: u32| (2 * i64::from(coordinate) + 1 - i64::from(size)).pow(2);
                squared(x) + squared(y) + squared(z) < i64::from(size).pow(2)
            };
            assert_eq!(clarity(&volume(size, ball), 0.5), 1.0);
        }
        let scattered = clarity(&volume(48, |x, y, z| (x * 7 + y * 13 + z * 29) % 5 == 0), 0.5);
        assert!(scattered < 0.4, "{scattered}");
        assert_eq!(clarity(&volume(8, |_, _, _| false), 0.5), 0.1, "nothing is not clear");
    }
}
