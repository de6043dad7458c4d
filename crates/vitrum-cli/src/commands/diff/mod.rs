//! `vitrum diff`: how two pictures differ, and whether that is within bounds.

mod parts;

use crate::failure::{Failure, Status};
use crate::output;
use clap::Args;
use parts::{Parts, color_channels};
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::io::{Picture, check_writable, read_picture, write_picture};
use vitrum_compare::{Bound, Comparison, Tolerance, Verdict, compare, difference_picture};

/// Compare two pictures in linear RGB, their alpha and layers of one name; with a limit it is a check, and exits 1 on a breach
#[derive(Debug, Args)]
pub struct Arguments {
    /// The reference
    a: PathBuf,

    /// The picture that is compared with it
    b: PathBuf,

    /// Largest difference of a channel that passes, also of alpha and of each layer
    #[arg(long, value_name = "X", value_parser = limit)]
    max_abs: Option<f64>,

    /// Largest root mean squared difference that passes, also of alpha and of each layer
    #[arg(long, value_name = "Y", value_parser = limit)]
    max_rmse: Option<f64>,

    /// Largest mean FLIP error of the colors that passes, 0 to 1
    #[arg(long, value_name = "Z", value_parser = limit)]
    max_flip: Option<f64>,

    /// Compare the colors alone, without alpha and further layers
    #[arg(long)]
    color_only: bool,

    /// Write the difference of the colors as a picture, its largest value scaled to white
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let output = arguments.output.as_deref();
    output.map_or(Ok(()), |file| output::check(file, check_writable))?;
    let (a, b) = (read_picture(&arguments.a)?, read_picture(&arguments.b)?);
    let size = |picture: &Picture| (picture.width, picture.height);
    let not_comparable = |problem: String| {
        let files = format!("{} and {}", arguments.a.display(), arguments.b.display());
        Failure::new(Status::Input, format!("{files}: {problem}"), "compare pictures of the same size")
    };
    if size(&a) != size(&b) {
        let [(aw, ah), (bw, bh)] = [size(&a), size(&b)];
        return Err(not_comparable(format!("{aw} x {ah} pixels cannot be compared with {bw} x {bh}")));
    }
    let (width, height) = size(&a);
    let not_compared = |error: vitrum_compare::CompareError| not_comparable(error.to_string());
    let parts = if arguments.color_only { Parts::default() } else { Parts::of(&a, &b).map_err(not_compared)? };
    let colors = a.layers.first().map(color_channels).unwrap_or_default().join(", ");
    let (a, b) = (a.color(), b.color());
    let comparison = compare(&a, &b, width, height).map_err(not_compared)?;
    if let Some(file) = output {
        let difference = difference_picture(&a, &b).map_err(not_compared)?;
        write_picture(file, &Picture::rgb(width, height, difference.pixels), &[])
            .map_err(|error| Failure::output(&error))?;
    }
    let measured = Measured { colors, comparison, parts };
    let breaches = arguments.breaches(&measured);
    if arguments.json {
        output::print_json(&measured.json(breaches.as_deref()))?;
    } else {
        output::print(&measured.text(breaches.as_deref()))?;
    }
    let passed = breaches.is_none_or(|breaches| breaches.is_empty());
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Arguments {
    /// The limits that the measurements exceed; `None` if no limit was given.
    fn breaches(&self, measured: &Measured) -> Option<Vec<String>> {
        let limits = Tolerance { max_abs: self.max_abs, rmse: self.max_rmse, ..Tolerance::default() };
        let tolerance = Tolerance { mean_flip: self.max_flip, ..limits };
        if tolerance == Tolerance::default() {
            return None;
        }
        let check = |name: &str, tolerance, comparison| match Bound::Tolerance(tolerance).check(comparison) {
            Verdict::Pass => None,
            Verdict::Fail(breaches) => {
                let breaches: Vec<_> = breaches.iter().map(ToString::to_string).collect();
                Some(format!("{name}{}", breaches.join("; ")))
            }
        };
        let mut breaches: Vec<_> = check("", tolerance, &measured.comparison).into_iter().collect();
        // FLIP is measured of colours alone.
        if limits != Tolerance::default() {
            let parts = measured.parts.both.iter();
            breaches.extend(parts.filter_map(|part| check(&format!("{}: ", part.name), limits, &part.comparison)));
        }
        Some(breaches)
    }
}

fn limit(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(limit) if f64::is_finite(limit) && limit >= 0.0 => Ok(limit),
        _ => Err("expected a finite number of at least 0".to_owned()),
    }
}

struct Measured {
    /// The channels of A's colours.
    colors: String,
    /// The comparison of the colours.
    comparison: Comparison,
    parts: Parts,
}

impl Measured {
    fn text(&self, breaches: Option<&[String]>) -> String {
        let Comparison { max_abs, rmse, psnr, peak, mean_flip, .. } = &self.comparison;
        let flip = mean_flip.map_or_else(|| "not measured".to_owned(), |flip| format!("{flip:.6}"));
        let place =
            |pixel: Option<(u32, u32)>| pixel.map_or_else(String::new, |(x, y)| format!(" at pixel ({x}, {y})"));
        let worst = place(self.comparison.worst_pixel());
        let mut text = format!(
            "max        {max_abs:.6e}{worst}\nRMSE       {rmse:.6e}\nPSNR       {psnr:.2} dB\nFLIP mean  {flip}\n\
             peak of A  {peak:.6}\n"
        );
        let Parts { both, only_a, only_b } = &self.parts;
        let names: Vec<_> = both.iter().map(|part| part.name.as_str()).collect();
        let compared: Vec<_> = std::iter::once(format!("color ({})", self.colors))
            .chain((!names.is_empty()).then(|| names.join(", ")))
            .collect();
        let mut row = |name: &str, value: String| text.push_str(&format!("{name:11}{value}\n"));
        row("compared", compared.join(", "));
        for (name, alone) in [("only in A", only_a), ("only in B", only_b)] {
            if !alone.is_empty() {
                row(name, alone.join(", "));
            }
        }
        for part in both.iter().filter(|part| part.comparison.max_abs > 0.0) {
            let Comparison { max_abs, rmse, .. } = part.comparison;
            row("differs", format!("{}: max {max_abs:.6e}{}, RMSE {rmse:.6e}", part.name, place(part.worst_pixel())));
        }
        match breaches {
            Some([]) => row("check", "pass".to_owned()),
            Some(breaches) => row("check", breaches.join("; ")),
            None => {}
        }
        text
    }

    /// The measurements as JSON; infinite values and NaN, for which JSON has no word, are null.
    fn json(&self, breaches: Option<&[String]>) -> serde_json::Value {
        let Self { colors, comparison, parts: Parts { both, only_a, only_b } } = self;
        let parts = both.iter().map(|part| {
            json!({
                "name": part.name,
                "max_abs": part.comparison.max_abs,
                "rmse": part.comparison.rmse,
                "worst_pixel": part.worst_pixel(),
            })
        });
        json!({
            "width": comparison.width,
            "height": comparison.height,
            "color": colors,
            "max_abs": comparison.max_abs,
            "rmse": comparison.rmse,
            "psnr": comparison.psnr,
            "mean_flip": comparison.mean_flip,
            "peak": comparison.peak,
            "worst_pixel": comparison.worst_pixel(),
            "channels": parts.collect::<Vec<_>>(),
            "only_in_a": only_a,
            "only_in_b": only_b,
            "passed": breaches.map(<[String]>::is_empty),
        })
    }
}
