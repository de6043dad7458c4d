//! The flags that change the transfer function.

use clap::Args;
use std::path::PathBuf;
use vitrum::preset::{self, Adjustments, Surface};
use vitrum::scene::GradientPoint;

/// The transfer function's file and changes; what they set are the keys of `transfer`.
#[derive(Debug, Clone, Args)]
pub struct TransferArguments {
    /// Take the transfer function of a file: 3D Slicer's volume property (.vp, .json, MRML), ParaView's colour map (.json, .xml, .pvsm), VTK's
    /// functions (XML, or a point a line); FILE#NAME takes one of several
    #[arg(long, value_name = "FILE")]
    pub transfer: Option<PathBuf>,

    /// Show nothing of values below; a preset is fitted to those above
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
    pub threshold: Option<f32>,

    /// Width of the window of values over which the transfer function changes; with --level
    #[arg(long, value_name = "WIDTH", requires = "level")]
    pub window: Option<f32>,

    /// Middle of the window of values; with --window
    #[arg(long, value_name = "LEVEL", requires = "window", allow_negative_numbers = true)]
    pub level: Option<f32>,

    /// Colour values by a map, such as viridis
    #[arg(long, value_name = "NAME", long_help = colormap_help())]
    pub colormap: Option<String>,

    /// Show the surface where the value is VALUE, in the preset's colour or another, opaque or with an opacity from 0 to 1, such as 300:ivory:0.4; repeatable.
    /// Without --preset a volume file then shows surfaces alone
    #[arg(long, value_name = "VALUE[:COLOR[:OPACITY]]", allow_hyphen_values = true)]
    pub isosurface: Vec<Surface>,

    /// Multiply the extinction by FACTOR where the value changes by MAGNITUDE over a voxel, such as 20:0,100:1 to show boundaries alone; `vitrum info` shows
    /// common magnitudes
    #[arg(long, value_name = "MAGNITUDE:FACTOR", value_delimiter = ',')]
    pub gradient_opacity: Vec<GradientPoint>,
}

impl TransferArguments {
    /// The changes.
    pub fn adjustments(&self) -> Adjustments {
        let window = self.window.zip(self.level).map(|(width, level)| [width, level]);
        let (colormap, isosurfaces) = (self.colormap.clone(), self.isosurface.clone());
        let mut gradient = self.gradient_opacity.clone();
        gradient.sort_by(|a, b| a.magnitude.total_cmp(&b.magnitude));
        Adjustments { threshold: self.threshold, window, colormap, isosurfaces, gradient }
    }
}

/// The help of `--colormap`, with all names.
fn colormap_help() -> String {
    let mut text =
        "Colour values by a map, over the window, or else over the values that the transfer function shows. The maps:"
            .to_owned();
    for (name, description) in preset::colormap_names() {
        text.push_str(&format!("\n  {name:12} {}", description.trim_start_matches("a map of colours: ")));
    }
    text
}
