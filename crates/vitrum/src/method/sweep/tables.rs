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
    /// The words kernels read; see [`layout`].
    pub words: Vec<u32>,
    /// Whether η is not 1 somewhere.
    pub refracts: bool,
    /// Whether the medium takes light away somewhere.
    pub colors: bool,
    /// Running sums over the fine grid of what must be 0 in empty space.
    anything: Vec<f64>,
}

/// τ, κ (3) and q (3) at a scalar, for a layer of the reference length.
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

/// −ln x, limited to what the table stores.
fn optical_depth(transmittance: f64) -> f64 {
    let depth = -transmittance.max(0.0).ln();
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

impl Tables {
    /// The tables of `transfer` over the range of `shown`, η over that of `bending`.
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
        let mut refracts = false;
        for i in 0..layout::IOR_SIZE {
            let share = f64::from(i) / f64::from(layout::IOR_SIZE - 1);
            let [eta] = interpolate(&points, scalar(bending, share), [1.0]);
            let eta = if refraction { eta as f32 } else { 1.0 };
            refracts |= eta != 1.0;
            words.push(eta.to_bits());
        }
        let colors = fine.iter().any(|depths| depths[1..4].iter().any(|&depth| depth > 0.0));
        Self { words, refracts, colors, anything }
    }

    /// The optical depths over the fine grid.
    fn sample(transfer: &TransferFunction, shown: &Volume) -> Vec<Depths> {
        let color = colors(&transfer.color);
        let medium = colors(&transfer.medium);
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
                let kappa = interpolate(&medium, value, [1.0; 3]).map(optical_depth);
                let color = interpolate(&color, value, [1.0; 3]);
                [tau, kappa[0], kappa[1], kappa[2], tau * color[0], tau * color[1], tau * color[2]]
            })
            .collect()
    }

    /// Whether particles and medium do nothing for all normalised scalars from `low` to `high`.
    pub fn is_clear(&self, low: f32, high: f32) -> bool {
        // Kernels interpolate between the table's entries: whole intervals count.
        let intervals = layout::SEGMENT_SIZE as usize - 1;
        let stride = FINE / intervals;
        let first = ((low * intervals as f32).floor().max(0.0) as usize).min(intervals);
        let last = ((high * intervals as f32).ceil() as usize + 1).min(intervals);
        self.anything[last * stride] == self.anything[first.saturating_sub(1) * stride]
    }

    /// Whether particles and medium do nothing where the normalised scalar is exactly `scalar`, as kernels look it up.
    pub fn is_clear_at(&self, scalar: f32) -> bool {
        let Segment { particles, medium, emission } = segment(&self.words, scalar, scalar);
        particles == 0.0 && medium == Vec3::ZERO && emission == Vec3::ZERO
    }

    /// Whether η is the same for all normalised scalars from `low` to `high`.
    pub fn is_uniform(&self, low: f32, high: f32) -> bool {
        let intervals = layout::IOR_SIZE as usize - 1;
        let first = ((low * intervals as f32).floor().max(0.0) as usize).min(intervals);
        let last = ((high * intervals as f32).ceil() as usize + 1).min(intervals);
        let first = first.saturating_sub(1);
        let start = layout::IOR_OFFSET as usize;
        self.words[start + first..=start + last].windows(2).all(|pair| pair[0] == pair[1])
    }
}

/// The physical scalar at a share of the volume's range.
fn scalar(volume: &Volume, share: f64) -> f64 {
    let [low, high] = volume.range.map(f64::from);
    low + (high - low) * share
}
