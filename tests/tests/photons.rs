//! The sweep's light against photons that were followed one by one.

use vitrum::backend::CpuBackend;
use vitrum::method::sweep::{Sweep, View};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::photons::{Field, blocks, irradiance, misplaced};

/// Texels along each side of the blocks over which light is compared: the sweep and a count of photons blur differently.
const BLOCK: usize = 4;

/// The share of light that the sweep puts somewhere else, and its flux over the photons', at a third, two thirds and the end of
/// the way from the volume's middle to the last plane.
fn compare(scene: &str, light: &str, edge: u32, resolution: u32, across: u32) -> Result<Vec<(f64, f64)>, Failure> {
    let settings = ["light.softness=0", "light.elevation=20", light];
    let case = Case::builtin(scene, edge, Some(resolution), &settings)?;
    let mut backend = CpuBackend::new(None)?;
    let mut sweep = Sweep::prepare(&case.scene, &case.inputs, &mut backend)?;
    let planes = sweep.planes;
    let middle = planes.behind / 2;
    let at = [1, 2, 3].map(|third| middle + (planes.count - 1 - middle) * third / 3);
    let view = View::new(&case.scene, &case.inputs.volume);
    let field = Field::new(&case.inputs.volume, &case.scene.transfer, &view);
    let photons = irradiance(&field, &sweep.light_grid, &planes, &at, across);

    let size = sweep.light_grid.size;
    let texels = (sweep.light_grid.size[0] * sweep.light_grid.size[1]) as usize;
    let (mut plane, mut unoccluded, mut found) = (0, 0.0f64, Vec::new());
    for pass in std::mem::take(&mut sweep.passes.passes) {
        let concentrates = pass.kernel.declaration.name == "sweep_concentrate_light";
        sweep.passes.passes.push(pass);
        if concentrates {
            if plane == 0 || at.contains(&plane) {
                sweep.run(&mut backend, &mut |_| true)?;
                sweep.passes.passes.clear();
                let red: Vec<f64> = sweep.irradiance(&mut backend)?[..texels].iter().map(|&e| f64::from(e)).collect();
                unoccluded = if plane == 0 { red[0] } else { unoccluded };
                found.push(red.iter().map(|e| e / unoccluded).collect::<Vec<f64>>());
            }
            plane += 1;
        }
    }
    sweep.free(&mut backend);
    let flux = |light: &[f64]| light.iter().sum::<f64>();
    let pairs = photons.iter().zip(&found[1..]);
    Ok(pairs
        .map(|(reference, found)| {
            let of = |light: &[f64]| blocks(light, size, BLOCK);
            (misplaced(&of(reference), &of(found)), flux(found) / flux(reference))
        })
        .collect())
}

/// The photons themselves: through a thick glass plate met at 30° they are displaced as Snell says, and none is lost.
#[test]
fn photons_obey_snell() {
    use vitrum_conformance::photons::Photon;
    use vitrum_kernels::glam::DVec3;
    let case = Case::builtin("ball", 16, Some(32), &[]).expect("the scene exists");
    let mut scene = case.scene.clone();
    scene.transfer.medium.clear();
    let view = View::new(&scene, &case.inputs.volume);
    let field = Field::new(&case.inputs.volume, &scene.transfer, &view);
    // Through the ball's centre nothing bends; beside it the ray crosses the axis where a ball lens has it.
    let (right, away) = (DVec3::X, DVec3::Z);
    let centre = view.point(DVec3::ZERO);
    for height in [0.0, 0.25, 0.5] {
        let photon = Photon { position: centre - away * 3.0 + right * height, direction: away, weight: DVec3::ONE };
        let depths = [centre.z + 1.2, centre.z + 2.0];
        let mut crossings = Vec::new();
        photon.follow(&field, &depths, |_, position, weight| crossings.push((position - centre, weight)));
        let [(a, weight), (b, _)] = crossings[..] else { panic!("the photon crosses both depths") };
        assert_eq!(weight, DVec3::ONE);
        let slope = (b.x - a.x) / (b.z - a.z);
        let outside = f64::asin(height);
        let inside = f64::asin(height / 1.5);
        let expected = -(2.0 * (outside - inside)).tan();
        println!("height {height}: slope {slope:.4}, Snell {expected:.4}");
        // The surface is two voxels thick, an eighth of the radius.
        assert!((slope - expected).abs() < 0.06, "{slope} instead of {expected}");
    }
}

