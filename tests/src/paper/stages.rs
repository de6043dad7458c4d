//! The stages of a frame of beams: the kernels of each, and the time that they take.

use vitrum::backend::KernelTime;

/// A stage of a frame of beams.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Rays of light, and beams of them: the paper's caustics buffer.
    Trace,
    /// Beams on the picture: volume caustics, and the shadow that the paper has with its airlight.
    Scatter,
    /// Viewing rays, the airlight along them, and beams that are seen behind surfaces.
    View,
    /// Light on diffuse surfaces.
    Surfaces,
    /// The sum of the parts.
    Compose,
}

impl Stage {
    /// Every stage, in the order of a table's columns.
    pub const ALL: [Self; 5] = [Self::Trace, Self::Scatter, Self::View, Self::Surfaces, Self::Compose];

    /// The name of its column.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Trace => "trace",
            Self::Scatter => "scatter",
            Self::View => "view",
            Self::Surfaces => "surfaces",
            Self::Compose => "compose",
        }
    }

    /// The stage of a kernel; `None` if it is none of beams.
    #[must_use]
    pub fn of(kernel: &str) -> Option<Self> {
        Some(match kernel.strip_prefix("beams_")? {
            "trace_light" | "store_beam" | "bound_beams" => Self::Trace,
            "map_faces" | "refract_maps" | "trace_maps" => Self::Trace,
            "find_curved" | "split_texels" | "drop_beam" => Self::Trace,
            "project_beam" | "scatter_beam" | "find_depths" | "look_around" => Self::Scatter,
            "integrate_beam" | "integrate_view" | "add_depths" => Self::Scatter,
            "trace_view" | "see" | "gather" => Self::View,
            "deposit_beam" | "light_cell" | "exchange_light" | "see_cells" => Self::View,
            "find_light" | "light_surface" => Self::Surfaces,
            "resolve" => Self::Compose,
            _ => return None,
        })
    }

    /// The milliseconds of each stage in [`Self::ALL`].
    #[must_use]
    pub fn times(kernels: &[KernelTime]) -> [f64; 5] {
        Self::ALL
            .map(|stage| kernels.iter().filter(|time| Self::of(time.kernel) == Some(stage)).map(|time| time.ms).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::kernel::kernels;

    #[test]
    fn every_kernel_of_beams_is_of_a_stage() {
        let names = kernels::ALL.iter().map(|kernel| kernel.declaration.name);
        let beams: Vec<&str> = names.filter(|name| name.starts_with("beams_")).collect();
        assert!(beams.len() >= 12, "{beams:?}");
        for name in beams {
            assert!(Stage::of(name).is_some(), "{name}");
        }
        assert_eq!(Stage::of("sweep_resolve"), None);
    }

    #[test]
    fn times_add_up_by_stage() {
        let time = |kernel, ms| KernelTime { kernel, passes: 1, ms };
        let kernels = [time("beams_see", 1.0), time("beams_scatter_beam", 4.0), time("beams_gather", 2.0)];
        assert_eq!(Stage::times(&kernels), [0.0, 4.0, 3.0, 0.0, 0.0]);
    }
}
