//! Key frames: any key of the scene, checked as scene files are, and smooth between.

use vitrum::builtin;
use vitrum::scene::{KeyFrames, Scene};

fn scene() -> Scene {
    builtin::scene("ball").expect("it is built in")
}

fn keys(text: &str) -> KeyFrames {
    KeyFrames::from_toml(text, "keys.toml", 10.0).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_kind_of_key_moves() {
    let keys = keys(
        "[[key]]\nframe = 0\ncamera.azimuth = -30\nlight.0.color = [0, 1, 2]\nsweep.wavelengths = 3\nshading.specular = 1\n\
         environment.visible = true\nsweep.light = \"forward\"\n\
         [[key]]\ntime = 1\ncamera = { azimuth = 30 }\nlight.0.color = [1, 1, 0]\nsweep.wavelengths = 6\n\
         environment.visible = false\n",
    );
    assert_eq!(keys.last_frame(), 10.0);
    let at = |frame| keys.at(&scene(), frame).expect("a scene");
    // Two keys make a straight line.
    for (frame, azimuth) in [(0, -30.0), (5, 0.0), (8, 18.0), (10, 30.0), (99, 30.0)] {
        assert!((at(frame).camera.azimuth - azimuth).abs() < 1e-5, "{frame}");
    }
    assert_eq!(at(5).light[0].color, [0.5, 1.0, 1.0]);
    assert_eq!([at(0), at(1), at(2), at(5), at(10)].map(|scene| scene.sweep.wavelengths), [3, 3, 4, 5, 6]);
    assert_eq!([at(0), at(9), at(10)].map(|scene| scene.environment.visible), [true, true, false]);
    assert_eq!(at(7).shading.specular, 1.0);
    assert!(
        keys.set("camera")
            && keys.set("light.0.color")
            && !keys.set("light.0.angular_radius")
            && !keys.set("light.col")
    );
}

#[test]
fn keys_that_a_frame_does_not_name_go_on() {
    let keys = keys(
        "[[key]]\nframe = 2\nlight.0.angular_radius = 1\ncamera.zoom = 1\n[[key]]\nframe = 4\ncamera.zoom = 9\n\
         [[key]]\nframe = 6\nlight.0.angular_radius = 5\n",
    );
    let at = |frame| keys.at(&scene(), frame).expect("a scene");
    assert_eq!([0, 2, 4, 6].map(|frame| at(frame).light[0].angular_radius), [1.0, 1.0, 3.0, 5.0]);
    assert_eq!([0, 3, 4, 6].map(|frame| at(frame).camera.zoom), [1.0, 5.0, 9.0, 9.0]);
}

#[test]
fn the_eye_comes_nearer_along_key_frames() {
    let keys = keys("[[key]]\nframe = 0\ncamera.distance = 8\n[[key]]\nframe = 4\ncamera.distance = 4\n");
    let at = |frame| keys.at(&scene(), frame).expect("a scene").camera.distance;
    assert_eq!([0, 2, 4].map(at), [8.0, 6.0, 4.0].map(Some));
}

#[test]
fn lists_move_as_a_whole_or_by_their_indices() {
    let whole = keys(
        "[[key]]\nframe = 0\ntransfer.ior = [{ value = 0, ior = 1 }, { value = 1, ior = 1 }]\n\
         [[key]]\nframe = 2\ntransfer.ior = [{ ior = 1.5, value = 0 }, { value = 2, ior = 2 }]\n",
    );
    let points = whole.at(&scene(), 1).expect("a scene").transfer.ior;
    assert_eq!(points.iter().map(|point| (point.value, point.ior)).collect::<Vec<_>>(), [(0.0, 1.25), (1.5, 1.5)]);
    let one = keys("[[key]]\nframe = 0\ntransfer.ior.1.ior = 1.2\n[[key]]\nframe = 2\ntransfer.ior.1.ior = 1.4\n");
    let (before, after) = (scene().transfer.ior, one.at(&scene(), 1).expect("a scene").transfer.ior);
    assert_eq!((before[0].ior, after[1].ior), (after[0].ior, 1.3));
    let ground = keys("[[key]]\nframe = 0\nclip.0.offset = 0\n[[key]]\nframe = 2\nclip.0.offset = 1\n");
    let scene = Scene { clip: Vec::new(), ..scene() };
    assert_eq!(ground.at(&scene, 1).expect("what is missing is made").clip[0].offset, 0.5);
}

#[test]
fn mistakes_name_the_line_and_what_to_do() {
    let first = "[[key]]\nframe = 0\nlight.0.angular_radius = 1\n";
    for (text, line, words) in [
        (
            "[[key]]\nframe = 0\nlight.0.angular_radiu = 1\n".to_owned(),
            3,
            &["key.0.light.0.angular_radiu", "unknown key", "light.0.angular_radius"][..],
        ),
        (
            format!("{first}[[key]]\nframe = 1\nlight.0.angular_radius = 90\n"),
            6,
            &["key.1.light.0.angular_radius", "0 to 45"],
        ),
        (format!("{first}[[key]]\nframe = 1\nlight.0.angular_radius = \"soft\"\n"), 6, &["soft", "number"]),
        (format!("{first}[[key]]\nframe = 0\n"), 4, &["frame 0 comes after frame 0"]),
        (format!("{first}[[key]]\nlight.0.angular_radius = 2\n"), 4, &["`frame` or `time`"]),
        (format!("{first}[[key]]\nframe = 1\ntime = 1\n"), 4, &["`frame` or `time`"]),
        (format!("{first}[[key]]\nframe = -1\n"), 4, &["frame -1"]),
        (format!("{first}[[key]]\ntime = nan\n"), 4, &["frame NaN"]),
        ("[[key]]\nframe = 0\nfilm.width = 9\n".to_owned(), 3, &["same for the whole animation", "--size"]),
        ("[[key]]\nframe = 0\nvolume.file = \"a.nrrd\"\n".to_owned(), 3, &["same for the whole animation"]),
        (
            "[[key]]\nframe = 0\ntransfer.ior = []\n[[key]]\nframe = 1\ntransfer.ior = [{ value = 0, ior = 1 }]\n"
                .to_owned(),
            6,
            &["another length"],
        ),
        ("keys = 3\n".to_owned(), 1, &["unknown key", "the keys here are: key"]),
        ("[[key]]\nframe = \n".to_owned(), 2, &[]),
    ] {
        let error = KeyFrames::from_toml(&text, "keys.toml", 10.0).expect_err(&text);
        let message = format!("{error}; {}", error.help());
        assert!(message.starts_with(&format!("keys.toml, line {line}: ")), "{message}\n{text}");
        for word in words {
            assert!(message.contains(word), "no `{word}` in: {message}");
        }
    }
    for text in ["", "key = []\n", "key = 3\n"] {
        let error = KeyFrames::from_toml(text, "keys.toml", 10.0).expect_err(text);
        assert!(error.to_string().contains("this key is missing"), "{error}");
    }
}

#[test]
fn a_frame_that_contradicts_itself_is_named() {
    let keys = keys("[[key]]\nframe = 0\ncamera.up = [0, 0, 1]\n[[key]]\nframe = 2\ncamera.up = [0, 0, -1]\n");
    keys.at(&scene(), 0).expect("a scene");
    let error = keys.at(&scene(), 1).expect_err("no direction halfway").to_string();
    assert!(error.starts_with("keys.toml, frame 1: `camera.up`"), "{error}");
}
