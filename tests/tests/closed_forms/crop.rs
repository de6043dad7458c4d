//! A crop box leaves what a volume that ends there would show.

use vitrum::io::{Volume, Voxels};
use vitrum::method::sweep::Sweep;
use vitrum::scene::{BlendMode, ColorPoint, Crop, IorPoint, OpacityPoint, Projection, Scene, Transport};
use vitrum::{Assets, OutputRequest, Subject};
use vitrum_conformance::closed_forms::{cube, render, straight_on};

use crate::setup::backends;

/// Opacity behind a length of matter of one opacity, with its faces between voxels and within them.
#[test]
fn what_is_left_absorbs_by_its_length() {
    const N: u32 = 20;
    let volume = cube(N, N as f32, |_| 1.0);
    let mut scene = straight_on(5);
    scene.environment.visible = false;
    scene.transfer.opacity = vec![OpacityPoint { value: 1.0, opacity: 0.1 }];
    for mut backend in backends() {
        for [min, max] in [[0.0, 1.0], [0.25, 0.8], [0.31, 0.42], [0.0, 0.017]] {
            for (sample_distance, azimuth) in [(1.0, 0.0), (0.37, 0.0), (3.0, 40.0)] {
                scene.sweep.sample_distance = sample_distance;
                scene.camera.azimuth = azimuth;
                scene.light[0].azimuth = azimuth;
                scene.crop = Some(Crop { min: [0.0, min, 0.0], max: [1.0, max, 1.0] });
                let frame = render(&scene, &volume, backend.as_mut());
                let found = frame.channel("opacity", "Y").expect("opacity")[12];
                // The middle ray crosses the cube's middle; oblique ones leave it by the side where that is nearer.
                let (sine, cosine) = f64::from(azimuth).to_radians().sin_cos();
                let half = 0.5 * f64::from(N);
                let side = if sine > 0.0 { half / sine } else { f64::INFINITY };
                let ends = [min, max].map(|share| (f64::from(share) - 0.5) * f64::from(N) / cosine);
                let length = ends[1].min(side) - ends[0].max(-side);
                let expected = 1.0 - 0.9_f64.powf(length);
                // Optical depths are half floats.
                assert!(
                    (f64::from(found) - expected).abs() < 5e-4,
                    "{min} to {max}, planes {sample_distance}, {azimuth}°: {found}, expected {expected}"
                );
            }
        }
    }
}

const SIZE: [u32; 3] = [20, 24, 18];
const LOW: [u32; 3] = [5, 6, 3];
const HIGH: [u32; 3] = [15, 21, 14];

/// A value for a voxel, the same on both sides of the faces of the box from `LOW` to `HIGH`: interpolation and gradients there tell nothing of what was cut away. Farther
/// outside the box there is dense matter, which would throw shadows and cover the rest.
fn value(at: [u32; 3]) -> f32 {
    let beside = (0..3).all(|axis| at[axis] + 2 >= LOW[axis] && at[axis] <= HIGH[axis] + 1);
    if !beside {
        return 1.0;
    }
    let [x, y, z] = [0, 1, 2].map(|axis| f64::from(at[axis].clamp(LOW[axis], HIGH[axis] - 1)));
    (0.45 + 0.25 * (0.7 * x + 0.3 * z).sin() * (0.5 * y - 0.4 * z).cos()) as f32
}

/// The voxels from `low` to `high` of the whole volume, in their places.
fn part(low: [u32; 3], high: [u32; 3]) -> Volume {
    let (x, y, z) = (low[0]..high[0], low[1]..high[1], low[2]..high[2]);
    let all: Vec<f32> = z
        .flat_map(|z| {
            y.clone().flat_map({
                let x = x.clone();
                move |y| x.clone().map(move |x| value([x, y, z]))
            })
        })
        .collect();
    let dimensions = [0, 1, 2].map(|axis| high[axis] - low[axis]);
    let mut volume = Volume::new("part", dimensions, [1.0; 3], Voxels::F32(all.into())).expect("finite numbers");
    volume.origin = low.map(|start| start as f32);
    volume
}

fn scene(change: impl Fn(&mut Scene)) -> Scene {
    let mut scene = Scene::default();
    scene.camera.target = Some([9.5, 13.0, 8.0]);
    scene.camera.position = Some([35.0, -28.0, 30.0]);
    scene.transfer.opacity = vec![OpacityPoint { value: 0.3, opacity: 0.0 }, OpacityPoint { value: 1.0, opacity: 0.5 }];
    scene.transfer.color =
        vec![ColorPoint { value: 0.2, color: [0.9, 0.5, 0.2] }, ColorPoint { value: 0.7, color: [0.2, 0.5, 0.9] }];
    (scene.film.width, scene.film.height) = (48, 48);
    change(&mut scene);
    scene
}

