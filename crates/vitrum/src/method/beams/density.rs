//! The density of a medium, from a volume, as kernels read it: along the world's axes.

use crate::assets::Assets;
use crate::error::Error;
use crate::method::view::{point_between_voxels, vector};
use crate::scene::Scene;
use crate::unrenderable::Unrenderable;
use glam::DVec3;
use rayon::prelude::*;
use vitrum_io::{Volume, require_memory};

/// The largest component of an axis across the world's axis that it is taken for: files write directions to three digits and more, and over 500
/// voxels this is half a voxel.
const ACROSS: f64 = 1e-3;

/// A density on a regular grid along the world's axes.
#[derive(Debug)]
pub(super) struct Density {
    /// Voxels along the world's x, y and z.
    pub(super) size: [u32; 3],
    /// The low corner of the box, in the world: the outer faces of the first voxels.
    pub(super) low: DVec3,
    /// The high corner of the box.
    pub(super) high: DVec3,
    /// The density in the middle of each voxel, at least 0, x fastest.
    pub(super) values: Vec<f32>,
}

/// Checks that the density of a scene's medium can be read, as far as that is decided without looking at voxels.
///
/// # Errors
/// Where the assets have no volume for it, or one that lies obliquely in the world.
pub(super) fn check(scene: &Scene, assets: &Assets) -> Result<(), Error> {
    volume(scene, assets)?.map_or(Ok(()), |volume| Order::of(volume).map(drop))
}

/// The density of a scene's medium, if a volume says it.
///
/// # Errors
/// Those of [`check`]; where a value is not finite, or below 0 without a window, or there is no memory for the values.
pub(super) fn density(scene: &Scene, assets: &Assets) -> Result<Option<Density>, Error> {
    let Some(volume) = volume(scene, assets)? else { return Ok(None) };
    let order = Order::of(volume)?;
    let size = order.size;
    let mut values = order.values(volume)?;
    let name = || volume.name.clone();
    if let Some(index) = values.par_iter().position_first(|value| !value.is_finite()) {
        let voxel = order.voxel(order.place(index));
        return Err(Unrenderable::DensityNotFinite { name: name(), voxel, value: values[index] }.into());
    }
    match scene.medium.as_ref().and_then(|medium| medium.density_window) {
        Some(window) => {
            let [low, high] = window.map(f64::from);
            values
                .par_iter_mut()
                .for_each(|value| *value = ((f64::from(*value) - low) / (high - low)).clamp(0.0, 1.0) as f32);
        }
        None => {
            if let Some(index) = values.par_iter().position_first(|&value| value < 0.0) {
                let extreme = |pick: fn(f32, f32) -> f32| values.par_iter().copied().reduce(|| values[index], pick);
                let (voxel, value) = (order.voxel(order.place(index)), values[index]);
                let range = [extreme(f32::min), extreme(f32::max)];
                return Err(Unrenderable::NegativeDensity { name: name(), voxel, value, range }.into());
            }
        }
    }
    let middle = volume.dimensions.map(|size| 0.5 * (f64::from(size) - 1.0));
    let middle = point_between_voxels(volume, DVec3::from_array(middle));
    let half = DVec3::from_array(std::array::from_fn(|axis| {
        0.5 * f64::from(size[axis]) * f64::from(volume.spacing[order.axes[axis]])
    }));
    Ok(Some(Density { size, low: middle - half, high: middle + half, values }))
}

/// The volume of the density, if the scene has one.
fn volume<'a>(scene: &Scene, assets: &'a Assets) -> Result<Option<&'a Volume>, Error> {
    match (scene.medium.as_ref().and_then(|medium| medium.density.as_ref()), &assets.density) {
        (None, _) => Ok(None),
        (Some(_), Some(volume)) => Ok(Some(volume)),
        (Some(_), None) => Err(Unrenderable::NoDensity.into()),
    }
}

/// The order of a volume's voxels along the world's axes.
struct Order {
    /// The volume's axis along each of the world's.
    axes: [usize; 3],
    /// Whether it runs against the world's axis.
    mirrored: [bool; 3],
    /// Voxels along the world's axes.
    size: [u32; 3],
}

