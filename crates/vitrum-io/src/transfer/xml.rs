//! Transfer functions in XML: ParaView's colour maps and state files, VTK's functions, and MRML.

use quick_xml::Reader;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};

use super::curve::Point;
use super::paraview::space_of;
use super::slicer::{self, LEFT_OUT};
use super::{Found, check_points, pick};
use crate::error::{Error, Place, Report, clip};

/// Real files nest a dozen elements.
const MOST_DEPTH: usize = 64;

/// An element.
struct Tag {
    name: String,
    attributes: Vec<(String, String)>,
    place: Place,
}

impl Tag {
    fn of(report: Report, start: &BytesStart, line: usize) -> Result<Self, Error> {
        let place = Place::Line(line);
        let mut attributes = Vec::new();
        for attribute in start.attributes().with_checks(false) {
            let invalid = |problem: String| {
                let problem = format!("an attribute is not well-formed: {}", clip(&problem));
                report.invalid(place, problem, "write it as name=\"value\"")
            };
            let attribute = attribute.map_err(|error| invalid(error.to_string()))?;
            let value =
                attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| invalid(error.to_string()))?;
            attributes.push((attribute.key.as_ref().to_owned(), value.into_owned()));
        }
        Ok(Self { name: start.name().as_ref().to_owned(), attributes, place })
    }

    fn get(&self, name: &str) -> Option<&str> {
        let same = |(other, _): &&(String, String)| other.eq_ignore_ascii_case(name);
        self.attributes.iter().find(same).map(|(_, value)| value.as_str())
    }

    /// The numbers of an attribute.
    fn numbers<const N: usize>(&self, report: Report, name: &str) -> Result<[f64; N], Error> {
        let text = self.get(name).unwrap_or_default();
        let numbers = text.split_whitespace().map(|word| word.parse().ok()).collect::<Option<Vec<f64>>>();
        numbers.and_then(|numbers| numbers.try_into().ok()).ok_or_else(|| {
            let problem = format!("the attribute `{name}` of `{}` is `{}`", clip(&self.name), clip(text));
            report.invalid(
                self.place,
                problem,
                if N == 1 { "write a number" } else { "write numbers with blanks between" },
            )
        })
    }

    fn number(&self, report: Report, name: &str) -> Result<f64, Error> {
        self.numbers::<1>(report, name).map(|[number]| number)
    }

    /// A number that may be missing.
    fn number_or(&self, name: &str, default: f64) -> f64 {
        self.get(name).and_then(|text| text.trim().parse().ok()).unwrap_or(default)
    }
}

/// The function that points belong to.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Inside {
    Nothing,
    /// ParaView's `ColorMap`: points with `x`, `o`, `r`, `g`, `b`.
    Map,
    /// VTK's `ColorTransferFunction`: points with `X` and `Value`.
    Colors,
    /// VTK's `PiecewiseFunction`.
    Opacities,
    /// A property of ParaView's state: elements with `value`.
    List,
}

struct Collector<'a> {
    report: Report<'a>,
    /// Every set of functions, by its name.
    sets: Vec<Found>,
    inside: Inside,
    /// The open elements whose names matter.
    open: Vec<String>,
    /// The name of a state's property, and its numbers so far.
    list: Option<(&'static str, Vec<f64>, Place)>,
    /// The proxy of a state that is open: whether it has colours.
    proxy: Option<bool>,
    gradient: bool,
}

/// Reads a document; `name` is that of one of several in it.
pub(super) fn read(report: Report, text: &str, name: Option<&str>) -> Result<Found, Error> {
    let mut reader = Reader::from_str(text);
    let mut collector = Collector {
        report,
        sets: Vec::new(),
        inside: Inside::Nothing,
        open: Vec::new(),
        list: None,
        proxy: None,
        gradient: false,
    };
    let (mut line, mut counted) = (1, 0);
    loop {
        let position = usize::try_from(reader.buffer_position()).unwrap_or(text.len()).min(text.len());
        line += text.as_bytes()[counted.min(position)..position].iter().filter(|&&byte| byte == b'\n').count();
        counted = counted.max(position);
        match reader.read_event() {
            Ok(Event::Start(tag)) => {
                let tag = Tag::of(report, &tag, line)?;
                if collector.open.len() == MOST_DEPTH {
                    let problem = format!("elements lie more than {MOST_DEPTH} deep");
                    return Err(report.invalid(tag.place, problem, "write the file anew"));
                }
                collector.start(&tag)?;
                collector.open.push(tag.name);
            }
            Ok(Event::Empty(tag)) => {
                let tag = Tag::of(report, &tag, line)?;
                collector.start(&tag)?;
                collector.end(&tag.name)?;
            }
            Ok(Event::End(_)) => {
                let ended = collector.open.pop().unwrap_or_default();
                collector.end(&ended)?;
            }
            Ok(Event::Eof) if collector.open.is_empty() => break,
            Ok(Event::Eof) => {
                let problem =
                    format!("the file ends inside of `{}`", clip(collector.open.last().map_or("", |name| name)));
                return Err(report.invalid(Place::Line(line), problem, "get the whole file"));
            }
            Ok(Event::DocType(_)) => {
                let problem = "document types are not read";
                return Err(report.unsupported(Place::Line(line), problem, "leave it out"));
            }
            Ok(_) => {}
            Err(error) => {
                let problem = format!("this is not well-formed XML: {}", clip(&error.to_string()));
                return Err(report.invalid(Place::Line(line), problem, "get the whole file, or write it anew"));
            }
        }
    }
    collector.finish(name)
}