/// The picture of a cropped volume is that of a smaller one. Both have the same planes and cells of light, but other coordinates, whose rounding is
/// some 1e-6 of a voxel; where light bends, it grows on the way.
#[test]
fn a_cropped_volume_looks_like_a_smaller_one() {
    let (whole, smaller) = (part([0; 3], SIZE), part(LOW, HIGH));
    let share = |face: [u32; 3]| [0, 1, 2].map(|axis| face[axis] as f32 / SIZE[axis] as f32);
    let crop = Some(Crop { min: share(LOW), max: share(HIGH) });
    let bends = |scene: &mut Scene| scene.transfer.ior = vec![IorPoint::new(0.2, 1.1), IorPoint::new(0.7, 1.3)];
    let scenes: [(&str, Scene, f64); 6] = [
        ("light that bends", scene(bends), 1e-4),
        ("light carried forward", scene(|_| {}), 1e-5),
        (
            "light on texels",
            scene(|scene| {
                scene.sweep.light = Transport::Texels;
                (scene.light[0].azimuth, scene.light[0].elevation) = (-10.0, 20.0);
            }),
            1e-6,
        ),
        ("without shadows", scene(|scene| scene.light[0].shadows = false), 1e-6),
        (
            "parallel",
            scene(|scene| {
                scene.camera.projection = Projection::Orthographic;
                scene.light[0].angular_radius = 6.0;
            }),
            1e-5,
        ),
        (
            "bent",
            scene(|scene| {
                bends(scene);
                scene.light[0].shadows = false;
            }),
            1e-5,
        ),
    ];
    for mut backend in backends() {
        for (label, scene, bound) in &scenes {
            let mut cropped = scene.clone();
            cropped.crop.clone_from(&crop);
            let mut expected = scene.clone();
            // The whole volume's sphere is larger, by which a parallel view is fitted.
            if scene.camera.projection == Projection::Orthographic {
                let radius = |size: [u32; 3]| size.map(|n| f64::from(n).powi(2)).iter().sum::<f64>().sqrt();
                expected.camera.zoom = (radius([0, 1, 2].map(|axis| HIGH[axis] - LOW[axis])) / radius(SIZE)) as f32;
            }
            let found = render(&cropped, &whole, backend.as_mut());
            let expected = render(&expected, &smaller, backend.as_mut());
            let (mut worst, mut sum, mut shown) = (0.0_f64, 0.0, 0);
            for name in ["R", "G", "B"] {
                let [a, b] = [&found, &expected].map(|frame| frame.channel("color", name).expect("colour"));
                for (a, b) in a.iter().zip(b) {
                    worst = worst.max(f64::from((a - b).abs()));
                    sum += f64::from((a - b).abs());
                    shown += 1;
                }
            }
            let opaque =
                found.channel("opacity", "Y").expect("opacity").iter().filter(|&&opacity| opacity > 0.1).count();
            println!(
                "{label}: the largest difference {worst:.2e}, mean {:.2e}; {opaque} pixels",
                sum / f64::from(shown)
            );
            assert!(opaque > 200 && worst < *bound, "{label}: {worst}");
        }
    }
}

/// Voxels in pages come and go with the planes, also those on faces within the volume, to which look-ups beside them go.
#[test]
fn streamed_volumes_are_cropped_and_projected_alike() {
    const PAGES: u32 = 70;
    let wave = |at: [f64; 3]| 0.5 + 0.3 * (0.31 * at[0] + 0.2 * at[1]).sin() * (0.4 * at[2] - 0.1 * at[0]).cos();
    let assets = Assets::from(Subject::Volume(cube(PAGES, PAGES as f32, wave).into()));
    let view = |blend_mode: BlendMode| {
        scene(|scene| {
            (scene.camera.target, scene.camera.position) = (None, None);
            scene.shading.blend_mode = blend_mode;
            scene.crop = Some(Crop { min: [0.2, 0.31, 0.0], max: [0.71, 0.9, 0.66] });
        })
    };
    let scenes = [BlendMode::Composite, BlendMode::Maximum, BlendMode::Minimum, BlendMode::Mean].map(view);
    for mut backend in backends() {
        for scene in &scenes {
            let [held, streamed] = [Sweep::prepare, Sweep::prepare_streamed].map(|prepare| {
                let sweep = prepare(
                    scene,
                    &assets,
                    OutputRequest { light: false, ..OutputRequest::default() },
                    backend.as_mut(),
                )
                .expect("it renders");
                sweep.run(backend.as_mut(), &mut |_| true).expect("it runs");
                sweep.film(backend.as_mut()).expect("it is there")
            });
            assert!(held == streamed, "{:?}", scene.shading.blend_mode);
        }
    }
}