impl Order {
    fn of(volume: &Volume) -> Result<Self, Error> {
        let directions = volume.axes.map(vector);
        let off = |axis: usize, world: usize| {
            let along = directions[axis][world];
            let across = (directions[axis].length_squared() - along * along).max(0.0).sqrt();
            libm::atan2(across, along.abs())
        };
        let mut axes = [0; 3];
        for (world, found) in axes.iter_mut().enumerate() {
            let nearest = (0..3).min_by(|&a, &b| off(a, world).total_cmp(&off(b, world)));
            *found = nearest.unwrap_or(world);
            let angle = off(*found, world);
            if angle.is_nan() || angle > ACROSS {
                return Err(
                    Unrenderable::ObliqueDensity { name: volume.name.clone(), angle: angle.to_degrees() }.into()
                );
            }
        }
        Ok(Self {
            axes,
            mirrored: std::array::from_fn(|world| directions[axes[world]][world] < 0.0),
            size: axes.map(|axis| volume.dimensions[axis]),
        })
    }

    /// The place along the world's axes of the value number `index`.
    fn place(&self, index: usize) -> [u32; 3] {
        let [width, height, _] = self.size.map(|size| size as usize);
        [index % width, index / width % height, index / (width * height)].map(|index| index as u32)
    }

    /// The volume's voxel at a place along the world's axes.
    fn voxel(&self, place: [u32; 3]) -> [u32; 3] {
        let mut voxel = [0; 3];
        for (world, &axis) in self.axes.iter().enumerate() {
            voxel[axis] = if self.mirrored[world] { self.size[world] - 1 - place[world] } else { place[world] };
        }
        voxel
    }

