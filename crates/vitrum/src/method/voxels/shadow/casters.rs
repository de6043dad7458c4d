//! What casts a shadow: bodies, turned so that light travels along x.

use super::frame::Frame;
use super::source::Source;
use crate::error::Error;
use crate::method::voxels::bodies::{Body, chosen, clear, of_mesh};
use crate::scene::Scene;
use glam::DVec3;
use rayon::prelude::*;
use vitrum_io::Mesh;

/// What a body does to light.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Caster {
    /// Each of its triangles has this optical depth.
    Surface(f32),
    /// It absorbs so much over a world unit, red, green and blue.
    Solid([f64; 3]),
}

impl Caster {
    /// What each of `bodies` does.
    pub(super) fn all(bodies: &[Body], mesh: &Mesh, scene: &Scene) -> Vec<Self> {
        let of_body = |(body, solid): (&Body, _)| {
            let material = chosen(&scene.material, of_mesh(mesh, body.material));
            if body.opaque { Self::Surface(material.density * scene.shadow.optical_depth) } else { Self::Solid(solid) }
        };
        let solids = clear(bodies, mesh, scene).into_iter().map(|clear| clear.absorption);
        bodies.iter().zip(solids).map(of_body).collect()
    }

    /// Whether all light goes through it.
    pub(super) fn is_nothing(&self) -> bool {
        match self {
            Self::Surface(depth) => *depth <= 0.0,
            Self::Solid(absorption) => absorption.iter().all(|channel| *channel <= 0.0),
        }
    }

    /// Whether it does something else to red light than to blue.
    pub(super) fn is_colored(&self) -> bool {
        matches!(self, Self::Solid([red, green, blue]) if red != green || green != blue)
    }
}

/// The triangles of bodies in the light's frame.
pub(super) struct Turned {
    pub frame: Frame,
    /// Low and high corner of all that light falls on.
    pub bounds: [[f64; 3]; 2],
    /// The corners of each body's triangles. A vertex is at the same place in all of its triangles, to the bit.
    pub bodies: Vec<Vec<[[f64; 3]; 3]>>,
}

impl Turned {
    /// The triangles of `bodies` in the frame of light from `source`.
    ///
    /// # Errors
    /// [`Unrenderable::LightInMesh`](crate::unrenderable::Unrenderable::LightInMesh).
    pub(super) fn new(bodies: &[Body], source: &Source) -> Result<Self, Error> {
        let position = |position: &[f32; 3]| glam::Vec3::from_array(*position).as_dvec3();
        let limits = |points: &[DVec3]| {
            let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
            points.iter().fold(empty, |[low, high], point| [low.min(*point), high.max(*point)])
        };
        let all = |limits: &[[DVec3; 2]]| limits.concat();
        let boxes: Vec<[DVec3; 2]> = bodies
            .iter()
            .map(|body| limits(&body.mesh.positions.par_iter().map(position).collect::<Vec<_>>()))
            .collect();
        let mut frame = Frame::new(source, limits(&all(&boxes)))?;
        let turned: Vec<Vec<DVec3>> = bodies
            .iter()
            .map(|body| body.mesh.positions.par_iter().map(|at| frame.turned(position(at))).collect())
            .collect();
        let boxes: Vec<[DVec3; 2]> = turned.iter().map(|points| limits(points)).collect();
        let bounds = frame.scale(source, limits(&all(&boxes)));
        let scaled = |at: DVec3| (at * frame.widths()).to_array();
        let corners = |(body, points): (&Body, &Vec<DVec3>)| {
            body.mesh.triangles.par_iter().map(|triangle| triangle.map(|at| scaled(points[at as usize]))).collect()
        };
        Ok(Self { bounds, bodies: bodies.iter().zip(&turned).map(corners).collect(), frame })
    }
}
