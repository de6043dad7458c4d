//! The list of kernels.

/// Calls `$callback!` with every kernel's declaration.
///
/// A declaration reads: name, uniform block (always binding 0), the buffers it reads (binding, name, element), the planar
/// buffer it `writes` or `updates` (binding, components) or the sums it `adds` to (binding, words a place has), its module with
/// const generics, the `levels` it may run at (see the module's `level`) with the one that a GPU runs, and the `modes` that get a
/// body of their own on the CPU. Of one that `rests`, the CPU leaves out blocks for as many passes as the module's `rest` says; of one
/// that keeps `unoccluded` light as it is (see the module's `unoccluded`), blocks that have nothing else around them.
///
/// A level is a set of bits, what it can do. A block of invocations on the CPU runs at the union of the levels its invocations
/// need, so unions must be in the list. The last level can do everything. A kernel that updates its record leaves it alone where
/// the level is 0 (there is nothing more to do in this frame) or 1 (nothing now).
#[macro_export]
macro_rules! for_each_kernel {
    ($callback:ident) => {
        $callback! {
            sweep_initialize_light: SweepUniforms, [], writes 1 [light::SIZE],
                sweep::initialize_light [], plain, modes [0];
            sweep_initialize_rays: SweepUniforms, [], writes 1 [ray::SIZE],
                sweep::initialize_rays [], plain, modes [0];
            sweep_filter_light: SweepUniforms, [1 behind: f32], writes 2 [light::SIZE],
                sweep::filter_light [], levels [1 3] gpu 3 unoccluded, modes [0 4];
            sweep_trace_light: SweepUniforms, [1 light: f32], writes 2 [trace::SIZE],
                sweep::trace_light [], levels [1 3 7] gpu 7 unoccluded, modes [0];
            sweep_gather_light: SweepUniforms, [1 behind: f32, 2 trace: f32], writes 3 [light::SIZE],
                sweep::gather_light [], levels [1 3 7] gpu 7 unoccluded, modes [0 4];
            sweep_refract_light_u8: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::U8, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_u16: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::U16, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_f32: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::F32, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_f32_with_ior: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::F32, true], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_u8_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::U8_PAGED, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_u16_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::U16_PAGED, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_f32_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::F32_PAGED, false], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_refract_light_f32_with_ior_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 trace: f32],
                updates 6 [light::SIZE],
                sweep::refract_light [format::F32_PAGED, true], levels [3 7] gpu 7 unoccluded, modes [0 1 2 4 5];
            sweep_concentrate_light: SweepUniforms, [1 light: f32], writes 2 [irradiance::SIZE],
                sweep::concentrate_light [], levels [1 3] gpu 3 unoccluded, modes [0];
            sweep_propagate_rays_u8: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::U8, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_u16: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::U16, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_f32: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::F32, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_f32_with_ior: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::F32, true], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_u8_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::U8_PAGED, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_u16_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::U16_PAGED, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_f32_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::F32_PAGED, false], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_propagate_rays_f32_with_ior_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 irradiance: f32],
                updates 6 [ray::SIZE],
                sweep::propagate_rays [format::F32_PAGED, true], levels [3 7 15 31] gpu 31 rests, modes [0 1 2 3 4 5];
            sweep_initialize_sheet: SweepUniforms, [1 sources: f32], writes 2 [sheet::SIZE],
                sweep::initialize_sheet [], plain, modes [0];
            sweep_advance_sheet_u8: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::U8, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_u16: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::U16, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_f32: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::F32, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_f32_with_ior: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::F32, true], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_u8_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::U8_PAGED, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_u16_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::U16_PAGED, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_f32_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::F32_PAGED, false], levels [3 7] gpu 7, modes [0 1 2];
            sweep_advance_sheet_f32_with_ior_paged: SweepUniforms,
                [1 voxels: u32, 2 ior_voxels: u32, 3 occupancy: u32, 4 tables: u32, 5 sources: f32],
                updates 6 [sheet::SIZE],
                sweep::advance_sheet [format::F32_PAGED, true], levels [3 7] gpu 7, modes [0 1 2];
            sweep_clear_sums: SweepUniforms, [], writes 1 [sums::SIZE],
                sweep::clear_sums [], plain, modes [0];
            sweep_scatter_sheet: SweepUniforms, [1 sheet: f32, 2 sources: f32], adds 3 [sums::SIZE],
                sweep::scatter_sheet [], plain, modes [0];
            sweep_collect_light: SweepUniforms, [1 sums: u32], writes 2 [light::SIZE],
                sweep::collect_light [], plain, modes [0];
            sweep_resolve: SweepUniforms, [1 rays: f32, 2 map: f32], writes 3 [film::SIZE],
                sweep::resolve [], plain, modes [0];
            voxelize_mark_surface: VoxelizeUniforms, [1 corners: u32, 2 items: u32], adds 3 [1],
                voxelize::mark_surface [], plain, modes [0 1];
            voxelize_sum_attributes: VoxelizeUniforms,
                [1 corners: u32, 2 items: u32, 3 attributes: f32, 4 mask: u32, 5 ranks: u32],
                adds 6 [attributes::SIZE],
                voxelize::sum_attributes [], plain, modes [0 1];
            voxelize_cross_columns: VoxelizeUniforms, [1 corners: f32, 2 items: u32], adds 3 [1],
                voxelize::cross_columns [], plain, modes [0];
            voxelize_fill_rows: VoxelizeUniforms, [1 changes: u32], adds 2 [1],
                voxelize::fill_rows [], plain, modes [0 1];
            voxels_initialize_rays: VoxelsUniforms, [], writes 1 [path::SIZE],
                voxels::initialize_rays [], plain, modes [0];
            voxels_march: VoxelsUniforms, [1 bricks: u32, 2 fields: u32, 3 materials: f32], updates 4 [path::SIZE],
                voxels::march [], levels [3] gpu 3, modes [0 1];
            voxels_march_paper: VoxelsUniforms, [1 mask: u32, 2 ranks: u32, 3 surfaces: f32, 4 materials: f32],
                updates 5 [path::SIZE],
                voxels::march_paper [], levels [3] gpu 3, modes [0 1];
            voxels_trace_triangles: VoxelsUniforms, [1 nodes: f32, 2 corners: f32, 3 materials: f32],
                updates 4 [path::SIZE],
                voxels::trace_triangles [], levels [3] gpu 3, modes [1];
            voxels_seek: VoxelsUniforms, [1 nodes: f32, 2 corners: f32, 3 materials: f32],
                updates 4 [path::SIZE],
                voxels::seek [], levels [3] gpu 3, modes [0 1];
            voxels_reflect: VoxelsUniforms, [1 rays: f32, 2 nodes: f32, 3 corners: f32, 4 materials: f32],
                updates 5 [mirror::SIZE],
                voxels::reflect [], levels [3] gpu 3, modes [0];
            voxels_resolve: VoxelsUniforms,
                [1 rays: f32, 2 map: f32, 3 corners: f32, 4 looks: f32, 5 shadow: u32, 6 mirrors: f32],
                writes 7 [view::SIZE],
                voxels::resolve [], plain, modes [0 1];
            shadow_count_crossings: ShadowUniforms, [1 casters: f32, 2 items: u32], adds 3 [absorption::SIZE],
                shadow::count_crossings [], plain, modes [0];
            shadow_absorb_solid: ShadowUniforms, [1 changes: u32], adds 2 [absorption::SIZE],
                shadow::absorb_solid [], plain, modes [0];
            shadow_accumulate: ShadowUniforms, [1 depths: u32], adds 2 [1],
                shadow::accumulate [], plain, modes [0 1];
            probe_apply_function: ProbeUniforms, [1 arguments: f32], writes 2 [probe::SIZE],
                probe::apply_function [], plain, modes [0];
        }
    };
}
