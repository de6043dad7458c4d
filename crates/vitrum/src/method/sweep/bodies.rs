//! The bodies of meshes within a volume, as a volume of their own.
//!
//! Opaque bodies are the share of each voxel that they fill, with their reflectance, on a grid that may be finer than the scan's: the kernels find their surfaces
//! ([`vitrum_kernels::sweep::bodies`]). Clear bodies are the index of refraction, in the place of the scan's own.

use super::mesh_volumes::{PADDING, Shares, identity};
use crate::assets::Assets;
use crate::error::Error;
use crate::method::Tools;
use crate::method::twist::twisted;
use crate::method::voxelize::{Grid, Settings};
use crate::method::voxels::bodies::{are_opaque, bodies, clear, longest_edge};
use crate::method::voxels::looks::reflectance;
use crate::method::voxels::solids::Solids;
use crate::scene::{Material, Rgb, Scene};
use crate::shown::bends;
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use rayon::prelude::*;
use std::sync::Arc;
use vitrum_io::{Mesh, Volume, Voxels, linear_to_srgb};

/// The most voxels of opaque bodies along an edge of a voxel of the scan: viewing rays look for surfaces at as many places between two planes.
const FINEST: f64 = 4.0;
/// Width of an opaque body's edge, in its voxels, over which its share falls from 1 to 0 in a straight line. Differences over a voxel to each side of the surface, between
/// interpolated values, are within it, so that they give the normal.
const EDGE: f64 = 5.0;
/// The fewest voxels along the longest edge of the bodies.
const FEWEST: u32 = 8;

/// All that the volume of bodies depends on, besides the mesh.
#[derive(Debug, Clone, PartialEq)]
struct Kind {
    resolution: u32,
    twist: f32,
    materials: Vec<Material>,
    /// The index of refraction of the surroundings.
    around: f32,
    /// Whether the bodies are clear.
    are_clear: bool,
}

/// The volume of the bodies within a scan.
pub(super) struct BodyVolume {
    kind: Kind,
    /// The mesh that the volume was made of: while it is kept, no other takes its place.
    mesh: Arc<Mesh>,
    volume: Volume,
    /// See [`Solids::open_rows`].
    pub(super) open_rows: u64,
}

/// The scene with materials for bodies within a volume, which are opaque where nothing is said of them.
fn with_materials(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    if scene.material.is_empty() {
        scene.material.push(Material { opaque: true, ..Material::default() });
    }
    scene
}

/// Whether the bodies of a mesh within a volume are clear.
fn are_clear(mesh: &Mesh, scene: &Scene) -> Result<bool, Error> {
    let opaque = are_opaque(mesh, &scene.material)?;
    if opaque.contains(&true) && opaque.contains(&false) {
        return Err(Unrenderable::MixedBodies { name: mesh.name.clone() }.into());
    }
    Ok(!opaque.contains(&true))
}

/// Checks that a scan can have the bodies of a mesh within it.
///
/// # Errors
/// [`Unrenderable::BodiesBeside`] where there are colours of voxels or another second volume, or clear bodies in a scan that bends light itself;
/// [`Unrenderable::MixedBodies`] of opaque and clear bodies; where the voxels stay in their file.
pub(super) fn check(scene: &Scene, volumes: Volumes<'_>, assets: &Assets) -> Result<(), Error> {
    let Some(mesh) = &assets.bodies else { return Ok(()) };
    let are_clear = are_clear(mesh, &with_materials(scene))?;
    let colored = volumes.shown.colors.is_some() || !scene.transfer.gradient.is_empty();
    let beside = [
        (colored, "voxels with colours, or factors by the gradient"),
        (volumes.ior.is_some(), "a second volume that gives the index of refraction"),
        (are_clear && bends(scene), "a scan that bends light itself, as they are clear"),
    ];
    match beside.into_iter().find(|(there, _)| *there) {
        Some((_, beside)) => Err(Unrenderable::BodiesBeside { name: mesh.name.clone(), beside }.into()),
        None => Ok(volumes.shown.require_whole("a picture with bodies within the volume")?),
    }
}

impl BodyVolume {
    /// The volume of the bodies of `mesh` within the scan `shown`: `scene.voxelization.resolution` voxels along the longest edge of the mesh, or as many as the scan's
    /// voxels allow.
    ///
    /// # Errors
    /// Where there are opaque and clear bodies, or the backend fails or lacks the memory.
    pub(super) fn new(scene: &Scene, shown: &Volume, mesh: &Arc<Mesh>, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let scene = with_materials(scene);
        let kind = Kind::of(&scene, shown, mesh)?;
        let deformed = twisted(mesh, kind.twist);
        let bodies = bodies(&deformed, &scene.material)?;
        let bounds = deformed.bounds().map(|corner| corner.map(f64::from));
        drop(deformed);
        let settings = Settings { padding: PADDING, ..Settings::new(kind.resolution) };
        let grid = Grid::around_box(&mesh.name, bounds, &settings)?;
        let solids = Solids::new(&bodies, grid, tools)?;
        let volume = if kind.are_clear {
            let indices: Vec<f32> = clear(&bodies, mesh, &scene).iter().map(|body| body.ior).collect();
            Shares::new(&solids.fields, grid).mixed(&mesh.name, &indices, 1.0)?
        } else {
            let reflectances: Vec<Rgb> = bodies.iter().map(|body| reflectance(body, mesh, &scene)).collect();
            opaque(&Shares::straight(&solids.fields, grid, EDGE), &mesh.name, &reflectances)?
        };
        Ok(Self { kind, mesh: Arc::clone(mesh), volume, open_rows: solids.open_rows })
    }

