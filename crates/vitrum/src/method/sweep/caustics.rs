//! The light that the clear bodies of a mesh send to ground and wall, for methods that follow viewing rays in another way: a sweep's wavefront through the
//! bodies' volumes, without the light inside them, which nobody looks at.

use super::cache::FrameCache;
use super::carrier::{BufferAllocator, VolumeBuffers};
use super::kept::Key;
use super::mesh_volumes::{MeshVolumes, Part};
use super::occupancy::{OccupancyQuery, VolumeRole};
use super::passes::occupancy;
use super::tables::tables_key;
use super::uniforms::FramePlan;
use super::wavefront::{Wavefront, check_point};
use crate::assets::Assets;
use crate::backend::{PassList, ReadBack as _};
use crate::error::Error;
use crate::method::cache::Scratch;
use crate::method::view::environment::EnvironmentMap;
use crate::method::view::light::{axis, direction_of_light, position};
use crate::method::voxelize::Grid;
use crate::method::{Bounds, Tools, View};
use crate::request::{Progress, Stage};
use crate::scene::{
    Attachment, Camera, Environment, Film, Ground, Intensity, Light, LightKind, Scene, Shading, Sweep, Transport, Wall,
};
use glam::DVec3;
use std::sync::Arc;
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::abi::vector::Affine;
use vitrum_kernels::abi::wavefront as abi;

/// The most bytes of light that is kept, unless one light alone has more.
const MOST_BYTES: u64 = 256 << 20;

/// The light on ground and wall, over unoccluded light.
pub(in crate::method) struct Caustics {
    /// The wavefront that carried it; its maps begin at word 0.
    wavefront: abi::Wavefront,
    /// The wavefront's frame.
    view: View,
    /// The maps.
    pub(in crate::method) shares: Vec<f32>,
}

impl Caustics {
    /// The wavefront for kernels that look at positions in the voxels of `grid`; the maps begin at the first word of a buffer.
    pub(in crate::method) fn seen_from(&self, grid: Grid) -> abi::Wavefront {
        let origin = DVec3::from_array(grid.origin) - self.view.eye;
        let row = |axis: usize| {
            let along = self.view.axes.col(axis);
            Affine::from((along * grid.voxel_size).extend(along.dot(origin)).as_vec4())
        };
        abi::Wavefront { row_x: row(0), row_y: row(1), row_z: row(2), ..self.wavefront }
    }

    fn bytes(&self) -> u64 {
        self.shares.len() as u64 * 4
    }
}

/// The volumes of a mesh's clear bodies, and the light of several sources through them, in the order in which it was carried.
#[derive(Default)]
pub(in crate::method) struct CausticsCache {
    bodies: Option<MeshVolumes>,
    frame: FrameCache,
    lights: Vec<(Key, Arc<Caustics>)>,
}

/// A light with its place and direction in the world, white and of intensity 1.
fn in_world(light: &Light, view: &View, bounds: Bounds) -> Result<Light, Error> {
    let numbers = |v: DVec3| v.as_vec3().to_array();
    let direction = match light.kind {
        LightKind::Distant => Some(view.axes * direction_of_light(light, view)?),
        LightKind::Spot => Some(axis(light, view, bounds)?),
        LightKind::Point => None,
    };
    Ok(Light {
        attachment: Some(Attachment::World),
        direction: direction.map(numbers),
        position: position(light, view).map(numbers),
        color: [1.0; 3],
        intensity: 1.0,
        ..light.clone()
    })
}

/// A scene with all that light on receivers depends on, and nothing else. `light` is its light in the world.
fn bare(scene: &Scene, light: Light) -> Scene {
    let Scene { ground, wall, camera, sweep, .. } = scene;
    Scene {
        ground: ground.as_ref().map(|ground| Ground { height: ground.height, ..Ground::default() }),
        wall: wall.as_ref().map(|wall| Wall { color: Wall::default().color, ..wall.clone() }),
        camera: Camera { up: camera.up, ..Camera::default() },
        sweep: Sweep { light: Transport::Forward, intensity: Intensity::Jacobian, refraction: true, ..sweep.clone() },
        light: vec![light],
        environment: Environment::default(),
        shading: Shading::default(),
        film: Film::default(),
        ..scene.clone()
    }
}

