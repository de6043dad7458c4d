//! Scene files and settings: accepted ones, and refused ones with their messages.

use vitrum::scene::{Clip, Crop, EnvironmentKind, Ground, Phase, Removes, Scene, SceneError, VolumeSource};

const BALL: &str = "volume.builtin = \"ball\"\n";

fn ball() -> Scene {
    Scene::from_toml(BALL, "ball.toml").expect("the smallest scene is valid")
}

/// The message and the help that a scene file of this text is refused with.
fn refusal(text: &str) -> String {
    let error = Scene::from_toml(&format!("{BALL}{text}"), "ball.toml").expect_err("the scene is invalid");
    format!("{error}\n{}", error.help())
}

/// The message that refuses a setting.
fn set_refusal(assignment: &str) -> String {
    let mut scene = ball();
    let error = scene.set(assignment).expect_err("the setting is invalid");
    assert_eq!(scene, ball(), "a refused setting changes nothing");
    format!("{error}\n{}", error.help())
}

#[test]
fn everything_left_out_takes_its_default() {
    let volume = VolumeSource { builtin: Some("ball".to_owned()), ..VolumeSource::default() };
    assert_eq!(ball(), Scene { volume, ..Scene::default() });
}

#[test]
fn unknown_keys_name_their_line_and_the_nearest_key() {
    assert_eq!(
        refusal("[[light]]\nangular_radiu = 3\n"),
        "ball.toml, line 3: `light.0.angular_radiu`: unknown key\ndid you mean `light.0.angular_radius`?"
    );
    assert_eq!(
        refusal("[ground]\nfriction = 3\n"),
        "ball.toml, line 3: `ground.friction`: unknown key\nthe keys here are: height, color, shadow_catcher"
    );
}

#[test]
fn values_out_of_range_name_the_range_and_the_default() {
    assert_eq!(
        refusal("[[light]]\nangular_radius = 400\n"),
        "ball.toml, line 3: `light.0.angular_radius`: found 400, expected a number from 0 to 45\n\
         correct the value, or leave the key out for its default, 1.0"
    );
    assert_eq!(
        refusal("[film]\nwidth = 0\n"),
        "ball.toml, line 3: `film.width`: found 0, expected a whole number from 1 to 16384\n\
         correct the value, or leave the key out for its default, 512"
    );
    assert!(
        refusal("volume.spacing = [1, 0, 1]").contains("`volume.spacing.1`: found 0, expected a finite number above 0")
    );
    assert!(refusal("[[transfer.ior]]\nvalue = 0\nior = 9\n").contains("line 4: `transfer.ior.0.ior`: found 9"));
}

#[test]
fn values_of_the_wrong_type_and_numbers_that_are_not_finite_are_refused() {
    assert!(refusal("[[light]]\nangular_radius = \"soft\"").contains("found \"soft\", expected a number from 0 to 45"));
    assert!(refusal("[[light]]\nangular_radius = nan").contains("found nan, expected a number from 0 to 45"));
    assert!(
        refusal("camera.distance = 0")
            .contains("`camera.distance`: found 0, expected a number from 0.000001 to 1000000")
    );
    assert!(refusal("camera.azimuth = inf").contains("found inf, expected a finite number"));
    assert!(refusal("camera.azimuth = 1e300").contains("expected a finite number"));
    assert!(refusal("camera.up = [0, 1]").contains("found a list of 2 items, expected a list of 3 items"));
    assert!(refusal("film.width = 512.5").contains("expected a whole number"));
    assert!(refusal("camera = 3").contains("found 3, expected a table of the keys projection, framing, azimuth"));
    assert_eq!(
        refusal("sweep.integrator = \"simplectic\""),
        "ball.toml, line 2: `sweep.integrator`: found \"simplectic\", expected one of symplectic, euler\n\
         did you mean `symplectic`?"
    );
}

#[test]
fn bounds_themselves_are_valid() {
    for text in ["shading.roughness = 0.02", "sweep.sample_distance = 0.05", "[[light]]\nangular_radius = 45"] {
        Scene::from_toml(&format!("{BALL}{text}"), "ball.toml").expect(text);
    }
}

