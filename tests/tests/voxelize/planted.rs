//! Planted faults: a kernel with a mistake is caught by the comparison with another backend, and by known results.
//!
//! The stranger writes the kernels of voxelization anew, a voxel and a column at a time. Without a mistake they give the same bits.

use crate::exact::{in_voxels, near};
use crate::shapes::{cuboid, random, together};
use crate::{run, run_on};
use bytemuck::{cast_slice, from_bytes};
use vitrum::backend::Pass;
use vitrum::method::voxelize::{FillRule, Settings, Voxelization};
use vitrum_conformance::altered::AlteredCpu;
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::attributes;
use vitrum_kernels::abi::voxelize::{VoxelizeUniforms, brought};
use vitrum_kernels::field::sums::{SharedSums, Sums, add, quantise};
use vitrum_kernels::glam::Vec3;
use vitrum_kernels::kernel::{Chunk, InstructionSet, Kernel, kernels as the_tree};
use vitrum_kernels::voxelize::columns::{columns_before, cross};
use vitrum_kernels::voxelize::overlap::{Overlap, shape, shape_of};
use vitrum_kernels::voxelize::place::Place;
use vitrum_kernels::voxelize::{Item, item_of, piece_of};

/// No mistake.
const NONE: u32 = 0;
/// The last voxel of a span is left out.
const SPAN: u32 = 1;
/// Bits beyond the first word of a row go to the first.
const WORD: u32 = 2;
/// The last slice of an item is left out.
const SLICE: u32 = 3;
/// A column enters through every triangle.
const WINDING: u32 = 4;
/// A column's half voxel is left out: what it has of the voxel that it crosses a triangle in.
const PART: u32 = 5;
/// Normals are as long as the triangle is large.
const AREA: u32 = 6;
/// Carries from a sum's low word are lost.
const CARRY: u32 = 7;

/// The voxels that an item meets.
fn voxels<const SHAPE: u32>(place: &Place, item: Item, skipped: i32) -> Vec<[i32; 3]> {
    let overlap = Overlap::<SHAPE>::new(place);
    let mut found = Vec::new();
    for slice in item.first..item.end {
        let rows = overlap.rows(slice);
        for row in rows.first..=rows.last {
            let (y, z) = if place.slices_are_layers() { (row, slice) } else { (slice, row) };
            let span = overlap.voxels(y, z);
            found.extend((span.first..=span.last - skipped).map(|x| [x, y, z]));
        }
    }
    found
}

/// A piece of work: its item, where the triangle lies, and the voxels that it meets, counted from the triangle's first.
fn piece(x: u32, y: u32, u: &VoxelizeUniforms, reads: &[&[u32]], mistake: u32) -> (Item, Place, Vec<[i32; 3]>) {
    let (mut item, place) = piece_of(x, y, u, u.dispatch.mode, reads[0], reads[1]);
    item.end -= i32::from(mistake == SLICE);
    let skipped = i32::from(mistake == SPAN);
    let voxels = match shape_of(&place) {
        shape::ROW => voxels::<{ shape::ROW }>,
        shape::FLAT_X => voxels::<{ shape::FLAT_X }>,
        shape::FLAT_Y => voxels::<{ shape::FLAT_Y }>,
        shape::FLAT_Z => voxels::<{ shape::FLAT_Z }>,
        _ => voxels::<{ shape::THICK }>,
    };
    (item, place, voxels(&place, item, skipped))
}

/// The stranger's [`vitrum_kernels::voxelize::mark_surface`], a bit at a time.
fn mark_surface<const MISTAKE: u32>(_: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
    let u: &VoxelizeUniforms = from_bytes(chunk.uniforms);
    let mut mask = SharedSums(chunk.sums);
    for index in 0..chunk.rows * chunk.width {
        let (x, y) = (index % chunk.width, chunk.first_row + index / chunk.width);
        let (_, place, met) = piece(x, y, u, chunk.reads, MISTAKE);
        for [x, y, z] in met {
            let (x, line) = (place.first.x + x, (place.first.z + z) * u.size.y as i32 + place.first.y + y);
            let word = if MISTAKE == WORD { 0 } else { x / 32 };
            mask.set((line * u.row_words as i32 + word) as usize, 1 << (x % 32));
        }
    }
    true
}

