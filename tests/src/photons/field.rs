//! A volume as a continuous medium, in double precision.

use vitrum::io::Volume;
use vitrum::method::View;
use vitrum::scene::{Scene, TransferFunction};
use vitrum_kernels::glam::{DMat3, DVec3};

/// The medium between voxels: how ∇(η²) follows from them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slopes {
    /// Central differences over one voxel on either side, which six neighbours give (sweep §5): the medium that the sweep's default defines.
    SixNeighbours,
    /// The derivative of η as it is interpolated, which jumps from voxel to voxel.
    Interpolated,
}

impl Slopes {
    /// Half the distance over which a difference is taken, in voxels.
    fn half_step(self) -> f64 {
        match self {
            Self::SixNeighbours => 1.0,
            Self::Interpolated => 0.05,
        }
    }
}

/// A refracting, absorbing medium in the view frame.
pub struct Field<'a> {
    volume: &'a Volume,
    transfer: &'a TransferFunction,
    /// The volume's values, x fastest, as a copy: a look-up in the volume itself is half of a photon's time.
    values: Vec<f32>,
    /// Voxel coordinates of a point of the view frame: `to_voxels · point + offset`.
    to_voxels: DMat3,
    offset: DVec3,
    reference_length: f64,
    /// The index of refraction outside of the volume's box.
    surroundings: f64,
    slopes: Slopes,
}

impl<'a> Field<'a> {
    /// The medium of a scene's volume, seen from `view`.
    #[must_use]
    pub fn new(volume: &'a Volume, scene: &'a Scene, view: &View, slopes: Slopes) -> Self {
        let transfer = &scene.transfer;
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let step = |axis: usize| vector(volume.axes[axis]) * f64::from(volume.spacing[axis]);
        let inverse = DMat3::from_cols(step(0), step(1), step(2)).inverse();
        let finest = volume.finest_spacing();
        let [width, height, depth] = volume.dimensions;
        let row = |y, z| (0..width).map(move |x| volume.value(x, y, z));
        let values = (0..depth).flat_map(|z| (0..height).flat_map(move |y| row(y, z))).collect();
        Self {
            volume,
            transfer,
            values,
            to_voxels: inverse * view.axes,
            offset: inverse * (view.eye - vector(volume.origin)),
            reference_length: f64::from(transfer.reference_length.unwrap_or(finest)),
            surroundings: f64::from(scene.surroundings.ior),
            slopes,
        }
    }

    /// The edge of a voxel.
    #[must_use]
    pub fn voxel(&self) -> f64 {
        self.volume.finest_spacing().into()
    }

    /// The parameters at which a ray enters and leaves the volume's box; `None` if it misses it.
    #[must_use]
    pub fn crossing(&self, from: DVec3, direction: DVec3) -> Option<(f64, f64)> {
        let (from, along) = (self.to_voxels * from + self.offset, self.to_voxels * direction);
        let (mut enters, mut leaves) = (0.0f64, f64::INFINITY);
        for axis in 0..3 {
            let far = f64::from(self.volume.dimensions[axis]) - 0.5;
            let (a, b) = ((-0.5 - from[axis]) / along[axis], (far - from[axis]) / along[axis]);
            if along[axis] == 0.0 {
                if !(-0.5..=far).contains(&from[axis]) {
                    return None;
                }
            } else {
                enters = enters.max(a.min(b));
                leaves = leaves.min(a.max(b));
            }
        }
        (enters < leaves).then_some((enters, leaves))
    }

    /// Whether a point lies in the volume's box.
    #[must_use]
    pub fn contains(&self, point: DVec3) -> bool {
        let at = self.to_voxels * point + self.offset;
        (0..3).all(|axis| (-0.5..=f64::from(self.volume.dimensions[axis]) - 0.5).contains(&at[axis]))
    }

    /// The unit normal, on either side, of the face of the box that is nearest to a point on the box, in the view frame.
    fn face(&self, point: DVec3) -> DVec3 {
        let at = self.to_voxels * point + self.offset;
        let beyond = |axis: usize| {
            let half = 0.5 * f64::from(self.volume.dimensions[axis]);
            (at[axis] + 0.5 - half).abs() - half
        };
        let axis = (0..3).max_by(|&a, &b| beyond(a).total_cmp(&beyond(b))).unwrap_or(0);
        self.to_voxels.row(axis).normalize()
    }

