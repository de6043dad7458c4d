//! The sweep's light against millions of photons, and the photons against more of them.

use vitrum::backend::Backend;
use vitrum::scene::Transport;

use super::Section;
use super::plot::{Axis, Corner, Plot, Scale, Series};
use crate::Failure;
use crate::photons::{Slopes, Subject};
use crate::table::aligned;

const SCENES: [&str; 3] = ["luneburg", "ball", "glass"];
/// Pixels along each side.
const EDGE: u32 = 96;
/// Voxels along a volume's longest edge.
const RESOLUTION: u32 = 64;
/// Photons along each side of a texel, of the counts that are compared with the reference, which has at least `REFERENCE`.
const FEWER: [u32; 5] = [1, 2, 3, 4, 5];
const REFERENCE: u32 = 8;
/// The fewest photons of a reference.
const FEWEST: u32 = 2_000_000;

/// A count of photons.
struct Reference {
    photons: u32,
    light: Vec<Vec<f64>>,
}

/// The photons of a subject in a medium of such slopes, as many as it takes.
fn referenced(subject: &Subject, slopes: Slopes) -> Reference {
    let count = |across: u32| subject.texels() * across * across;
    let across = (REFERENCE..).find(|&across| count(across) >= FEWEST).unwrap_or(REFERENCE);
    Reference { photons: count(across), light: subject.photons(across, slopes) }
}

/// Both comparisons with photons, for each scene.
pub fn photons(_: &mut dyn Backend) -> Result<Section, Failure> {
    let mut rows = Vec::new();
    let mut series = Vec::new();
    for scene in SCENES {
        let subject = Subject::new(scene, EDGE, RESOLUTION, Transport::Texels)?;
        let count = |across: u32| subject.texels() * across * across;
        let reference = referenced(&subject, Slopes::SixNeighbours);
        let texels = subject.sweep_against(&reference.light);
        let subject_forward = Subject::new(scene, EDGE, RESOLUTION, Transport::Forward)?;
        let of_forward = referenced(&subject_forward, Slopes::SixNeighbours);
        let forward = subject_forward.sweep_against(&of_forward.light);
        let interpolated = subject_forward.sweep_against(&referenced(&subject_forward, Slopes::Interpolated).light);
        for (plane, name) in ["⅓", "⅔", "last"].into_iter().enumerate() {
            let share = |misplaced: f64| format!("{:.1} %", misplaced * 100.0);
            rows.push([
                format!("`{scene}`"),
                name.to_owned(),
                share(texels[plane].misplaced),
                format!("{:.3}", texels[plane].flux),
                share(forward[plane].misplaced),
                format!("{:.3}", forward[plane].flux),
                share(interpolated[plane].misplaced),
                format!("{:.3}", interpolated[plane].flux),
                format!("{}, {}", reference.photons, of_forward.photons),
            ]);
        }
        let reference = reference.light;
        let error = |across: u32| {
            let compared = subject.compare(&reference, &subject.photons(across, Slopes::SixNeighbours));
            // All three planes, since a photon that strays does so on any of them.
            let mean = compared.iter().map(|compared| compared.misplaced).sum::<f64>() / compared.len() as f64;
            (f64::from(count(across)), mean)
        };
        series.push(Series::new(scene, FEWER.map(error).to_vec()));
    }
    let header = [
        "scene",
        "plane",
        "texels: light in another place",
        "flux",
        "forward: light in another place",
        "flux",
        "forward, η interpolated",
        "flux",
        "photons",
    ];
    let sweep = aligned(header.map(str::to_owned), rows);
    let header = ["photons a texel", "`luneburg`", "`ball`", "`glass`"].map(str::to_owned);
    let of = |row: usize| {
        let share = |line: usize| format!("{:.3} %", series[line].points[row].1 * 100.0);
        [(FEWER[row] * FEWER[row]).to_string(), share(0), share(1), share(2)]
    };
    let order = |line: usize| format!("{:.2}", -series[line].order());
    let orders = ["order in N".to_owned(), order(0), order(1), order(2)];
    let converged = aligned(header, (0..FEWER.len()).map(of).chain([orders]));
    let text = format!("{sweep}\n\nFewer photons against these:\n\n{converged}");
    let logarithmic = |label| Axis { label, scale: Scale::Logarithmic };
    let plot = Plot {
        title: "Photons against the most photons",
        x: logarithmic("photons N"),
        y: logarithmic("share of light in another place"),
        series,
        legend: Corner::UpperRight,
    };
    Ok(Section { text, plot })
}