    /// Whether a scene has the same bodies.
    ///
    /// # Errors
    /// Where there are opaque and clear bodies.
    pub(super) fn fits(&self, scene: &Scene, shown: &Volume, mesh: &Arc<Mesh>) -> Result<bool, Error> {
        Ok(Arc::ptr_eq(mesh, &self.mesh) && self.kind == Kind::of(&with_materials(scene), shown, mesh)?)
    }

    /// Voxels along each axis.
    pub(super) fn dimensions(&self) -> [u32; 3] {
        self.volume.dimensions
    }

    /// The volumes of a picture of the scan with the bodies in it.
    pub(super) fn volumes<'a>(&'a self, scan: Volumes<'a>) -> Volumes<'a> {
        if self.kind.are_clear {
            Volumes { ior: Some(&self.volume), ..scan }
        } else {
            Volumes { bodies: Some(&self.volume), ..scan }
        }
    }

    /// The scene that renders these volumes: where bodies are clear, the values of the second volume are indices of refraction.
    pub(super) fn scene(&self, scene: &Scene) -> Scene {
        let mut seen = scene.clone();
        if self.kind.are_clear {
            seen.transfer.ior = identity();
            // The bodies' indices are over those of the surroundings already.
            seen.surroundings.ior = 1.0;
        }
        seen
    }
}

impl Kind {
    fn of(scene: &Scene, shown: &Volume, mesh: &Mesh) -> Result<Self, Error> {
        let are_clear = are_clear(mesh, scene)?;
        let finest = if are_clear { 1.0 } else { FINEST };
        // A float that is too large, or none, becomes the nearest number.
        let most = (f64::from(longest_edge(mesh)) / f64::from(shown.finest_spacing()) * finest).ceil() as u32;
        Ok(Self {
            resolution: scene.voxelization.resolution.min(most.max(FEWEST)),
            twist: scene.mesh.first().map_or(0.0, |mesh| mesh.twist),
            materials: scene.material.clone(),
            around: scene.surroundings.ior,
            are_clear,
        })
    }
}

/// The share of each voxel that opaque bodies fill, 0 to 255, and as the colours the bodies' `reflectances` with that share in the highest byte.
fn opaque(shares: &Shares<'_>, name: &str, reflectances: &[Rgb]) -> Result<Volume, Error> {
    let word = |voxel: usize| {
        let (mut filled, mut sum) = (0.0, [0.0_f32; 3]);
        for (body, reflectance) in reflectances.iter().enumerate() {
            let share = shares.of(body, voxel);
            filled += share;
            sum = std::array::from_fn(|channel| sum[channel] + share * reflectance[channel]);
        }
        let byte = |share: f32| (share.clamp(0.0, 1.0) * 255.0 + 0.5) as u32;
        let [red, green, blue] = sum.map(|channel| byte(linear_to_srgb(channel / filled.max(1e-6))));
        red | green << 8 | blue << 16 | byte(filled) << 24
    };
    let words: Vec<u32> = (0..shares.voxels()).into_par_iter().map(word).collect();
    let filled: Vec<u8> = words.par_iter().map(|word| (word >> 24) as u8).collect();
    Ok(shares.placed(name, Voxels::from(filled))?.with_colors(words)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_voxel_has_the_reflectance_of_the_bodies_in_it_by_their_shares() {
        let grid = Grid { dimensions: [3, 1, 1], origin: [0.0; 3], voxel_size: 0.5 };
        // Two bodies that touch in the second voxel, and end in the third.
        let fields = [65535, 32768, 0, 0, 32768, 32768];
        let shares = Shares::straight(&fields, grid, EDGE);
        let volume = opaque(&shares, "two", &[[1.0, 0.0, 0.25], [0.0, 1.0, 0.25]]).unwrap();
        let words = volume.colors.as_ref().unwrap();
        assert_eq!(words[0], 0xff_00_00_ff | u32::from((linear_to_srgb(0.25) * 255.0 + 0.5) as u8) << 16);
        let [red, green, _, share] = words[1].to_le_bytes();
        assert!(red == green && share == 255 && (i32::from(red) - 188).abs() <= 1, "{red}, {green}, {share}");
        let [red, green, _, share] = words[2].to_le_bytes();
        assert!((red, green) == (0, 255) && (i32::from(share) - 128).abs() <= 1, "{red}, {green}, {share}");
    }

    #[test]
    fn bodies_within_a_volume_are_opaque_where_nothing_is_said() {
        let mesh = crate::builtin::mesh("ring").expect("it is built in");
        let found = |scene: &Scene| are_clear(&mesh, &with_materials(scene));
        assert!(!found(&Scene::default()).unwrap());
        let glass = Scene { material: vec![Material::default()], ..Scene::default() };
        assert!(found(&glass).unwrap());
    }
}
