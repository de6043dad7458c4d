//! Transfer functions as tables: preintegrated segments over (front, back) scalars (sweep §4.2), and η.

use super::transfer::abscissa::{Abscissa, by_change, graded};
use super::transfer::curve::Curve;
use super::transfer::window::Window;
use crate::scene::{ColorPoint, Scene, TransferFunction};
use crate::subject::Volumes;
use half::f16;
use vitrum_io::Volume;
use vitrum_kernels::abi::tables as layout;
use vitrum_kernels::field::tables::{Segment, ior_place, segment, segment_place};
use vitrum_kernels::glam::Vec3;

/// The width of the ramp that stands for a step of colour, opacity or filter, in normalised scalars: a few roundings of such a scalar.
const SEGMENT_RAMP: f64 = 1.0 / (1 << 19) as f64;
/// The width of the ramp that stands for a step of η, in normalised scalars. Light is bent by slopes.
const IOR_RAMP: f64 = 1.0 / 1024.0;

/// The scene's values that tables depend on: the transfer functions, whether rays are refracted, and the index of the surroundings.
pub(super) type TablesKey = (TransferFunction, bool, f32);

/// The key of a scene's tables.
pub(super) fn tables_key(scene: &Scene) -> TablesKey {
    (scene.transfer.clone(), scene.sweep.refraction, scene.surroundings.ior)
}

/// More than the rounding of a normalised scalar.
const ROUNDING: f32 = 1e-6;

/// Points and weights of Gauss's quadrature with five points over −1…1, which is exact for polynomials up to the ninth degree.
const QUADRATURE: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The tables of a scene.
pub struct Tables {
    /// The words of the tables, as kernels read them; see [`layout`].
    pub words: Vec<u32>,
    /// Whether η differs from 1 anywhere.
    pub refracts: bool,
    /// Whether the medium's transmittance is below 1 anywhere.
    pub colors: bool,
    /// The largest optical depth of particles, for a layer of the reference length.
    pub(super) densest: f64,
    /// What the normalised scalars of the shown volume stand for.
    pub(super) shown: Window,
    /// What the normalised scalars of the volume that gives η stand for.
    pub(super) bending: Window,
    /// The normalised scalars between which colour, opacity and filter change; `None` where they do not.
    changing: Option<[f32; 2]>,
    /// The normalised scalars between which η changes; `None` where it does not.
    bent: Option<[f32; 2]>,
    /// How many of the preintegration table's intervals before each of its entries have opacity or a filter.
    anything: Vec<u32>,
    /// How many of them have opacity.
    particles: Vec<u32>,
}

/// Opacity α of particles, transmittance (3) of the medium, and colour (3) of particles at a scalar, for a layer of the reference length.
type Layer = [f64; 7];

/// Optical depth τ, medium's optical depths κ (3) and colours q (3) at a scalar, for a layer of the reference length.
type Depths = [f64; 7];

/// The depths of a layer.
fn depths([alpha, f0, f1, f2, red, green, blue]: Layer) -> Depths {
    let tau = optical_depth(1.0 - alpha);
    let [k0, k1, k2] = [f0, f1, f2].map(optical_depth);
    [tau, k0, k1, k2, tau * red, tau * green, tau * blue]
}

fn colors(points: &[ColorPoint]) -> Curve<3> {
    Curve::new(points.iter().map(|point| (point.value, point.color)), [1.0; 3])
}

/// Opacity, filter and colour of `transfer`, between the scalars where what is seen of them changes.
fn layers(transfer: &TransferFunction, shown: &Volume) -> Curve<7> {
    let opacity = if transfer.opacity.is_empty() {
        let [low, high] = shown.common_range();
        Curve::new([(low, [0.0]), (high, [0.1])], [0.0])
    } else {
        Curve::new(transfer.opacity.iter().map(|point| (point.value, [point.opacity])), [0.0])
    };
    let layers = Curve::of_three(&opacity, &colors(&transfer.filter), &colors(&transfer.color));
    // The colour of what is not there is not seen.
    layers
        .trimmed(|[alpha, f0, f1, f2, red, green, blue]| [alpha, f0, f1, f2, red * alpha, green * alpha, blue * alpha])
}

