//! The same bits from both backends, every instruction set, any number of threads and any order of the triangles.

use crate::shapes::{Random, ball, random, together};
use crate::{run, run_on};
use vitrum::backend::{Backend, CpuBackend};
use vitrum::method::voxelize::{FillRule, Settings, Voxelization};
use vitrum_conformance::{adapter, data};
use vitrum_io::{Mesh, OpenOptions, open_mesh};
use vitrum_kernels::kernel::InstructionSet;

fn everything(resolution: u32) -> Settings {
    Settings { attributes: true, solid: Some(FillRule::Nonzero), ..Settings::new(resolution) }
}

/// A mesh with all that a vertex can have.
fn colorful() -> Mesh {
    let mut mesh = together(&[ball(1.0, 24), random(400, 5)]);
    let mut random = Random(9);
    let normals = mesh.positions.iter().map(|_| {
        let normal: [f32; 3] = std::array::from_fn(|_| random.signed() as f32);
        let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
        normal.map(|x| x / length)
    });
    mesh.normals = Some(normals.collect());
    mesh.colors = Some(mesh.positions.iter().map(|_| std::array::from_fn(|_| random.unit() as f32)).collect());
    mesh.materials = vec![Default::default(); 7];
    mesh.triangle_materials = (0..mesh.triangles.len() as u32).map(|index| index % 7).collect();
    mesh
}

fn assert_same(expected: &Voxelization, found: &Voxelization, what: &str) {
    assert!(expected.surface == found.surface, "{what}: surface");
    assert!(expected.attributes == found.attributes, "{what}: attributes");
    assert!(expected.solid == found.solid, "{what}: solid");
}

fn compare(mesh: &Mesh, settings: &Settings, other: &mut dyn Backend) {
    let expected = run(mesh, settings);
    let found = run_on(mesh, settings, other);
    assert_same(&expected, &found, &format!("{} on {}", mesh.name, other.adapter()));
}

#[test]
fn the_graphics_adapter_gives_the_same_bits() {
    let Some(mut adapter) = adapter::exact_for_test() else { return };
    for rule in [FillRule::Nonzero, FillRule::EvenOdd] {
        compare(&colorful(), &Settings { solid: Some(rule), ..everything(37) }, &mut adapter);
    }
    // So large that it is filled slab by slab.
    compare(
        &ball(1.0, 24),
        &Settings { surface: false, solid: Some(FillRule::Nonzero), ..Settings::new(300) },
        &mut adapter,
    );
    compare(&random(200, 3), &Settings { overlap: 0.25, ..everything(150) }, &mut adapter);
    for (name, resolution) in
        [("meshes/teapot.obj", 60), ("meshes/horse_96966.ply", 96), ("meshes/2CylinderEngine.glb", 80)]
    {
        if let Some(path) = data::shared(name) {
            let mesh = open_mesh(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
            compare(&mesh, &everything(resolution), &mut adapter);
        }
    }
}

#[test]
fn instruction_sets_and_threads_give_the_same_bits() {
    let mesh = colorful();
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        for threads in [1, 7] {
            let mut other = CpuBackend::with_instruction_set(Some(threads), set).expect("threads can be started");
            compare(&mesh, &everything(50), &mut other);
        }
    }
}

#[test]
fn the_order_of_the_triangles_changes_no_bit() {
    let mesh = colorful();
    let expected = run(&mesh, &everything(45));
    let mut random = Random(4);
    let mut shuffled = mesh.clone();
    for index in (1..shuffled.triangles.len()).rev() {
        let other = (random.unit() * index as f64) as usize;
        shuffled.triangles.swap(index, other);
        shuffled.triangle_materials.swap(index, other);
    }
    assert_ne!(mesh.triangles, shuffled.triangles);
    assert_same(&expected, &run(&shuffled, &everything(45)), "shuffled");
    // Nor does the corner that a triangle begins with change what is met and what is inside.
    shuffled.triangles.iter_mut().for_each(|triangle| triangle.rotate_left(1));
    let turned = run(&shuffled, &Settings { attributes: false, ..everything(45) });
    assert!(turned.solid == expected.solid, "solid of turned triangles");
}
