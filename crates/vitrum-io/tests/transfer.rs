//! Transfer functions of other programs: one function in every form, and files that are refused.

use vitrum_io::transfer::{TransferFile, paraview_json, read_transfer, read_transfer_bytes};
use vitrum_io::{Error, srgb_to_linear};

/// The opacity goes from 0 at 0 by 0.5 at 100 to 1 at 200, the colour straight from black at 0 to this at 200, in sRGB.
const COLOR: [f32; 3] = [1.0, 0.5, 0.25];

const VP: &str = "1\n1\n0.9\n0.1\n0.2\n10\n6 0 0 100 0.5 200 1\n4 0 1 255 1\n8 0 0 0 0 200 1 0.5 0.25\n";

const MRML: &str = "<?xml version=\"1.0\"?>\n<MRML>\n<VolumeProperty name=\"a\" gradientOpacity=\"4 0 1 255 1\" \
    scalarOpacity=\"6 0 0 100 0.5 200 1\" colorTransfer=\"8 0 0 0 0 200 1 0.5 0.25\"/>\n\
    <VolumeProperty name=\"b\" gradientOpacity=\"4 0 0 255 1\" scalarOpacity=\"2 7 1\" colorTransfer=\"4 7 1 1 1\"/>\n</MRML>\n";

const SLICER_JSON: &str = r#"{"@schema": "volume-property-schema-v1.0.0.json#", "volumeProperties": [{"components": [{
    "scalarOpacityUnitDistance": 2.5,
    "rgbTransferFunction": {"type": "colorTransferFunction", "points": [
        {"x": 0, "color": [0, 0, 0], "midpoint": 0.5, "sharpness": 0},
        {"x": 200, "color": [1, 0.5, 0.25], "midpoint": 0.5, "sharpness": 0}]},
    "scalarOpacity": {"type": "piecewiseLinearFunction", "points": [
        {"x": 0, "y": 0, "midpoint": 0.5, "sharpness": 0}, {"x": 100, "y": 0.5, "midpoint": 0.5, "sharpness": 0},
        {"x": 200, "y": 1, "midpoint": 0.5, "sharpness": 0}]}}]}]}"#;

const PARAVIEW_JSON: &str = r#"[{"ColorSpace": "RGB", "Name": "a", "NanColor": [1, 1, 0],
    "RGBPoints": [0, 0, 0, 0, 200, 1, 0.5, 0.25], "Points": [0, 0, 0.5, 0, 100, 0.5, 0.5, 0, 200, 1, 0.5, 0]}]"#;

const PARAVIEW_XML: &str = "<ColorMaps>\r\n<ColorMap name=\"a\" space=\"RGB\">\r\n<Point x=\"0\" o=\"0\" r=\"0\" g=\"0\" b=\"0\"/>\r\n\
    <Point x=\"100\" o=\"0.5\" r=\"0.5\" g=\"0.25\" b=\"0.125\"/>\r\n<Point x=\"200\" o=\"1\" r=\"1\" g=\"0.5\" b=\"0.25\"/>\r\n\
    <NaN r=\"1\" g=\"1\" b=\"0\"/>\r\n</ColorMap>\r\n</ColorMaps>\r\n";

const VTK: &str = "<VolumeProperty Version=\"1.3\"><VolumeComponent Index=\"0\" ScalarOpacityUnitDistance=\"2.5\">\
    <RGBTransferFunction><ColorTransferFunction Size=\"2\" ColorSpace=\"0\"><Point X=\"0\" Value=\"0 0 0\" MidPoint=\"0.5\" Sharpness=\"0\"/>\
    <Point X=\"200\" Value=\"1 0.5 0.25\"/></ColorTransferFunction></RGBTransferFunction>\
    <ScalarOpacity><PiecewiseFunction Size=\"3\"><Point X=\"0\" Value=\"0\"/><Point X=\"100\" Value=\"0.5\"/><Point X=\"200\" Value=\"1\"/>\
    </PiecewiseFunction></ScalarOpacity>\
    <GradientOpacity><PiecewiseFunction Size=\"1\"><Point X=\"0\" Value=\"0.25\"/></PiecewiseFunction></GradientOpacity>\
    </VolumeComponent></VolumeProperty>";

const LIST: &str = "# scalar, opacity\n0, 0\n100, 0.5\n200, 1\n\n# scalar and colour\n0; 0; 0; 0\n200 1 0.5 0.25\n";

