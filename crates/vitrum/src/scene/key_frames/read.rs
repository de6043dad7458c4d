//! Reading key frames from TOML.

use super::super::check::{check_value, renamed_key, unknown_key};
use super::super::colors;
use super::super::error::{Fault, Origin, Problem, SceneError};
use super::super::lines::{line_of, line_of_key};
use super::super::renamed;
use super::super::schema::{Kind, Shape};
use super::curve::Curve;
use super::value;
use super::{Interpolation, KeyFrames, Track};
use toml::{Table, Value};

/// The keys that are the same for the whole animation, since they name data that is read once, or give the pictures their size.
///
/// `*` stands for any index of a list.
const FIXED: [&str; 20] = [
    "method",
    "annotation.*.kind",
    "volume",
    "mesh.*.file",
    "mesh.*.builtin",
    "mesh.*.up",
    "mesh.*.scale",
    "mesh.*.rotation",
    "mesh.*.position",
    "mesh.*.material",
    "light.*.kind",
    "light.*.texture",
    "medium.density",
    "voxelization",
    "voxels",
    "ior_volume",
    "environment.kind",
    "environment.file",
    "film.width",
    "film.height",
];

/// Largest number of frames of an animation.
const MOST_FRAMES: f64 = 100_000.0;

/// A value of a key, where it was written.
struct Setting {
    frame: f64,
    value: Value,
    /// The path in the file.
    written: Vec<String>,
}

/// The values of one key at all key frames.
struct Settings {
    path: Vec<String>,
    whole: bool,
    list: Vec<Setting>,
}

impl KeyFrames {
    /// Reads key frames from the text of a file; `name` is its name for messages. Times are turned into frames by `rate`, in
    /// frames a second.
    ///
    /// ```toml
    /// [[key]]
    /// frame = 0
    /// camera.azimuth = 20
    ///
    /// [[key]]
    /// time = 2.5
    /// camera.azimuth = 80
    /// light.0.angular_radius = 3
    /// ```
    ///
    /// # Errors
    ///
    /// Where the text is not TOML; where a key frame has no frame or time, or not a later one than that before; where a key is
    /// unknown, its value is not valid in a scene, or it cannot change during an animation. The error names the line.
    pub fn from_toml(text: &str, name: &str, rate: f64) -> Result<Self, SceneError> {
        let at_line = |line| Origin::File { name: name.to_owned(), line };
        let table: Table = toml::from_str(text).map_err(|error: toml::de::Error| SceneError {
            origin: at_line(error.span().map(|span| line_of(text, span.start))),
            key: String::new(),
            problem: Box::new(Problem::Syntax(error.message().to_owned())),
        })?;
        let located = |fault: Fault| {
            let line = line_of_key(text, &fault.path);
            fault.from(at_line(line))
        };
        let (settings, last_frame) = collect(&table, rate).map_err(located)?;
        let tracks = settings.into_iter().map(Settings::into_track).collect::<Result<_, _>>().map_err(located)?;
        Ok(Self { name: name.to_owned(), tracks, last_frame })
    }
}

fn path(segments: &[&str]) -> Vec<String> {
    segments.iter().map(|&segment| segment.to_owned()).collect()
}

/// Every key's values, in the order of frames, and the last frame.
fn collect(table: &Table, rate: f64) -> Result<(Vec<Settings>, f64), Fault> {
    if let Some(unknown) = table.keys().find(|key| *key != "key") {
        let problem = Problem::UnknownKey { nearest: None, known: path(&["key"]) };
        return Err(Fault::at(&path(&[unknown]), problem));
    }
    let keys = table.get("key").and_then(Value::as_array).filter(|keys| !keys.is_empty());
    let missing = || {
        Fault::at(&path(&["key"]), Problem::MissingKey { expected: "a list of key frames, each [[key]]".to_owned() })
    };
    let mut settings = Vec::new();
    let mut last = None;
    for (index, key) in keys.ok_or_else(missing)?.iter().enumerate() {
        let place = path(&["key", &index.to_string()]);
        let wrong = |problem: String, advice: &str| Err(Fault::contradiction(&place.join("."), problem, advice));
        let Some(key) = key.as_table() else {
            return wrong("a key frame is a table".to_owned(), "begin each one with [[key]]");
        };
        let number = |name: &str| key.get(name).map(|value| value.as_float().or(value.as_integer().map(|n| n as f64)));
        let frame = match (number("frame"), number("time")) {
            (Some(Some(frame)), None) => frame,
            (None, Some(Some(time))) => time * rate,
            _ => {
                return wrong(
                    "a key frame has one number, `frame` or `time`".to_owned(),
                    "give it one of them, such as frame = 0",
                );
            }
        };
        // NaN is in no range.
        if !(0.0..MOST_FRAMES).contains(&frame) {
            return wrong(format!("frame {frame} is not from 0 to below {MOST_FRAMES}"), "correct it");
        }
        if let Some(last) = last.filter(|&last| frame <= last) {
            return wrong(format!("frame {frame} comes after frame {last}"), "sort the key frames, one for each frame");
        }
        last = Some(frame);
        let shape = Shape::scene();
        for (name, value) in key.iter().filter(|(name, _)| !matches!(name.as_str(), "frame" | "time")) {
            let child = shape.child(name).ok_or_else(|| unknown_key(shape, &[], name));
            let child = child.map_err(|fault| Fault { path: [place.clone(), fault.path].concat(), ..fault })?;
            gather(child, value, &mut vec![name.clone()], &place, frame, &mut settings)?;
        }
    }
    Ok((settings, last.unwrap_or(0.0)))
}

