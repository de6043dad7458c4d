//! The committed modules belong to the tree, and lays structs out as the host does.

use std::collections::HashMap;
use std::mem::{offset_of, size_of_val};

use rspirv::dr::{Instruction, Module, Operand, load_words};
use rspirv::spirv::{Decoration, Op, Word};
use vitrum_conformance::root;
use vitrum_kernels::abi::grid::Grid;
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::shadow::ShadowUniforms;
use vitrum_kernels::abi::sweep::SweepUniforms;
use vitrum_kernels::abi::voxelize::VoxelizeUniforms;
use vitrum_kernels::abi::voxels::VoxelsUniforms;
use vitrum_kernels::kernel::ALL;
use vitrum_shader_manifest::Manifest;

#[test]
fn the_committed_modules_are_current() {
    let manifest = Manifest::read(&root()).unwrap_or_else(|error| panic!("{error}"));
    let stale = manifest.stale(&root()).unwrap_or_else(|error| panic!("{error}"));
    assert!(stale.is_empty(), "run `cargo xtask shaders`:\n{}", stale.join("\n"));
    let mut kernels: Vec<&str> = ALL.iter().map(|kernel| kernel.declaration.name).collect();
    kernels.sort_unstable();
    assert_eq!(manifest.modules.keys().map(String::as_str).collect::<Vec<_>>(), kernels);
    assert_eq!(vitrum_shaders::NAMES, kernels);
}

/// A field of a struct.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Field {
    name: &'static str,
    offset: usize,
    size: usize,
}

/// All fields of a struct; one that is left out does not compile.
macro_rules! fields {
    ($struct:ident { $($field:ident),* $(,)? }) => {{
        let $struct { $($field),* } = $struct::default();
        vec![$(Field {
            name: stringify!($field),
            offset: offset_of!($struct, $field),
            size: size_of_val(&$field),
        }),*]
    }};
}

fn grid() -> Vec<Field> {
    fields!(Grid { row_x, row_y, row_z, size, value, pitch, bricks, pages })
}

#[rustfmt::skip]
fn sweep_uniforms() -> Vec<Field> {
    fields!(SweepUniforms {
        dispatch, window, size, irradiance, plane, grid, ior_grid,
        light_grid, light_shear, light_initial, light_direction, taps_a, taps_b,
        camera, ground_plane, ground_color, wall_plane, wall_color,
        clip_0, clip_1, clip_2, clip_3, clip_everything,
        ambient, shading,
        environment, environment_x, environment_y, environment_z,
        environment_color, environment_horizon, environment_nadir,
    })
}

fn voxelize_uniforms() -> Vec<Field> {
    fields!(VoxelizeUniforms { dispatch, size, columns, surface })
}

fn shadow_uniforms() -> Vec<Field> {
    fields!(ShadowUniforms { dispatch, size, depth, absorption })
}

#[rustfmt::skip]
fn voxels_uniforms() -> Vec<Field> {
    fields!(VoxelsUniforms {
        dispatch, size, bricks, camera, right, up, away, scale, low, high,
        environment, environment_x, environment_y, environment_z,
        environment_color, environment_horizon, environment_nadir,
        ground, ground_color, wall, wall_color, light, light_color, ambient,
        shadow, shadow_x, shadow_y, shadow_z, shadow_filter,
    })
}

/// std140 aligns vectors of four, and structs of them, to 16 bytes. With no other fields it leaves no gap: each begins where
/// the one before ends.
#[test]
fn uniforms_are_laid_out_by_the_rules_of_std140() {
    for (name, size, alignment, fields) in [
        ("Grid", size_of::<Grid>(), align_of::<Grid>(), grid()),
        ("SweepUniforms", size_of::<SweepUniforms>(), align_of::<SweepUniforms>(), sweep_uniforms()),
        ("ProbeUniforms", size_of::<ProbeUniforms>(), align_of::<ProbeUniforms>(), fields!(ProbeUniforms { dispatch })),
        ("ShadowUniforms", size_of::<ShadowUniforms>(), align_of::<ShadowUniforms>(), shadow_uniforms()),
        ("VoxelizeUniforms", size_of::<VoxelizeUniforms>(), align_of::<VoxelizeUniforms>(), voxelize_uniforms()),
        ("VoxelsUniforms", size_of::<VoxelsUniforms>(), align_of::<VoxelsUniforms>(), voxels_uniforms()),
    ] {
        let mut end = 0;
        for field in fields {
            assert_eq!((field.offset, field.offset % 16, field.size % 16), (end, 0, 0), "{name}.{}", field.name);
            end += field.size;
        }
        assert_eq!((size, alignment), (end, 16), "{name}");
    }
}

