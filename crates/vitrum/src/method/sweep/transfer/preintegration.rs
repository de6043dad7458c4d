//! The preintegration table: optical depths, and the colour that is seen, between each two scalars (sweep §4.2).

use super::curve::Curve;
use half::f16;
use rayon::prelude::*;
use vitrum_kernels::abi::tables as layout;

/// Opacity α of particles, transmittance (3) of the medium, and colour (3) of particles at a scalar, for a layer of the reference length.
pub(in crate::method::sweep) type Layer = [f64; 7];

/// Optical depth τ, medium's optical depths κ (3) and colours q (3) at a scalar, for a layer of the reference length.
pub(in crate::method::sweep) type Depths = [f64; 7];

/// Optical depth below which a segment's colour is the mean of its particles' colours: a 64th of their difference would not be seen.
const THIN: f64 = 1.0 / 64.0;
/// Transmittance behind which nothing is seen.
const OPAQUE: f64 = 1e-7;

/// Points and weights of Gauss's quadrature with five points over −1…1, which is exact for polynomials up to the ninth degree.
const QUADRATURE: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The depths of a layer.
pub(in crate::method::sweep) fn depths([alpha, f0, f1, f2, red, green, blue]: Layer) -> Depths {
    let tau = optical_depth(1.0 - alpha);
    let [k0, k1, k2] = [f0, f1, f2].map(optical_depth);
    [tau, k0, k1, k2, tau * red, tau * green, tau * blue]
}

/// Optical depth −ln T of a transmittance T, limited to the range of the table.
pub(super) fn optical_depth(transmittance: f64) -> f64 {
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

/// The integrals of the depths over the scalars from the table's first node on.
pub(in crate::method::sweep) struct Preintegration<'a> {
    /// Ascending scalars of the table's rows and columns.
    nodes: &'a [f64],
    /// The depths at each node.
    at_nodes: Vec<Depths>,
    /// ∫ of the depths up to each node.
    sums: Vec<Depths>,
    /// ∫ s τ ds up to each node.
    moments: Vec<f64>,
    /// How many of the intervals before each node have any depth.
    pub(in crate::method::sweep) anything: Vec<u32>,
    /// How many of them have particles.
    pub(in crate::method::sweep) particles: Vec<u32>,
}

impl<'a> Preintegration<'a> {
    pub(in crate::method::sweep) fn new(layers: &Curve<7>, nodes: &'a [f64]) -> Self {
        let at_nodes = nodes.iter().map(|&node| depths(layers.at(node))).collect();
        let mut this =
            Self { nodes, at_nodes, sums: vec![[0.0; 7]], moments: vec![0.0], anything: vec![0], particles: vec![0] };
        for pair in nodes.windows(2) {
            this.add(layers, pair[0], pair[1]);
        }
        this
    }

    /// Adds the integrals over an interval.
    fn add(&mut self, layers: &Curve<7>, start: f64, end: f64) {
        let last = self.sums.len() - 1;
        let (mut sum, mut moment) = (self.sums[last], self.moments[last]);
        let (mut some, mut opaque) = (false, false);
        let knots = layers.places().filter(|place| *place > start && *place < end);
        let ends: Vec<f64> = std::iter::once(start).chain(knots).chain([end]).collect();
        for part in ends.windows(2) {
            let (integral, first_moment) = integral(layers, part[0], part[1]);
            moment += first_moment;
            sum.iter_mut().zip(integral).for_each(|(sum, integral)| *sum += integral);
            // Asked, not summed: a sum could swallow what is tiny.
            opaque |= part.iter().any(|&end| depths(layers.at(end))[0] > 0.0);
            some |= part.iter().any(|&end| depths(layers.at(end)).iter().any(|&depth| depth > 0.0));
        }
        self.anything.push(self.anything[last] + u32::from(some));
        self.particles.push(self.particles[last] + u32::from(opaque));
        self.sums.push(sum);
        self.moments.push(moment);
    }

