//! The pass list of a frame of beams.

use super::lattice::lattice;
use super::uniforms::{self, Surroundings};
use super::{of_triangles, shown};
use crate::assets::Assets;
use crate::backend::{Backend, Buffer, Pass, PassList, WhileBusy};
use crate::error::Error;
use crate::method::view::environment::EnvironmentUniforms;
use crate::method::view::receivers::Receivers;
use crate::method::voxels::UploadedMesh;
use crate::method::voxels::bodies::materials;
use crate::method::voxels::cache::FrameCache;
use crate::method::voxels::light::light_source;
use crate::method::voxels::shadow::source::Source;
use crate::method::{Bounds, View};
use crate::scene::Scene;
use bytemuck::bytes_of;
use vitrum_kernels::abi::beams::{BLOCK, BeamsUniforms, flag, part};
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::record::{beam, beam_pixel, bundle, depths, inscattered, pencil, search, sight};
use vitrum_kernels::abi::vector::Size;
use vitrum_kernels::abi::voxels::STEPS;
use vitrum_kernels::beams::pyramid::{pixels_below, rows_before, size};
use vitrum_kernels::beams::tree::{ROW, rows, top};
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// Nodes of a tree on a straight piece of a ray, several times as many as usual.
const NODES: u32 = 8 * STEPS as u32;

/// A frame of beams that is ready to run.
pub(super) struct Frame {
    pub(super) passes: PassList,
    /// Viewing rays across and down.
    pub(super) rays: [u32; 2],
    pub(super) film: Buffer,
    /// The pencils of light, planar records as [`pencil`] describes.
    pub(super) pencils: Buffer,
}

/// A list of passes that is being written.
struct List {
    block: BeamsUniforms,
    passes: Vec<Pass>,
}

impl List {
    /// Adds a pass over `size` invocations, in a round; records are written from word `start` on.
    fn add(
        &mut self,
        kernel: &'static Kernel,
        [width, height]: [u32; 2],
        (mode, round): (u32, u32),
        buffers: &[&Buffer],
        start: u64,
    ) {
        let mut block = self.block;
        block.dispatch = Dispatch { width, height, mode };
        block.limits.round = round;
        self.passes.push(Pass {
            kernel,
            uniforms: bytes_of(&block).to_vec(),
            buffers: buffers.iter().map(|&buffer| buffer.clone()).collect(),
            width,
            height,
            start,
            window: Window::whole(width, height),
        });
    }
}

/// The passes in which pencils get to their next piece in air, at most.
fn passes_of_round(block: &BeamsUniforms) -> u32 {
    ((block.limits.bounces + 1) * NODES).div_ceil(4 * STEPS as u32)
}

