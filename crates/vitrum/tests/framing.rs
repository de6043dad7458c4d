//! A camera with `framing = "visible"` has all of what is visible in its picture, and little more.

use glam::DVec3;
use vitrum::io::{Mesh, Volume, Voxels};
use vitrum::method::{Bounds, View};
use vitrum::scene::{Camera, Clip, Framing, Ground, IorPoint, OpacityPoint, Projection, Scene, TransferFunction};
use vitrum::{Assets, framed, framed_all_round, preset};

const SIZE: u32 = 40;

/// Voxels of 200 in a box, from one corner to before the other, in nothing.
fn boxed([low, high]: [[u32; 3]; 2]) -> Volume {
    let inside = |at: [u32; 3]| (0..3).all(|axis| (low[axis]..high[axis]).contains(&at[axis]));
    let at = |index: u32| [index % SIZE, index / SIZE % SIZE, index / (SIZE * SIZE)];
    let voxels: Vec<u8> = (0..SIZE.pow(3)).map(|index| if inside(at(index)) { 200 } else { 3 }).collect();
    Volume::new("box", [SIZE; 3], [1.0, 0.5, 2.0], Voxels::from(voxels)).expect("a volume")
}

/// The corners of that box, in the world.
fn corners(volume: &Volume, [low, high]: [[u32; 3]; 2]) -> Vec<DVec3> {
    let corner = |corner: usize| {
        let along = |axis: usize| {
            let index = if corner >> axis & 1 == 1 { high[axis] } else { low[axis] };
            f64::from(volume.origin[axis]) + (f64::from(index) - 0.5) * f64::from(volume.spacing[axis])
        };
        DVec3::new(along(0), along(1), along(2))
    };
    (0..8).map(corner).collect()
}

fn scene(change: impl FnOnce(&mut Scene)) -> Scene {
    let opacity = |value, opacity| OpacityPoint { value, opacity };
    let transfer =
        TransferFunction { opacity: vec![opacity(100.0, 0.0), opacity(150.0, 1.0)], ..TransferFunction::default() };
    let mut scene =
        Scene { transfer, camera: Camera { framing: Framing::Visible, ..Camera::default() }, ..Scene::default() };
    change(&mut scene);
    scene
}

/// The greatest distances from the picture's middle, in halves of its width and height, as the picture's camera sees points.
fn spread(scene: &Scene, assets: &Assets, points: &[DVec3]) -> [f64; 2] {
    let view = View::new(scene, Bounds::from(&assets.subject));
    let place = |point: &DVec3| {
        let at = view.point(*point);
        assert!(view.orthographic || at.z > 0.0, "{point} is behind the eye");
        let depth = if view.orthographic { 1.0 } else { at.z };
        [(at.x / (depth * view.half_size[0])).abs(), (at.y / (depth * view.half_size[1])).abs()]
    };
    points.iter().map(place).fold([0.0; 2], |[x, y], [wide, high]| [f64::max(x, wide), f64::max(y, high)])
}

const VIEWS: [[f32; 3]; 6] = [
    [25.0, 15.0, 0.0],
    [0.0, 0.0, 0.0],
    [90.0, -30.0, 0.0],
    [200.0, 80.0, 0.0],
    [310.0, 5.0, 30.0],
    [45.0, 35.0, 90.0],
];

const BOXES: [[[u32; 3]; 2]; 4] =
    [[[0; 3], [SIZE; 3]], [[3, 30, 2], [9, 39, 5]], [[18, 2, 18], [22, 38, 22]], [[39, 39, 39], [40, 40, 40]]];

#[test]
fn all_of_a_box_fills_the_picture_from_every_side() {
    for ends in BOXES {
        let assets = Assets::from(boxed(ends));
        let points = corners(assets.subject.volume().expect("a volume"), ends);
        for projection in [Projection::Perspective, Projection::Orthographic] {
            for [azimuth, elevation, roll] in VIEWS {
                for (width, height) in [(64, 64), (200, 50)] {
                    let scene = scene(|scene| {
                        let camera = &mut scene.camera;
                        (camera.projection, camera.azimuth) = (projection, azimuth);
                        (camera.elevation, camera.roll) = (elevation, roll);
                        (scene.film.width, scene.film.height) = (width, height);
                    });
                    let fitted = framed(&scene, &assets).expect("there is memory");
                    let [wide, high] = spread(&fitted, &assets, &points);
                    let told = format!("{ends:?}, {projection:?}, {azimuth}, {elevation}, {width} x {height}");
                    assert!(wide < 1.0 && high < 1.0, "{told}: {wide}, {high} are cut off");
                    assert!(wide.max(high) > 0.9, "{told}: {wide}, {high} leave much room");
                    // Zoom magnifies what was found.
                    let mut near = scene.clone();
                    near.camera.zoom = 2.0;
                    let [twice, _] = spread(&framed(&near, &assets).expect("there is memory"), &assets, &points);
                    assert!((twice / wide - 2.0).abs() < 1e-4, "{told}: {twice} and {wide}");
                }
            }
        }
    }
}

