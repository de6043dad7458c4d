//! Small plots as SVG, the same bytes on every machine.

use std::ops::Range;

use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;

/// A line of a plot.
#[derive(Debug, Clone)]
pub struct Series {
    /// Name of the line in the legend.
    pub name: String,
    /// x and y of its points, left to right.
    pub points: Vec<(f64, f64)>,
}

/// The division of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Division by powers of ten.
    Logarithmic,
}

/// An axis.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Quantity on the axis, with its unit.
    pub label: &'static str,
    /// Division of the axis.
    pub scale: Scale,
}

/// A plot of lines.
#[derive(Debug, Clone)]
pub struct Plot {
    /// Title of the plot.
    pub title: &'static str,
    /// Axis from left to right.
    pub x: Axis,
    /// Axis from bottom to top.
    pub y: Axis,
    /// The lines.
    pub series: Vec<Series>,
    /// The corner where no line is.
    pub legend: Corner,
}

/// A corner of a plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corner {
    /// Top left.
    UpperLeft,
    /// Top right.
    UpperRight,
    /// Bottom left.
    LowerLeft,
    /// Bottom right.
    LowerRight,
}

impl Series {
    /// A line.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), points }
    }

    /// The order of convergence from the first to the last point: the slope of the line between them in a logarithmic plot.
    #[must_use]
    pub fn order(&self) -> f64 {
        let (first, last) = (self.points[0], self.points[self.points.len() - 1]);
        (last.1 / first.1).ln() / (last.0 / first.0).ln()
    }
}

const SIZE: (u32, u32) = (640, 400);
/// The colours of Okabe & Ito 2008, which people who see colours differently tell apart.
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(128, 128, 128),
];

impl Plot {
    /// The plot as an SVG file.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn svg(&self) -> Result<String, String> {
        let [x, y] = [(&self.x, 0), (&self.y, 1)].map(|(axis, component)| self.range(axis, component));
        use Scale::{Linear, Logarithmic};
        let logarithmic = |range: Range<f64>| {
            let ticks = ticks(&range);
            range.log_scale().with_key_points(ticks)
        };
        match (self.x.scale, self.y.scale) {
            (Linear, Linear) => self.draw(x, y),
            (Linear, Logarithmic) => self.draw(x, logarithmic(y)),
            (Logarithmic, Linear) => self.draw(logarithmic(x), y),
            (Logarithmic, Logarithmic) => self.draw(logarithmic(x), logarithmic(y)),
        }
    }

    /// The range of an axis: the values on it, with a margin.
    fn range(&self, axis: &Axis, component: usize) -> Range<f64> {
        let points = self.series.iter().flat_map(|series| &series.points);
        let values = points.map(|&(x, y)| [x, y][component]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        match axis.scale {
            Scale::Linear => low - 0.05 * (high - low)..high + 0.05 * (high - low),
            Scale::Logarithmic => low / 1.3..high * 1.3,
        }
    }

    fn draw<X, Y>(&self, x: X, y: Y) -> Result<String, String>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let mut text = String::new();
        self.draw_into(&mut text, x, y).map_err(|error| format!("{}: {error}", self.title))?;
        Ok(text)
    }

    fn draw_into<X, Y>(&self, text: &mut String, x: X, y: Y) -> Result<(), Box<dyn std::error::Error>>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
        area.fill(&WHITE).map_err(|error| error.to_string())?;
        let mut chart = ChartBuilder::on(&area)
            .caption(self.title, ("sans-serif", 16))
            .margin(12)
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(x, y)
            .map_err(|error| error.to_string())?;
        let number = |value: &f64| tick(*value);
        chart
            .configure_mesh()
            .x_desc(self.x.label)
            .y_desc(self.y.label)
            .x_label_formatter(&number)
            .y_label_formatter(&number)
            .light_line_style(WHITE)
            .draw()
            .map_err(|error| error.to_string())?;
        for (series, color) in self.series.iter().zip(COLORS.into_iter().cycle()) {
            let line = LineSeries::new(series.points.iter().copied(), color.stroke_width(2));
            chart
                .draw_series(line)
                .map_err(|error| error.to_string())?
                .label(series.name.clone())
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
            let points = series.points.iter().map(|&point| Circle::new(point, 3, color.filled()));
            chart.draw_series(points).map_err(|error| error.to_string())?;
        }
        chart
            .configure_series_labels()
            .position(match self.legend {
                Corner::UpperLeft => SeriesLabelPosition::UpperLeft,
                Corner::UpperRight => SeriesLabelPosition::UpperRight,
                Corner::LowerLeft => SeriesLabelPosition::LowerLeft,
                Corner::LowerRight => SeriesLabelPosition::LowerRight,
            })
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font(("sans-serif", 13))
            .draw()
            .map_err(|error| error.to_string())?;
        area.present().map_err(|error| error.to_string())?;
        Ok(())
    }
}

/// The numbers at a logarithmic axis: powers of ten, and where those are few also twice and five times them.
fn ticks(range: &Range<f64>) -> Vec<f64> {
    let decades = (range.start.log10().floor() as i32)..=(range.end.log10().ceil() as i32);
    let steps: &[f64] = if (range.end / range.start).log10() > 2.5 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let all = decades.flat_map(|decade| steps.iter().map(move |step| step * 10f64.powi(decade)));
    all.filter(|tick| range.contains(tick)).collect()
}

/// A number beside an axis.
fn tick(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (9e-4..1e5).contains(&size) => format!("{}", (value * 1e6).round() / 1e6),
        _ => format!("{value:.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_has_its_lines_and_names() {
        let axis = |scale| Axis { label: "n", scale };
        let line = Series::new("second order", vec![(10.0, 1e-2), (100.0, 1e-4)]);
        assert!((line.order() + 2.0).abs() < 1e-12);
        for scale in [Scale::Linear, Scale::Logarithmic] {
            let plot = Plot {
                title: "errors",
                x: axis(scale),
                y: axis(scale),
                series: vec![line.clone()],
                legend: Corner::UpperRight,
            };
            let svg = plot.svg().unwrap();
            assert!(svg.starts_with("<svg") && svg.contains("second order") && svg.contains("errors"));
            assert!(svg.contains("<polyline") && svg.matches("<circle").count() == 2);
            assert_eq!(svg, plot.svg().unwrap());
        }
    }

    #[test]
    fn ticks_are_short() {
        assert_eq!([0.0, 0.05, 100.0, 1e-4].map(tick), ["0", "0.05", "100", "1e-4"]);
        assert_eq!(ticks(&(8.0..60.0)), [10.0, 20.0, 50.0]);
        assert_eq!(ticks(&(8.0..6000.0)), [10.0, 100.0, 1000.0]);
    }
}
