//! A mesh as volumes for the plane sweep: each voxel's coverage by each material, smooth across surfaces.
//!
//! A body's share of a voxel falls from 1 to 0 over [`EDGE`] voxels across its surface, by the smoothed distance, so that the index of
//! refraction has a slope that rays can follow. One body is one volume: its share is the scalar, and transfer functions say what it
//! does. Of several, the index of refraction is a volume of its own, and the scalar of the other one counts materials from the
//! clearest to the darkest: on its way across a surface it only passes materials that absorb more than one side and less than the
//! other, so that a voxel's mixture absorbs about what it should.

use crate::assets::Assets;
use crate::error::Error;
use crate::method::Tools;
use crate::method::twist::twisted;
use crate::method::view::{Bounds, fitting_distance, from_angles, up_and_front};
use crate::method::voxelize::{Grid, Settings};
use crate::method::voxels::bodies::{Body, Clear, bodies, clear, longest_edge};
use crate::method::voxels::solids::{BAND, Solids};
use crate::scene::{ColorPoint, IorPoint, MethodName, OpacityPoint, Projection, Scene, TransferFunction};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use rayon::prelude::*;
use std::sync::Arc;
use vitrum_io::{Mesh, Volume, Voxels};

/// Width of a body's edge, in voxels, over which its coverage falls from 1 to 0.
const EDGE: f64 = 3.0;
/// Empty voxels around the mesh: the reach of the edge and of gradients.
pub(super) const PADDING: u32 = 4;
/// Reference length of the transfer functions, over the mesh's longest edge.
const REFERENCE: f32 = 0.01;

/// The key of the volumes: all values that their voxels depend on.
#[derive(Debug, Clone, PartialEq)]
struct Kind {
    resolution: u32,
    twist: f32,
    /// The optical constants of the bodies if there are several; empty for one body, whose volume does not depend on them.
    materials: Vec<Clear>,
}

impl Kind {
    fn of(scene: &Scene, materials: &[Clear]) -> Self {
        let twist = scene.mesh.first().map_or(0.0, |mesh| mesh.twist);
        let materials = if materials.len() > 1 { materials.to_vec() } else { Vec::new() };
        Self { resolution: scene.voxelization.resolution, twist, materials }
    }
}

/// The bodies that volumes are made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All, as if all were clear.
    All,
    /// The clear ones.
    Clear,
}

impl Part {
    /// The bodies of a mesh.
    fn bodies(self, mesh: &Mesh, scene: &Scene) -> Result<Vec<Body>, Error> {
        let mut bodies = bodies(mesh, &scene.material)?;
        bodies.retain(|body| self == Self::All || !body.opaque);
        Ok(bodies)
    }

    /// The optical constants of the bodies of a mesh.
    fn clear(self, mesh: &Mesh, scene: &Scene) -> Result<Vec<Clear>, Error> {
        Ok(clear(&self.bodies(mesh, scene)?, mesh, scene))
    }
}

/// The box around bodies.
fn around(bodies: &[Body]) -> [[f32; 3]; 2] {
    let empty = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    bodies.iter().map(|body| body.mesh.bounds()).fold(empty, |[low, high], [first, last]| {
        let axes = |of: fn(f32, f32) -> f32, a: [f32; 3], b: [f32; 3]| std::array::from_fn(|axis| of(a[axis], b[axis]));
        [axes(f32::min, low, first), axes(f32::max, high, last)]
    })
}

/// The volumes that the sweep renders in place of a mesh.
pub(super) struct MeshVolumes {
    part: Part,
    kind: Kind,
    /// The mesh that they were made of: while it is kept, no other takes its place.
    mesh: Arc<Mesh>,
    shown: Volume,
    ior: Option<Volume>,
    /// See [`Solids::open_rows`].
    pub(super) open_rows: u64,
}

impl MeshVolumes {
    /// Turns a mesh into volumes with `scene.voxelization.resolution` voxels along its longest edge.
    ///
    /// # Errors
    /// If there are too many materials, or the backend fails or lacks the memory.
    pub(super) fn new(scene: &Scene, assets: &Assets, part: Part, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let mesh = mesh_of(assets)?;
        let materials = part.clear(mesh, scene)?;
        let kind = Kind::of(scene, &materials);
        let deformed = twisted(mesh, kind.twist);
        let bodies = part.bodies(&deformed, scene)?;
        let bounds = if part == Part::All { deformed.bounds() } else { around(&bodies) };
        drop(deformed);
        let settings = Settings { padding: PADDING, ..Settings::new(kind.resolution) };
        let grid = Grid::around_box(&mesh.name, bounds.map(|corner| corner.map(f64::from)), &settings)?;
        let solids = Solids::new(&bodies, grid, tools)?;
        let shares = Shares::new(&solids.fields, grid);
        let (shown, ior) = match &materials[..] {
            [_] => (shares.of_one(&mesh.name)?, None),
            several => {
                let numbers = numbers(several);
                let indices: Vec<f32> = several.iter().map(|material| material.ior).collect();
                (shares.mixed(&mesh.name, &numbers, 0.0)?, Some(shares.mixed(&mesh.name, &indices, 1.0)?))
            }
        };
        Ok(Self { part, kind, mesh: Arc::clone(mesh), shown, ior, open_rows: solids.open_rows })
    }

