//! A mesh in the making, each piece counted against the limit of memory.

use super::content::{self, Budget};
use super::triangulate::{MOST_CORNERS, triangulate};
use super::{Material, Mesh};
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::options::OpenOptions;
use crate::source::{Assumptions, Source};
use crate::tolerance::{BYTE_ORDER_MARK, LeftOut};

/// A mesh in the making.
#[derive(Debug)]
pub(super) struct Builder<'a> {
    pub report: Report<'a>,
    pub budget: Budget<'a>,
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// Empty, or as many as positions.
    pub normals: Vec<[f32; 3]>,
    /// Empty, or as many as positions.
    pub colors: Vec<[f32; 4]>,
    pub materials: Vec<Material>,
    /// Empty, or as many as triangles.
    pub triangle_materials: Vec<u32>,
    pub assumptions: Assumptions,
    pub left_out: LeftOut,
    /// Polygons that cross themselves.
    crossing: u64,
    pieces: Vec<[usize; 3]>,
}

impl<'a> Builder<'a> {
    pub fn new(report: Report<'a>, budget: Budget<'a>) -> Self {
        Self {
            report,
            budget,
            positions: Vec::new(),
            triangles: Vec::new(),
            normals: Vec::new(),
            colors: Vec::new(),
            materials: Vec::new(),
            triangle_materials: Vec::new(),
            assumptions: Assumptions::default(),
            left_out: LeftOut::default(),
            crossing: 0,
            pieces: Vec::new(),
        }
    }

    pub fn triangle(&mut self, corners: [u32; 3]) -> Result<(), Error> {
        self.budget.push(&mut self.triangles, corners)
    }

    /// Adds a polygon, whose corners are there already, as triangles; one of fewer than 3 corners is left out and counted.
    pub fn polygon(&mut self, place: Place, corners: &[u32]) -> Result<(), Error> {
        if let Some(missing) = corners.iter().find(|&&corner| corner as usize >= self.positions.len()) {
            return Err(self.report.invalid(
                place,
                format!("the face names vertex {missing}, counted from 0, and there are {}", self.positions.len()),
                "correct the index, or get the whole file",
            ));
        }
        match *corners {
            [a, b, c] => return self.triangle([a, b, c]),
            [] | [_] | [_, _] => {
                self.left_out.add("faces of fewer than 3 corners");
                return Ok(());
            }
            _ => {}
        }
        // Points, projected ones and the triangles among them.
        self.budget.check(64 * corners.len() as u64)?;
        let points: Vec<_> = corners.iter().map(|&corner| self.positions[corner as usize].map(f64::from)).collect();
        self.pieces.clear();
        match triangulate(&points, &mut self.pieces) {
            Some(simple) => self.crossing += u64::from(!simple),
            None => {
                return Err(self.report.unsupported(
                    place,
                    format!("a face of {} corners that is not convex; {MOST_CORNERS} are the most", corners.len()),
                    "triangulate it in the program that made it",
                ));
            }
        }
        for index in 0..self.pieces.len() {
            self.triangle(self.pieces[index].map(|corner| corners[corner]))?;
        }
        Ok(())
    }

    /// Names the material of all triangles that have none yet.
    pub fn assign(&mut self, material: u32) -> Result<(), Error> {
        while self.triangle_materials.len() < self.triangles.len() {
            self.budget.push(&mut self.triangle_materials, material)?;
        }
        Ok(())
    }

