//! Isosurfaces as kernels look them up: their scalars, and the sheet of those between any two scalars.

use super::window::Window;
use crate::scene::Isosurface;
use vitrum_io::Volume;
use vitrum_kernels::abi::tables as layout;

/// An isosurface.
#[derive(Debug, Clone, Copy)]
struct Surface {
    /// Its normalised scalar, as kernels have that of a voxel of its value.
    scalar: f32,
    /// Its optical depth.
    depth: f64,
    /// Its reflectance.
    color: [f64; 3],
}

/// The isosurfaces of a scene, those of an opacity above 0, by their normalised scalars.
#[derive(Debug, Default)]
pub(in crate::method::sweep) struct Isosurfaces(Vec<Surface>);

/// The ends of the values at which a scene has isosurfaces; `None` where it has none.
pub(in crate::method::sweep) fn support(isosurfaces: &[Isosurface]) -> Option<[f64; 2]> {
    let seen = isosurfaces.iter().filter(|surface| surface.opacity > 0.0);
    seen.map(|surface| [f64::from(surface.value); 2])
        .reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
}

impl Isosurfaces {
    pub(in crate::method::sweep) fn new(isosurfaces: &[Isosurface], window: Window, volume: &Volume) -> Self {
        let (scale, offset) = (f64::from(volume.value_scale), f64::from(volume.value_offset));
        let stored = |value: f32| ((f64::from(value) - offset) / scale) as f32;
        let seen = isosurfaces.iter().filter(|surface| surface.opacity > 0.0);
        let mut surfaces: Vec<Surface> = seen
            .map(|surface| Surface {
                scalar: window.normalised_as_kernels_do(stored(surface.value), volume),
                depth: super::preintegration::optical_depth(1.0 - f64::from(surface.opacity)),
                color: surface.color.map(f64::from),
            })
            .collect();
        surfaces.sort_by(|a, b| a.scalar.total_cmp(&b.scalar));
        Self(surfaces)
    }

    pub(in crate::method::sweep) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a segment between normalised scalars from `low` to `high` may cross one.
    pub(in crate::method::sweep) fn are_within(&self, low: f32, high: f32) -> bool {
        self.0.iter().any(|surface| surface.scalar >= low && surface.scalar <= high)
    }

    /// The words of the table, see [`layout`].
    pub(in crate::method::sweep) fn words(&self) -> Vec<u32> {
        let most = layout::MOST_ISOSURFACES as usize;
        let scalars = (0..most).map(|index| self.0.get(index).map_or(f32::MAX, |surface| surface.scalar));
        let sheets = (0..=most).flat_map(|front| (0..=most).flat_map(move |back| self.sheet(front, back)));
        scalars.chain(sheets).map(f32::to_bits).collect()
    }

    /// The sheet between a scalar with `front` surfaces up to it and one with `back`.
    fn sheet(&self, front: usize, back: usize) -> [f32; layout::SHEET_WORDS as usize] {
        let end = self.0.len();
        let between = &self.0[front.min(back).min(end)..front.max(back).min(end)];
        let mut ordered: Vec<&Surface> = between.iter().collect();
        if back < front {
            ordered.reverse();
        }
        let (mut left, mut depth, mut seen) = (1.0, 0.0, [0.0; 4]);
        for surface in ordered {
            let clear = libm::exp(-surface.depth);
            let [red, green, blue] = surface.color;
            let weight = left * (1.0 - clear);
            let parts = [red, green, blue, f64::from(surface.scalar)];
            seen.iter_mut().zip(parts).for_each(|(sum, part)| *sum += weight * part);
            left *= clear;
            depth += surface.depth;
        }
        let opacity = (1.0 - left).max(f64::MIN_POSITIVE);
        let [red, green, blue, scalar] = seen.map(|sum| (sum / opacity) as f32);
        // Together they are no denser than matter can be.
        let least = libm::exp(-f64::from(layout::MAX_OPTICAL_DEPTH));
        [left.max(least) as f32, depth.min(f64::from(layout::MAX_OPTICAL_DEPTH)) as f32, red, green, blue, scalar]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::Voxels;

    #[test]
    fn sheets_are_seen_from_the_front() {
        let volume = Volume::new("test", [2, 1, 1], [1.0; 3], Voxels::from(vec![0.0_f32, 10.0])).expect("a volume");
        let window = Window { origin: 0.0, width: 10.0 };
        let surface = |value, color, opacity| Isosurface { value, color, opacity };
        let list =
            [surface(5.0, [0.0, 0.0, 1.0], 1.0), surface(7.0, [1.0; 3], 0.0), surface(2.5, [1.0, 0.0, 0.0], 0.5)];
        assert_eq!(support(&list), Some([2.5, 5.0]));
        let surfaces = Isosurfaces::new(&list, window, &volume);
        let near = |a: f32, b: f32| (a - b).abs() < 1e-6;
        assert!(surfaces.are_within(0.2, 0.3) && !surfaces.are_within(0.3, 0.4) && !surfaces.are_within(0.6, 0.8));
        // Red and half before blue.
        let [clear, depth, red, green, blue, scalar] = surfaces.sheet(0, 2);
        assert!(near(clear, 0.0) && near(depth, 20.0) && near(red, 0.5) && near(green, 0.0) && near(blue, 0.5));
        assert!(near(scalar, 0.375), "{scalar}");
        let [_, _, red, _, blue, _] = surfaces.sheet(2, 0);
        assert!(near(red, 0.0) && near(blue, 1.0));
        let [clear, depth, ..] = surfaces.sheet(1, 0);
        assert!(near(clear, 0.5) && near(depth, std::f32::consts::LN_2));
        assert_eq!(surfaces.sheet(1, 1), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let words = Isosurfaces::default().words();
        assert_eq!(words.len(), (layout::WORDS - layout::ISOSURFACES) as usize);
        assert_eq!((words[0], words[8 + 6 * 80]), (f32::MAX.to_bits(), 1.0_f32.to_bits()));
    }
}
