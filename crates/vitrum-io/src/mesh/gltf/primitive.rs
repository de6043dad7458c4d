//! The triangles of a primitive, put where its node stands.

use glam::{DAffine3, DVec3};

use super::accessor::Values;
use super::document::Primitive;
use super::scene::Assembly;
use super::transform;
use crate::error::{Error, Place};
use crate::mesh::build::unit;
use crate::mesh::strip::strip;

const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

impl<'a> Assembly<'a, '_> {
    pub fn add_primitive(&mut self, primitive: &Primitive, map: &DAffine3, name: &str) -> Result<(), Error> {
        let report = self.builder.report;
        let mode = primitive.mode.unwrap_or(TRIANGLES);
        if mode > FAN {
            let problem = format!("{name}.mode is {mode}, not 0 to {FAN}");
            return Err(report.invalid(Place::File, problem, "correct the mode; 4 is triangles"));
        }
        let (Some(position), true) = (primitive.attributes.position, mode >= TRIANGLES) else {
            self.left_out += 1;
            return Ok(());
        };
        let positions = self.files.values(self.builder, position, &["VEC3"], &format!("{name}.attributes.POSITION"))?;
        let count = positions.count;
        let normals = self.attribute(primitive.attributes.normal, "NORMAL", &["VEC3"], name, count)?;
        let colors = self.attribute(primitive.attributes.color, "COLOR_0", &["VEC3", "VEC4"], name, count)?;
        let mut indices = self.indices(primitive, positions.count, name)?;
        let before = self.builder.triangles.len();
        let vertices = Vertices { positions, normals, colors };
        self.add_vertices(&vertices, &mut indices, map)?;
        match mode {
            TRIANGLES if !indices.len().is_multiple_of(3) => {
                let problem = format!("{name} has {} corners, which do not make triangles", indices.len());
                return Err(report.invalid(Place::File, problem, "give each triangle three"));
            }
            TRIANGLES => {
                for corners in indices.chunks_exact(3) {
                    self.builder.triangle([corners[0], corners[1], corners[2]])?;
                }
            }
            STRIP => self.joints += strip(self.builder, &indices)?,
            _ => {
                for pair in indices.get(1..).unwrap_or_default().windows(2) {
                    self.builder.triangle([indices[0], pair[0], pair[1]])?;
                }
            }
        }
        if transform::mirrors(map) {
            self.builder.triangles[before..].iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        let material = self.material(primitive.material, name)?;
        self.builder.assign(material)
    }

    /// An attribute that no triangle needs: one that cannot be read, or is of other vertices, is left out and told.
    fn attribute(
        &mut self,
        index: Option<usize>,
        attribute: &str,
        kinds: &[&str],
        name: &str,
        count: u32,
    ) -> Result<Option<Values<'a>>, Error> {
        let Some(index) = index else { return Ok(None) };
        let problem = match self.files.values(self.builder, index, kinds, &format!("{name}.attributes.{attribute}")) {
            Ok(values) if values.count == count => return Ok(Some(values)),
            Ok(values) => format!("there are {} for {count} vertices", values.count),
            Err(error @ Error::TooLarge { .. }) => return Err(error),
            Err(Error::Invalid { problem, .. } | Error::Unsupported { problem, .. }) => problem,
            Err(error) => error.to_string(),
        };
        self.leave_out(format!("left out: {attribute} of {name}, as {problem}"));
        Ok(None)
    }

    /// Tells what was left out; a hostile file may have much of it.
    pub fn leave_out(&mut self, fact: String) {
        const MOST: usize = 64;
        if self.builder.assumptions.len() < MOST {
            self.builder.assumptions.push(fact);
        }
    }

    /// The vertices in the order of corners, each below `count`.
    fn indices(&mut self, primitive: &Primitive, count: u32, name: &str) -> Result<Vec<u32>, Error> {
        let report = self.builder.report;
        let Some(index) = primitive.indices else {
            self.builder.budget.check(4 * u64::from(count))?;
            return Ok((0..count).collect());
        };
        let values = self.files.values(self.builder, index, &["SCALAR"], &format!("{name}.indices"))?;
        self.builder.budget.check(4 * u64::from(values.count))?;
        let Some(indices) = values.indices() else {
            let problem = format!("accessors[{index}] holds indices of no unsigned type");
            return Err(report.invalid(Place::File, problem, "use 5121, 5123 or 5125 as `componentType`"));
        };
        let indices: Vec<u32> = indices.collect();
        match indices.iter().find(|&&index| index >= count) {
            None => Ok(indices),
            Some(index) => {
                let problem = format!("{name} names vertex {index}, counted from 0, and there are {count}");
                Err(report.invalid(Place::File, problem, "correct the index"))
            }
        }
    }

    /// Adds the vertices that are used, since primitives may share accessors, and makes the indices those in the mesh.
    fn add_vertices(&mut self, vertices: &Vertices, indices: &mut [u32], map: &DAffine3) -> Result<(), Error> {
        const UNUSED: u32 = u32::MAX;
        let builder = &mut *self.builder;
        builder.budget.check(4 * u64::from(vertices.positions.count))?;
        let mut numbers = vec![UNUSED; vertices.positions.count as usize];
        for &index in indices.iter() {
            numbers[index as usize] = 0;
        }
        for (index, number) in (0..).zip(&mut numbers).filter(|(_, number)| **number != UNUSED) {
            *number = builder.positions.len() as u32;
            let position =
                map.transform_point3(DVec3::from(vertices.positions.floats(index, 0.0).map(f64::from))).to_array();
            builder.budget.push(&mut builder.positions, position.map(|coordinate| coordinate as f32))?;
        }
        crate::mesh::check::check_count(builder.report, builder.positions.len())?;
        self.add_normals(vertices, &numbers, map)?;
        self.add_colors(vertices, &numbers)?;
        for index in indices {
            *index = numbers[*index as usize];
        }
        Ok(())
    }

    /// Primitives without normals have 0 where others have some.
    fn add_normals(&mut self, vertices: &Vertices, numbers: &[u32], map: &DAffine3) -> Result<(), Error> {
        let builder = &mut *self.builder;
        if vertices.normals.is_none() && builder.normals.is_empty() {
            return Ok(());
        }
        let first = builder.positions.len() - used(numbers).count();
        while builder.normals.len() < first {
            builder.budget.push(&mut builder.normals, [0.0; 3])?;
        }
        for index in used(numbers) {
            let normal = vertices.normals.as_ref().map_or([0.0; 3], |values| values.floats(index, 0.0));
            builder.budget.push(&mut builder.normals, unit(transform::normal(map, normal.map(f64::from))))?;
        }
        Ok(())
    }

    /// Primitives without colours are white where others have some.
    fn add_colors(&mut self, vertices: &Vertices, numbers: &[u32]) -> Result<(), Error> {
        let builder = &mut *self.builder;
        if vertices.colors.is_none() && builder.colors.is_empty() {
            return Ok(());
        }
        let first = builder.positions.len() - used(numbers).count();
        while builder.colors.len() < first {
            builder.budget.push(&mut builder.colors, [1.0; 4])?;
        }
        for index in used(numbers) {
            let color = vertices.colors.as_ref().map_or([1.0; 4], |values| values.floats(index, 1.0));
            builder.budget.push(&mut builder.colors, color)?;
        }
        Ok(())
    }
}

struct Vertices<'a> {
    positions: Values<'a>,
    normals: Option<Values<'a>>,
    colors: Option<Values<'a>>,
}

/// The vertices that have a number.
fn used(numbers: &[u32]) -> impl Iterator<Item = u32> {
    (0..).zip(numbers).filter(|(_, number)| **number != u32::MAX).map(|(index, _)| index)
}
