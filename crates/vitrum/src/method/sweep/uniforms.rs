//! The plan of a frame, and its uniform block, from the scene.

use super::crop::{self, Extent};
use super::irradiance_ring::IrradianceRing;
use super::light::{LightGrid, direction};
use super::paging::Sampling;
use super::planes::Planes;
use super::tables::Tables;
use super::voxels::grid;
use super::wavefront::{self, Frame};
use super::window::VisibleLight;
use crate::error::Error;
use crate::method::view::environment::{EnvironmentMap, EnvironmentUniforms};
use crate::method::view::light::{direction_of_light, position};
use crate::method::view::receivers::{Receivers, plane};
use crate::method::view::{Bounds, View, vector};
use crate::method::{ChosenRays, RefinedPixels, lights};
use crate::scene::{Gradient, Integrator, Intensity, Interpolation, Removes, Rgb, Scene, Transport};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use glam::{DVec3, DVec4};
use std::sync::Arc;
use vitrum_io::Picture;
use vitrum_kernels::abi::camera::Camera;
use vitrum_kernels::abi::clip::{Clip, MOST_CLIPS};
use vitrum_kernels::abi::dispatch::{Dispatch, Region};
use vitrum_kernels::abi::format::Format;
use vitrum_kernels::abi::light as abi;
use vitrum_kernels::abi::receivers::{self, Receiver};
use vitrum_kernels::abi::sweep::{SweepUniforms, flag, mode};
use vitrum_kernels::abi::vector::{Size, Vec3};
use vitrum_kernels::abi::wavefront as abi_wavefront;
use vitrum_kernels::kernel::Window;

/// The smallest v_z / |v| of a ray that is followed, at 89° to the planes' normal. One step of an even more oblique ray would cross
/// dozens of voxels.
pub(super) const SMALLEST_COSINE: f32 = 0.017_452;

/// The plan of a frame: everything that is the same for all its planes.
pub(super) struct FramePlan {
    pub(super) planes: Planes,
    pub(super) light_grid: LightGrid,
    pub(super) rays: [u32; 2],
    /// Rays along each side of a pixel, where all pixels have the same.
    supersampling: u32,
    /// Rays along each side of the squares in which rays are listed; 0 where all rays are there.
    listed: u32,
    pub(super) tables: Arc<Tables>,
    pub(super) format: Format,
    /// The longest step, in voxels, over which a brick's range holds, in each volume.
    pub(super) reach: [u32; 2],
    /// [`mode`] of viewing rays.
    pub(super) mode: u32,
    /// Whether light is carried through the volume; else it is unoccluded everywhere.
    pub(super) shadows: bool,
    /// Positions of the look-ups between two planes among the voxels of the volume, and of the second one.
    pub(super) sampling: Vec<Sampling>,
    /// Positions of the look-ups between two planes of the wavefront that carries the light forward.
    pub(super) light_sampling: Vec<Sampling>,
    /// The frame of the wavefront that carries the light forward, if one does.
    pub(super) frame: Option<Frame>,
    pub(super) view: View,
    /// Whether light outside the volumes is read, too, by receivers.
    pub(super) lights_surroundings: bool,
    block: SweepUniforms,
    ring: IrradianceRing,
    angular_radius: f32,
}

fn receiver(plane: DVec4, color: Option<Rgb>) -> Receiver {
    Receiver { plane: plane.as_vec4().into(), color: color.map_or(Vec3::ZERO, Vec3::from) }
}

/// The longest step, in voxels, over which a brick's range holds: one and a half times the plane distance, at 48° to the planes'
/// normal.
fn reach(volume: &vitrum_io::Volume, distance: f64) -> u32 {
    let finest = volume.finest_spacing();
    (1.5 * distance / f64::from(finest)).ceil().clamp(1.0, 64.0) as u32
}

/// The geometry of a frame: view, light, planes and receivers.
struct Geometry {
    view: View,
    /// The unit direction in which light travels.
    towards: DVec3,
    planes: Planes,
    light_grid: LightGrid,
    receivers: Receivers,
    frame: Option<Frame>,
}