    /// The scalars of a volume in this order.
    fn values(&self, volume: &Volume) -> Result<Vec<f32>, Error> {
        let [width, height, depth] = self.size.map(|size| size as usize);
        let no_memory = || Unrenderable::NoMemory { dimensions: volume.dimensions };
        let count = width.checked_mul(height).and_then(|slice| slice.checked_mul(depth)).ok_or_else(no_memory)?;
        require_memory("medium.density", (count as u64).saturating_mul(size_of::<f32>() as u64))?;
        let mut values = Vec::new();
        values.try_reserve_exact(count).map_err(|_| no_memory())?;
        values.resize(count, 0.0);
        values.par_chunks_mut(width.max(1)).enumerate().for_each(|(row, values)| {
            let [y, z] = [row % height, row / height].map(|index| index as u32);
            for (x, value) in values.iter_mut().enumerate() {
                let [x, y, z] = self.voxel([x as u32, y, z]);
                *value = volume.value(x, y, z);
            }
        });
        Ok(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Medium, VolumeSource};
    use std::sync::Arc;
    use vitrum_io::Voxels;

    /// 2 × 3 × 4 voxels, each with the value x + 10 y + 100 z of its indices.
    fn counted() -> Volume {
        let value = |index: u16| index % 2 + 10 * (index / 2 % 3) + 100 * (index / 6);
        let voxels: Vec<f32> = (0..24).map(|index| f32::from(value(index))).collect();
        Volume::new("counted", [2, 3, 4], [1.0, 2.0, 3.0], Voxels::F32(voxels.into())).unwrap()
    }

    fn of(volume: Volume, window: Option<[f32; 2]>) -> Result<Density, Error> {
        let medium = Medium { density: Some(VolumeSource::default()), density_window: window, ..Medium::default() };
        let scene = Scene { medium: Some(medium), ..Scene::default() };
        let assets = Assets { density: Some(Arc::new(volume)), ..Assets::from(counted()) };
        density(&scene, &assets).map(|density| density.expect("the scene has one"))
    }

    fn message(volume: Volume, window: Option<[f32; 2]>) -> String {
        of(volume, window).unwrap_err().to_string()
    }

    #[test]
    fn the_box_ends_at_the_faces_of_the_outer_voxels() {
        let found = of(counted(), None).unwrap();
        assert_eq!((found.size, found.low), ([2, 3, 4], DVec3::new(-1.0, -3.0, -6.0)));
        assert_eq!((found.high, found.values[0]), (DVec3::new(1.0, 3.0, 6.0), 0.0));
        assert_eq!(found.values[1..4], [1.0, 10.0, 11.0]);
        assert_eq!(found.values[23], 321.0);
    }

    #[test]
    fn a_window_is_linear_and_limited() {
        let found = of(counted(), Some([100.0, 300.0])).unwrap();
        for (value, expected) in [(0, 0.0), (6, 0.0), (7, 0.005), (12, 0.5), (18, 1.0), (23, 1.0)] {
            assert_eq!(found.values[value], expected, "{value}");
        }
        let widest = of(counted(), Some([f32::MIN, f32::MAX])).unwrap();
        assert!(widest.values.iter().all(|&value| value == 0.5), "{:?}", widest.values);
    }

    /// Index x runs against the world's z, y along x, z along y.
    #[test]
    fn values_are_put_along_the_axes_of_the_world() {
        let mut volume = counted();
        volume.axes = [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        volume.origin = [5.0, 6.0, 7.0];
        let found = of(volume.clone(), None).unwrap();
        assert_eq!((found.size, found.low), ([3, 4, 2], DVec3::new(4.0, 4.5, 5.5)));
        assert_eq!(found.high, DVec3::new(10.0, 16.5, 7.5));
        for (index, value) in found.values.iter().enumerate() {
            let [x, y, z] = [index % 3, index / 3 % 4, index / 12];
            assert_eq!(*value, (1 - z + 10 * x + 100 * y) as f32, "{x} {y} {z}");
        }
        // Directions as files round them.
        volume.axes[0] = [2e-4, 0.0, -1.0];
        assert_eq!(of(volume, None).unwrap().values, found.values);
    }

    #[test]
    fn oblique_volumes_are_refused() {
        let mut volume = counted();
        volume.axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
        let text = message(volume.clone(), None);
        assert!(
            text.contains("medium.density: counted: an axis of the volume is 36.87° off the world's axes"),
            "{text}"
        );
        assert!(text.contains("resample the volume along the world's axes"), "{text}");
        volume.axes = [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(message(volume, None).contains("90.00°"));
    }

    #[test]
    fn values_that_are_no_densities_are_refused_with_their_voxel() {
        // The voxel is the volume's own, also where values are reordered.
        for axes in [counted().axes, [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]] {
            let with = |value: f32| {
                let mut voxels: Vec<f32> = (0..24).map(|_| 1.0).collect();
                voxels[1 + 2 * (2 + 3 * 3)] = value;
                Volume { voxels: Voxels::F32(voxels.into()), axes, ..counted() }
            };
            for value in [f32::NAN, f32::INFINITY] {
                let text = message(with(value), Some([0.0, 1.0]));
                let expected = format!("medium.density: counted: the value at voxel (1, 2, 3) is {value}, expected");
                assert!(text.contains(&expected) && text.contains("replace it by a finite value"), "{text}");
            }
            let text = message(with(-2.5), None);
            assert!(text.contains("the value at voxel (1, 2, 3) is -2.5, and a density is at least 0"), "{text}");
            assert!(
                text.contains("from -2.5 to 1;") && text.contains("`medium.density_window = [-2.5, 1.0]`"),
                "{text}"
            );
            assert_eq!(of(with(-2.5), Some([0.0, 2.0])).unwrap().values.iter().sum::<f32>(), 11.5);
        }
    }

    #[test]
    fn a_scene_decides_whether_there_is_a_density() {
        let mut scene = Scene::default();
        let assets = Assets { density: Some(Arc::new(counted())), ..Assets::from(counted()) };
        assert!(density(&scene, &assets).unwrap().is_none());
        scene.medium = Some(Medium { density: Some(VolumeSource::default()), ..Medium::default() });
        assert!(check(&scene, &assets).is_ok());
        let none = check(&scene, &Assets::from(counted())).unwrap_err().to_string();
        assert!(none.contains("the assets have no volume for it; set `Assets::density`"), "{none}");
    }
}
