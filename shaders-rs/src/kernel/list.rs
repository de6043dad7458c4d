//! The list of kernels.
//!
//! A declaration stands under its folder and the folder's uniform block (always binding 0, from the folder's namesake in [`crate::abi`]). It reads:
//!
//! `module(buffer: element, …) writes|updates|adds record, levels […], modes group […], skip […], reports work;`
//!
//! - The **module** in the folder has the kernel's function `invoke`. A kernel that reads voxels is a *family*, `module<V>`: it is declared
//!   once and has a member for each format of voxels ([`crate::abi::format`]).
//! - The **buffers** that it reads, in order of their bindings, by name and element; `volume` stands for voxels, the second volume's
//!   voxels, occupancy and tables.
//! - The planar buffer of records of which it **writes** or **updates** one an index, or the sums that it **adds** to; the
//!   record's components, or the words that a place has, are the `SIZE` of its module in [`crate::abi::record`].
//! - The **levels** of work that get a body of their own on the CPU, by their names in the module's `level`, and the `few` of them that are
//!   enough where there are fewer bodies. A level is a set of bits; each has all bits of those before, and the last one can do
//!   everything. A block of invocations on the CPU runs at the first level that has all bits its invocations need (the module's function
//!   `level`), a GPU at the last. A kernel that updates its record leaves it alone where the level is 0 (there is nothing more to do in this
//!   frame) or 1 (nothing now).
//! - The **modes** that it is run in, by their names in a group of constants beside the uniform block. A mode is the same for a
//!   whole pass, and gets bodies of its own on the CPU; after `=` stands the mode that computes the same bits where there are fewer bodies.
//! - What the CPU may **skip** ([`super::skip`]): blocks that have nothing to do `until` a later pass, or around which all is the `same`.
//! - Whether it **reports** work on a GPU: a kernel that updates and whose level is above 0 for any invocation then raises the numbers of
//!   workgroups of a later dispatch (`kernel/workgroups.rs`), which the backend makes and binds behind the record.

#[cfg(not(target_arch = "spirv"))]
use super::{
    chunk::{Chunk, LANES},
    declaration::{Access, Binding, Declaration, Element, Family, Kernel, Skip},
    drive,
    instruction_set::InstructionSet,
    skip,
};
#[cfg(target_arch = "spirv")]
use super::{last, record, workgroups};
use crate::abi::Dispatched as _;
#[cfg(target_arch = "spirv")]
use crate::abi::dispatch::Dispatch;
#[cfg(not(target_arch = "spirv"))]
use crate::field::sums::SharedSums;
#[cfg(target_arch = "spirv")]
use spirv_std::{glam::UVec3, spirv};

