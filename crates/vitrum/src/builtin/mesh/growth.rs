//! Branches as tapered tubes.

use super::parts::Part;
use super::revolve::circle;
use glam::Vec3;

/// Straight pieces of a branch.
const PIECES: usize = 6;
/// Radius of a branch at its tip, over its radius at the base.
const TAPER: f32 = 0.35;

/// Numbers in 0…1, the same on every machine (a linear congruence with Knuth's constants, its upper bits scattered).
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 >> 33) ^ (self.0 >> 51);
        (mixed & 0x00ff_ffff) as f32 / 16_777_216.0
    }

    /// A unit vector; all directions are as likely.
    pub(super) fn direction(&mut self) -> Vec3 {
        loop {
            let point = Vec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0;
            let squared = point.length_squared();
            if (0.01..1.0).contains(&squared) {
                return point / squared.sqrt();
            }
        }
    }
}

/// A branch.
pub(super) struct Branch {
    pub(super) base: Vec3,
    /// Unit direction of the branch at its base.
    pub(super) direction: Vec3,
    pub(super) length: f32,
    /// At its base.
    pub(super) radius: f32,
    /// Amplitude by which the branch's direction wanders.
    pub(super) bend: f32,
}

impl Branch {
    /// The place at a part of the way along its joints, and the direction there.
    pub(super) fn at(&self, way: &[Vec3], part: f32) -> (Vec3, Vec3) {
        let along = part * (way.len() - 1) as f32 * 0.999;
        let joint = along as usize;
        let piece = way[joint + 1] - way[joint];
        (way[joint] + piece * (along - joint as f32), piece.normalize())
    }

    /// Radius of the branch at a part of its length, 0 to 1.
    pub(super) fn radius_at(&self, part: f32) -> f32 {
        self.radius * (1.0 - (1.0 - TAPER) * part)
    }
}

/// Branches, one after another.
#[derive(Default)]
pub(super) struct Wood {
    pub(super) part: Part,
}

impl Wood {
    /// Adds a branch and returns its joints.
    pub(super) fn add(&mut self, branch: &Branch, random: &mut Random) -> Vec<Vec3> {
        let mut way = vec![branch.base];
        let mut direction = branch.direction;
        for _ in 0..PIECES {
            let last = way[way.len() - 1];
            way.push(last + direction * (branch.length / PIECES as f32));
            // Towards the light, too.
            direction = (direction + random.direction() * branch.bend + Vec3::Z * (0.3 * branch.bend)).normalize();
        }
        self.tube(branch, &way);
        way
    }

    /// A tube around joints, open where it begins and with a tip where it ends.
    fn tube(&mut self, branch: &Branch, way: &[Vec3]) {
        // Thin ones need fewer sides.
        let turns = circle(u32::from(branch.radius > 0.012));
        let sides = turns.len() as u32;
        let Part { positions, triangles } = &mut self.part;
        let first = positions.len() as u32;
        let mut side = branch.direction.any_orthonormal_vector();
        for (joint, middle) in way[..PIECES].iter().enumerate() {
            let along = (way[joint + 1] - *middle).normalize();
            // The frame turns with the branch and no more.
            side = (side - along * side.dot(along)).normalize();
            let other = along.cross(side);
            let radius = branch.radius_at(joint as f32 / PIECES as f32);
            positions.extend(turns.iter().map(|turn| (*middle + (side * turn.x + other * turn.y) * radius).to_array()));
        }
        let tip = positions.len() as u32;
        positions.push(way[PIECES].to_array());
        for ring in 0..PIECES as u32 {
            for index in 0..sides {
                let vertex = |ring: u32, index: u32| first + ring * sides + index % sides;
                let (a, b) = (vertex(ring, index), vertex(ring, index + 1));
                if ring + 1 == PIECES as u32 {
                    triangles.push([a, b, tip]);
                } else {
                    let (c, d) = (vertex(ring + 1, index + 1), vertex(ring + 1, index));
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
}
