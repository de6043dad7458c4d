//! Animations: GIF, APNG and MP4, frame by frame, beside their path and renamed when whole.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use gif::{DisposalMethod, Repeat};
use png::{BitDepth, ColorType, SrgbRenderingIntent};

use super::picture::Picture;
use super::srgb::{linear_to_srgb, to_8_bits};
use super::video::Video;
use crate::atomic_write::{Staged, create_beside, failed};
use crate::error::{Error, Place, Report};
use crate::input::display_name;
use crate::temporary::Temporary;

/// Speed of the choice of GIF's 256 colours: 1 is the best choice, 30 the fastest.
const GIF_SPEED: i32 = 10;

/// GIF counts in hundredths of a second, and programs that show animations slow down what has fewer than two.
const MOST_GIF_RATE: u16 = 50;

/// A writer of an animation that repeats for ever.
pub struct Animation {
    path: PathBuf,
    beside: Temporary,
    encoder: Encoder,
    size: [u32; 2],
    frames: u32,
    left: u32,
    rate: u16,
}

enum Encoder {
    Gif(Box<gif::Encoder<BufWriter<File>>>),
    Png(Box<png::Writer<BufWriter<File>>>),
    Video(Video),
}

impl Animation {
    /// Begins an animation of `frames` frames of `size` pixels at `rate` frames a second: a GIF (`.gif`), an animated PNG (`.png`,
    /// `.apng`), or an MP4 (`.mp4`) where the program ffmpeg is installed. The frames of a GIF last whole hundredths of a second,
    /// which differ by one where the rate does not divide 100, so that the animation as a whole keeps it.
    ///
    /// # Errors
    ///
    /// [`Error::Unsupported`] where the extension is another, [`Error::Write`] where the size is 0 or too large for the format,
    /// the rate is above 50 for a GIF, or the operating system fails.
    pub fn create(path: &Path, size: [u32; 2], frames: u32, rate: u16) -> Result<Self, Error> {
        let name = display_name(path);
        let report = Report::new(&name);
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let beside = create_beside(report, path)?;
        let sink = || Ok(BufWriter::new(beside.file().try_clone()?));
        let encoder = match extension.as_str() {
            "gif" => {
                let [Ok(width), Ok(height)] = size.map(u16::try_from) else {
                    let problem = format!("{} x {} pixels are too many for GIF", size[0], size[1]);
                    return Err(report.write(problem, "write at most 65535 pixels a side, or a .png", None));
                };
                if rate > MOST_GIF_RATE {
                    let problem = format!("{rate} frames a second are too many for GIF");
                    let advice = format!("choose at most {MOST_GIF_RATE}, or write a .png or .mp4");
                    return Err(report.write(problem, advice, None));
                }
                sink().and_then(|sink| begin_gif(sink, width, height))
            }
            "png" | "apng" => sink().and_then(|sink| begin_png(sink, size, frames, rate)),
            "mp4" => Ok(Encoder::Video(Video::begin(report, beside.path(), size, rate.max(1))?)),
            _ => {
                let found = format!("`.{extension}` is no known animation format");
                return Err(report.unsupported(Place::File, found, "use .gif, .png (animated), .mp4 or a folder"));
            }
        };
        let encoder = encoder.map_err(|error| failed(report, error))?;
        Ok(Self { path: path.to_owned(), beside, encoder, size, frames, left: frames, rate: rate.max(1) })
    }

    /// The file of a frame where an animation is a folder of pictures.
    #[must_use]
    pub fn frame_file(folder: &Path, index: u32) -> PathBuf {
        folder.join(format!("frame-{index:05}.png"))
    }

    /// Adds a frame: the picture's first layer as sRGB with straight alpha.
    ///
    /// # Errors
    ///
    /// [`Error::Write`] where the picture has another size or there are more frames than were announced, or the operating
    /// system fails.
    pub fn push(&mut self, picture: &Picture) -> Result<(), Error> {
        let name = display_name(&self.path);
        let report = Report::new(&name);
        if [picture.width, picture.height] != self.size || self.left == 0 {
            let problem = "a frame is not what was announced".to_owned();
            return Err(report.write(problem, "give all frames the same size, and as many as announced", None));
        }
        let index = self.frames - self.left;
        self.left -= 1;
        let mut pixels = rgba(picture);
        let written = match &mut self.encoder {
            Encoder::Gif(encoder) => {
                let [width, height] = self.size.map(|n| n as u16);
                let mut frame = gif::Frame::from_rgba_speed(width, height, &mut pixels, GIF_SPEED);
                frame.delay = gif_delay(index, self.rate);
                frame.dispose = DisposalMethod::Background;
                encoder.write_frame(&frame).map_err(io::Error::other)
            }
            Encoder::Png(writer) => writer.write_image_data(&pixels).map_err(io::Error::other),
            Encoder::Video(video) => video.push(&pixels),
        };
        written.map_err(|error| failed(report, error))
    }

    /// Ends the animation and puts it in its place.
    ///
    /// # Errors
    ///
    /// [`Error::Write`] where frames are missing, or the operating system fails.
    pub fn finish(self) -> Result<(), Error> {
        let name = display_name(&self.path);
        let report = Report::new(&name);
        if self.left > 0 {
            return Err(report.write(format!("{} frames are missing", self.left), "add them", None));
        }
        let ended = match self.encoder {
            Encoder::Gif(encoder) => encoder.into_inner().map_err(io::Error::other).and_then(|mut sink| sink.flush()),
            Encoder::Png(writer) => writer.finish().map_err(io::Error::other),
            Encoder::Video(mut video) => video.end(),
        };
        ended.and_then(|()| self.beside.file().sync_all()).map_err(|error| failed(report, error))?;
        Staged::of(self.beside, self.path).put()
    }
}

fn begin_gif(sink: BufWriter<File>, width: u16, height: u16) -> io::Result<Encoder> {
    let mut encoder = gif::Encoder::new(sink, width, height, &[]).map_err(io::Error::other)?;
    encoder.set_repeat(Repeat::Infinite).map_err(io::Error::other)?;
    Ok(Encoder::Gif(Box::new(encoder)))
}

/// Hundredths of a second that a frame lasts: from the one nearest to its begin to that nearest to the next one's.
fn gif_delay(index: u32, rate: u16) -> u16 {
    let rate = u64::from(rate);
    let begin = |index: u64| (200 * index + rate) / (2 * rate);
    (begin(u64::from(index) + 1) - begin(u64::from(index))) as u16
}

fn begin_png(sink: BufWriter<File>, [width, height]: [u32; 2], frames: u32, rate: u16) -> io::Result<Encoder> {
    let mut encoder = png::Encoder::new(sink, width, height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
    encoder.set_animated(frames, 0).map_err(io::Error::other)?;
    encoder.set_frame_delay(1, rate.max(1)).map_err(io::Error::other)?;
    Ok(Encoder::Png(Box::new(encoder.write_header().map_err(io::Error::other)?)))
}

/// The first layer as four bytes a pixel.
fn rgba(picture: &Picture) -> Vec<u8> {
    let alpha = picture.layers.first().and_then(|layer| layer.channel("A")).map(Cow::Borrowed);
    let alpha = alpha.unwrap_or_else(|| vec![1.0; (picture.width * picture.height) as usize].into());
    let pixels = picture.color().into_iter().zip(alpha.iter());
    pixels
        .flat_map(|([r, g, b], &alpha)| {
            let code = |value: f32| to_8_bits(linear_to_srgb(value));
            [code(r), code(g), code(b), to_8_bits(alpha)]
        })
        .collect()
}
