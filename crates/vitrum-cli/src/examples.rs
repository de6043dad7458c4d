//! The examples below each command's help: lines that work as they stand, given the files that they name.

pub const PROGRAM: &str = "\
Examples:
  vitrum render builtin:glass/wine -o wine.png
  vitrum info head.nrrd
  vitrum render head.nrrd --preset bone -o head.png
  vitrum keys camera

`vitrum help COMMAND` tells more of a command, `vitrum keys` of scene keys.";

pub const RENDER: &str = "\
Examples:
  vitrum render builtin:ball -o ball.png --size 1024x768
  vitrum render head.nrrd --preset bone --set camera.azimuth=60 -o head.png
  vitrum render scan-folder --up -z --set transfer.opacity.0.value=300 -o scan.exr
  vitrum render scene.toml -o frame.png --aov depth=depth.exr --stats frame.json";

pub const TURNTABLE: &str = "\
Examples:
  vitrum turntable head.nrrd --preset amber -o head.gif --frames 48
  vitrum turntable builtin:ball -o frames --size 640x480
  vitrum turntable scene.toml -o film.mp4 --keys keys.toml --rate 25";

pub const VIEW: &str = "\
Examples:
  vitrum view head.nrrd
  vitrum view builtin:ball -- --backend gpu
  vitrum view -- --watch scene.toml

The window is the program `vitrum-viewer`: `vitrum-viewer --help` tells its flags.";

pub const VOXELIZE: &str = "\
Examples:
  vitrum voxelize bunny.ply -r 256 -o bunny.nrrd
  vitrum voxelize bunny.ply -r 128 -o bunny.nrrd --field normal=normals.nrrd";

pub const INFO: &str = "\
Examples:
  vitrum info head.nrrd
  vitrum info dicom-folder --json
  vitrum info builtin:vase";

pub const CONVERT: &str = "\
Examples:
  vitrum convert dicom-folder -o head.nrrd
  vitrum convert series.nii.gz --time 12 -o bold.npy
  vitrum convert head.nrrd --crop 40:200,:,20: --resample 1,1,1 -o part.nrrd
  vitrum convert labels.nrrd --labels 3,4,7 --blur 1 -o organs.nrrd";

pub const DIFF: &str = "\
Examples:
  vitrum diff cpu.exr gpu.exr
  vitrum diff cpu.exr gpu.exr --max-rmse 1e-4 -o difference.png";

pub const SCENE: &str = "\
Examples:
  vitrum scene head.nrrd --preset amber -o head.toml
  vitrum scene builtin:ball --all

`vitrum help scene` tells what a scene file is.";

pub const DEVICES: &str = "\
Examples:
  vitrum devices
  vitrum render builtin:ball --backend gpu --adapter NVIDIA -o ball.png";

pub const PRESETS: &str = "\
Examples:
  vitrum presets
  vitrum render head.nrrd --preset bone -o bone.png";

pub const SCENES: &str = "\
Examples:
  vitrum scenes
  vitrum render builtin:supernova/3 -o supernova.png";

pub const KEYS: &str = "\
Examples:
  vitrum keys camera
  vitrum keys light.0.azimuth
  vitrum keys radius
  vitrum keys --json";

pub const SCHEMA: &str = "\
Examples:
  vitrum schema";

pub const COMPLETIONS: &str = "\
Examples:
  vitrum completions bash
  vitrum completions fish

Bash reads the script from ~/.local/share/bash-completion/completions/vitrum, zsh from a file _vitrum in a folder of its $fpath, fish
from ~/.config/fish/completions/vitrum.fish. It asks the program itself, so that it offers presets, built-in scenes, keys and adapters.";

pub const MAN: &str = "\
Examples:
  vitrum man render
  vitrum man -o man1";

#[cfg(test)]
mod tests {
    use crate::arguments::Arguments;
    use clap::{CommandFactory, Parser};

    #[test]
    fn every_command_has_examples_that_can_be_parsed() {
        let program = Arguments::command();
        let commands = program.get_subcommands().chain([&program]);
        for command in commands {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let examples: Vec<_> = help.lines().filter_map(|line| line.strip_prefix("  vitrum ")).collect();
            assert!(!examples.is_empty(), "`{}` has no examples", command.get_name());
            for example in &examples {
                let words = example.split(' ');
                let parsed = Arguments::try_parse_from(["vitrum"].into_iter().chain(words));
                assert!(parsed.is_ok(), "vitrum {example}\n{}", parsed.unwrap_err());
            }
            let own = command.get_name();
            assert!(own == "vitrum" || examples.iter().any(|example| example.split(' ').next() == Some(own)), "{own}");
        }
    }
}
