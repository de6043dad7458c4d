//! Texels that are split where the curvature of their light shows (`beams.adaptive`).

use super::picture::{errors, picture};
use super::{LAMP, SUN, case, light, on_both, on_the_cpu};
use vitrum::backend::{Backend, CpuBackend};
use vitrum::method::beams::{self, Drawn};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::{ball, cuboid};
use vitrum_conformance::{Failure, adapter, frames};
use vitrum_kernels::abi::record::beam;
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest difference of the flux of a round with and without split texels, as a share of the light that meets the bodies. A texel has the flux of its
/// middle: of the 100 texels of 32² that a ball's outline cuts each is off by up to one half, and by 0.3 root mean square, which of 800 lit ones is 0.4 %. A way on
/// which little light goes begins and ends within a texel likewise.
const FLUX: f64 = 0.01;

fn with(case: &Case, adaptive: bool) -> Result<Case, Failure> {
    let mut case = case.clone();
    case.scene.set(&format!("beams.adaptive={adaptive}"))?;
    Ok(case)
}

/// The beams of a case, and the texels that are split.
fn trace(case: &Case, backend: &mut dyn Backend) -> Result<(Vec<Drawn>, Vec<bool>), Failure> {
    let frame = beams::prepare(&case.scene, &case.assets, backend).map_err(Failure::from)?;
    light::trace(&frame, backend)?;
    let curved = frame.curved(backend)?.iter().map(|&flag| flag > 0.0).collect();
    Ok((frame.beams(backend)?, curved))
}

/// The red flux of a texel in a round.
fn flux(drawn: &Drawn, round: usize, texel: usize) -> f64 {
    let count = (drawn.count * drawn.count) as usize;
    f64::from(drawn.records[round * drawn.pitch + beam::FLUX * count + texel])
}

/// The red flux of each round.
fn by_round(drawn: &Drawn) -> Vec<f64> {
    let texels = (drawn.count * drawn.count) as usize;
    (0..drawn.records.len() / drawn.pitch)
        .map(|round| (0..texels).map(|texel| flux(drawn, round, texel)).sum())
        .collect()
}

/// A ball in fog.
fn ball_in_fog(light: &str) -> Result<Case, Failure> {
    let medium = "medium={absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],extent=12}";
    let camera = ["camera.position=[0,-9,0.5]", "camera.target=[0,0,-0.3]", "camera.field_of_view=40"];
    let settings = [light, medium, "ground={height=-3}", "material=[{ior=1.5}]", "beams.rays=32"];
    case(ball(96), 128, &[&settings[..], &camera[..]].concat())
}

/// Light is drawn once: by a texel, or by the four in its place; in all, there is as much of it.
#[test]
fn split_texels_have_the_light_of_their_own() -> Result<(), Failure> {
    on_both(|backend| {
        for light in [LAMP, SUN] {
            let case = ball_in_fog(light)?;
            let (whole, none) = trace(&with(&case, false)?, backend)?;
            let (split, curved) = trace(&with(&case, true)?, backend)?;
            assert!(none.is_empty() && whole.len() == 1 && split.len() == 2);
            let (edge, rounds) = (whole[0].count as usize, by_round(&whole[0]).len());
            for (texel, &curved) in curved.iter().enumerate() {
                let (column, row) = (texel % edge, texel / edge);
                let parts = [0, 1].map(|j| [0, 1].map(|i| (2 * row + j) * 2 * edge + 2 * column + i));
                for round in 0..rounds {
                    let before = flux(&whole[0], round, texel);
                    let expected = if curved { 0.0 } else { before };
                    assert_eq!(flux(&split[0], round, texel), expected, "{light}, texel {texel}, round {round}");
                    let of_parts: f64 = parts.as_flattened().iter().map(|&part| flux(&split[1], round, part)).sum();
                    assert!(curved || before == 0.0 || of_parts == 0.0, "{light}, texel {texel} shines twice");
                }
            }
            let [before, kept, parts] = [&whole[0], &split[0], &split[1]].map(by_round);
            let off: Vec<f64> =
                (0..rounds).map(|round| (kept[round] + parts[round] - before[round]) / before[0]).collect();
            let number = curved.iter().filter(|&&curved| curved).count();
            println!("{light}: {number} of {} texels are split; flux by {off:.4?} ({})", curved.len(), backend.name());
            assert!(number > 0, "{light}");
            assert!(off.iter().all(|off| off.abs() <= FLUX), "{light}: {off:?}");
        }
        Ok(())
    })
}

/// A level plate bends no wavefront of parallel light: nothing is split, and the picture has the same bits.
#[test]
fn flat_bodies_split_nothing() -> Result<(), Failure> {
    let settings = [
        SUN,
        "material=[{ior=1.5}]",
        "medium={scattering=[0.1,0.1,0.1],extent=4}",
        "ground={height=-2}",
        "beams.rays=16",
        "camera.position=[4,-9,2]",
    ];
    let case = case(cuboid(DVec3::new(0.5, 0.5, 0.1), DQuat::IDENTITY), 48, &settings)?;
    on_both(|backend| {
        let (_, curved) = trace(&with(&case, true)?, backend)?;
        assert_eq!((curved.len(), curved.iter().filter(|&&curved| curved).count()), (256, 0));
        let mut color = |adaptive: bool| -> Result<Vec<f32>, Failure> {
            let frame = frames::render(&with(&case, adaptive)?, backend)?;
            let mut color = Vec::new();
            for channel in ["R", "G", "B"] {
                color.extend(frame.channel("color", channel).expect("every frame has it").iter().copied());
            }
            Ok(color)
        };
        assert!(color(true)? == color(false)?);
        Ok(())
    })
}

/// The picture of 32² rays with split texels is between those of 32² and of 64².
#[test]
fn split_texels_make_the_picture_better() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        let mut error =
            |rays: u32, adaptive: bool| errors(&with(&picture(rays)?, adaptive)?, backend).map(|[error, _]| error);
        let [coarse, adaptive, fine] = [error(32, false)?, error(32, true)?, error(64, false)?];
        let (_, curved) = trace(&with(&picture(32)?, true)?, backend)?;
        let number = curved.iter().filter(|&&curved| curved).count();
        println!("{coarse:.2e}, with {number} texels split {adaptive:.2e}, {fine:.2e}");
        assert!(adaptive < coarse && adaptive > 0.5 * fine, "{coarse:.2e}, {adaptive:.2e}, {fine:.2e}");
        // Three quarters of the rays of 64² at most.
        assert!(1024 + 4 * number <= 4096 * 3 / 4, "{number} texels");
        Ok(())
    })
}

/// What is split does not depend on the backend.
#[test]
fn both_backends_split_the_same_texels() -> Result<(), Failure> {
    let Some(mut gpu) = adapter::for_test() else { return Ok(()) };
    for light in [LAMP, SUN] {
        let case = with(&ball_in_fog(light)?, true)?;
        let of_cpu = trace(&case, &mut CpuBackend::new(None)?)?.1;
        let of_gpu = trace(&case, &mut gpu)?.1;
        assert!(of_cpu == of_gpu, "{light}");
    }
    Ok(())
}