#[test]
fn before_the_focus_the_sweep_puts_light_where_photons_go() -> Result<(), Failure> {
    for (scene, most) in [("luneburg", 0.05), ("ball", 0.10), ("glass", 0.15)] {
        for (third, (misplaced, flux)) in compare(scene, "sweep.light=texels", 64, 32, 4)?.into_iter().enumerate() {
            println!("{scene}, {} thirds of the way: {:.1} % misplaced, flux {flux:.3}", third + 1, misplaced * 100.0);
            assert!(third > 0 || misplaced < most, "{scene}: {misplaced}");
            assert!(flux < 1.05, "{scene}: {flux} times the photons' light");
        }
    }
    Ok(())
}

/// Sheets put it there behind the focus, too, and lose none.
#[test]
fn sheets_put_light_where_photons_go() -> Result<(), Failure> {
    // What is left are walls one voxel thick, whose light a texel's four nodes cannot tell, and the noise of 16 photons a texel.
    for (scene, most) in [("luneburg", 0.03), ("ball", 0.04), ("glass", 0.08)] {
        for (third, (misplaced, flux)) in compare(scene, "sweep.light=sheets", 64, 32, 4)?.into_iter().enumerate() {
            println!("{scene}, {} thirds of the way: {:.1} % misplaced, flux {flux:.3}", third + 1, misplaced * 100.0);
            assert!(misplaced < most, "{scene}: {misplaced}");
            assert!((flux - 1.0).abs() < 0.03, "{scene}: {flux} times the photons' light");
        }
    }
    Ok(())
}

/// 8: a ball lens, the share of its light inside radius a at distance z behind the centre. Beyond the focus, where the sweep fails,
/// photons must be right.
#[test]
fn photons_have_the_spot_of_a_ball_lens() {
    use vitrum_conformance::photons::Photon;
    use vitrum_kernels::glam::DVec3;
    let case = Case::builtin("ball", 16, Some(96), &[]).expect("the scene exists");
    let mut scene = case.scene.clone();
    scene.transfer.medium.clear();
    let view = View::new(&scene, &case.inputs.volume);
    let field = Field::new(&case.inputs.volume, &scene.transfer, &view);
    let centre = view.point(DVec3::ZERO);
    let depths = [centre.z + 1.5, centre.z + 2.0, centre.z + 3.0];
    let mut distances: [Vec<f64>; 3] = Default::default();
    let edge = 60;
    let mut photons = 0;
    for index in 0..edge * edge {
        let at = |i: i32| (f64::from(i) + 0.5) / f64::from(edge) * 2.0 - 1.0;
        let (x, y) = (at(index % edge), at(index / edge));
        if x.hypot(y) < 1.0 {
            photons += 1;
            let position = centre + DVec3::new(x, y, -2.0);
            let photon = Photon { position, direction: DVec3::Z, weight: DVec3::ONE };
            photon.follow(&field, &depths, |plane, position, _| {
                distances[plane].push((position - centre).truncate().length());
            });
        }
    }
    for (plane, z, radius, truth) in
        [(0, 1.5, 0.5, 0.7878), (1, 2.0, 0.25, 0.2694), (1, 2.0, 0.5, 0.5106), (2, 3.0, 0.5, 0.1840)]
    {
        let inside = distances[plane].iter().filter(|distance| **distance < radius).count();
        let share = inside as f64 / f64::from(photons);
        println!("z = {z}, a = {radius}: {share:.4}, truth {truth}");
        // The surface is two of 88 voxels thick; the rim's rays, a tenth of all, go astray in it.
        assert!((share - truth).abs() < 0.04, "{share} instead of {truth}");
    }
}
