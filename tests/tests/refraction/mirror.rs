//! Mirror images at the first surface: opaque bodies and receivers, at their places, with their light and shadow.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::frames;
use vitrum_conformance::refraction::{Traced, ball, case, cuboid, together, trace};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3};

const EDGE: u32 = 96;

/// The radius of an opaque ball, and where it hovers.
const RADIUS: f64 = 0.5;
const MIDDLE: DVec3 = DVec3::new(0.2, 0.3, 1.1);

/// The colour of the ball, under light from all sides of 1.
const COLOR: [f64; 3] = [0.8, 0.4, 0.2];

/// The colour of a wall behind all that.
const WALL: [f64; 3] = [0.1, 0.5, 0.7];

fn placed(mesh: &Mesh, scale: f64, by: DVec3) -> Mesh {
    let place = |at: &[f32; 3]| (DVec3::from_array(at.map(f64::from)) * scale + by).as_vec3().to_array();
    Mesh { positions: mesh.positions.iter().map(place).collect(), ..mesh.clone() }
}

/// A ball above a plate of black glass, whose upper face is at z = 0, in black surroundings.
fn scene(settings: &[&str]) -> Result<Case, Failure> {
    let plate = placed(&cuboid(DVec3::new(2.0, 2.0, 0.25), DQuat::IDENTITY), 1.0, DVec3::new(0.0, 0.0, -0.25));
    let mesh = together(&[plate, placed(&ball(96), RADIUS, MIDDLE)]);
    let usual = [
        "material=[{name=\"m0\",ior=1.5,attenuation_color=[0.001,0.001,0.001],attenuation_distance=0.01},\
         {name=\"m1\",opaque=true,color=[0.8,0.4,0.2]}]",
        "environment.kind=color",
        "environment.color=[0,0,0]",
        "camera.position=[0.5,-5,3]",
        "camera.target=[0,0,0.2]",
        "voxelization.resolution=128",
    ];
    case("mirror", mesh, EDGE, &[&usual, settings].concat())
}

/// The distance at which a ray passes the ball's middle, and whether the ray comes nearer to it.
fn passes(from: DVec3, towards: DVec3) -> (f64, bool) {
    let along = (MIDDLE - from).dot(towards);
    ((MIDDLE - from - towards * along).length(), along > 0.0)
}

/// Fresnel's share of light that meets glass of index 1.5 at an angle of this cosine.
fn reflectance(cosine: f64) -> f64 {
    let inside = (1.0 - (1.0 - cosine * cosine) / 2.25).sqrt();
    let across = (cosine - 1.5 * inside) / (cosine + 1.5 * inside);
    let along = (1.5 * cosine - inside) / (1.5 * cosine + inside);
    0.5 * (across * across + along * along)
}

/// The rays of pixels that see the plate's upper face, away from its edges and from the ball's outline: their numbers, cosines, where
/// they are mirrored, and whether that is towards the ball.
fn mirrored(rays: &[Traced]) -> Vec<(usize, f64, [DVec3; 2], bool)> {
    let seen = |(pixel, ray): (usize, &Traced)| {
        let at = ray.from - ray.towards * (ray.from.z / ray.towards.z);
        let (direct, _) = passes(ray.from, ray.towards);
        let towards = ray.towards * DVec3::new(1.0, 1.0, -1.0);
        let (passed, nearer) = passes(at, towards);
        // Eight voxels from the edge, where normals are round.
        let clear = at.x.abs().max(at.y.abs()) < 1.75 && direct > RADIUS + 0.1 && (passed - RADIUS).abs() > 0.05;
        clear.then_some((pixel, -ray.towards.z, [at, towards], passed < RADIUS && nearer))
    };
    rays.iter().enumerate().filter_map(seen).collect()
}

fn color(case: &Case, backend: &mut dyn Backend) -> Result<Vec<[f32; 3]>, Failure> {
    Ok(frames::render(case, backend)?.aov("color").expect("every frame has a colour").color())
}

