//! The committed SPIR-V modules.

macro_rules! modules {
    ($($name:ident)*) => {
        /// The SPIR-V of a kernel, by name.
        pub(super) fn module(kernel: &str) -> Option<&'static [u8]> {
            match kernel {
                $(stringify!($name) => Some(include_bytes!(concat!(
                    env!("CARGO_MANIFEST_DIR"),
                    "/../../shaders-rs/spirv/",
                    stringify!($name),
                    ".spv"
                ))),)*
                _ => None,
            }
        }
    };
}

modules! {
    probe_apply_function
    shadow_absorb_solid
    shadow_accumulate
    shadow_count_crossings
    sweep_advance_sheet_f32
    sweep_advance_sheet_f32_paged
    sweep_advance_sheet_f32_with_ior
    sweep_advance_sheet_f32_with_ior_paged
    sweep_advance_sheet_u16
    sweep_advance_sheet_u16_paged
    sweep_advance_sheet_u8
    sweep_advance_sheet_u8_paged
    sweep_clear_sums
    sweep_collect_light
    sweep_concentrate_light
    sweep_filter_light
    sweep_gather_light
    sweep_initialize_light
    sweep_initialize_rays
    sweep_initialize_sheet
    sweep_propagate_rays_f32
    sweep_propagate_rays_f32_paged
    sweep_propagate_rays_f32_with_ior
    sweep_propagate_rays_f32_with_ior_paged
    sweep_propagate_rays_u16
    sweep_propagate_rays_u16_paged
    sweep_propagate_rays_u8
    sweep_propagate_rays_u8_paged
    sweep_refract_light_f32
    sweep_refract_light_f32_paged
    sweep_refract_light_f32_with_ior
    sweep_refract_light_f32_with_ior_paged
    sweep_refract_light_u16
    sweep_refract_light_u16_paged
    sweep_refract_light_u8
    sweep_refract_light_u8_paged
    sweep_resolve
    sweep_scatter_sheet
    sweep_trace_light
    voxelize_cross_columns
    voxelize_fill_rows
    voxelize_mark_surface
    voxelize_sum_attributes
    voxels_initialize_rays
    voxels_march
    voxels_march_paper
    voxels_reflect
    voxels_resolve
    voxels_seek
    voxels_trace_triangles
}
