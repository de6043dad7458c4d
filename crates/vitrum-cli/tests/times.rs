//! Points in time: by number, in seconds, by file, and as animations.

mod common;

use common::{Folder, nrrd};
use serde_json::Value;

fn info(folder: &Folder, arguments: &[&str]) -> Value {
    let text = folder.succeed(&[&["info", "--json"], arguments].concat());
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// A grid of 4³ points of one value, but for one point of 0.
fn vti(value: u8) -> String {
    let values = format!("0 {}", format!("{value} ").repeat(63));
    format!(
        "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 3 0 3 0 3\"><Piece Extent=\"0 3 0 3 0 3\">\
         <PointData><DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">{values}</DataArray></PointData></Piece></ImageData></VTKFile>"
    )
}

fn most(info: &Value) -> f64 {
    info["range"][1].as_f64().expect("a range")
}

#[test]
fn moments_in_seconds_are_the_nearest_that_a_file_states() {
    let folder = Folder::new();
    let header = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 2 2 3\nspacings: 1 1 1 250\nunits: \"mm\" \"mm\" \"mm\" \"ms\"\nencoding: raw\n\n";
    folder.write("time.nrrd", [header.as_bytes(), &(0..24).collect::<Vec<u8>>()].concat());
    let at = info(&folder, &["time.nrrd", "--time", "0.5s"]);
    assert_eq!((most(&at), &at["times"], &at["moments"]), (23.0, &3.into(), &serde_json::json!([0.0, 0.25, 0.5])));
    assert_eq!(most(&info(&folder, &["time.nrrd", "--time", "0.3s"])), 15.0);
    assert!(
        folder
            .succeed(&["info", "time.nrrd", "--time", "1"])
            .contains("3 from 0 s to 0.5 s; this is number 1, at 0.25 s")
    );
    folder.refuse(&["info", "time.nrrd", "--time", "9s"], 3, &["from 0 s to 0.5 s", "--time"]);
    folder.write("scene.toml", "[volume]\nfile = \"time.nrrd\"\nseconds = 0.5\n");
    assert_eq!(most(&info(&folder, &["scene.toml"])), 23.0);
    assert_eq!(most(&info(&folder, &["scene.toml", "--time", "0"])), 7.0);
    let plain = header.replace("spacings: 1 1 1 250\nunits: \"mm\" \"mm\" \"mm\" \"ms\"\n", "");
    folder.write("plain.nrrd", [plain.as_bytes(), &[1; 24]].concat());
    folder.refuse(
        &["info", "plain.nrrd", "--time", "0.5s"],
        3,
        &["does not say when its points in time are", "--time"],
    );
    folder.write("one.nrrd", nrrd("2 2 2", "", &[1; 8]));
    folder.refuse(&["info", "one.nrrd", "--time", "x"], 2, &["0.5s"]);
}

#[test]
fn collections_and_numbered_files_are_points_in_time() {
    let folder = Folder::new();
    for (index, value) in [10, 20, 30].into_iter().enumerate() {
        folder.write(&format!("flow_{index:04}.vti"), vti(value));
    }
    // Not of the series: another prefix, and no number.
    folder.write("flow_b0001.vti", vti(99));
    folder.write("flow_.vti", vti(98));
    folder.write(
        "flow.pvd",
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\"><Collection>\n\
         <DataSet timestep=\"0.5\" group=\"\" part=\"0\" file=\"flow_0001.vti\"/>\n\
         <DataSet timestep=\"0\" part=\"0\" file=\"flow_0000.vti\"/>\n<DataSet timestep=\"0\" part=\"1\" file=\"flow_.vti\"/>\n\
         <DataSet timestep=\"2\" part=\"0\" file=\"flow_0002.vti\"/>\n</Collection></VTKFile>\n",
    );
    let first = info(&folder, &["flow.pvd"]);
    assert_eq!((most(&first), &first["format"], &first["times"]), (10.0, &"VTK collection".into(), &3.into()));
    assert!(first["assumptions"].to_string().contains("left out: 1 further parts"), "{first}");
    assert_eq!(most(&info(&folder, &["flow.pvd", "--time", "2"])), 30.0);
    assert_eq!(most(&info(&folder, &["flow.pvd", "--time", "0.6s"])), 20.0);
    let own = info(&folder, &["flow_0001.vti"]);
    assert_eq!((most(&own), &own["times"]), (20.0, &3.into()));
    assert!(own["assumptions"].to_string().contains("number 1 of 3"), "{own}");
    assert_eq!(most(&info(&folder, &["flow_0001.vti", "--time", "2"])), 30.0);
    assert_eq!(info(&folder, &["flow_.vti"])["times"], 1);
    folder.refuse(&["info", "flow_0001.vti", "--time", "3"], 3, &["the point in time 3", "0 to 2"]);
    for (name, file) in [("up.pvd", "../flow_0000.vti"), ("gone.pvd", "gone.vti"), ("self.pvd", "self.pvd")] {
        folder.write(
            name,
            format!("<VTKFile type=\"Collection\"><Collection><DataSet file=\"{file}\"/></Collection></VTKFile>"),
        );
        folder.refuse(&["info", name], 3, &[name, "line 1"]);
    }
    folder.write("none.pvd", "<VTKFile type=\"Collection\"><Collection/></VTKFile>");
    folder.refuse(&["info", "none.pvd"], 3, &["no `DataSet`"]);
}

#[test]
fn animations_go_over_time() {
    let folder = Folder::new();
    for (index, value) in [0, 200, 200].into_iter().enumerate() {
        folder.write(&format!("flow_{index}.vti"), vti(value));
    }
    let common = ["--backend", "cpu", "--size", "16x16", "--quiet"];
    let transfer = "opacity = [{ value = 100, opacity = 0 }, { value = 101, opacity = 1 }]";
    folder.write("scene.toml", format!("[volume]\nfile = \"flow_0.vti\"\n[transfer]\n{transfer}\n"));
    folder.succeed(&[&["turntable", "scene.toml", "--over-time", "-o", "frames"], &common[..]].concat());
    let picture =
        |index: u32| std::fs::read(folder.file("frames").join(format!("frame-{index:05}.png"))).expect("a picture");
    assert!(!folder.file("frames").join("frame-00003.png").exists());
    // The camera stands still: the same volume gives the same picture.
    assert_ne!(picture(0), picture(1));
    assert_eq!(picture(1), picture(2));
    folder.succeed(&[&["turntable", "scene.toml", "--over-time", "--frames", "6", "-o", "slow"], &common[..]].concat());
    assert!(folder.file("slow").join("frame-00005.png").exists());
    folder.write("one.nrrd", nrrd("2 2 2", "", &[1; 8]));
    folder.refuse(
        &["turntable", "one.nrrd", "--preset", "haze", "--over-time", "-o", "one"],
        2,
        &["one point in time", ".pvd"],
    );
}
