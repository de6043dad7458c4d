//! Subdivision of a mesh: each triangle becomes four.

use std::collections::HashMap;

use super::{Mesh, check};
use crate::error::{Error, Report};
use crate::memory;

impl Mesh {
    /// The same surface of four times as many triangles: each edge is cut at its middle.
    ///
    /// Normals and colours in the middle are the mean of those of the edge's ends, and normals of length 1 again.
    ///
    /// # Errors
    ///
    /// [`Error::Unsupported`] where there would be more vertices than 32-bit indices tell apart, and
    /// [`Error::TooLarge`] where the memory is not there.
    pub fn subdivide(&self) -> Result<Self, Error> {
        let report = Report::new(&self.name);
        let before = self.positions.len();
        let mut middles = HashMap::new();
        let mut ends = Vec::new();
        let mut triangles = memory::reserve(report, self.triangles.len().saturating_mul(4))?;
        for &[a, b, c] in &self.triangles {
            let mut middle = |from: u32, to: u32| {
                *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                    ends.push([from.min(to), from.max(to)]);
                    // Checked below to fit; the vertices of a mesh did before.
                    (before + ends.len() - 1) as u32
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        check::check_count(report, before + ends.len())?;
        let materials = self.triangle_materials.iter().flat_map(|&material| [material; 4]).collect();
        Ok(Self {
            name: self.name.clone(),
            positions: with_means(&self.positions, &ends),
            triangles,
            normals: self.normals.as_deref().map(|normals| {
                let mut all = with_means(normals, &ends);
                for normal in &mut all[before..] {
                    *normal = super::build::unit(normal.map(f64::from));
                }
                all
            }),
            colors: self.colors.as_deref().map(|colors| with_means(colors, &ends)),
            materials: self.materials.clone(),
            triangle_materials: materials,
            source: self.source.clone(),
        })
    }
}

/// The values, followed by the mean of each pair of them.
fn with_means<const COUNT: usize>(values: &[[f32; COUNT]], pairs: &[[u32; 2]]) -> Vec<[f32; COUNT]> {
    let mean = |pair: &[u32; 2]| {
        let [a, b] = pair.map(|index| values[index as usize]);
        std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis]))
    };
    values.iter().copied().chain(pairs.iter().map(mean)).collect()
}
