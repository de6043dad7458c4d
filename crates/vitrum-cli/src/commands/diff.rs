//! `vitrum diff`: how two pictures differ, and whether that is within bounds.

use crate::failure::{Failure, Status};
use crate::output;
use clap::Args;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::io::{Picture, check_writable, read_picture, write_picture};
use vitrum_compare::{Bound, Comparison, Tolerance, Verdict, compare, difference_picture};

/// Compare two pictures in linear RGB; with a limit it is a check, and exits 1 on a breach
#[derive(Debug, Args)]
pub struct Arguments {
    /// The reference
    a: PathBuf,

    /// The picture that is compared with it
    b: PathBuf,

    /// Largest difference of a channel that passes
    #[arg(long, value_name = "X", value_parser = limit)]
    max_abs: Option<f64>,

    /// Largest root mean squared difference that passes
    #[arg(long, value_name = "Y", value_parser = limit)]
    max_rmse: Option<f64>,

    /// Largest mean FLIP error that passes, 0 to 1
    #[arg(long, value_name = "Z", value_parser = limit)]
    max_flip: Option<f64>,

    /// Write the difference as a picture, its largest value scaled to white
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let output = arguments.output.as_deref();
    output.map_or(Ok(()), check_writable).map_err(|error| Failure::output(&error))?;
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
    let (a, b) = (a.color(), b.color());
    let comparison = compare(&a, &b, width, height).map_err(|error| not_comparable(error.to_string()))?;
    if let Some(file) = output {
        let difference = difference_picture(&a, &b).map_err(|error| not_comparable(error.to_string()))?;
        write_picture(file, &Picture::rgb(width, height, difference.pixels), &[])
            .map_err(|error| Failure::output(&error))?;
    }
    let verdict = arguments.bound().map(|bound| bound.check(&comparison));
    if arguments.json {
        output::print_json(&json(&comparison, verdict.as_ref()))?;
    } else {
        output::print(&text(&comparison, verdict.as_ref()))?;
    }
    let passed = verdict.is_none_or(|verdict| verdict.passed());
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Arguments {
    /// `None` where no limit was given: then there is nothing to check.
    fn bound(&self) -> Option<Bound> {
        let tolerance =
            Tolerance { max_abs: self.max_abs, rmse: self.max_rmse, mean_flip: self.max_flip, ..Tolerance::default() };
        (tolerance != Tolerance::default()).then_some(Bound::Tolerance(tolerance))
    }
}

fn limit(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(limit) if f64::is_finite(limit) && limit >= 0.0 => Ok(limit),
        _ => Err("expected a finite number of at least 0".to_owned()),
    }
}

fn text(comparison: &Comparison, verdict: Option<&Verdict>) -> String {
    let Comparison { max_abs, rmse, psnr, peak, mean_flip, .. } = comparison;
    let flip = mean_flip.map_or_else(|| "not measured".to_owned(), |flip| format!("{flip:.6}"));
    let place = comparison.worst_pixel().map_or_else(String::new, |(x, y)| format!(" at pixel ({x}, {y})"));
    let verdict = verdict.map_or_else(String::new, |verdict| format!("check      {verdict}\n"));
    format!(
        "max        {max_abs:.6e}{place}\nRMSE       {rmse:.6e}\nPSNR       {psnr:.2} dB\nFLIP mean  {flip}\n\
         peak of A  {peak:.6}\n{verdict}"
    )
}

/// What is infinite or not a number is null: JSON has no word for it.
fn json(comparison: &Comparison, verdict: Option<&Verdict>) -> serde_json::Value {
    json!({
        "width": comparison.width,
        "height": comparison.height,
        "max_abs": comparison.max_abs,
        "rmse": comparison.rmse,
        "psnr": comparison.psnr,
        "mean_flip": comparison.mean_flip,
        "peak": comparison.peak,
        "worst_pixel": comparison.worst_pixel(),
        "passed": verdict.map(Verdict::passed),
    })
}