    pub fn finish(mut self, format: &'static str, sample_type: &str, encoding: &str) -> Result<Mesh, Error> {
        if self.crossing > 0 {
            self.assumptions.push(format!("{} polygons cross themselves: their triangles overlap", self.crossing));
        }
        self.leave_out_unused();
        std::mem::take(&mut self.left_out).tell(&mut self.assumptions);
        let normals = self.unit_normals();
        let clamped = clamp_colors(&mut self.colors);
        if clamped > 0 {
            self.assumptions.push(format!("{clamped} vertices have colours outside 0 to 1, which were clamped"));
        }
        let mut mesh = Mesh::new(self.report.file, self.positions, self.triangles)?;
        mesh.normals = normals;
        mesh.colors = (!self.colors.is_empty()).then_some(self.colors);
        mesh.materials = self.materials;
        mesh.triangle_materials = self.triangle_materials;
        mesh.source = Source {
            format,
            sample_type: sample_type.to_owned(),
            encoding: encoding.to_owned(),
            assumptions: self.assumptions,
        };
        Ok(mesh)
    }

    /// Leaves out vertices whose position is not finite and that no triangle has.
    fn leave_out_unused(&mut self) {
        let is_finite = |position: &[f32; 3]| position.iter().all(|coordinate| coordinate.is_finite());
        if self.positions.iter().all(is_finite) {
            return;
        }
        let mut kept: Vec<bool> = self.positions.iter().map(is_finite).collect();
        for &vertex in self.triangles.iter().flatten() {
            if let Some(kept) = kept.get_mut(vertex as usize) {
                *kept = true;
            }
        }
        let counted = kept.iter().scan(0, |next, &kept| {
            let number = *next;
            *next += u32::from(kept);
            Some(number)
        });
        let numbers: Vec<u32> = counted.collect();
        kept.iter().filter(|kept| !**kept).for_each(|_| {
            self.left_out.add("vertices whose position is not finite and that no triangle has");
        });
        retain(&mut self.positions, &kept);
        retain(&mut self.normals, &kept);
        retain(&mut self.colors, &kept);
        for vertex in self.triangles.iter_mut().flatten() {
            // An index beyond the last is told by the check of the mesh.
            *vertex = numbers.get(*vertex as usize).copied().unwrap_or(u32::MAX);
        }
    }

    /// Normals of length 1, or 0 where a vertex has none that is finite.
    fn unit_normals(&mut self) -> Option<Vec<[f32; 3]>> {
        let mut normals = std::mem::take(&mut self.normals);
        let mut broken = 0;
        for normal in &mut normals {
            let is_finite = normal.iter().all(|component| component.is_finite());
            broken += usize::from(!is_finite);
            *normal = if is_finite { unit(normal.map(f64::from)) } else { [0.0; 3] };
        }
        if broken > 0 {
            self.assumptions.push(format!("left out: {broken} normals that are not finite"));
        }
        (broken < normals.len()).then_some(normals)
    }
}

/// Keeps the elements that are marked; an empty list stays empty.
fn retain<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut marks = kept.iter();
    list.retain(|_| marks.next().copied().unwrap_or(true));
}

/// The file's bytes and an empty mesh: how every reader starts.
pub(super) fn start<'a>(input: &'a Input, options: &OpenOptions) -> Result<(Vec<u8>, Builder<'a>), Error> {
    let report = Report::new(&input.name);
    let mut budget = Budget::new(report, options);
    let mut bytes = content::read(input, &mut budget)?;
    if bytes.starts_with(BYTE_ORDER_MARK) {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    Ok((bytes, Builder::new(report, budget)))
}

/// The vector of length 1 in the same direction; 0 stays 0.
pub(super) fn unit(vector: [f64; 3]) -> [f32; 3] {
    let length = vector.iter().map(|component| component * component).sum::<f64>().sqrt();
    if length > 0.0 { vector.map(|component| (component / length) as f32) } else { [0.0; 3] }
}

/// Clamps colours to 0 to 1, NaN to 0, and returns the count of those that it changed.
fn clamp_colors(colors: &mut [[f32; 4]]) -> usize {
    let mut count = 0;
    for color in colors {
        let clamped = color.map(|channel| if channel.is_nan() { 0.0 } else { channel.clamp(0.0, 1.0) });
        count += usize::from(clamped != *color);
        *color = clamped;
    }
    count
}
