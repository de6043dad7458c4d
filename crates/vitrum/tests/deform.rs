//! A mesh that deforms from frame to frame: every picture is the one that a renderer of its own makes, and what can stay on the backend does.

mod common;

use common::{Watch, Watched, cpu, lost, small};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use vitrum::backend::{BackendError, Contents};
use vitrum::io::Mesh;
use vitrum::scene::{MethodName, Scene};
use vitrum::{Assets, MovingMeshes, OutputRequest, Renderer, builtin, render_requested};

fn request() -> OutputRequest {
    OutputRequest { light: false, ..OutputRequest::default() }
}

/// Counts bytes that buffers are made with, and bytes that are written to buffers that were there; fails a write when told to.
#[derive(Clone, Default)]
struct Uploads {
    made: Arc<AtomicU64>,
    written: Arc<AtomicU64>,
    fails: Arc<AtomicBool>,
}

impl Uploads {
    /// Bytes since the last call: made, and written.
    fn since(&self) -> [u64; 2] {
        [&self.made, &self.written].map(|count| count.swap(0, Ordering::Relaxed))
    }
}

impl Watch for Uploads {
    fn creates(&mut self, contents: &Contents<'_>) -> Result<(), BackendError> {
        let bytes = if matches!(contents, Contents::Zeros(_)) { 0 } else { contents.bytes() };
        self.made.fetch_add(bytes, Ordering::Relaxed);
        Ok(())
    }

    fn writes(&mut self, words: usize) -> Result<(), BackendError> {
        self.written.fetch_add(4 * words as u64, Ordering::Relaxed);
        if self.fails.swap(false, Ordering::Relaxed) { Err(lost()) } else { Ok(()) }
    }
}

fn renderer(assets: Assets) -> (Renderer, Uploads) {
    let uploads = Uploads::default();
    (Renderer::new(Box::new(Watched::new(uploads.clone())), assets), uploads)
}

/// The sea of the scene `ocean`, seen from above.
fn sea(settings: &[&str]) -> Scene {
    let (mut scene, _) = small("ocean");
    let seen = ["beams.rays=32", "camera.position=[0,-9,4]", "camera.target=[0,0,-1]", "light.0.direction=[0,0.5,-1]"];
    for setting in seen.iter().chain(settings) {
        scene.set(setting).unwrap_or_else(|error| panic!("{error}"));
    }
    scene
}

fn load(scene: &Scene) -> Assets {
    Assets::load(scene, Path::new("")).expect("it needs no file")
}

fn fresh(scene: &Scene, assets: &Assets) -> vitrum::Frame {
    render_requested(scene, assets, request(), &mut cpu(), &mut |_| true).expect("a picture")
}

const VOXELS: [&str; 3] = ["method=voxels", "medium=none", "ground={height=-6}"];
const EXACT: [&str; 4] = ["method=voxels", "medium=none", "ground={height=-6}", "voxels.surfaces=exact"];
const SWEEP: [&str; 2] = ["method=sweep", "medium=none"];

#[test]
fn a_sea_has_the_pictures_of_its_moments() {
    for (name, settings) in [("beams", &[][..]), ("voxels", &VOXELS), ("exact", &EXACT), ("sweep", &SWEEP)] {
        let mut scene = sea(settings);
        let (mut renderer, uploads) = renderer(load(&scene));
        let mut last = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
        let [first, _] = uploads.since();
        let mut meshes = MovingMeshes::new("", None);
        for seconds in [0.4, 2.0] {
            scene.mesh[0].time = Some(seconds);
            renderer.deform(meshes.at(&scene.mesh).expect("a mesh"));
            let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
            let [made, written] = uploads.since();
            assert!(frame.layers == fresh(&scene, &load(&scene)).layers, "{name}, {seconds} s: another picture");
            assert!(frame.layers != last.layers, "{name}, {seconds} s: nothing has moved");
            match name {
                "beams" => assert!(made == 0 && written > first / 2, "{seconds} s: {made} and {written} of {first}"),
                // The shadow map is made anew.
                "exact" => assert!(written > 1 << 20, "{seconds} s: {made} and {written} of {first}"),
                _ => {}
            }
            last = frame;
        }
    }
}

/// The order in which a ray looks at triangles counts where it meets an edge of two to the last bit, and where it grazes a surface, so that the first of three
/// triangles is in contact with the second one and that with the third, and the first is not with the third: of pictures of 240 × 160 pixels one in 600
/// differs, by up to 0.0011.
#[test]
fn a_twist_refits_the_tree() {
    let (mut scene, assets) = small("torus");
    scene.set("voxels.surfaces=exact").expect("a setting");
    let (mut renderer, uploads) = renderer(assets.clone());
    renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    uploads.since();
    for twist in [10.0, 25.0, 0.0] {
        scene.mesh[0].twist = twist;
        let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
        let [_, written] = uploads.since();
        assert!(written > 1 << 20, "{twist}°: {written} bytes");
        let other = fresh(&scene, &assets);
        let color = |frame: &vitrum::Frame| {
            ["R", "G", "B"].map(|name| frame.channel("color", name).expect("it is there").to_vec())
        };
        let (found, expected) = (color(&frame).concat(), color(&other).concat());
        let off: Vec<f32> = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).filter(|off| *off > 0.0).collect();
        let most = off.iter().copied().fold(0.0, f32::max);
        println!("{twist}°: {} of {} values differ, by up to {most:.1e}", off.len(), found.len());
        assert!(off.len() * 50 <= found.len() && most < 2e-3, "{twist}°: {} values by up to {most}", off.len());
    }
}

