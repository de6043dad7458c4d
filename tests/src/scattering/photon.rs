//! Photons: where they start, and what becomes of them.

use super::{Ball, Lamp, Medium, Random, Scene};
use std::f64::consts::{PI, TAU};
use vitrum_kernels::glam::DVec3;

/// A photon of a source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Photon {
    /// Where it is.
    pub at: DVec3,
    /// Its unit direction.
    pub towards: DVec3,
    /// The flux, in W, that photons would have together if all were as this one: the mean over them is the source's
    /// flux.
    pub flux: f64,
}

/// What became of a photon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It left the box.
    Escaped,
    /// It was absorbed at a collision, counted from 1.
    Absorbed(u32),
}

impl Photon {
    /// A random photon of a scene's source; parallel light starts where it enters the box. If there is a ball, half of
    /// all photons go straight to it, and none of the other half.
    ///
    /// # Panics
    /// If the ball is not within the box, or the lamp is within the ball.
    pub fn start(scene: &Scene, random: &mut Random) -> Self {
        if let Some(ball) = scene.ball {
            assert!(ball.is_within(&scene.medium), "a ball is within the medium's box");
        }
        let to_ball = scene.ball.is_some() && random.happens(0.5);
        match scene.lamp {
            Lamp::Point { position, intensity } => of_point(scene.ball, position, intensity, to_ball, random),
            Lamp::Distant { direction, irradiance } => of_distant(scene, direction, irradiance, to_ball, random),
        }
    }

    /// Follows the photon to its end. `goes` gets it at the start of each straight part of its way, with the distances
    /// from there between which this is in the medium, to the ball or the box's end; and how often it was scattered
    /// before. Its free path is drawn after that.
    pub fn follow(
        mut self,
        scene: &Scene,
        random: &mut Random,
        mut goes: impl FnMut(&Self, [f64; 2], u32, &mut Random),
    ) -> End {
        let medium = &scene.medium;
        let mut collisions = 0;
        // Free paths have no memory: one that meets the ball starts anew behind it.
        loop {
            let Some([enters, leaves]) = medium.crossing(self.at, self.towards) else { return End::Escaped };
            let hit = scene.ball.and_then(|ball| Some((ball, ball.hit(self.at, self.towards)?)));
            let ends = hit.map_or(leaves, |(_, hit)| hit);
            goes(&self, [enters, ends], collisions, random);
            let flight = enters + random.exponential() / medium.extinction();
            if flight < ends {
                self.at += self.towards * flight;
                collisions += 1;
                if !random.happens(medium.albedo()) {
                    return End::Absorbed(collisions);
                }
                self.towards = medium.scatter(self.towards, random);
            } else if let Some((ball, hit)) = hit {
                [self.at, self.towards] = ball.pass(self.at + self.towards * hit, self.towards, random);
            } else {
                return End::Escaped;
            }
        }
    }
}

/// A photon of a point that shines to all sides.
fn of_point(ball: Option<Ball>, at: DVec3, intensity: f64, to_ball: bool, random: &mut Random) -> Photon {
    let Some(ball) = ball else {
        let cosine = 2.0 * random.share() - 1.0;
        return Photon { at, towards: random.around(DVec3::Z, cosine), flux: 4.0 * PI * intensity };
    };
    let way = ball.centre - at;
    let sine = ball.radius / way.length();
    assert!(sine < 1.0, "a lamp is outside of the ball");
    // The cone that touches the ball, or all other directions: in either, cosines are equally likely.
    let edge = (1.0 - sine * sine).sqrt();
    let [low, high] = if to_ball { [edge, 1.0] } else { [-1.0, edge] };
    let cosine = low + (high - low) * random.share();
    // Each half stands for the flux of its solid angle.
    let flux = intensity * TAU * (high - low) / 0.5;
    Photon { at, towards: random.around(way.normalize(), cosine), flux }
}

/// A photon of parallel light.
fn of_distant(scene: &Scene, towards: DVec3, irradiance: f64, to_ball: bool, random: &mut Random) -> Photon {
    let medium = &scene.medium;
    let half = if scene.ball.is_some() { 0.5 } else { 1.0 };
    if let (Some(ball), true) = (scene.ball, to_ball) {
        let (right, up) = towards.any_orthonormal_pair();
        let (sin, cos) = (TAU * random.share()).sin_cos();
        let across = ball.centre + (right * cos + up * sin) * (ball.radius * random.share().sqrt());
        let back = medium.crossing(across, -towards).map_or(0.0, |[_, way]| way);
        let flux = irradiance * PI * ball.radius * ball.radius / half;
        return Photon { at: across - towards * back, towards, flux };
    }
    // The rest of the box's faces that it meets: a photon that would meet the ball is drawn again.
    let faces = faces(medium, towards);
    let whole: f64 = faces.iter().sum();
    let silhouette = scene.ball.map_or(0.0, |ball| PI * ball.radius * ball.radius);
    let flux = irradiance * (whole - silhouette) / half;
    loop {
        let at = on_faces(medium, towards, faces, random.share() * whole, random);
        if scene.ball.is_none_or(|ball| ball.hit(at, towards).is_none()) {
            return Photon { at, towards, flux };
        }
    }
}

/// The areas that the faces which light meets have across it, by their axes.
fn faces(medium: &Medium, towards: DVec3) -> [f64; 3] {
    let size = medium.high - medium.low;
    [size.y * size.z * towards.x.abs(), size.z * size.x * towards.y.abs(), size.x * size.y * towards.z.abs()]
}

/// A random point of the face that is `which` of the way through the areas.
fn on_faces(medium: &Medium, towards: DVec3, faces: [f64; 3], which: f64, random: &mut Random) -> DVec3 {
    let axis = if which < faces[0] { 0 } else { 1 + usize::from(which >= faces[0] + faces[1]) };
    let shares = DVec3::new(random.share(), random.share(), random.share());
    let mut at = medium.low + (medium.high - medium.low) * shares;
    at[axis] = if towards[axis] > 0.0 { medium.low[axis] } else { medium.high[axis] };
    at
}