/// Uploads a frame's buffers and lists its passes.
pub(super) fn list(
    scene: &Scene,
    assets: &Assets,
    uploaded: &UploadedMesh,
    cache: &mut FrameCache,
    backend: &mut dyn Backend,
) -> Result<Frame, Error> {
    let mesh = shown(assets)?;
    let extent = Bounds::from(mesh);
    let view = View::new(scene, extent);
    let looks = cache.looks(scene, mesh, uploaded);
    let mut flags = if looks.of_triangles { flag::LOOK_OF_TRIANGLE } else { 0 };
    let pictures = cache.pictures.get(scene, assets.environment.as_deref(), &assets.textures, backend)?;
    let light = scene.first_light();
    let source = Source::of(light, &view, extent)?;
    let texture = light.texture.as_deref().and_then(|path| pictures.texture(path));
    let shines = light.intensity > 0.0 && light.color != [0.0; 3];
    let casts = light.shadows && shines;
    let scatters = scene.medium.as_ref().is_some_and(|medium| medium.scattering != [0.0; 3]);
    flags |= if scatters && shines { flag::SCATTERS } else { 0 };
    flags |= if casts { flag::SHADOWS } else { 0 };
    // Beams light the medium, and diffuse surfaces.
    let surfaces = uploaded.has_diffuse() || scene.ground.is_some() || scene.wall.is_some();
    let casts = casts && (scatters || surfaces);
    let surroundings = Surroundings {
        environment: EnvironmentUniforms::new(&scene.environment, &pictures.environment, &view),
        receivers: Receivers::new(scene, &view, extent),
        light: light_source(light, &source, &view, uploaded.grid, texture),
        lattice: if casts { lattice(&source, uploaded, scene.beams.rays)? } else { Default::default() },
    };
    let mut block = uniforms::block(scene, uploaded, &view, extent, &surroundings, flags);
    let materials = materials(&uploaded.bodies, mesh, &of_triangles(scene), uploaded.grid.voxel_size);
    let materials = cache.materials(materials, backend)?;
    let looks = cache.looks_buffer(scene, &looks, backend)?;
    let Size { width, height } = block.picture;
    let picture = [width, height];
    let texels = [block.lattice.count; 2];
    let bytes = |[width, height]: [u32; 2], components: usize| {
        u64::from(width) * u64::from(height) * components as u64 * 4
    };
    let scratch = &mut cache.scratch;
    let rounds = if casts { scene.beams.segments + 1 } else { 0 };
    let beam_bytes = bytes(texels, beam::SIZE).next_multiple_of(256);
    block.limits.pitch = (beam_bytes / 4) as u32;
    let pencils = scratch.zeros("pencils of light", bytes(texels, pencil::SIZE).max(4), backend)?;
    let beams = scratch.zeros("beams", (beam_bytes * u64::from(rounds)).max(4), backend)?;
    // The nodes of the tree of a round.
    let tree = if casts { [ROW, rows(top(texels[0]))] } else { [1, 1] };
    let bundle_bytes = if casts { bytes(tree, bundle::SIZE).next_multiple_of(256) } else { 0 };
    block.limits.bundle_pitch = (bundle_bytes / 4) as u32;
    block.limits.last = rounds.saturating_sub(1);
    let bundles = scratch.zeros("bundles of beams", (bundle_bytes * u64::from(rounds)).max(4), backend)?;
    let searches = scratch.zeros("searches for light", bytes(picture, search::SIZE), backend)?;
    let rays = scratch.zeros("viewing rays", bytes(picture, pencil::SIZE), backend)?;
    let sights = scratch.zeros("sights", bytes(picture, sight::SIZE), backend)?;
    let levels = block.sums.levels;
    let coarse = [size(block.picture, 1).width, rows_before(block.picture, levels + 1)];
    let depths = scratch.zeros("depths", bytes(coarse, depths::SIZE).max(4), backend)?;
    let words = u64::from(pixels_below(block.picture, levels + 1)) * inscattered::SIZE as u64;
    let [caustics, shadows] = [0, 1].map(|number| ("sums", number));
    let caustics = scratch.zeros(caustics, words * 4, backend)?;
    let shadows = scratch.zeros(shadows, words * 4, backend)?;
    let film = scratch.zeros("film", bytes(picture, beam_pixel::SIZE), backend)?;
    let [nodes, corners] = [0, 1].map(|half| uploaded.tree[half].clone());
    let mut list = List { block, passes: Vec::new() };
    for round in 0..rounds {
        for _ in 0..passes_of_round(&block) {
            list.add(&kernels::beams_trace_light, texels, (0, round), &[&nodes, &corners, &materials, &pencils], 0);
        }
        let mode = if round == 0 { part::SHADOW } else { part::CAUSTIC };
        let start = beam_bytes / 4 * u64::from(round);
        list.add(&kernels::beams_store_beam, texels, (mode, round), &[&pencils, &pictures.buffer, &beams], start);
        let start = bundle_bytes / 4 * u64::from(round);
        list.add(&kernels::beams_bound_beams, tree, (0, round), &[&beams, &bundles], start);
    }
    for round in 0..scene.beams.views {
        for _ in 0..passes_of_round(&block) {
            list.add(&kernels::beams_trace_view, picture, (0, round), &[&nodes, &corners, &materials, &rays], 0);
        }
        if casts && surfaces {
            let sought = [&rays, &nodes, &corners, &looks, &materials, &searches];
            for _ in 0..uploaded.nodes().div_ceil(4 * STEPS as u32) {
                list.add(&kernels::beams_find_light, picture, (0, round), &sought, 0);
            }
        }
        let seen = [&rays, &pictures.buffer, &corners, &looks, &materials, &searches, &sights];
        list.add(&kernels::beams_see, picture, (0, round), &seen, 0);
        // The first pieces need no more than their surfaces.
        if casts && (round > 0 || surfaces) {
            let gathered = [&rays, &beams, &bundles, &corners, &looks, &materials, &sights];
            list.add(&kernels::beams_gather, picture, (0, round), &gathered, 0);
        }
    }
    if rounds > 0 && scatters {
        if levels > 0 {
            list.add(&kernels::beams_find_depths, coarse, (0, 0), &[&sights, &depths], 0);
        }
        let blocks = width.max(height).div_ceil(BLOCK);
        for round in 0..rounds {
            let sums = if round == 0 { &shadows } else { &caustics };
            let drawn = [&beams, &sights, &depths, sums];
            list.add(&kernels::beams_scatter_beam, [blocks, texels[0] * texels[1]], (0, round), &drawn, 0);
        }
    }
    list.add(&kernels::beams_resolve, picture, (0, 0), &[&sights, &caustics, &shadows, &film], 0);
    let while_busy = |kernel: &'static Kernel, until: &'static Kernel| {
        let name = kernel.declaration.name;
        WhileBusy { kernel: name, passes: vec![name], until: Some(until.declaration.name) }
    };
    let passes = PassList {
        passes: list.passes,
        while_busy: vec![
            while_busy(&kernels::beams_trace_light, &kernels::beams_store_beam),
            while_busy(&kernels::beams_trace_view, &kernels::beams_see),
            while_busy(&kernels::beams_find_light, &kernels::beams_see),
        ],
        ..PassList::default()
    };
    Ok(Frame { passes, rays: picture, film, pencils })
}