#[test]
fn a_turntable_keeps_its_distance_and_cuts_nothing_off() {
    for ends in BOXES {
        let assets = Assets::from(boxed(ends));
        let points = corners(assets.subject.volume().expect("a volume"), ends);
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let fitted = framed_all_round(&scene(|scene| scene.camera.projection = projection), &assets)
                .expect("there is memory");
            let mut most = 0.0_f64;
            for side in 0..24_u8 {
                let mut turned = fitted.clone();
                turned.camera.azimuth += 15.0 * f32::from(side);
                let [wide, high] = spread(&turned, &assets, &points);
                assert!(wide < 1.0 && high < 1.0, "{ends:?}, {projection:?}, {side}: {wide}, {high}");
                most = most.max(wide).max(high);
                assert_eq!(framed(&turned, &assets).expect("there is memory").camera.distance, fitted.camera.distance);
            }
            assert!(most > 0.9, "{ends:?}, {projection:?}: {most}");
        }
    }
}

#[test]
fn what_is_not_visible_takes_no_room() {
    // A voxel is less than a two-thousandth of these.
    let ends = [[10; 3], [24; 3]];
    let assets = Assets::from(boxed(ends));
    let volume = assets.subject.volume().expect("a volume");
    let points = corners(volume, ends);
    let filled = |scene: &Scene, points: &[DVec3]| {
        let [wide, high] = spread(&framed(scene, &assets).expect("there is memory"), &assets, points);
        wide.max(high)
    };
    // A speck in a corner.
    let mut speckled = volume.clone();
    if let Voxels::U8(voxels) = &mut speckled.voxels {
        voxels.make_mut()[0] = 200;
    }
    let with_speck = framed(&scene(|_| ()), &Assets::from(speckled)).expect("there is memory");
    assert_eq!(with_speck.camera, framed(&scene(|_| ()), &assets).expect("there is memory").camera);
    // A plane that cuts a half away, which is as well told by corners.
    let clip = |offset: f32| {
        let middle = points.iter().sum::<DVec3>() / 8.0;
        scene(|scene| {
            scene.clip = vec![Clip { normal: [1.0, 0.0, 0.0], offset: middle.x as f32 + offset, ..Clip::default() }];
        })
    };
    let left: Vec<DVec3> =
        points.iter().map(|point| point.with_x(point.x.min(points.iter().sum::<DVec3>().x / 8.0))).collect();
    let share = filled(&clip(0.0), &left);
    assert!(share > 0.9 && share < 1.0, "{share}");
    // What bends light is seen without opacity; what does neither is not, and the whole grid is shown.
    let clear = |ior: f32| {
        scene(|scene| {
            scene.transfer.opacity = vec![OpacityPoint { value: 0.0, opacity: 0.0 }];
            scene.transfer.ior = vec![IorPoint::new(100.0, 1.0), IorPoint::new(150.0, ior)];
        })
    };
    assert!(filled(&clear(1.3), &points) > 0.9);
    let nothing = clear(1.0);
    assert_eq!(framed(&nothing, &assets).expect("there is memory"), nothing);
    // Whoever says where the eye is, is not asked.
    let placed = scene(|scene| scene.camera.position = Some([9.0, 9.0, 9.0]));
    assert_eq!(framed(&placed, &assets).expect("there is memory"), placed);
    let whole = Scene::default();
    assert_eq!(framed(&whole, &assets).expect("there is memory"), whole);
    // A target stays where it is.
    let aimed = framed(&scene(|scene| scene.camera.target = Some([1.0, 2.0, 3.0])), &assets).expect("there is memory");
    assert_eq!(aimed.camera.target, Some([1.0, 2.0, 3.0]));
    let [wide, high] = spread(&aimed, &assets, &points);
    assert!(wide.max(high) < 1.0 && wide.max(high) > 0.9, "{wide}, {high}");
}

#[test]
fn a_subject_stands_on_its_ground() {
    let ends = [[10; 3], [20; 3]];
    let assets = Assets::from(boxed(ends));
    let lowest =
        corners(assets.subject.volume().expect("a volume"), ends).iter().map(|point| point.z).fold(f64::MAX, f64::min);
    let height = |ground: Ground| {
        let fitted = framed(&scene(|scene| scene.ground = Some(ground)), &assets).expect("there is memory");
        fitted.ground.and_then(|ground| ground.height)
    };
    assert_eq!(height(Ground::default()), Some(lowest as f32));
    assert_eq!(height(Ground { height: Some(-3.0), ..Ground::default() }), Some(-3.0));
}

#[test]
fn meshes_and_fog_fill_the_picture() {
    let positions = vec![[0.0, 0.0, 0.0], [9.0, 0.0, 1.0], [4.0, 2.0, 0.5]];
    let points: Vec<DVec3> = positions.iter().map(|&at: &[f32; 3]| DVec3::from_array(at.map(f64::from))).collect();
    let assets = Assets::from(Mesh::new("triangle", positions, vec![[0, 1, 2]]).expect("a mesh"));
    let [wide, high] = spread(&framed(&scene(|_| ()), &assets).expect("there is memory"), &assets, &points);
    assert!(wide.max(high) < 1.0 && wide.max(high) > 0.9, "{wide}, {high}");
    // The fog of a preset has no border; its dense part is in the picture.
    let ends = [[10; 3], [20; 3]];
    let assets = Assets::from(boxed(ends));
    let volume = assets.subject.volume().expect("a volume");
    let mut hazy = scene(|_| ());
    preset::apply("haze", volume, &mut hazy).expect("a preset");
    let [wide, high] = spread(&framed(&hazy, &assets).expect("there is memory"), &assets, &corners(volume, ends));
    assert!(wide.max(high) < 1.0 && wide.max(high) > 0.9, "{wide}, {high}");
}
