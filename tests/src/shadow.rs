//! Shadow maps of meshes, point by point, and what light meets on its way by an exact caster of rays.

use vitrum::Error;
use vitrum::backend::{Backend, ReadBack as _};
use vitrum::method::voxels::{Rays, Uploaded};
use vitrum::method::{Tools, View};
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::VoxelsUniforms;
use vitrum_kernels::glam::{DVec2, DVec3};
use vitrum_kernels::kernel::kernels;
use vitrum_kernels::math::affine;
use vitrum_kernels::shadow::look_up::transmittance;

use crate::Failure;
use crate::case::Case;

/// A shadow map as a backend made it.
pub struct Map {
    /// What kernels are told of it.
    pub block: VoxelsUniforms,
    /// Its words.
    pub words: Vec<u32>,
    origin: DVec3,
    voxel: f64,
}

impl Map {
    /// The shadow map of a case.
    ///
    /// # Errors
    /// If the backend fails.
    pub fn of(case: &Case, backend: &mut dyn Backend) -> Result<Self, Failure> {
        let Case { scene, assets, .. } = case;
        let uploaded = Uploaded::new(scene, assets, &mut Tools { backend: &mut *backend, progress: &mut |_| true })?;
        let rays = Rays::prepare(scene, assets, &uploaded, backend)?;
        let last = rays.passes.passes.last().expect("there are passes");
        let block = bytemuck::pod_read_unaligned(&last.uniforms);
        // By its binding's name; the uniforms are the first.
        let bindings = kernels::voxels_resolve.declaration.bindings;
        let place = bindings.iter().position(|binding| binding.name == "shadow").expect("it is read");
        let words = backend.read_all(&last.buffers[place - 1]).map_err(Error::from)?;
        let origin = DVec3::from_array(uploaded.grid.origin);
        let voxel = uploaded.grid.voxel_size;
        Ok(Self { block, words, origin, voxel })
    }

    /// What is left of the light at a point in the world, red, green and blue.
    #[must_use]
    pub fn at(&self, point: DVec3) -> [f64; 3] {
        let position = ((point - self.origin) / self.voxel).as_vec3();
        transmittance(&self.block, &self.words, position).to_array().map(f64::from)
    }

    /// The low corner of the grid that positions are relative to, in the world.
    #[must_use]
    pub fn world_origin(&self) -> DVec3 {
        self.origin
    }

    /// Edge of a voxel of the shadow map, in world units.
    #[must_use]
    pub fn edge(&self) -> f64 {
        f64::from(self.block.shadow.edge) * self.voxel
    }

    /// Width of a column of the shadow map at a point in the world, in world units.
    #[must_use]
    pub fn width(&self, point: DVec3) -> f64 {
        let position = ((point - self.origin) / self.voxel).as_vec3();
        f64::from(affine(self.block.shadow.scale, position)) * self.edge()
    }

    /// Unit direction in which a distant light travels.
    #[must_use]
    pub fn light(&self) -> DVec3 {
        let light = self.block.light.direction;
        DVec3::new(f64::from(light.x), f64::from(light.y), f64::from(light.z)).normalize()
    }
}

/// The camera's view of a case, in which directions of normals are given.
#[must_use]
pub fn view(case: &Case) -> View {
    View::new(&case.scene, &case.assets.subject)
}

/// The point of a plane across the world's axis `axis`, at `at`, that each pixel of a case sees if nothing is in the way.
#[must_use]
pub fn seen_on_plane(case: &Case, axis: usize, at: f64) -> Vec<DVec3> {
    let view = view(case);
    let [width, height] = [case.scene.film.width, case.scene.film.height];
    let share = |at: u32, edge: u32| (f64::from(at) + 0.5) / f64::from(edge) * 2.0 - 1.0;
    let point = |row: u32, column: u32| {
        let side = view.axes.x_axis * (share(column, width) * view.half_size[0])
            - view.axes.y_axis * (share(row, height) * view.half_size[1]);
        let [from, towards] =
            if view.orthographic { [view.eye + side, view.axes.z_axis] } else { [view.eye, view.axes.z_axis + side] };
        from + towards * ((at - from[axis]) / towards[axis])
    };
    (0..height).flat_map(|row| (0..width).map(move |column| point(row, column))).collect()
}