/// The stranger's [`vitrum_kernels::voxelize::sum_attributes`], for triangles of one normal and one colour.
fn sum_attributes<const MISTAKE: u32>(_: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
    let u: &VoxelizeUniforms = from_bytes(chunk.uniforms);
    let (given, mask, ranks): (&[f32], _, _) = (cast_slice(chunk.reads[2]), chunk.reads[3], chunk.reads[4]);
    let mut sums = SharedSums(chunk.sums);
    for index in 0..chunk.rows * chunk.width {
        let (x, y) = (index % chunk.width, chunk.first_row + index / chunk.width);
        let (item, place, met) = piece(x, y, u, chunk.reads, MISTAKE);
        if met.is_empty() {
            continue;
        }
        let record = &given[item.triangle as usize * brought::SIZE..];
        let (a, b, c) = place.corners();
        let length = if MISTAKE == AREA { (b - a).cross(c - a).length() } else { 1.0 };
        for [x, y, z] in met {
            let (x, line) = (place.first.x + x, (place.first.z + z) * u.size.y as i32 + place.first.y + y);
            let word = (line * u.row_words as i32 + x / 32) as usize;
            let rank = ranks[word] + (mask[word] & ((1 << (x % 32)) - 1)).count_ones();
            let at = rank as usize * attributes::SIZE;
            sums.add(at + attributes::COUNT, 1);
            sums.raise(at + attributes::MATERIAL, record[brought::MATERIAL] as u32);
            for axis in 0..3 {
                let values = [
                    (attributes::NORMAL + 2 * axis, record[brought::NORMALS + axis] * length),
                    (attributes::COLOR + 2 * axis, record[brought::COLORS + axis]),
                ];
                for (component, value) in values {
                    let units = quantise(value, attributes::SCALE);
                    if MISTAKE == CARRY {
                        sums.add(at + component, units as u32);
                    } else {
                        add(&mut sums, (at + component) as i32, units);
                    }
                }
            }
        }
    }
    true
}

/// The stranger's [`vitrum_kernels::voxelize::cross_columns`].
fn cross_columns<const MISTAKE: u32>(_: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
    let u: &VoxelizeUniforms = from_bytes(chunk.uniforms);
    let corners: &[f32] = cast_slice(chunk.reads[0]);
    let (a_voxel, units) = ((1 << u.column_shift) as f32, 1 << u.column_units);
    let [nx, ny] = [u.size.x as i32, u.size.y as i32];
    let mut changes = SharedSums(chunk.sums);
    for index in 0..chunk.rows * chunk.width {
        let item = item_of(index % chunk.width, chunk.first_row + index / chunk.width, u, chunk.reads[1]);
        for line in item.first..item.end {
            let corner = |number: usize| Vec3::from_slice(&corners[item.triangle as usize * 9 + 3 * number..]);
            let across = cross(corner(0), corner(1), corner(2), (line as f32 + 0.5) / a_voxel);
            let before = |y: f32| columns_before(y, a_voxel, ny as f32 * a_voxel);
            let columns = if across.crosses { before(across.low_y)..before(across.high_y) } else { 0..0 };
            for column in columns {
                let x = across.at((column as f32 + 0.5) / a_voxel).clamp(0.0, nx as f32);
                let voxel = (x as i32).min(nx - 1);
                let part = ((x - voxel as f32) * units as f32 + 0.5).floor() as i32;
                let part = if MISTAKE == PART { 0 } else { part };
                let sign = if across.leaves && MISTAKE != WINDING { -1 } else { 1 };
                let row = ((line >> u.column_shift) - u.first_layer as i32) * ny + (column >> u.column_shift);
                let at = (row * u.row_words as i32 + voxel) as usize;
                changes.add(at, (sign * (units - part)) as u32);
                changes.add(at + 1, (sign * part) as u32);
            }
        }
    }
    true
}

/// The stranger's kernels: declared as the tree's are, with another body.
macro_rules! strangers {
    ($($name:ident = $kernel:ident, $body:ident, $mistake:ident;)*) => {
        $(static $name: Kernel = Kernel { declaration: the_tree::$kernel.declaration, run: $body::<$mistake> };)*
    };
}

strangers! {
    MARK = voxelize_mark_surface, mark_surface, NONE;
    MARK_SPAN = voxelize_mark_surface, mark_surface, SPAN;
    MARK_WORD = voxelize_mark_surface, mark_surface, WORD;
    MARK_SLICE = voxelize_mark_surface, mark_surface, SLICE;
    SUM = voxelize_sum_attributes, sum_attributes, NONE;
    SUM_AREA = voxelize_sum_attributes, sum_attributes, AREA;
    SUM_SLICE = voxelize_sum_attributes, sum_attributes, SLICE;
    SUM_CARRY = voxelize_sum_attributes, sum_attributes, CARRY;
    CROSS = voxelize_cross_columns, cross_columns, NONE;
    CROSS_WINDING = voxelize_cross_columns, cross_columns, WINDING;
    CROSS_PART = voxelize_cross_columns, cross_columns, PART;
}

/// The voxelization where `kernel` runs in the place of the tree's.
fn by_stranger(kernel: &'static Kernel, mesh: &Mesh, settings: &Settings) -> Voxelization {
    let altered = AlteredCpu::of_passes(move |list| {
        let replaced = |pass: &&mut Pass| pass.kernel.declaration.name == kernel.declaration.name;
        list.passes.iter_mut().filter(replaced).for_each(|pass| pass.kernel = kernel);
    });
    run_on(mesh, settings, &mut altered.unwrap_or_else(|error| panic!("{error}")))
}

