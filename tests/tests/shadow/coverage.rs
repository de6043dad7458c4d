//! Many small quads: the light that is missing below them.

use super::{ABOVE, Random, case, on_both, quads};
use vitrum_conformance::Failure;
use vitrum_conformance::shadow::{Caster, Map};
use vitrum_kernels::glam::DVec3;

/// Light over a grid of points below the mesh, and what an exact caster says: the mean of both, and the root of the mean square of
/// the differences.
fn compare(map: &Map, caster: &Caster, half: f64, height: f64) -> [f64; 3] {
    const POINTS: u32 = 200;
    let at = |i: u32| ((f64::from(i) + 0.5) / f64::from(POINTS) * 2.0 - 1.0) * half;
    let (mut found, mut expected, mut squares) = (0.0, 0.0, 0.0);
    for y in 0..POINTS {
        for x in 0..POINTS {
            let point = DVec3::new(at(x), at(y), height);
            let (here, truth) = (map.at(point)[0], (-caster.depth(point)).exp());
            found += here;
            expected += truth;
            squares += (here - truth).powi(2);
        }
    }
    let count = f64::from(POINTS * POINTS);
    [found / count, expected / count, (squares / count).sqrt()]
}

#[test]
fn missing_light_approaches_coverage() -> Result<(), Failure> {
    let mut random = Random(7);
    let mut quad = || {
        let middle = DVec3::new(random.within(1.0), random.within(1.0), random.within(0.5));
        let e = DVec3::new(random.within(1.0), random.within(1.0), random.within(1.0)).normalize();
        let f = e.any_orthonormal_vector();
        [middle, e * 0.02, f * 0.03]
    };
    let mesh = quads((0..1500).map(|_| quad()));
    for (density, light) in [(16.0, ABOVE), (0.7, ["light.0.elevation=55", "light.0.azimuth=130"])] {
        on_both(|backend| {
            let mut before = f64::INFINITY;
            for (resolution, bound) in [(32, 0.02), (64, 0.01), (128, 0.005), (256, 0.0025), (384, 0.0015)] {
                let settings = [format!("shadow.resolution={resolution}"), format!("material.0.density={density}")];
                let case = case(mesh.clone(), 8, &[&light[..], &[&settings[0], &settings[1]]].concat())?;
                let map = Map::of(&case, backend)?;
                let caster = Caster::new(&mesh, map.light(), |_| density);
                let [found, expected, difference] = compare(&map, &caster, 2.0, -1.0);
                println!("{resolution}: {found:.5}, exact {expected:.5}, rms {difference:.4}");
                assert!(expected < 0.95 && expected > 0.5, "{expected}");
                // Each column is right in its middle: what is missing is counted without bias, with the noise of so many samples.
                assert!((found - expected).abs() < bound, "{resolution}: {found}, expected {expected}");
                assert!(difference < 0.9 * before, "{resolution}: {difference} after {before}");
                before = difference;
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// Columns meet triangles where an exact caster does, to the last crossing: at columns' middles the two agree.
#[test]
fn columns_count_what_rays_cross() -> Result<(), Failure> {
    let mut random = Random(11);
    let mut quad = || {
        let mut direction = || DVec3::new(random.within(1.0), random.within(1.0), random.within(1.0)) * 0.3;
        let (middle, e, f) = (direction() * 3.0, direction(), direction());
        [middle, e, f]
    };
    let mesh = quads((0..300).map(|_| quad()));
    let settings = ["light.0.elevation=40", "light.0.azimuth=-70", "material.0.density=0.09", "shadow.resolution=96"];
    let case = case(mesh.clone(), 8, &settings)?;
    on_both(|backend| {
        let map = Map::of(&case, backend)?;
        let caster = Caster::new(&mesh, map.light(), |_| 0.09);
        let (mut compared, mut different) = (0, 0);
        let b = map.block;
        let (rows, edge) = ([b.shadow.row_x, b.shadow.row_y, b.shadow.row_z], map.edge());
        let axes =
            rows.map(|row| DVec3::new(row.factors.x.into(), row.factors.y.into(), row.factors.z.into()).normalize());
        // The world's point at a place in the shadow map's voxels.
        let zero = rows.map(|row| f64::from(row.constant));
        let origin = map.world_origin();
        for y in (1..b.shadow.size.y).step_by(3) {
            for z in (1..b.shadow.size.z).step_by(3) {
                for face in [b.shadow.size.x / 3, b.shadow.size.x / 2, b.shadow.size.x] {
                    let place = [f64::from(face), f64::from(y) + 0.5, f64::from(z) + 0.5];
                    let point =
                        origin + (0..3).map(|axis| axes[axis] * ((place[axis] - zero[axis]) * edge)).sum::<DVec3>();
                    let (found, expected) = (map.at(point)[0], (-caster.depth(point)).exp());
                    compared += 1;
                    different += u32::from((found - expected).abs() > 1e-3);
                }
            }
        }
        // Floats on one side, doubles on the other: where a column grazes an edge or a face, they may differ.
        println!("{different} of {compared} differ");
        assert!(compared > 1000 && different * 200 < compared, "{different} of {compared} differ");
        Ok(())
    })
}
