//! The committed modules belong to the tree, and lays structs out as the host does.

use std::collections::HashMap;
use std::mem::{offset_of, size_of_val};

use rspirv::dr::{Instruction, Module, Operand, load_words};
use rspirv::spirv::{Decoration, Op, Word};
use vitrum_conformance::root;
use vitrum_kernels::abi::ambient::Ambient;
use vitrum_kernels::abi::beams::{BeamsUniforms, Cells, Lattice, Limits, Medium, Sums};
use vitrum_kernels::abi::camera::Camera;
use vitrum_kernels::abi::clip::Clip;
use vitrum_kernels::abi::dispatch::{Dispatch, Region};
use vitrum_kernels::abi::environment::Environment;
use vitrum_kernels::abi::grid::Grid;
use vitrum_kernels::abi::light::{Cone, Light, LightGrid, LightSource, Taps};
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::receivers::{Receiver, Receivers};
use vitrum_kernels::abi::shadow::{ShadowUniforms, Spread};
use vitrum_kernels::abi::sweep::{Step, SweepUniforms};
use vitrum_kernels::abi::vector::{Affine, Counts, Size, Vec3};
use vitrum_kernels::abi::voxelize::VoxelizeUniforms;
use vitrum_kernels::abi::voxels::{ShadowMap, VoxelsUniforms};
use vitrum_kernels::abi::wavefront::{ReceiverMap, SpotCone, Wavefront};
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
#[derive(Debug, Clone, PartialEq)]
struct Field {
    name: &'static str,
    offset: usize,
    size: usize,
    /// Fields of the field; empty for a scalar.
    fields: Vec<Field>,
}

/// The fields of a struct, with the fields of the structs in it; a list without one of them does not compile.
macro_rules! fields {
    ($struct:ident { $($field:ident $(: $fields:expr)?),* $(,)? }) => {{
        let $struct { $($field),* } = $struct::default();
        vec![$(Field {
            name: stringify!($field),
            offset: offset_of!($struct, $field),
            size: size_of_val(&$field),
            fields: fields!($($fields)?),
        }),*]
    }};
    () => { Vec::new() };
    ($fields:expr) => { $fields };
}

fn of_vec3() -> Vec<Field> {
    fields!(Vec3 { x, y, z })
}

fn of_affine() -> Vec<Field> {
    fields!(Affine { factors: of_vec3(), constant })
}

fn of_counts() -> Vec<Field> {
    fields!(Counts { x, y, z })
}

fn of_dispatch() -> Vec<Field> {
    fields!(Dispatch { width, height, mode })
}

#[rustfmt::skip]
fn of_grid() -> Vec<Field> {
    fields!(Grid {
        row_x: of_affine(), row_y: of_affine(), row_z: of_affine(), size: of_vec3(), low: of_vec3(), high: of_vec3(), reach,
        value_scale, value_origin,
        row_pitch, slice_pitch, bricks: of_counts(), first_brick, pages: of_counts(), brick_shift, nearest,
    })
}

fn of_light() -> Vec<Field> {
    fields!(Light { direction: of_vec3(), color: of_vec3() })
}

#[rustfmt::skip]
fn of_light_source() -> Vec<Field> {
    let of_cone = fields!(Cone { right: of_vec3(), up: of_vec3(), tangent, slope, first, width, height });
    fields!(LightSource { kind, direction: of_vec3(), color: of_vec3(), position: of_vec3(), cone: of_cone })
}

fn of_spread() -> Vec<Field> {
    fields!(Spread { low_y, low_z, step })
}

fn of_camera() -> Vec<Field> {
    fields!(Camera { half_width, half_height, start, orthographic })
}

fn of_receivers() -> Vec<Field> {
    let of_receiver = || fields!(Receiver { plane: of_affine(), color: of_vec3() });
    fields!(Receivers { ground: of_receiver(), wall: of_receiver() })
}

#[rustfmt::skip]
fn of_ambient() -> Vec<Field> {
    fields!(Ambient {
        mean: of_vec3(), x: of_vec3(), y: of_vec3(), z: of_vec3(), xx: of_vec3(), yy: of_vec3(), zz: of_vec3(), xy: of_vec3(), xz: of_vec3(),
        yz: of_vec3(),
    })
}

