//! Transfer functions as tables: preintegrated segments over (front, back) scalars (sweep §4.2), and η.

use crate::scene::{ColorPoint, TransferFunction};
use half::f16;
use vitrum_io::Volume;
use vitrum_kernels::abi::tables as layout;
use vitrum_kernels::field::tables::{Segment, segment};
use vitrum_kernels::glam::Vec3;

/// Samples of the fine grid over which segments are integrated; a multiple of the table's intervals.
const FINE: usize = (layout::SEGMENT_SIZE as usize - 1) * 32;

/// The tables of a scene.
pub struct Tables {
    /// The words of the tables, as kernels read them; see [`layout`].
    pub words: Vec<u32>,
    /// Whether η differs from 1 anywhere.
    pub refracts: bool,
    /// Whether the medium's transmittance is below 1 anywhere.
    pub colors: bool,
    /// Running sums over the fine grid of the quantities that are 0 in empty space.
    anything: Vec<f64>,
}

/// Optical depth τ, medium's optical depths κ (3) and colours q (3) at a scalar, for a layer of the reference length.
type Depths = [f64; 7];

/// Piecewise linear interpolation of `points` (value, y), constant beyond the ends.
fn interpolate<const N: usize>(points: &[(f32, [f32; N])], value: f64, default: [f32; N]) -> [f64; N] {
    let wide = |y: [f32; N]| y.map(f64::from);
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return wide(default);
    };
    if value < f64::from(first.0) {
        return wide(first.1);
    }
    let after = points.partition_point(|point| f64::from(point.0) <= value);
    if after == points.len() {
        return wide(last.1);
    }
    let (x0, y0) = points[after - 1];
    let (x1, y1) = points[after];
    let t = (value - f64::from(x0)) / (f64::from(x1) - f64::from(x0));
    std::array::from_fn(|i| f64::from(y0[i]) + (f64::from(y1[i]) - f64::from(y0[i])) * t)
}

fn colors(points: &[ColorPoint]) -> Vec<(f32, [f32; 3])> {
    points.iter().map(|point| (point.value, point.color)).collect()
}

/// Optical depth −ln T of a transmittance T, limited to the range of the table.
fn optical_depth(transmittance: f64) -> f64 {
    let depth = -libm::log(transmittance.max(0.0));
    depth.clamp(0.0, f64::from(layout::MAX_OPTICAL_DEPTH))
}

/// A pair of halves in a word; halves that would be denormal become 0.
fn pack(low: f64, high: f64) -> u32 {
    let half = |x: f64| {
        let scaled = f16::from_f64(x * f64::from(1 << layout::SEGMENT_EXPONENT));
        if scaled.is_normal() { u32::from(scaled.to_bits()) } else { 0 }
    };
    half(low) | half(high) << 16
}

/// The η table from the values of η at the ends of its cells: see [`layout`].
fn pack_indices(indices: &[f64]) -> Vec<u32> {
    let (least, most) =
        indices.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &eta| (low.min(eta), high.max(eta)));
    let steepest = indices.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
    let levels = f64::from((1u32 << layout::IOR_LEVEL_BITS) - 1);
    let rises = f64::from(layout::IOR_NO_RISE - 1);
    let (step, rise) = ((most - least) / levels, steepest / rises);
    let units = |value: f64, unit: f64| if unit > 0.0 { (value / unit).round() } else { 0.0 };
    let cells = indices.windows(2).map(|pair| {
        let level = units(pair[0] - least, step) as u32;
        let rise = units(pair[1] - pair[0], rise) as i32 + layout::IOR_NO_RISE as i32;
        level << (32 - layout::IOR_LEVEL_BITS) | rise as u32
    });
    [least, step, rise].into_iter().map(|unit| (unit as f32).to_bits()).chain(cells).collect()
}

