//! The transparent shadow map of a mesh (Chang et al. 2010, §3).

mod casters;
pub(in crate::method) mod frame;
mod passes;
mod resolution;
pub(in crate::method) mod source;

use super::bodies::Body;
use crate::assets::Assets;
use crate::backend::{Buffer, Contents};
use crate::error::Error;
use crate::method::Tools;
use crate::method::voxelize::Grid;
use crate::method::{Bounds, View};
use crate::scene::{Coefficient, Scene};
use crate::unrenderable::Unrenderable;
use casters::Caster;
use frame::Frame;
use glam::{DVec3, DVec4};
use source::Source;
use vitrum_kernels::abi::shadow::Spread;
use vitrum_kernels::abi::vector::{Affine, Counts};
pub(super) use vitrum_kernels::abi::voxels::ShadowMap as Lookup;
use vitrum_kernels::shadow::look_up::MOST_COLUMNS;

/// The key of a shadow map: all values on which it depends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cast {
    source: Source,
    /// Voxels along the longest edge of the mesh's box as the light sees it; `None` for as many as the picture needs.
    resolution: Option<u32>,
    /// Pixels along the longer side of the picture, where the resolution depends on them.
    pixels: u32,
    coefficient: Coefficient,
    absorption: f32,
    /// The absorption of each body.
    casters: Vec<Caster>,
    /// Words before the shadow map in its buffer: the maps of the light on receivers. None where receivers look the shadow map up.
    before: u32,
}

/// A transparent shadow map on a backend: the transmittance from the light to each voxel.
pub(super) struct ShadowMap {
    cast: Cast,
    /// Frame of the light.
    frame: Frame,
    /// Grid of the voxels, in the frame of the light.
    grid: Grid,
    channels: u32,
    /// The first word of the map of opaque bodies alone, and its channels.
    opaque: [u32; 2],
    pub(super) buffer: Buffer,
}

impl Cast {
    /// The key of a scene's shadow map; `None` for a scene without visible shadows. `before` is the number of words of the maps of the light on receivers,
    /// which then look up opaque bodies alone; 0 if there are none.
    ///
    /// # Errors
    /// If the light has no direction.
    pub(super) fn of(scene: &Scene, assets: &Assets, bodies: &[Body], before: u32) -> Result<Option<Self>, Error> {
        let receives = before == 0 && (scene.ground.is_some() || scene.wall.is_some());
        let shows = bodies.iter().any(|body| body.opaque) || receives;
        let Some(mesh) = assets.subject.mesh().filter(|_| shows && scene.first_light().shadows) else {
            return Ok(None);
        };
        let view = View::new(scene, mesh);
        let casters = Caster::all(bodies, mesh, scene);
        if casters.iter().all(Caster::is_nothing) {
            return Ok(None);
        }
        Ok(Some(Self {
            source: Source::of(scene.first_light(), &view, Bounds::from(mesh))?,
            resolution: scene.shadow.resolution,
            pixels: if scene.shadow.resolution.is_some() { 0 } else { scene.film.width.max(scene.film.height) },
            coefficient: scene.shadow.coefficient,
            absorption: scene.shadow.optical_depth,
            casters,
            before,
        }))
    }

    /// The casters of a shadow map of opaque bodies alone, if it is another than that of all bodies: `None` where no other body casts a shadow.
    fn opaque(&self) -> Option<Vec<Caster>> {
        let is_solid = |caster: &Caster| matches!(caster, Caster::Solid(_)) && !caster.is_nothing();
        let kept = |caster: &Caster| if is_solid(caster) { Caster::Solid([0.0; 3]) } else { caster.clone() };
        self.casters.iter().any(is_solid).then(|| self.casters.iter().map(kept).collect())
    }
}

