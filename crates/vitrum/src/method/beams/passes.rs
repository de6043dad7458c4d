//! The passes of a frame of beams, from its scene.

use super::drawing::{self, Picture};
use super::exchange;
use super::frame::Frame;
use super::lattice::{coarser, lattice};
use super::list::{List, pitch};
use super::lit::{Bodies, Lights, Lit, passes_of_round};
use super::maps::{self, Maps};
use super::medium::MediumCache;
use super::of_triangles;
use super::split::Split;
use super::uniforms::{self, Surroundings};
use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, PassList, WhileBusy};
use crate::error::Error;
use crate::method::cache::Scratch;
use crate::method::view::environment::EnvironmentUniforms;
use crate::method::view::receivers::Receivers;
use crate::method::voxels::UploadedMesh;
use crate::method::voxels::bodies::materials;
use crate::method::voxels::cache::FrameCache;
use crate::method::voxels::light::light_source;
use crate::method::voxels::shadow::source::Source;
use crate::method::voxels::uploaded::shown;
use crate::method::{Bounds, View};
use crate::scene::{MethodName, Scene, Tracer};
use vitrum_kernels::abi::beams::{Lattice, flag};
use vitrum_kernels::abi::record::{beam_pixel, inscattered, pencil, search, sight};
use vitrum_kernels::abi::vector::Size;
use vitrum_kernels::abi::voxels::STEPS;
use vitrum_kernels::beams::pyramid::pixels_below;
use vitrum_kernels::kernel::{Kernel, kernels};

/// Rays along each edge of the lattice whose beams are seen behind surfaces, at most.
const VIEW_RAYS: u32 = 32;

/// The parts of a frame's work that its scene needs.
#[derive(Clone, Copy)]
struct Needs {
    /// Light that the medium scatters out of beams.
    scattering: bool,
    /// Light on diffuse surfaces.
    surfaces: bool,
}

/// Uploads a frame's buffers and lists its passes.
pub(super) fn list(
    scene: &Scene,
    assets: &Assets,
    uploaded: &UploadedMesh,
    cache: &mut FrameCache,
    media: &mut MediumCache,
    backend: &mut dyn Backend,
) -> Result<Frame, Error> {
    let mesh = shown(assets, MethodName::Beams)?;
    let extent = Bounds::from(mesh);
    let view = View::new(scene, extent);
    let looks = cache.looks(scene, mesh, uploaded);
    let pictures = cache.pictures.get(scene, assets.environment.as_deref(), &assets.textures, backend)?;
    let light = scene.first_light();
    let source = Source::of(light, &view, extent)?;
    let texture = light.texture.as_deref().and_then(|path| pictures.texture(path));
    let shines = light.intensity > 0.0 && light.color != [0.0; 3];
    let scatters = scene.medium.as_ref().is_some_and(|medium| medium.scattering != [0.0; 3]);
    let needs = Needs {
        scattering: scatters,
        surfaces: uploaded.has_diffuse() || scene.ground.is_some() || scene.wall.is_some(),
    };
    let casts = light.shadows && shines && (needs.scattering || needs.surfaces);
    let mut flags = if looks.of_triangles { flag::LOOK_OF_TRIANGLE } else { 0 };
    flags |= if scatters && shines { flag::SCATTERS } else { 0 };
    flags |= if casts { flag::SHADOWS } else { 0 };
    let count = scene.beams.rays;
    let fine = if casts { lattice(&source, uploaded, count)? } else { Lattice::default() };
    let materials = materials(&uploaded.bodies, mesh, &of_triangles(scene), uploaded.grid.voxel_size);
    let medium = media.medium(scene, assets, (extent, uploaded.grid), materials, backend)?;
    let surroundings = Surroundings {
        environment: EnvironmentUniforms::new(scene, &pictures.environment, &view),
        receivers: Receivers::new(scene, &view, extent),
        light: light_source(light, &source, &view, uploaded.grid, texture),
        lattice: fine,
        medium: medium.uniforms,
    };
    let mut block = uniforms::block(scene, uploaded, &view, extent, &surroundings, flags);
    block.cells = exchange::cells(&block, medium.mean_cosine, medium.first_exchange);
    let bodies = Bodies {
        nodes: uploaded.tree[0].clone(),
        corners: uploaded.tree[1].clone(),
        materials: medium.materials,
        looks: cache.looks_buffer(scene, &looks, backend)?,
    };
    let scratch = &mut cache.scratch;
    let by_maps = scene.beams.tracer == Tracer::DepthMap;
    let most = if by_maps { maps::ROUNDS } else { u32::MAX };
    let rounds = (scene.beams.segments + 1).min(most);
    // Behind surfaces beams are looked for one by one: there a coarser lattice does.
    let coarse = coarser(fine, VIEW_RAYS);
    let mut lit = None;
    if casts {
        let mut beams = |lattice: Lattice, number: usize| -> Result<Lit, BackendError> {
            let maps = by_maps.then(|| Maps::new(&lattice, number, scratch, backend)).transpose()?;
            let lit = Lit::new(lattice, rounds, block.limits, number, scratch, backend)?;
            Ok(Lit { maps: maps.map(|maps| (maps, uploaded.nodes())), ..lit })
        };
        let mut first = beams(fine, 0)?;
        let second = (scatters && scene.beams.views > 1).then(|| beams(coarse, 1)).transpose()?;
        let split = (scatters && scene.beams.adaptive)
            .then(|| Split::new(&mut first, block.limits, 2, scratch, backend))
            .transpose()?;
        lit = Some(Lights { first, second, split });
    }
    let mut list = List { block, passes: Vec::new() };
    if let Some(Lights { first, second, split }) = &lit {
        second.iter().for_each(|second| second.trace(&mut list, &bodies, &pictures.buffer));
        first.trace(&mut list, &bodies, &pictures.buffer);
        split.iter().for_each(|split| split.trace(&mut list, first, &bodies, &pictures.buffer));
        first.finish(&mut list, &bodies);
    }
    let multiple = scatters && shines && scene.beams.orders > 1;
    let cells = multiple
        .then(|| {
            // Smooth light has enough of the coarser beams.
            let beams: Vec<&Lit> = lit.iter().flat_map(Lights::fewest).collect();
            let buffers = [&pictures.buffer, &bodies.materials];
            exchange::list(&mut list, &beams, buffers, scene.beams.orders, scratch, backend)
        })
        .transpose()?;
    let lights = (&pictures.buffer, lit.as_ref(), cells.as_ref());
    let film = picture(&mut list, &bodies, lights, (scene, uploaded, needs), scratch, backend)?;
    let while_busy = |kernel: &'static Kernel, until: &'static Kernel| {
        let name = kernel.declaration.name;
        WhileBusy { kernel: name, passes: vec![name], until: Some(until.declaration.name) }
    };
    let Size { width, height } = block.picture;
    Ok(Frame {
        passes: PassList {
            passes: list.passes,
            while_busy: vec![
                while_busy(&kernels::beams_trace_light, &kernels::beams_store_beam),
                while_busy(&kernels::beams_map_faces, &kernels::beams_refract_maps),
                while_busy(&kernels::beams_trace_view, &kernels::beams_see),
                while_busy(&kernels::beams_find_light, &kernels::beams_see),
            ],
            ..PassList::default()
        },
        rays: [width, height],
        film,
        lights: lit,
    })
}