#[test]
fn values_that_contradict_each_other_are_refused() {
    assert!(refusal("volume.file = \"head.nrrd\"").contains("line 1: `volume`: both `file` and `builtin` are given"));
    assert!(refusal("[ior_volume]").contains("line 2: `ior_volume`: neither `file` nor `builtin` is given"));
    assert!(refusal("camera.up = [0, 0, 0]").contains("gives no direction"));
    assert!(refusal("camera.position = [1, 2, 3]\ncamera.target = [1, 2, 3]").contains("the eye stands on its target"));
    assert!(refusal("environment.kind = \"map\"").contains("`environment.file` is not given"));
    assert!(
        refusal("film.width = 16384\nfilm.height = 16384\nfilm.supersampling = 2\nsweep.light = \"texels\"")
            .contains("are 1073741824 viewing rays")
    );
    let unsorted = "transfer.ior = [\n  { value = 2, ior = 1 },\n  { value = 1, ior = 1 },\n]\n";
    assert!(refusal(unsorted).contains("line 4: `transfer.ior.1.value`: 1 comes after 2"));
    let many = "[[clip]]\n".repeat(5);
    assert!(refusal(&many).contains("found a list of 5 items, expected a list of at most 4 items"));
}

#[test]
fn a_step_of_two_points_at_one_value_is_valid() {
    let text = "transfer.ior = [{ value = 1, ior = 1 }, { value = 1, ior = 1.5 }]";
    Scene::from_toml(&format!("{BALL}{text}"), "ball.toml").expect("a step is sorted");
}

#[test]
fn a_crop_box_has_an_inside_and_is_of_volumes() {
    let mut scene = ball();
    scene.set("crop.min=[0.25, 0, 0]").expect("a box");
    assert_eq!(scene.crop, Some(Crop { min: [0.25, 0.0, 0.0], max: [1.0; 3] }));
    scene.set("crop.max.0=0.5").expect("a smaller one");
    scene.validate().expect("it has an inside");
    assert_eq!(Scene::from_toml(&scene.to_toml().expect("TOML"), "again.toml").expect("the same").crop, scene.crop);
    scene.set("crop=none").expect("it is optional");
    assert_eq!(scene.crop, None);
    let empty = refusal("crop.min = [0, 0.5, 0]\ncrop.max = [1, 0.5, 1]");
    assert!(empty.contains("`crop.max.1`: 0.5 is not above `crop.min.1`, which is 0.5"), "{empty}");
    assert!(refusal("crop.max = [1, 1, 2]").contains("`crop.max.2`: found 2"));
    for key in ["crop.max = [0.5, 1, 1]", "shading.blend_mode = \"maximum\""] {
        let text = format!("{key}\n[[mesh]]\nbuiltin = \"vase\"\n");
        let error = Scene::from_toml(&text, "mesh.toml").expect_err("it is of volumes").to_string();
        assert!(error.contains("the picture shows a mesh"), "{error}");
    }
}

#[test]
fn text_that_is_not_toml_names_its_line() {
    assert_eq!(
        refusal("[camera]\nroll = [1,\n"),
        "ball.toml, line 3: unclosed array, expected `]`\ncorrect the TOML there; docs/scene.md describes every key"
    );
    assert!(refusal("volume.builtin = \"head\"").contains("duplicate key"));
}

#[test]
fn settings_reach_every_kind_of_key() {
    let mut scene = ball();
    for setting in [
        "light.0.angular_radius=3",
        "camera.up = [0, 1, 0]",
        "environment.kind=checkerboard",
        "sweep.refraction=false",
        "ground.color=[0.5, 0.5, 0.5]",
        "clip=[{ normal = [1, 0, 0] }]",
        "clip.0.offset=2.5",
        "clip.1.removes=opacity",
        "transfer.opacity=[{ value = 0, opacity = 0 }, { value = 1, opacity = 1 }]",
        "transfer.opacity.1.value=7",
        "volume.file=C:\\scans\\2024=1.nrrd",
        "volume.builtin=none",
        "sweep.light=texels",
        "sweep.intensity=none",
    ] {
        scene.set(setting).unwrap_or_else(|error| panic!("{setting}: {error}"));
    }
    assert_eq!(scene.light[0].angular_radius, 3.0);
    assert_eq!(scene.camera.up, [0.0, 1.0, 0.0]);
    assert_eq!(scene.environment.kind, EnvironmentKind::Checkerboard);
    assert!(!scene.sweep.refraction);
    assert_eq!(scene.ground, Some(Ground { height: None, color: [0.5; 3], ..Ground::default() }));
    assert_eq!(
        scene.clip,
        [
            Clip { normal: [1.0, 0.0, 0.0], offset: 2.5, ..Clip::default() },
            Clip { removes: Removes::Opacity, ..Clip::default() }
        ]
    );
    assert_eq!(scene.transfer.opacity[1].value, 7.0);
    assert_eq!(scene.volume.file.as_deref(), Some("C:\\scans\\2024=1.nrrd".as_ref()));
    assert_eq!(scene.volume.builtin, None);
    scene.validate().expect("the scene is valid again");
    scene.set("ground=none").expect("the ground is optional");
    assert_eq!(scene.ground, None);
}