/// η over the index of the surroundings: light bends by ratios of indices alone (Snell's law). Without a function for η there is no
/// refraction, whatever surrounds the volume.
fn indices(transfer: &TransferFunction, refraction: bool, surroundings: f32) -> Curve<1> {
    let points = transfer.ior.iter().filter(|_| refraction).map(|point| (point.value, [point.ior / surroundings]));
    Curve::new(points, [1.0]).trimmed(|eta| eta)
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
    /// The tables of `transfer` for `volumes`; see `layers` and `indices`. Their entries follow the functions, so that they are the same
    /// whatever else the volumes hold.
    pub fn new(transfer: &TransferFunction, refraction: bool, surroundings: f32, volumes: Volumes<'_>) -> Self {
        let layers = layers(transfer, volumes.shown);
        let indices = indices(transfer, refraction, surroundings);
        let (shown, bending) = if volumes.ior.is_some() {
            (Window::new(layers.support(), volumes.shown), Window::new(indices.support(), volumes.bending()))
        } else {
            let both = Window::new(layers.support().into_iter().chain(indices.support()), volumes.shown);
            (both, both)
        };
        let layers = layers.normalised(shown, SEGMENT_RAMP);
        let indices = indices.normalised(bending, IOR_RAMP);

        let mut words = Vec::with_capacity(layout::WORDS as usize);
        let abscissa = segment_abscissa(&layers);
        let nodes = abscissa.nodes();
        let [anything, particles] = segments(&layers, &nodes, &mut words);

        let ior_abscissa = ior_abscissa(&indices);
        let at_nodes: Vec<f64> = ior_abscissa.nodes().into_iter().map(|node| indices.at(node)[0]).collect();
        words.extend(pack_indices(&at_nodes));
        words.extend(abscissa.words(layout::SEGMENT_PIECES, 0.0));
        words.extend(ior_abscissa.words(layout::IOR_PIECES, ROUNDING));

        let single = |support: Option<[f64; 2]>| support.map(|ends| ends.map(|end| end as f32));
        Self {
            words,
            refracts: at_nodes.iter().any(|&eta| eta as f32 != 1.0),
            densest: layers.values().map(|layer| depths(layer)[0]).fold(0.0, f64::max),
            colors: layers.values().any(|layer| depths(layer)[1..4].iter().any(|&depth| depth > 0.0)),
            shown,
            bending,
            changing: single(layers.support()),
            bent: single(indices.support()),
            anything,
            particles,
        }
    }

    /// Whether opacity is 0 and the filter white for all normalised scalars from `low` to `high`.
    pub fn is_clear(&self, low: f32, high: f32) -> bool {
        match self.changing {
            Some([start, end]) if high > start && low < end => {
                let last = layout::SEGMENT_SIZE as usize - 1;
                let entry = |scalar: f32| segment_place(&self.words, scalar) as usize;
                // Kernels interpolate between the table's entries: whole intervals count.
                self.anything[entry(low)] == self.anything[(entry(high) + 1).min(last)]
            }
            _ => self.is_clear_at(low),
        }
    }

    /// Whether opacity is 0 for all normalised scalars from `low` to `high`.
    pub fn is_without_particles(&self, low: f32, high: f32) -> bool {
        match self.changing {
            Some([start, end]) if high > start && low < end => {
                let last = layout::SEGMENT_SIZE as usize - 1;
                let entry = |scalar: f32| segment_place(&self.words, scalar) as usize;
                self.particles[entry(low)] == self.particles[(entry(high) + 1).min(last)]
            }
            _ => self.is_without_particles_at(low),
        }
    }

    /// Whether opacity is 0 at the normalised scalar `scalar`, as kernels look it up.
    pub fn is_without_particles_at(&self, scalar: f32) -> bool {
        segment(&self.words, scalar, scalar).particles == 0.0
    }

    /// Whether opacity is 0 and the filter white at the normalised scalar `scalar`, as kernels look it up.
    pub fn is_clear_at(&self, scalar: f32) -> bool {
        let Segment { particles, medium, emission, .. } = segment(&self.words, scalar, scalar);
        particles == 0.0 && medium == Vec3::ZERO && emission == Vec3::ZERO
    }

    /// Whether η is the same for all normalised scalars from `low` to `high`.
    pub fn is_uniform(&self, low: f32, high: f32) -> bool {
        let Some([start, end]) = self.bent else { return true };
        if high <= start || low >= end {
            return true;
        }
        let cells = layout::IOR_CELLS as usize;
        let first = (ior_place(&self.words, low) as usize).min(cells - 1);
        let last = (ior_place(&self.words, high) as usize + 1).clamp(first + 1, cells);
        let words = &self.words[layout::IOR_OFFSET as usize..][first..last];
        let flat = |word: u32| word % (2 * layout::IOR_NO_RISE) == layout::IOR_NO_RISE;
        words.iter().all(|&word| word == words[0] && flat(word))
    }
}

