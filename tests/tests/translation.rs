//! Every committed module is valid on every device, in every language: without a device.
//!
//! `conformance.rs` runs them.

use std::fs;

use vitrum_conformance::root;
use vitrum_kernels::kernel::ALL;
use vitrum_shader_manifest::folder;
use vitrum_shader_translation::Translation;
use vitrum_shaders::NAMES;

/// Buffers that a kernel may have on every device for WebGPU.
const BUFFERS: usize = 8;
/// Characters that a number in WGSL has at most. Safari refuses literals of some 30 digits.
const NUMBER: usize = 16;

#[test]
fn every_module_is_valid_and_translates_to_the_committed_wgsl_to_metal_and_to_direct3d() {
    for name in NAMES {
        let spirv = vitrum_shaders::spirv(name).expect("names are those of modules");
        let translation = Translation::of_spirv(spirv).unwrap_or_else(|error| panic!("{name}: {error}"));
        let wgsl = translation.wgsl().unwrap_or_else(|error| panic!("{name}: {error}"));
        let path = folder(&root()).join(format!("wgsl/{name}.wgsl"));
        let committed = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(wgsl == committed, "{}: not what naga writes; run `cargo xtask shaders`", path.display());
        for (language, text) in [("MSL", translation.msl()), ("HLSL", translation.hlsl())] {
            let text = text.unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(text.contains("main"), "{name}: {language} without the entry point");
        }
    }
}

#[test]
fn wgsl_has_one_entry_point_called_main_and_no_long_numbers() {
    for name in NAMES {
        let text = fs::read_to_string(folder(&root()).join(format!("wgsl/{name}.wgsl"))).expect("it is committed");
        assert_eq!(text.matches("@compute").count(), 1, "{name}");
        assert!(text.contains("fn main("), "{name}");
        let words = text.split(|character: char| !(character.is_ascii_alphanumeric() || "._".contains(character)));
        let numbers = words.filter(|word| word.starts_with(|first: char| first.is_ascii_digit()));
        let digits = |word: &&str| word.chars().take_while(|digit| digit.is_ascii_digit() || *digit == '.').count();
        let long = numbers.filter(|word| digits(word) > NUMBER);
        assert_eq!(long.collect::<Vec<_>>(), Vec::<&str>::new(), "{name}");
    }
}

#[test]
fn no_kernel_has_more_buffers_than_every_device_allows() {
    for kernel in ALL {
        let buffers = kernel.declaration.bindings.len();
        assert!(buffers <= BUFFERS, "{} has {buffers}", kernel.declaration.name);
    }
}