impl Tables {
    /// The tables of `transfer`: over the range of `shown`, and for η over the range of `bending`.
    pub fn new(transfer: &TransferFunction, refraction: bool, shown: &Volume, bending: &Volume) -> Self {
        let fine = Self::sample(transfer, shown);
        let mut sums = vec![[0.0; 7]; FINE + 1];
        let mut anything = vec![0.0; FINE + 1];
        for i in 0..FINE {
            for c in 0..7 {
                sums[i + 1][c] = sums[i][c] + 0.5 * (fine[i][c] + fine[i + 1][c]);
            }
            // Counted, not summed: a sum could swallow what is tiny.
            let some = fine[i].iter().chain(&fine[i + 1]).any(|&depth| depth > 0.0);
            anything[i + 1] = anything[i] + f64::from(u8::from(some));
        }
        let mut words = Vec::with_capacity(layout::WORDS as usize);
        let size = layout::SEGMENT_SIZE as usize;
        let stride = FINE / (size - 1);
        for front in 0..size {
            for back in 0..size {
                let (low, high) = (front.min(back) * stride, front.max(back) * stride);
                let mean: Depths = if low == high {
                    fine[low]
                } else {
                    std::array::from_fn(|c| (sums[high][c] - sums[low][c]) / (high - low) as f64)
                };
                words.push(pack(mean[0], mean[1]));
                words.push(pack(mean[2], mean[3]));
                words.push(pack(mean[4], mean[5]));
                words.push(pack(mean[6], mean[0]));
            }
        }
        let points: Vec<(f32, [f32; 1])> = transfer.ior.iter().map(|point| (point.value, [point.ior])).collect();
        let indices: Vec<f64> = (0..=layout::IOR_CELLS)
            .map(|i| {
                let share = f64::from(i) / f64::from(layout::IOR_CELLS);
                let [eta] = interpolate(&points, scalar(bending, share), [1.0]);
                if refraction { eta } else { 1.0 }
            })
            .collect();
        let refracts = indices.iter().any(|&eta| eta as f32 != 1.0);
        words.extend(pack_indices(&indices));
        let colors = fine.iter().any(|depths| depths[1..4].iter().any(|&depth| depth > 0.0));
        Self { words, refracts, colors, anything }
    }

    /// The optical depths over the fine grid.
    fn sample(transfer: &TransferFunction, shown: &Volume) -> Vec<Depths> {
        let color = colors(&transfer.color);
        let filter = colors(&transfer.filter);
        let opacity: Vec<(f32, [f32; 1])> = if transfer.opacity.is_empty() {
            vec![(shown.range[0], [0.0]), (shown.range[1], [0.1])]
        } else {
            transfer.opacity.iter().map(|point| (point.value, [point.opacity])).collect()
        };
        (0..=FINE)
            .map(|i| {
                let value = scalar(shown, i as f64 / FINE as f64);
                let [alpha] = interpolate(&opacity, value, [0.0]);
                let tau = optical_depth(1.0 - alpha);
                let kappa = interpolate(&filter, value, [1.0; 3]).map(optical_depth);
                let color = interpolate(&color, value, [1.0; 3]);
                [tau, kappa[0], kappa[1], kappa[2], tau * color[0], tau * color[1], tau * color[2]]
            })
            .collect()
    }

    /// Whether opacity is 0 and the filter white for all normalised scalars from `low` to `high`.
    pub fn is_clear(&self, low: f32, high: f32) -> bool {
        // Kernels interpolate between the table's entries: whole intervals count.
        let intervals = layout::SEGMENT_SIZE as usize - 1;
        let stride = FINE / intervals;
        let first = ((low * intervals as f32).floor().max(0.0) as usize).min(intervals);
        let last = ((high * intervals as f32).ceil() as usize + 1).min(intervals);
        self.anything[last * stride] == self.anything[first.saturating_sub(1) * stride]
    }

    /// Whether opacity is 0 and the filter white at the normalised scalar `scalar`, as kernels look it up.
    pub fn is_clear_at(&self, scalar: f32) -> bool {
        let Segment { particles, medium, emission } = segment(&self.words, scalar, scalar);
        particles == 0.0 && medium == Vec3::ZERO && emission == Vec3::ZERO
    }