#[rustfmt::skip]
fn of_environment() -> Vec<Field> {
    fields!(Environment {
        kind, map_width, map_height, map_levels, row_x: of_vec3(), row_y: of_vec3(), row_z: of_vec3(),
        color: of_vec3(), horizon: of_vec3(), nadir: of_vec3(), square, intensity, visible,
    })
}

fn of_size() -> Vec<Field> {
    fields!(Size { width, height })
}

#[rustfmt::skip]
fn of_wavefront() -> Vec<Field> {
    let of_cone = fields!(SpotCone { axis: of_vec3(), tangent, slope });
    let of_map = fields!(ReceiverMap { size: of_size(), texels, margin, ground, wall });
    fields!(Wavefront {
        row_x: of_affine(), row_y: of_affine(), row_z: of_affine(), spherical, cells: of_size(), corner_x, corner_y, cell, inverse_cell,
        first_depth, inverse_step, first_sample, colors, components, bricks: of_counts(), layer, list, wide: of_size(), map: of_map,
        source: of_vec3(), cone: of_cone, observed, units, softness, blur,
    })
}

#[rustfmt::skip]
fn sweep_uniforms() -> Vec<Field> {
    let of_region = fields!(Region { first_column, first_row, end_column, end_row });
    let of_step = fields!(Step { behind, ahead, distance, inverse_reference_length, smallest_cosine, alike });
    let of_light_grid = fields!(LightGrid {
        width, height, corner_x, corner_y, texel, inverse_texel, shear_x, shear_y, shear_depth,
    });
    let of_taps = fields!(Taps { first_x, first_y, second_x, second_y, third_x, third_y });
    let of_clip = || fields!(Clip { plane: of_affine(), everything });
    fields!(SweepUniforms {
        dispatch: of_dispatch(), flags, region: of_region, picture: of_size(), sensor: of_size(), refined, irradiance_start,
        step: of_step, grid: of_grid(), ior_grid: of_grid(), light_grid: of_light_grid, light: of_light(), wavefront: of_wavefront(), taps: of_taps,
        camera: of_camera(), receivers: of_receivers(), clip_0: of_clip(), clip_1: of_clip(), clip_2: of_clip(), clip_3: of_clip(),
        ambient: of_ambient(), roughness, specular, environment: of_environment(),
    })
}

#[rustfmt::skip]
fn voxelize_uniforms() -> Vec<Field> {
    fields!(VoxelizeUniforms {
        dispatch: of_dispatch(), work, size: of_counts(), row_words, column_shift, first_layer, column_units, voxel_units,
        corner_units, margin, first_triangle, divergence,
    })
}

#[rustfmt::skip]
fn shadow_uniforms() -> Vec<Field> {
    fields!(ShadowUniforms {
        dispatch: of_dispatch(), work, width, height, layers, first_layer, first_word, depth, channels, winding_units, uniform_depth,
        absorption: of_vec3(), spread: of_spread(), divergence,
    })
}

#[rustfmt::skip]
fn voxels_uniforms() -> Vec<Field> {
    let of_shadow = fields!(ShadowMap {
        size: of_counts(), channels, axis: of_vec3(), row_x: of_affine(), row_y: of_affine(), row_z: of_affine(),
        scale: of_affine(), spread: of_spread(), radius, edge, softness, first, first_opaque, opaque_channels,
    });
    fields!(VoxelsUniforms {
        dispatch: of_dispatch(), flags, size: of_counts(), materials, bricks: of_counts(), most_bounces, camera: of_camera(),
        right: of_vec3(), up: of_vec3(), away: of_vec3(), eye: of_vec3(), voxel, same_cosine, same_distance, low: of_vec3(), high: of_vec3(),
        environment: of_environment(), mean_radiance: of_vec3(), receivers: of_receivers(), light: of_light_source(), ambient: of_ambient(),
        shadow: of_shadow, wavefront: of_wavefront(),
    })
}

