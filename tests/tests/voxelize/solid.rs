//! Solids: volumes against closed forms and the meshes' own, crossing and open surfaces by their rules.

use crate::run;
use crate::shapes::{ball, cuboid, mesh, reversed, together};
use vitrum::method::voxelize::{FillRule, Settings, Solid, Voxelization};
use vitrum_conformance::data::shared;
use vitrum_io::{Mesh, OpenOptions, open_mesh};

fn filled(mesh: &Mesh, resolution: u32, rule: FillRule) -> (Voxelization, Solid) {
    let mut voxels = run(mesh, &Settings { surface: false, solid: Some(rule), ..Settings::new(resolution) });
    let solid = voxels.solid.take().expect("the solid was asked for");
    (voxels, solid)
}

fn volume(mesh: &Mesh, resolution: u32, rule: FillRule) -> f64 {
    let (voxels, solid) = filled(mesh, resolution, rule);
    assert_eq!(solid.open_rows, 0, "{}", mesh.name);
    voxels.statistics.volume.expect("a solid has a volume")
}

/// Relative error that the volume of a solid may have at 128 voxels, what others reach (0.02 %).
const AT_128: f64 = 2e-4;

#[test]
fn a_box_has_its_volume_to_the_last_voxel() {
    for resolution in [7, 16, 50] {
        let (voxels, solid) = filled(&cuboid([-3.0; 3], [5.0; 3]), resolution, FillRule::Nonzero);
        let full = solid.coverage.iter().filter(|&&coverage| coverage == 255).count();
        assert_eq!(full, (resolution as usize).pow(3), "{resolution}");
        // The clearance at the border is 2⁻¹⁶ of the edge, less than half of a 255th of a voxel.
        assert_eq!(solid.coverage.iter().filter(|&&coverage| coverage != 0).count(), full);
        let volume = voxels.statistics.volume.expect("a volume");
        // The count has whole voxels, each larger than an edge's part by the clearance.
        let expected = 512.0 / (1.0 - 2.0 / 65536.0f64).powi(3);
        assert!((volume / expected - 1.0).abs() < 1e-12, "{volume} {expected}");
    }
}

#[test]
fn a_ball_has_its_meshs_volume() {
    let ball = ball(1.0, 90);
    let expected = ball.signed_volume();
    for (resolution, bound) in [(32, 1e-3), (128, AT_128), (200, 1e-4), (300, 1e-4)] {
        let found = volume(&ball, resolution, FillRule::Nonzero);
        assert!((found / expected - 1.0).abs() < bound, "{resolution}: {found} {expected}");
    }
}

#[test]
fn real_meshes_have_their_volume() {
    for name in
        ["meshes/dragon_202520.ply", "meshes/horse_96966.ply", "meshes/idgh_binary.stl", "meshes/buddha_100000.obj"]
    {
        let Some(path) = shared(name) else { continue };
        let mesh = open_mesh(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let topology = mesh.topology();
        let (voxels, solid) = filled(&mesh, 128, FillRule::Nonzero);
        let (found, expected) = (voxels.statistics.volume.expect("a volume"), mesh.signed_volume().abs());
        if topology.unpaired_edges == 0 {
            assert_eq!(solid.open_rows, 0, "{name}");
            assert!((found / expected - 1.0).abs() < AT_128, "{name}: {found} {expected}");
        }
    }
}

#[test]
fn the_direction_a_surface_faces_does_not_matter() {
    let ball = ball(1.0, 30);
    for rule in [FillRule::Nonzero, FillRule::EvenOdd] {
        assert_eq!(filled(&ball, 40, rule).1, filled(&reversed(&ball), 40, rule).1, "{rule:?}");
    }
}

#[test]
fn overlapping_bodies_are_one_or_none_by_the_rule() {
    // Two cubes of 8 that share 1, in a grid that has their faces between voxels.
    let both = together(&[cuboid([0.0; 3], [2.0; 3]), cuboid([1.0; 3], [3.0; 3])]);
    let close = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    close(volume(&both, 48, FillRule::Nonzero), 15.0);
    close(volume(&both, 48, FillRule::EvenOdd), 14.0);
    // A cube in a cube: a cavity if it faces inwards, or by the other rule.
    let (outer, inner) = (cuboid([0.0; 3], [3.0; 3]), cuboid([1.0; 3], [2.0; 3]));
    let cavity = together(&[outer.clone(), reversed(&inner)]);
    let nested = together(&[outer, inner]);
    close(volume(&cavity, 48, FillRule::Nonzero), 26.0);
    close(volume(&nested, 48, FillRule::Nonzero), 27.0);
    close(volume(&cavity, 48, FillRule::EvenOdd), 26.0);
    close(volume(&nested, 48, FillRule::EvenOdd), 26.0);
}

#[test]
fn columns_through_edges_and_corners_cross_once() {
    // An octahedron whose edges and corners lie in the columns' planes, and its copies at all shifts of a quarter of a voxel.
    let corners =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let faces = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for resolution in 3..40 {
        let octahedron = mesh(corners.to_vec(), faces.clone());
        let found = volume(&octahedron, resolution, FillRule::Nonzero);
        // Columns sample a linear height at midpoints: the error is that of its creases, of the order of a voxel's area.
        let bound = 3.0 / f64::from(resolution).powi(2);
        assert!((found * 0.75 - 1.0).abs() < bound, "{resolution}: {found}");
    }
}

#[test]
fn rows_through_a_hole_are_left_empty_and_counted() {
    // A cube without its upper x face: every column leaves through the hole.
    let mut open = cuboid([0.0; 3], [1.0; 3]);
    open.triangles.truncate(10);
    let (_, solid) = filled(&open, 16, FillRule::Nonzero);
    assert_eq!(solid.open_rows, 16 * 16);
    assert!(solid.coverage.iter().all(|&coverage| coverage == 0));
    // Without half of it: the rows of the other half are as they were, those on the diagonal are open.
    let mut half = cuboid([0.0; 3], [1.0; 3]);
    half.triangles.truncate(11);
    let (voxels, solid) = filled(&half, 16, FillRule::Nonzero);
    assert_eq!(solid.open_rows, 16 * 17 / 2);
    assert_eq!(solid.coverage.iter().filter(|&&coverage| coverage == 255).count(), 16 * 16 * 15 / 2);
    // A hole that no column goes through is none.
    let mut side = cuboid([0.0; 3], [1.0; 3]);
    side.triangles.drain(0..2);
    assert_eq!(filled(&side, 16, FillRule::Nonzero).1.open_rows, 0);
    assert!(voxels.statistics.volume.is_some());
}

#[test]
fn triangles_without_area_change_nothing() {
    let cube = cuboid([0.0; 3], [1.0; 3]);
    let mut with = cube.clone();
    with.triangles.extend([[0, 0, 7], [1, 1, 1], [0, 7, 0]]);
    assert_eq!(filled(&cube, 20, FillRule::EvenOdd).1, filled(&with, 20, FillRule::EvenOdd).1);
}
