//! MP4 animations: raw frames into ffmpeg, which has to be installed.

use std::fs::File;
use std::io::{self, Read, Seek, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};

use crate::error::{Error, Report};

/// An ffmpeg that waits for frames. It is ended when the value is dropped.
pub(super) struct Video {
    child: Child,
    frames: Option<ChildStdin>,
    /// Messages of ffmpeg, in a file: a full pipe without a reader would stop it.
    log: File,
}

impl Video {
    /// Starts ffmpeg on a file, which it overwrites, for frames of RGBA in 8 bits.
    pub fn begin(report: Report, path: &Path, [width, height]: [u32; 2], rate: u16) -> Result<Self, Error> {
        let failed = |error: io::Error| {
            if error.kind() == io::ErrorKind::NotFound {
                let advice = "install ffmpeg, or write .gif, .png (animated) or a folder";
                return report.write("it takes the program ffmpeg, which is not installed", advice, None);
            }
            report.write(format!("ffmpeg cannot be started: {error}"), "check its installation", Some(error))
        };
        let log = tempfile::tempfile().map_err(failed)?;
        let mut command = Command::new("ffmpeg");
        command.args(["-nostdin", "-y", "-loglevel", "error", "-f", "rawvideo", "-pixel_format", "rgba"]);
        command.args(["-video_size", &format!("{width}x{height}"), "-framerate", &rate.to_string(), "-i", "pipe:0"]);
        // The format that every player shows: 4:2:0, thus even sizes, and the colours that sRGB shares with television.
        let filter = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,\
                      setparams=color_primaries=bt709:color_trc=iec61966-2-1";
        command.args(["-an", "-vf", filter, "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p"]);
        // Once more for older ones, which do not take them from the filter.
        command.args(["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"]);
        command.args(["-movflags", "+faststart", "-f", "mp4"]);
        // With its protocol, so that a colon in a folder's name is not taken for one.
        let mut file = std::ffi::OsString::from("file:");
        file.push(path);
        command.arg(file);
        command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(log.try_clone().map_err(failed)?);
        #[cfg(unix)]
        {
            use std::os::unix::process::CommandExt;
            // Ctrl-C is for this program, which then ends the other.
            command.process_group(0);
        }
        let mut child = command.spawn().map_err(failed)?;
        let frames = child.stdin.take();
        Ok(Self { child, frames, log })
    }

    /// Adds a frame.
    pub fn push(&mut self, pixels: &[u8]) -> io::Result<()> {
        let written = self.frames.as_mut().map_or(Ok(()), |frames| frames.write_all(pixels));
        match written {
            // ffmpeg ended, and says why.
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => self.end().and(Err(error)),
            written => written,
        }
    }

    /// Ends the animation.
    pub fn end(&mut self) -> io::Result<()> {
        self.frames = None;
        let status = self.child.wait()?;
        if status.success() {
            return Ok(());
        }
        let mut said = String::new();
        // Whatever it said is better than nothing.
        let _ = self.log.rewind().and_then(|()| self.log.read_to_string(&mut said));
        let last = said.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or("it did not say why").trim();
        Err(io::Error::other(format!("ffmpeg failed ({status}): {last}")))
    }
}

impl Drop for Video {
    fn drop(&mut self) {
        // Where it has ended already there is nothing to do.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