kernels! {
    sweep: SweepUniforms {
        initialize_light() writes light;
        initialize_rays(light: u32, pixels: u32) writes ray;
        filter_light(behind: f32) writes light,
            levels [INSIDE BORDER], modes mode [STRAIGHT, CLEAR_STRAIGHT], skip [same];
        trace_light(light: f32) writes trace,
            levels [STILL NEAR FAR], skip [same];
        gather_light(behind: f32, trace: f32) writes light,
            levels [STILL NEAR FAR UNCONSERVED], modes mode [STRAIGHT, CLEAR_STRAIGHT], skip [same];
        refract_light<V>(volume, trace: f32) updates light,
            levels [FULL BORDER] few [BORDER],
            modes mode [STRAIGHT, CENTRAL, CHAIN, CLEAR_STRAIGHT = STRAIGHT, CLEAR_CENTRAL = CENTRAL],
            skip [same until];
        concentrate_light(light: f32) writes irradiance,
            levels [INNER BORDER], skip [same];
        propagate_rays<V>(volume, light: u32) updates ray,
            levels [FULL MEETING BORDER],
            modes mode [
                STRAIGHT, CENTRAL, CHAIN, UNSHADED, CLEAR_STRAIGHT = STRAIGHT, CLEAR_CENTRAL = CENTRAL, TEXELS_CENTRAL, TEXELS_CHAIN, SHADED_BY_GRADIENT
            ],
            skip [until];
        follow_rays<V>(volume, light: u32) updates ray,
            levels [WORK], modes mode [CENTRAL, CHAIN, CLEAR_CENTRAL = CENTRAL, TEXELS_CENTRAL, TEXELS_CHAIN], reports work;
        project_rays<V>(volume) updates ray,
            levels [FULL BORDER], modes blend [MAXIMUM, MINIMUM, MEAN],
            skip [until];
        color_projected(tables: u32) updates ray,
            levels [WORK], modes blend [MAXIMUM, MINIMUM, MEAN];
        initialize_nodes() writes node;
        advance_nodes<V>(volume) updates node,
            levels [FULL BORDER] few [BORDER],
            modes mode [STRAIGHT, CENTRAL, CHAIN, CLEAR_STRAIGHT = STRAIGHT, CLEAR_CENTRAL = CENTRAL],
            skip [until];
        blur_nodes(nodes: f32, behind: f32) writes blurred, modes blurred [NODES, AGAIN];
        take_blurred(blurred: f32) updates node, levels [WORK];
        clear_sums() writes sums;
        project_nodes(nodes: f32) writes projected;
        cover_samples(projected: f32, bricks: u32) writes covered, levels [UNSEEN WORK];
        scatter_cells(covered: f32, projected: f32, bricks: u32) adds sums, modes mode [CENTRAL, CLEAR_CENTRAL];
        collect_light(sums: u32, nodes: f32, bricks: u32) writes carried,
            modes mode [STRAIGHT, CENTRAL];
        collect_clear(sums: u32, nodes: f32, bricks: u32) writes carried_clear,
            modes mode [CLEAR_CENTRAL];
        collect_straight(sums: u32, nodes: f32, bricks: u32) writes carried_straight,
            modes mode [STRAIGHT];
        clear_landed() writes landed;
        land_cells(nodes: f32) adds landed, modes receiver [GROUND, WALL, OBSERVED];
        integrate_landed() adds landed, modes along [ROWS, COLUMNS];
        collect_receiver(landed: u32, nodes: f32) writes received;
        resolve(rays: f32, map: f32, light: u32) writes film, modes mode [STRAIGHT, CENTRAL];
    }
    voxelize: VoxelizeUniforms {
        mark_surface(corners: u32, items: u32) adds word, modes pieces [TRIANGLES, ITEMS];
        sum_attributes(corners: u32, items: u32, attributes: f32, mask: u32, ranks: u32) adds attributes,
            modes pieces [TRIANGLES, ITEMS];
        cross_columns(corners: f32, items: u32) adds word;
        fill_rows(changes: u32) adds word, modes mode [NONZERO, EVEN_ODD];
    }
    voxels: VoxelsUniforms {
        initialize_rays() writes path;
        march(bricks: u32, fields: u32, materials: f32) updates path,
            levels [WORK], modes mode [TWO_SURFACES, MULTI_SURFACE], reports work;
        march_paper(mask: u32, ranks: u32, surfaces: f32, materials: f32) updates path,
            levels [WORK], modes mode [TWO_SURFACES, MULTI_SURFACE], reports work;
        trace_triangles(nodes: f32, corners: f32, materials: f32) updates path,
            levels [WORK], modes mode [MULTI_SURFACE], reports work;
        seek(nodes: f32, corners: f32, materials: f32) updates path,
            levels [WORK], modes mode [TWO_SURFACES, MULTI_SURFACE];
        reflect(rays: f32, nodes: f32, corners: f32, materials: f32) updates mirror,
            levels [WORK], reports work;
        resolve(rays: f32, pictures: f32, corners: f32, looks: f32, shadow: u32, mirrors: f32) writes view,
            modes seen [ENVIRONMENT, SURFACES];
        follow() updates path,
            levels [WORK];
        add_way(rays: f32, pictures: f32, corners: f32, looks: f32, shadow: u32) updates view,
            levels [WORK], modes seen [ENVIRONMENT, SURFACES];
    }
    shadow: ShadowUniforms {
        count_crossings(casters: f32, items: u32) adds absorption;
        absorb_solid(changes: u32) adds absorption;
        accumulate(depths: u32) adds word, modes mode [COUNTED, UNIFORM];
    }
    beams: BeamsUniforms {
        trace_light(nodes: f32, corners: f32, materials: f32) updates pencil,
            levels [WORK], reports work;
        trace_view(nodes: f32, corners: f32, materials: f32) updates pencil,
            levels [WORK], reports work;
        map_faces(nodes: f32, corners: f32, materials: f32) updates faces,
            levels [WORK], reports work;
        refract_maps(faces: f32, materials: f32) writes way;
        trace_maps(faces: f32, ways: f32, materials: f32) writes pencil;
        store_beam(pencils: f32, pictures: f32, materials: f32) writes beam,
            modes part [CAUSTIC, SHADOW];
        bound_beams(beams: f32) writes bundle;
        find_curved(beams: f32) updates curved,
            levels [WORK];
        split_texels(curved: f32, beams: f32) writes pencil;
        drop_beam(curved: f32) updates beam,
            levels [WORK];
        find_light(pencils: f32, nodes: f32, corners: f32, looks: f32, materials: f32) updates search,
            levels [WORK], reports work;
        see(pencils: f32, pictures: f32, corners: f32, looks: f32, materials: f32, searches: f32) updates sight,
            levels [WORK];
        gather(pencils: f32, beams: f32, bundles: f32, materials: f32) updates sight,
            levels [WORK];
        light_surface(pencils: f32, beams: f32, bundles: f32, corners: f32, looks: f32, materials: f32) updates sight,
            levels [WORK];
        project_beam(beams: f32) writes projection;
        find_depths(sights: f32) writes depths;
        look_around(depths: f32) writes around;
        integrate_beam(beams: f32, materials: f32) writes optical_depth;
        integrate_view(sights: f32, materials: f32) writes optical_depth;
        add_depths(parts: f32) writes optical_depth;
        scatter_beam(beams: f32, projections: f32, sights: f32, depths: f32, materials: f32, optical_depths: f32) adds inscattered,
            modes medium [HOMOGENEOUS, VARYING, MARCHED];
        deposit_beam(beams: f32, materials: f32) adds deposit;
        light_cell(sums: u32, pictures: f32, materials: f32) writes cell;
        exchange_light(direct: f32, scattered: f32, materials: f32) writes cell,
            modes target [CELLS, EYE];
        see_cells(pencils: f32, cells: f32, materials: f32) updates sight,
            levels [WORK];
        resolve(sights: f32, caustics: u32, shadows: u32) writes beam_pixel;
    }
    probe: ProbeUniforms {
        apply_function(arguments: f32) writes probe;
    }
}

/// Every kernel.
#[cfg(not(target_arch = "spirv"))]
pub static ALL: &[&Kernel] = &flatten(DECLARED);

#[cfg(not(target_arch = "spirv"))]
const COUNT: usize = {
    let (mut count, mut at) = (0, 0);
    while at < DECLARED.len() {
        count += DECLARED[at].len();
        at += 1;
    }
    count
};

#[cfg(not(target_arch = "spirv"))]
const fn flatten(declared: &[&[&'static Kernel]]) -> [&'static Kernel; COUNT] {
    let mut all = [declared[0][0]; COUNT];
    let (mut count, mut at) = (0, 0);
    while at < declared.len() {
        let mut member = 0;
        while member < declared[at].len() {
            all[count] = declared[at][member];
            count += 1;
            member += 1;
        }
        at += 1;
    }
    all
}
