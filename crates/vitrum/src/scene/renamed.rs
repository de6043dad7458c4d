//! Keys and values that have a new name: whoever uses the old one is told the new one.

/// Old keys and new ones. An index of a list stands for the first item.
pub(super) const KEYS: [(&str, &str); 18] = [
    ("light.attachment", "light.0.attachment"),
    ("light.azimuth", "light.0.azimuth"),
    ("light.elevation", "light.0.elevation"),
    ("light.direction", "light.0.direction"),
    ("light.color", "light.0.color"),
    ("light.intensity", "light.0.intensity"),
    ("light.shadows", "light.0.shadows"),
    ("light.softness", "light.0.angular_radius"),
    ("light.resolution", "sweep.light_resolution"),
    ("light.margin", "sweep.light_margin"),
    ("mesh.file", "mesh.0.file"),
    ("mesh.builtin", "mesh.0.builtin"),
    ("mesh.up", "mesh.0.up"),
    ("mesh.twist", "mesh.0.twist"),
    ("transfer.medium", "transfer.filter"),
    ("voxels.resolution", "voxelization.resolution"),
    ("shadow.absorption", "shadow.optical_depth"),
    ("shadow.softness", "shadow.filter_radius"),
];

/// Keys, old values and new ones.
pub(super) const VALUES: [(&str, &str, &str); 1] = [("shadow.coefficient", "counted", "per_triangle")];

/// The new name of the key `key` of the table at `path`, if that is an old one.
pub(super) fn key(path: &[String], key: &str) -> Option<&'static str> {
    let old = in_scene(path).iter().map(String::as_str).chain([key]).collect::<Vec<_>>().join(".");
    KEYS.iter().find(|(known, _)| *known == old).map(|(_, new)| *new)
}

/// The new name of a value of the key at `path`, if that is an old one.
pub(super) fn value(path: &[String], value: &str) -> Option<&'static str> {
    let key = in_scene(path).join(".");
    VALUES.iter().find(|(known, old, _)| *known == key && *old == value).map(|(_, _, new)| *new)
}

/// The path inside the scene of one in a file of key frames, where `key.0` and so on come first.
fn in_scene(path: &[String]) -> &[String] {
    match path {
        [first, _, rest @ ..] if first == "key" => rest,
        _ => path,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{KeyFrames, Scene, SceneError};
    use super::{KEYS, VALUES};

    /// The three ways to write a key: a scene file, a setting, key frames.
    fn refusals(key: &str, value: &str) -> [SceneError; 3] {
        let (table, name) = key.split_once('.').unwrap();
        let setting = format!("{key}={value}");
        let frames = format!("[[key]]\nframe = 0\n{setting}\n");
        [
            Scene::from_toml(&format!("[{table}]\n{name} = {value}\n"), "scene.toml").unwrap_err(),
            Scene::default().set(&setting).unwrap_err(),
            KeyFrames::from_toml(&frames, "keys.toml", 10.0).unwrap_err(),
        ]
    }

    #[test]
    fn every_old_key_is_refused_with_the_new_one() {
        for (old, new) in KEYS {
            for refusal in refusals(old, "1") {
                assert!(refusal.key.ends_with(old), "{refusal}");
                assert!(refusal.to_string().contains(&format!("now `{new}`")), "{refusal}");
                let last = new.rsplit('.').next().unwrap();
                assert!(refusal.help().contains(last), "{}", refusal.help());
            }
        }
    }

    #[test]
    fn every_new_key_is_one() {
        for (_, new) in KEYS {
            // The value may be wrong, the key is not.
            let refusal = Scene::default().set(&format!("{new}={{}}")).map_err(|error| error.to_string());
            assert!(!refusal.is_err_and(|message| message.contains("unknown key")), "{new}");
        }
    }

    #[test]
    fn every_old_value_is_refused_with_the_new_one() {
        for (key, old, new) in VALUES {
            for refusal in refusals(key, &format!("\"{old}\"")) {
                assert!(refusal.key.ends_with(key), "{refusal}");
                assert_eq!(refusal.help(), format!("did you mean `{new}`?"));
            }
            Scene::default().set(&format!("{key}={new}")).unwrap();
        }
    }
}
