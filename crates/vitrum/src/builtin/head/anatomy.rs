//! Anatomy of the head: signed distances from a point to the surfaces of tissues, negative inside.

use super::super::noise::{gradient, vector};
use super::super::shapes::{ellipsoid, smooth_difference, smooth_union, smoothstep, tube};
use glam::Vec3;

/// The tissues around one point of the left half (x ≥ 0); the head faces +y.
pub(super) struct Anatomy {
    position: Vec3,
    /// Signed distance to the inner face of the skull's vault.
    cavity: f32,
}

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// Centre of the skull's vault.
const VAULT: Vec3 = v(0.0, -0.08, 0.36);

impl Anatomy {
    pub fn new(position: Vec3) -> Self {
        Self { position, cavity: ellipsoid(position, VAULT, v(0.375, 0.495, 0.435)) }
    }

    /// Signed distance to the skin.
    pub fn skin(&self) -> f32 {
        let p = self.position;
        let blob = |centre, radii| ellipsoid(p, centre, radii);
        let neck = tube(p, (v(0.0, -0.16, -0.15), 0.31), (v(0.0, -0.18, -1.4), 0.37));
        let jowl = tube(p, (v(0.20, 0.12, -0.29), 0.145), (v(0.265, 0.01, 0.02), 0.155));
        let mut skin = blob(v(0.0, -0.08, 0.36), v(0.46, 0.59, 0.56));
        skin = smooth_union(skin, neck, 0.16);
        skin = smooth_union(skin, blob(v(0.0, 0.17, -0.04), v(0.35, 0.36, 0.47)), 0.12);
        skin = smooth_union(skin, jowl, 0.12);
        if skin.abs() > FEATURES {
            return skin;
        }
        if p.y > 0.0 {
            skin = smooth_union(skin, blob(v(0.0, 0.42, -0.42), v(0.14, 0.10, 0.09)), 0.12);
            skin = smooth_union(skin, blob(v(0.17, 0.36, -0.10), v(0.15, 0.13, 0.14)), 0.10);
            skin = smooth_union(skin, blob(v(0.12, 0.43, 0.17), v(0.15, 0.08, 0.06)), 0.10);
            skin = smooth_difference(skin, blob(v(0.165, 0.55, 0.06), v(0.09, 0.10, 0.055)), 0.09);
            skin = smooth_union(skin, blob(v(0.165, 0.405, 0.06), v(0.10, 0.10, 0.09)), 0.03);
            let bridge = tube(p, (v(0.0, 0.50, 0.12), 0.045), (v(0.0, 0.60, -0.065), 0.055));
            let wings = blob(v(0.055, 0.555, -0.085), v(0.05, 0.06, 0.04));
            skin = smooth_union(skin, smooth_union(bridge, wings, 0.04), 0.06);
            skin = smooth_union(skin, blob(v(0.0, 0.525, -0.225), v(0.11, 0.045, 0.030)), 0.05);
            skin = smooth_union(skin, blob(v(0.0, 0.515, -0.285), v(0.09, 0.045, 0.030)), 0.05);
        }
        let ear = blob(v(0.44, -0.08, 0.04), v(0.050, 0.10, 0.15));
        let concha = blob(v(0.50, -0.05, 0.03), v(0.05, 0.05, 0.08));
        smooth_union(skin, smooth_difference(ear, concha, 0.03), 0.05)
    }

