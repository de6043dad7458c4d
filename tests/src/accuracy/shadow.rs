//! The shadow of the tree on the ground against what an exact caster of rays finds.

use vitrum::backend::Backend;
use vitrum::method::Tools;
use vitrum::method::voxelize::{Settings, voxelize};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DVec2, DVec3};

use super::Section;
use super::plot::{Axis, Corner, Plot, Scale, Series};
use crate::Failure;
use crate::case::Case;
use crate::shadow::{Caster, Map};
use crate::table::aligned;

const RESOLUTIONS: [u32; 5] = [32, 64, 128, 256, 512];
/// Points along each side of the ground, and of a patch.
const POINTS: usize = 384;
const PATCH: usize = 16;
const KINDS: [&str; 3] = ["counted", "voxels touched", "uniform"];

/// Light at the points.
struct Ground {
    points: Vec<DVec3>,
    exact: Vec<f64>,
}

/// Mean, root of the mean square of points' differences, and of patches'.
fn errors(exact: &[f64], found: &[f64]) -> [f64; 3] {
    let differences: Vec<f64> = exact.iter().zip(found).map(|(exact, found)| found - exact).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let root = |values: &[f64]| mean(&values.iter().map(|value| value * value).collect::<Vec<_>>()).sqrt();
    let patch = |first: usize| {
        let rows = (0..PATCH).map(|row| mean(&differences[first + row * POINTS..][..PATCH]));
        mean(&rows.collect::<Vec<_>>())
    };
    let corners = (0..POINTS).step_by(PATCH).flat_map(|y| (0..POINTS).step_by(PATCH).map(move |x| y * POINTS + x));
    let patches: Vec<f64> = corners.map(patch).collect();
    [mean(&differences), root(&differences), root(&patches)]
}

impl Ground {
    /// Where light along `direction` is less than all, behind the mesh on its lowest plane.
    fn new(mesh: &Mesh, direction: DVec3, depth: impl Fn(usize) -> f64) -> Self {
        let [low, high] = mesh.bounds().map(|corner| DVec3::from_array(corner.map(f64::from)));
        let shadow = |corner: DVec3| (corner + direction * ((low.z - corner.z) / direction.z)).truncate();
        let corner = |bits: usize| {
            let pick = |axis: usize| if bits >> axis & 1 == 0 { low[axis] } else { high[axis] };
            shadow(DVec3::new(pick(0), pick(1), pick(2)))
        };
        let first = (0..8).map(corner).fold(DVec2::INFINITY, DVec2::min);
        let size = (0..8).map(corner).fold(DVec2::NEG_INFINITY, DVec2::max) - first;
        let caster = Caster::new(mesh, direction, depth);
        let place = |index: usize| (index as f64 + 0.5) / POINTS as f64;
        let points: Vec<DVec3> = (0..POINTS * POINTS)
            .map(|index| first + size * DVec2::new(place(index % POINTS), place(index / POINTS)))
            .map(|point| point.extend(low.z - 1e-3))
            .collect();
        let exact = points.iter().map(|point| (-caster.depth(*point)).exp()).collect();
        Self { points, exact }
    }
}

