//! 15: the faces of a volume's box, and cuts through it, refract by Snell's law where the index next to them is not that of the surroundings.

use vitrum::backend::Backend;
use vitrum::method::sweep::Sweep;
use vitrum::scene::{Clip, Projection, Scene, Transport, Wall};
use vitrum::{Assets, OutputRequest};
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::border::{Ray, block, cut, faces, half, ray_and_end, scene, through};
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::closed_forms::{cuboid, refracting, render};
use vitrum_kernels::abi::record::status;
use vitrum_kernels::glam::DVec3;

use crate::setup::backends;

/// The largest errors of direction (radians) and place (world units) of rays behind the block, the number of rays that go through it, and of
/// those of them that the sweep lost.
fn errors(scene: &Scene, ior: f64, backend: &mut dyn Backend) -> (f64, f64, usize, usize) {
    let volume = block();
    let frame = render(scene, &volume, backend);
    let faces = faces(&scene.clip);
    let (mut turn, mut aside, mut rays, mut lost) = (0.0, 0.0, 0, 0);
    for pixel in (0..frame.height).flat_map(|y| (0..frame.width).map(move |x| (x, y))) {
        let (begins, (position, direction), fate) = ray_and_end(scene, &volume, &frame, pixel);
        let away = vitrum::method::View::new(scene, &volume).axes.z_axis;
        let Some((place, expected)) = through(begins, &faces, ior, away) else { continue };
        // A ray within a thousandth of an edge of the block may go either way.
        if near_an_edge(begins, &faces) || near_an_edge((place, expected), &faces) {
            continue;
        }
        rays += usize::from(place != begins.0);
        if fate != status::ACTIVE && fate != status::LEFT {
            lost += 1;
            continue;
        }
        turn = larger(turn, direction.angle_between(expected));
        aside = larger(aside, (position - place).reject_from_normalized(expected).length());
    }
    (turn, aside, rays, lost)
}

/// Whether a ray passes an edge between two faces closely: by the distances between the places where it crosses their planes.
fn near_an_edge((at, direction): Ray, faces: &[(DVec3, f64)]) -> bool {
    let crossing = |&(normal, distance): &(DVec3, f64)| {
        let speed = normal.dot(direction);
        (speed.abs() > 1e-9).then(|| at + direction * ((distance - normal.dot(at)) / speed))
    };
    faces.iter().filter_map(crossing).any(|point| {
        let outside = |&(normal, distance): &(DVec3, f64)| normal.dot(point) - distance;
        let on_it = faces.iter().map(outside).fold(f64::NEG_INFINITY, f64::max) < 2e-3;
        on_it && faces.iter().filter(|face| outside(face).abs() < 2e-3).count() > 1
    })
}

fn seen_from(mut scene: Scene, azimuth: f32, elevation: f32) -> Scene {
    (scene.camera.azimuth, scene.camera.elevation) = (azimuth, elevation);
    scene
}

#[test]
fn a_block_that_fills_its_box_bends_rays_by_snells_law() {
    for mut backend in backends() {
        let (mut turn, mut aside) = (0.0, 0.0);
        for (ior, azimuth, elevation) in [
            (1.33, 0.0, 0.0),
            (1.33, 20.0, 10.0),
            (1.33, 45.0, 30.0),
            (1.5, 30.0, -20.0),
            (2.4, 15.0, 5.0),
            (0.8, 25.0, 15.0),
        ] {
            for projection in [Projection::Orthographic, Projection::Perspective] {
                let mut scene = seen_from(scene(ior, 32), azimuth, elevation);
                scene.camera.projection = projection;
                let found = errors(&scene, f64::from(ior), backend.as_mut());
                println!("{}: {ior} at {azimuth}°, {elevation}°, {projection:?}: {found:?}", backend.name());
                let (turned, by, rays, lost) = found;
                assert!(rays > 200, "{rays} rays meet the block");
                assert_eq!(lost, 0, "of {rays} rays");
                (turn, aside) = (larger(turn, turned), larger(aside, by));
            }
        }
        table::BLOCK_TURN.hold(turn, backend.as_ref());
        table::BLOCK_SIDE.hold(aside, backend.as_ref());
    }
}

#[test]
fn the_index_of_the_surroundings_counts_by_its_ratio() {
    for mut backend in backends() {
        let mut same = seen_from(scene(1.33, 16), 20.0, 10.0);
        same.surroundings.ior = 1.33;
        let (turn, aside, ..) = errors(&same, 1.0, backend.as_mut());
        assert!(turn < 1e-6 && aside < 1e-6, "a block like its surroundings bends rays by {turn}, {aside}");
        let mut embedded = seen_from(scene(1.5, 32), 30.0, -20.0);
        embedded.surroundings.ior = 1.33;
        let (turn, aside, _, lost) = errors(&embedded, 1.5 / f64::from(1.33_f32), backend.as_mut());
        assert_eq!(lost, 0);
        table::EMBEDDED_TURN.hold(turn, backend.as_ref());
        table::EMBEDDED_SIDE.hold(aside, backend.as_ref());
    }
}

#[test]
fn the_matter_around_the_eye_counts() {
    for mut backend in backends() {
        let mut scene = scene(1.33, 32);
        scene.camera.projection = Projection::Perspective;
        scene.camera.position = Some([0.1, 0.3, -0.05]);
        scene.camera.target = Some([0.2, -0.8, 0.1]);
        scene.camera.field_of_view = 60.0;
        let (turn, aside, rays, lost) = errors(&scene, f64::from(1.33_f32), backend.as_mut());
        assert_eq!((rays > 700, lost), (true, 0), "{rays} rays");
        table::EYE_TURN.hold(turn, backend.as_ref());
        table::EYE_SIDE.hold(aside, backend.as_ref());
    }
}

