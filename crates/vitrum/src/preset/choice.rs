//! The preset for a volume for which none is named.

use super::hounsfield::may_be_hounsfield;
use super::subject::Subject;
use super::{labels, noise};
use vitrum_io::Volume;

/// A preset, and why it suits a volume.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// The preset's name.
    pub name: &'static str,
    /// What in the volume speaks for it: the end of a sentence.
    pub reason: String,
}

impl Choice {
    /// The light and the surroundings in which isosurfaces are shown.
    pub(crate) fn for_surfaces() -> Self {
        Self { name: "plain", reason: "its light shows the shape of isosurfaces, which alone are seen".to_owned() }
    }
}

/// Noise, as a share of the way from air to soft matter, up to which lit surfaces look smooth.
const QUIET: f32 = 0.0075;

/// [`Subject::clarity`] from which a volume shows compact bodies.
const COMPACT: f32 = 0.9;

/// Voxels along the longest edge from which surfaces are finer than the steps between voxels.
const FINE: u32 = 128;

/// Distance of slices over that of voxels within them, up to which surfaces show no slices.
const EVEN: f32 = 2.0;

/// Whether a volume's values are labels of parts by its file's word.
pub(crate) fn are_named_labels(volume: &Volume) -> bool {
    volume.source.labels().is_some_and(|labels| labels.list.len() > 1)
}

/// Whether a volume's values are labels of parts: by its file's word, or by the values themselves.
pub(crate) fn holds_labels(volume: &Volume) -> bool {
    are_named_labels(volume) || are_labels(volume)
}

/// The preset that shows most of a volume's contents without a fault: fog, unless the volume is made of clean, compact, finely sampled bodies, whose
/// surfaces are then lit. Fog hides noise and steps between slices, which surfaces and clear matter show; labels have colours of their own.
#[must_use]
pub fn choose(volume: &Volume) -> Choice {
    let haze = |reason: String| Choice { name: "haze", reason };
    if holds_labels(volume) && labels::parts(volume).is_some() {
        return Choice { name: "labels", reason: "the values are labels, and no measurements".to_owned() };
    }
    let subject = Subject::above(volume, None);
    let [finest, coarsest] = [f32::min, f32::max].map(|of| volume.spacing.into_iter().reduce(of).unwrap_or(1.0));
    let noise = noise::of(volume, &subject);
    let percent = |share: f32| (1000.0 * f64::from(share)).round() / 10.0;
    match noise {
        None => haze("there is little matter in it".to_owned()),
        Some(noise) if noise.share > QUIET => haze(format!(
            "the values are noisy, by {} % of the way from air to soft matter, which surfaces would show",
            percent(noise.share)
        )),
        _ if may_be_hounsfield(volume) => haze("of a CT, soft tissue and bone show at once".to_owned()),
        _ if subject.clarity < COMPACT => {
            haze("its shapes are thin or many, and would hide one another as surfaces".to_owned())
        }
        _ if coarsest > EVEN * finest => haze("its slices lie far apart, which surfaces would show".to_owned()),
        _ if volume.dimensions.iter().all(|&size| size < FINE) => {
            haze("it has few voxels, whose steps surfaces would show".to_owned())
        }
        Some(_) => Choice {
            name: "plain",
            reason: "it holds compact bodies without noise, whose surfaces are clear".to_owned(),
        },
    }
}

