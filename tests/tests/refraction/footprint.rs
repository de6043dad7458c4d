//! The footprint of a pixel in the environment: neighbours whose rays took other ways do not count.

use super::on_both;
use vitrum::io::{Channel, Layer, Picture};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::frames;
use vitrum_conformance::refraction::{ball, case};

/// An environment whose texels have nothing to do with each other, so that its levels differ.
fn noise() -> Picture {
    let (width, height) = (256_u32, 128_u32);
    let channel = |name: &str, salt: u32| {
        let texel = |index: u32| ((index ^ salt).wrapping_mul(2_654_435_761) >> 24) as f32 / 255.0;
        Channel { name: name.to_owned(), data: (0..width * height).map(texel).collect() }
    };
    let channels = vec![channel("R", 1), channel("G", 7919), channel("B", 104_729)];
    Picture { width, height, layers: vec![Layer { name: "color".to_owned(), channels }] }
}

fn ball_of(ior: &str) -> Result<Case, Failure> {
    let settings = ["environment.kind=map", "voxelization.resolution=64", ior];
    let mut case = case("footprint", ball(48), 64, &settings)?;
    case.assets.environment = Some(noise().into());
    Ok(case)
}

#[test]
fn what_is_seen_beside_a_body_does_not_depend_on_it() -> Result<(), Failure> {
    let cases = [ball_of("material=[{ior=1.5}]")?, ball_of("material=[{ior=2.4}]")?];
    on_both(|backend| {
        let mut pixels = Vec::new();
        for case in &cases {
            let frame = frames::render(case, backend)?;
            let bounces = frame.channel("bounces", "Y").expect("rays through meshes count them").to_vec();
            let color = frame.aov("color").expect("every frame has a colour").color();
            pixels.push(bounces.into_iter().zip(color).collect::<Vec<_>>());
        }
        let beside = pixels[0].iter().zip(&pixels[1]).filter(|(a, b)| a.0 == 0.0 && b.0 == 0.0);
        let (mut seen, mut inside) = (0, 0);
        for ((_, first), (_, second)) in beside {
            seen += 1;
            assert_eq!(first, second, "beside the ball");
        }
        for ((bounces, first), (_, second)) in pixels[0].iter().zip(&pixels[1]) {
            inside += u32::from(*bounces > 0.0 && first != second);
        }
        assert!(seen > 500 && inside > 500, "{seen} pixels beside the ball, {inside} of it");
        Ok(())
    })
}