    /// The volumes.
    pub(super) fn volumes(&self) -> Volumes<'_> {
        Volumes { shown: &self.shown, ior: self.ior.as_ref(), bodies: None }
    }

    /// Whether a scene has the same volumes.
    pub(super) fn fits(&self, scene: &Scene, assets: &Assets) -> Result<bool, Error> {
        let mesh = mesh_of(assets)?;
        Ok(Arc::ptr_eq(mesh, &self.mesh) && self.kind == Kind::of(scene, &self.part.clear(mesh, scene)?))
    }

    /// The scene that renders these volumes: materials become transfer functions, and camera, ground and wall stay where the mesh alone
    /// would put them.
    ///
    /// # Errors
    /// If there are too many materials.
    pub(super) fn scene(&self, scene: &Scene, assets: &Assets) -> Result<Scene, Error> {
        let mesh = mesh_of(assets)?;
        let materials = self.part.clear(mesh, scene)?;
        let mut seen = scene.clone();
        seen.transfer = transfer(&materials, REFERENCE * longest_edge(mesh));
        // The bodies' indices are over those of the surroundings already.
        seen.surroundings.ior = 1.0;
        // The mesh's box decides what is in the picture, not that of voxels around it.
        let bounds = Bounds::from(&**mesh);
        let (centre, radius) = bounds.sphere();
        let (middle, padded) = Bounds::from(&self.shown).sphere();
        let at = centre.as_vec3().to_array();
        seen.camera.target.get_or_insert(at);
        let larger = (padded / radius) as f32;
        match scene.camera.projection {
            Projection::Orthographic => seen.camera.zoom *= larger,
            Projection::Perspective => {
                let distance = fitting_distance(scene, padded, f64::from(larger));
                seen.camera.distance.get_or_insert(distance);
            }
        }
        let (up, front) = up_and_front(&scene.camera);
        if let Some(ground) = &mut seen.ground {
            ground.height.get_or_insert(bounds.lowest(up) as f32);
        }
        if let Some(wall) = &mut seen.wall {
            // The volumes' middle is that of the mesh only where they have all of it.
            let aside = (middle - centre).dot(from_angles(up, front, wall.azimuth, 0.0));
            let distance = wall.distance.map_or(radius, f64::from);
            wall.distance = Some(if self.part == Part::All { distance } else { distance + aside } as f32);
        }
        Ok(seen)
    }
}

fn mesh_of(assets: &Assets) -> Result<&Arc<Mesh>, Error> {
    assets.subject.shared_mesh().ok_or_else(|| Unrenderable::NeedsMesh { method: MethodName::Sweep.as_str() }.into())
}

/// The scalar of each material: its rank from the clearest, above 0, to the darkest, 1; 0 is air.
fn numbers(materials: &[Clear]) -> Vec<f32> {
    let darkness = |material: &Clear| material.absorption.iter().sum::<f64>();
    let place = |material: &Clear| materials.iter().filter(|other| darkness(other) < darkness(material)).count();
    materials.iter().map(|material| (place(material) + 1) as f32 / materials.len() as f32).collect()
}

/// The index of refraction of a volume whose values are indices, over that of the surroundings.
pub(super) fn identity() -> Vec<IorPoint> {
    vec![IorPoint::new(0.04, 0.04), IorPoint::new(25.0, 25.0)]
}

/// The transfer functions over the scalar of [`MeshVolumes`]: the coverage by one body, or the number of a material and the index of
/// refraction.
fn transfer(materials: &[Clear], reference: f32) -> TransferFunction {
    let color =
        |material: &Clear| material.absorption.map(|coefficient| libm::exp(-coefficient * f64::from(reference)) as f32);
    let mut filter = vec![ColorPoint { value: 0.0, color: [1.0; 3] }];
    filter.extend(
        numbers(materials)
            .into_iter()
            .zip(materials)
            .map(|(value, material)| ColorPoint { value, color: color(material) }),
    );
    filter.sort_by(|a, b| a.value.total_cmp(&b.value));
    let ior = match materials {
        [one] => vec![IorPoint::new(0.0, 1.0), IorPoint::new(1.0, one.ior)],
        _ => identity(),
    };
    TransferFunction {
        reference_length: Some(reference),
        opacity: vec![OpacityPoint { value: 0.0, opacity: 0.0 }],
        ior,
        filter,
        ..TransferFunction::default()
    }
}