/// Whether a volume's values are numbers of parts: few whole numbers, of which neighbours nearly always have the same.
fn are_labels(volume: &Volume) -> bool {
    /// More parts than these are not told apart by eye.
    const MOST: usize = 256;
    /// The share of neighbours with equal values; a mask of one part is a body, and not labels.
    const EQUAL: f64 = 0.98;
    const FEWEST: usize = 3;
    let counts = volume.histogram_over([volume.range[0] - 0.5, volume.range[0] + MOST as f32 - 0.5], MOST);
    let whole = volume.range.iter().all(|end| end.fract() == 0.0) && volume.range[1] - volume.range[0] < MOST as f32;
    if !whole || counts.iter().filter(|&&count| count > 0).count() < FEWEST {
        return false;
    }
    let nothing = volume.range[0];
    let [width, height, depth] = volume.dimensions;
    let (mut pairs, mut equal) = (0_u64, 0_u64);
    for z in 0..depth {
        for y in 0..height {
            let mut before = volume.value(0, y, z);
            for x in 1..width {
                let here = volume.value(x, y, z);
                if before > nothing && here > nothing {
                    pairs += 1;
                    equal += u64::from(here == before);
                }
                if here.fract() != 0.0 {
                    return false;
                }
                before = here;
            }
        }
    }
    pairs > 0 && equal as f64 >= EQUAL * pairs as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preset::testing::{Normal, ball};
    use vitrum_io::Voxels;

    fn volume(size: u32, voxels: impl Into<Voxels>) -> Volume {
        Volume::new("test", [size; 3], [1.0; 3], voxels.into()).expect("a volume")
    }

    fn name(volume: &Volume) -> (&'static str, String) {
        let Choice { name, reason } = choose(volume);
        (name, reason)
    }

    #[test]
    fn surfaces_are_for_clean_compact_bodies_alone() {
        const SIZE: u32 = 128;
        let clean = volume(SIZE, ball(SIZE));
        assert_eq!(choose(&clean).name, "plain", "{:?}", name(&clean));
        // 8 bits are enough.
        let eight: Vec<u8> = ball(SIZE).into_iter().map(|value| (value * 0.2) as u8).collect();
        assert_eq!(choose(&volume(SIZE, eight)).name, "plain");
        let mut normal = Normal::default();
        let noisy: Vec<f32> = ball(SIZE).into_iter().map(|value| value + 30.0 * normal.next()).collect();
        let (preset, reason) = name(&volume(SIZE, noisy));
        assert!(preset == "haze" && reason.contains("noisy"), "{reason}");
        let (preset, reason) = name(&Volume { spacing: [1.0, 1.0, 4.0], ..clean });
        assert!(preset == "haze" && reason.contains("slices"), "{reason}");
        let (preset, reason) = name(&volume(64, ball(64)));
        assert!(preset == "haze" && reason.contains("few voxels"), "{reason}");
        // A lattice of rods.
        let rods = (0..SIZE.pow(3)).map(|index| {
            let [x, y] = [index % SIZE % 9, index / SIZE % SIZE % 9].map(|at| at < 5);
            if x && y { 200_u8 } else { 0 }
        });
        let (preset, reason) = name(&volume(SIZE, rods.collect::<Vec<u8>>()));
        assert!(preset == "haze" && reason.contains("thin"), "{reason}");
    }

    #[test]
    fn kinds_of_data_are_told_apart() {
        const SIZE: u32 = 128;
        // Three nested parts.
        let parts: Vec<u8> = (0..SIZE.pow(3)).map(|index| [0, 4, 7, 9][(index / SIZE % SIZE / 32) as usize]).collect();
        let (preset, reason) = name(&volume(SIZE, parts));
        assert!(preset == "labels" && reason.contains("labels"), "{reason}");
        // A mask is a body.
        let mask: Vec<u8> = ball(SIZE).into_iter().map(|value| u8::from(value > 500.0)).collect();
        assert_eq!(choose(&volume(SIZE, mask)).name, "plain");
        let ct: Vec<f32> = ball(SIZE).into_iter().map(|value| value * 1.05 - 1000.0).collect();
        let mut dense = ct.clone();
        let inner = dense
            .iter_mut()
            .zip(ball(SIZE))
            .enumerate()
            .filter(|(index, (_, matter))| *matter == 1000.0 && index / 4 % 3 == 0);
        inner.for_each(|(_, (value, _))| *value = 900.0);
        let (preset, reason) = name(&volume(SIZE, ct.clone()));
        assert_eq!(preset, "plain", "{reason}: it does not reach bone");
        let (preset, _) = name(&volume(SIZE, dense));
        assert_eq!(preset, "haze");
        for degenerate in [vec![0.0; 8], vec![1e30; 8], (0..8).map(|value| value as f32).collect()] {
            assert_eq!(choose(&volume(2, degenerate)).name, "haze");
        }
    }
}
