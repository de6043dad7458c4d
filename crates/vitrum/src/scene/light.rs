//! Lights: distant ones, points and spots.

use super::{Rgb, Scene, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The form of a light source.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LightKind {
    /// A source infinitely far away, as the sun: its light has one direction and is equally strong everywhere.
    #[default]
    Distant,
    /// A point, or a ball, that shines equally to all sides.
    Point,
    /// A point, or a ball, that shines into a cone.
    Spot,
}

impl LightKind {
    /// Its name in scene files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Distant => "distant",
            Self::Point => "point",
            Self::Spot => "spot",
        }
    }
}

/// The frame that a light turns with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Attachment {
    /// The camera's frame, so that the light turns with the camera.
    Camera,
    /// The world's frame.
    World,
}

/// A light source. Keys that its kind does not have must keep their defaults.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Light {
    /// Form of the source.
    pub kind: LightKind,
    /// Strength, linear RGB, times `intensity`. Of a distant light: the radiance of a white diffuse surface that faces it, which is its
    /// irradiance over π. Of the others: the same at a distance of one world unit, which is their radiant intensity over π; it falls with the
    /// square of the distance.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "radiance"))]
    pub color: Rgb,
    /// Factor on `color`.
    #[schemars(range(min = 0, max = 1e9))]
    pub intensity: f32,
    /// Whether the volume or mesh casts shadows, colours light and focuses it. `false` leaves the light unoccluded everywhere, without
    /// caustics, and takes much less time.
    pub shadows: bool,
    /// Frame of the angles, the direction and the position. If absent `camera` for a distant light, else `world`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attachment: Option<Attachment>,
    /// Side that a distant light comes from: 0 is from the camera (in the world: from the front), positive from the right.
    #[schemars(extend("x-unit" = "degrees"))]
    pub azimuth: f32,
    /// Height above the horizon that a distant light comes from.
    #[schemars(range(min = -90, max = 90), extend("x-unit" = "degrees"))]
    pub elevation: f32,
    /// Direction that the light of a distant source, or of a spot's axis, travels in, of any length but 0. In the camera's axes (x right, y
    /// up, z towards the viewer) or the world's, by `attachment`. It replaces the angles of a distant light; if absent a spot shines at the
    /// middle of the volume or mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "three numbers, not all 0"))]
    pub direction: Option<Vector>,
    /// Angular radius of a distant source, as seen from the scene; the sun's is 0.27. 0 casts crisp shadows.
    #[schemars(range(min = 0, max = 45), extend("x-unit" = "degrees"))]
    pub angular_radius: f32,
    /// Place of a point or spot, which need one: in the world, or by `attachment` from the camera's target in the camera's axes. Where it casts
    /// shadows it stands outside of the box around the mesh, at least 1/64 of the box's diagonal away, or outside of that around the volume, all
    /// of which it sees within 80° of one direction.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units"))]
    pub position: Option<Vector>,
    /// Radius of the ball that a point or spot shines from; 0 casts crisp shadows. It counts where `shadow.samples` is above 1.
    #[schemars(range(min = 0, max = 1e6), extend("x-unit" = "world units"))]
    pub radius: f32,
    /// Half-angle of a spot's cone, from its axis to its edge.
    #[schemars(range(min = 0.1, max = 89), extend("x-unit" = "degrees"))]
    pub cone_angle: f32,
    /// Share of a spot's half-angle, at the edge, over which its light fades smoothly to nothing; 0 gives a crisp edge.
    #[schemars(range(min = 0, max = 1))]
    pub penumbra: f32,
    /// Picture (HDR, EXR, PNG, JPEG, TIFF) that a spot projects: the square around its cone, upright for one who looks along its axis; a
    /// factor on `color`. A relative path starts at the scene file's folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a path"))]
    pub texture: Option<std::path::PathBuf>,
}

impl Light {
    /// A light of a kind, with the defaults of all keys. A point or spot needs a position besides.
    #[must_use]
    pub fn of_kind(kind: LightKind) -> Self {
        let mut light = Self { kind, ..Self::default() };
        light.forget_foreign_keys();
        light
    }

    /// The frame of its angles, direction and position, said or not.
    #[must_use]
    pub fn attachment(&self) -> Attachment {
        match (self.attachment, self.kind) {
            (Some(attachment), _) => attachment,
            (None, LightKind::Distant) => Attachment::Camera,
            (None, LightKind::Point | LightKind::Spot) => Attachment::World,
        }
    }

