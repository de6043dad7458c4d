//! Rays through voxels against rays through the same triangles.

use vitrum::backend::Backend;
use vitrum_io::{Mesh, OpenOptions, open_mesh};
use vitrum_kernels::abi::record::fate;
use vitrum_kernels::glam::{DQuat, DVec3};

use super::Section;
use super::plot::{Axis, Corner, Plot, Scale, Series};
use crate::refraction::{Traced, ball, case, cuboid, sweep, trace};
use crate::table::aligned;
use crate::{Failure, data};

/// Pixels along each side.
const EDGE: u32 = 96;
const RESOLUTIONS: [u32; 3] = [64, 128, 256];
const KINDS: [(&str, &[&str]); 5] = [
    ("multi-surface", &[]),
    ("two-surface", &["voxels.surfaces=two"]),
    ("paper's normals", &["voxels.normals=paper"]),
    ("paper's, overlapping", &["voxels.normals=paper", "voxels.overlap=0.5"]),
    (SWEEP, &[]),
];
/// The rays of a plane sweep.
const SWEEP: &str = "plane sweep";

/// The last directions of rays that met the mesh and left it.
fn directions(rays: &[Traced]) -> Vec<Option<DVec3>> {
    let met_and_left = |ray: &Traced| ray.bounces > 0 && ray.status == fate::LEFT;
    rays.iter().map(|ray| met_and_left(ray).then_some(ray.direction)).collect()
}

/// The angles between the last directions of the rays and of the exact rays, in degrees, in order. A ray that misses the mesh, or does
/// not leave it, in either is left out.
fn angles(exact: &[Option<DVec3>], found: &[Option<DVec3>]) -> Vec<f64> {
    let both = exact.iter().zip(found).filter_map(|(exact, found)| exact.zip(*found));
    let mut angles: Vec<f64> = both.map(|(exact, found)| exact.angle_between(found).to_degrees()).collect();
    angles.sort_by(f64::total_cmp);
    angles
}

/// The median, and the share within 5°.
fn summary(angles: &[f64]) -> [f64; 2] {
    let within = angles.partition_point(|&angle| angle < 5.0) as f64 / angles.len().max(1) as f64;
    [angles.get(angles.len() / 2).copied().unwrap_or_default(), within]
}

fn meshes() -> Result<Vec<(&'static str, Mesh)>, Failure> {
    let mut meshes = vec![
        ("ball", ball(256)),
        ("plate", cuboid(DVec3::new(1.0, 0.2, 0.8), DQuat::from_rotation_z(0.35) * DQuat::from_rotation_x(0.2))),
    ];
    meshes.extend(vitrum::builtin::mesh("vase").map(|mesh| ("vase", mesh)));
    if let Some(path) = data::shared("meshes/hand_closed.obj") {
        meshes.push(("hand", open_mesh(&path, &OpenOptions::default())?));
    }
    Ok(meshes)
}

/// The errors of all kinds of rays, for each mesh.
pub fn refraction(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let mut rows = Vec::new();
    let mut series = Vec::new();
    for (name, mesh) in meshes()? {
        let mut run = |kind: &str, settings: &[&str]| {
            let case = case(name, mesh.clone(), EDGE, settings)?;
            if kind == SWEEP { sweep(&case, backend) } else { Ok(directions(&trace(&case, backend)?)) }
        };
        let exact = run("exact", &["voxels.surfaces=exact"])?;
        let mut points: [Vec<(f64, f64)>; KINDS.len()] = Default::default();
        for resolution in RESOLUTIONS {
            let setting = format!("voxelization.resolution={resolution}");
            let mut cells = vec![name.to_owned(), resolution.to_string()];
            for ((kind, settings), points) in KINDS.iter().zip(&mut points) {
                let [median, within] =
                    summary(&angles(&exact, &run(kind, &[&[setting.as_str()], *settings].concat())?));
                points.push((f64::from(resolution), median));
                cells.push(format!("{median:.2}°, {:.0} %", within * 100.0));
            }
            rows.push(<[String; KINDS.len() + 2]>::try_from(cells).unwrap_or_default());
        }
        if name == "ball" {
            series.extend(KINDS.iter().zip(points).map(|((kind, _), points)| Series::new(*kind, points)));
        }
    }
    let [multi, two, paper, overlapping, swept] = KINDS.map(|(name, _)| name.to_owned());
    let header = ["mesh".to_owned(), "voxels".to_owned(), multi, two, paper, overlapping, swept];
    let text = aligned(header, rows);
    let logarithmic = |label| Axis { label, scale: Scale::Logarithmic };
    let plot = Plot {
        title: "A ball of voxels: median angle to the exact rays",
        x: logarithmic("voxels along the ball's diameter"),
        y: logarithmic("degrees"),
        series,
        legend: Corner::UpperRight,
    };
    Ok(Section { text, plot })
}