impl ShadowMap {
    /// Makes a shadow map.
    ///
    /// # Errors
    /// If the light stands in the mesh's box, the map is too large for the backend, or the backend fails.
    pub(super) fn new(cast: Cast, bodies: &[Body], tools: &mut Tools<'_>) -> Result<Self, Error> {
        let turned = casters::Turned::new(bodies, &cast.source)?;
        let grid = resolution::grid(&cast, &turned)?;
        let is_colored = cast.coefficient == Coefficient::PerTriangle && cast.casters.iter().any(Caster::is_colored);
        let channels = if is_colored { 3 } else { 1 };
        let words = passes::words(grid, channels);
        let others = cast.opaque().filter(|_| cast.before > 0).map(|casters| Cast { casters, ..cast.clone() });
        let of_opaque = others.as_ref().map_or(0, |_| passes::words(grid, 1));
        let all = u64::from(cast.before) + words + of_opaque;
        // Kernels count bytes by a signed number.
        if all > i32::MAX as u64 / 4 {
            return Err(Unrenderable::ShadowMapTooLarge { dimensions: grid.dimensions, bytes: all * 4 }.into());
        }
        let buffer = tools.backend.create("shadow map", Contents::Zeros(all * 4))?;
        passes::run(&cast, &turned, grid, channels, (&buffer, cast.before), tools)?;
        let mut opaque = [cast.before, channels];
        if let Some(others) = others {
            opaque = [cast.before + words as u32, u32::from(!others.casters.iter().all(Caster::is_nothing))];
            passes::run(&others, &turned, grid, 1, (&buffer, opaque[0]), tools)?;
        }
        Ok(Self { frame: turned.frame, grid, channels, opaque, buffer, cast })
    }

    /// The key of the shadow map.
    pub(super) fn cast(&self) -> &Cast {
        &self.cast
    }

    /// The uniforms for look-ups at positions in the voxels of `viewed`.
    ///
    /// # Errors
    /// If the softness takes more columns than a look-up may.
    pub(super) fn lookup(&self, scene: &Scene, viewed: Grid) -> Result<Lookup, Error> {
        let radius = f64::from(scene.shadow.filter_radius);
        let edge = self.grid.voxel_size;
        // Of a point or spot the radius is the one in the middle of the mesh.
        let middle = self.grid.origin[0] + 0.5 * f64::from(self.grid.dimensions[0]) * edge;
        let width = 1.0 + radius / (edge * self.frame.unit_depth.map_or(1.0, |unit| middle / unit));
        if width > f64::from(MOST_COLUMNS) {
            let (voxels, limit) = (width - 1.0, MOST_COLUMNS - 1);
            return Err(Unrenderable::ShadowTooSoft { radius, voxels, limit }.into());
        }
        // Where a soft light is several crisp ones, each is crisp; the columns of a point or spot are of its middle.
        let is_soft = scene.shadow.samples < 2 && self.frame.unit_depth.is_none();
        let disc = if is_soft { f64::from(scene.first_light().disc()) } else { 0.0 };
        let softness = libm::tan(disc.to_radians());
        let Frame { axes, unit_depth, .. } = self.frame;
        let from = DVec3::from_array(viewed.origin) - self.frame.origin;
        // The depth over the unit depth.
        let scale = unit_depth
            .map_or(DVec4::W, |unit| (axes.x_axis * viewed.voxel_size / unit).extend(from.dot(axes.x_axis) / unit));
        let row = |axis: usize, divisor: DVec4| {
            let along = axes.col(axis);
            let low = self.grid.origin[axis];
            let origin = from.dot(along) - low * divisor.w;
            let factors = along * viewed.voxel_size / edge - divisor.truncate() * (low / edge);
            Affine::from(factors.extend(origin / edge).as_vec4())
        };
        let [x, y, z] = self.grid.dimensions;
        Ok(Lookup {
            size: Counts::new(x, y, z),
            channels: self.channels,
            axis: axes.x_axis.as_vec3().into(),
            row_x: row(0, DVec4::W),
            row_y: row(1, scale),
            row_z: row(2, scale),
            scale: Affine::from(scale.as_vec4()),
            spread: spread(&self.frame, self.grid),
            radius: width as f32,
            edge: (edge / viewed.voxel_size) as f32,
            softness: softness as f32,
            first: self.cast.before,
            first_opaque: self.opaque[0],
            opaque_channels: self.opaque[1],
        })
    }
}

/// The spread of the columns of a grid in a light's frame.
fn spread(frame: &Frame, grid: Grid) -> Spread {
    let tangent = |length: f64| frame.unit_depth.map_or(0.0, |unit| (length / unit) as f32);
    Spread { low_y: tangent(grid.origin[1]), low_z: tangent(grid.origin[2]), step: tangent(grid.voxel_size) }
}

/// The divergence of the columns of a grid in a light's frame: a voxel's edge over the distance from the light to the grid's front.
fn divergence(frame: &Frame, grid: Grid) -> f64 {
    frame.unit_depth.map_or(0.0, |_| grid.voxel_size / grid.origin[0])
}
