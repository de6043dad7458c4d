//! `vitrum help TOPIC`: what concerns more than one command, from one text each.

use crate::arguments::Arguments;
use crate::failure::{Failure, Status};
use crate::output;
use clap::CommandFactory;
use std::fmt::Write;
use std::process::ExitCode;
use vitrum::preset;
use vitrum::suggest::nearest;

/// The exit codes, and what each means.
const EXIT_CODES: [(u8, &str); 7] = [
    (0, "done"),
    (1, "a check said no"),
    (2, "wrong use"),
    (3, "an input could not be read or is invalid"),
    (4, "the device failed or is missing"),
    (124, "out of time"),
    (130, "interrupted"),
];

/// A topic: its name, what it is about, and its text.
struct Topic {
    name: &'static str,
    about: &'static str,
    text: fn() -> String,
}

const TOPICS: [Topic; 6] = [
    Topic { name: "scene", about: "scene files and their keys", text: || SCENE.to_owned() },
    Topic { name: "presets", about: "looks by name", text: presets },
    Topic { name: "files", about: "the volumes and meshes that are read", text: files },
    Topic { name: "transfer", about: "which values are seen, and how", text: || TRANSFER.to_owned() },
    Topic { name: "output", about: "pictures, animations and what lies beside them", text: || OUTPUT.to_owned() },
    Topic { name: "exit-codes", about: "what the program ends with", text: exit_codes },
];

const SCENE: &str = "\
A scene file is TOML: sections such as [camera] and [[light]] hold keys with values.

  [volume]
  file = \"head.nrrd\"        # relative to the scene file
  [camera]
  azimuth = 60.0
  [[light]]                 # the first light, light.0 for --set
  angular_radius = 3.0

Any key also goes with --set, in the order in which they are given and after --preset:
--set camera.azimuth=60, --set light.0.angular_radius=3, --set ground.color=white. Colours are three
numbers of linear light, or \"white\", \"#fff\". A key that is left out has its default.

  vitrum keys               all keys: unit, range, default and meaning
  vitrum keys camera        those of one section; words inside of keys are found, too
  vitrum scene INPUT -o s.toml    the scene of what would be rendered, to be changed by hand
  vitrum schema             the JSON schema, by which editors complete and check scene files";

const TRANSFER: &str = "\
A transfer function says what each value of a volume looks like: colour, opacity, index of
refraction, filter. A preset fits one to the volume; these flags change it, in this order:

  --window WIDTH --level LEVEL    stretch it over level - width / 2 to level + width / 2
  --threshold VALUE               everything below is nothing
  --colormap NAME                 the colours of a map, such as viridis
  --isosurface VALUE[:COLOR[:OPACITY]]    the surface where values are VALUE; repeatable
  --gradient-opacity MAGNITUDE:FACTOR    less opacity where values change little; repeatable
  --set transfer.opacity.0.value=300    a point of it, last of all

  vitrum info FILE          the values: histogram, percentiles and landmarks
  --transfer FILE           one of 3D Slicer (.vp, .json, MRML), ParaView (.json, .xml), VTK, or a
                            list of scalars and opacities
  vitrum scene FILE -o s.toml     its points, written out
  vitrum scene FILE --write-transfer p.json      its colours and opacities, for ParaView

The values of segmentations are labels: the preset `labels` gives each a colour of its own, unmixed.";

const OUTPUT: &str = "\
The extension of -o decides:

  .png    8 bits a channel, sRGB (--bits 16 for more), the scene in its texts
  .exr    linear float32, every named output in its layers, the scene in its metadata
  .hdr .tif .jpg    linear RGBE; linear float32; 8 bits
  .gif .png .mp4, or a folder of frames      animations of vitrum turntable
  .svg    annotations alone, by --annotations

  --aov depth=depth.exr     a named output in a file of its own
  --stats frame.json        times, sizes, cameras, what was taken for granted

An output appears whole or not at all: it is written beside its path and renamed onto it, and all
outputs of one render appear or none. A path that is a symbolic link stays one, and its target is
written. Of a file with several names (hard links) the name that is given gets the new file, the others
keep the old one, and that is told. Standard output carries results, standard error messages.";

