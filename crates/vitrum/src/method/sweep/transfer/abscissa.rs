//! Abscissae of tables: where their entries stand among the scalars.
//!
//! An abscissa rises by a number of entries over each of a few pieces of the scalars, and is constant beyond: entries stand where the functions
//! change. See [`vitrum_kernels::abi::tables`] for what kernels read.

use vitrum_kernels::abi::tables::{EXTENT_WORDS, PIECE_WORDS};

/// Entries of the narrowest stretch between two points of the functions, if there are enough.
const FEWEST: f64 = 8.0;
/// How fast entries may get wider with the distance from a narrow stretch: two scalars, one within such a stretch and one beside it, have a mean
/// that falls with their distance, which entries much wider than that would not show.
const GROWTH: f64 = 0.25;
/// The width of an entry into which a step may be taken, where pieces are too few: a share of the whole.
const STEP: f64 = 1e-3;
/// How much wider than needed entries may become before a point of the functions is given up as the place of an entry.
const POINT: f64 = 3.0;

/// A stretch of scalars, and what entries it is to get.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::method::sweep) struct Stretch {
    start: f64,
    end: f64,
    /// Entries; any positive number.
    entries: f64,
    /// The width of entries that it needs.
    finest: f64,
    /// Whether a point of the functions is where it starts.
    at_point: bool,
}

impl Stretch {
    fn width(&self) -> f64 {
        self.end - self.start
    }

    fn with(&self, next: &Self) -> Self {
        let (entries, finest) = (self.entries + next.entries, self.finest.min(next.finest));
        Self { end: next.end, entries, finest, ..*self }
    }

    /// How many times as wide as needed entries become where it shares a piece with the next one.
    fn cost(&self, next: &Self) -> f64 {
        let both = self.with(next);
        let coarseness = both.width() / both.entries / both.finest;
        if next.at_point { POINT * coarseness } else { coarseness }
    }
}

/// Stretches between the places `places` (ascending, in single precision) for a table of means over pairs of scalars: the narrowest get a few of
/// `entries` entries each, and the rest is spent by length, but wide entries keep their distance from narrow ones. Stretches up to `ramp`
/// wide are steps, of one entry.
pub(in crate::method::sweep) fn graded(places: &[f64], entries: u32, ramp: f64) -> Vec<Stretch> {
    let between: Vec<[f64; 2]> = places.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let is_step = |[start, end]: [f64; 2]| end - start <= ramp;
    let wide: Vec<[f64; 2]> = between.iter().copied().filter(|&part| !is_step(part)).collect();
    let width = |x: f64| {
        let widths = wide.iter().map(|[start, end]| {
            let distance = (start - x).max(x - end).max(0.0);
            (end - start) / FEWEST + GROWTH * distance
        });
        widths.fold(f64::INFINITY, f64::min)
    };
    let whole = places.last().zip(places.first()).map_or(0.0, |(last, first)| last - first);
    let mut parts: Vec<Stretch> = Vec::new();
    for part in between {
        let [start, end] = part;
        if is_step(part) {
            parts.push(Stretch { start, end, entries: 1.0, finest: STEP * whole, at_point: true });
        } else {
            let first = parts.len();
            divide([start, end], &width, &mut parts);
            parts[first].at_point = true;
        }
    }
    let steps = parts.iter().filter(|part| is_step([part.start, part.end])).count() as f64;
    let available = (f64::from(entries) - steps).max(1.0);
    let limited = |finest: f64, widest: f64| finest.min(widest);
    let count = |widest: f64| -> f64 {
        let parts = parts.iter().filter(|part| !is_step([part.start, part.end]));
        parts.map(|part| part.width() / limited(part.finest, widest)).sum()
    };
    // The widest entries with which all are spent.
    let mut widest = f64::INFINITY;
    if count(widest) < available {
        let (mut low, mut high) = (0.0, whole);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if count(middle) > available { low = middle } else { high = middle }
        }
        widest = high;
    }
    for part in &mut parts {
        if !is_step([part.start, part.end]) {
            part.finest = limited(part.finest, widest);
            part.entries = part.width() / part.finest;
        }
    }
    parts
}

