//! The pass list of a frame of beams.

use super::drawing::{self, Picture};
use super::exchange;
use super::lattice::{coarser, lattice};
use super::maps::{self, Maps};
use super::medium::MediumCache;
use super::of_triangles;
use super::split::Split;
use super::uniforms::{self, Surroundings};
use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList, ReadBack as _, START_ALIGNMENT, WhileBusy};
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
use bytemuck::bytes_of;
use vitrum_kernels::abi::beams::{BeamsUniforms, Lattice, Limits, flag, part};
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::record::{beam, beam_pixel, bundle, inscattered, pencil, search, sight};
use vitrum_kernels::abi::vector::Size;
use vitrum_kernels::abi::voxels::STEPS;
use vitrum_kernels::beams::pyramid::pixels_below;
use vitrum_kernels::beams::tree::{ROW, rows};
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// Nodes of a tree on a straight piece of a ray, several times as many as usual.
const NODES: u32 = 8 * STEPS as u32;

/// Rays along each edge of the lattice whose beams are seen behind surfaces, at most.
const VIEW_RAYS: u32 = 32;

/// Columns of a dispatch at most: devices have a limit of 65,535 workgroups along each axis.
const COLUMNS: u32 = 1 << 18;

/// A frame of beams that is ready to run.
pub struct Frame {
    /// The passes.
    pub passes: PassList,
    /// Viewing rays across and down.
    pub rays: [u32; 2],
    pub(super) film: Buffer,
    lights: Option<Lights>,
}

impl Frame {
    /// The pencils of light after the passes have run: planar records as [`pencil`] describes, one for each texel of the lattice. None if no light
    /// casts shadows.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn pencils(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        self.lights.as_ref().map_or(Ok(Vec::new()), |lights| backend.read_all(&lights.first.pencils))
    }

    /// The maps of the bodies as the light sees them, after the passes have run: planar records as [`faces`](vitrum_kernels::abi::record::faces) describes,
    /// one for each texel of the lattice. None if no light casts shadows, or goes through triangles.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn maps(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let maps = self.lights.as_ref().and_then(|lights| lights.first.maps.as_ref());
        maps.map_or(Ok(Vec::new()), |(maps, _)| backend.read_all(&maps.faces))
    }
    /// The beams that are drawn after the passes have run, of the light's lattice and of the one whose texels are parts of its split ones.
    /// None if no light casts shadows.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn beams(&self, backend: &mut dyn Backend) -> Result<Vec<Drawn>, BackendError> {
        let of = |lit: &Lit| {
            let records = backend.read_all(&lit.beams)?;
            Ok(Drawn { count: lit.lattice.count, pitch: lit.limits.pitch as usize, records })
        };
        self.lights.iter().flat_map(Lights::drawn).map(of).collect()
    }

    /// Records of [`curved`](vitrum_kernels::abi::record::curved) after the passes have run, one for each texel of the lattice. None if texels are not
    /// split.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn curved(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let split = self.lights.as_ref().and_then(|lights| lights.split.as_ref());
        split.map_or(Ok(Vec::new()), |split| backend.read_all(&split.curved))
    }
}

/// Beams of a lattice.
pub struct Drawn {
    /// Texels along each edge.
    pub count: u32,
    /// Floats from the records of one round to those of the next.
    pub pitch: usize,
    /// Planar records of [`beam`], one for each texel, round by round: the first one has the shadow.
    pub records: Vec<f32>,
}

/// A list of passes that is being written.
pub(super) struct List {
    pub(super) block: BeamsUniforms,
    passes: Vec<Pass>,
}

impl List {
    /// Adds a pass over `size` invocations, in a round; records are written from word `start` on.
    pub(super) fn add(
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
        for first in (0..width).step_by(COLUMNS as usize) {
            self.passes.push(Pass {
                kernel,
                uniforms: bytes_of(&block).to_vec(),
                buffers: buffers.iter().map(|&buffer| buffer.clone()).collect(),
                width,
                height,
                start,
                window: Window { first: [first, 0], end: [width.min(first + COLUMNS), height] },
            });
        }
    }
}

/// The bodies as rays run through them.
pub(super) struct Bodies {
    pub(super) nodes: Buffer,
    pub(super) corners: Buffer,
    pub(super) materials: Buffer,
    looks: Buffer,
}

/// The beams of a lattice of rays, in rounds: the first one has the shadow.
pub(super) struct Lit {
    pub(super) lattice: Lattice,
    pub(super) pencils: Buffer,
    pub(super) beams: Buffer,
    bundles: Buffer,
    pub(super) limits: Limits,
    /// The maps that light is traced by, and the nodes of the tree that they are made from; none if light goes through triangles.
    maps: Option<(Maps, u32)>,
    /// Whether beams go once all are traced.
    pub(super) loses_beams: bool,
}