impl Collector<'_> {
    fn start(&mut self, tag: &Tag) -> Result<(), Error> {
        match tag.name.as_str() {
            "ColorMap" => {
                let set = self.add("ParaView colour map (XML)", tag.get("name").unwrap_or_default());
                set.colors.space = space_of(tag.get("space").unwrap_or("RGB"), &mut set.assumptions);
                self.inside = Inside::Map;
            }
            "Point" => self.point(tag)?,
            "GradientOpacity" => self.gradient = true,
            "ColorTransferFunction" if !self.gradient => {
                let set = self.of_vtk(|set| set.colors.points.is_empty());
                set.colors.space = space_of(tag.get("ColorSpace").unwrap_or("RGB"), &mut set.assumptions);
                self.inside = Inside::Colors;
            }
            "PiecewiseFunction" => {
                self.inside = Inside::Opacities;
                if !self.gradient {
                    self.of_vtk(|set| set.opacities.points.is_empty());
                }
            }
            "VolumeProperty" => self.property(tag)?,
            "VolumeComponent" => {
                let distance = tag.number_or("ScalarOpacityUnitDistance", f64::NAN);
                if distance.is_finite() {
                    self.of_vtk(|set| set.unit_distance.is_none()).unit_distance = Some(distance);
                }
            }
            "Proxy" => {
                let group = tag.get("group").unwrap_or_default();
                self.proxy = match group {
                    "lookup_tables" => Some(true),
                    "piecewise_functions" => Some(false),
                    _ => None,
                };
            }
            "Property" => self.state(tag),
            "Element" => {
                if let Some((_, numbers, place)) = &mut self.list {
                    check_points(self.report, *place, numbers.len() / 4)?;
                    *place = tag.place;
                    numbers.push(tag.number(self.report, "value")?);
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, name: &str) -> Result<(), Error> {
        match name {
            "ColorMap" | "ColorTransferFunction" | "PiecewiseFunction" => self.inside = Inside::Nothing,
            "GradientOpacity" => self.gradient = false,
            "Proxy" => self.proxy = None,
            "Property" => self.end_list()?,
            _ => {}
        }
        Ok(())
    }

    fn add(&mut self, format: &'static str, name: &str) -> &mut Found {
        let index = self.sets.len();
        self.sets.push(Found { format, name: name.to_owned(), ..Found::default() });
        &mut self.sets[index]
    }

    /// The last set of VTK's functions, or a new one where that has the part already.
    fn of_vtk(&mut self, lacks: impl Fn(&Found) -> bool) -> &mut Found {
        const FORMAT: &str = "VTK transfer function (XML)";
        match self.sets.last() {
            Some(last) if last.format == FORMAT && lacks(last) => {}
            _ => {
                let number = (self.sets.len() + 1).to_string();
                self.add(FORMAT, &number);
            }
        }
        let last = self.sets.len() - 1;
        &mut self.sets[last]
    }

    fn point(&mut self, tag: &Tag) -> Result<(), Error> {
        let (report, place) = (self.report, tag.place);
        let bent = (tag.number_or("MidPoint", 0.5), tag.number_or("Sharpness", 0.0));
        let inside = self.inside;
        if inside == Inside::Nothing {
            return Ok(());
        }
        let x = tag.number(report, "x")?;
        if self.gradient {
            let factor = Point::new(x, [tag.number(report, "Value")?], place);
            if let Some(set) = self.sets.last_mut() {
                set.gradients.points.push(factor.bent(bent.0, bent.1));
            }
            return Ok(());
        }
        let Some(set) = self.sets.last_mut() else { return Ok(()) };
        match inside {
            Inside::Map => {
                let [r, g, b] = [tag.number(report, "r")?, tag.number(report, "g")?, tag.number(report, "b")?];
                set.colors.points.push(Point::new(x, [r, g, b], place));
                if tag.get("o").is_some() {
                    set.opacities.points.push(Point::new(x, [tag.number(report, "o")?], place));
                }
            }
            Inside::Colors => {
                let color = Point::new(x, tag.numbers::<3>(report, "Value")?, place);
                set.colors.points.push(color.bent(bent.0, bent.1));
            }
            Inside::Opacities => {
                let opacity = Point::new(x, [tag.number(report, "Value")?], place);
                set.opacities.points.push(opacity.bent(bent.0, bent.1));
            }
            Inside::Nothing | Inside::List => {}
        }
        Ok(())
    }

    /// MRML: the functions are attributes.
    fn property(&mut self, tag: &Tag) -> Result<(), Error> {
        let (Some(opacity), Some(color)) = (tag.get("scalarOpacity"), tag.get("colorTransfer")) else { return Ok(()) };
        let opacities = slicer::opacities(self.report, tag.place, opacity)?;
        let colors = slicer::colors(self.report, tag.place, color)?;
        let report = self.report;
        let set = self.add("3D Slicer MRML", tag.get("name").unwrap_or_default());
        (set.opacities, set.colors) = (opacities, colors);
        set.unit_distance = tag.get("scalarOpacityUnitDistance").and_then(|text| text.trim().parse().ok());
        if let Some(gradient) = tag.get("gradientOpacity") {
            set.gradients = slicer::gradients(report, tag.place, gradient, &mut set.assumptions);
        }
        set.assumptions.push(LEFT_OUT.to_owned());
        Ok(())
    }

    /// A property of a proxy of ParaView's state.
    fn state(&mut self, tag: &Tag) {
        let Some(colors) = self.proxy else { return };
        let name = match tag.get("name") {
            Some("RGBPoints") if colors => "RGBPoints",
            Some("Points") if !colors => "Points",
            _ => return,
        };
        self.list = Some((name, Vec::new(), tag.place));
        self.inside = Inside::List;
    }

    fn end_list(&mut self) -> Result<(), Error> {
        const FORMAT: &str = "ParaView state";
        let Some((name, numbers, place)) = self.list.take() else { return Ok(()) };
        self.inside = Inside::Nothing;
        if numbers.len() % 4 != 0 {
            let problem = format!("`{name}` has {} numbers, and a point has 4", numbers.len());
            return Err(self.report.invalid(place, problem, "save the state by ParaView"));
        }
        let colors = name == "RGBPoints";
        let lacks = |set: &Found| if colors { set.colors.points.is_empty() } else { set.opacities.points.is_empty() };
        // The n-th colours belong to the n-th opacities: ParaView writes both for each array.
        let index = match self.sets.iter().position(|set| set.format == FORMAT && lacks(set)) {
            Some(index) => index,
            None => {
                let number = (self.sets.len() + 1).to_string();
                self.add(FORMAT, &number);
                self.sets.len() - 1
            }
        };
        let set = &mut self.sets[index];
        for point in numbers.chunks_exact(4) {
            if colors {
                set.colors.points.push(Point::new(point[0], [point[1], point[2], point[3]], place));
            } else {
                set.opacities.points.push(Point::new(point[0], [point[1]], place).bent(point[2], point[3]));
            }
        }
        Ok(())
    }

    fn finish(self, name: Option<&str>) -> Result<Found, Error> {
        let report = self.report;
        let whole = |set: &Found| !set.colors.points.is_empty() || !set.opacities.points.is_empty();
        let mut sets: Vec<Found> = self.sets.into_iter().filter(whole).collect();
        if sets.is_empty() {
            let problem = "there is no transfer function in it that is known";
            let advice = "give a colour map of ParaView (`ColorMap`), functions of VTK (`ColorTransferFunction`, `PiecewiseFunction`) or MRML (`VolumeProperty`)";
            return Err(report.invalid(Place::File, problem, advice));
        }
        let names: Vec<String> = sets.iter().map(|set| set.name.clone()).collect();
        let mut told = crate::source::Assumptions::default();
        let index = pick(report, &names, name, &mut told)?;
        let mut found = sets.swap_remove(index);
        found.assumptions.extend(told);
        Ok(found)
    }
}
