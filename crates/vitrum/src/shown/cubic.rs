//! A volume on a finer grid, by the cubic spline through its values: linear interpolation there is nearly the cubic one of the volume.

use super::colors;
use super::spline::{AROUND, Between, curvatures, evaluate};
use crate::error::Error;
use crate::scene::Scene;
use rayon::prelude::*;
use vitrum_io::{Shared, Volume, Voxels, require_memory};

/// How many times finer the grid becomes along an axis: the chords of linear interpolation are then off by the inverse square of it of what they were.
pub(super) type Factors = [u32; 3];

/// Edge of a voxel of the finer grid that suffices, in pixels.
const PIXELS: f32 = 4.0;
/// The finest grid over the volume's own. Its chords are off by a 64th of what the volume's own are.
const MOST: u32 = 8;
/// The coarsest one. The chords are off by a quarter.
const LEAST: u32 = 2;
/// The most bytes of a grid that is finer than the coarsest one.
const MOST_BYTES: u64 = 1 << 30;

/// Bytes of a voxel of the finer grid: 8 bits would show steps.
fn voxel_bytes(volume: &Volume) -> u64 {
    if matches!(volume.voxels, Voxels::F32(_)) { 4 } else { 2 }
}

fn bytes(volume: &Volume, factors: Factors) -> u64 {
    let count = |axis: usize| u64::from(volume.dimensions[axis]) * u64::from(factors[axis]);
    (0..3).map(count).fold(voxel_bytes(volume), u64::saturating_mul)
}

/// The factors for a scene: as fine as the picture's pixels ask for, and memory allows. The volume's longest edge is taken to be as long as the picture's, with `camera.zoom`.
pub(super) fn factors(scene: &Scene, volume: &Volume) -> Factors {
    let film = &scene.film;
    let longest = volume.extent().into_iter().fold(f32::MIN_POSITIVE, f32::max);
    let pixels = film.width.max(film.height) as f32 * scene.camera.zoom / longest;
    let mut factors = volume.spacing.map(|spacing| ((spacing * pixels / PIXELS).ceil() as u32).clamp(LEAST, MOST));
    while bytes(volume, factors) > MOST_BYTES {
        let Some(largest) = factors.iter_mut().filter(|factor| **factor > LEAST).max() else { break };
        *largest -= 1;
    }
    factors
}

/// The volume on a grid that is so many times as fine, over the same box.
///
/// # Errors
/// [`vitrum_io::Error::TooLarge`] where the memory does not suffice.
pub(super) fn refined(volume: &Volume, factors: Factors) -> Result<Volume, Error> {
    let (scale, offset) = (volume.value_scale, volume.value_offset);
    let mut stored = volume.range.map(|value| (value - offset) / scale);
    stored.sort_by(f32::total_cmp);
    let [low, high] = stored;
    if high <= low {
        return Ok(volume.clone());
    }
    // Those along z, and the values that they are found from.
    let of_curvatures = volume.voxel_count() as u64 * 8;
    require_memory(
        &format!("{}, for `volume.interpolation = \"cubic\"`", volume.name),
        bytes(volume, factors) + of_curvatures,
    )?;
    let spline = Spline { sizes: volume.dimensions.map(|size| size as usize), factors };
    let step = (high - low) / f32::from(u16::MAX);
    let in_words = |value: f32| ((value - low) / step).round() as u16;
    let voxels = match &volume.voxels {
        Voxels::F32(values) => Voxels::from(spline.run(|index| values[index], |value| value.clamp(low, high))),
        Voxels::U8(values) => Voxels::from(spline.run(|index| f32::from(values[index]), in_words)),
        Voxels::U16(values) => Voxels::from(spline.run(|index| f32::from(values[index]), in_words)),
    };
    let colors = volume.colors.as_ref().map(|own| colors::refined(own, volume.dimensions, factors).into());
    let mut made = Volume { voxels, colors, ..volume.clone() };
    if voxel_bytes(volume) == 2 {
        (made.value_scale, made.value_offset) = (step * scale, low * scale + offset);
    }
    for (axis, factor) in factors.into_iter().enumerate() {
        made.dimensions[axis] *= factor;
        made.spacing[axis] /= factor as f32;
        // The outer faces stay where they are.
        let moved = 0.5 * (volume.spacing[axis] - made.spacing[axis]);
        made.origin.iter_mut().zip(volume.axes[axis]).for_each(|(origin, along)| *origin -= moved * along);
    }
    Ok(made)
}

/// The splines along the axes of a grid, one axis after the other.
struct Spline {
    sizes: [usize; 3],
    factors: Factors,
}

