//! A phantom of a human head: an amber of soft tissue around skull and vessels (sweep, Figs. 4 and 9).

mod anatomy;
mod vessels;

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use super::shapes::coverage;
use crate::scene::{Camera, Clip, Environment, Intensity, Light, Removes, Scene, Shading, TransferFunction, Transport};
use anatomy::Anatomy;
use glam::Vec3;
use vitrum_io::{Error, Volume, Voxels};

/// Scalar values of the tissues, on the scale of a CT scan with contrast agent (Hounsfield units), further apart than real ones.
const AIR: f32 = -1000.0;
const SOFT: f32 = 0.0;
const BRAIN: f32 = 120.0;
const VESSEL: f32 = 400.0;
const BONE: f32 = 1200.0;

pub(super) const SCENES: &[SceneEntry] = &[
    ("head", "amber soft tissue around skull and vessels; one half's opacity is clipped away", clipped),
    ("head/unclipped", "the same without the clipping plane", unclipped),
    ("head/no-refraction", "the unclipped head with straight rays", no_refraction),
    ("head/no-intensity", "the unclipped head without intensity correction: no caustics", no_intensity),
];

fn unclipped() -> Scene {
    Scene {
        volume: procedural("head"),
        camera: Camera {
            azimuth: 38.0,
            elevation: 8.0,
            distance: Some(3.135),
            target: Some([0.0, 0.0, 0.08]),
            ..Camera::default()
        },
        light: vec![Light { azimuth: 25.0, elevation: 30.0, ..Light::default() }],
        transfer: TransferFunction {
            reference_length: Some(0.02),
            color: colors([
                (300.0, [0.62, 0.05, 0.04]),
                (480.0, [0.80, 0.12, 0.08]),
                (700.0, [0.92, 0.85, 0.72]),
                (BONE, [0.97, 0.94, 0.87]),
            ]),
            opacity: opacities([(220.0, 0.0), (VESSEL, 0.45), (600.0, 0.6), (BONE, 0.95)]),
            ior: iors([(AIR, 1.0), (SOFT, 1.15), (BRAIN, 1.20), (VESSEL, 1.22)]),
            filter: colors([(AIR, [1.0; 3]), (SOFT, [0.995, 0.978, 0.925]), (BRAIN, [0.993, 0.965, 0.920])]),
            ..TransferFunction::default()
        },
        shading: Shading { roughness: 0.2, ..Shading::default() },
        environment: Environment::default(),
        ..Scene::default()
    }
}

fn clipped() -> Scene {
    Scene { clip: vec![Clip { normal: [-1.0, 0.0, 0.0], offset: 0.0, removes: Removes::Opacity }], ..unclipped() }
}

fn no_refraction() -> Scene {
    let mut scene = unclipped();
    scene.sweep.refraction = false;
    scene
}

fn no_intensity() -> Scene {
    let mut scene = unclipped();
    // Light on texels alone has an intensity to correct.
    scene.sweep.light = Transport::Texels;
    scene.sweep.intensity = Intensity::None;
    scene
}

/// The head, facing +y, cut off below the neck.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::new(1.12, 1.44, 2.0), resolution)?;
    let vessels = vessels::paint(&grid);
    let [width, height, _] = grid.dimensions();
    let voxels = grid.sample_symmetric(|index| {
        let vessel = vessels[(index[0] + width * (index[1] + height * index[2])) as usize];
        let value = tissue(&grid, index, f32::from(vessel) / 255.0);
        (value - STORED_ZERO + 0.5) as u16
    })?;
    grid.volume(name, Voxels::from(voxels))?.with_value_mapping(1.0, STORED_ZERO)
}

/// The value that is stored as 0, as CT scanners do.
const STORED_ZERO: f32 = -1024.0;

/// The scalar of a voxel with the given coverage by a vessel, 0 to 1.
fn tissue(grid: &Grid, index: [u32; 3], vessel: f32) -> f32 {
    let anatomy = Anatomy::new(grid.position(index));
    let edge = 3.0 * grid.spacing();
    let skin = anatomy.skin();
    let mut value = AIR;
    let mut fill = |tissue: f32, share: f32| value += (tissue - value) * share;
    if skin < edge {
        fill(SOFT, coverage(skin, edge));
        fill(BRAIN, coverage(anatomy.brain(), edge));
        fill(BONE, coverage(anatomy.bone(), edge));
        fill(VESSEL, vessel);
        fill(AIR, coverage(anatomy.airways(), edge));
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tissues_are_where_they_belong() {
        let volume = volume("head", 192).unwrap();
        let at = |x: f32, y: f32, z: f32| {
            let index = [x, y, z].map(|at| at / volume.spacing[0]);
            let index: [u32; 3] =
                std::array::from_fn(|axis| (index[axis] + 0.5 * (volume.dimensions[axis] - 1) as f32).round() as u32);
            volume.value(index[0], index[1], index[2])
        };
        for (position, value, what) in [
            ([0.5, 0.6, 0.9], AIR, "corner"),
            ([0.14, 0.30, -0.06], AIR, "maxillary sinus"),
            ([0.2, -0.1, 0.45], BRAIN, "brain"),
            ([0.395, -0.08, 0.40], BONE, "temple"),
            ([0.25, -0.2, -0.9], SOFT, "neck"),
        ] {
            let found = at(position[0], position[1], position[2]);
            assert!((found - value).abs() < 60.0, "{what}: {found}, not {value}");
        }
    }

    #[test]
    fn the_head_is_its_own_mirror_image() {
        let volume = volume("head", 64).unwrap();
        let [width, height, depth] = volume.dimensions;
        for (y, z) in (0..height).flat_map(|y| (0..depth).map(move |z| (y, z))) {
            for x in 0..width / 2 {
                assert_eq!(volume.value(x, y, z), volume.value(width - 1 - x, y, z));
            }
        }
    }
}