impl CausticsCache {
    /// The light of a scene's first light on its receivers; `None` where no wavefront can carry it: from a place next to the bodies, or through more voxels
    /// than the backend holds.
    ///
    /// # Errors
    /// As [`MeshVolumes::new`]; if the backend fails.
    pub(in crate::method) fn of(
        &mut self,
        scene: &Scene,
        assets: &Assets,
        tools: &mut Tools<'_>,
    ) -> Result<Option<Arc<Caustics>>, Error> {
        let Some(mesh) = assets.subject.mesh() else { return Ok(None) };
        let bounds = Bounds::from(mesh);
        let light = in_world(scene.first_light(), &View::new(scene, bounds), bounds)?;
        let kept = match self.bodies.take() {
            Some(made) if made.fits(scene, assets)? => Some(made),
            _ => None,
        };
        if kept.is_none() {
            *self = Self::default();
        }
        let bodies = match kept {
            Some(bodies) => bodies,
            None => MeshVolumes::new(scene, assets, Part::Clear, tools)?,
        };
        let bodies = self.bodies.insert(bodies);
        let scene = &bare(&bodies.scene(scene, assets)?, light);
        let volumes = bodies.volumes();
        let corners: Vec<DVec3> = super::crop::corners(scene, volumes).collect();
        let view = View::new(scene, Bounds::from(volumes.shown));
        if position(scene.first_light(), &view).is_some_and(|at| check_point(at, &corners, view.up, None).is_err()) {
            return Ok(None);
        }
        let frame = &mut self.frame;
        let uploaded = frame.uploaded(volumes, tools.backend)?;
        let Some([voxels, ior_voxels]) = uploaded.voxels.clone() else { return Ok(None) };
        let tables = frame.tables(scene, volumes);
        let largest = tools.backend.largest_buffer();
        let no_map = EnvironmentMap::new(&scene.environment, None);
        let plan = FramePlan::new(scene, volumes, Arc::clone(&tables), &no_map, (uploaded.format, largest))?;
        let Some(of_light) = plan.frame else { return Ok(None) };
        let of_light = of_light.for_particles(0.0, mode::bends(plan.mode));
        let seen_by = (plan.common(), plan.mode);
        let wavefront = Wavefront::new(scene, volumes, (&plan.view, of_light), seen_by, &[], largest)?;
        let key = (tables_key(scene), wavefront.key());
        if let Some((_, found)) = self.lights.iter().find(|(known, _)| *known == key) {
            return Ok(Some(Arc::clone(found)));
        }
        let query = |volume, ranges, reach, role| OccupancyQuery {
            volume,
            ranges,
            tables: &tables,
            reach,
            role,
            cut: false,
            blend: None,
        };
        let second = volumes.ior.zip(uploaded.second_ranges.as_ref());
        let role = if second.is_none() { VolumeRole::Both } else { VolumeRole::Shown };
        let mut queries = vec![query(volumes.shown, &uploaded.ranges, plan.reach[0], role)];
        queries.extend(second.map(|(volume, ranges)| query(volume, ranges, plan.reach[1], VolumeRole::Bending)));
        let of_tables = (tables_key(scene), plan.reach, false, None);
        let occupancy = frame.occupancy.get(of_tables, || occupancy(&queries, tools.backend))?.buffer.clone();
        let tables = frame.tables_buffer(scene, &tables, tools.backend)?;
        let of_volumes = VolumeBuffers { voxels, ior_voxels, occupancy, tables };
        // Of all that, the maps alone are kept.
        let mut scratch = Scratch::default();
        let mut allocator = BufferAllocator { plan: &plan, scratch: &mut scratch, backend: tools.backend };
        let buffers = wavefront.buffers(&mut allocator)?;
        let (passes, _) = wavefront.passes(&buffers, &of_volumes, plan.format);
        let (progress, total) = (&mut *tools.progress, passes.len() as u64);
        let list = PassList { passes, ..PassList::default() };
        tools.backend.run(&list, &mut |done| progress(Progress { stage: Stage::Shadow, done: done as u64, total }))?;
        let maps = wavefront.maps();
        let shares = tools.backend.read_part(&buffers.light, maps.start * 4..maps.end * 4)?;
        let first = maps.start as u32;
        let seen = wavefront.seen;
        let map = abi::ReceiverMap { ground: seen.map.ground - first, wall: seen.map.wall - first, ..seen.map };
        let seen = abi::Wavefront { map, ..seen };
        let made = Arc::new(Caustics { wavefront: seen, view: wavefront.frame.view, shares });
        self.keep(key, &made);
        Ok(Some(made))
    }

    /// Keeps the light of that key; lights that were carried first go first.
    fn keep(&mut self, key: Key, made: &Arc<Caustics>) {
        let mut total = made.bytes() + self.lights.iter().map(|(_, light)| light.bytes()).sum::<u64>();
        self.lights.retain(|(_, light)| {
            let stays = total <= MOST_BYTES;
            total -= if stays { 0 } else { light.bytes() };
            stays
        });
        self.lights.push((key, Arc::clone(made)));
    }
}