    /// Signed distance to the brain: a folded cerebrum, the cerebellum and the brain stem with the spinal cord.
    pub fn brain(&self) -> f32 {
        let p = self.position;
        let stem = tube(p, (v(0.0, -0.12, 0.18), 0.085), (v(0.0, -0.33, -0.30), 0.045));
        let cord = tube(p, (v(0.0, -0.33, -0.30), 0.040), (v(0.0, -0.36, -1.1), 0.040));
        let stem = smooth_union(stem, cord, 0.03);
        if self.cavity > 0.0 {
            return stem;
        }
        // Sulci run where noise vanishes; the hemispheres part in the middle.
        let mut cerebrum = (self.cavity + 0.02).max(0.09 - p.z + 0.25 * (-0.25 - p.y).max(0.0));
        if cerebrum > -0.12 {
            let noise = gradient(p * 5.5 + 0.35 * vector(p * 6.0, 71), 73);
            cerebrum += 0.085 * smoothstep(0.13, 0.0, noise.abs());
        }
        cerebrum = smooth_difference(cerebrum, (p.x - 0.012).max(0.36 - p.z), 0.03);
        let ventricle = ellipsoid(p, v(0.06, -0.06, 0.36), v(0.035, 0.20, 0.055));
        cerebrum = smooth_difference(cerebrum, ventricle, 0.02);
        let folia = 0.012 * triangle_wave(p.z * 28.0 + p.y * 6.0);
        let cerebellum = ellipsoid(p, v(0.13, -0.32, 0.04), v(0.17, 0.17, 0.12)) + folia;
        stem.min(cerebrum).min(cerebellum.max(self.cavity + 0.02))
    }

    /// Signed distance to bone: the skull with its openings, jaw and teeth, and the spine.
    pub fn bone(&self) -> f32 {
        let p = self.position;
        let outer = ellipsoid(p, VAULT, v(0.415, 0.537, 0.480));
        let mut bone = outer.max(-self.cavity);
        if p.y > -0.15 && p.z < 0.4 {
            bone = self.face(bone);
        }
        // The foramen magnum.
        bone = smooth_difference(bone, tube(p, (v(0.0, -0.2, 0.0), 0.08), (v(0.0, -0.32, -0.3), 0.08)), 0.03);
        if p.z < -0.1 && p.y < 0.1 { bone.min(self.spine()) } else { bone }
    }

    /// The union of `vault` with the facial skull.
    fn face(&self, vault: f32) -> f32 {
        let p = self.position;
        let blob = |centre, radii| ellipsoid(p, centre, radii);
        let bar = |start, end, radius| tube(p, (start, radius), (end, radius));
        let mut bone = smooth_union(vault, blob(v(0.0, 0.30, -0.07), v(0.22, 0.17, 0.17)), 0.06);
        bone = smooth_union(bone, blob(v(0.13, 0.40, 0.165), v(0.16, 0.06, 0.035)), 0.05);
        bone = smooth_union(bone, blob(v(0.245, 0.33, -0.03), v(0.07, 0.07, 0.06)), 0.05);
        bone = smooth_union(bone, bar(v(0.26, 0.32, -0.02), v(0.345, 0.12, 0.0), 0.024), 0.03);
        bone = smooth_union(bone, bar(v(0.345, 0.12, 0.0), v(0.33, -0.06, 0.03), 0.024), 0.03);
        bone = smooth_union(bone, blob(v(0.30, -0.15, -0.07), v(0.055, 0.07, 0.10)), 0.05);
        bone = smooth_union(bone, bar(v(0.0, 0.44, 0.14), v(0.0, 0.51, 0.06), 0.026), 0.03);
        let orbit = blob(v(0.165, 0.42, 0.065), v(0.105, 0.17, 0.090));
        let nose = blob(v(0.0, 0.42, -0.045), v(0.068, 0.20, 0.105));
        let sinuses = self.sinuses(0.018);
        bone = smooth_difference(bone, orbit.min(nose).min(sinuses), 0.02);
        bone.min(self.jaw())
    }

    /// The mandible and the teeth.
    fn jaw(&self) -> f32 {
        let p = self.position;
        let bar = |start, end| tube(p, start, end);
        let chin = bar((v(0.0, 0.425, -0.41), 0.055), (v(0.13, 0.38, -0.40), 0.048));
        let body = bar((v(0.13, 0.38, -0.40), 0.048), (v(0.255, 0.08, -0.33), 0.045));
        let ramus = bar((v(0.255, 0.08, -0.33), 0.045), (v(0.315, 0.03, -0.03), 0.032));
        let jaw = smooth_union(smooth_union(chin, body, 0.05), ramus, 0.05);
        let tooth = |&[x, y]: &[f32; 2]| {
            let upper = bar((v(x, y, -0.14), 0.022), (v(x, y + 0.01, -0.232), 0.026));
            let lower = bar((v(x, y - 0.015, -0.36), 0.022), (v(x, y - 0.005, -0.272), 0.024));
            upper.min(lower)
        };
        TEETH.iter().map(tooth).fold(jaw, f32::min)
    }