fn presets() -> String {
    let mut text = "\
A preset of a volume sets transfer function, light, shading and surroundings, fitted to the values;
camera, clip and film stay. A preset of a mesh sets its material. A volume without one gets the preset that
suits its values, which is told with the reason; a mesh is shown by what its file says.

"
    .to_owned();
    for (heading, names) in [
        ("Volumes (--preset):", preset::names()),
        ("Meshes (--preset):", preset::mesh_names()),
        ("Media around meshes (--medium):", preset::medium_names()),
        ("Maps of colours (--colormap):", preset::colormap_names()),
    ] {
        let names: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        let _ = writeln!(text, "{heading}\n  {}", names.join(", "));
    }
    text + "\n`vitrum presets` describes each; `vitrum presets FILE -o sheet.png` shows all of them on one input."
}

fn files() -> String {
    let mut text = "The content of a file decides its format, the extension only helps.\n\nVolumes:\n".to_owned();
    let rows = |formats: &[&vitrum::io::Format]| -> String {
        formats.iter().map(|format| format!("  {:16} {}\n", format.name, format.extensions.join(" "))).collect()
    };
    text += &rows(vitrum::io::VOLUME_FORMATS);
    text += "\nMeshes:\n";
    text += &rows(vitrum::io::MESH_FORMATS);
    text + "
A volume may be packed as a whole (.gz, .zst), and comes from standard input as `-`. A folder stands
for the DICOM series or the TIFF slices in it. What the file does not say, these flags do:

  --raw 256x256x109:u16     voxels without a header
  --spacing 1,1,1.3         distances of voxels
  --up -z                   what is up
  --array NAME, --array norm, rgb or N    an array by name, or what is made of colours and vectors
  --time 12, --time 0.5s    a point in time

`vitrum info FILE` tells what is in it, what was taken for granted, and what was left out."
}

fn exit_codes() -> String {
    EXIT_CODES.iter().map(|(code, meaning)| format!("  {code:3}  {meaning}\n")).collect::<String>()
        + "\nWhere a command fails, no unfinished output is left."
}

/// The help of the program as a whole, with its exit codes.
pub fn about() -> String {
    let codes: Vec<String> = EXIT_CODES.iter().map(|(code, meaning)| format!("{code} {meaning}")).collect();
    format!(
        "Renders volumes with refraction, coloured transmission, soft shadows and caustics.\n\nExit codes: {}.",
        codes.join(", ")
    )
}

/// Names of topics, for the help of the program.
pub fn names() -> String {
    let rows: String = TOPICS.iter().map(|topic| format!("  {:10}  {}\n", topic.name, topic.about)).collect();
    format!("Topics of `vitrum help TOPIC`:\n{rows}")
}

/// Answers `vitrum help TOPIC`; `None` where the command line is another.
pub fn answer(arguments: &[String]) -> Option<Result<ExitCode, Failure>> {
    let [_, help, words @ ..] = arguments else { return None };
    if help != "help" || words.is_empty() || words.iter().any(|word| word.starts_with('-')) {
        return None;
    }
    let asked = words.join("-").to_lowercase();
    let mut program = Arguments::command();
    // Subcommands then know their whole names.
    program.build();
    let command = program.find_subcommand_mut(&asked).map(|command| command.render_long_help());
    let topic = TOPICS.iter().find(|topic| topic.name == asked);
    let printed = match (command, topic) {
        (None, Some(topic)) => output::print(&format!("{}\n", (topic.text)())),
        // A command of the same name: its help follows.
        (Some(command), Some(topic)) => {
            output::print(&format!("{}\n\n", (topic.text)())).and_then(|()| output::print_styled(&command))
        }
        (Some(_), None) => return None,
        (None, None) => Err(unknown(&words.join(" "), &program)),
    };
    Some(printed.map(|()| ExitCode::SUCCESS))
}

fn unknown(asked: &str, program: &clap::Command) -> Failure {
    let topics = TOPICS.iter().map(|topic| topic.name);
    let names = topics.clone().chain(program.get_subcommands().map(clap::Command::get_name));
    let help = match nearest(asked, names) {
        Some(near) => format!("did you mean `vitrum help {near}`?"),
        None => {
            format!("the topics are: {}; `vitrum --help` lists the commands", topics.collect::<Vec<_>>().join(", "))
        }
    };
    Failure::new(Status::WrongUse, format!("there is no command and no topic `{asked}`"), help)
}