fn state() -> String {
    let property = |name: &str, numbers: &[f64]| {
        let elements =
            numbers.iter().enumerate().map(|(index, value)| format!("<Element index=\"{index}\" value=\"{value}\"/>"));
        format!(
            "<Property name=\"{name}\" id=\"1\" number_of_elements=\"{}\">{}</Property>",
            numbers.len(),
            elements.collect::<String>()
        )
    };
    format!(
        "<ParaView><ServerManagerState><Proxy group=\"sources\" type=\"XMLImageDataReader\">{}</Proxy>\
         <Proxy group=\"lookup_tables\" type=\"PVLookupTable\">{}</Proxy><Proxy group=\"piecewise_functions\" type=\"PiecewiseFunction\">{}\
         </Proxy></ServerManagerState></ParaView>",
        property("Points", &[9.0; 8]),
        property("RGBPoints", &[0.0, 0.0, 0.0, 0.0, 200.0, 1.0, 0.5, 0.25]),
        property("Points", &[0.0, 0.0, 0.5, 0.0, 100.0, 0.5, 0.5, 0.0, 200.0, 1.0, 0.5, 0.0])
    )
}

fn read(name: &str, text: &str) -> TransferFile {
    read_transfer_bytes(name, text.as_bytes(), None).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The value of a function of straight lines.
fn at<const N: usize>(points: &[(f32, [f32; N])], x: f32) -> [f32; N] {
    let after = points.partition_point(|point| point.0 <= x).clamp(1, points.len() - 1);
    let (a, b) = (points[after - 1], points[after]);
    let t = ((x - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
    std::array::from_fn(|i| a.1[i] + (b.1[i] - a.1[i]) * t)
}

fn opacity(file: &TransferFile, x: f32) -> f32 {
    let points: Vec<_> = file.opacity.iter().map(|&(x, opacity)| (x, [opacity])).collect();
    at(&points, x)[0]
}

#[test]
fn one_function_is_read_from_every_form() {
    let state = state();
    let files = [
        ("a.vp", VP, None),
        ("presets.xml", MRML, None),
        ("a.json", SLICER_JSON, Some(2.5)),
        ("map.json", PARAVIEW_JSON, None),
        ("map.xml", PARAVIEW_XML, None),
        ("a.xml", VTK, Some(2.5)),
        ("a.txt", LIST, None),
        ("a.pvsm", state.as_str(), None),
    ];
    for (name, text, unit_distance) in files {
        // A mark in front, as some editors leave it.
        let file = read(name, &format!("\u{feff}{text}"));
        assert_eq!((file.range(), file.unit_distance), ([0.0, 200.0], unit_distance), "{name}");
        for x in [0.0, 40.0, 100.0, 163.0, 200.0] {
            let share = x / 200.0;
            assert!((opacity(&file, x) - share).abs() < 1e-6, "{name}: opacity {} at {x}", opacity(&file, x));
            let expected = COLOR.map(|code| srgb_to_linear(code * share));
            let color = at(&file.color, x);
            // Pieces of lines within 5e-4 of pieces that are twelve to an interval: 1.5e-3 beside the curve.
            let off = color.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(off < 2.5e-3, "{name}: {color:?} at {x}, expected {expected:?}");
        }
    }
}

#[test]
fn what_is_left_out_or_chosen_is_told() {
    let told = |file: &TransferFile, words: &str| {
        let facts = file.assumptions.facts().join("; ");
        assert!(facts.contains(words), "{words}: {facts}");
    };
    told(&read("a.vp", VP), "shading");
    assert_eq!(read("a.xml", VTK).gradient, [(0.0, 0.25)]);
    told(&read("presets.xml", MRML), "2 transfer functions, `a`, `b`: the first was taken");
    let second = read_transfer_bytes("presets.xml", MRML.as_bytes(), Some("b")).expect("the second");
    assert_eq!((second.name.as_str(), second.range()), ("b", [7.0, 7.0]));
    assert_eq!(second.gradient, [(0.0, 0.0), (255.0, 1.0)]);
    told(&read("a.txt", "0 0 0 0\n1 255 0 0\n"), "up to 255");
    told(&read("a.txt", "1 1\n0 0\n"), "were sorted");
    told(&read("a.txt", "0 0\n1 1.5\n"), "1 values of the opacities are not between 0 and 1");
    told(&read("a.json", r#"{"Points": [0,0,0.5,0,1,1,0.5,0], "UseLogScale": 1}"#), "logarithmic");
    told(&read("a.json", r#"{"RGBPoints": [0,0,0,0,1,1,1,1], "ColorSpace": "Munsell"}"#), "`Munsell`");
}

#[test]
fn sharp_ways_spaces_and_categories_keep_their_shape() {
    let step = read("a.json", r#"{"Points": [0, 0, 0.25, 1, 100, 1, 0.5, 0]}"#);
    assert!(opacity(&step, 20.0) < 0.01 && opacity(&step, 30.0) > 0.99, "{:?}", step.opacity);
    let lab = read("a.json", r#"{"RGBPoints": [0,0,0,0, 1,1,1,1], "ColorSpace": "Lab"}"#);
    // L* = 50 reflects 18.4 % of the light.
    let [gray, ..] = at(&lab.color, 0.5);
    assert!((gray - 0.184).abs() < 3e-3, "{gray}");
    let steps = read(
        "a.xml",
        "<ColorMap space=\"Step\"><Point x=\"0\" r=\"1\" g=\"0\" b=\"0\"/><Point x=\"1\" r=\"0\" g=\"1\" b=\"0\"/></ColorMap>",
    );
    assert_eq!((at(&steps.color, 0.9)[0], at(&steps.color, 0.9)[1]), (1.0, 0.0));
    let labels = read("a.json", r#"{"IndexedColors": [1,0,0, 0,0,1], "Annotations": ["3", "liver", "5", "spleen"]}"#);
    assert_eq!([at(&labels.color, 3.9)[0], at(&labels.color, 4.1)[0]], [1.0, 0.0]);
}

#[test]
fn what_is_written_for_paraview_is_read_again() {
    let file = read("a.vp", VP);
    let written = TransferFile { unit_distance: Some(0.7), name: "bone".to_owned(), ..file.clone() };
    let again = read("b.json", &paraview_json(&written));
    assert_eq!((again.name.as_str(), again.unit_distance), ("bone", Some(0.7)));
    for x in [0.0, 33.0, 100.0, 150.0, 200.0] {
        assert!((opacity(&again, x) - opacity(&file, x)).abs() < 1e-5);
        let (a, b) = (at(&again.color, x), at(&file.color, x));
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 2e-3), "{a:?} and {b:?} at {x}");
    }
}

#[test]
fn wrong_files_are_refused_with_their_place() {
    let long = "0 0\n".repeat(1 << 15);
    let cases: [(&str, &str, &str); 16] = [
        ("a.vp", "1\n1\n", "2 lines, and a volume property has 9"),
        ("a.vp", &VP.replace("6 0 0", "7 0 0"), "a.vp, line 7: 6 numbers of opacities behind the count 7"),
        ("a.vp", &VP.replace("100 0.5", "100 half"), "a.vp, line 7: `half` among the opacities is no number"),
        ("a.vp", &VP.replace("100 0.5", "nan 0.5"), "line 7: a point of the opacities is not finite"),
        ("a.json", "{\n\"RGBPoints\": [0,\n}", "a.json, line 3: this is not well-formed JSON"),
        ("a.json", "{}", "neither a colour map of ParaView"),
        ("a.json", r#"{"RGBPoints": [0, 0, 0]}"#, "`RGBPoints` has 3 numbers, and a point has 4"),
        ("a.json", r#"{"RGBPoints": [0, 0, 0, "red"]}"#, "`RGBPoints[3]` is no number"),
        ("a.json", r#"{"volumeProperties": []}"#, "no volume property with a component"),
        ("a.xml", "<ColorMap><Point x=\"0\" r=\"1\"/></ColorMap>", "line 1: the attribute `g` of `Point` is ``"),
        ("a.xml", "<ColorMaps>\n<ColorMap>", "a.xml, line 2: the file ends inside of `ColorMap`"),
        ("a.xml", "<svg/>", "no transfer function in it that is known"),
        ("a.xml", "<!DOCTYPE a [<!ENTITY b \"c\">]><ColorMap/>", "document types are not read"),
        ("a.txt", "0 0\n1 x\n", "a.txt, line 2: `x` is no number"),
        ("a.txt", "0 0 0\n", "line 1: 3 numbers in a line"),
        ("a.txt", &long, "and 16384 are the most"),
    ];
    for (name, text, words) in cases {
        let error = read_transfer_bytes(name, text.as_bytes(), None).expect_err(words);
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.advice().is_some_and(|advice| !advice.is_empty()), "{error}");
    }
    let error = read_transfer_bytes("a.xml", MRML.as_bytes(), Some("aa")).expect_err("no such name");
    assert!(error.to_string().contains("no transfer function `aa`"), "{error}");
    assert!(matches!(read_transfer("nowhere.vp".as_ref()), Err(Error::Unreadable { .. })));
}