/// Small bodies on a cubic lattice, body number `n` at the place `order(n)`; the lattice leans by `lean`.
fn bodies(order: impl Fn(usize) -> usize, lean: f32) -> Mesh {
    const EDGE: usize = 8;
    let corners = [[0.0, 0.0, 0.0], [0.07, 0.0, 0.0], [0.0, 0.07, 0.0], [0.0, 0.0, 0.07]];
    let place = |number: usize| {
        let at = order(number);
        [at % EDGE, at / EDGE % EDGE, at / EDGE / EDGE].map(|index| index as f32 * 0.25 - 0.9)
    };
    let all = 0..EDGE.pow(3);
    let positions = all.clone().flat_map(|number| {
        let at = place(number);
        corners.map(|corner: [f32; 3]| {
            let [x, y, z] = [0, 1, 2].map(|axis| at[axis] + corner[axis]);
            [x, y + lean * x, z]
        })
    });
    let faces = |number: usize| {
        let first = 4 * number as u32;
        [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(|face: [u32; 3]| face.map(|corner| first + corner))
    };
    Mesh::new("bodies", positions.collect(), all.flat_map(faces).collect()).expect("a valid mesh")
}

/// Neighbours of the tree's nodes that go to places far from each other make boxes that all contain each other.
#[test]
fn a_tree_that_is_worn_out_is_built_anew() {
    let (mut scene, _) = small("torus");
    scene.set("voxels.surfaces=exact").expect("a setting");
    let assets = Assets::from(bodies(|number| number, 0.0));
    let (mut renderer, uploads) = renderer(assets);
    renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    let [first, _] = uploads.since();
    // Neighbours that lean stay neighbours; with steps of 75 places, odd and therefore without two at one place, none do.
    for (name, mesh, stays) in
        [("lean", bodies(|number| number, 0.2), true), ("far", bodies(|number| number * 75 % 512, 0.0), false)]
    {
        renderer.deform(Arc::new(mesh.clone()));
        let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
        let [made, written] = uploads.since();
        assert_eq!((made < first / 8, written > 0), (stays, stays), "{name}: {made} and {written} of {first}");
        assert!(frame.layers == fresh(&scene, &Assets::from(mesh)).layers, "{name}: another picture");
    }
}

#[test]
fn a_mesh_of_other_triangles_materials_or_colours_is_uploaded_anew() {
    let mut scene = sea(&EXACT);
    scene.set("material=[{name='paint',opaque=true}]").expect("a setting");
    let waves = load(&scene).subject.mesh().expect("a mesh").clone();
    let count = waves.positions.len();
    let mut painted = waves.clone();
    painted.materials[0].name = "paint".to_owned();
    let colored = Mesh { colors: Some(vec![[0.9, 0.2, 0.1, 1.0]; count]), ..painted.clone() };
    let (mut renderer, _) = renderer(load(&scene));
    for mesh in [waves.clone(), painted, colored, builtin::mesh("vase").expect("it is built in"), waves] {
        renderer.deform(Arc::new(mesh.clone()));
        let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
        assert!(frame.layers == fresh(&scene, &Assets::from(mesh)).layers);
    }
}

#[test]
fn a_frame_whose_refit_fails_is_none_and_the_next_one_is_right() {
    let mut scene = sea(&[]);
    let (mut renderer, uploads) = renderer(load(&scene));
    renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    scene.mesh[0].time = Some(0.4);
    renderer.deform(MovingMeshes::new("", None).at(&scene.mesh).expect("a mesh"));
    uploads.fails.store(true, Ordering::Relaxed);
    assert!(renderer.render(&scene, request(), &mut |_| true).is_err());
    let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    assert!(frame.layers == fresh(&scene, &load(&scene)).layers);
}

#[test]
fn a_volume_makes_room_for_a_mesh() {
    let (scene, assets) = small("ball");
    let (mut renderer, _) = renderer(assets);
    renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    let scene = sea(&SWEEP);
    assert_eq!(scene.method, MethodName::Sweep);
    renderer.deform(MovingMeshes::new("", None).at(&scene.mesh).expect("a mesh"));
    let frame = renderer.render(&scene, request(), &mut |_| true).expect("a picture");
    assert!(frame.layers == fresh(&scene, &load(&scene)).layers);
}
