//! A volume without its noise, with its edges.

use super::slab::{Sizes, binomial, filter_all, mean};
use crate::error::Error;
use rayon::prelude::*;
use vitrum_io::{Shared, Volume, Voxels, require_memory};

/// The most bytes of one part of a volume while it is filtered: parts follow one after another.
const PART: usize = 256 << 20;

/// Arrays of a part's size that the filter holds.
const ARRAYS: usize = 8;

/// The volume, smoothed with a radius in voxels; `noise` is the deviation of its values, above 0, and `usual` a value in the midst of them.
///
/// The filter is the guided one (He, Sun and Tang 2013), in three dimensions: within each window the result is the straight line through the
/// values over those of a guide that fits them best, and lines of windows are averaged. Where the guide differs by less than the noise the line is
/// flat, and the result a mean over some hundred voxels; across an edge it follows the guide. The guide is the volume itself under a binomial
/// filter, so that noise on edges, where light bends, is smoothed along with the rest; lines as steep as the values demand make edges as
/// high as they were.
///
/// Along axes with wider spacing the radius is as much smaller, down to none.
pub(crate) fn smoothed(volume: &Volume, radius: u32, noise: f32, usual: f32) -> Result<Volume, Error> {
    let sizes = volume.dimensions.map(|size| size as usize);
    let count: usize = sizes.iter().product();
    let wide = matches!(volume.voxels, Voxels::F32(_));
    require_memory(&volume.name, (count * if wide { 4 } else { 2 } + PART) as u64)?;
    let finest = volume.finest_spacing();
    let radii = [0, 1, 2].map(|axis| {
        let along = (radius as f32 * finest / volume.spacing[axis]).round() as usize;
        along.min(sizes[axis] / 2)
    });
    let (scale, offset) = (volume.value_scale, volume.value_offset);
    let mut stored = volume.range.map(|value| (value - offset) / scale);
    stored.sort_by(f32::total_cmp);
    let [low, high] = stored;
    if high <= low {
        return Ok(volume.clone());
    }
    let filter = Guided { radii, variance: noise * noise, scale, middle: usual - offset, part: PART };
    // The mapping of stored numbers in 16 bits: 8 bits would show steps where there was noise.
    let step = (high - low) / f32::from(u16::MAX);
    let voxels = match &volume.voxels {
        Voxels::F32(values) => {
            let mut smooth = room(count);
            filter.run(sizes, |index| values[index], &mut smooth, |value| value);
            Voxels::from(smooth)
        }
        Voxels::U8(values) => {
            let mut smooth = room(count);
            filter.run(
                sizes,
                |index| f32::from(values[index]),
                &mut smooth,
                |value| ((value - low) / step).round() as u16,
            );
            Voxels::from(smooth)
        }
        Voxels::U16(values) => {
            let mut smooth = room(count);
            filter.run(
                sizes,
                |index| f32::from(values[index]),
                &mut smooth,
                |value| ((value - low) / step).round() as u16,
            );
            Voxels::from(smooth)
        }
    };
    let mut made = Volume { voxels, ..volume.clone() };
    if !wide {
        (made.value_scale, made.value_offset) = (step * scale, low * scale + offset);
    }
    // The range stays that of the scan, as transfer functions without points go by it.
    Ok(made)
}

/// `count` zeros that become shared without a copy.
fn room<T: bytemuck::Pod>(count: usize) -> Vec<T> {
    let mut values = Vec::with_capacity(Shared::<T>::room(count));
    values.resize(count, T::zeroed());
    values
}

/// The filter, with its radius along each axis.
struct Guided {
    radii: [usize; 3],
    /// The variance of values that counts as noise.
    variance: f32,
    /// Values over stored ones.
    scale: f32,
    /// Taken away from values: products of small numbers keep their digits.
    middle: f32,
    /// The most bytes of a part.
    part: usize,
}

impl Guided {
    /// Filters stored values part by part into `to`.
    fn run<T: Send>(
        &self,
        sizes: Sizes,
        value: impl Fn(usize) -> f32 + Sync,
        to: &mut [T],
        store: impl Fn(f32) -> T + Sync,
    ) {
        let [width, height, depth] = sizes;
        let plane = width * height;
        // Three filters reach so far, one after another.
        let margin = 3 * self.radii[2];
        let slices = (self.part / (4 * ARRAYS * plane)).saturating_sub(2 * margin).max(16);
        for (part, to) in to.chunks_mut(slices * plane).enumerate() {
            let (first, end) = (part * slices, part * slices + to.len() / plane);
            let (from, until) = (first.saturating_sub(margin), (end + margin).min(depth));
            let voxels = (from * plane..until * plane).into_par_iter();
            let values = voxels.map(|index| value(index) * self.scale - self.middle).collect();
            let smooth = self.filtered(values, [width, height, until - from]);
            let smooth = &smooth[(first - from) * plane..];
            to.par_iter_mut().zip(smooth).for_each(|(to, value)| *to = store((value + self.middle) / self.scale));
        }
    }

