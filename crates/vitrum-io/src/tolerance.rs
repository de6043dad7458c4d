//! The one rule of all readers about faults in a file: what does not decide voxels, positions or connectivity is left out and told,
//! never fatal; what a user's option replaces is not checked; a second source stands in for a bad first one. `docs/security.md` has
//! the rule in full.

use crate::error::Error;
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};

/// Distances of voxels beyond this are no distances: far below the end of float32, so that no extent overflows.
const LARGEST: f64 = 1e17;

/// The steps along the axes that a file states, mended: each is finite and not 0, and below 0 where the axis runs backwards.
///
/// A distance that is none (0, NaN, infinite) is taken for `unit`, and told, unless the user's spacing replaces it anyway.
pub(crate) fn steps(stated: [f64; 3], unit: f64, options: &OpenOptions, assumptions: &mut Assumptions) -> [f64; 3] {
    let mut steps = stated;
    for (axis, step) in steps.iter_mut().enumerate() {
        let name = ["x", "y", "z"][axis];
        let narrow = (*step as f32).abs();
        // One that is only too large is told by the check of the extent, unless it is replaced.
        let replaced = options.spacing.is_some() && step.abs() > LARGEST;
        if !(narrow > 0.0 && narrow.is_finite()) || replaced {
            if options.spacing.is_none() {
                let fact = format!("the spacing along {name} is {step}, which is no distance: {unit} was taken");
                assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
            }
            *step = unit;
        } else if *step < 0.0 {
            let fact = format!("the spacing along {name} is {step}: its axis was taken to run backwards");
            assumptions.push(fact);
        }
    }
    steps
}

/// The spacings that a file states; where they cannot be read, `ones` if the user's spacing replaces them anyway.
pub(crate) fn replaceable<T>(stated: Result<T, Error>, ones: T, options: &OpenOptions) -> Result<T, Error> {
    stated.or_else(|error| if options.spacing.is_some() { Ok(ones) } else { Err(error) })
}

/// Tells that a file says no spacing, unless the user's spacing replaces it anyway.
pub(crate) fn note_unspaced(options: &OpenOptions, assumptions: &mut Assumptions) {
    if options.spacing.is_none() {
        let fact = "the file says no spacing: 1 was taken along each axis";
        assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
    }
}

/// The origin, where it is finite; one that is not is dropped and told, and the grid is centred.
pub(crate) fn origin(stated: Option<[f64; 3]>, assumptions: &mut Assumptions) -> Option<[f64; 3]> {
    let [x, y, z] = stated?;
    if [x, y, z].iter().all(|value| (*value as f32).is_finite()) {
        return stated;
    }
    assumptions.push(format!("the origin ({x:?}, {y:?}, {z:?}) is no position: the grid was centred on the world's"));
    None
}

/// Counts of what was left out, by what it is: each is told once.
#[derive(Debug, Default)]
pub(crate) struct LeftOut(Vec<(&'static str, u64)>);

impl LeftOut {
    /// Counts one more.
    pub fn add(&mut self, what: &'static str) {
        match self.0.iter_mut().find(|(other, _)| *other == what) {
            Some((_, count)) => *count += 1,
            None => self.0.push((what, 1)),
        }
    }

    /// Tells all counts.
    pub fn tell(self, assumptions: &mut Assumptions) {
        assumptions.extend(self.0.into_iter().map(|(what, count)| format!("left out: {count} {what}")));
    }
}

/// The text of a name: UTF-8, or else Latin-1, as which every byte has a meaning.
pub(crate) fn name(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(name) => name.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    }
}

/// The mark that some editors put in front of UTF-8.
pub(crate) const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