impl Spline {
    /// The values of the finer grid, as `store` stores them.
    fn run<T: bytemuck::Pod + Send>(
        &self,
        value: impl Fn(usize) -> f32 + Sync,
        store: impl Fn(f32) -> T + Sync,
    ) -> Vec<T> {
        let Self { sizes: [width, height, depth], factors } = *self;
        let plane = width * height;
        let curved = self.curvatures_along_z(&value);
        let [wide, high, deep] = [0, 1, 2].map(|axis| self.sizes[axis] * factors[axis] as usize);
        let mut fine = Vec::with_capacity(Shared::<T>::room(wide * high * deep));
        fine.resize(wide * high * deep, T::zeroed());
        fine.par_chunks_mut(wide * high).enumerate().for_each(|(index, to)| {
            let slice = |z: usize| (z * plane..(z + 1) * plane).map(&value).collect::<Vec<f32>>();
            let between = Between::new(index, factors[2], depth);
            let middle = match between {
                Between::End(end) => slice(end),
                Between::Behind(behind, _) => {
                    let first = behind.saturating_sub(AROUND);
                    let around: Vec<Vec<f32>> = (first..(behind + 2 + AROUND).min(depth)).map(slice).collect();
                    let mut middle = vec![0.0; plane];
                    evaluate(between, depth, |z| &around[z - first], &curved, &mut middle);
                    middle
                }
            };
            let rows = along_x(&middle, width, factors[0]);
            let row = |y: usize| &rows[y * wide..][..wide];
            let mut bent = vec![0.0; rows.len()];
            curvatures(height, row, &mut bent);
            let mut values = vec![0.0; wide];
            for (y, to) in to.chunks_mut(wide).enumerate() {
                evaluate(Between::new(y, factors[1], height), height, row, &bent, &mut values);
                to.iter_mut().zip(&values).for_each(|(to, value)| *to = store(*value));
            }
        });
        fine
    }

    /// The curvatures of the lines along z.
    fn curvatures_along_z(&self, value: &(impl Fn(usize) -> f32 + Sync)) -> Vec<f32> {
        let [width, height, depth] = self.sizes;
        let plane = width * height;
        let mut curved = vec![0.0; plane * depth];
        // Rows are parted among the threads; each thread's lie in all slices.
        let bands = split_in_bands(&mut curved, plane, width * height.div_ceil(4 * rayon::current_num_threads()));
        bands.into_par_iter().for_each(|(start, mut band)| {
            let lanes = band.first().map_or(0, |slice| slice.len());
            let values: Vec<Vec<f32>> =
                (0..depth).map(|z| (0..lanes).map(|lane| value(z * plane + start + lane)).collect()).collect();
            let mut found = vec![0.0; lanes * depth];
            curvatures(depth, |z| &values[z], &mut found);
            band.iter_mut().zip(found.chunks(lanes)).for_each(|(to, found)| to.copy_from_slice(found));
        });
        curved
    }
}

/// A band of rows: its first lane in a plane, and its lanes in each of the planes.
type Band<'a> = (usize, Vec<&'a mut [f32]>);

/// The planes of a grid in bands of `lanes` numbers of each plane.
fn split_in_bands(values: &mut [f32], plane: usize, lanes: usize) -> Vec<Band<'_>> {
    let mut bands: Vec<Band<'_>> = (0..plane.div_ceil(lanes)).map(|band| (band * lanes, Vec::new())).collect();
    for slice in values.chunks_mut(plane) {
        bands.iter_mut().zip(slice.chunks_mut(lanes)).for_each(|((_, band), part)| band.push(part));
    }
    bands
}

