//! Documents of annotations: well-formed, in the right places, and drawn as they say.

use roxmltree::{Document, Node};
use vitrum::io::{Orientation, Picture, Volume, Voxels};
use vitrum::method::{Bounds, View};
use vitrum::scene::{
    Anchor, Annotation, AnnotationKind, ColorPoint, OpacityPoint, OrientationStyle, Projection, Scene,
};
use vitrum::{Assets, Subject};
use vitrum_annotations::{AnnotationError, Overlay};

/// A patient's volume, 20 x 30 x 40.
fn subject() -> Subject {
    let mut volume = Volume::new("v", [20, 30, 40], [1.0; 3], Voxels::from(vec![7_u8; 24_000])).expect("it is valid");
    volume.orientation = Orientation::Patient;
    volume.range = [0.0, 1000.0];
    Assets::from(volume).subject
}

fn scene(annotations: Vec<Annotation>) -> Scene {
    let mut scene = Scene { annotation: annotations, ..Scene::default() };
    (scene.film.width, scene.film.height) = (600, 400);
    scene.camera.projection = Projection::Orthographic;
    scene.transfer.color =
        vec![ColorPoint { value: 0.0, color: [0.0; 3] }, ColorPoint { value: 1000.0, color: [1.0, 0.0, 0.0] }];
    scene.transfer.opacity =
        vec![OpacityPoint { value: 200.0, opacity: 0.0 }, OpacityPoint { value: 800.0, opacity: 0.5 }];
    scene
}

fn of(kind: AnnotationKind) -> Annotation {
    Annotation { kind, ..Annotation::default() }
}

fn overlay(scene: &Scene) -> Overlay {
    Overlay::new(scene, &subject()).expect("it can be drawn").expect("there are annotations")
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{node:?} has no {name}"))
}

/// Every kind at once, with letters that XML has words for.
fn all() -> Vec<Annotation> {
    let caption = Annotation { text: Some("a < b & \"c\"\nα → β".to_owned()), ..of(AnnotationKind::Caption) };
    let cube = Annotation { style: Some(OrientationStyle::Cube), ..of(AnnotationKind::Orientation) };
    let legend = Annotation { text: Some("density".to_owned()), ..of(AnnotationKind::Legend) };
    let axes = Annotation { anchor: Some(Anchor::TopLeft), ..of(AnnotationKind::Axes) };
    let box_and_letters = [of(AnnotationKind::BoundingBox), of(AnnotationKind::Orientation)];
    [vec![of(AnnotationKind::ScaleBar), caption, cube, legend, axes], box_and_letters.to_vec()].concat()
}

#[test]
fn documents_are_well_formed_and_grow_with_the_picture() {
    let mut scene = scene(all());
    let small = overlay(&scene);
    (scene.film.width, scene.film.height) = (1200, 800);
    let large = overlay(&scene);
    let [small, large] = [&small, &large].map(|overlay| Document::parse(overlay.svg()).expect("it is well-formed"));
    assert!(small.descendants().any(|node| node.text() == Some("a < b & \"c\"")), "the caption's text is there");
    let texts = |document: &Document<'_>| {
        let nodes =
            document.descendants().filter(|node| node.has_tag_name("text") && node.attribute("transform").is_none());
        nodes.map(|node| (node.text().map(str::to_owned), number(node, "x"), number(node, "y"))).collect::<Vec<_>>()
    };
    let [small, large] = [texts(&small), texts(&large)];
    assert!(small.len() > 10 && small.len() == large.len(), "{small:?}");
    for (one, other) in small.iter().zip(&large) {
        assert_eq!(one.0, other.0);
        // The bar is moved to whole pixels.
        assert!((2.0 * one.1 - other.1).abs() < 1.5 && (2.0 * one.2 - other.2).abs() < 1.5, "{one:?} and {other:?}");
    }
}

#[test]
fn the_box_has_the_corners_of_the_volume() {
    let scene = scene(vec![of(AnnotationKind::BoundingBox)]);
    let drawn = overlay(&scene);
    let document = Document::parse(drawn.svg()).expect("it is well-formed");
    let paths: Vec<&str> = document.descendants().filter_map(|node| node.attribute("d")).collect();
    let ends: Vec<[f64; 2]> = paths
        .iter()
        .flat_map(|path| path[1..].split('L'))
        .map(|end| {
            let (x, y) = end.split_once(' ').expect("two numbers");
            [x, y].map(|text| text.parse().expect("a number"))
        })
        .collect();
    // Twelve edges, each with another one around it.
    assert_eq!(ends.len(), 48);
    let view = View::new(&scene, Bounds::from(&subject()));
    for corner in 0..8 {
        let high = |axis: usize, half: f64| if corner >> axis & 1 == 1 { half } else { -half };
        let world = [high(0, 10.0), high(1, 15.0), high(2, 20.0)];
        let [x, y] = view.project(world.into(), [600, 400]).expect("it is before the camera");
        let near = ends.iter().filter(|[a, b]| (a - x).abs() < 2e-3 && (b - y).abs() < 2e-3).count();
        assert_eq!(near, 6, "three edges meet at {world:?}");
    }
    let dashed = document.descendants().filter(|node| node.attribute("stroke-dasharray").is_some()).count();
    assert_eq!(dashed, 6, "the three edges at the hidden corner");
}