/// Adds to `parts` the stretch, in parts over which `width`, the width of entries, is about the same.
fn divide([start, end]: [f64; 2], width: &impl Fn(f64) -> f64, parts: &mut Vec<Stretch>) {
    let middle = f64::midpoint(start, end);
    let widths = [start, middle, end].map(width);
    let finest = widths.into_iter().fold(f64::INFINITY, f64::min);
    let coarsest = widths.into_iter().fold(0.0, f64::max);
    if coarsest > 2.0 * finest && end - start > 2.0 * finest {
        divide([start, middle], width, parts);
        divide([middle, end], width, parts);
    } else {
        parts.push(Stretch { start, end, entries: 1.0, finest: widths[1], at_point: false });
    }
}

/// Stretches between points (place, value) for a table of values: entries are spent half by length and half by how much the values change.
pub(in crate::method::sweep) fn by_change(points: &[(f64, f64)]) -> Vec<Stretch> {
    let changes = || points.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs());
    let (whole, change) =
        (points.last().zip(points.first()).map_or(0.0, |(last, first)| last.0 - first.0), changes().sum::<f64>());
    let stretch = |(pair, changed): (&[(f64, f64)], f64)| {
        let (start, end) = (pair[0].0, pair[1].0);
        let entries = (end - start) / whole + if change > 0.0 { changed / change } else { 0.0 };
        Stretch { start, end, entries, finest: (end - start) / entries, at_point: true }
    };
    points.windows(2).zip(changes()).map(stretch).collect()
}

/// A piece: entries in equal parts of the scalars from `start` on.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    start: f32,
    /// Entries per scalar.
    rate: f32,
    entries: u32,
}

/// Where the entries of a table stand among the normalised scalars.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::method::sweep) struct Abscissa {
    pieces: Vec<Piece>,
    end: f32,
    entries: u32,
}

impl Abscissa {
    /// An abscissa of `entries` intervals in at most `most` pieces. Neighbouring stretches share a piece where they must, those first whose
    /// entries become the least too wide. Without stretches it is 0 everywhere.
    pub(in crate::method::sweep) fn new(mut stretches: Vec<Stretch>, entries: u32, most: u32) -> Self {
        while stretches.len() > most as usize {
            let cost = |at: &usize| stretches[*at].cost(&stretches[at + 1]);
            let Some(cheapest) = (0..stretches.len() - 1).min_by(|a, b| cost(a).total_cmp(&cost(b))) else { break };
            stretches[cheapest] = stretches[cheapest].with(&stretches[cheapest + 1]);
            stretches.remove(cheapest + 1);
        }
        let Some(last) = stretches.last() else { return Self { pieces: Vec::new(), end: f32::MAX, entries } };
        let end = last.end as f32;
        let ends: Vec<f32> = stretches.iter().skip(1).map(|stretch| stretch.start as f32).chain([end]).collect();
        let counts = whole_numbers(&stretches, entries);
        let pieces = stretches.iter().zip(ends).zip(counts).map(|((stretch, end), entries)| {
            let start = stretch.start as f32;
            let mut rate = (f64::from(entries) / (f64::from(end) - f64::from(start))) as f32;
            // As kernels round, the last entry stands at the end.
            while (end - start) * rate < entries as f32 {
                rate = rate.next_up();
            }
            Piece { start, rate, entries }
        });
        Self { pieces: pieces.collect(), end, entries }
    }

    /// The words that kernels read, for `most` pieces, with ends that are farther apart than the pieces' by `margin` on either side.
    pub(in crate::method::sweep) fn words(&self, most: u32, margin: f32) -> Vec<u32> {
        let unused = Piece { start: f32::MAX, rate: 0.0, entries: 0 };
        let pieces = self.pieces.iter().copied().chain(std::iter::repeat(unused)).take(most as usize);
        let words = pieces.flat_map(|Piece { start, rate, entries }| [start, rate, entries as f32]);
        let start = self.pieces.first().map_or(f32::MAX, |piece| piece.start);
        let words: Vec<u32> = words.chain([start - margin, self.end + margin]).map(f32::to_bits).collect();
        debug_assert_eq!(words.len() as u32, most * PIECE_WORDS + EXTENT_WORDS);
        words
    }

