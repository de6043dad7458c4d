//! The transparent shadow map of a mesh (Chang et al. 2010, §3).

mod casters;
mod passes;

use super::bodies::Body;
use crate::assets::Assets;
use crate::backend::Buffer;
use crate::error::Error;
use crate::method::Tools;
use crate::method::view::View;
use crate::method::view::light::travels;
use crate::method::voxelize::{Grid, Settings};
use crate::scene::{Coefficient, Scene};
use crate::unrenderable::Unrenderable;
use casters::Caster;
use glam::{DMat3, DVec3};
use vitrum_kernels::abi::vector::{Affine, Counts};
pub(super) use vitrum_kernels::abi::voxels::ShadowMap as Lookup;
use vitrum_kernels::shadow::look_up::MOST_COLUMNS;

/// Voxels around the mesh: columns beside it are lit.
const PADDING: u32 = 1;

/// What a shadow map depends on.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cast {
    /// Unit direction in which light travels, in the world.
    direction: DVec3,
    resolution: u32,
    coefficient: Coefficient,
    absorption: f32,
    /// What each body does to light.
    casters: Vec<Caster>,
}

/// How much light gets to each voxel, on a backend.
pub(super) struct ShadowMap {
    cast: Cast,
    /// The light's frame: as columns where its axes lie in the world, x along the light.
    axes: DMat3,
    /// What positions in it are relative to, in the world.
    centre: DVec3,
    /// The voxels in it.
    grid: Grid,
    channels: u32,
    pub(super) buffer: Buffer,
}

impl Cast {
    /// Of a scene; `None` where there is no shadow to be seen.
    ///
    /// # Errors
    /// If the light has no direction.
    pub(super) fn of(scene: &Scene, assets: &Assets, bodies: &[Body]) -> Result<Option<Self>, Error> {
        let shows = bodies.iter().any(|body| body.opaque) || scene.ground.is_some() || scene.wall.is_some();
        let Some(mesh) = assets.subject.mesh().filter(|_| shows && scene.first_light().shadows) else {
            return Ok(None);
        };
        let view = View::new(scene, mesh);
        let casters = Caster::all(bodies, mesh, scene);
        if casters.iter().all(Caster::is_nothing) {
            return Ok(None);
        }
        Ok(Some(Self {
            direction: view.axes * travels(scene.first_light(), &view)?,
            resolution: scene.shadow.resolution,
            coefficient: scene.shadow.coefficient,
            absorption: scene.shadow.optical_depth,
            casters,
        }))
    }
}

impl ShadowMap {
    /// Makes a shadow map.
    ///
    /// # Errors
    /// If it is too large for the backend, or the backend fails.
    pub(super) fn new(cast: Cast, bodies: &[Body], tools: &mut Tools<'_>) -> Result<Self, Error> {
        let across = cast.direction.any_orthonormal_vector();
        let axes = DMat3::from_cols(cast.direction, across, cast.direction.cross(across));
        let turned = casters::Turned::new(bodies, axes);
        let settings = Settings { padding: PADDING, ..Settings::new(cast.resolution) };
        let grid = Grid::around_box("the mesh", turned.bounds, &settings)?;
        let channels = if cast.coefficient == Coefficient::PerTriangle && cast.casters.iter().any(Caster::is_colored) {
            3
        } else {
            1
        };
        let buffer = passes::run(&cast, &turned, grid, channels, tools)?;
        Ok(Self { axes, centre: turned.centre, grid, channels, buffer, cast })
    }

    /// Whether it is the one of `cast`.
    pub(super) fn is_of(&self, cast: &Cast) -> bool {
        self.cast == *cast
    }

    /// What kernels are told that look up positions in the voxels of `viewed`.
    ///
    /// # Errors
    /// If the softness takes more columns than a look-up may.
    pub(super) fn lookup(&self, scene: &Scene, viewed: Grid) -> Result<Lookup, Error> {
        let radius = f64::from(scene.shadow.filter_radius);
        let edge = self.grid.voxel_size;
        let width = 1.0 + radius / edge;
        if width > f64::from(MOST_COLUMNS) {
            let (voxels, limit) = (width - 1.0, MOST_COLUMNS - 1);
            return Err(Unrenderable::ShadowTooSoft { radius, voxels, limit }.into());
        }
        let row = |axis: usize| {
            let along = self.axes.col(axis);
            let origin = (DVec3::from_array(viewed.origin) - self.centre).dot(along) - self.grid.origin[axis];
            Affine::from((along * viewed.voxel_size / edge).extend(origin / edge).as_vec4())
        };
        let [x, y, z] = self.grid.dimensions;
        Ok(Lookup {
            size: Counts::new(x, y, z),
            channels: self.channels,
            row_x: row(0),
            row_y: row(1),
            row_z: row(2),
            radius: width as f32,
            edge: (edge / viewed.voxel_size) as f32,
        })
    }
}
