//! Every preset gives a valid scene for every kind of volume, and leaves other parts of the scene alone.

use vitrum::io::{Orientation, Volume, Voxels};
use vitrum::preset::{self, Adjustments, PresetError};
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
            match preset::apply(name, &volume, &mut scene) {
                Err(PresetError::NotHounsfield { .. }) => {
                    assert!(name.starts_with("ct-") && volume.name != "signed CT", "{name} of {}", volume.name);
                    continue;
                }
                Err(PresetError::NoLabels { .. }) => {
                    assert_eq!(*name, "labels");
                    continue;
                }
                outcome => outcome.expect("the preset is listed"),
            }
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
    let volume = &volumes()[3];
    for (name, _) in preset::names().iter().filter(|(name, _)| *name != "labels") {
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
    assert_eq!(
        help("cinematic"),
        "the presets are: plain, bone, amber, glass, xray, mip, haze, labels, ct-bone, ct-angio, ct-soft, ct-lung, mr-angio"
    );
    assert_eq!(changed, scene());
    for volume in volumes() {
        let choice = preset::choose(&volume);
        assert!(preset::names().iter().any(|&(name, _)| name == choice.name), "{choice:?}");
    }
}

/// The opacity of a scene's function at a value.
fn opacity(scene: &Scene, value: f32) -> f32 {
    let points = &scene.transfer.opacity;
    let after = points.partition_point(|point| point.value <= value);
    match (after.checked_sub(1).map(|before| points[before]), points.get(after)) {
        (Some(a), Some(b)) => a.opacity + (b.opacity - a.opacity) * (value - a.value) / (b.value - a.value),
        (Some(only), None) => only.opacity,
        (None, first) => first.map_or(0.0, |first| first.opacity),
    }
}

#[test]
fn nothing_is_seen_below_a_threshold_and_something_above() {
    let ct = &volumes()[3];
    for (name, _) in preset::names().iter().filter(|(name, _)| *name != "labels") {
        for threshold in [-500.0, 120.0, 800.0] {
            let adjustments = Adjustments { threshold: Some(threshold), ..Adjustments::default() };
            let mut scene = scene();
            preset::fit(name, ct, &adjustments, &mut scene).expect("the values may be Hounsfield units");
            scene.validate().unwrap_or_else(|error| panic!("{name} above {threshold}: {error}"));
            assert_eq!(opacity(&scene, threshold), 0.0, "{name} at {threshold}");
            let first = scene.transfer.opacity.iter().position(|point| point.opacity > 0.0);
            assert!(first.is_none_or(|first| scene.transfer.opacity[first].value > threshold), "{name}");
            let bends = scene.transfer.ior.iter().find(|point| point.ior != 1.0);
            assert!(bends.is_none_or(|point| point.value > threshold), "{name}");
            // Lungs end at -400, by the preset; a layer of fog is thin.
            let shows = matches!(*name, "plain" | "bone" | "amber" | "ct-bone" | "ct-angio" | "ct-soft");
            assert!(!shows || opacity(&scene, 3000.0) > 0.2, "{name} above {threshold}: {:?}", scene.transfer.opacity);
        }
    }
}

#[test]
fn a_window_holds_what_the_function_changes_over() {
    let ramp = &volumes()[0];
    let adjustments = Adjustments { window: Some([40.0, 100.0]), ..Adjustments::default() };
    let mut fitted = scene();
    preset::fit("haze", ramp, &adjustments, &mut fitted).expect("a preset of any volume");
    let values = |scene: &Scene| scene.transfer.opacity.iter().map(|point| point.value).collect::<Vec<_>>();
    let shown = values(&fitted);
    assert_eq!((shown.first(), shown.last()), (Some(&80.0), Some(&120.0)));
    // The window of soft tissue is the preset's own: nothing moves, and a preset of units takes other values by it.
    let soft = Adjustments { window: Some([400.0, 40.0]), ..Adjustments::default() };
    let (mut plain, mut windowed) = (scene(), scene());
    preset::apply("ct-soft", &volumes()[3], &mut plain).expect("Hounsfield units");
    preset::fit("ct-soft", &volumes()[3], &soft, &mut windowed).expect("Hounsfield units");
    for (a, b) in values(&plain).iter().zip(values(&windowed)) {
        assert!((a - b).abs() < 1e-3, "{a} and {b}");
    }
    preset::fit("ct-soft", ramp, &soft, &mut windowed).expect("a window says where the values lie");
    // A scene's own ramp.
    let mut own = scene();
    preset::adjust(ramp, &adjustments, &mut own).expect("a window");
    assert_eq!([opacity(&own, 80.0), opacity(&own, 100.0), opacity(&own, 120.0)], [0.0, 0.5, 1.0]);
    let wrong = Adjustments { window: Some([0.0, 1.0]), ..Adjustments::default() };
    assert!(matches!(preset::adjust(ramp, &wrong, &mut own), Err(PresetError::Adjustment { .. })));
}

#[test]
fn maps_of_colours_lie_over_what_is_shown() {
    let adjustments =
        Adjustments { colormap: Some("viridis".to_owned()), window: Some([40.0, 100.0]), ..Adjustments::default() };
    let mut scene = scene();
    preset::fit("plain", &volumes()[0], &adjustments, &mut scene).expect("a preset");
    let colors = &scene.transfer.color;
    assert_eq!((colors[0].value, colors[colors.len() - 1].value), (80.0, 120.0));
    // Yellow, in linear light.
    assert!(colors[colors.len() - 1].color[0] > 0.9 && colors[colors.len() - 1].color[2] < 0.05);
    let wrong = Adjustments { colormap: Some("viridi".to_owned()), ..Adjustments::default() };
    let error = preset::fit("plain", &volumes()[0], &wrong, &mut scene).expect_err("no such map");
    assert_eq!(error.help(), "did you mean `viridis`?");
}

#[test]
fn presets_of_units_refuse_other_values_and_say_what_to_do() {
    let mut changed = scene();
    let error = preset::apply("ct-bone", &volumes()[0], &mut changed).expect_err("8 bits");
    assert!(error.to_string().contains("Hounsfield units, and the values go from 0 to 255"), "{error}");
    assert!(error.help().contains("`bone`") && error.help().contains("level 1524"), "{}", error.help());
    assert_eq!(changed, scene());
    // The points of 3D Slicer's CT-Bone.
    preset::apply("ct-bone", &volumes()[3], &mut changed).expect("Hounsfield units");
    assert!((opacity(&changed, 641.385) - 0.715_686).abs() < 1e-6 && opacity(&changed, -16.45) == 0.0);
    // Its longest edge, 8, is no CT's in millimetres; a patient's volume is in millimetres.
    let millimetre = changed.transfer.reference_length.expect("opacities are per millimetre");
    assert!((millimetre - 8.0 / 300.0).abs() < 1e-6, "{millimetre}");
    let notes = preset::fit("ct-bone", &volumes()[3], &Adjustments::default(), &mut changed).expect("Hounsfield units");
    assert!(notes.iter().any(|note| note.contains("the longest edge, 8, was taken for 300 mm")), "{notes:?}");
    let patient = Volume { orientation: Orientation::Patient, ..volumes()[3].clone() };
    let notes = preset::fit("ct-bone", &patient, &Adjustments::default(), &mut changed).expect("Hounsfield units");
    assert_eq!((changed.transfer.reference_length, notes.len()), (Some(1.0), 1), "{notes:?}");
}