impl Geometry {
    fn new(scene: &Scene, volumes: Volumes<'_>) -> Result<Self, Error> {
        let bounds = Bounds::from(volumes.shown);
        let view = View::new(scene, bounds);
        let receivers = Receivers::new(scene, &view, bounds);
        if scene.sweep.light == Transport::Forward {
            let light = scene.first_light();
            let planes = Planes::within(scene, &view, volumes)?;
            let (frame, towards) = if let Some(position) = position(light, &view) {
                let frame = Frame::of_point(scene, &view, volumes, position)?;
                (frame, view.direction(frame.view.axes.z_axis))
            } else {
                let towards = direction_of_light(light, &view)?;
                (Frame::new(scene, &view, volumes, towards)?, towards)
            };
            let light_grid = LightGrid::of_frame(&frame, towards);
            return Ok(Self { view, towards, planes, light_grid, receivers, frame: Some(frame) });
        }
        // Lights of the scene are checked with their numbers before.
        let towards = direction(scene.first_light(), None, &view)?;
        let planes = Planes::new(scene, &view, volumes, &receivers, towards)?;
        let light_grid = LightGrid::new(scene, &view, volumes, &planes, towards)?;
        Ok(Self { view, towards, planes, light_grid, receivers, frame: None })
    }
}

/// Checks that planes and a light grid exist for a scene of these volumes, and that each of its clips is a plane.
///
/// # Errors
/// [`Error::Unrenderable`] where the light shines towards the camera, or planes or light texels would be too many.
pub(super) fn check(scene: &Scene, volumes: Volumes<'_>, map: Option<&Picture>) -> Result<(), Error> {
    let colored = volumes.shown.colors.is_some() || !scene.transfer.gradient.is_empty();
    if colored && volumes.ior.is_some() {
        return Err(Unrenderable::ColorsBeside { name: volumes.shown.name.clone() }.into());
    }
    let view = View::new(scene, volumes.shown);
    super::light::check(scene, Bounds::from(volumes.shown), map)?;
    for exposure in lights::sweep_exposures(scene, map, Bounds::from(volumes.shown)) {
        Geometry::new(&exposure.scene, volumes)?;
    }
    crop::check(scene, volumes)?;
    set_clips(&mut SweepUniforms::default(), scene, &view, volumes.shown)
}

