//! The session: recent inputs, and the scene saved by itself.

use crate::trouble::Trouble;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Recent inputs that are kept.
const MOST_RECENT: usize = 12;

/// What is kept from one run of the program to the next.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Session {
    /// Inputs that were opened, the latest first.
    pub recent: Vec<String>,
    /// The document that is open; there is none after the window was closed as usual.
    pub open: Option<Saved>,
}

/// A document that is open.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Saved {
    /// The input, as a person named it.
    pub input: String,
    /// The scene's text.
    pub scene: String,
}

impl Session {
    /// The file in the user's folder for such data; `None` where the system has none.
    #[must_use]
    pub fn usual_file() -> Option<PathBuf> {
        let folders = directories::ProjectDirs::from("", "", "vitrum")?;
        Some(folders.data_local_dir().join("viewer.json"))
    }

    /// Reads the session; an unreadable one is as none.
    #[must_use]
    pub fn read(file: &Path) -> Self {
        let text = std::fs::read_to_string(file).ok();
        text.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    /// Writes the session, whole or not at all.
    ///
    /// # Errors
    /// Where the file cannot be written.
    pub fn write(&self, file: &Path) -> Result<(), Trouble> {
        if let Some(folder) = file.parent() {
            std::fs::create_dir_all(folder)
                .map_err(|error| Trouble::new(format!("{}: {error}", folder.display()), "check the folder"))?;
        }
        let text = serde_json::to_string_pretty(self).map_err(|error| Trouble::new(error.to_string(), ""))?;
        Ok(vitrum::io::write_text(file, &text)?)
    }

    /// Puts an input in front of the recent ones.
    pub fn remember(&mut self, input: &str) {
        self.recent.retain(|known| known != input);
        self.recent.insert(0, input.to_owned());
        self.recent.truncate(MOST_RECENT);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_comes_back_and_a_broken_one_is_none() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("state").join("viewer.json");
        assert_eq!(Session::read(&file), Session::default());
        let mut session = Session { open: Some(Saved { input: "a".into(), scene: "b".into() }), ..Session::default() };
        for number in 0..20 {
            session.remember(&format!("{number}"));
        }
        session.remember("15");
        assert_eq!((session.recent.len(), session.recent[0].as_str()), (MOST_RECENT, "15"));
        session.write(&file).expect("it is written");
        assert_eq!(Session::read(&file), session);
        std::fs::write(&file, "{ half").expect("it is written");
        assert_eq!(Session::read(&file), Session::default());
    }
}
