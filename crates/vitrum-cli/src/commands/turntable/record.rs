//! The mark in each picture of a folder that says which scene it is of, so that `--resume` mixes no two.

use crate::failure::{Failure, Status};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::Path;
use vitrum::io::Mesh;
use vitrum::scene::Scene;
use vitrum::{Assets, Subject};

/// Key of the mark in the metadata of a picture.
const KEY: &str = "vitrum.frame";

/// The marks of the pictures of an animation.
pub struct Record {
    /// What tells data from other data of the same name: sizes, ranges and bounds.
    data: String,
}

impl Record {
    pub fn of(assets: &Assets) -> Self {
        let of_mesh = |mesh: &Mesh| format!("{} {} {:?}", mesh.positions.len(), mesh.triangles.len(), mesh.bounds());
        let mut data = match &assets.subject {
            Subject::Mesh(mesh) => of_mesh(mesh),
            subject => subject.volume().map_or_else(String::new, |volume| {
                format!("{:?} {:?} {:?} {:?}", volume.dimensions, volume.spacing, volume.range, volume.histogram(64))
            }),
        };
        data.extend(assets.bodies.as_deref().map(of_mesh));
        Self { data }
    }

    /// The mark of the picture of a scene: a hash of everything that it depends on, as metadata.
    pub fn mark(&self, scene: &Scene) -> Result<(String, String), Failure> {
        let digest = Sha256::digest(format!("{}\n{}", self.data, scene.to_toml()?));
        Ok((KEY.to_owned(), digest.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// Whether a picture of the scene is in the file. Fails if the file holds another picture.
    pub fn is_done(&self, file: &Path, scene: &Scene) -> Result<bool, Failure> {
        let Ok(bytes) = fs::read(file) else { return Ok(false) };
        let problem = match mark_in(&bytes) {
            Some(mark) if mark == self.mark(scene)?.1.as_bytes() => return Ok(true),
            Some(_) => "this picture is of another scene, or of other data",
            None => "nothing in this file says which scene it is of",
        };
        let message = format!("{}: {problem}", file.display());
        let help = "leave out --resume to render all pictures anew, or choose another folder";
        Err(Failure::new(Status::WrongUse, message, help))
    }
}

/// The mark in a PNG: the text behind the last zero of the chunk `iTXt` with the key.
fn mark_in(png: &[u8]) -> Option<&[u8]> {
    const SIGNATURE: usize = 8;
    let mut rest = png.get(SIGNATURE..)?;
    loop {
        let length = u32::from_be_bytes(rest.get(..4)?.try_into().ok()?) as usize;
        let (kind, data) = (rest.get(4..8)?, rest.get(8..8 + length)?);
        let keyword = data.strip_prefix(KEY.as_bytes()).filter(|behind| behind.first() == Some(&0));
        if let (b"iTXt", Some(behind)) = (kind, keyword) {
            return behind.rsplit(|&byte| byte == 0).next();
        }
        // The checksum follows.
        rest = rest.get(12 + length..)?;
    }
}

#[cfg(test)]
mod tests {
    use super::mark_in;

    #[test]
    fn damaged_files_have_no_mark() {
        let chunk = [&b"\x89PNG\r\n\x1a\n\0\0\0\x13iTXtvitrum.frame\0\0\0\0\0ab"[..], b"CRC."].concat();
        assert_eq!(mark_in(&chunk), Some(&b"ab"[..]));
        for end in 0..chunk.len() - 6 {
            assert_eq!(mark_in(&chunk[..end]), None, "{end}");
        }
    }
}