impl FramePlan {
    /// The plan of a frame of `scene`, for volumes stored in `format`, on a backend whose buffers have at most `largest_buffer` bytes.
    pub(super) fn new(
        scene: &Scene,
        volumes: Volumes<'_>,
        tables: Arc<Tables>,
        map: &EnvironmentMap,
        (format, largest_buffer): (Format, u64),
    ) -> Result<Self, Error> {
        let (shown, second) = (volumes.shown, volumes.second());
        let Geometry { view, towards, planes, light_grid, receivers, frame } = Geometry::new(scene, volumes)?;
        let environment = EnvironmentUniforms::new(scene, map, &view);
        let supersampling = scene.film.supersampling;
        let rays = [scene.film.width * supersampling, scene.film.height * supersampling];
        let reach = [reach(shown, planes.distance), second.map_or(1, |volume| reach(volume, planes.distance))];
        let by_gradient = scene.shading.is_by_gradient(scene.first_light());
        let mode = match (tables.refracts, scene.sweep.gradient) {
            // Rays are straight in any mode where η is 1; where light is carried, this one has gradients.
            (false, _) if by_gradient && scene.first_light().shadows => mode::CENTRAL,
            (false, _) if by_gradient => mode::SHADED_BY_GRADIENT,
            (false, _) if tables.colors => mode::STRAIGHT,
            (false, _) if scene.first_light().shadows => mode::CLEAR_STRAIGHT,
            (false, _) => mode::UNSHADED,
            (true, Gradient::Central) if tables.colors => mode::CENTRAL,
            (true, Gradient::Central) => mode::CLEAR_CENTRAL,
            (true, Gradient::Chain) => mode::CHAIN,
        };
        let first_brick: u32 = super::voxels::bricks(shown).iter().product();
        crop::check(scene, volumes)?;
        let extent = |volume| Extent::new(scene, volumes, volume);
        let mut block = SweepUniforms {
            flags: flags(scene) | if tables.has_isosurfaces() { flag::ISOSURFACES } else { 0 },
            picture: Size { width: rays[0], height: rays[1] },
            sensor: Size { width: rays[0], height: rays[1] },
            grid: grid(shown, tables.shown, format, &view, extent(shown), (reach[0], 0)),
            light_grid: abi::LightGrid {
                width: light_grid.size[0],
                height: light_grid.size[1],
                corner_x: light_grid.corner.x as f32,
                corner_y: light_grid.corner.y as f32,
                texel: light_grid.texel as f32,
                inverse_texel: (1.0 / light_grid.texel) as f32,
                shear_x: light_grid.shear.x as f32,
                shear_y: light_grid.shear.y as f32,
                shear_depth: planes.depth(0) as f32,
            },
            // Adding 0 leaves no negative zero.
            light: abi::Light { direction: (towards.as_vec3() + glam::Vec3::ZERO).into(), ..abi::Light::default() },
            camera: Camera {
                half_width: view.half_size[0] as f32,
                half_height: view.half_size[1] as f32,
                start: planes.depth(planes.first_visible) as f32,
                orthographic: u32::from(view.orthographic),
            },
            receivers: receivers::Receivers {
                ground: receiver(receivers.ground, scene.ground.as_ref().map(|ground| ground.color)),
                wall: receiver(receivers.wall, scene.wall.as_ref().map(|wall| wall.color)),
            },
            ambient: environment.ambient,
            roughness: scene.shading.roughness,
            specular: scene.shading.specular,
            environment: environment.block,
            ..SweepUniforms::default()
        };
        block.ior_grid = second.map_or(block.grid, |volume| {
            grid(volume, tables.bending, format, &view, extent(volume), (reach[1], first_brick))
        });
        let nearest = u32::from(scene.volume.interpolation == Interpolation::Nearest);
        (block.grid.nearest, block.ior_grid.nearest) = (nearest, nearest);
        let steepest = steepest(&view, &tables, std::iter::once(towards.as_vec3().to_array()));
        let sampled = std::iter::once(shown).chain(second);
        let aside = frame.as_ref().map_or(0.0, Frame::reach);
        let sampling =
            sampled.clone().map(|volume| Sampling::new(scene, volume, &view, &planes, (steepest, aside))).collect();
        let of_frame = |frame: &Frame| {
            let steepest = if tables.refracts { 1.0 / f64::from(SMALLEST_COSINE) } else { frame.steepest() };
            sampled.map(|volume| Sampling::new(scene, volume, &frame.view, &frame.planes, (steepest, 0.0))).collect()
        };
        let light_sampling = frame.as_ref().map_or_else(Vec::new, of_frame);
        block.light.color = initial_light(scene, &block);
        if let Some(frame) = &frame {
            block.wavefront = wavefront::unoccluded(&view, frame);
        }
        if frame.is_none() && light_grid.follows_light() {
            [block.light_grid.shear_x, block.light_grid.shear_y] = exact_shear(&block.light);
        }
        block.step.inverse_reference_length = 1.0 / scene.transfer.reference_length_in(shown);
        block.step.smallest_cosine = SMALLEST_COSINE;
        set_clips(&mut block, scene, &view, shown)?;
        // Streamed voxels go as soon as they can, and irradiance that never changes needs to be there but once.
        let several = scene.first_light().shadows && !format.is_paged() && frame.is_none();
        let ring = if several {
            IrradianceRing::new(light_grid.size, largest_buffer)
        } else {
            IrradianceRing::one(light_grid.size)
        };
        Ok(Self {
            ring,
            planes,
            light_grid,
            rays,
            supersampling,
            listed: 0,
            tables,
            format,
            sampling,
            light_sampling,
            reach,
            mode,
            shadows: scene.first_light().shadows,
            frame,
            view,
            lights_surroundings: scene.ground.is_some() || scene.wall.is_some(),
            block,
            angular_radius: scene.first_light().disc(),
        })
    }

