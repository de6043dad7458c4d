//! Closed forms on finer and finer grids.

use vitrum::backend::Backend;
use vitrum::scene::{Gradient, Integrator, Intensity};

use super::Section;
use super::plot::{Axis, Corner, Plot, Scale, Series};
use crate::Failure;
use crate::closed_forms;
use crate::table::aligned;

/// A table of errors, a column for each line, and the order of each line from its first to its last point below.
fn table<const COLUMNS: usize>(first: &str, series: &[Series], point: impl Fn(f64) -> String) -> String {
    let cells = |name: String, cell: &dyn Fn(&Series) -> String| -> [String; COLUMNS] {
        let cells: Vec<String> = [name].into_iter().chain(series.iter().map(cell)).collect();
        cells.try_into().expect("a column for each line, and one before")
    };
    let row =
        |index: usize| cells(point(series[0].points[index].0), &|series| format!("{:.2e}", series.points[index].1));
    let order = cells("order".to_owned(), &|series| format!("{:.2}", series.order().abs()));
    let rows = (0..series[0].points.len()).map(row).chain([order]);
    aligned(cells(first.to_owned(), &|series| series.name.clone()), rows)
}

fn logarithmic(label: &'static str) -> Axis {
    Axis { label, scale: Scale::Logarithmic }
}

fn linear(label: &'static str) -> Axis {
    Axis { label, scale: Scale::Linear }
}

/// The ray step alone: Euler against kick–drift–kick.
pub fn step(_: &mut dyn Backend) -> Result<Section, Failure> {
    let line = |name: &str, euler: bool| {
        let point = |steps: u32| (f64::from(steps), f64::from(closed_forms::step::worst_miss(steps, euler)));
        Series::new(name, [32, 64, 128, 256, 512].map(point).to_vec())
    };
    let series = vec![line("Euler (paper)", true), line("kick–drift–kick", false)];
    Ok(Section {
        text: table::<3>("planes across", &series, |planes| planes.to_string()),
        plot: Plot {
            title: "A ray through a Luneburg lens, exact gradients",
            x: logarithmic("planes across the lens"),
            y: logarithmic("miss at the antipode, radii"),
            series,
            legend: Corner::LowerLeft,
        },
    })
}

/// The Luneburg lens against the edge of a voxel, ∇η by central differences and by the chain rule.
pub fn luneburg(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let mut line = |name: &str, gradient: Gradient| {
        let mut point = |n: u32| {
            let miss = closed_forms::luneburg::worst_miss(n, Integrator::Symplectic, gradient, backend);
            (closed_forms::luneburg::EDGE / f64::from(n), miss)
        };
        Series::new(name, [16, 32, 64, 128].map(&mut point).to_vec())
    };
    let series = vec![line("central ∇η", Gradient::Central), line("chain rule", Gradient::Chain)];
    let voxels = |edge: f64| format!("{:.4} ({:.0}³)", edge, closed_forms::luneburg::EDGE / edge);
    Ok(Section {
        text: table::<3>("voxel, radii", &series, voxels),
        plot: Plot {
            title: "Luneburg lens: error of the focus against the voxel",
            x: logarithmic("edge of a voxel, radii"),
            y: logarithmic("miss at the antipode, radii"),
            series,
            legend: Corner::LowerRight,
        },
    })
}

/// The ball lens against the edge of a voxel.
pub fn ball(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let mut line = |layer: f64| {
        let mut point = |n: u32| {
            let worst = closed_forms::ball::worst_crossing(n, layer, backend);
            (closed_forms::ball::EDGE / f64::from(n), worst)
        };
        Series::new(format!("surface of {layer} voxels"), [32, 48, 64, 96, 128, 192].map(&mut point).to_vec())
    };
    let series = vec![line(2.0), line(4.0), line(8.0)];
    let voxels = |edge: f64| format!("{:.4} ({:.0}³)", edge, closed_forms::ball::EDGE / edge);
    Ok(Section {
        text: table::<4>("voxel, radii", &series, voxels),
        plot: Plot {
            title: "Ball lens, n = 1.5: where rays cross the axis",
            x: logarithmic("edge of a voxel, radii"),
            y: logarithmic("worst relative error, 0.1 ≤ h ≤ 0.75"),
            series,
            legend: Corner::UpperRight,
        },
    })
}

/// Eq. 13 against the Jacobian where light is sheared.
pub fn areas(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let mut line = |name: &str, intensity: Intensity| {
        let mut point = |strength: f64| {
            let (shear, flux) = closed_forms::saddle::flux(strength, intensity, backend)?;
            Ok::<_, Failure>((shear, flux - 1.0))
        };
        let points = [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0].into_iter().map(&mut point);
        Ok::<_, Failure>(Series::new(name, points.collect::<Result<_, _>>()?))
    };
    let series = vec![line("Jacobian", Intensity::Jacobian)?, line("Eq. 13 (paper)", Intensity::Paper)?];
    let header = ["shear from plane to plane", "Jacobian", "Eq. 13 (paper)"].map(str::to_owned);
    let rows = series[0].points.iter().zip(&series[1].points).map(|(jacobian, paper)| {
        let percent = |error: f64| format!("{:+.2} %", error * 100.0);
        [format!("{:.4}", jacobian.0), percent(jacobian.1), percent(paper.1)]
    });
    Ok(Section {
        text: aligned(header, rows),
        plot: Plot {
            title: "Light that is sheared: error of the flux",
            x: linear("shear from plane to plane"),
            y: linear("flux over the truth, less 1"),
            series,
            legend: Corner::UpperLeft,
        },
    })
}

/// Shares of the focal distance, and the irradiance there on axis.
const SHARES: [(f64, &str, f64); 3] = [(0.25, "¼", 4.0 / 3.0), (0.5, "½", 2.0), (0.75, "¾", 4.0)];

/// The irradiance behind a thin lens slab against the number of light texels.
pub fn slab(backend: &mut dyn Backend) -> Result<Section, Failure> {
    let resolutions = [0.5f32, 1.0, 2.0, 4.0];
    let mut line = |(share, name, truth): (f64, &str, f64)| {
        let mut point = |resolution: f32| {
            let found = closed_forms::slab::irradiance(share, resolution, 1.0, Intensity::Jacobian, backend);
            (closed_forms::slab::texels(resolution), found.0 / truth)
        };
        Series::new(format!("at {name} of the focal distance"), resolutions.map(&mut point).to_vec())
    };
    let series: Vec<Series> = SHARES.map(&mut line).into();
    let header = ["light texels a period", "at ¼ (truth 1.333)", "at ½ (truth 2)", "at ¾ (truth 4)"].map(str::to_owned);
    let rows = (0..resolutions.len()).map(|row| {
        let found = |line: usize| format!("{:.3}", series[line].points[row].1 * SHARES[line].2);
        [format!("{:.1}", series[0].points[row].0), found(0), found(1), found(2)]
    });
    Ok(Section {
        text: aligned(header, rows),
        plot: Plot {
            title: "Behind a thin lens slab, on axis: irradiance over the truth",
            x: logarithmic("light texels a period"),
            y: linear("irradiance over the truth"),
            series,
            legend: Corner::LowerRight,
        },
    })
}
