//! Pictures come back from every format, and a failed write leaves no trace.

mod common;

use std::fs;

use common::Folder;
use vitrum_io::{
    Animation, Channel, Error, Layer, Picture, WriteOptions, check_writable, linear_to_srgb, read_picture,
    srgb_to_linear, write_picture, write_picture_with,
};

const WIDTH: u32 = 5;
const HEIGHT: u32 = 3;
const EXTENSIONS: [&str; 7] = ["png", "exr", "hdr", "jpg", "jpeg", "tif", "TIFF"];

/// A gradient, each channel in its own direction.
fn pixels() -> Vec<[f32; 3]> {
    let ramp = |index: u32| index as f32 / (WIDTH * HEIGHT - 1) as f32;
    (0..WIDTH * HEIGHT).map(|index| [ramp(index), 1.0 - ramp(index), 0.25]).collect()
}

fn with_alpha() -> Picture {
    let alpha = |index: usize| index as f32 / 14.0;
    let pixels = pixels().into_iter().enumerate();
    Picture::rgba(WIDTH, HEIGHT, pixels.map(|(index, [r, g, b])| [r, g, b, alpha(index)]).collect())
}

/// The largest difference in sRGB code values.
fn difference(a: &Picture, b: &Picture) -> f32 {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let (a, b) = (a.color(), b.color());
    assert_eq!(a.len(), b.len());
    let both = a.iter().flatten().zip(b.iter().flatten());
    both.map(|(&a, &b)| (linear_to_srgb(a) - linear_to_srgb(b)).abs()).fold(0.0, f32::max)
}

#[test]
fn every_format_comes_back() {
    let folder = Folder::new();
    let picture = Picture::rgb(WIDTH, HEIGHT, pixels());
    for extension in EXTENSIONS {
        let path = folder.path(&format!("picture.{extension}"));
        check_writable(&path).unwrap();
        write_picture(&path, &picture, &[]).unwrap();
        let back = read_picture(&path).unwrap();
        let tolerance = match extension {
            "exr" | "tif" | "TIFF" => 0.0,
            "png" => 0.51 / 255.0,
            "hdr" => 0.02,
            _ => 0.1,
        };
        assert!(difference(&picture, &back) <= tolerance, "{extension}: {}", difference(&picture, &back));
    }
    assert_eq!(folder.names().len(), EXTENSIONS.len(), "{:?}", folder.names());
}

#[test]
fn the_content_decides_not_the_extension() {
    let folder = Folder::new();
    let picture = Picture::rgb(WIDTH, HEIGHT, pixels());
    write_picture(&folder.path("a.exr"), &picture, &[]).unwrap();
    fs::rename(folder.path("a.exr"), folder.path("a.png")).unwrap();
    assert_eq!(read_picture(&folder.path("a.png")).unwrap(), picture);
}

#[test]
fn alpha_stays_straight() {
    let folder = Folder::new();
    let picture = with_alpha();
    for (extension, tolerance) in [("png", 0.51 / 255.0), ("exr", 0.0), ("tif", 0.0)] {
        let path = folder.path(&format!("a.{extension}"));
        write_picture(&path, &picture, &[]).unwrap();
        let back = read_picture(&path).unwrap();
        assert!(difference(&picture, &back) <= 0.51 / 255.0);
        let alpha = |picture: &Picture| picture.layers[0].channel("A").unwrap().to_vec();
        let pairs = alpha(&picture).into_iter().zip(alpha(&back));
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() <= tolerance), "{extension}");
    }
}

#[test]
fn png_in_16_bits_is_finer() {
    let picture = Picture::rgb(1, 1, vec![[srgb_to_linear(0.123_456); 3]]);
    let options = WriteOptions { png_bits: 16, ..WriteOptions::default() };
    let folder = Folder::new();
    let path = folder.path("a.png");
    write_picture_with(&path, &picture, &[], &options).unwrap();
    assert!(difference(&picture, &read_picture(&path).unwrap()) < 0.6 / 65535.0);
}

#[test]
fn gray_stays_gray() {
    let folder = Folder::new();
    let picture = Picture::gray(2, 1, vec![0.0, 1.0]);
    assert_eq!(picture.color(), [[0.0; 3], [1.0; 3]]);
    for extension in ["png", "exr"] {
        let path = folder.path(&format!("a.{extension}"));
        write_picture(&path, &picture, &[]).unwrap();
        assert_eq!(read_picture(&path).unwrap(), picture);
    }
}

#[test]
fn values_out_of_range_take_the_nearest() {
    let folder = Folder::new();
    let picture = Picture::rgb(2, 1, vec![[f32::NAN, -1.0, 0.0], [f32::INFINITY, 2.0, 1.0]]);
    for extension in ["png", "hdr"] {
        let path = folder.path(&format!("a.{extension}"));
        write_picture(&path, &picture, &[]).unwrap();
        let back = read_picture(&path).unwrap().color();
        assert_eq!(back[0], [0.0; 3], "{extension}");
        assert!(back[1][0] >= 1.0 && back[1][0].is_finite(), "{extension}");
    }
}