#[test]
fn modules_read_uniforms_where_the_host_puts_them() {
    let offsets = |fields: &[Field]| fields.iter().map(|field| field.offset as u32).collect::<Vec<_>>();
    let (uniforms, probe, grid) = (sweep_uniforms(), fields!(ProbeUniforms { dispatch }), grid());
    let (voxelize, voxels, shadow) = (voxelize_uniforms(), voxels_uniforms(), shadow_uniforms());
    for kernel in ALL {
        let name = kernel.declaration.name;
        let module = load(name);
        let block = uniform_block(&module).unwrap_or_else(|| panic!("{name} has no uniform block"));
        let fields = match name.split_once('_') {
            Some(("probe", _)) => &probe,
            Some(("voxelize", _)) => &voxelize,
            Some(("voxels", _)) => &voxels,
            Some(("shadow", _)) => &shadow,
            _ => &uniforms,
        };
        assert_eq!(member_offsets(&module, block), offsets(fields), "{name}: uniforms");
        for (field, member) in fields.iter().zip(members(&module, block)) {
            let expected = if field.size == size_of::<Grid>() { offsets(&grid) } else { vec![0, 4, 8, 12] };
            let found = member_offsets(&module, member);
            // Vectors have no members.
            assert!(!is_struct(&module, member) || found == expected, "{name}: {} has {found:?}", field.name);
        }
    }
}

fn load(name: &str) -> Module {
    let bytes = vitrum_shaders::spirv(name).unwrap_or_else(|| panic!("{name}: no module; run `cargo xtask shaders`"));
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
    load_words(words).unwrap_or_else(|error| panic!("{name}: {error}; run `cargo xtask shaders`"))
}

/// The struct behind binding 0; rust-gpu puts it into a block of its own.
fn uniform_block(module: &Module) -> Option<Word> {
    let types: HashMap<Word, &Instruction> =
        module.types_global_values.iter().filter_map(|found| Some((found.result_id?, found))).collect();
    let binding_0 = [Operand::Decoration(Decoration::Binding), Operand::LiteralBit32(0)];
    let decorated = module.annotations.iter().find(|found| found.operands[1..] == binding_0)?;
    let variable = types[&decorated.operands[0].id_ref_any()?];
    let pointer = types[&variable.result_type?];
    let mut block = pointer.operands[1].id_ref_any()?;
    while let [only] = members(module, block)[..] {
        let only =
            if definition(module, only).class.opcode == Op::TypeRuntimeArray { members(module, only)[0] } else { only };
        if !is_struct(module, only) {
            break;
        }
        block = only;
    }
    Some(block)
}

fn definition(module: &Module, id: Word) -> &Instruction {
    let mut types = module.types_global_values.iter();
    types.find(|found| found.result_id == Some(id)).expect("what is used is defined")
}

fn is_struct(module: &Module, id: Word) -> bool {
    definition(module, id).class.opcode == Op::TypeStruct
}

/// The types of a struct's members.
fn members(module: &Module, id: Word) -> Vec<Word> {
    definition(module, id).operands.iter().filter_map(Operand::id_ref_any).collect()
}

/// The offsets of a struct's members, in their order.
fn member_offsets(module: &Module, id: Word) -> Vec<u32> {
    let mut offsets: Vec<(u32, u32)> = module
        .annotations
        .iter()
        .filter_map(|found| match found.operands[..] {
            [
                Operand::IdRef(target),
                Operand::LiteralBit32(member),
                Operand::Decoration(Decoration::Offset),
                Operand::LiteralBit32(offset),
            ] if target == id => Some((member, offset)),
            _ => None,
        })
        .collect();
    offsets.sort_unstable();
    offsets.into_iter().map(|(_, offset)| offset).collect()
}