#[test]
fn a_cut_through_a_body_is_a_surface_of_it() {
    for mut backend in backends() {
        // A prism of 20°: sin⁻¹(1.5 sin 20°) − 20° = 10.866°.
        let mut prism = scene(1.5, 32);
        let (sin, cos) = 20.0_f32.to_radians().sin_cos();
        prism.clip = vec![cut([sin, -cos, 0.0], 0.1)];
        let volume = block();
        let frame = render(&prism, &volume, backend.as_mut());
        let (begins, (_, direction), fate) = ray_and_end(&prism, &volume, &frame, (15, 16));
        let deviation = direction.angle_between(begins.1).to_degrees();
        assert_eq!(fate, status::ACTIVE);
        assert!((deviation - 10.866).abs() < 1e-3, "{deviation}°");

        let clips: [Vec<Clip>; 2] = [
            vec![cut([sin, -cos, 0.0], 0.1)],
            vec![cut([0.5, 0.7, 0.3], 0.35), cut([-0.2, -1.0, 0.4], 0.3), cut([0.1, 0.2, -1.0], 0.2)],
        ];
        let (mut turn, mut aside) = (0.0, 0.0);
        for clip in clips {
            let mut scene = seen_from(scene(1.5, 32), 10.0, 5.0);
            scene.clip = clip;
            let found = errors(&scene, 1.5, backend.as_mut());
            println!("{} with {} cuts: {found:?}", backend.name(), scene.clip.len());
            let (turned, by, rays, lost) = found;
            assert_eq!((rays > 200, lost), (true, 0), "of {rays} rays");
            (turn, aside) = (larger(turn, turned), larger(aside, by));
        }
        table::CUT_TURN.hold(turn, backend.as_ref());
        table::CUT_SIDE.hold(aside, backend.as_ref());
    }
}

/// Irradiance on the axis behind a slab η = 1 + ε cos kx that fills its box: 1 / (cos ωσ − Z ω sin ωσ) with ω² = η₀ ε k² and σ = t / η₀ of
/// the axis.
#[test]
fn light_behind_a_slab_that_fills_its_box() -> Result<(), Failure> {
    const EPSILON: f64 = 0.3;
    const THICKNESS: f64 = 0.25;
    let k = std::f64::consts::TAU;
    let volume = cuboid([192, 16, 64], 1.0 / 64.0, |[x, _, _]| 1.0 + EPSILON * (k * x).cos());
    let axis = 1.0 + EPSILON;
    let (omega, sigma) = ((axis * EPSILON).sqrt() * k, THICKNESS / axis);
    let focus = (omega * sigma).cos() / (omega * (omega * sigma).sin());
    for mut backend in backends() {
        for (light, of_light) in
            [(Transport::Texels, table::FILLED_SLAB_TEXELS), (Transport::Forward, table::FILLED_SLAB_FORWARD)]
        {
            let mut worst = 0.0;
            for share in [0.2, 0.4] {
                let mut scene = refracting(&volume, 64);
                scene.sweep.light = light;
                scene.sweep.light_resolution = 4.0;
                // The wall's distance is from the middle of the slab.
                let wall = THICKNESS / 2.0 + share * focus;
                scene.wall = Some(Wall { distance: Some(wall as f32), azimuth: 0.0, color: [1.0; 3] });
                let assets = Assets::from(volume.clone());
                let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend.as_mut())?;
                sweep.run(backend.as_mut(), &mut |_| true)?;
                // The last plane may lie behind the wall, and a wavefront's lies right behind the slab.
                let (planes, [width, height]) = (sweep.light_planes(), sweep.light_grid.size.map(|n| n as usize));
                let behind = |plane: u32| planes.depth(plane) - planes.volume_depths[1];
                let plane = (planes.count - 1..).find(|&plane| behind(plane) >= share * focus).expect("it is not far");
                let distance = behind(plane);
                let light_on_plane = sweep.irradiance_on(plane, backend.as_mut())?;
                let row = height / 2;
                let middle = [(width - 1) / 2, width / 2].map(|x| f64::from(light_on_plane[row * width + x]));
                let expected = 1.0 / ((omega * sigma).cos() - distance * omega * (omega * sigma).sin());
                let found = 0.5 * (middle[0] + middle[1]);
                println!("{} {light:?}: {found:.4} at {distance:.4}, {expected:.4} expected", backend.name());
                worst = larger(worst, (found / expected - 1.0).abs());
            }
            of_light.hold(worst, backend.as_ref());
        }
    }
    Ok(())
}

#[test]
fn nothing_is_lost_in_a_block_seen_close_up() {
    // Faces at right angles to the view and along it, planes on the faces or not.
    for mut backend in backends() {
        for sample_distance in [0.5, 1.0, 1.3] {
            let mut scene = scene(1.6, 24);
            scene.sweep.sample_distance = sample_distance;
            scene.camera.zoom = 2.0;
            let (turn, aside, rays, lost) = errors(&scene, f64::from(1.6_f32), backend.as_mut());
            assert_eq!(lost, 0, "of {rays}");
            assert!(turn < 1e-6 && aside < 1e-6, "straight on, rays turned by {turn}, {aside}");
        }
        assert!(half().x > half().z);
    }
}