#[test]
fn refused_settings_say_why() {
    assert_eq!(
        set_refusal("light.0.angular_radiu=3"),
        "setting light.0.angular_radiu=3: `light.0.angular_radiu`: unknown key\ndid you mean `light.0.angular_radius`?"
    );
    assert!(set_refusal("light.0.angular_radius=soft").contains("found \"soft\", expected a number from 0 to 45"));
    assert!(set_refusal("light.0.angular_radius").contains("there is no `=`"));
    assert!(set_refusal("=3").contains("there is no key"));
    assert!(set_refusal("light..color=3").contains("a part of it is empty"));
    assert!(set_refusal("light.0.angular_radius.x=3").contains("unknown key\nthis value has no keys inside"));
    assert!(set_refusal("clip.1.offset=3").contains("the list has 0 items"));
    assert!(set_refusal("clip.0.ofset=3").contains("did you mean `clip.0.offset`?"));
    assert!(set_refusal("light.azimut=3").contains("did you mean `light.0.azimuth`?"));
    assert!(set_refusal("light.azimuth=3").contains("this key is now `light.0.azimuth`\nwrite `light.0.azimuth`"));
    assert!(set_refusal("light={azimuth=3}").contains("this key is now `light.0.azimuth`"));
    assert!(set_refusal("clip=[{").contains("`clip`: "));
    assert!(set_refusal("camera=none").contains("expected a table"));
    assert!(set_refusal("transfer.ior.0.ior=1.5").contains("`transfer.ior.0.value`: this key is missing"));
}

#[test]
fn a_scene_survives_being_written_and_read() {
    let mut scene = ball();
    for setting in [
        "clip=[{ normal = [0.1, 0.2, 0.3] }]",
        "transfer.filter=[{ value = -1000, color = [0.3, 1e-7, 1] }]",
        "wall={}",
        "volume.spacing=[0.1, 0.2, 0.3]",
        "ior_volume.file=it's \"quoted\".nrrd",
    ] {
        scene.set(setting).expect(setting);
    }
    let text = scene.to_toml().expect("every name is Unicode");
    assert_eq!(Scene::from_toml(&text, "written").expect(&text), scene);
    assert!(text.contains("normal = [0.1, 0.2, 0.3]"), "floats are written as the f32 that they are:\n{text}");
}

#[test]
fn scenes_that_programs_make_are_checked_too() {
    let mut scene = ball();
    scene.validate().expect("valid");
    scene.light[0].angular_radius = f32::NAN;
    let error = scene.validate().expect_err("NaN is no softness");
    assert_eq!(error.to_string(), "scene: `light.0.angular_radius`: found nan, expected a number from 0 to 45");
}

#[test]
fn lights_are_a_list_that_may_be_empty() {
    let two = Scene::from_toml(&format!("{BALL}[[light]]\n[[light]]\nazimuth = 3"), "ball.toml").expect("two lights");
    assert_eq!(two.light.iter().map(|light| light.azimuth).collect::<Vec<_>>(), [-35.0, 3.0]);
    let dark = Scene::from_toml(&format!("light = []\n{BALL}"), "ball.toml").expect("darkness is valid");
    assert!(dark.light.is_empty() && ball().light.len() == 1);
    let text = dark.to_toml().expect("every name is Unicode");
    assert_eq!(Scene::from_toml(&text, "written").expect(&text), dark);
    assert_eq!(
        refusal("[light]\nsoftness = 2\n"),
        "ball.toml, line 3: `light.softness`: this key is now `light.0.angular_radius`\n\
         write `angular_radius` in a table `[[light]]`, and `light.0.angular_radius` in key frames"
    );
    assert_eq!(
        refusal("[light]\n"),
        "ball.toml, line 2: `light`: found a table, expected a list\nwrite `[[light]]`, once for each item"
    );
}

#[test]
fn keys_of_another_kind_of_light_are_refused_and_a_change_of_the_kind_takes_them_away() {
    for (text, words) in [
        ("kind = \"point\"\nposition = [0, 0, 1]\nazimuth = 3", "a point light has no `azimuth`"),
        ("kind = \"point\"\nposition = [0, 0, 1]\ncone_angle = 3", "a point light has no `cone_angle`"),
        ("radius = 3", "a distant light has no `radius`"),
        ("kind = \"spot\"", "a spot light needs a `position`"),
        ("direction = [0, 0, 0]", "gives no direction"),
    ] {
        assert!(refusal(&format!("[[light]]\n{text}\n")).contains(words), "{}", refusal(&format!("[[light]]\n{text}")));
    }
    let mut scene = ball();
    for setting in ["light.0.azimuth=70", "light.0.position=[0, 0, 3]", "light.0.kind=point", "light.0.kind=distant"] {
        scene.set(setting).expect(setting);
    }
    assert_eq!(scene, ball());
}