fn segment_abscissa(layers: &Curve<7>) -> Abscissa {
    let places: Vec<f64> = layers.places().collect();
    let last = layout::SEGMENT_SIZE - 1;
    Abscissa::new(graded(&places, last, 1.1 * SEGMENT_RAMP), last, layout::SEGMENT_PIECES)
}

fn ior_abscissa(indices: &Curve<1>) -> Abscissa {
    let points: Vec<(f64, f64)> = indices.places().zip(indices.values().map(|[eta]| eta)).collect();
    Abscissa::new(by_change(&points), layout::IOR_CELLS, layout::IOR_PIECES)
}

/// Adds the preintegration table over `nodes` to `words`: means over the scalars between them. Returns how many of the intervals before each
/// node have any depth.
fn segments(layers: &Curve<7>, nodes: &[f64], words: &mut Vec<u32>) -> [Vec<u32>; 2] {
    let at_nodes: Vec<Depths> = nodes.iter().map(|&node| depths(layers.at(node))).collect();
    let mut sums = vec![[0.0; 7]];
    // ∫ s τ ds.
    let mut moments = vec![0.0];
    let (mut anything, mut particles) = (vec![0], vec![0]);
    for pair in nodes.windows(2) {
        let knots = layers.places().filter(|place| *place > pair[0] && *place < pair[1]);
        let ends: Vec<f64> = std::iter::once(pair[0]).chain(knots).chain([pair[1]]).collect();
        let mut sum: Depths = sums[sums.len() - 1];
        let mut moment: f64 = moments[moments.len() - 1];
        let (mut some, mut opaque) = (false, false);
        for part in ends.windows(2) {
            let (integral, first_moment) = integral(layers, part[0], part[1]);
            moment += first_moment;
            sum.iter_mut().zip(integral).for_each(|(sum, integral)| *sum += integral);
            // Asked, not summed: a sum could swallow what is tiny.
            opaque |= part.iter().any(|&end| depths(layers.at(end))[0] > 0.0);
            some |= part.iter().any(|&end| depths(layers.at(end)).iter().any(|&depth| depth > 0.0));
        }
        anything.push(anything[anything.len() - 1] + u32::from(some));
        particles.push(particles[particles.len() - 1] + u32::from(opaque));
        sums.push(sum);
        moments.push(moment);
    }
    for front in 0..nodes.len() {
        for back in 0..nodes.len() {
            let (low, high) = (front.min(back), front.max(back));
            let way = nodes[high] - nodes[low];
            let mean: Depths =
                if way > 0.0 { std::array::from_fn(|c| (sums[high][c] - sums[low][c]) / way) } else { at_nodes[low] };
            // Along scalars that rise, from 0 at `low` to 1 at `high`.
            let rising = if way > 0.0 {
                (moments[high] - moments[low] - nodes[low] * (sums[high][0] - sums[low][0])) / (way * way)
            } else {
                0.5 * mean[0]
            };
            let moment = (if front < back { rising } else { mean[0] - rising }).clamp(0.0, mean[0]);
            words.push(pack(mean[2], mean[3]));
            words.push(pack(mean[1], mean[0]));
            words.push(pack(moment, mean[4]));
            words.push(pack(mean[5], mean[6]));
        }
    }
    [anything, particles]
}

