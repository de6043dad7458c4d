//! Transfer functions as tables: preintegrated segments over (front, back) scalars (sweep §4.2), and η.

use super::planes::plane_distance;
use super::transfer::abscissa::{Abscissa, by_change, graded};
use super::transfer::curve::Curve;
use super::transfer::isosurfaces::{self, Isosurfaces};
use super::transfer::preintegration::{Preintegration, depths};
use super::transfer::window::Window;
use crate::scene::{ColorPoint, Isosurface, Scene, TransferFunction};
use crate::subject::Volumes;
use vitrum_io::Volume;
use vitrum_kernels::abi::tables as layout;
use vitrum_kernels::field::tables::{Segment, ior_place, segment, segment_place};
use vitrum_kernels::glam::Vec3;

/// The width of the ramp that stands for a step of colour, opacity or filter, in normalised scalars: a few roundings of such a scalar.
const SEGMENT_RAMP: f64 = 1.0 / (1 << 19) as f64;
/// The width of the ramp that stands for a step of η, in normalised scalars. Light is bent by slopes.
const IOR_RAMP: f64 = 1.0 / 1024.0;

/// The scene's values that tables depend on: the transfer functions, isosurfaces, whether rays are refracted, the index of the surroundings, and the
/// distance of planes.
pub(super) type TablesKey = (TransferFunction, Vec<Isosurface>, bool, f32, f32);

/// The key of a scene's tables.
pub(super) fn tables_key(scene: &Scene) -> TablesKey {
    let Scene { transfer, isosurface, sweep, surroundings, .. } = scene;
    (transfer.clone(), isosurface.clone(), sweep.refraction, surroundings.ior, sweep.sample_distance)
}

/// More than the rounding of a normalised scalar.
const ROUNDING: f32 = 1e-6;

/// The tables of a scene.
pub struct Tables {
    /// The words of the tables, as kernels read them; see [`layout`].
    pub words: Vec<u32>,
    /// Whether η differs from 1 anywhere.
    pub refracts: bool,
    /// Whether the medium's transmittance is below 1 anywhere.
    pub colors: bool,
    /// The largest optical depth of particles, for a layer of the reference length; without end where there are isosurfaces.
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
    isosurfaces: Isosurfaces,
}

fn colors(points: &[ColorPoint]) -> Curve<3> {
    Curve::new(points.iter().map(|point| (point.value, point.color)), [1.0; 3])
}

/// Opacity, filter and colour of a scene, between the scalars where what is seen of them changes.
fn layers(scene: &Scene, shown: &Volume) -> Curve<7> {
    let transfer = &scene.transfer;
    let opacity = if scene.has_usual_opacity() {
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
    /// The tables of a scene for `volumes`; see `layers` and `indices`. Their entries follow the functions, so that they are the same
    /// whatever else the volumes hold.
    pub fn new(scene: &Scene, volumes: Volumes<'_>) -> Self {
        let transfer = &scene.transfer;
        let layers = layers(scene, volumes.shown);
        let surfaces = isosurfaces::support(&scene.isosurface);
        let indices = indices(transfer, scene.sweep.refraction, scene.surroundings.ior);
        let (shown, bending) = if volumes.ior.is_some() {
            (
                Window::new(layers.support().into_iter().chain(surfaces), volumes.shown),
                Window::new(indices.support(), volumes.bending()),
            )
        } else {
            let all = layers.support().into_iter().chain(surfaces).chain(indices.support());
            let both = Window::new(all, volumes.shown);
            (both, both)
        };
        let layers = layers.normalised(shown, SEGMENT_RAMP);
        let indices = indices.normalised(bending, IOR_RAMP);

        let abscissa = segment_abscissa(&layers);
        let nodes = abscissa.nodes();
        let preintegration = Preintegration::new(&layers, &nodes);
        let length = plane_distance(scene, volumes.shown) / f64::from(transfer.reference_length_in(volumes.shown));
        let mut words = preintegration.words(length);
        let Preintegration { anything, particles, .. } = preintegration;

        let ior_abscissa = ior_abscissa(&indices);
        let at_nodes: Vec<f64> = ior_abscissa.nodes().into_iter().map(|node| indices.at(node)[0]).collect();
        words.extend(pack_indices(&at_nodes));
        words.extend(abscissa.words(layout::SEGMENT_PIECES, 0.0));
        words.extend(ior_abscissa.words(layout::IOR_PIECES, ROUNDING));
        let isosurfaces = Isosurfaces::new(&scene.isosurface, shown, volumes.shown);
        words.extend(isosurfaces.words());
        let densest = if isosurfaces.is_empty() { 0.0 } else { f64::INFINITY };

        let single = |support: Option<[f64; 2]>| support.map(|ends| ends.map(|end| end as f32));
        Self {
            words,
            refracts: at_nodes.iter().any(|&eta| eta as f32 != 1.0),
            densest: layers.values().map(|layer| depths(layer)[0]).fold(densest, f64::max),
            colors: layers.values().any(|layer| depths(layer)[1..4].iter().any(|&depth| depth > 0.0)),
            shown,
            bending,
            changing: single(layers.support()),
            bent: single(indices.support()),
            anything,
            particles,
            isosurfaces,
        }
    }

    /// Whether there are isosurfaces.
    pub(super) fn has_isosurfaces(&self) -> bool {
        !self.isosurfaces.is_empty()
    }

    /// Whether opacity is 0, the filter white and no isosurface for all normalised scalars from `low` to `high`.
    pub fn is_clear(&self, low: f32, high: f32) -> bool {
        !self.isosurfaces.are_within(low, high) && self.has_clear_layers(low, high)
    }

    fn has_clear_layers(&self, low: f32, high: f32) -> bool {
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

    /// Whether opacity is 0 and no isosurface for all normalised scalars from `low` to `high`.
    pub fn is_without_particles(&self, low: f32, high: f32) -> bool {
        !self.isosurfaces.are_within(low, high) && self.has_layers_without_particles(low, high)
    }

    fn has_layers_without_particles(&self, low: f32, high: f32) -> bool {
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

#[cfg(test)]
mod tests {
    use super::super::transfer::preintegration::integral;
    use super::*;
    use vitrum_kernels::field::tables::ior_and_slope;

    /// η and its slope at a normalised scalar, as kernels read them from the table of `indices`.
    fn looked_up(indices: &[f64], scalar: f64) -> (f64, f64) {
        let mut words = vec![0; layout::IOR_LEAST as usize];
        words.extend(pack_indices(indices));
        let line = Abscissa::new(by_change(&[(0.0, 0.0), (1.0, 1.0)]), layout::IOR_CELLS, layout::IOR_PIECES);
        words.extend(line.words(layout::SEGMENT_PIECES, 0.0));
        words.extend(line.words(layout::IOR_PIECES, ROUNDING));
        words.extend(Isosurfaces::default().words());
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
        let abscissa = segment_abscissa(&layers);
        let mut words = Preintegration::new(&layers, &abscissa.nodes()).words(1.0);
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