#[test]
fn letters_say_where_the_patient_is() {
    let mut scene = scene(vec![of(AnnotationKind::Orientation)]);
    (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
    let drawn = overlay(&scene);
    let document = Document::parse(drawn.svg()).expect("it is well-formed");
    let at = |letter: &str| {
        let node = document.descendants().find(|node| node.text() == Some(letter)).expect(letter);
        [number(node, "x"), number(node, "y")]
    };
    // From the front the patient's right is on the left.
    assert!(at("R")[0] < 100.0 && at("L")[0] > 500.0 && at("S")[1] < 100.0 && at("I")[1] > 300.0);
}

#[test]
fn what_is_drawn_lies_where_the_document_says() {
    let red = Annotation { color: Some("#ff0000".to_owned()), length: Some(10.0), ..of(AnnotationKind::ScaleBar) };
    let scene = scene(vec![red]);
    let drawn = overlay(&scene);
    let document = Document::parse(drawn.svg()).expect("it is well-formed");
    let bar = document.descendants().find(|node| node.attribute("class") == Some("scale-bar")).expect("the bar");
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(bar, name));
    let grey = [0.2_f32; 3];
    let mut picture = Picture::rgb(600, 400, vec![grey; 240_000]);
    drawn.draw(&mut picture).expect("it can be drawn");
    let color = picture.color();
    let pixel = |x: f64, y: f64| color[y as usize * 600 + x as usize];
    let middle = y + 0.5 * height;
    assert_eq!(pixel(x + 1.0, middle), [1.0, 0.0, 0.0]);
    assert_eq!([pixel(x - 1.0, middle), pixel(x + width + 1.5, middle), pixel(300.0, 200.0)], [grey; 3]);
    assert!(color.iter().filter(|pixel| **pixel == grey).count() > 239_000);
}

#[test]
fn a_pixel_is_mixed_as_a_screen_mixes_it() {
    // Half opaque white over black in sRGB is the code of one half.
    let plate = Annotation { background: Some("#ffffff80".to_owned()), ..of(AnnotationKind::Axes) };
    let drawn = overlay(&scene(vec![plate]));
    let document = Document::parse(drawn.svg()).expect("it is well-formed");
    let plate = document.descendants().find(|node| node.attribute("class") == Some("plate")).expect("the plate");
    let at = ((number(plate, "y") + 2.0) as usize) * 600 + (number(plate, "x") + 2.0) as usize;
    let mut picture = Picture::rgba(600, 400, vec![[0.0, 0.0, 0.0, 1.0]; 240_000]);
    drawn.draw(&mut picture).expect("it can be drawn");
    assert!((vitrum::io::linear_to_srgb(picture.color()[at][0]) * 255.0 - 128.0).abs() < 1.0);
    let mut clear = Picture::rgba(600, 400, vec![[0.0; 4]; 240_000]);
    drawn.draw(&mut clear).expect("it can be drawn");
    let alpha = clear.layers[0].channel("A").expect("it has one")[at];
    assert!((alpha * 255.0 - 128.0).abs() < 0.5 && (clear.color()[at][0] - 1.0).abs() < 1e-3, "{alpha}");
}

#[test]
fn scale_bars_in_perspective_and_missing_units_are_told() {
    let mut scene = scene(vec![of(AnnotationKind::ScaleBar)]);
    let told = |scene: &Scene| overlay(scene).notes().join("\n");
    assert!(!told(&scene).contains("perspective") && told(&scene).contains("no unit of length"));
    scene.camera.projection = Projection::Perspective;
    scene.annotation[0].unit = Some("cm".to_owned());
    assert!(told(&scene).contains("perspective") && !told(&scene).contains("no unit of length"));
    scene.annotation = vec![Annotation { text: Some("漢".to_owned()), ..of(AnnotationKind::Caption) }];
    assert!(told(&scene).contains("has no `漢`"));
}

#[test]
fn a_legend_needs_a_transfer_function() {
    let mesh = vitrum::builtin::mesh("vase").expect("it is built in");
    let legend = scene(vec![of(AnnotationKind::Caption), of(AnnotationKind::Legend)]);
    let refused = Overlay::new(&legend, &mesh.into());
    assert!(matches!(refused, Err(AnnotationError::NotPossible { index: 1, .. })), "{refused:?}");
    assert_eq!(Overlay::new(&scene(Vec::new()), &subject()), Ok(None));
}
