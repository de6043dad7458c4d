//! The shadow of a box on the ground and on a wall, in light from all sides: its outline by geometry, and the light beside it.

use vitrum::io::Volume;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::shot::{Cuboid, Shot, from_angles, vector};
use crate::{is_tried, on_both};

const VOXELS: u32 = 48;
const VOXEL: f64 = 2.0 / 48.0;
/// The half edges of the box: faces between voxels, no two alike.
const HALF: DVec3 = DVec3::new(6.0 * VOXEL, 4.0 * VOXEL, 5.0 * VOXEL);
const REFLECTANCE: f64 = 0.5;
/// The wall's distance from the middle of the volume.
const WALL: f64 = 1.25;

fn volume() -> Volume {
    let inside = Cuboid::around(DVec3::ZERO, HALF);
    cube(VOXELS, 2.0, |at| f64::from(u8::from(inside.contains(DVec3::from_array(at)))))
}

/// A plane that shows the shadow: a point of it, its normal, and the settings that make it.
struct Receiver {
    name: &'static str,
    point: DVec3,
    normal: DVec3,
    setting: String,
    camera: [f64; 2],
}

fn ground() -> Receiver {
    Receiver {
        name: "ground",
        point: DVec3::NEG_Z,
        normal: DVec3::Z,
        setting: format!("ground={{height=-1,color=[{REFLECTANCE},{REFLECTANCE},{REFLECTANCE}]}}"),
        camera: [20.0, 30.0],
    }
}

fn wall() -> Receiver {
    Receiver {
        name: "wall",
        point: DVec3::NEG_Y * WALL,
        normal: DVec3::Y,
        setting: format!("wall={{distance={WALL},color=[{REFLECTANCE},{REFLECTANCE},{REFLECTANCE}]}}"),
        camera: [25.0, 10.0],
    }
}

/// What a picture has of a shadow.
struct Outline {
    /// The farthest that the shadow's outline lies beside that of the box, in voxels across the light.
    beside: f64,
    /// The largest error of the light beside the shadow, relative.
    lit: f64,
    /// The most light in the shadow, relative.
    dark: f64,
    /// Pixels that see the shadow of the box.
    pixels: usize,
}

impl Receiver {
    fn meets(&self, from: DVec3, along: DVec3) -> DVec3 {
        from + along * ((self.point - from).dot(self.normal) / along.dot(self.normal))
    }

    /// The picture of the receiver in light that comes from an azimuth and an elevation; what it looks at is the shadow.
    fn shot(&self, azimuth: f64, elevation: f64) -> Result<Shot, Failure> {
        let light = -from_angles(azimuth, elevation);
        let settings = [
            self.setting.clone(),
            "transfer.opacity=[{value=0.49,opacity=0},{value=0.51,opacity=1}]".to_owned(),
            vector("light.0.direction", light),
            format!("camera.azimuth={}", self.camera[0]),
            format!("camera.elevation={}", self.camera[1]),
            vector("camera.target", self.meets(DVec3::ZERO, light)),
            "camera.zoom=2".to_owned(),
            "sweep.light_resolution=1".to_owned(),
        ];
        Shot::new(volume(), 48, &settings)
    }

    fn outline(&self, shot: &Shot, light: DVec3, red: &[f64]) -> Outline {
        let body = Cuboid::around(DVec3::ZERO, HALF);
        let expected = REFLECTANCE * -light.dot(self.normal);
        let mut outline = Outline { beside: 0.0, lit: 0.0, dark: 0.0, pixels: 0 };
        for ((from, along), red) in shot.rays().zip(red) {
            let seen = self.meets(from, along);
            if body.grown(1.5 * VOXEL).crossing(from, along).is_some() {
                continue;
            }
            let hidden = |by: f64| body.grown(by * VOXEL).crossing(seen, -light).is_some();
            let share = red / expected;
            // How far the box would have to grow or shrink for the pixel to be on the right side of its shadow.
            let (is_dark, is_hidden) = (share < 0.5, hidden(0.0));
            outline.pixels += usize::from(is_hidden);
            if is_hidden != is_dark {
                let sign = if is_dark { 1.0 } else { -1.0 };
                let steps = (1..=60).find(|step| hidden(sign * 0.1 * f64::from(*step)) == is_dark);
                outline.beside = outline.beside.max(steps.map_or(f64::INFINITY, |steps| 0.1 * f64::from(steps)));
            }
            if !hidden(2.0) {
                outline.lit = outline.lit.max((share - 1.0).abs());
            }
            if hidden(-2.0) {
                outline.dark = outline.dark.max(share.abs());
            }
        }
        outline
    }
}

/// The level of a half of a box that trilinear interpolation rounds lies up to 0.3 voxels inside its edges and corners; with what a carrier
/// needs to tell light from shadow the outline is held to half a voxel. Nothing has changed the light beside it: what an irradiance map may add
/// are roundings of sums. Two voxels inside the outline all light goes through four voxels and more of what is opaque.
fn shadows(receiver: &Receiver, azimuths: &[f64], elevations: &[f64]) -> Result<(), Failure> {
    on_both(|backend, held| {
        let (mut refused, mut worst) = (Vec::new(), [0.0f64; 3]);
        let around = |elevation| if elevation == 90.0 { &azimuths[..1] } else { azimuths };
        let lights =
            elevations.iter().flat_map(|&elevation| around(elevation).iter().map(move |&azimuth| (azimuth, elevation)));
        for (number, (azimuth, elevation)) in lights.enumerate() {
            if !is_tried(backend, number) {
                continue;
            }
            let light = -from_angles(azimuth, elevation);
            let shot = receiver.shot(azimuth, elevation)?;
            let angle = shot.angle(light);
            if !shot.takes(light) {
                refused.push(format!("({azimuth}, {elevation}) {angle:.0}°"));
                continue;
            }
            let pixels = shot.render(backend)?;
            let Outline { beside, lit, dark, pixels } = receiver.outline(&shot, light, &pixels.red);
            println!(
                "{}: {} in light from ({azimuth}, {elevation}), {angle:.0}° from the view{}: beside {beside:.1} voxels, lit {lit:.1e}, dark {dark:.1e}, {pixels} pixels",
                backend.name(),
                receiver.name,
                if angle > 85.0 { ", towards the camera" } else { "" },
            );
            assert!(pixels > 50, "{pixels} pixels see the shadow");
            worst = [worst[0].max(beside), worst[1].max(lit), worst[2].max(dark)];
        }
        println!("{} of {}: not taken: {}", backend.name(), receiver.name, refused.join(", "));
        let name = receiver.name;
        held.at_most(backend, &format!("outline of the shadow on the {name}, voxels"), worst[0], 0.5);
        held.at_most(backend, &format!("light beside the shadow on the {name}, relative"), worst[1], 1e-5);
        held.at_most(backend, &format!("light in the shadow on the {name}, relative"), worst[2], 0.01);
        Ok(())
    })
}

#[test]
fn shadows_on_the_ground_lie_where_geometry_says() -> Result<(), Failure> {
    let azimuths: Vec<f64> = (0..12).map(|step| f64::from(step) * 30.0).collect();
    shadows(&ground(), &azimuths, &[30.0, 60.0, 90.0])
}

#[test]
fn shadows_on_a_wall_lie_where_geometry_says() -> Result<(), Failure> {
    shadows(&wall(), &[-60.0, -30.0, 0.0, 30.0, 60.0], &[-60.0, -30.0, 0.0, 30.0, 60.0])
}
