//! Corners of faces, `vertex/texture/normal`, as vertices of a mesh.

use std::collections::HashMap;

use super::vertices::Vertices;
use crate::error::{Error, Place};
use crate::mesh::build::Builder;
use crate::mesh::words::show;

/// Counts of each kind of vertex data before a statement; negative indices count back from there.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct Before {
    pub positions: usize,
    pub normals: usize,
}

/// The normals of vertices, corner by corner. A vertex whose corners have several normals becomes several vertices.
pub(super) struct Corners<'a> {
    vertices: &'a Vertices,
    /// Counts in the whole file.
    positions: usize,
    /// The normal of each vertex of the file; empty where the file has no normals.
    normals: Vec<Normal>,
    copies: HashMap<(u32, Normal), u32>,
    uses_normals: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Normal {
    /// A vertex without any corner so far.
    Unseen,
    None,
    Index(u32),
}

impl<'a> Corners<'a> {
    pub fn new(vertices: &'a Vertices, builder: &mut Builder) -> Result<Self, Error> {
        let positions = builder.positions.len();
        let mut normals = Vec::new();
        if !vertices.normals.is_empty() {
            normals = builder.budget.reserve(positions as u64)?;
            normals.resize(positions, Normal::Unseen);
            builder.normals = builder.budget.reserve(positions as u64)?;
            builder.normals.resize(positions, [0.0; 3]);
        }
        Ok(Self { vertices, positions, normals, copies: HashMap::new(), uses_normals: false })
    }

    /// The vertex of a word of a face.
    pub fn vertex(&mut self, builder: &mut Builder, place: Place, word: &[u8], before: Before) -> Result<u32, Error> {
        let report = builder.report;
        let wrong = || {
            let problem = format!("`{}` is not a corner such as `1`, `1/2`, `1//3` or `1/2/3`", show(word));
            report.invalid(place, problem, "correct the face")
        };
        let mut parts = word.split(|&byte| byte == b'/');
        let number = |part: &[u8]| std::str::from_utf8(part).ok().and_then(|part| part.parse::<i64>().ok());
        let position = parts.next().and_then(number).ok_or_else(wrong)?;
        let Some(position) = resolve(position, before.positions, self.positions) else {
            let count = self.positions;
            let problem = format!("the face names vertex {position}, counted from 1, and there are {count}");
            return Err(report.invalid(place, problem, "correct the index, or get the whole file"));
        };
        // Texture coordinates are not read.
        parts.next();
        let written = parts.next().filter(|part| !part.is_empty());
        let normal = written.and_then(number);
        let normal = normal.and_then(|normal| resolve(normal, before.normals, self.vertices.normals.len()));
        if written.is_some() && normal.is_none() {
            builder.left_out.add("normals of corners that name none of the file's");
        }
        if parts.next().is_some() {
            return Err(wrong());
        }
        self.with_normal(builder, position, normal.map_or(Normal::None, Normal::Index))
    }

    fn with_normal(&mut self, builder: &mut Builder, position: u32, normal: Normal) -> Result<u32, Error> {
        let Some(first) = self.normals.get_mut(position as usize) else {
            return Ok(position);
        };
        let vector = match normal {
            Normal::Index(index) => self.vertices.normals[index as usize],
            Normal::Unseen | Normal::None => [0.0; 3],
        };
        self.uses_normals |= normal != Normal::None;
        if *first == Normal::Unseen {
            *first = normal;
            builder.normals[position as usize] = vector;
        }
        if *first == normal {
            return Ok(position);
        }
        if let Some(&copy) = self.copies.get(&(position, normal)) {
            return Ok(copy);
        }
        let copy = builder.positions.len() as u32;
        builder.budget.take(2 * size_of::<((u32, Normal), u32)>() as u64)?;
        self.copies.insert((position, normal), copy);
        let coordinates = builder.positions[position as usize];
        builder.budget.push(&mut builder.positions, coordinates)?;
        builder.budget.push(&mut builder.normals, vector)?;
        if !builder.colors.is_empty() {
            let color = builder.colors[position as usize];
            builder.budget.push(&mut builder.colors, color)?;
        }
        Ok(copy)
    }

    pub fn finish(self, builder: &mut Builder) {
        if !self.uses_normals {
            builder.normals.clear();
        }
        if !self.copies.is_empty() {
            builder.assumptions.push(format!(
                "vertices with several normals were doubled: {} became {}",
                self.positions,
                builder.positions.len()
            ));
        }
    }
}

/// An index from 0 out of one from 1, or from the last backwards; `None` where there is no such thing.
fn resolve(index: i64, before: usize, count: usize) -> Option<u32> {
    let from_zero = if index > 0 { index - 1 } else { (before as i64).checked_add(index)? };
    // Fewer than 2^32 of each: positions were counted, and the others are no more than the file's lines.
    (index != 0 && (0..count as i64).contains(&from_zero)).then_some(from_zero as u32)
}