    /// The region of the light that viewing rays can read when they read it inside the convex hull of `points` alone (view frame).
    pub(super) fn visible_light(&self, points: impl Iterator<Item = DVec3>) -> VisibleLight {
        self.light_grid.visible_light(points, &self.planes)
    }

    /// The texels that are carried on to plane `plane`, if viewing rays read light in the region `visible` alone.
    pub(super) fn window(&self, visible: &VisibleLight, plane: u32) -> Window {
        let filter =
            if self.is_soft() { self.light_grid.filter_radius(self.angular_radius, &self.planes, plane) } else { 0.0 };
        self.light_grid.window(visible, &self.planes, plane, filter)
    }

    /// The block of a pass over a part of `size` invocations that leads to plane `index`.
    pub(super) fn block(&self, size: [u32; 2], window: Window, mode: u32, index: u32) -> SweepUniforms {
        let mut block = self.block;
        block.dispatch = Dispatch { width: size[0], height: size[1], mode };
        block.region = Region {
            first_column: window.first[0],
            first_row: window.first[1],
            end_column: window.end[0],
            end_row: window.end[1],
        };
        block.irradiance_start = self.ring.start(index.saturating_sub(1)) as u32;
        block.step.behind = self.planes.depth(index.saturating_sub(1)) as f32;
        block.step.ahead = self.planes.depth(index) as f32;
        block.step.distance = self.planes.step(index) as f32;
        block.step.alike = self.planes.alike(index) as f32;
        if self.planes.is_behind(index) {
            block.flags |= flag::BEHIND_VOLUME;
        }
        if index + self.planes.alike(index) + 1 == self.planes.count {
            block.flags |= flag::LAST_STRETCH;
        }
        let [first, second, third] =
            self.light_grid.taps(self.angular_radius, &self.planes, index).map(|tap| tap.as_vec2());
        block.taps = abi::Taps {
            first_x: first.x,
            first_y: first.y,
            second_x: second.x,
            second_y: second.y,
            third_x: third.x,
            third_y: third.y,
        };
        block
    }

    /// The plane irradiance (or radiance, see [`flag::STORE_RADIANCE`]) of unoccluded light.
    pub(super) fn unoccluded_irradiance(&self) -> [f32; 3] {
        let Vec3 { x, y, z } = self.block.light.color;
        [x, y, z]
    }

    /// Tells viewing rays of the wavefront whose light they look up.
    pub(super) fn see(&mut self, seen: abi_wavefront::Wavefront) {
        self.block.wavefront = seen;
        self.block.flags |= flag::FORWARD;
    }

    /// Has some rays alone.
    pub(super) fn choose(&mut self, chosen: ChosenRays<'_>) {
        match chosen {
            ChosenRays::Refined(refined) => self.refine(refined),
            ChosenRays::Tile(tile) => {
                self.rays = tile.size;
                // A pixel for each ray.
                self.listed = 1;
            }
        }
        self.block.picture = Size { width: self.rays[0], height: self.rays[1] };
    }

    /// Has the rays of some pixels alone.
    fn refine(&mut self, refined: RefinedPixels<'_>) {
        let Size { width, height } = self.block.sensor;
        let sensor = [width, height].map(|rays| rays / self.supersampling * refined.edge);
        self.rays = refined.rays();
        self.block.sensor = Size { width: sensor[0], height: sensor[1] };
        (self.listed, self.block.refined) = (refined.edge, refined.edge);
    }

    /// Rays along each side of the squares in which rays are listed; 0 where all rays are there.
    pub(super) fn listed(&self) -> u32 {
        self.listed
    }

    /// The uniform block of viewing rays, as far as it is the same for all planes.
    pub(super) fn common(&self) -> &SweepUniforms {
        &self.block
    }

