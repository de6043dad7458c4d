//! Points around all of what a scene shows.

use crate::assets::Assets;
use crate::method::Bounds;
use crate::method::view::{point_between_voxels, vector};
use crate::scene::{Clip, Isosurface, Removes, Scene, TransferFunction};
use crate::shown::runs::{Run, part_sizes, runs};
use crate::shown::visible::{By, Visible};
use crate::subject::Subject;
use glam::DVec3;
use vitrum_io::{Mesh, Volume};

/// Visible parts smaller than this share of all that is visible are noise, which is no subject.
const SPECK: f64 = 5e-4;

/// The share of what is visible that must not be specks, for these to be left out.
const REST: f64 = 0.9;

/// The parts of a scene that points depend on.
pub(crate) type PointsKey = (TransferFunction, Vec<Isosurface>, Vec<Clip>, f32, bool);

/// The parts of `scene`.
pub(crate) fn points_key(scene: &Scene) -> PointsKey {
    let Scene { transfer, isosurface, clip, surroundings, sweep, .. } = scene;
    (transfer.clone(), isosurface.clone(), clip.clone(), surroundings.ior, sweep.refraction)
}

/// The vertices of a mesh.
fn vertices(mesh: &Mesh) -> Vec<DVec3> {
    mesh.positions.iter().map(|&position| vector(position)).collect()
}

/// Points of the world whose convex hull holds all bodies within a scene's volume.
pub(crate) fn of_bodies(assets: &Assets) -> Vec<DVec3> {
    assets.bodies.as_deref().map_or_else(Vec::new, vertices)
}

/// Points of the world whose convex hull holds all that a scene shows of its subject: corners of visible voxels, vertices of a mesh. None where nothing is
/// visible.
pub(crate) fn points(scene: &Scene, subject: &Subject) -> Vec<DVec3> {
    match subject {
        Subject::Mesh(mesh) => vertices(mesh),
        Subject::Volume(volume) => of_volume(scene, volume, By::Both),
        Subject::Volumes { shown, ior } => {
            let mut points = of_volume(scene, shown, By::Absorption);
            points.extend(of_volume(scene, ior, By::Bending));
            points
        }
    }
}

fn of_volume(scene: &Scene, volume: &Volume, by: By) -> Vec<DVec3> {
    let whole = volume;
    // Every few voxels of a volume that stays in its file.
    let volume = &volume.overview();
    let finest = volume.finest_spacing();
    let visible = Visible::new(scene, by, (volume.extent(), volume.common_range(), finest));
    let all = runs(volume, &visible);
    let sizes = part_sizes(&all, volume.dimensions);
    let length = |run: &Run| u64::from(run.end - run.start);
    let total: u64 = all.iter().map(length).sum();
    let least = (total as f64 * SPECK) as u64;
    let parts = || all.iter().zip(&sizes).filter(|(_, size)| **size > least).map(|(run, _)| run);
    let kept: u64 = parts().map(length).sum();
    let clips = Clips::new(scene, whole, volume);
    let mut points = Vec::new();
    let mut hull = |run: &Run| corners(*run, volume, &clips, &mut points);
    // Runs of a row lie within its first and its last, but where a plane cuts in between.
    let cut = !clips.0.is_empty();
    if kept as f64 >= REST * total as f64 {
        spans(parts(), cut).iter().for_each(&mut hull);
    } else {
        spans(all.iter(), cut).iter().for_each(&mut hull);
    }
    points
}

/// Each run by itself, or one for each row from its first to its last.
fn spans<'a>(runs: impl Iterator<Item = &'a Run>, each: bool) -> Vec<Run> {
    let mut spans: Vec<Run> = Vec::new();
    for &run in runs {
        match spans.last_mut() {
            Some(last) if !each && last.row == run.row => last.end = run.end,
            _ => spans.push(run),
        }
    }
    spans
}

/// Planes that remove everything, by voxel coordinates: the normal and the distance from the plane at voxel (0, 0, 0).
struct Clips(Vec<(DVec3, f64)>);

impl Clips {
    /// By the coordinates of `volume`, which is `whole` or its overview.
    fn new(scene: &Scene, whole: &Volume, volume: &Volume) -> Self {
        let corners = Bounds::from(whole).corners();
        let centre = corners.iter().sum::<DVec3>() / 8.0;
        let removing = scene.clip.iter().filter(|clip| clip.removes == Removes::Everything);
        let plane = |clip: &Clip| {
            let normal = vector(clip.normal).try_normalize()?;
            let distance = |at: DVec3| (point_between_voxels(volume, at) - centre).dot(normal) - f64::from(clip.offset);
            let start = distance(DVec3::ZERO);
            Some((DVec3::new(distance(DVec3::X), distance(DVec3::Y), distance(DVec3::Z)) - start, start))
        };
        Self(removing.filter_map(plane).collect())
    }

    /// The part of a line along x that no plane removes, from `start` to `end`.
    fn left(&self, [start, end]: [f64; 2], y: f64, z: f64) -> Option<[f64; 2]> {
        let (mut low, mut high) = (start, end);
        for &(slope, at_zero) in &self.0 {
            let rest = at_zero + slope.y * y + slope.z * z;
            if slope.x.abs() < 1e-12 {
                if rest > 0.0 {
                    return None;
                }
            } else if slope.x > 0.0 {
                high = high.min(-rest / slope.x);
            } else {
                low = low.max(-rest / slope.x);
            }
        }
        (low <= high).then_some([low, high])
    }
}

fn corners(run: Run, volume: &Volume, clips: &Clips, points: &mut Vec<DVec3>) {
    let height = volume.dimensions[1];
    let [y, z] = [run.row % height, run.row / height].map(f64::from);
    for (y, z) in [(y - 0.5, z - 0.5), (y + 0.5, z - 0.5), (y - 0.5, z + 0.5), (y + 0.5, z + 0.5)] {
        let ends = clips.left([f64::from(run.start) - 0.5, f64::from(run.end) - 0.5], y, z);
        points.extend(ends.into_iter().flatten().map(|x| point_between_voxels(volume, DVec3::new(x, y, z))));
    }
}