#[test]
fn exr_keeps_layers_and_metadata() {
    let folder = Folder::new();
    let path = folder.path("a.exr");
    let count = (WIDTH * HEIGHT) as usize;
    let mut picture = with_alpha();
    let plane = |value: f32| vec![value; count];
    picture.layers.push(Layer {
        name: "normal".to_owned(),
        channels: ["X", "Y", "Z"].map(|name| Channel { name: name.to_owned(), data: plane(-0.5) }).to_vec(),
    });
    picture.layers.push(Layer {
        name: "Tiefe µ".to_owned(),
        channels: vec![Channel { name: "Z".to_owned(), data: plane(f32::INFINITY) }],
    });
    let metadata = [("scene", "{\"seed\": 1}"), ("name", "a name of the format's own")];
    let metadata = metadata.map(|(key, value)| (key.to_owned(), value.to_owned()));
    write_picture(&path, &picture, &metadata).unwrap();
    assert_eq!(read_picture(&path).unwrap(), picture);
    let header = exr::meta::MetaData::read_from_file(&path, true).unwrap().headers.remove(0);
    let kept = |key: &str| header.own_attributes.other.get(key.as_bytes()).map(|value| format!("{value:?}"));
    assert!(kept("scene").unwrap().contains("seed"));
    assert!(kept("vitrum.name").unwrap().contains("format's own"));
}

#[test]
fn vectors_keep_their_components_and_signs_or_are_refused() {
    let folder = Folder::new();
    let count = (WIDTH * HEIGHT) as usize;
    let vectors: Vec<[f32; 3]> = (0..count).map(|index| [index as f32 - 7.0, -0.5, -2.0 * index as f32]).collect();
    let component = |axis: usize| vectors.iter().map(|vector| vector[axis]).collect();
    let channels = ["X", "Y", "Z"].into_iter().enumerate();
    let channels = channels.map(|(axis, name)| Channel { name: name.to_owned(), data: component(axis) }).collect();
    let layers = vec![Layer { name: "normal".to_owned(), channels }];
    let picture = Picture { width: WIDTH, height: HEIGHT, layers };
    assert_eq!(picture.color(), vectors);
    for extension in ["exr", "tif"] {
        let path = folder.path(&format!("normal.{extension}"));
        write_picture(&path, &picture, &[]).unwrap();
        assert_eq!(read_picture(&path).unwrap().color(), vectors, "{extension}");
    }
    for extension in ["png", "jpg", "hdr"] {
        let path = folder.path(&format!("normal.{extension}"));
        let error = write_picture(&path, &picture, &[]).unwrap_err().to_string();
        assert!(error.contains("`normal` is a vector") && error.contains("write it to .exr or .tif"), "{error}");
        assert!(!path.exists(), "{extension}");
    }
}

#[test]
fn png_keeps_metadata() {
    let folder = Folder::new();
    let path = folder.path("a.png");
    let picture = Picture::rgb(WIDTH, HEIGHT, pixels());
    write_picture(&path, &picture, &[("Software".to_owned(), "Vitrum µ".to_owned())]).unwrap();
    let decoder = png::Decoder::new(std::io::BufReader::new(fs::File::open(&path).unwrap()));
    let info = decoder.read_info().unwrap().info().clone();
    assert_eq!(info.utf8_text[0].keyword, "Software");
    assert_eq!(info.utf8_text[0].get_text().unwrap(), "Vitrum µ");
    assert!(info.srgb.is_some());
}

#[test]
fn what_cannot_be_written_leaves_the_old_file_alone() {
    let folder = Folder::new();
    let good = Picture::rgb(WIDTH, HEIGHT, pixels());
    let path = folder.write("a.jpg", "old");
    let broken = |change: fn(&mut Picture)| {
        let mut picture = good.clone();
        change(&mut picture);
        picture
    };
    let cases = [
        // Fails in the encoder, when the temporary file is there already.
        (Picture::rgb(70_000, 1, vec![[0.0; 3]; 70_000]), "cannot be written"),
        (broken(|picture| picture.height = 4), "channel `R` has 15 values for 5 x 4 pixels"),
        (broken(|picture| picture.width = 0), "0 x 3 pixels"),
        (broken(|picture| picture.layers.clear()), "5 x 3 pixels in 0 layers"),
        (broken(|picture| picture.layers[0].channels.clear()), "layer `color` has no channels"),
        (broken(|picture| picture.layers[0].name.clear()), "`` is no layer or channel name"),
        (broken(|picture| picture.layers.push(picture.layers[0].clone())), "two layers have the name `color`"),
        (broken(|picture| picture.layers[0].channels[1].name = "R".to_owned()), "two channels of the name `R`"),
    ];
    for (picture, expected) in cases {
        let error = write_picture(&path, &picture, &[]).expect_err(expected);
        assert!(matches!(error, Error::Write { .. }), "{error:?}");
        assert!(error.to_string().contains(expected), "expected: {expected}\nfound: {error}");
    }
    for (key, value) in [("", "v"), ("ä", "v"), (" k", "v"), ("k", "\0")] {
        let metadata = [(key.to_owned(), value.to_owned())];
        let error = write_picture(&path, &good, &metadata).expect_err(key).to_string();
        assert!(error.contains("cannot be kept"), "{error}");
    }
    for options in
        [WriteOptions { png_bits: 12, ..Default::default() }, WriteOptions { jpeg_quality: 0, ..Default::default() }]
    {
        assert!(write_picture_with(&path, &good, &[], &options).is_err());
    }
    assert_eq!(folder.names(), ["a.jpg"]);
    assert_eq!(fs::read(&path).unwrap(), b"old");
    write_picture(&path, &good, &[]).unwrap();
    assert!(read_picture(&path).is_ok());
}