/// Coverage of each voxel by each body, 0 to 1.
pub(super) struct Shares<'a> {
    fields: &'a [u16],
    grid: Grid,
    /// The coverage for each number of a field, 0 to 1.
    of_distance: Vec<f32>,
}

impl<'a> Shares<'a> {
    /// The coverages of fields as [`Solids`] has them.
    pub(super) fn new(fields: &'a [u16], grid: Grid) -> Self {
        Self::by(fields, grid, EDGE, |t| t * t * (3.0 - 2.0 * t))
    }

    /// The coverages of fields as [`Solids`] has them, as straight lines that fall from 1 to 0 over `edge` voxels: a coverage between voxels then tells the distance.
    pub(super) fn straight(fields: &'a [u16], grid: Grid, edge: f64) -> Self {
        Self::by(fields, grid, edge, |t| t)
    }

    /// The coverages by a function of the place in an edge of `edge` voxels, 0 outside to 1 inside.
    fn by(fields: &'a [u16], grid: Grid, edge: f64, shape: impl Fn(f64) -> f64) -> Self {
        let share = |stored: u32| {
            let distance = (f64::from(stored) / 65535.0 * 2.0 - 1.0) * BAND;
            shape((distance / edge + 0.5).clamp(0.0, 1.0)) as f32
        };
        Self { fields, grid, of_distance: (0..=65535).map(share).collect() }
    }

    /// The number of voxels.
    pub(super) fn voxels(&self) -> usize {
        self.grid.dimensions.iter().map(|&count| count as usize).product()
    }

    /// The coverage of a voxel by a body.
    pub(super) fn of(&self, body: usize, voxel: usize) -> f32 {
        self.of_distance[usize::from(self.fields[body * self.voxels() + voxel])]
    }

    fn of_one(&self, name: &str) -> Result<Volume, Error> {
        let share = |stored: &u16| (self.of_distance[usize::from(*stored)] * 65535.0 + 0.5) as u16;
        let voxels: Vec<u16> = self.fields.par_iter().map(share).collect();
        Ok(self.placed(name, Voxels::from(voxels))?.with_value_mapping(1.0 / 65535.0, 0.0)?)
    }

    /// The mean of the bodies' `values`, weighted by their coverages, and of `air` for the rest; an earlier body takes its coverage
    /// before later ones.
    pub(super) fn mixed(&self, name: &str, values: &[f32], air: f32) -> Result<Volume, Error> {
        let mix = |voxel: usize| {
            let (mut left, mut sum) = (1.0_f32, 0.0);
            for (body, value) in values.iter().enumerate() {
                let share = self.of(body, voxel).min(left);
                left -= share;
                sum += share * value;
            }
            sum + left * air
        };
        let mixed: Vec<f32> = (0..self.voxels()).into_par_iter().map(mix).collect();
        self.placed(name, Voxels::from(mixed))
    }

    /// The volume of `voxels` on the grid.
    pub(super) fn placed(&self, name: &str, voxels: Voxels) -> Result<Volume, Error> {
        let Grid { dimensions, origin, voxel_size } = self.grid;
        let mut volume = Volume::new(name, dimensions, [voxel_size as f32; 3], voxels)?;
        // Where the first voxel's centre is.
        volume.origin = origin.map(|corner| (corner + 0.5 * voxel_size) as f32);
        Ok(volume)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn material(ior: f32, absorption: f64) -> Clear {
        Clear { ior, absorption: [absorption; 3] }
    }

    #[test]
    fn materials_are_counted_from_the_clearest() {
        let materials = [material(1.5, 2.0), material(1.3, 0.5), material(1.7, 2.0)];
        assert_eq!(numbers(&materials), [2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0]);
        let transfer = transfer(&materials, 0.1);
        let filter: Vec<f32> = transfer.filter.iter().map(|point| point.color[0]).collect();
        assert!(filter.windows(2).all(|pair| pair[0] >= pair[1]) && filter[0] == 1.0, "{filter:?}");
        assert!((filter[1] - libm::expf(-0.05)).abs() < 1e-6);
    }

    #[test]
    fn bodies_that_touch_leave_no_air_between() {
        let grid = Grid { dimensions: [4, 1, 1], origin: [0.0; 3], voxel_size: 0.5 };
        // The surface that both share is in the third voxel.
        let fields = [65535, 65535, 32768, 0, 0, 0, 32768, 65535];
        let shares = Shares::new(&fields, grid);
        let volume = shares.mixed("two", &[1.5, 1.3], 1.0).unwrap();
        let found: Vec<f32> = (0..4).map(|x| volume.value(x, 0, 0)).collect();
        for (found, expected) in found.iter().zip([1.5, 1.5, 1.4, 1.3]) {
            assert!((found - expected).abs() < 1e-4, "{found}, not {expected}");
        }
        assert_eq!(volume.origin, [0.25; 3]);
    }
}