/// Large triangles, small ones, and all kinds.
fn scenes() -> [(Mesh, Settings); 3] {
    let filled = |resolution| Settings { solid: Some(FillRule::Nonzero), ..Settings::new(resolution) };
    let everything = |resolution| Settings { attributes: true, ..filled(resolution) };
    let small = |at: u8| cuboid([f32::from(at); 3], [f32::from(at) + 0.3; 3]);
    [
        (cuboid([0.0; 3], [1.0, 0.7, 0.45]), everything(70)),
        (together(&[0, 1, 2, 3, 4].map(small)), everything(40)),
        (random(200, 8), filled(20)),
    ]
}

/// Whether surface, attributes and solid equal the results of the tree's own kernels.
fn agrees(kernel: &'static Kernel) -> [bool; 3] {
    let mut same = [true; 3];
    for (mesh, settings) in scenes() {
        let (expected, found) = (run(&mesh, &settings), by_stranger(kernel, &mesh, &settings));
        same[0] &= expected.surface == found.surface;
        same[1] &= expected.attributes == found.attributes;
        same[2] &= expected.solid == found.solid;
    }
    same
}

#[test]
fn kernels_without_a_mistake_agree() {
    for kernel in [&MARK, &SUM, &CROSS] {
        assert_eq!(agrees(kernel), [true; 3], "{}", kernel.declaration.name);
    }
}

#[test]
fn a_mistake_is_seen_in_what_the_kernel_makes() {
    for kernel in [&MARK_SPAN, &MARK_WORD, &MARK_SLICE] {
        // Attributes have a place for each voxel of the surface.
        assert_eq!(agrees(kernel), [false, false, true]);
    }
    for kernel in [&SUM_AREA, &SUM_SLICE, &SUM_CARRY] {
        assert_eq!(agrees(kernel), [true, false, true]);
    }
    for kernel in [&CROSS_WINDING, &CROSS_PART] {
        assert_eq!(agrees(kernel), [true, true, false]);
    }
}

/// Voxels that the exact test finds and that are not set.
fn missed(kernel: &'static Kernel, mesh: &Mesh, settings: &Settings) -> usize {
    let voxels = by_stranger(kernel, mesh, settings);
    let mask = voxels.surface.expect("the surface was asked for");
    let mut missed = 0;
    for triangle in &mesh.triangles {
        let corners = in_voxels(&voxels.grid, triangle.map(|vertex| mesh.positions[vertex as usize]));
        near(&voxels.grid, corners, -1e-9, |voxel, meets| missed += usize::from(meets && !mask.get(voxel)));
    }
    missed
}

#[test]
fn the_exact_test_sees_what_is_missed() {
    let (mesh, settings) = (random(40, 8), Settings::new(50));
    assert_eq!(missed(&MARK, &mesh, &settings), 0);
    for kernel in [&MARK_SPAN, &MARK_WORD, &MARK_SLICE] {
        assert!(missed(kernel, &mesh, &settings) > 100);
    }
}

/// On a box's edge two faces of one normal each; of small triangles as of large ones.
#[test]
fn closed_forms_see_wrong_sums() {
    let normals = |kernel: &'static Kernel| {
        let settings = Settings { attributes: true, ..Settings::new(9) };
        let cube = cuboid([0.0; 3], [1.0; 3]);
        let voxels = by_stranger(kernel, &cube, &settings);
        let (mask, attributes) = (voxels.surface.expect("asked for"), voxels.attributes.expect("asked for"));
        mask.spread(&attributes.normals, [0.0; 3])[(4 * 11 + 9) * 11 + 9]
    };
    assert_eq!(normals(&SUM), [1.0, 1.0, 0.0]);
    for kernel in [&SUM_AREA, &SUM_SLICE] {
        assert_ne!(normals(kernel), [1.0, 1.0, 0.0]);
    }
}

/// A box has its volume, and no row of voxels that goes through it is open.
#[test]
fn closed_forms_see_wrong_solids() {
    let settings = Settings { surface: false, solid: Some(FillRule::Nonzero), ..Settings::new(32) };
    let of = |kernel: &'static Kernel| {
        let statistics = by_stranger(kernel, &cuboid([0.0; 3], [1.0, 0.5, 0.25]), &settings).statistics;
        (statistics.volume.expect("it was filled") * 8.0, statistics.open_rows.expect("it was filled"))
    };
    let (volume, open) = of(&CROSS);
    // The box is 2⁻¹⁵ smaller than 32 voxels; across x, columns count whole.
    assert!((volume - 1.0).abs() < 1e-3 && open == 0, "{volume}, {open}");
    assert_eq!(of(&CROSS_WINDING).1, 16 * 8);
    let (volume, _) = of(&CROSS_PART);
    // A voxel of 32 is lost at one end.
    assert!((volume - 31.0 / 32.0).abs() < 1e-3, "{volume}");
}