    /// A part of the volume, filtered; its outer slices, up to three radii, only where the volume ends there.
    fn filtered(&self, values: Vec<f32>, sizes: Sizes) -> Vec<f32> {
        let windows = self.radii.map(mean);
        let ends = || [f32::INFINITY, f32::NEG_INFINITY];
        let wider = |[low, high]: [f32; 2], [lower, higher]: [f32; 2]| [low.min(lower), high.max(higher)];
        let [low, high] = values.par_iter().map(|&value| [value; 2]).reduce(ends, wider);
        let mut spare = vec![0.0; values.len()];
        let mut guide = values.clone();
        filter_all(&mut guide, &mut spare, sizes, &self.radii.map(binomial));
        let mut over = |mut array: Vec<f32>| {
            filter_all(&mut array, &mut spare, sizes, &windows);
            array
        };
        let products = |a: &[f32], b: &[f32]| a.par_iter().zip(b).map(|(a, b)| a * b).collect::<Vec<f32>>();
        let mut slope = over(products(&guide, &values));
        let squares = over(products(&guide, &guide));
        let mean_guide = over(guide.clone());
        let mut height = over(values);
        slope.par_iter_mut().zip(&mut height).zip(squares.par_iter().zip(&mean_guide)).for_each(
            |((slope, height), (square, guide))| {
                let covariance = *slope - guide * *height;
                *slope = covariance / ((square - guide * guide).max(0.0) + self.variance);
                *height -= *slope * guide;
            },
        );
        drop((squares, mean_guide));
        let (slope, mut height) = (over(slope), over(height));
        height.par_iter_mut().zip(slope.par_iter().zip(&guide)).for_each(|(height, (slope, guide))| {
            *height = (*height + slope * guide).clamp(low, high);
        });
        height
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preset::testing::{Normal, ball};
    use glam::DVec3;

    const SIZE: u32 = 48;

    fn volume(voxels: Vec<f32>) -> Volume {
        Volume::new("test", [SIZE; 3], [1.0; 3], Voxels::from(voxels)).expect("a volume")
    }

    fn noisy(voxels: Vec<f32>, deviation: f32) -> Volume {
        let mut normal = Normal::default();
        volume(voxels.into_iter().map(|value| value + deviation * normal.next()).collect())
    }

    fn at(index: u32) -> [f32; 3] {
        [index % SIZE, index / SIZE % SIZE, index / (SIZE * SIZE)].map(|index| index as f32)
    }

    fn all() -> impl Iterator<Item = u32> {
        0..SIZE.pow(3)
    }

    /// From 0 to 1000 over a voxel, around x = `place`.
    fn step(place: f32) -> Vec<f32> {
        all().map(|index| 1000.0 * (at(index)[0] - place + 0.5).clamp(0.0, 1.0)).collect()
    }

    /// A volume's means over y and z, along x.
    fn profile(volume: &Volume) -> Vec<f32> {
        let inner = 8..SIZE - 8;
        let mean = |x: u32| {
            let plane = inner.clone().flat_map(|z| inner.clone().map(move |y| (y, z)));
            let sum: f32 = plane.map(|(y, z)| volume.value(x, y, z)).sum();
            sum / (inner.len() * inner.len()) as f32
        };
        (0..SIZE).map(mean).collect()
    }

    #[test]
    fn an_edge_stays_where_it_is() {
        for place in [20.0_f32, 20.3, 20.5] {
            for deviation in [0.0, 20.0, 60.0] {
                let before = noisy(step(place), deviation);
                // The least rise over the three voxels around the edge: the windows are 3, 5 and 7 wide.
                for (radius, least) in [(1, 950.0), (2, 880.0), (3, 800.0)] {
                    let after = smoothed(&before, radius, deviation.max(10.0), 1000.0).expect("there is memory");
                    let means = profile(&after);
                    let behind = means.iter().position(|&mean| mean > 500.0).expect("there is an edge");
                    let (low, high) = (means[behind - 1], means[behind]);
                    let moved = (behind - 1) as f32 + (500.0 - low) / (high - low) - place;
                    assert!(moved.abs() < 0.1, "{place}, noise {deviation}, radius {radius}: moved by {moved}");
                    let at = |x: f32| {
                        let index = x.floor() as usize;
                        means[index] + (means[index + 1] - means[index]) * x.fract()
                    };
                    let rise = at(place + 1.5) - at(place - 1.5);
                    assert!(rise > least, "{place}, noise {deviation}, radius {radius}: {rise}");
                }
            }
        }
    }

    #[test]
    fn noise_becomes_a_small_share_of_itself() {
        for deviation in [10.0, 100.0] {
            let before = noisy(vec![1000.0; SIZE.pow(3) as usize], deviation);
            // Where the line is flat a value is a mean of means, over 27, 125 and 343 voxels each: 0.11, 0.05, 0.03 by the sum of squared
            // weights; a guide that is less smooth than that leaves as much again at the smallest radius.
            for (radius, share) in [(1, 0.16), (2, 0.07), (3, 0.04)] {
                let after = smoothed(&before, radius, deviation, 1000.0).expect("there is memory");
                let inner = |index: &u32| at(*index).iter().all(|&along| along > 8.0 && along < SIZE as f32 - 9.0);
                let values: Vec<f32> =
                    all().filter(inner).map(|index| after.voxels.stored(index as usize).expect("inside")).collect();
                let mean = values.iter().sum::<f32>() / values.len() as f32;
                let variance =
                    values.iter().map(|value| (value - mean) * (value - mean)).sum::<f32>() / values.len() as f32;
                assert!((mean - 1000.0).abs() < 0.02 * deviation, "{mean}");
                assert!(variance.sqrt() < share * deviation, "radius {radius}: {}", variance.sqrt() / deviation);
            }
        }
    }

    /// The mean angle, in degrees, between the gradient on a ball's surface and the ball's radius: what refraction goes by.
    fn direction_error(volume: &Volume) -> f64 {
        let middle = DVec3::splat(0.5 * (f64::from(SIZE) - 1.0));
        let angle = |index: u32| {
            let [x, y, z] = at(index).map(|along| along as u32);
            let from_middle = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) - middle;
            ((from_middle.length() - 0.35 * f64::from(SIZE)).abs() < 0.7).then(|| {
                let difference = |a: f32, b: f32| f64::from(a - b);
                let gradient = DVec3::new(
                    difference(volume.value(x - 1, y, z), volume.value(x + 1, y, z)),
                    difference(volume.value(x, y - 1, z), volume.value(x, y + 1, z)),
                    difference(volume.value(x, y, z - 1), volume.value(x, y, z + 1)),
                );
                libm::acos(gradient.normalize().dot(from_middle.normalize())).to_degrees()
            })
        };
        let angles: Vec<f64> = all().filter_map(angle).collect();
        angles.iter().sum::<f64>() / angles.len() as f64
    }