    /// The normalised scalars of the entries, at the ends of the intervals. Where it is 0 everywhere, they are all 0.
    pub(in crate::method::sweep) fn nodes(&self) -> Vec<f64> {
        let ends = self.pieces.iter().skip(1).map(|piece| piece.start).chain([self.end]).map(f64::from);
        let inside = self.pieces.iter().zip(ends).flat_map(|(piece, end)| {
            let start = f64::from(piece.start);
            let at = move |entry: u32| start + (end - start) * f64::from(entry) / f64::from(piece.entries);
            (0..piece.entries).map(at)
        });
        let mut nodes: Vec<f64> = inside.chain([f64::from(self.end)]).collect();
        if self.pieces.is_empty() {
            nodes = vec![0.0];
        }
        nodes.resize(self.entries as usize + 1, nodes.last().copied().unwrap_or_default());
        nodes
    }
}

/// Whole numbers of entries, at least 1 each, with the sum `entries`, about in the ratios that the stretches ask for.
fn whole_numbers(stretches: &[Stretch], entries: u32) -> Vec<u32> {
    let sum: f64 = stretches.iter().map(|stretch| stretch.entries).sum();
    let wanted: Vec<f64> = stretches.iter().map(|stretch| stretch.entries / sum * f64::from(entries)).collect();
    let mut counts: Vec<u32> = wanted.iter().map(|wanted| (wanted.floor() as u32).max(1)).collect();
    let shortage = |at: &usize, counts: &[u32]| wanted[*at] - f64::from(counts[*at]);
    while counts.iter().sum::<u32>() < entries {
        let most = (0..counts.len()).max_by(|a, b| shortage(a, &counts).total_cmp(&shortage(b, &counts)));
        if let Some(at) = most {
            counts[at] += 1;
        }
    }
    while counts.iter().sum::<u32>() > entries {
        let least = (0..counts.len())
            .filter(|&at| counts[at] > 1)
            .min_by(|a, b| shortage(a, &counts).total_cmp(&shortage(b, &counts)));
        match least {
            Some(at) => counts[at] -= 1,
            None => break,
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::abi::tables::{SEGMENT_ABSCISSA, SEGMENT_PIECES, SEGMENT_SIZE};
    use vitrum_kernels::field::tables::segment_place;

    const ENTRIES: u32 = SEGMENT_SIZE - 1;
    const RAMP: f64 = 3e-6;

    /// The abscissa of a table over functions with points at `places`, and its words as kernels read them.
    fn abscissa(places: &[f64]) -> (Abscissa, Vec<u32>) {
        let abscissa = Abscissa::new(graded(places, ENTRIES, RAMP), ENTRIES, SEGMENT_PIECES);
        let mut words = vec![0; SEGMENT_ABSCISSA as usize];
        words.extend(abscissa.words(SEGMENT_PIECES, 0.0));
        (abscissa, words)
    }

    fn single(places: &[f64]) -> Vec<f64> {
        places.iter().map(|&place| f64::from(place as f32)).collect()
    }

    #[test]
    fn one_stretch_is_divided_into_equal_parts() {
        let (abscissa, words) = abscissa(&[0.0, 1.0]);
        assert_eq!(abscissa.pieces, [Piece { start: 0.0, rate: 255.0, entries: 255 }]);
        for scalar in [-1e9, -0.1, 0.0, 0.25, 0.7, 1.0, 1.1, 1e9_f32] {
            assert_eq!(segment_place(&words, scalar), scalar.clamp(0.0, 1.0) * 255.0);
        }
    }

    #[test]
    fn it_rises_from_end_to_end_and_its_entries_stand_at_the_points() {
        let sets: [&[f64]; 5] = [
            &[0.0, 1.0],
            &[0.0, 0.3, 0.31, 1.0],
            &[0.0, 0.5, 0.5001, 1.0],
            &[0.0, 1e-4, 1.0],
            &[0.0, 0.4, 0.400_002, 1.0],
        ];
        for places in sets {
            let places = single(places);
            let (abscissa, words) = abscissa(&places);
            let nodes = abscissa.nodes();
            assert_eq!(nodes.len() as u32, ENTRIES + 1);
            assert!(nodes.is_sorted_by(|a, b| a < b), "{places:?}");
            for place in &places {
                assert!(nodes.contains(place), "{place} of {places:?}");
                let at = segment_place(&words, *place as f32);
                assert!(at == at.round() && nodes[at as usize] == *place, "{place} is at {at}");
            }
            for (entry, node) in nodes.iter().enumerate() {
                // A rounding of the scalar is up to so many entries.
                let steepest = abscissa.pieces.iter().map(|piece| piece.rate).fold(0.0, f32::max);
                let off = 1e-6 * (255.0 + steepest);
                let at = segment_place(&words, *node as f32);
                assert!((at - entry as f32).abs() < off, "{node}: {at} instead of {entry}");
            }
            let mut scalars: Vec<f32> =
                (-100..=1100).map(|i| i as f32 * 1e-3).chain(nodes.iter().map(|&n| n as f32)).collect();
            scalars.sort_unstable_by(f32::total_cmp);
            let at: Vec<f32> = scalars.iter().map(|&scalar| segment_place(&words, scalar)).collect();
            assert!(at.is_sorted(), "{places:?}");
            assert_eq!((at[0], at[at.len() - 1]), (0.0, 255.0), "{places:?}");
        }
    }

    #[test]
    fn narrow_stretches_get_entries_and_wide_ones_keep_their_distance() {
        let places = single(&[0.0, 0.4999, 0.5, 0.5001, 1.0]);
        let (abscissa, _) = abscissa(&places);
        let nodes = abscissa.nodes();
        let within = nodes.iter().filter(|&&node| (places[1]..=places[3]).contains(&node)).count();
        assert!(within >= 15, "{within}");
        for pair in nodes.windows(2) {
            let distance = (places[1] - pair[1]).max(pair[0] - places[3]).max(0.0);
            let width = pair[1] - pair[0];
            assert!(width <= 1e-4 + 1.5 * distance, "{width} at {distance}");
        }
        let widest = nodes.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        assert!(widest < 0.012, "{widest}");
    }

    #[test]
    fn more_points_than_pieces_share_them() {
        let places: Vec<f64> = (0..=40).map(|i| f64::from(i) / 40.0).collect();
        let (abscissa, _) = abscissa(&single(&places));
        assert!(abscissa.pieces.len() == SEGMENT_PIECES as usize);
        let widest = abscissa.nodes().windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        assert!(widest < 1.2 / 255.0, "{widest}");
        // More than a table has entries for.
        let places: Vec<f64> = (0..=999).map(|i| f64::from(i) / 999.0).collect();
        assert_eq!(self::abscissa(&single(&places)).0.nodes().len(), 256);
    }

    #[test]
    fn without_change_it_is_nothing() {
        let (abscissa, words) = abscissa(&[]);
        assert!(abscissa.nodes().iter().all(|&node| node == 0.0));
        assert_eq!([-1e9, 0.0, 1e9].map(|scalar| segment_place(&words, scalar)), [0.0; 3]);
    }

    #[test]
    fn half_of_the_entries_go_where_values_change() {
        let stretches = by_change(&[(0.0, 1.0), (0.1, 1.5), (1.0, 1.5)]);
        let abscissa = Abscissa::new(stretches, 1000, 4);
        assert_eq!(abscissa.pieces.iter().map(|piece| piece.entries).collect::<Vec<_>>(), [550, 450]);
    }
}