    /// [`mode`] of viewing rays.
    pub(super) fn ray_mode(&self) -> u32 {
        if self.frame.is_some() || mode::is_unoccluded(self.mode) { self.mode } else { mode::on_texels(self.mode) }
    }

    /// The buffer of the latest planes' irradiance.
    pub(super) fn ring(&self) -> IrradianceRing {
        self.ring
    }

    /// Whether the light has an angular radius, so that its shadows are filtered.
    pub(super) fn is_soft(&self) -> bool {
        self.angular_radius > 0.0
    }
}

fn flags(scene: &Scene) -> u32 {
    let mut flags = 0;
    if scene.sweep.integrator == Integrator::Euler {
        flags |= flag::EULER;
    }
    flags |= match scene.sweep.intensity {
        // A wavefront has no intensity to correct.
        Intensity::Jacobian if scene.sweep.light == Transport::Forward => flag::STORE_RADIANCE,
        Intensity::Jacobian => 0,
        Intensity::Paper => flag::PAPER_INTENSITY | flag::STORE_RADIANCE,
        Intensity::None => flag::NO_INTENSITY | flag::STORE_RADIANCE,
    };
    if !scene.clip.is_empty() {
        flags |= flag::CLIP;
    }
    if scene.shading.is_by_gradient(scene.first_light()) {
        flags |= flag::SHADED_BY_GRADIENT;
    }
    if scene.sweep.empty_space_skipping {
        flags |= flag::SKIP_EMPTY;
    }
    flags
}

/// The steepest slope of viewing rays and light from plane to plane, distance across over depth; `directions` has the directions in
/// which the light starts.
fn steepest(view: &View, tables: &Tables, directions: impl Iterator<Item = [f32; 3]>) -> f64 {
    let bent = if tables.refracts { 1.0 / f64::from(SMALLEST_COSINE) } else { 0.0 };
    let seen = if view.orthographic { 0.0 } else { libm::hypot(view.half_size[0], view.half_size[1]) };
    let slopes =
        directions.map(|[x, y, z]| libm::hypot(f64::from(x), f64::from(y)) / f64::from(z.max(SMALLEST_COSINE)));
    slopes.fold(bent.max(seen), f64::max)
}

/// The grid's shear, rounded as kernels round the light's slope: unrefracted light then stays exactly on its texel.
fn exact_shear(light: &abi::Light) -> [f32; 2] {
    let v = light.direction;
    let inverse = 1.0 / v.z;
    [v.x * inverse, v.y * inverse]
}

/// Irradiance of unoccluded light on a plane, or its radiance where the kernels store radiance.
fn initial_light(scene: &Scene, block: &SweepUniforms) -> Vec3 {
    let stored = if block.flags & flag::STORE_RADIANCE != 0 { 1.0 } else { block.light.direction.z };
    let light = scene.first_light();
    let factor = light.intensity * stored;
    light.color.map(|channel| channel * factor).into()
}

pub(super) fn set_clips(
    block: &mut SweepUniforms,
    scene: &Scene,
    view: &View,
    volume: &vitrum_io::Volume,
) -> Result<(), Error> {
    if scene.clip.len() > MOST_CLIPS {
        return Err(Unrenderable::TooManyClips { count: scene.clip.len(), limit: MOST_CLIPS }.into());
    }
    let (centre, _) = Bounds::from(volume).sphere();
    let mut clips = [Clip::default(); MOST_CLIPS];
    for (slot, clip) in scene.clip.iter().enumerate() {
        let normal = vector(clip.normal)
            .try_normalize()
            .ok_or_else(|| Unrenderable::NoDirection { key: format!("clip.{slot}.normal") })?;
        clips[slot] = Clip {
            plane: plane(view, normal, centre + normal * f64::from(clip.offset)).as_vec4().into(),
            everything: u32::from(clip.removes == Removes::Everything),
        };
    }
    [block.clip_0, block.clip_1, block.clip_2, block.clip_3] = clips;
    Ok(())
}