/// Goes down to values that stand for themselves: numbers, vectors, texts, whole lists.
fn gather(
    shape: Shape<'static>,
    value: &Value,
    key: &mut Vec<String>,
    place: &[String],
    frame: f64,
    settings: &mut Vec<Settings>,
) -> Result<(), Fault> {
    check_free(value, key, place)?;
    let written = || [place, key.as_slice()].concat();
    match (shape.kind(), value) {
        // A list by its indices: what is not named stays.
        (Kind::Table | Kind::List { .. }, Value::Table(members)) => {
            for (name, member) in members {
                let child = shape.child(name).ok_or_else(|| {
                    let fault = unknown_key(shape, key, name);
                    Fault { path: [place, &fault.path].concat(), ..fault }
                })?;
                key.push(name.clone());
                gather(child, member, key, place, frame, settings)?;
                key.pop();
            }
            Ok(())
        }
        (kind, value) => {
            let mut value = value.clone();
            colors::resolve(shape, &mut value);
            check_value(shape, &value, &mut written())?;
            let setting = Setting { frame, value, written: written() };
            match settings.iter_mut().find(|known| known.path == *key) {
                Some(known) => known.list.push(setting),
                None => settings.push(Settings {
                    path: key.clone(),
                    whole: matches!(kind, Kind::WholeNumber),
                    list: vec![setting],
                }),
            }
            Ok(())
        }
    }
}

/// Fails if the value sets a key that the whole animation shares, or one by its old name.
fn check_free(value: &Value, key: &mut Vec<String>, place: &[String]) -> Result<(), Fault> {
    let inside: Vec<(String, &Value)> = match value {
        Value::Table(members) => members.iter().map(|(name, member)| (name.clone(), member)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(index, item)| (index.to_string(), item)).collect(),
        _ => Vec::new(),
    };
    for (segment, value) in inside {
        if let Some(new) = renamed::key(key, &segment) {
            return Err(renamed_key(&[place, key.as_slice()].concat(), &segment, new));
        }
        key.push(segment);
        check_free(value, key, place)?;
        key.pop();
    }
    let is_fixed = |pattern: &&str| {
        let segments: Vec<_> = pattern.split('.').collect();
        segments.len() == key.len() && segments.iter().zip(&*key).all(|(known, given)| *known == "*" || known == given)
    };
    if FIXED.iter().any(is_fixed) {
        let path = [place, key.as_slice()].concat().join(".");
        let problem = "this is the same for the whole animation";
        return Err(Fault::contradiction(&path, problem, "set it in the scene, or by --set or --size"));
    }
    Ok(())
}

impl Settings {
    fn into_track(self) -> Result<Track, Fault> {
        let numbers: Option<Vec<_>> = self.list.iter().map(|setting| value::numbers(&setting.value)).collect();
        let Some(numbers) = numbers else {
            let steps = self.list.into_iter().map(|setting| (setting.frame, setting.value)).collect();
            return Ok(Track { path: self.path, interpolation: Interpolation::Steps(steps) });
        };
        let (_, form) = &numbers[0];
        if let Some((setting, _)) = self.list.iter().zip(&numbers).find(|(_, (_, other))| other != form) {
            let problem = "this list has another length than in the key frames before";
            let advice = "give all of them as many points, so that each has one to move to";
            return Err(Fault::contradiction(&setting.written.join("."), problem, advice));
        }
        let knots: Vec<_> =
            self.list.iter().zip(numbers).map(|(setting, (numbers, _))| (setting.frame, numbers)).collect();
        let form = self.list[0].value.clone();
        Ok(Track {
            path: self.path,
            interpolation: Interpolation::Smooth { form, curve: Curve::new(&knots), whole: self.whole },
        })
    }
}