    #[test]
    fn a_noisy_ball_bends_light_as_a_ball_does() {
        for deviation in [30.0, 80.0] {
            let before = noisy(ball(SIZE), deviation);
            let rough = direction_error(&before);
            for (radius, share) in [(1, 0.5), (2, 0.3), (3, 0.2)] {
                let after = smoothed(&before, radius, deviation, 1000.0).expect("there is memory");
                let smooth = direction_error(&after);
                assert!(smooth < share * rough, "noise {deviation}, radius {radius}: {smooth}° of {rough}°");
            }
        }
    }

    #[test]
    fn parts_fit_together() {
        let before = noisy(ball(SIZE), 40.0);
        let values: Vec<f32> = all().map(|index| before.voxels.stored(index as usize).expect("inside")).collect();
        let filtered = |part: usize| {
            let filter = Guided { radii: [2; 3], variance: 1600.0, scale: 1.0, middle: 1000.0, part };
            let mut to = vec![0.0_f32; values.len()];
            filter.run([SIZE as usize; 3], |index| values[index], &mut to, |value| value);
            to
        };
        for (whole, parts) in filtered(PART).iter().zip(filtered(0)) {
            assert!((whole - parts).abs() < 1e-2, "{whole} and {parts}");
        }
    }

    #[test]
    fn few_bits_become_sixteen_and_floats_stay() {
        let stored: Vec<u8> = ball(SIZE).into_iter().map(|value| (value / 5.0) as u8).collect();
        let few = Volume::new("few", [SIZE; 3], [1.0; 3], Voxels::from(stored)).expect("a volume");
        let few = few.with_value_mapping(-5.0, 300.0).expect("a mapping");
        let made = smoothed(&few, 1, 10.0, 1000.0).expect("there is memory");
        assert!(matches!(made.voxels, Voxels::U16(_)));
        assert_eq!((made.range, made.dimensions), (few.range, few.dimensions));
        assert!((made.value(24, 24, 24) - few.value(24, 24, 24)).abs() < 0.05, "{}", made.value(24, 24, 24));
        assert!((made.value(0, 0, 0) - 300.0).abs() < 0.05);
        assert!(matches!(
            smoothed(&noisy(ball(SIZE), 1.0), 1, 10.0, 0.0).expect("there is memory").voxels,
            Voxels::F32(_)
        ));
        // Slices far apart are not mixed.
        let slices: Vec<f32> = all().map(|index| (at(index)[2] as u32 % 2 * 1000) as f32).collect();
        let apart = Volume { spacing: [1.0, 1.0, 5.0], ..volume(slices) };
        assert_eq!(smoothed(&apart, 2, 10.0, 500.0).expect("there is memory").value(9, 9, 9), 1000.0);
    }
}