    /// The cervical vertebrae, one every [`VERTEBRA`] world units.
    fn spine(&self) -> f32 {
        let p = self.position;
        let number = ((-0.24 - p.z) / VERTEBRA).max(0.0) as i32 as f32;
        let p = v(p.x, p.y, p.z + 0.24 + (number + 0.5) * VERTEBRA);
        let body = ellipsoid(p, v(0.0, -0.21, 0.0), v(0.115, 0.085, 0.058));
        let arch = ellipsoid(p, v(0.0, -0.345, -0.005), v(0.105, 0.085, 0.040));
        let wing = tube(p, (v(0.06, -0.25, 0.0), 0.035), (v(0.175, -0.25, -0.01), 0.026));
        let spine = tube(p, (v(0.0, -0.39, 0.0), 0.030), (v(0.0, -0.455, -0.03), 0.022));
        let vertebra = smooth_union(smooth_union(body, arch, 0.04), wing.min(spine), 0.03);
        let canal = (v(p.x, p.y + 0.335, 0.0)).length() - 0.058;
        smooth_difference(vertebra, canal, 0.02)
    }

    /// Signed distance to the air inside: sinuses, nose, mouth and throat, ear canals.
    pub fn airways(&self) -> f32 {
        let p = self.position;
        if p.y < -0.2 {
            return f32::INFINITY;
        }
        let bar = |start, end, radius| tube(p, (start, radius), (end, radius));
        let nose = ellipsoid(p, v(0.032, 0.40, -0.045), v(0.026, 0.19, 0.088));
        let nostril = bar(v(0.034, 0.50, -0.09), v(0.036, 0.575, -0.14), 0.020);
        let throat = bar(v(0.0, 0.20, -0.06), v(0.0, 0.07, -0.20), 0.055)
            .min(bar(v(0.0, 0.07, -0.20), v(0.0, 0.03, -0.55), 0.060))
            .min(bar(v(0.0, 0.03, -0.55), v(0.0, 0.02, -1.2), 0.065));
        let ear = bar(v(0.48, -0.06, 0.03), v(0.28, -0.05, 0.02), 0.022);
        nose.min(nostril).min(throat).min(ear).min(self.sinuses(0.0))
    }

    /// Signed distance to the sinuses, widened by a lining.
    fn sinuses(&self, lining: f32) -> f32 {
        let blob = |centre, radii| ellipsoid(self.position, centre, radii);
        let maxillary = blob(v(0.145, 0.31, -0.075), v(0.062, 0.085, 0.075));
        let frontal = blob(v(0.065, 0.435, 0.185), v(0.050, 0.024, 0.034));
        let sphenoid = blob(v(0.045, 0.16, 0.01), v(0.036, 0.055, 0.040));
        maxillary.min(frontal).min(sphenoid) - lining
    }
}

/// Largest height or depth of a feature, such as the nose or an ear, over the head's large forms.
const FEATURES: f32 = 0.2;

/// Height of a vertebra and the disc below it.
const VERTEBRA: f32 = 0.145;

/// x and y of the teeth, from the middle to the back.
const TEETH: [[f32; 2]; 7] =
    [[0.026, 0.460], [0.078, 0.450], [0.124, 0.424], [0.158, 0.384], [0.180, 0.334], [0.194, 0.280], [0.202, 0.224]];

/// From −1 at whole numbers to 1 between them.
fn triangle_wave(at: f32) -> f32 {
    let share = at - (at as i32) as f32;
    1.0 - 2.0 * (2.0 * share.abs() - 1.0).abs()
}
