//! The edges of the box around the subject.

use crate::Job;
use crate::canvas::{Canvas, Short};
use crate::style::Style;
use glam::DVec3;

/// Each axis, with the two others.
const AXES: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

pub fn add(job: &Job<'_>, style: &Style, canvas: &mut Canvas) {
    let corners = job.bounds.corners();
    let hidden = hidden_faces(job, &corners);
    let dashes =
        format!(" stroke-dasharray=\"{} {}\" opacity=\"0.6\"", Short(2.0 * style.line), Short(4.0 * style.line));
    // What is behind goes first, below the rest.
    for behind in [true, false] {
        for [axis, one, other] in AXES {
            for (low, high) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let first = low << one | high << other;
                let is_behind = hidden[one][low] && hidden[other][high];
                if is_behind != behind {
                    continue;
                }
                let ends = [corners[first], corners[first | 1 << axis]];
                if let Some([[ax, ay], [bx, by]]) = segment(job, ends) {
                    let [ax, ay, bx, by] = [ax, ay, bx, by].map(Short);
                    canvas.line(&format!("M{ax} {ay}L{bx} {by}"), style, if behind { &dashes } else { "" });
                }
            }
        }
    }
}

/// Whether the face at the low and the one at the high end of each axis is turned away from the eye.
fn hidden_faces(job: &Job<'_>, corners: &[DVec3; 8]) -> [[bool; 2]; 3] {
    std::array::from_fn(|axis| {
        std::array::from_fn(|end| {
            let [one, other] = [AXES[axis][1], AXES[axis][2]];
            let corner = corners[end << axis];
            let out = corners[1 << axis] - corners[0];
            let out = if end == 1 { out } else { -out };
            // Of a box that is no cuboid the normal is across the face all the same.
            let across = (corners[1 << one] - corners[0]).cross(corners[1 << other] - corners[0]);
            let normal = if across.dot(out) > 0.0 { across } else { -across };
            let towards = if job.view.orthographic { -job.view.axes.z_axis } else { job.view.eye - corner };
            normal.dot(towards) <= 0.0
        })
    })
}

/// The picture's ends of a segment of the world, as much of it as is before the eye.
pub fn segment(job: &Job<'_>, [from, to]: [DVec3; 2]) -> Option<[[f64; 2]; 2]> {
    let size = [job.scene.film.width, job.scene.film.height];
    let [mut from, mut to] = [from, to];
    if !job.view.orthographic {
        let [a, b] = [from, to].map(|end| job.view.point(end).z);
        let near = 1e-3 * job.view.target_depth.abs().max(1e-12);
        if a < near && b < near {
            return None;
        }
        if a < near {
            from += (to - from) * ((near - a) / (b - a));
        } else if b < near {
            to += (from - to) * ((near - b) / (a - b));
        }
    }
    Some([job.view.project(from, size)?, job.view.project(to, size)?])
}