/// Light behind all voxels that triangles touch, each of them counted, in a grid along the light with voxels of the edge `edge`.
fn touched(
    mesh: &Mesh,
    direction: DVec3,
    depths: &[f64],
    edge: f64,
    points: &[DVec3],
    backend: &mut dyn Backend,
) -> Result<Vec<f64>, Failure> {
    let across = direction.any_orthonormal_vector();
    let axes = [direction, across, direction.cross(across)];
    let turned = |at: DVec3| DVec3::from_array(axes.map(|axis| at.dot(axis)));
    let mut sums = vec![0.0; points.len()];
    for (number, depth) in (0..).zip(depths) {
        let triangles = mesh.triangles.iter().zip(&mesh.triangle_materials);
        let mut part = Mesh {
            triangles: triangles.filter(|(_, material)| **material == number).map(|(triangle, _)| *triangle).collect(),
            colors: None,
            materials: Vec::new(),
            triangle_materials: Vec::new(),
            ..mesh.clone()
        };
        let first = part.triangles[0][0] as usize;
        let mut is_used = vec![false; mesh.positions.len()];
        part.triangles.as_flattened().iter().for_each(|&vertex| is_used[vertex as usize] = true);
        // Vertices of the other material are put where they do no harm to the bounds.
        let place = |(vertex, used): (usize, &bool)| mesh.positions[if *used { vertex } else { first }].map(f64::from);
        let places = is_used.iter().enumerate().map(place);
        part.positions = places.map(|at| turned(DVec3::from_array(at)).as_vec3().to_array()).collect();
        let [low, high] = part.bounds();
        let longest = (0..3).map(|axis| f64::from(high[axis] - low[axis])).fold(0.0, f64::max);
        let settings = Settings { attributes: true, ..Settings::new((longest / edge).round().max(1.0) as u32) };
        let mut tools = Tools { backend: &mut *backend, progress: &mut |_| true };
        let voxels = voxelize(&part, &settings, &mut tools)?;
        let (surface, attributes) =
            (voxels.surface.expect("it was wanted"), voxels.attributes.expect("they were wanted"));
        let counts = surface.spread(&attributes.counts, 0);
        let [nx, ny, nz] = voxels.grid.dimensions.map(|count| count as usize);
        let columns: Vec<u32> = counts.chunks_exact(nx).map(|row| row.iter().sum()).collect();
        for (sum, point) in sums.iter_mut().zip(points) {
            let at = (turned(*point) - DVec3::from_array(voxels.grid.origin)) / voxels.grid.voxel_size;
            if at.y >= 0.0 && at.z >= 0.0 && at.y < ny as f64 && at.z < nz as f64 {
                *sum += f64::from(columns[at.z as usize * ny + at.y as usize]) * depth;
            }
        }
    }
    Ok(sums.iter().map(|sum| f64::exp(-sum)).collect())
}

/// The tree's shadow at several resolutions.
pub fn shadow(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let with = |scene: &str, resolution: u32| {
        let case = Case::builtin(scene, 8, None, &[&format!("shadow.resolution={resolution}")])?;
        Ok::<_, Failure>(case)
    };
    let tree = with("tree", RESOLUTIONS[0])?;
    let missing = || Failure::Setup("the scene `tree` shows no mesh".to_owned());
    let mesh = tree.assets.subject.mesh().ok_or_else(missing)?;
    let named = |name: &str| tree.scene.material.iter().find(|material| material.name.as_deref() == Some(name));
    let depths: Vec<f64> = mesh
        .materials
        .iter()
        .map(|material| {
            named(&material.name).map_or(0.0, |listed| f64::from(listed.density * tree.scene.shadow.optical_depth))
        })
        .collect();
    let direction = Map::of(&tree, backend)?.light();
    let ground = Ground::new(mesh, direction, |index| depths[mesh.triangle_materials[index] as usize]);
    let mut rows = Vec::new();
    let mut points: [Vec<(f64, f64)>; KINDS.len()] = Default::default();
    for resolution in RESOLUTIONS {
        let lit = |map: &Map| -> Vec<f64> { ground.points.iter().map(|point| map.at(*point)[0]).collect() };
        let counted = Map::of(&with("tree", resolution)?, backend)?;
        let uniform = Map::of(&with("tree/uniform", resolution)?, backend)?;
        let touched = touched(mesh, direction, &depths, counted.edge(), &ground.points, backend)?;
        let mut cells = vec![resolution.to_string()];
        for (found, points) in [lit(&counted), touched, lit(&uniform)].iter().zip(&mut points) {
            let [mean, root, patches] = errors(&ground.exact, found);
            cells.push(format!("{:+.2} %, {root:.3}, {patches:.3}", mean * 100.0));
            points.push((f64::from(resolution), patches));
        }
        rows.push(<[String; 4]>::try_from(cells).unwrap_or_default());
    }
    let [counted, touched, uniform] = KINDS.map(str::to_owned);
    let text = aligned(["voxels".to_owned(), counted, touched, uniform], rows);
    let logarithmic = |label| Axis { label, scale: Scale::Logarithmic };
    let plot = Plot {
        title: "A tree's shadow on the ground: rms error of patches",
        x: logarithmic("voxels along the longest edge"),
        y: logarithmic("light, of 1"),
        series: KINDS.iter().zip(points).map(|(kind, points)| Series::new(*kind, points)).collect(),
        legend: Corner::UpperRight,
    };
    Ok(Section { text, plot })
}
