//! VTK collections, `.pvd`: files of points in time, and when they are.
//!
//! The format: <https://www.paraview.org/Wiki/ParaView/Data_formats#PVD_File_Format>.

use super::Vti;
use super::xml::{Document, Step, Tag};
use crate::detached::locate;
use crate::error::{Error, Place, Report, clip};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::source::Assumptions;
use crate::time::{Clock, Times};
use crate::volume::Volume;

/// The reader of `.pvd` files.
pub(crate) struct Pvd;

/// A file of a collection.
struct Member {
    moment: f64,
    file: String,
    place: Place,
}

impl VolumeReader for Pvd {
    fn format(&self) -> &'static Format {
        &formats::PVD
    }

    fn recognises(&self, input: &Input) -> bool {
        let has = |word: &[u8]| input.head.windows(word.len()).any(|window| window == word);
        has(b"<VTKFile") && has(b"\"Collection\"")
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut assumptions = Assumptions::default();
        let members = members(input, report, &mut assumptions)?;
        let clock = Clock::Stated(members.iter().map(|member| member.moment).collect());
        let count = members.len() as u64;
        let times = Times::choose(report, Place::File, count, &clock, options, &mut assumptions)?;
        let member = usize::try_from(times.chosen).ok().and_then(|chosen| members.get(chosen));
        let Some(Member { file, place, .. }) = member else { return Err(nothing(report)) };
        let (path, _) = locate(report, *place, input, file)?;
        let mut member = Input::new(&path, options)?;
        member.unpack(options)?;
        if Pvd.recognises(&member) || !Vti.recognises(&member) {
            let problem = format!("`{}` is no VTK image data", clip(file));
            let advice = "resample it to an image first, for example by ParaView's filter Resample To Image";
            return Err(report.unsupported(*place, problem, advice));
        }
        let mut volume = Vti.read_alone(&member, options)?;
        let told = std::mem::replace(&mut volume.source.assumptions, assumptions);
        volume.source.assumptions.extend(told);
        volume.source.format = self.format().name;
        volume.name.clone_from(&input.name);
        Ok(volume)
    }
}

/// The files of a collection by their moments, one for each; further parts of a moment are left out.
fn members(input: &Input, report: Report, assumptions: &mut Assumptions) -> Result<Vec<Member>, Error> {
    let mut document = Document::new(input.open()?, report);
    let mut members: Vec<Member> = Vec::new();
    let (mut first, mut unnumbered) = (true, 0_u32);
    loop {
        match document.next()? {
            Step::Done => break,
            Step::End => {}
            Step::Start(tag) => {
                if std::mem::take(&mut first) && (tag.name != "VTKFile" || tag.get("type") != Some("Collection")) {
                    let problem = format!("the outermost element is `{}`, and no collection", clip(&tag.name));
                    return Err(report.invalid(tag.place(), problem, "check that this is a VTK collection"));
                }
                if tag.name == "DataSet" {
                    members.push(member(report, &tag, members.len(), &mut unnumbered)?);
                }
            }
        }
    }
    // Stable, so that the first part of each moment stays the first.
    members.sort_by(|a, b| a.moment.total_cmp(&b.moment));
    let before = members.len();
    members.dedup_by(|next, first| next.moment == first.moment);
    if members.len() < before {
        assumptions.push(format!("left out: {} further parts of points in time", before - members.len()));
    }
    if unnumbered > 0 {
        assumptions.push(format!("{unnumbered} files have no `timestep` that is a number: their numbers were taken"));
    }
    if members.is_empty() {
        return Err(nothing(report));
    }
    Ok(members)
}

fn member(report: Report, tag: &Tag, number: usize, unnumbered: &mut u32) -> Result<Member, Error> {
    let Some(file) = tag.get("file") else {
        return Err(report.invalid(tag.place(), "this `DataSet` has no `file`", "write the collection anew"));
    };
    let moment = match tag.get("timestep") {
        Some(text) => text.trim().parse::<f64>().ok().filter(|moment| moment.is_finite()),
        None => None,
    };
    let moment = moment.unwrap_or_else(|| {
        *unnumbered += 1;
        number as f64
    });
    // Without the sign of a zero, which would be a moment of its own.
    Ok(Member { moment: moment + 0.0, file: file.to_owned(), place: tag.place() })
}

fn nothing(report: Report) -> Error {
    report.invalid(Place::File, "the collection has no `DataSet`", "write it anew, for example by ParaView")
}
