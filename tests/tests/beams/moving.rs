//! Beams in a sea that moves: the tree of triangles that is refitted from frame to frame makes the pictures of a new one.

use super::on_both;
use std::path::Path;
use vitrum::method::{Cache, Job};
use vitrum::{Assets, MovingMeshes, Subject};
use vitrum_conformance::case::Case;
use vitrum_conformance::{Failure, frames};

/// Seconds of the frames, the first of which builds the tree.
const MOMENTS: [f32; 3] = [0.0, 0.5, 3.0];

/// A ray looks for the nearest triangle, and a tree only says in which order: boxes have a margin above what rounding can be off by, so that neither leaves
/// one out. What is left to the order are edges that a ray meets to the last bit, and chains of contacts where it grazes a surface: no ray of these pictures
/// does, so that they are the same to the bit.
#[test]
fn a_refitted_tree_makes_the_pictures_of_a_new_one() -> Result<(), Failure> {
    let settings = ["beams.rays=32", "beams.views=1"];
    on_both(|backend| {
        let mut case = Case::builtin("ocean", 32, None, &settings)?;
        let mut meshes = MovingMeshes::new("", None);
        let mut cache = Cache::default();
        for seconds in MOMENTS {
            case.scene.mesh[0].time = Some(seconds);
            case.assets.subject = Subject::Mesh(meshes.at(&case.scene.mesh)?);
            let job = Job { scene: &case.scene, assets: &case.assets, request: case.request, chosen: None };
            let refitted = vitrum::frame(&job, &mut cache, backend, &mut |_| true)?;
            case.assets = Assets::load(&case.scene, Path::new(""))?;
            let built = frames::render(&case, backend)?;
            assert!(refitted.layers == built.layers, "{} at {seconds} s: another picture", backend.name());
        }
        Ok(())
    })
}