/// Floats from one round's records to those of the next, for `size` records of `components`: a pass's records start at such a multiple.
pub(super) fn pitch([width, height]: [u32; 2], components: usize) -> u64 {
    (u64::from(width) * u64::from(height) * components as u64).next_multiple_of(START_ALIGNMENT)
}

impl Lit {
    /// Buffers for the beams of a lattice, number `number` of the frame's.
    pub(super) fn new(
        lattice: Lattice,
        rounds: u32,
        limits: Limits,
        number: usize,
        scratch: &mut Scratch,
        backend: &mut dyn Backend,
    ) -> Result<Self, BackendError> {
        let texels = [lattice.count; 2];
        let [beams, bundles] = [pitch(texels, beam::SIZE), pitch(Self::tree(&lattice), bundle::SIZE)];
        let mut zeros = |label, words: u64| scratch.zeros((label, number), words * 4, backend);
        Ok(Self {
            lattice,
            pencils: zeros("pencils of light", u64::from(lattice.count).pow(2) * pencil::SIZE as u64)?,
            beams: zeros("beams", beams * u64::from(rounds))?,
            bundles: zeros("bundles of beams", bundles * u64::from(rounds))?,
            limits: Limits { pitch: beams as u32, bundle_pitch: bundles as u32, last: rounds - 1, ..limits },
            maps: None,
            loses_beams: false,
        })
    }

    /// Rows of the nodes of a round's tree.
    fn tree(lattice: &Lattice) -> [u32; 2] {
        [ROW, rows(lattice.count)]
    }

    /// Lists the passes in which pencils of light become beams, and beams bundles, unless some of them are to go before.
    pub(super) fn trace(&self, list: &mut List, bodies: &Bodies, pictures: &Buffer) {
        self.describe(list);
        let texels = [self.lattice.count; 2];
        if let Some((maps, nodes)) = &self.maps {
            maps.make(list, bodies, *nodes);
        }
        for round in 0..=self.limits.last {
            self.follow(list, bodies, round);
            let mode = if round == 0 { part::SHADOW } else { part::CAUSTIC };
            let start = u64::from(self.limits.pitch) * u64::from(round);
            let stored = [&self.pencils, pictures, &bodies.materials, &self.beams];
            list.add(&kernels::beams_store_beam, texels, (mode, round), &stored, start);
            if !self.loses_beams {
                self.bound(list, round);
            }
        }
    }

    /// Lists the pass in which the beams of a round become bundles.
    pub(super) fn bound(&self, list: &mut List, round: u32) {
        let start = u64::from(self.limits.bundle_pitch) * u64::from(round);
        let bound = [&self.beams, &self.bundles];
        list.add(&kernels::beams_bound_beams, Self::tree(&self.lattice), (0, round), &bound, start);
    }

    /// Lists the passes that follow pencils to the end of the last piece, so that the fate of its light is known. They leave pencils without work: no
    /// other lattice is traced behind them.
    fn finish(&self, list: &mut List, bodies: &Bodies) {
        self.describe(list);
        self.follow(list, bodies, self.limits.last + 1);
    }

    /// Lists the passes that follow pencils to the piece of a round.
    fn follow(&self, list: &mut List, bodies: &Bodies, round: u32) {
        if let Some((maps, _)) = &self.maps {
            maps.trace(list, bodies, &self.pencils, round);
            return;
        }
        let traced = [&bodies.nodes, &bodies.corners, &bodies.materials, &self.pencils];
        for _ in 0..passes_of_round(&list.block) {
            list.add(&kernels::beams_trace_light, [self.lattice.count; 2], (0, round), &traced, 0);
        }
    }

    /// Makes the passes that follow read these beams.
    pub(super) fn describe(&self, list: &mut List) {
        list.block.lattice = self.lattice;
        list.block.limits = self.limits;
    }
}

/// The beams of a frame's light.
struct Lights {
    /// Those that are drawn and light surfaces.
    first: Lit,
    /// Those that are seen behind surfaces.
    second: Option<Lit>,
    /// Those that are drawn in place of some of the first ones.
    split: Option<Split>,
}

impl Lights {
    /// The beams that are drawn and light surfaces.
    fn drawn(&self) -> impl Iterator<Item = &Lit> {
        std::iter::once(&self.first).chain(self.split.as_ref().map(|split| &split.lit))
    }

    /// All light of the frame in as few beams as there are.
    fn fewest(&self) -> Vec<&Lit> {
        self.second.as_ref().map_or_else(|| self.drawn().collect(), |second| vec![second])
    }
}

/// The passes in which pencils get to their next piece in air, at most.
fn passes_of_round(block: &BeamsUniforms) -> u32 {
    ((block.limits.bounces + 1) * NODES).div_ceil(4 * STEPS as u32)
}

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
        environment: EnvironmentUniforms::new(&scene.environment, &pictures.environment, &view),
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