    /// Whether η is the same for all normalised scalars from `low` to `high`.
    pub fn is_uniform(&self, low: f32, high: f32) -> bool {
        let cells = layout::IOR_CELLS as usize;
        let first = ((low * cells as f32).floor().max(0.0) as usize).min(cells - 1).saturating_sub(1);
        let last = ((high * cells as f32).ceil() as usize + 1).clamp(first + 1, cells);
        let words = &self.words[layout::IOR_OFFSET as usize..][first..last];
        let flat = |word: u32| word % (2 * layout::IOR_NO_RISE) == layout::IOR_NO_RISE;
        words.iter().all(|&word| word == words[0] && flat(word))
    }
}

/// The physical scalar at `share` of the volume's range, 0 to 1.
fn scalar(volume: &Volume, share: f64) -> f64 {
    let [low, high] = volume.range.map(f64::from);
    low + (high - low) * share
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::field::tables::ior_and_slope;

    /// η and its slope at a normalised scalar, as kernels read them from the table of `indices`.
    fn looked_up(indices: &[f64], scalar: f64) -> (f64, f64) {
        let mut words = vec![0; layout::IOR_LEAST as usize];
        words.extend(pack_indices(indices));
        assert_eq!(words.len(), layout::WORDS as usize);
        let (eta, slope) = ior_and_slope(&words, scalar as f32);
        (f64::from(eta), f64::from(slope))
    }

    fn indices(of: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..=layout::IOR_CELLS).map(|i| of(f64::from(i) / f64::from(layout::IOR_CELLS))).collect()
    }

    #[test]
    fn indices_are_right_to_a_millionth_of_their_range() {
        // A Luneburg lens, a smooth step over a twentieth of the scalars, a straight line.
        let step = |x: f64| ((x - 0.4) * 20.0).clamp(0.0, 1.0);
        let smooth = |t: f64| 1.0 + 0.5 * t * t * (3.0 - 2.0 * t);
        let functions: [&dyn Fn(f64) -> f64; 3] = [&|x| (1.0 + x).sqrt(), &|x| smooth(step(x)), &|x| 1.3 - 0.3 * x];
        for of in functions {
            let indices = indices(of);
            let (low, high) = indices.iter().fold((f64::MAX, f64::MIN), |(a, b), &eta| (a.min(eta), b.max(eta)));
            let steepest = indices.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
            for (i, pair) in indices.windows(2).enumerate() {
                for share in [0.0, 0.25, 0.75] {
                    let (eta, slope) = looked_up(&indices, (i as f64 + share) / f64::from(layout::IOR_CELLS));
                    let expected = pair[0] + (pair[1] - pair[0]) * share;
                    // Half a level, half a rise's unit, and single precision.
                    let off = 1e-6 * (high - low) + steepest / 4094.0 * share + 2e-7;
                    assert!((eta - expected).abs() < off, "cell {i}: {eta} instead of {expected}");
                    let off = steepest / 4094.0 * 1.01 * f64::from(layout::IOR_CELLS);
                    let expected = (pair[1] - pair[0]) * f64::from(layout::IOR_CELLS);
                    assert!((slope - expected).abs() < off, "cell {i}: slope {slope} instead of {expected}");
                }
            }
        }
    }

    #[test]
    fn what_does_not_change_is_exact() {
        let flat = indices(|x| if x < 0.5 { 1.0 } else { 1.45 });
        for scalar in [0.0, 0.1, 0.2503, 0.4990] {
            assert_eq!(looked_up(&flat, scalar), (1.0, 0.0));
        }
        let (eta, slope) = looked_up(&flat, 1.0);
        assert!((eta - 1.45).abs() < 1e-6 && slope == 0.0);
        // Without refraction η is 1.
        assert_eq!(looked_up(&indices(|_| 1.0), 0.7), (1.0, 0.0));
        assert_eq!(looked_up(&indices(|_| 1.37), 0.7).1, 0.0);
    }
}