#[test]
fn lights_that_texels_do_not_carry_are_refused_by_name() {
    let mesh = "mesh = [{ builtin = \"vase\" }]\n";
    for shown in [BALL, mesh] {
        for kind in ["point", "spot"] {
            let text = |method: &str, sweep: &str| {
                format!(
                    "method = \"{method}\"\n{shown}{sweep}[[light]]\n[[light]]\nkind = \"{kind}\"\nposition = [0, 0, 3]\n"
                )
            };
            let on_texels = text("sweep", "[sweep]\nlight = \"texels\"\n");
            let error = Scene::from_toml(&on_texels, "scene.toml").expect_err(shown);
            let words = format!("a sweep carries distant lights alone on texels, and this is a {kind} light");
            assert!(error.key == "light.1.kind" && error.to_string().contains(&words), "{error}");
            assert!(error.help().contains("set `sweep.light = \"forward\"`"), "{}", error.help());
            for method in ["sweep", "voxels", "beams"].iter().filter(|method| shown == mesh || **method == "sweep") {
                Scene::from_toml(&text(method, ""), "scene.toml").expect("every method has all kinds of lights");
            }
        }
    }
    let spot = format!("{BALL}[[light]]\nkind = \"spot\"\nposition = [0, 0, 3]\ntexture = \"slide.png\"\n");
    let error = Scene::from_toml(&spot, "scene.toml").expect_err("a sweep projects no pictures");
    assert_eq!(error.key, "light.0.texture");
}

#[test]
fn values_that_no_light_has_are_refused() {
    let spot = "kind = \"spot\"\nposition = [0, 0, 3]\n";
    for (text, words) in [
        ("cone_angle = 0", "found 0, expected a number from 0.1 to 89"),
        ("cone_angle = 180", "found 180, expected a number from 0.1 to 89"),
        ("penumbra = 1.5", "expected a number from 0 to 1"),
        ("intensity = -1", "found -1, expected a number from 0 to 1000000000"),
        ("radius = -1", "found -1, expected a number from 0 to 1000000"),
        ("color = [1, -1, 0]", "found -1, expected a number from 0 to 1000000"),
        ("direction = [0, 0, 0]", "gives no direction"),
    ] {
        let found = refusal(&format!("[[light]]\n{spot}{text}\n"));
        assert!(found.contains(words), "{found}");
    }
}