/// Lists the passes of the picture, and gives the film.
fn picture(
    list: &mut List,
    bodies: &Bodies,
    (pictures, lights, cells): (&Buffer, Option<&Lights>, Option<&Buffer>),
    (scene, uploaded, needs): (&Scene, &UploadedMesh, Needs),
    scratch: &mut Scratch,
    backend: &mut dyn Backend,
) -> Result<Buffer, Error> {
    let Bodies { nodes, corners, materials, looks } = bodies;
    let of_picture = list.block.picture;
    let Size { width, height } = of_picture;
    let picture = [width, height];
    let levels = list.block.sums.levels;
    let words = u64::from(pixels_below(of_picture, levels + 1)) * inscattered::SIZE as u64;
    let mut zeros = |label: &'static str, words: u64| scratch.zeros(label, words.max(1) * 4, backend);
    let rays = zeros("viewing rays", pitch(picture, pencil::SIZE))?;
    let sights = zeros("sights", pitch(picture, sight::SIZE))?;
    let searches = zeros("searches for light", pitch(picture, search::SIZE))?;
    let caustics = zeros("caustics", words)?;
    let shadows = zeros("shadows", words)?;
    let film = zeros("film", u64::from(width) * u64::from(height) * beam_pixel::SIZE as u64)?;
    for round in 0..scene.beams.views {
        let traced = [nodes, corners, materials, &rays];
        for _ in 0..passes_of_round(&list.block) {
            list.add(&kernels::beams_trace_view, picture, (0, round), &traced, 0);
        }
        if lights.is_some() && needs.surfaces {
            let sought = [&rays, nodes, corners, looks, materials, &searches];
            for _ in 0..uploaded.nodes().div_ceil(4 * STEPS as u32) {
                list.add(&kernels::beams_find_light, picture, (0, round), &sought, 0);
            }
        }
        let seen = [&rays, pictures, corners, looks, materials, &searches, &sights];
        list.add(&kernels::beams_see, picture, (0, round), &seen, 0);
        if let Some(cells) = cells {
            list.add(&kernels::beams_see_cells, picture, (0, round), &[&rays, cells, materials, &sights], 0);
        }
        if let Some(lights) = lights {
            for drawn in lights.drawn().filter(|_| needs.surfaces) {
                drawn.describe(list);
                let lights = [&rays, &drawn.beams, &drawn.bundles, corners, looks, materials, &sights];
                // The first round is the shadow, which the search for light finds sharper.
                for lit in 1..=drawn.limits.last {
                    list.block.limits.lit = lit;
                    list.add(&kernels::beams_light_surface, picture, (0, round), &lights, 0);
                }
            }
            if let Some(second) = lights.second.as_ref().filter(|_| round > 0) {
                second.describe(list);
                let gathered = [&rays, &second.beams, &second.bundles, materials, &sights];
                list.add(&kernels::beams_gather, picture, (0, round), &gathered, 0);
            }
        }
    }
    if let Some(lights) = lights.filter(|_| needs.scattering) {
        drawing::draw(
            list,
            &lights.drawn().collect::<Vec<_>>(),
            &Picture { sights: &sights, caustics: &caustics, shadows: &shadows },
            materials,
            scratch,
            backend,
        )?;
    }
    list.add(&kernels::beams_resolve, picture, (0, 0), &[&sights, &caustics, &shadows, &film], 0);
    Ok(film)
}
