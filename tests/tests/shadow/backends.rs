//! Both backends make the same shadow map, to the last bit, whatever the order of the triangles.

use super::{Random, case};
use vitrum::backend::CpuBackend;
use vitrum_conformance::refraction::{ball, cuboid, together};
use vitrum_conformance::shadow::Map;
use vitrum_conformance::{Failure, adapter};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3};

fn mesh() -> Mesh {
    let turned = DQuat::from_rotation_x(0.3) * DQuat::from_rotation_y(0.7);
    together(&[ball(40), cuboid(DVec3::new(1.2, 0.2, 1.4), turned), cuboid(DVec3::new(0.1, 1.6, 0.1), turned)])
}

const KINDS: [&[&str]; 6] = [
    &["material=[{opaque=true,density=0.4}]"],
    &["material=[{name=\"m1\",attenuation_color=[0.2,0.5,0.9]},{opaque=true,density=0.03}]"],
    &["material=[{name=\"m0\",attenuation_color=[0.5,0.5,0.5]},{opaque=true,density=3}]"],
    &["shadow.coefficient=uniform", "material=[{opaque=true}]"],
    &[
        "material=[{name=\"m1\",attenuation_color=[0.2,0.5,0.9]},{opaque=true,density=0.03}]",
        "light.0={kind='point',position=[0.4,-0.7,2.2]}",
    ],
    &["material=[{opaque=true}]", "light.0={kind='spot',position=[3,1,0.5],cone_angle=12}"],
];

#[test]
fn the_map_is_the_same_on_both_backends() -> Result<(), Failure> {
    let Some(mut gpu) = adapter::exact_for_test() else { return Ok(()) };
    let mut cpu = CpuBackend::new(None)?;
    for settings in KINDS {
        // The second one is cut into several slabs.
        for resolution in ["shadow.resolution=33", "shadow.resolution=256"] {
            let case = case(mesh(), 8, &[settings, &[resolution, "voxelization.resolution=16"]].concat())?;
            let (expected, found) = (Map::of(&case, &mut cpu)?, Map::of(&case, &mut gpu)?);
            assert!(expected.words.iter().any(|word| *word != u32::MAX), "there is a shadow");
            assert!(expected.words == found.words, "{settings:?}, {resolution}");
        }
    }
    Ok(())
}

#[test]
fn the_order_of_triangles_does_not_matter() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let mut random = Random(3);
    for settings in KINDS {
        let settings = [settings, &["shadow.resolution=64", "voxelization.resolution=16"]].concat();
        let expected = Map::of(&case(mesh(), 8, &settings)?, &mut cpu)?;
        let mut shuffled = mesh();
        for index in (1..shuffled.triangles.len()).rev() {
            let other = (random.next() * (index + 1) as f64) as usize;
            shuffled.triangles.swap(index, other);
            shuffled.triangle_materials.swap(index, other);
        }
        assert!(expected.words == Map::of(&case(shuffled, 8, &settings)?, &mut cpu)?.words, "{settings:?}");
    }
    Ok(())
}
