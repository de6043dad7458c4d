//! Surface voxelization: no voxel is missed, none is set far away, and attributes are the triangles'.

use crate::exact::{in_voxels, meets, near};
use crate::shapes::{ball, cuboid, mesh, random};
use crate::{cpu, run, try_on};
use vitrum::method::voxelize::Settings;
use vitrum_conformance::data::shared;
use vitrum_io::{Mesh, OpenOptions, open_mesh};
use vitrum_kernels::glam::DVec3;

/// Largest distance of a marked voxel from a triangle: four times the margin of a triangle as long as the grid. The margin is 2⁻¹⁹ of
/// the extent, and half a unit of its corners, 2⁻²² of the next power of two.
fn tolerance(dimensions: [u32; 3]) -> f64 {
    4.0 * f64::from(dimensions.into_iter().max().unwrap_or(0) + 4) * (1.0 / 524_288.0 + 1.0 / 2_097_152.0)
}

/// Compares with the exact test at every voxel of the grid.
fn compare(mesh: &Mesh, settings: &Settings) -> u64 {
    let voxels = run(mesh, settings);
    let (grid, mask) = (voxels.grid, voxels.surface.expect("the surface was asked for"));
    let [nx, ny, nz] = grid.dimensions;
    let count = nx as usize * ny as usize * nz as usize;
    let index = |[x, y, z]: [u32; 3]| (z as usize * ny as usize + y as usize) * nx as usize + x as usize;
    let (mut needed, mut allowed) = (vec![false; count], vec![false; count]);
    let overlap = f64::from(settings.overlap);
    for triangle in &mesh.triangles {
        let corners = in_voxels(&grid, triangle.map(|vertex| mesh.positions[vertex as usize]));
        // Float64 may take boxes that touch for apart or not: those a hair smaller are certain.
        near(&grid, corners, overlap - 1e-9, |voxel, meets| needed[index(voxel)] |= meets);
        near(&grid, corners, overlap + tolerance(grid.dimensions), |voxel, meets| allowed[index(voxel)] |= meets);
    }
    let dense = mask.dense(1, 0);
    let missed = (0..count).filter(|&at| needed[at] && dense[at] == 0).count();
    let spurious = (0..count).filter(|&at| !allowed[at] && dense[at] == 1).count();
    assert_eq!((missed, spurious), (0, 0), "{}: voxels missed, voxels set for nothing", mesh.name);
    assert_eq!(mask.count(), dense.iter().map(|&set| u64::from(set)).sum::<u64>());
    mask.count()
}

#[test]
fn the_exact_test_knows_touching_from_apart() {
    let triangle = [DVec3::new(0.5, -9.0, 0.0), DVec3::new(0.5, 9.0, 5.0), DVec3::new(0.5, 9.0, -5.0)];
    assert!(meets(DVec3::ZERO, 0.5, triangle));
    assert!(!meets(DVec3::ZERO, 0.499, triangle));
    // The corner (½, ½, ½) of the box, and a plane across the diagonal.
    for (distance, expected) in [(1.49, true), (1.51, false)] {
        let triangle = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * distance);
        assert_eq!(meets(DVec3::ZERO, 0.5, triangle), expected, "{distance}");
    }
}

#[test]
fn no_voxel_of_random_triangles_is_missed() {
    for (seed, resolution) in [(1, 5), (2, 16), (3, 33), (4, 64), (5, 97)] {
        for single in 0..12 {
            // Few at a time, so that voxels stay empty that could be set for nothing.
            let set = compare(&random(16, seed * 1000 + single), &Settings::new(resolution));
            assert!(set > 0);
        }
    }
}

#[test]
fn no_voxel_of_single_triangles_is_missed() {
    for seed in 1..400 {
        let whole = random(8, seed);
        let kind = (seed % 9) as usize;
        let single = mesh(whole.positions.clone(), vec![whole.triangles[kind]]);
        // Points and triangles of one: there is no grid around them.
        if try_on(&single, &Settings::new(40), &mut cpu(), true).is_ok() {
            compare(&single, &Settings { padding: 2, ..Settings::new(40) });
        }
    }
}

#[test]
fn overlapping_voxels_reach_as_far_as_is_said() {
    for overlap in [0.125, 0.5, 1.0] {
        compare(&random(6, 77), &Settings { overlap, padding: 2, ..Settings::new(24) });
    }
}

#[test]
fn no_voxel_of_real_meshes_is_missed() {
    for (name, resolution) in [
        ("meshes/teapot.obj", 40),
        ("meshes/footbones_ascii.ply", 48),
        ("meshes/slotted_disk_ascii.stl", 64),
        ("meshes/hand_closed.obj", 32),
        ("meshes/tree.obj", 32),
    ] {
        if let Some(path) = shared(name) {
            let mesh = open_mesh(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
            compare(&mesh, &Settings::new(resolution));
        }
    }
}

#[test]
fn a_box_along_the_axes_has_the_shell_of_its_voxels() {
    for resolution in [4, 10, 31, 64] {
        let cube = run(&cuboid([3.0; 3], [4.0; 3]), &Settings::new(resolution));
        let n = u64::from(resolution);
        assert_eq!(cube.statistics.surface_voxels, Some(n.pow(3) - (n - 2).pow(3)), "{resolution}");
        assert_eq!(cube.grid.dimensions, [resolution + 2; 3]);
    }
}

#[test]
fn the_voxels_of_a_plane_are_its_area_over_that_of_a_face() {
    // A rectangle through the middle of voxels meets one layer; across the diagonal of two axes a row of voxels meets it in one
    // voxel, or two where it passes a corner: ball and plane alike have 3/2 of the area's faces on average (Cauchy).
    let flat = mesh(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.5, 0.0], [0.0, 0.5, 0.0]], vec![[0, 1, 2], [0, 2, 3]]);
    assert_eq!(run(&flat, &Settings::new(100)).statistics.surface_voxels, Some(100 * 50));
    // A sphere: the mean over directions of |n|₁ is 3/2 faces met per face's area, each voxel having about as many.
    let radius = 1.0;
    let sphere = run(&ball(radius, 200), &Settings::new(128));
    let area = 4.0 * std::f64::consts::PI * (radius / sphere.grid.voxel_size).powi(2);
    let ratio = sphere.statistics.surface_voxels.unwrap_or(0) as f64 / area;
    // A plane n meets |nx| + |ny| + |nz| voxels for an area of 1: the thickness of a voxel along n. Its mean is 3/2; curvature adds
    // about one voxel in 128.
    assert!((ratio - 1.5).abs() < 0.01, "{ratio}");
}

