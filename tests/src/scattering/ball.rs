//! A clear ball: Snell's law and Fresnel's equations.

use super::{Medium, Random};
use crate::refraction::refract;
use vitrum_kernels::glam::DVec3;

/// A clear ball that absorbs nothing and has no medium inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub centre: DVec3,
    /// Its radius, in world units.
    pub radius: f64,
    /// Its index of refraction, above 1; that of the medium is 1.
    pub ior: f64,
}

impl Ball {
    /// The distance at which a ray from outside meets the ball.
    #[must_use]
    pub fn hit(&self, from: DVec3, towards: DVec3) -> Option<f64> {
        let from = from - self.centre;
        let middle = -from.dot(towards);
        let squared = self.radius * self.radius - (from + towards * middle).length_squared();
        // A ray that leaves the surface moves away from the centre, and does not meet it again.
        (middle > 0.0 && squared > 0.0).then(|| (middle - squared.sqrt()).max(0.0))
    }

    /// Whether the ball hides two points outside of it from each other.
    #[must_use]
    pub fn hides(&self, from: DVec3, to: DVec3) -> bool {
        let distance = (to - from).length();
        self.hit(from, (to - from) / distance).is_some_and(|hit| hit < distance)
    }

    /// Where light leaves the ball that comes from outside to a point of its surface, and its direction there. Whether
    /// it is mirrored or refracted is drawn at random at every surface, for light without polarization.
    pub fn pass(&self, at: DVec3, towards: DVec3, random: &mut Random) -> [DVec3; 2] {
        let mut normal = (at - self.centre).normalize();
        let Some(mut inside) = refract(towards, normal, 1.0, self.ior)
            .filter(|inside| !random.happens(reflectance(normal, towards, *inside, self.ior)))
        else {
            return [self.centre + normal * self.radius, mirrored(towards, normal)];
        };
        loop {
            normal = (normal - inside * (2.0 * normal.dot(inside))).normalize();
            let outside = refract(inside, normal, self.ior, 1.0);
            match outside.filter(|outside| !random.happens(reflectance(normal, *outside, inside, self.ior))) {
                Some(outside) => return [self.centre + normal * self.radius, outside],
                None => inside = mirrored(inside, normal),
            }
        }
    }

    /// Whether the whole ball lies in a medium's box.
    #[must_use]
    pub fn is_within(&self, medium: &Medium) -> bool {
        (self.centre - self.radius).cmpge(medium.low).all() && (self.centre + self.radius).cmple(medium.high).all()
    }
}

/// A unit direction after a mirror.
fn mirrored(towards: DVec3, normal: DVec3) -> DVec3 {
    (towards - normal * (2.0 * towards.dot(normal))).normalize()
}

/// The share that a surface mirrors, of either way round, by the directions on its two sides.
fn reflectance(normal: DVec3, outside: DVec3, inside: DVec3, ior: f64) -> f64 {
    let [outer, inner] = [outside, inside].map(|direction| direction.dot(normal).abs());
    let across = (outer - ior * inner) / (outer + ior * inner);
    let along = (inner - ior * outer) / (inner + ior * outer);
    0.5 * (across * across + along * along)
}