    /// The angular radius of a distant source, in degrees; 0 of the others, which have none.
    pub(crate) fn disc(&self) -> f32 {
        if self.kind == LightKind::Distant { self.angular_radius } else { 0.0 }
    }

    /// The first key that is given and that lights of its kind do not have.
    pub(super) fn foreign_key(&self) -> Option<&'static str> {
        let usual = Self::default();
        let distant = self.kind == LightKind::Distant;
        let spot = self.kind == LightKind::Spot;
        [
            ("azimuth", distant || self.azimuth == usual.azimuth),
            ("elevation", distant || self.elevation == usual.elevation),
            ("angular_radius", distant || self.angular_radius == usual.angular_radius),
            ("direction", self.kind != LightKind::Point || self.direction.is_none()),
            ("position", !distant || self.position.is_none()),
            ("radius", !distant || self.radius == usual.radius),
            ("cone_angle", spot || self.cone_angle == usual.cone_angle),
            ("penumbra", spot || self.penumbra == usual.penumbra),
            ("texture", spot || self.texture.is_none()),
        ]
        .into_iter()
        .find_map(|(key, fits)| (!fits).then_some(key))
    }

    /// Gives the keys that lights of its kind do not have their defaults, as a change of the kind does.
    pub(super) fn forget_foreign_keys(&mut self) {
        let usual = Self::default();
        let kind = self.kind;
        if kind != LightKind::Distant {
            (self.azimuth, self.elevation) = (usual.azimuth, usual.elevation);
            self.angular_radius = usual.angular_radius;
        }
        if kind == LightKind::Point {
            self.direction = None;
        }
        if kind == LightKind::Distant {
            (self.position, self.radius) = (None, usual.radius);
        }
        if kind != LightKind::Spot {
            (self.cone_angle, self.penumbra, self.texture) = (usual.cone_angle, usual.penumbra, None);
        }
    }
}

/// The light of a scene without any: it is black, and shines along the viewing direction.
static DARKNESS: Light = Light {
    kind: LightKind::Distant,
    color: [0.0; 3],
    intensity: 0.0,
    shadows: false,
    attachment: Some(Attachment::Camera),
    azimuth: 0.0,
    elevation: 0.0,
    direction: None,
    angular_radius: 0.0,
    position: None,
    radius: 0.0,
    cone_angle: 30.0,
    penumbra: 0.0,
    texture: None,
};

impl Scene {
    /// The first light, or a black one if there is none.
    pub(crate) fn first_light(&self) -> &Light {
        self.light.first().unwrap_or(&DARKNESS)
    }
}

impl Default for Light {
    fn default() -> Self {
        Self {
            kind: LightKind::Distant,
            color: [1.0, 1.0, 1.0],
            intensity: 1.0,
            shadows: true,
            attachment: None,
            azimuth: -35.0,
            elevation: 40.0,
            direction: None,
            angular_radius: 1.0,
            position: None,
            radius: 0.0,
            cone_angle: 30.0,
            penumbra: 0.1,
            texture: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_of_the_kind_leaves_no_key_of_another_kind() {
        let all = Light {
            azimuth: 1.0,
            elevation: 2.0,
            angular_radius: 3.0,
            direction: Some([1.0, 0.0, 0.0]),
            position: Some([1.0; 3]),
            radius: 1.0,
            cone_angle: 10.0,
            penumbra: 0.5,
            texture: Some("slide.png".into()),
            ..Light::default()
        };
        for kind in [LightKind::Distant, LightKind::Point, LightKind::Spot] {
            let mut light = Light { kind, ..all.clone() };
            assert!(light.foreign_key().is_some(), "{kind:?}");
            light.forget_foreign_keys();
            assert_eq!(light.foreign_key(), None, "{kind:?}");
        }
    }

    #[test]
    fn a_distant_light_turns_with_the_camera_and_others_stay_in_the_world() {
        let of = |kind| Light { kind, ..Light::default() }.attachment();
        assert_eq!(of(LightKind::Distant), Attachment::Camera);
        assert_eq!([LightKind::Point, LightKind::Spot].map(of), [Attachment::World; 2]);
    }
}