    /// The optical direction behind the box's face at `point` (Snell's law), into the box if `enters`, else out of it; without its part along
    /// the normal turned round if all is reflected.
    #[must_use]
    pub fn refracted(&self, point: DVec3, direction: DVec3, enters: bool) -> DVec3 {
        let normal = self.face(point);
        let across = normal * direction.dot(normal);
        let along = direction - across;
        let behind = if enters { self.ior(self.to_voxels * point + self.offset) } else { self.surroundings };
        let square = behind * behind - along.length_squared();
        along + if square > 0.0 { across.normalize() * square.sqrt() } else { -across }
    }

    /// The index of refraction outside of the box.
    #[must_use]
    pub fn surroundings(&self) -> f64 {
        self.surroundings
    }

    /// The scalar at voxel coordinates: trilinear, beyond the outermost voxels' centres theirs.
    fn scalar(&self, at: DVec3) -> f64 {
        let size = self.volume.dimensions;
        let limited: [f64; 3] = std::array::from_fn(|axis| at[axis].clamp(0.0, f64::from(size[axis]) - 1.0));
        let low = limited.map(|x| x.floor() as u32);
        let mut sum = 0.0;
        for corner in 0..8u32 {
            let mut weight = 1.0;
            let mut index = [0; 3];
            for axis in 0..3 {
                let up = corner >> axis & 1;
                let fraction = limited[axis] - f64::from(low[axis]);
                weight *= if up == 1 { fraction } else { 1.0 - fraction };
                index[axis] = (low[axis] + up).min(size[axis] - 1);
            }
            let at = (index[2] as usize * size[1] as usize + index[1] as usize) * size[0] as usize + index[0] as usize;
            sum += weight * f64::from(self.values[at]);
        }
        sum
    }

    /// The index of refraction at voxel coordinates.
    fn ior(&self, at: DVec3) -> f64 {
        let points = self.transfer.ior.iter().map(|point| (f64::from(point.value), [f64::from(point.ior); 3]));
        interpolate(points, self.scalar(at)).map_or(1.0, |ior| ior[0])
    }

    /// ½∇(η²) at a point of the volume, per world unit, in the view frame.
    #[must_use]
    pub fn acceleration(&self, point: DVec3) -> DVec3 {
        let at = self.to_voxels * point + self.offset;
        let half_square = |at: DVec3| 0.5 * self.ior(at).powi(2);
        let half = self.slopes.half_step();
        let slope = |axis: DVec3| (half_square(at + axis * half) - half_square(at - axis * half)) / (2.0 * half);
        self.to_voxels.transpose() * DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z))
    }

    /// Extinction of red, green and blue at a point of the volume, per world unit.
    #[must_use]
    pub fn extinction(&self, point: DVec3) -> DVec3 {
        let scalar = self.scalar(self.to_voxels * point + self.offset);
        let medium = self.transfer.filter.iter().map(|point| (f64::from(point.value), point.color.map(f64::from)));
        let opacity = self.transfer.opacity.iter().map(|point| (f64::from(point.value), [f64::from(point.opacity); 3]));
        let depth = |share: f64| -share.max(1e-6).ln() / self.reference_length;
        let medium = interpolate(medium, scalar).unwrap_or([1.0; 3]);
        let opacity = interpolate(opacity, scalar).unwrap_or([0.0; 3]);
        DVec3::from_array(std::array::from_fn(|channel| depth(medium[channel]) + depth(1.0 - opacity[channel])))
    }
}

/// A piecewise linear function, constant beyond its ends; `None` if it has no point.
fn interpolate(points: impl Iterator<Item = (f64, [f64; 3])>, at: f64) -> Option<[f64; 3]> {
    let mut before: Option<(f64, [f64; 3])> = None;
    for (value, result) in points {
        if at < value {
            let Some((low, start)) = before else { return Some(result) };
            let t = (at - low) / (value - low);
            return Some(std::array::from_fn(|i| start[i] + (result[i] - start[i]) * t));
        }
        before = Some((value, result));
    }
    before.map(|(_, result)| result)
}
