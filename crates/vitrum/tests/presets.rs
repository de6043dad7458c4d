//! Every preset gives a valid scene for every kind of volume, and leaves other parts of the scene alone.

use vitrum::io::{Volume, Voxels};
use vitrum::preset;
use vitrum::scene::{Camera, Scene, VolumeSource};

fn scene() -> Scene {
    Scene {
        volume: VolumeSource { builtin: Some("ball".to_owned()), ..VolumeSource::default() },
        camera: Camera { azimuth: 77.0, ..Camera::default() },
        ..Scene::default()
    }
}

fn volumes() -> Vec<Volume> {
    let volume = |name, voxels| Volume::new(name, [16, 8, 4], [0.5, 1.0, 2.0], voxels).expect("the volume is valid");
    let floats = |value: fn(f32) -> f32| Voxels::F32((0..512).map(|index| value(index as f32 / 511.0)).collect());
    vec![
        volume("8-bit ramp", Voxels::U8((0..512).map(|index| (index / 2) as u8).collect())),
        volume("8-bit mask", Voxels::U8((0..512).map(|index| u8::from(index > 400)).collect())),
        volume("one voxel set", Voxels::U8((0..512).map(|index| if index == 99 { 255 } else { 0 }).collect())),
        volume("signed CT", Voxels::U16((0..512).map(|index| index * 8).collect()))
            .with_value_mapping(1.0, -1024.0)
            .expect("the mapping is finite"),
        volume("decay", floats(|share| libm::expf(-20.0 * share))),
        volume("outlier", floats(|share| if share == 1.0 { 1e20 } else { share })),
        volume("large", floats(|share| 3e37 * (share - 0.5))),
        volume("tiny", floats(|share| 1e-30 * share)),
        volume("constant", floats(|_| 4.0)),
        volume("zero", floats(|_| 0.0)),
    ]
}

#[test]
fn every_preset_fits_every_volume() {
    for volume in volumes() {
        for (name, _) in preset::names() {
            let mut scene = scene();
            preset::apply(name, &volume, &mut scene).expect("the preset is listed");
            scene.validate().unwrap_or_else(|error| panic!("{name} of {}: {error}", volume.name));
            assert!(!scene.transfer.opacity.is_empty(), "{name}: an empty opacity is a ramp that nobody chose");
            for point in scene.transfer.ior.iter().take(1) {
                assert_eq!(point.ior, 1.0, "{name}: air bends no light");
            }
        }
    }
}

#[test]
fn a_preset_leaves_the_view_alone_and_is_idempotent() {
    let volume = &volumes()[0];
    for (name, _) in preset::names() {
        let mut once = scene();
        preset::apply(name, volume, &mut once).expect("the preset is listed");
        let mut twice = once.clone();
        preset::apply(name, volume, &mut twice).expect("the preset is listed");
        assert_eq!(once, twice);
        let kept =
            |scene: &Scene| (scene.volume.clone(), scene.camera.clone(), scene.sweep.clone(), scene.film.clone());
        assert_eq!(kept(&once), kept(&scene()));
    }
}

#[test]
fn an_unknown_preset_suggests_the_nearest() {
    let mut changed = scene();
    let mut help = |name: &str| preset::apply(name, &volumes()[0], &mut changed).expect_err("no such preset").help();
    assert_eq!(help("ambr"), "did you mean `amber`?");
    assert_eq!(help("cinematic"), "the presets are: plain, bone, amber, glass, xray, haze");
    assert_eq!(changed, scene());
    assert!(preset::names().iter().any(|&(name, _)| name == preset::DEFAULT));
}