/// The rows of a plane on a grid that is `factor` times as fine along them.
fn along_x(plane: &[f32], width: usize, factor: u32) -> Vec<f32> {
    let height = plane.len() / width;
    let wide = width * factor as usize;
    // Rows become lanes, so that all of them are computed side by side.
    let turned: Vec<f32> = (0..width).flat_map(|x| (0..height).map(move |y| plane[y * width + x])).collect();
    let column = |x: usize| &turned[x * height..][..height];
    let mut bent = vec![0.0; plane.len()];
    curvatures(width, column, &mut bent);
    let mut rows = vec![0.0; wide * height];
    let mut values = vec![0.0; height];
    for x in 0..wide {
        evaluate(Between::new(x, factor, width), width, column, &bent, &mut values);
        values.iter().enumerate().for_each(|(y, value)| rows[y * wide + x] = *value);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A volume of `size`³ voxels in the cube from −1 to 1.
    fn volume(size: u32, of: impl Fn(DVec3) -> f64) -> Volume {
        let edge = 2.0 / f64::from(size);
        let place = |index: u32| (f64::from(index) + 0.5) * edge - 1.0;
        let all = (0..size.pow(3)).map(|index| [index % size, index / size % size, index / (size * size)]);
        let voxels: Vec<f32> = all.map(|at| of(DVec3::from_array(at.map(place))) as f32).collect();
        Volume::new("test", [size; 3], [edge as f32; 3], Voxels::from(voxels)).expect("a volume")
    }

    /// The trilinear interpolation at a place of the world.
    fn at(volume: &Volume, place: DVec3) -> f64 {
        let origin = DVec3::from_array(volume.origin.map(f64::from));
        let among = (place - origin) / DVec3::from_array(volume.spacing.map(f64::from));
        let (low, share) = (among.floor(), among - among.floor());
        let corner = |bits: u32| {
            let step = [0, 1, 2].map(|axis| f64::from(bits >> axis & 1));
            let [x, y, z] = [0, 1, 2].map(|axis| (low[axis] + step[axis]).max(0.0) as u32);
            let weights = [0, 1, 2].map(|axis| if step[axis] > 0.0 { share[axis] } else { 1.0 - share[axis] });
            f64::from(volume.value(x, y, z)) * weights.iter().product::<f64>()
        };
        (0..8).map(corner).sum()
    }

    /// Places here and there in the cube from −1/2 to 1/2.
    fn places() -> impl Iterator<Item = DVec3> {
        (1..400).map(|index| {
            let along = |root: f64| (f64::from(index) * root).fract() - 0.5;
            DVec3::new(along(0.754_877_666), along(0.569_840_291), along(0.430_159_709))
        })
    }

    /// A wave on a slope, whose greatest and least values are at the cube's corners.
    fn wave(at: DVec3) -> f64 {
        let waves = libm::cos(2.5 * at.x) * libm::cos(2.0 * at.y + 0.3) * libm::cos(1.5 * at.z - 0.2);
        waves + 3.0 * (at.x + at.y + at.z)
    }

    #[test]
    fn errors_fall_with_the_fourth_power_of_the_voxels_edge() {
        // Between the values of the finer grid lie chords: its own values tell the spline's error.
        let error = |size: u32| {
            let fine = refined(&volume(size, wave), [4; 3]).expect("there is memory");
            let place = |along: f64| ((along + 1.0) / f64::from(fine.spacing[0])).floor() as u32;
            let errors = places().map(|at| {
                let [x, y, z] = [at.x, at.y, at.z].map(place);
                let centre = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + 0.5;
                (f64::from(fine.value(x, y, z)) - wave(centre * f64::from(fine.spacing[0]) - 1.0)).abs()
            });
            errors.fold(0.0, f64::max)
        };
        let [coarse, half] = [8, 16].map(error);
        assert!(coarse / half > 12.0, "{coarse} with 8³ voxels, {half} with 16³");
        // Linear interpolation of the finer grid is off by its chords: a sixteenth of the volume's own.
        let chords =
            |volume: &Volume| places().map(|place| (at(volume, place) - wave(place)).abs()).fold(0.0, f64::max);
        let volume = volume(16, wave);
        let (linear, cubic) = (chords(&volume), chords(&refined(&volume, [4; 3]).expect("there is memory")));
        assert!(cubic < linear / 12.0, "{cubic} instead of {linear}");
    }

    #[test]
    fn a_grid_stays_where_it_is_and_a_slope_what_it_is() {
        let slope = |at: DVec3| 3.0 * at.x - 2.0 * at.y + at.z + 7.0;
        let coarse = Volume { axes: [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], ..volume(6, slope) };
        let fine = refined(&coarse, [2, 3, 4]).expect("there is memory");
        assert_eq!((fine.dimensions, fine.range), ([12, 18, 24], coarse.range));
        for axis in 0..3 {
            assert!((fine.extent()[axis] - coarse.extent()[axis]).abs() < 1e-6);
            let middle = |volume: &Volume| {
                let along =
                    |step: usize| 0.5 * (volume.extent()[step] - volume.spacing[step]) * volume.axes[step][axis];
                volume.origin[axis] + (0..3).map(along).sum::<f32>()
            };
            assert!((middle(&fine) - middle(&coarse)).abs() < 1e-6);
        }
        let straight = refined(&volume(6, slope), [2, 3, 4]).expect("there is memory");
        for place in places() {
            assert!((at(&straight, place) - slope(place)).abs() < 1e-5, "{place}");
        }
    }

    #[test]
    fn nothing_is_beyond_what_was_measured() {
        // Air, tissue and metal, edge to edge.
        let parts = |at: DVec3| {
            if at.x < -0.3 {
                -1000.0
            } else if at.length() < 0.7 {
                3000.0
            } else {
                40.0
            }
        };
        let coarse = volume(16, parts);
        let fine = refined(&coarse, [3; 3]).expect("there is memory");
        let Voxels::F32(values) = &fine.voxels else { panic!("floats stay floats") };
        for (index, &value) in values.iter().enumerate() {
            // The eight values around: an edge has nothing beside it that is beyond both of its sides.
            let fine_at = [index % 48, index / 48 % 48, index / (48 * 48)];
            let behind = fine_at.map(|along| ((along as f64 + 0.5) / 3.0 - 0.5).max(0.0) as u32);
            let around = (0..8).map(|bits: u32| {
                let [x, y, z] = [0, 1, 2].map(|axis| behind[axis] + (bits >> axis & 1));
                coarse.value(x, y, z)
            });
            let ends = around.fold([f32::MAX, f32::MIN], |[low, high], value| [low.min(value), high.max(value)]);
            assert!((ends[0] - 0.01..=ends[1] + 0.01).contains(&value), "{value} at {fine_at:?} of {ends:?}");
        }
        let bytes: Vec<u8> = (0..512_u32).map(|index| (index * 7919 % 251) as u8).collect();
        let few =
            Volume::new("few", [8; 3], [1.0; 3], Voxels::from(bytes)).and_then(|few| few.with_value_mapping(-2.0, 5.0));
        let few = few.expect("a volume");
        let fine = refined(&few, [3; 3]).expect("there is memory");
        assert!(matches!(fine.voxels, Voxels::U16(_)));
        assert!((fine.value(10, 13, 4) - few.value(3, 4, 1)).abs() < 0.01);
    }

    #[test]
    fn a_coarse_ball_is_rounder() {
        // Sixteen voxels across, with the edge that a scanner makes: a voxel's mean over its neighbourhood, nearly.
        let radius = 0.62;
        let ball = |at: DVec3| 1.0 / (1.0 + libm::exp((at.length() - radius) / 0.08));
        let coarse = volume(16, ball);
        // The mean angle, in degrees, between the gradient on the surface and the radius, and the mean distance of the surface from the sphere.
        let errors = |volume: &Volume| {
            let step = 0.5 * f64::from(volume.spacing[0]);
            let angles = places().map(|place| {
                let outwards = place.normalize();
                let (mut low, mut high) = (0.3, 0.9);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    if at(volume, outwards * middle) > 0.5 { low = middle } else { high = middle }
                }
                let point = outwards * low;
                let along = |axis: DVec3| at(volume, point - axis * step) - at(volume, point + axis * step);
                let normal = DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z)).normalize();
                [libm::acos(normal.dot(outwards).min(1.0)).to_degrees(), (low - radius).abs()]
            });
            let sum = angles.fold([0.0; 2], |sum, error| [sum[0] + error[0], sum[1] + error[1]]);
            sum.map(|sum| sum / places().count() as f64)
        };
        let (linear, cubic) = (errors(&coarse), errors(&refined(&coarse, [8; 3]).expect("there is memory")));
        println!("linear {linear:?}, cubic {cubic:?}");
        assert!(cubic[0] < 0.5 * linear[0] && cubic[1] < 0.5 * linear[1], "{cubic:?} instead of {linear:?}");
    }

    #[test]
    fn a_grid_is_as_fine_as_pixels_and_memory_are() {
        let mut scene = Scene::default();
        let of = |scene: &Scene, size: u32| factors(scene, &volume(size, |at| at.x));
        assert_eq!(of(&scene, 16), [8; 3]);
        assert_eq!(of(&scene, 32), [4; 3]);
        assert_eq!(of(&scene, 100), [2; 3]);
        scene.camera.zoom = 2.0;
        assert_eq!(of(&scene, 40), [7; 3]);
        // Slices far apart.
        let apart = Volume { spacing: [1.0, 1.0, 3.0], ..volume(32, |at| at.x) };
        assert_eq!(factors(&Scene::default(), &apart), [2, 2, 4]);
        // A few large voxels in a huge picture: a gibibyte at most, and twice as fine in any case.
        (scene.film.width, scene.camera.zoom) = (16384, 1.0);
        let large = Volume { dimensions: [256; 3], ..volume(2, |at| at.x) };
        let chosen = factors(&scene, &large);
        assert!(bytes(&large, chosen) <= MOST_BYTES && chosen.iter().all(|&factor| factor >= 2), "{chosen:?}");
        let huge = Volume { dimensions: [2048; 3], ..large };
        assert_eq!(factors(&scene, &huge), [2; 3]);
    }
}