#[test]
fn unwritable_paths_are_known_before() {
    let folder = Folder::new();
    folder.write("file", "");
    fs::create_dir(folder.path("folder.png")).unwrap();
    let cases = [
        ("a.bmp", "`.bmp` is no known picture format; use one of .png, .exr, .hdr, .jpg, .jpeg, .tif, .tiff"),
        ("a", "there is no extension"),
        ("missing/a.png", "there is no folder"),
        ("file/a.png", "there is no folder"),
        ("folder.png", "there is a folder of this name"),
    ];
    for (name, expected) in cases {
        let message = check_writable(&folder.path(name)).expect_err(name).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
    check_writable(&folder.path("new.png")).unwrap();
    assert_eq!(folder.names().len(), 2);
}

#[cfg(unix)]
#[test]
fn written_files_are_for_everybody_as_the_umask_says() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let path = folder.path("a.png");
    write_picture(&path, &Picture::gray(1, 1, vec![0.0]), &[]).unwrap();
    let mode = |path: &std::path::Path| fs::metadata(path).unwrap().permissions().mode();
    assert_eq!(mode(&path), mode(&folder.write("other", "")));
}

#[test]
fn unreadable_pictures_say_why() {
    let folder = Folder::new();
    let mut huge = Vec::new();
    let mut writer = png::Encoder::new(&mut huge, 60_000, 60_000).write_header().unwrap();
    writer.write_chunk(png::chunk::IDAT, &[]).unwrap();
    writer.finish().unwrap();
    let huge = read_picture(&folder.write("huge.png", huge));
    assert!(matches!(huge, Err(Error::TooLarge { .. })), "{huge:?}");
    let missing = read_picture(&folder.path("missing.png"));
    assert!(matches!(missing, Err(Error::Unreadable { .. })), "{missing:?}");
    let text = read_picture(&folder.write("text.png", "this is no picture"));
    assert!(matches!(text, Err(Error::Unsupported { .. })), "{text:?}");
    for extension in EXTENSIONS {
        let path = folder.path(&format!("whole.{extension}"));
        write_picture(&path, &Picture::rgb(WIDTH, HEIGHT, pixels()), &[]).unwrap();
        let whole = fs::read(&path).unwrap();
        let half = read_picture(&folder.write(&format!("half.{extension}"), &whole[..whole.len() / 2]));
        assert!(matches!(half, Err(Error::Invalid { .. })), "{extension}: {half:?}");
    }
}

#[test]
fn gif_films_keep_their_rate() {
    let folder = Folder::new();
    let path = folder.path("animation.gif");
    let picture = Picture::rgb(WIDTH, HEIGHT, pixels());
    // Within half of a hundredth of a second each frame begins when it should, however long the animation is.
    for rate in [1, 12, 24, 30, 40, 50] {
        let frames = 3 * rate + 1;
        let mut animation = Animation::create(&path, [WIDTH, HEIGHT], frames, rate as u16).unwrap();
        (0..frames).for_each(|_| animation.push(&picture).unwrap());
        animation.finish().unwrap();
        let mut decoder = gif::DecodeOptions::new().read_info(fs::File::open(&path).unwrap()).unwrap();
        let mut begin = 0;
        let mut counted = 0;
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            let wanted = f64::from(counted) * 100.0 / f64::from(rate);
            assert!((f64::from(begin) - wanted).abs() <= 0.5, "frame {counted} of {rate} a second begins at {begin}");
            assert!(frame.delay >= 2, "programs slow down shorter ones");
            begin += u32::from(frame.delay);
            counted += 1;
        }
        assert_eq!(counted, frames);
    }
    let error =
        Animation::create(&path, [WIDTH, HEIGHT], 2, 51).err().map(|error| error.to_string()).unwrap_or_default();
    assert!(error.contains("51 frames a second are too many for GIF; choose at most 50"), "{error}");
    Animation::create(&folder.path("animation.png"), [WIDTH, HEIGHT], 2, 60).unwrap();
}