/// A pixel that sees the plate sees F times the ball's colour where the mirrored ray meets the ball, else the wall's.
#[test]
fn a_ball_is_mirrored_where_its_image_is() -> Result<(), Failure> {
    // The face of voxels is not quite flat: a thousandth of a radian, over which F changes by less than that.
    const PERSPECTIVE: &str = "camera.projection=perspective";
    let exact = [("voxels.surfaces=exact", PERSPECTIVE), ("voxels.surfaces=exact", "camera.projection=orthographic")];
    let voxels = [("voxels.surfaces=multi", PERSPECTIVE), ("voxels.surfaces=two", PERSPECTIVE)];
    for (settings, of_radiance) in [(exact, table::MIRROR_EXACT), (voxels, table::MIRROR_VOXELS)] {
        on_both(|backend| {
            let mut worst = 0.0;
            for (kind, projection) in settings {
                let wall = format!("wall={{color={WALL:?},azimuth=180,distance=4}}");
                let case = scene(&[kind, projection, "light.0.intensity=0", "shading.ambient=[1,1,1]", &wall])?;
                let rays = mirrored(&trace(&case, backend)?);
                let found = color(&case, backend)?;
                let images = rays.iter().filter(|(.., met)| *met).count();
                assert!(images > 100 && rays.len() > images + 500, "{kind}: {images} of {} see the ball", rays.len());
                for &(pixel, cosine, _, met) in &rays {
                    for (found, color) in found[pixel].iter().zip(if met { COLOR } else { WALL }) {
                        worst = larger(worst, (f64::from(*found) - reflectance(cosine) * color).abs());
                    }
                }
            }
            of_radiance.hold(worst, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// Light from one side: mirror images follow Lambert's law as bodies do, on the side of the ball that shows.
#[test]
fn what_is_mirrored_has_its_light() -> Result<(), Failure> {
    let settings =
        ["light.0.attachment=world", "light.0.elevation=0", "light.0.azimuth=180", "shading.ambient=[0,0,0]"];
    let case = scene(&[&settings[..], &["voxels.surfaces=exact"]].concat())?;
    on_both(|backend| {
        let rays = mirrored(&trace(&case, backend)?);
        let found = color(&case, backend)?;
        // From behind the world's front, +y: from the camera's side.
        let light = -DVec3::Y;
        let (mut lit, mut worst) = (0, 0.0);
        for (pixel, cosine, [at, towards], _) in rays.into_iter().filter(|(.., met)| *met) {
            let along = (MIDDLE - at).dot(towards);
            let across = (MIDDLE - at - towards * along).length_squared();
            let normal = (at + towards * (along - (RADIUS * RADIUS - across).sqrt()) - MIDDLE) / RADIUS;
            let strength = normal.dot(light).max(0.0);
            // Near its terminator the ball shades itself by voxels of the shadow map.
            if strength < 0.3 {
                continue;
            }
            lit += 1;
            let expected = reflectance(cosine) * COLOR[0] * strength;
            let found = f64::from(found[pixel][0]);
            // A facet is π / 96 wide, and smooth normals are those of the ball.
            worst = larger(worst, (found / expected - 1.0).abs());
        }
        table::MIRROR_LIGHT.hold(worst, backend);
        assert!(lit > 100, "{lit}");
        Ok(())
    })
}

/// A search through the boxes of 100 000 needles that are too thin to be seen finds the ceiling behind them: it does not end before.
#[test]
fn searches_end_where_the_tree_does() -> Result<(), Failure> {
    let mut seed = 1_u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f32::from((seed >> 16) as u16) / 65536.0 * 2.0 - 1.0
    };
    let mut needles = Mesh { positions: Vec::new(), triangles: Vec::new(), normals: None, colors: None, ..ball(3) };
    for _ in 0..100_000 {
        let at = [2.0 * random(), 2.0 * random(), 1.25 + 0.5 * random()];
        let along = [0.6 * random(), 0.6 * random(), 0.6 * random()];
        let first = needles.positions.len() as u32;
        let end = [at[0] + along[0], at[1] + along[1], at[2] + along[2]];
        needles.positions.extend([at, end, [end[0] + 2.4e-7, end[1], end[2]]]);
        needles.triangles.push([first, first + 1, first + 2]);
    }
    let ceiling = placed(&cuboid(DVec3::new(40.0, 40.0, 0.1), DQuat::IDENTITY), 1.0, DVec3::new(0.0, 0.0, 4.0));
    let plate = placed(&cuboid(DVec3::new(2.0, 2.0, 0.25), DQuat::IDENTITY), 1.0, DVec3::new(0.0, 0.0, -0.25));
    let glass = "material=[{name=\"m0\",ior=1.5,attenuation_color=[0.001,0.001,0.001],attenuation_distance=0.01},\
                 {name=\"m1\",opaque=true,color=[0,0,0]},{name=\"m2\",opaque=true,color=[1,1,1]}]";
    let settings = [
        glass,
        "environment.kind=color",
        "environment.color=[0,0,0]",
        "camera.position=[0.5,-5,3]",
        "camera.target=[0,0,0.2]",
        "voxels.surfaces=exact",
        "light.0.intensity=0",
        "shading.ambient=[1,1,1]",
    ];
    let case = case("needles", together(&[plate, needles, ceiling]), 48, &settings)?;
    on_both(|backend| {
        let rays = trace(&case, backend)?;
        let found = color(&case, backend)?;
        let (mut seen, mut wrong) = (0, 0);
        for (pixel, ray) in rays.iter().enumerate() {
            let at = ray.from - ray.towards * (ray.from.z / ray.towards.z);
            if at.x.abs().max(at.y.abs()) < 1.9 {
                seen += 1;
                let expected = reflectance(-ray.towards.z);
                wrong += u32::from((f64::from(found[pixel][0]) - expected).abs() > 1e-5);
            }
        }
        // Together needles cover a thousandth of what is behind them.
        assert!(seen > 300 && wrong <= 3, "{wrong} of {seen} pixels see no ceiling");
        Ok(())
    })
}

/// Light from the camera's side: the ball's shadow on the wall is seen in the plate.
#[test]
fn shadows_are_mirrored() -> Result<(), Failure> {
    let wall = format!("wall={{color={WALL:?},azimuth=180,distance=4}}");
    let light = [
        "light.0.attachment=world",
        "light.0.elevation=0",
        "light.0.azimuth=180",
        "shading.ambient=[0,0,0]",
        "light.0.angular_radius=0",
        "voxels.caustics=false",
    ];
    let case = scene(&[&light[..], &["voxels.surfaces=exact", &wall]].concat())?;
    on_both(|backend| {
        let rays = mirrored(&trace(&case, backend)?);
        let found = color(&case, backend)?;
        let (mut lit, mut dark, mut worst) = (0, 0, 0.0);
        for (pixel, cosine, [at, towards], _) in rays.into_iter().filter(|(.., met)| !met) {
            // The wall is four units behind the middle of the plate, which is that of all.
            let seen = at + towards * ((4.0 - at.y) / towards.y);
            let off = (DVec3::new(seen.x, MIDDLE.y, seen.z) - MIDDLE).length();
            // Three voxels of the shadow map away from the shadow's edge.
            if (off - RADIUS).abs() < 0.05 {
                continue;
            }
            let expected = if off < RADIUS { 0.0 } else { reflectance(cosine) * WALL[2] };
            *if off < RADIUS { &mut dark } else { &mut lit } += 1;
            let found = f64::from(found[pixel][2]);
            worst = larger(worst, (found - expected).abs());
        }
        table::MIRROR_SHADOW.hold(worst, backend);
        assert!(lit > 300 && dark > 20, "{lit} lit and {dark} dark pixels");
        Ok(())
    })
}