/// The integral of the depths over the scalars s from `start` to `end`, between which the functions are linear, and that of s τ.
fn integral(layers: &Curve<7>, start: f64, end: f64) -> (Depths, f64) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::field::tables::ior_and_slope;

    /// η and its slope at a normalised scalar, as kernels read them from the table of `indices`.
    fn looked_up(indices: &[f64], scalar: f64) -> (f64, f64) {
        let mut words = vec![0; layout::IOR_LEAST as usize];
        words.extend(pack_indices(indices));
        let line = Abscissa::new(by_change(&[(0.0, 0.0), (1.0, 1.0)]), layout::IOR_CELLS, layout::IOR_PIECES);
        words.extend(line.words(layout::SEGMENT_PIECES, 0.0));
        words.extend(line.words(layout::IOR_PIECES, ROUNDING));
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

    /// The largest and the mean error of the optical depth between two scalars, as kernels read it, for opacities at scalars; 400 pairs from
    /// −0.2 to 1.2, of which each second one is within `near`.
    fn errors(opacities: &[(f32, f32)], near: [f64; 2]) -> [f64; 2] {
        let opacity = Curve::new(opacities.iter().map(|&(value, opacity)| (value, [opacity])), [0.0]);
        let layers = Curve::of_three(&opacity, &colors(&[]), &colors(&[])).trimmed(|layer| layer);
        let window = Window { origin: 0.0, width: f64::from(opacities[opacities.len() - 1].0) };
        let layers: Curve<7> = layers.normalised(window, SEGMENT_RAMP);
        let mut words = Vec::new();
        let abscissa = segment_abscissa(&layers);
        segments(&layers, &abscissa.nodes(), &mut words);
        words.extend(pack_indices(&indices(|_| 1.0)));
        words.extend(abscissa.words(layout::SEGMENT_PIECES, 0.0));
        words.extend(abscissa.words(layout::SEGMENT_PIECES, 0.0));
        let mut found = [0.0_f64; 2];
        for i in 1..=400 {
            let share = |factor: f64| (f64::from(i) * factor).fract();
            let [low, high] = if i % 2 == 0 { [-0.2, 1.2] } else { near };
            let [front, back] = [0.618_034, 0.754_878].map(|factor| low + (high - low) * share(factor));
            let ends: Vec<f64> = {
                let [first, last] = [front.min(back), front.max(back)];
                let knots = layers.places().filter(|&place| place > first && place < last);
                std::iter::once(first).chain(knots).chain([last]).collect()
            };
            let whole: f64 = ends.windows(2).map(|part| integral(&layers, part[0], part[1]).0[0]).sum();
            let exact = whole / (front - back).abs();
            let error = (f64::from(segment(&words, front as f32, back as f32).particles) - exact).abs();
            found = [found[0].max(error), found[1] + error / 400.0];
        }
        found
    }

    #[test]
    fn means_are_right_over_any_two_scalars() {
        // One ramp; metal far above tissue; a peak in a broad ramp.
        let ramp = errors(&[(0.0, 0.0), (1.0, 0.6)], [0.0, 1.0]);
        let tissue = [(0.0, 0.0), (40.0, 0.3), (80.0, 0.05), (2000.0, 0.4), (30_000.0, 0.6)];
        let tissue = errors(&tissue, [0.0, 0.003]);
        let peak = [(0.0, 0.0), (0.49, 0.1), (0.4999, 0.1), (0.5, 0.6), (0.5001, 0.1), (1.0, 0.3)];
        let peak = errors(&peak, [0.499, 0.501]);
        // Twice what was measured; in one piece the second and the third are 0.24, 0.065 and 0.60, 0.027.
        let bounds = [(ramp, [4.2e-4, 8.5e-5]), (tissue, [5.1e-3, 4.8e-4]), (peak, [0.015, 7.7e-4])];
        for ([largest, mean], [most, usual]) in bounds {
            assert!(largest <= most && mean <= usual, "{ramp:?}, {tissue:?}, {peak:?}");
        }
    }

    #[test]
    fn what_does_not_change_is_exact() {
        let flat = indices(|x| if x < 0.5 { 1.0 } else { 1.45 });
        for scalar in [0.0, 0.1, 0.2503, 0.4990] {
            assert_eq!(looked_up(&flat, scalar), (1.0, 0.0));
        }
        // The slope at the very end is that before it.
        let slopes = [0.0, 1.0, -0.1, 1.1].map(|scalar| looked_up(&indices(|x| 1.0 + x), scalar).1.round());
        assert_eq!(slopes, [1.0, 1.0, 0.0, 0.0]);
        let (eta, slope) = looked_up(&flat, 1.0);
        assert!((eta - 1.45).abs() < 1e-6 && slope == 0.0);
        // Without refraction η is 1.
        assert_eq!(looked_up(&indices(|_| 1.0), 0.7), (1.0, 0.0));
        assert_eq!(looked_up(&indices(|_| 1.37), 0.7).1, 0.0);
    }
}