#[rustfmt::skip]
fn beams_uniforms() -> Vec<Field> {
    let of_lattice = fields!(Lattice {
        count, axis: of_vec3(), across: of_vec3(), upwards: of_vec3(), origin: of_vec3(), low_across, low_upwards, step_across,
        step_upwards,
    });
    let of_limits = fields!(Limits {
        same_distance, threshold, view_threshold, bounces, round, lit, pitch, projection_pitch, bundle_pitch, last, axis,
        estimator, depth_start, depth_pitch, step, filter_radius, line_weight,
    });
    let of_medium = fields!(Medium {
        extinction: of_vec3(), scattering: of_vec3(), anisotropy, phase, low: of_vec3(), high: of_vec3(),
        nodes, columns, rows, layers, first, first_phase,
    });
    fields!(BeamsUniforms {
        dispatch: of_dispatch(), picture: of_size(), camera: of_camera(), right: of_vec3(), up: of_vec3(),
        away: of_vec3(), eye: of_vec3(), voxel, low: of_vec3(), high: of_vec3(), light: of_light_source(), lattice: of_lattice,
        limits: of_limits, medium: of_medium, receivers: of_receivers(), environment: of_environment(), ambient: of_ambient(), flags,
        sums: fields!(Sums { scale, levels, pixels_1, pixels_2, pixels_3, pixels_4, rows_2, rows_3, rows_4, rows }),
        cells: fields!(Cells { edge: of_vec3(), scale, mean_cosine, first }),
    })
}

fn probe_uniforms() -> Vec<Field> {
    fields!(ProbeUniforms { dispatch: of_dispatch(), function })
}

/// The size of a struct by the rules of std430, which aligns scalars, and structs of nothing but scalars, to 4 bytes: each field begins where
/// the one before ends.
fn size_by_std430(name: &str, fields: &[Field]) -> usize {
    let mut end = 0;
    for field in fields {
        let size =
            if field.fields.is_empty() { 4 } else { size_by_std430(&format!("{name}.{}", field.name), &field.fields) };
        assert_eq!((field.offset, field.size), (end, size), "{name}.{}", field.name);
        end += size;
    }
    end
}

#[test]
fn uniforms_are_laid_out_by_the_rules_of_std430() {
    for (name, size, alignment, fields) in [
        ("SweepUniforms", size_of::<SweepUniforms>(), align_of::<SweepUniforms>(), sweep_uniforms()),
        ("ProbeUniforms", size_of::<ProbeUniforms>(), align_of::<ProbeUniforms>(), probe_uniforms()),
        ("ShadowUniforms", size_of::<ShadowUniforms>(), align_of::<ShadowUniforms>(), shadow_uniforms()),
        ("VoxelizeUniforms", size_of::<VoxelizeUniforms>(), align_of::<VoxelizeUniforms>(), voxelize_uniforms()),
        ("BeamsUniforms", size_of::<BeamsUniforms>(), align_of::<BeamsUniforms>(), beams_uniforms()),
        ("VoxelsUniforms", size_of::<VoxelsUniforms>(), align_of::<VoxelsUniforms>(), voxels_uniforms()),
    ] {
        assert_eq!((size, alignment), (size_by_std430(name, &fields), 4), "{name}");
    }
}

#[test]
fn modules_read_uniforms_where_the_host_puts_them() {
    let blocks = HashMap::from([
        ("sweep", sweep_uniforms()),
        ("voxelize", voxelize_uniforms()),
        ("voxels", voxels_uniforms()),
        ("shadow", shadow_uniforms()),
        ("beams", beams_uniforms()),
        ("probe", probe_uniforms()),
    ]);
    for kernel in ALL {
        let name = kernel.declaration.name;
        let module = load(name);
        let block = uniform_block(&module).unwrap_or_else(|| panic!("{name} has no uniform block"));
        let (folder, _) = name.split_once('_').unwrap_or_else(|| panic!("{name} has no folder"));
        agree(&module, block, &blocks[folder], name);
    }
}

/// Holds the offsets of a module's struct, and of the structs in it, to the host's.
fn agree(module: &Module, id: Word, fields: &[Field], path: &str) {
    let offsets: Vec<u32> = fields.iter().map(|field| field.offset as u32).collect();
    assert_eq!(member_offsets(module, id), offsets, "{path}");
    for (field, member) in fields.iter().zip(members(module, id)) {
        let path = format!("{path}.{}", field.name);
        assert_eq!(is_struct(module, member), !field.fields.is_empty(), "{path}");
        if !field.fields.is_empty() {
            agree(module, member, &field.fields, &path);
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