/// Triangles that light along one direction goes through, in cells across it: an independent and exact reference.
pub struct Caster {
    axes: [DVec3; 3],
    low: DVec2,
    cell: f64,
    cells: [usize; 2],
    /// For each cell the triangles that may be in it.
    inside: Vec<Vec<u32>>,
    /// Corners across the light and along it, and the optical depth.
    triangles: Vec<([DVec3; 3], f64)>,
}

impl Caster {
    /// For light along `direction` through a mesh whose triangle number i has the optical depth `depth(i)`.
    #[must_use]
    pub fn new(mesh: &Mesh, direction: DVec3, depth: impl Fn(usize) -> f64) -> Self {
        const CELLS: f64 = 256.0;
        let along = direction.normalize();
        let across = along.any_orthonormal_vector();
        let axes = [across, along.cross(across), along];
        let turned = |vertex: u32| {
            let at = DVec3::from_array(mesh.positions[vertex as usize].map(f64::from));
            DVec3::from_array(axes.map(|axis| at.dot(axis)))
        };
        let triangles: Vec<([DVec3; 3], f64)> =
            mesh.triangles.iter().enumerate().map(|(index, triangle)| (triangle.map(turned), depth(index))).collect();
        let corners = || triangles.iter().flat_map(|(corners, _)| corners).map(|corner| corner.truncate());
        let low = corners().fold(DVec2::INFINITY, DVec2::min);
        let high = corners().fold(DVec2::NEG_INFINITY, DVec2::max);
        let cell = (high - low).max_element() / CELLS;
        let cells = [(high - low).x, (high - low).y].map(|length| (length / cell) as usize + 1);
        let mut inside = vec![Vec::new(); cells[0] * cells[1]];
        for (index, (corners, _)) in (0..).zip(&triangles) {
            let [a, b, c] = corners.map(|corner| (corner.truncate() - low) / cell);
            let (first, last) = (a.min(b).min(c), a.max(b).max(c));
            for y in first.y as usize..=(last.y as usize).min(cells[1] - 1) {
                for x in first.x as usize..=(last.x as usize).min(cells[0] - 1) {
                    inside[y * cells[0] + x].push(index);
                }
            }
        }
        Self { axes, low, cell, cells, inside, triangles }
    }

    /// The optical depth of all triangles between the light and `point`.
    #[must_use]
    pub fn depth(&self, point: DVec3) -> f64 {
        let at = DVec3::from_array(self.axes.map(|axis| point.dot(axis)));
        let cell = (at.truncate() - self.low) / self.cell;
        let [width, height] = self.cells;
        if cell.x < 0.0 || cell.y < 0.0 || cell.x >= width as f64 || cell.y >= height as f64 {
            return 0.0;
        }
        let met =
            self.inside[cell.y as usize * width + cell.x as usize].iter().map(|&index| &self.triangles[index as usize]);
        met.filter(|(corners, _)| along(corners, at.truncate()).is_some_and(|depth| depth < at.z))
            .map(|(_, depth)| depth)
            .sum()
    }
}

/// Where a line along z through `at` meets a triangle. Points on its edges count as inside or not.
fn along([a, b, c]: &[DVec3; 3], at: DVec2) -> Option<f64> {
    let side = |p: &DVec3, q: &DVec3| (q.truncate() - p.truncate()).perp_dot(at - p.truncate());
    let (u, v, w) = (side(b, c), side(c, a), side(a, b));
    let sum = u + v + w;
    let inside = (u > 0.0) == (v > 0.0) && (v > 0.0) == (w > 0.0) && sum != 0.0;
    inside.then(|| (u * a.z + v * b.z + w * c.z) / sum)
}