#[test]
fn a_medium_is_for_beams_and_refused_by_name_elsewhere() {
    let text = "[medium]\nscattering = [0.1, 0.2, 0.3]\nanisotropy = 0.7\n";
    assert!(refusal(text).contains("line 2: `medium`: the method `sweep` renders no participating medium"));
    assert!(refusal(text).contains("set `method = \"beams\"`, or leave `medium` out"));
    let voxels = Scene::from_toml(&format!("method = \"voxels\"\n{VASE}{text}"), "scene.toml").expect_err("voxels");
    assert!(voxels.to_string().contains("the method `voxels` renders no participating medium"), "{voxels}");
    let scene = beams(text).expect("beams render a medium");
    let medium = scene.medium.expect("it was given");
    assert_eq!((medium.scattering, medium.phase, medium.extent), ([0.1, 0.2, 0.3], Phase::HenyeyGreenstein, None));
    beams("").expect("a vacuum has surface caustics");
    beams("[medium]\n").expect("a medium may do nothing");
    beams("[medium]\nphase = \"rayleigh\"\nextent = 40\n").expect("a clear sky");
    beams("[medium]\ndensity = { builtin = \"ball\" }\n").expect("a density of its own");
    let windowed = beams("[medium]\ndensity = { file = \"head.nrrd\" }\ndensity_window = [-1000, 400.5]\n");
    let medium = windowed.expect("a window").medium.expect("it was given");
    assert_eq!(medium.density_window, Some([-1000.0, 400.5]));
    for (text, words) in [
        ("anisotropy = 1", "a number from -0.99 to 0.99"),
        ("phase = \"mie\"", "one of henyey_greenstein, rayleigh"),
        (
            "phase = \"rayleigh\"\nanisotropy = 0.5",
            "`medium.anisotropy`: the phase function `rayleigh` has the mean cosine 0",
        ),
        ("extent = 0", "above 0"),
        ("density = {}", "`medium.density`: neither `file` nor `builtin` is given"),
        ("extent = 3\ndensity = { builtin = \"ball\" }", "`medium.extent`: the medium fills the box of the volume"),
        ("density_window = [0, 1]", "`medium.density_window`: it maps the values of a volume to densities"),
        ("density_window = [0]\ndensity = { builtin = \"ball\" }", "a list of 2 items, each a finite number"),
        ("density_window = [0, inf]\ndensity = { builtin = \"ball\" }", "a finite number"),
        (
            "density_window = [1, 1]\ndensity = { builtin = \"ball\" }",
            "the density is 0 at 1 and 1 at 1, and the first is not below the second",
        ),
    ] {
        let error = beams(&format!("[medium]\n{text}\n")).expect_err(text);
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn beams_show_meshes_with_all_kinds_of_bodies_and_lights() {
    let point = "[[light]]\nkind = \"point\"\nposition = [0, 0, 3]\n";
    for text in [point, "[[material]]\nmirror = true\ncolor = [0.9, 0.8, 0.7]\n", "[[material]]\nopaque = true\n"] {
        beams(text).expect(text);
    }
    let volume = Scene::from_toml(&format!("method = \"beams\"\n{BALL}"), "scene.toml").expect_err("a volume");
    assert!(volume.to_string().contains("`beams` shows a mesh, and none is given"), "{volume}");
    for (text, words) in [
        ("[[clip]]\n", "the method `beams` does not clip a mesh"),
        ("[beams]\nrays = 3\n", "found 3, expected a whole number from 4 to 1024"),
        ("[beams]\nbounces = 17\n", "found 17, expected a whole number from 1 to 16"),
        ("[[material]]\nmirror = true\nopaque = true\n", "given as diffuse by `opaque` and as a mirror"),
        ("[[material]]\ncolor = [1, 1, 1]\n", "it is the colour of an opaque body, and the material is clear"),
    ] {
        let error = beams(text).expect_err(text);
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn mirrors_are_refused_by_methods_that_have_none() {
    for method in ["sweep", "voxels"] {
        let text = format!("method = \"{method}\"\n{VASE}[[material]]\nmirror = true\n");
        let error = Scene::from_toml(&text, "scene.toml").expect_err(method);
        let words = format!("the method `{method}` renders no mirrors");
        assert!(error.key == "material.0.mirror" && error.to_string().contains(&words), "{error}");
        assert!(error.help().contains("set `method = \"beams\"`, or make the material clear"), "{}", error.help());
    }
}

const VASE: &str = "mesh = [{ builtin = \"vase\" }]\n";

/// A scene of beams around a vase, with more text behind.
fn beams(text: &str) -> Result<Scene, SceneError> {
    Scene::from_toml(&format!("method = \"beams\"\n{VASE}{text}"), "scene.toml")
}

#[test]
fn meshes_are_a_list_with_places_and_materials() {
    let refusal = |text: &str| {
        let error = Scene::from_toml(&format!("method = \"voxels\"\n{text}"), "scene.toml").expect_err(text);
        format!("{error}\n{}", error.help())
    };
    let two = "[[mesh]]\nbuiltin = \"torus\"\n[[mesh]]\nbuiltin = \"vase\"\nposition = [1, 0, 0]\n";
    let scene = Scene::from_toml(&format!("method = \"voxels\"\n{two}"), "scene.toml").expect("two meshes");
    assert_eq!((scene.mesh.len(), scene.mesh[0].scale, scene.mesh[1].position), (2, 1.0, [1.0, 0.0, 0.0]));
    assert!(refusal(&format!("{two}twist = 3")).contains("`mesh.1.twist`: only a mesh that is alone can be twisted"));
    let nameless = refusal(&format!("{two}material = \"gold\""));
    assert!(nameless.contains("`mesh.1.material`: no entry of `material` has the name \"gold\""), "{nameless}");
    assert!(refusal("[[mesh]]\nscale = 0").contains("above 0"));
    assert!(refusal("[[mesh]]").contains("`mesh.0`: neither `file` nor `builtin` is given"));
    assert!(refusal("[mesh]\nfile = \"a.ply\"").contains("`mesh.file`: this key is now `mesh.0.file`"));
}

#[test]
fn data_in_memory_needs_no_names() {
    let scene = Scene::default();
    scene.check_settings().expect("nothing is wrong with the settings");
    assert!(scene.check_sources().is_err() && scene.validate().is_err());
}