#[test]
fn attributes_are_those_of_the_triangles() {
    let mut cube = cuboid([0.0; 3], [1.0; 3]);
    cube.colors = Some((0..8).map(|_| [0.25, 0.5, 1.0, 1.0]).collect());
    let voxels = run(&cube, &Settings { attributes: true, ..Settings::new(9) });
    let (mask, attributes) = (voxels.surface.expect("asked for"), voxels.attributes.expect("asked for"));
    let counts = mask.spread(&attributes.counts, 0);
    let normals = mask.spread(&attributes.normals, [0.0; 3]);
    let colors = mask.spread(&attributes.colors, [0.0; 3]);
    let at = |x: usize, y: usize, z: usize| (z * 11 + y) * 11 + x;
    // The middle of a face off its diagonal: one triangle, its normal, its colour.
    let middle = at(9, 3, 6);
    assert_eq!((counts[middle], colors[middle]), (1, [0.25, 0.5, 1.0]));
    assert_eq!(normals[middle], [1.0, 0.0, 0.0]);
    // On an edge two faces.
    let edge = at(9, 9, 4);
    assert_eq!((counts[edge], normals[edge]), (2, [1.0, 1.0, 0.0]));
    assert_eq!(counts[at(5, 5, 5)], 0);
    assert!(attributes.materials.iter().all(Option::is_none));
    // As many as a brute-force count gives.
    let mut expected = vec![0; 11 * 11 * 11];
    for triangle in &cube.triangles {
        let corners = in_voxels(&voxels.grid, triangle.map(|vertex| cube.positions[vertex as usize]));
        near(&voxels.grid, corners, 1e-4, |[x, y, z], meets| {
            expected[at(x as usize, y as usize, z as usize)] += u32::from(meets);
        });
    }
    assert_eq!(counts, expected);
}

#[test]
fn normals_of_vertices_are_interpolated_and_the_largest_material_stays() {
    let mut sphere = ball(1.0, 40);
    sphere.normals = Some(sphere.positions.clone());
    sphere.materials = vec![Default::default(); 3];
    sphere.triangle_materials = (0..sphere.triangles.len()).map(|index| index as u32 % 3).collect();
    sphere.materials[2].base_color = Some([0.0, 1.0, 0.0]);
    let voxels = run(&sphere, &Settings { attributes: true, ..Settings::new(16) });
    let (mask, attributes) = (voxels.surface.expect("asked for"), voxels.attributes.expect("asked for"));
    let materials = mask.spread(&attributes.materials, None);
    let normals = mask.spread(&attributes.normals, [0.0; 3]);
    let [nx, ny, nz] = voxels.grid.dimensions;
    for (at, normal) in normals.iter().enumerate().filter(|(at, _)| materials[*at].is_some()) {
        let (x, y, z) = (at as u32 % nx, at as u32 / nx % ny, at as u32 / nx / ny);
        assert!(z < nz);
        let centre = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + 0.5;
        let outwards = (centre - DVec3::new(f64::from(nx), f64::from(ny), f64::from(nz)) * 0.5).normalize();
        let found = DVec3::from_array(normal.map(f64::from)).normalize();
        // A voxel's diagonal is 1.7 of 8 voxels of radius, and triangles reach a quarter of a voxel farther.
        assert!(found.dot(outwards) > 0.97, "{found} {outwards}");
    }
    // A third of the triangles are of each; few voxels meet one triangle alone.
    assert!(
        attributes.materials.iter().filter(|&&material| material == Some(2)).count() * 2 > attributes.materials.len()
    );
}

#[test]
fn what_is_no_grid_is_refused() {
    let point = mesh(vec![[1.0; 3]; 3], vec![[0, 1, 2]]);
    let flat = cuboid([0.0; 3], [1.0, 1.0, 0.0]);
    assert!(run(&flat, &Settings::new(8)).grid.dimensions == [10, 10, 3]);
    for (mesh, settings, words) in [
        (&point, Settings::new(8), "one point"),
        (&flat, Settings::new(0), "0 voxels"),
        (&flat, Settings::new(1 << 20), "1 to 8192"),
        (&flat, Settings { padding: u32::MAX, ..Settings::new(8) }, "at most 1024"),
        (&flat, Settings { overlap: f32::NAN, ..Settings::new(8) }, "expected 0 to 1"),
    ] {
        let error = try_on(mesh, &settings, &mut cpu(), true).expect_err(words).to_string();
        assert!(error.contains(words), "{error}");
    }
    // Not a number never gets here.
    assert!(Mesh::new("nan", vec![[f32::NAN; 3]; 3], vec![[0, 1, 2]]).is_err());
    // Cancelled before anything is done.
    let cancelled = try_on(&flat, &Settings::new(8), &mut cpu(), false).expect_err("cancelled");
    assert!(cancelled.is_cancelled());
}
