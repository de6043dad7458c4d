//! The pass list of a frame (Algorithm 1).

use super::Buffers;
use super::cache::FrameCache;
use super::carrier::{BufferAllocator, Carrier, VolumeBuffers};
use super::kept::Carried;
use super::occupancy::{Occupancy, OccupancyQuery, VolumeRole};
use super::paging::{Residency, Swept, pools};
use super::projection;
use super::tables::tables_key;
use super::texels::Texels;
use super::uniforms::FramePlan;
use super::unoccluded::Unoccluded;
use super::uploaded::UploadedVolumes;
use super::voxels::bricks;
use super::wavefront::Wavefront;

use crate::backend::{Backend, BackendError, Buffer, Contents, PassList, WhileBusy, Write};
use crate::error::Error;
use crate::method::ChosenRays;
use crate::request::OutputRequest;
use crate::scene::{Removes, Scene};
use crate::subject::Volumes;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use vitrum_kernels::abi::record::{film, ray};
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::kernel::kernels;
use vitrum_kernels::sweep::follow_rays::STEPS;

/// How far rays are followed beyond the sweep, over the volume's depth. Steps are up to sixteen times shorter where η changes fast.
const FARTHEST: f64 = 32.0;

/// Uploads the remaining data of a frame and lists its passes.
pub(super) fn build(
    scene: &Scene,
    volumes: Volumes<'_>,
    plan: &mut FramePlan,
    (uploaded, map): (&UploadedVolumes, &Buffer),
    (request, chosen): (OutputRequest, Option<ChosenRays<'_>>),
    cache: &mut FrameCache,
    backend: &mut dyn Backend,
) -> Result<(PassList, Buffers, Option<Arc<Carried>>), Error> {
    let rendered = volumes;
    let shown = volumes.shown;
    let UploadedVolumes { ranges, second_ranges, .. } = uploaded;
    let made = Arc::clone(&plan.tables);
    let tables = &*made;
    let has_bodies = volumes.bodies.is_some();
    let is_lit = has_bodies || tables.densest > 0.0;
    // The largest optical depth of particles from plane to plane; bodies have no end of it.
    let densest = if has_bodies { f64::INFINITY } else { tables.densest };
    let densest = densest * plan.planes.distance * f64::from(plan.common().step.inverse_reference_length);
    let second = volumes.second().zip(second_ranges.as_ref());
    let role = if volumes.ior.is_none() { VolumeRole::Both } else { VolumeRole::Shown };
    let second_role = if has_bodies { VolumeRole::Bodies } else { VolumeRole::Bending };
    // A cut through matter of one index bends light, too.
    let cut = scene.crop.is_some() || scene.clip.iter().any(|clip| clip.removes == Removes::Everything);
    let blend = projection::blend(scene);
    let mut queries = vec![OccupancyQuery { volume: shown, ranges, tables, reach: plan.reach[0], role, cut, blend }];
    queries.extend(second.map(|(volume, ranges)| OccupancyQuery {
        volume,
        ranges,
        tables,
        reach: plan.reach[1],
        role: second_role,
        cut,
        blend,
    }));
    let key = (tables_key(scene), plan.reach, cut, blend);
    let Occupancy { buffer: occupancy, occupied } = cache.occupancy.get(key, || occupancy(&queries, backend))?.clone();
    let tables = cache.tables_buffer(scene, tables, backend)?;

    let first = plan.planes.first_visible;
    let wavefront = match plan.frame.filter(|_| plan.shadows) {
        Some(frame) => {
            let boxes: Vec<_> =
                queries.iter().flat_map(|query| query.looked_at(scene.shading.specular > 0.0)).collect();
            let frame = frame.for_particles(densest, mode::bends(plan.mode));
            let seen_by = (plan.common(), plan.mode);
            let largest = backend.largest_buffer();
            let wavefront = Wavefront::new(scene, rendered, (&plan.view, frame), seen_by, &boxes, largest)?;
            plan.see(wavefront.seen);
            Some(wavefront)
        }
        None => None,
    };
    let key = wavefront.as_ref().map(|wavefront| (tables_key(scene), wavefront.key()));
    let known = cache.light.find(key.as_ref(), request.light);
    let is_known = known.is_some();
    // Light that is there needs no voxels again.
    let light_planes = wavefront.as_ref().filter(|_| !is_known).map(|wavefront| wavefront.frame.planes);
    let offset = light_planes.map_or(0, |planes| planes.count);
    let (voxels, pools) = match &uploaded.voxels {
        Some(voxels) => (voxels.clone(), Vec::new()),
        None => {
            let earliest = if plan.shadows && wavefront.is_none() { 1 } else { first + 1 };
            let residencies = queries.iter().enumerate().map(|(volume, query)| {
                let of_light = light_planes.as_ref().zip(plan.light_sampling.get(volume));
                let light = of_light.map(|(planes, &sampling)| Swept { sampling, planes, first: 1, offset: 0 });
                let rays = Swept { sampling: plan.sampling[volume], planes: &plan.planes, first: earliest, offset };
                Residency::new(query, &light.into_iter().chain([rays]).collect::<Vec<_>>())
            });
            let pools = pools(&volumes.iter().collect::<Vec<_>>(), residencies.collect(), uploaded, backend)?;
            ([pools[0].buffer.clone(), pools[pools.len() - 1].buffer.clone()], pools)
        }
    };
    let [voxels, ior_voxels] = voxels;
    let volumes = VolumeBuffers { voxels, ior_voxels, occupancy, tables };
    let plan = &*plan;
    let mut buffers = BufferAllocator { plan, scratch: &mut cache.scratch, backend };
    let light: Box<dyn Carrier> = match &plan.frame {
        _ if !plan.shadows => Box::new(Unoccluded::new(&mut buffers)?),
        None => {
            let inside = || plan.visible_light(occupied.iter().map(|point| plan.view.point(*point)));
            let everywhere = request.light || plan.lights_surroundings || !plan.light_grid.follows_light();
            Box::new(Texels::new(&mut buffers, volumes.clone(), (!everywhere).then(inside))?)
        }
        Some(_) => Box::new(Unoccluded::new(&mut buffers)?),
    };
    let light_kept = &mut cache.light;
    let carried = match (wavefront, known) {
        (_, Some(carried)) => Some(carried),
        (Some(wavefront), None) => {
            light_kept.make_room(wavefront.bytes());
            let made = wavefront.buffers(&mut buffers)?;
            let carried = Arc::new(Carried { wavefront, buffers: made, is_done: AtomicBool::new(false) });
            if let Some(key) = key {
                light_kept.keep(key, Arc::clone(&carried));
            }
            Some(carried)
        }
        (None, None) => None,
    };
    // What viewing rays look the light up in.
    let looked_up =
        carried.as_ref().map_or_else(|| light.irradiance().clone(), |carried| carried.buffers.light.clone());
    let pixels = plan.rays;
    // A picture's rays and those that are chosen take turns.
    let turn = usize::from(chosen.is_some());
    let rays = buffers.planar(("rays", turn), pixels, ray::SIZE)?;
    let finished = buffers.planar(("film", turn), pixels, film::SIZE)?;
    let places = match chosen {
        Some(ChosenRays::Refined(refined)) => {
            buffers.backend.create("refined pixels", Contents::Bytes(bytemuck::cast_slice(refined.pixels)))?
        }
        Some(ChosenRays::Tile(tile)) => {
            buffers.backend.create("rays of a part", Contents::Bytes(bytemuck::cast_slice(&tile.words())))?
        }
        None => buffers.planar("no chosen rays", [1, 1], 1)?,
    };

    let (ray_kernel, ray_mode) = match blend {
        None => (kernels::sweep_propagate_rays.get(plan.format), plan.ray_mode()),
        Some(blend) => (kernels::sweep_project_rays.get(plan.format), blend),
    };
    // The first pass of each plane, of the wavefront's planes first.
    let (mut passes, mut starts) = match carried.as_deref() {
        Some(_) if is_known => (Vec::new(), Vec::new()),
        Some(Carried { wavefront, buffers, .. }) => wavefront.passes(buffers, &volumes, plan.format),
        None => (light.start(plan), Vec::new()),
    };
    let entries = carried.as_ref().filter(|_| !is_known).map(|carried| carried.wavefront.entries(&carried.buffers));
    passes.push(plan.initialize(&[&looked_up, &places, &rays]));
    starts.push(if carried.is_some() { passes.len() } else { 0 });
    let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = &volumes;
    let light_seen = blend.is_none().then_some(&looked_up);
    let bound: Vec<&Buffer> =
        [voxels, ior_voxels, occupancy, tables].into_iter().chain(light_seen).chain([&rays]).collect();
    // Rays on their way over planes whose irradiance is in the ring.
    let mut waiting = Vec::new();
    for plane in 1..plan.planes.count {
        starts.push(passes.len());
        if plane > first {
            waiting.push(plan.pass(ray_kernel, pixels, ray_mode, plane, &bound));
        }
        if waiting.len() == plan.ring().planes as usize {
            passes.append(&mut waiting);
        }
        if carried.is_none() {
            light.advance(plan, plane, &mut passes);
        }
    }
    passes.append(&mut waiting);
    let followers = kernels::sweep_follow_rays.get(plan.format);
    // Of streamed voxels only those around the latest planes are there.
    if scene.sweep.follow_turned_rays && mode::bends(plan.mode) && !plan.format.is_paged() {
        // The step of the planes within the volume.
        let volumes = [voxels, ior_voxels, occupancy, tables, &looked_up, &rays];
        // Where there are neither particles nor bodies, nothing on the way looks at the light.
        let chosen = if is_lit { plan.ray_mode() } else { mode::on_texels(plan.mode) };
        let follow = || plan.pass(followers, pixels, chosen, plan.planes.behind, &volumes);
        passes.extend((0..most_follow_passes(plan)).map(|_| follow()));
    }
    let last = plan.planes.count - 1;
    let coloring = &kernels::sweep_color_projected;
    passes.extend(blend.map(|blend| plan.pass(coloring, pixels, blend, last, &[tables, &rays])));
    let chosen = if mode::bends(plan.mode) { mode::CENTRAL } else { mode::STRAIGHT };
    passes.push(plan.pass(&kernels::sweep_resolve, pixels, chosen, last, &[&rays, map, &looked_up, &finished]));
    let (name, follow) = (ray_kernel.declaration.name, followers.declaration.name);
    let after = [follow, coloring.declaration.name, kernels::sweep_resolve.declaration.name];
    let mut writes: Vec<Write> = pools.into_iter().flat_map(|pool| pool.writes(&starts)).collect();
    writes.extend(entries);
    writes.sort_by_key(|write| write.before);
    // Light goes on to the last plane only where what is there is an output, too.
    let names = passes.iter().map(|pass| pass.kernel.declaration.name);
    let idle = names.filter(|other| carried.is_none() && !request.light && !after.contains(other));
    let ends: BTreeSet<&str> = idle.chain([name]).collect();
    let while_busy = vec![
        WhileBusy { kernel: name, passes: ends.into_iter().collect(), until: None },
        WhileBusy { kernel: follow, passes: vec![follow], until: None },
    ];
    let list = PassList { passes, writes, while_busy };
    let buffers = Buffers { irradiance: light.irradiance().clone(), film: finished };
    Ok((list, buffers, carried))
}

/// The most passes that follow rays beyond the sweep. A ray that goes as far as [`FARTHEST`] times across the volume, in steps as long as the
/// planes' distance, is done.
fn most_follow_passes(plan: &FramePlan) -> u32 {
    let [near, far] = plan.planes.volume_depths;
    ((far - near) / plan.planes.distance * FARTHEST / f64::from(STEPS)).ceil() as u32
}

/// Occupancy of the bricks of all volumes, one volume after the other, and points in the world whose convex hull encloses the bricks
/// that are not empty.
pub(super) fn occupancy(queries: &[OccupancyQuery], backend: &mut dyn Backend) -> Result<Occupancy, BackendError> {
    let counts: Vec<usize> =
        queries.iter().map(|query| bricks(query.volume).iter().map(|&n| n as usize).product()).collect();
    let bytes = counts.iter().sum::<usize>() as u64 * 4;
    let mut occupied = Vec::new();
    let buffer = backend.create(
        "occupancy",
        Contents::Written(bytes, &mut |mut words| {
            for (query, &count) in queries.iter().zip(&counts) {
                let (these, rest) = words.split_at_mut(count);
                if query.blend.is_some() {
                    query.write_bounds(these);
                } else {
                    query.write_distances(these);
                    occupied.extend(query.occupied(these));
                }
                words = rest;
            }
        }),
    )?;
    Ok(Occupancy { buffer, occupied: occupied.into() })
}