    /// The table's words, see [`layout`]: means over the scalars between two nodes, and the colour that is seen in a segment of `length` reference
    /// lengths between them.
    pub(in crate::method::sweep) fn words(&self, length: f64) -> Vec<u32> {
        let entries = self.nodes.len();
        let row = entries * layout::SEGMENT_WORDS as usize;
        let mut words = vec![0; entries * row];
        words.par_chunks_mut(row).enumerate().for_each(|(front, row)| {
            for (back, words) in row.chunks_exact_mut(layout::SEGMENT_WORDS as usize).enumerate() {
                words.copy_from_slice(&self.entry(front, back, length));
            }
        });
        words
    }

    fn entry(&self, front: usize, back: usize, length: f64) -> [u32; layout::SEGMENT_WORDS as usize] {
        let (low, high) = (front.min(back), front.max(back));
        let way = self.nodes[high] - self.nodes[low];
        let (sums, moments) = (&self.sums, &self.moments);
        let mean: Depths =
            if way > 0.0 { std::array::from_fn(|c| (sums[high][c] - sums[low][c]) / way) } else { self.at_nodes[low] };
        // Along scalars that rise, from 0 at `low` to 1 at `high`.
        let rising = if way > 0.0 {
            (moments[high] - moments[low] - self.nodes[low] * (sums[high][0] - sums[low][0])) / (way * way)
        } else {
            0.5 * mean[0]
        };
        let moment = (if front < back { rising } else { mean[0] - rising }).clamp(0.0, mean[0]);
        let [red, green, blue] = if way > 0.0 && mean[0] * length > THIN {
            self.seen(front, back, length / way).map(|color| mean[0] * color)
        } else {
            [mean[4], mean[5], mean[6]]
        };
        [pack(mean[2], mean[3]), pack(mean[1], mean[0]), pack(moment, red), pack(green, blue)]
    }

    /// The colour of a segment's particles, weighted by what is seen of them: ∫ τ c e^(−t) ds over ∫ τ e^(−t) ds, t the optical depth in front, `scale` reference
    /// lengths for each unit of the scalar.
    fn seen(&self, front: usize, back: usize, scale: f64) -> [f64; 3] {
        let (mut seen, mut colors, mut left) = (0.0, [0.0; 3], 1.0);
        let (low, high) = (front.min(back), front.max(back));
        for step in 0..high - low {
            let interval = if front < back { low + step } else { high - 1 - step };
            let (start, end) = (&self.sums[interval], &self.sums[interval + 1]);
            let depth = (end[0] - start[0]) * scale;
            if depth <= 0.0 {
                continue;
            }
            let clear = libm::exp(-depth);
            // The mean of e^(−t) over the interval.
            let mean = if depth < 1e-3 { 1.0 - 0.5 * depth } else { (1.0 - clear) / depth };
            let weight = left * mean;
            seen += weight * (end[0] - start[0]);
            for (channel, color) in colors.iter_mut().enumerate() {
                *color += weight * (end[4 + channel] - start[4 + channel]);
            }
            left *= clear;
            if left < OPAQUE {
                break;
            }
        }
        colors.map(|color| color / seen.max(f64::MIN_POSITIVE))
    }
}

/// The integral of the depths over the scalars s from `start` to `end`, between which the functions are linear, and ∫ s τ ds.
pub(in crate::method::sweep) fn integral(layers: &Curve<7>, start: f64, end: f64) -> (Depths, f64) {
    let (middle, half) = (f64::midpoint(start, end), 0.5 * (end - start));
    let mut sum = [0.0; 7];
    let mut moment = 0.0;
    for (place, weight) in QUADRATURE {
        let there = depths(layers.at(middle + half * place));
        sum.iter_mut().zip(there).for_each(|(sum, depth)| *sum += half * weight * depth);
        moment += half * weight * there[0] * (middle + half * place);
    }
    (sum, moment)
}
