//! What becomes of the samples of a sweep.

/// A gate is open above this.
const OPEN: f64 = 0.5;

/// What becomes of one sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fate {
    /// Part of a stroke in the picture.
    Drawn,
    /// Part of a stroke that bodies cover.
    Covered,
    /// In sight, above or below the lines that are written.
    Outside,
    /// Nearer ground hides it.
    Hidden,
    /// Beyond the stored ground.
    Beyond,
}

/// Signals of a sweep, sample by sample; `present` line by line.
pub(super) struct SweepSignals<'a> {
    pub range: &'a [f64],
    pub line: &'a [f64],
    pub blank: &'a [f64],
    /// Share of each line that bodies cover; empty without bodies.
    pub present: &'a [f64],
}

impl SweepSignals<'_> {
    /// The fate of every sample of a profile that ends at `end` (m), on `lines` lines. A sample is drawn if one of the
    /// strokes that it ends or begins reaches a line; a stroke is there if the sample that ends it is in sight.
    pub fn fates(&self, end: f64, lines: usize) -> Vec<Fate> {
        let samples = self.range.partition_point(|range| *range <= end);
        let strokes: Vec<Option<[f64; 2]>> =
            (0..samples).map(|sample| self.stroke(sample, lines as f64)).collect();
        let fate = |sample: usize| {
            let of_stroke = |stroke: usize| strokes.get(stroke).copied().flatten();
            let drawn: Vec<[f64; 2]> = [sample, sample + 1].into_iter().filter_map(of_stroke).collect();
            match drawn.as_slice() {
                _ if sample >= samples => Fate::Beyond,
                [] if self.blank[sample] > OPEN => Fate::Hidden,
                [] => Fate::Outside,
                strokes if strokes.iter().all(|stroke| self.is_covered(*stroke)) => Fate::Covered,
                _ => Fate::Drawn,
            }
        };
        (0..self.range.len()).map(fate).collect()
    }

    /// The lines that the stroke up to `sample` reaches, upper end first.
    fn stroke(&self, sample: usize, lines: f64) -> Option<[f64; 2]> {
        let from = sample.checked_sub(1)?;
        let (a, b) = (self.line[from], self.line[sample]);
        let reached = [a.min(b).max(0.0), a.max(b).min(lines)];
        (self.blank[sample] <= OPEN && reached[0] < reached[1]).then_some(reached)
    }

    fn is_covered(&self, [top, bottom]: [f64; 2]) -> bool {
        let lines = self.present.get(top.floor() as usize..bottom.ceil() as usize);
        lines.is_some_and(|lines| lines.iter().all(|share| *share >= 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::{Fate, SweepSignals};

    #[test]
    fn every_sample_has_its_fate() {
        use Fate::{Beyond, Covered, Drawn, Hidden, Outside};
        let signals = SweepSignals {
            range: &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0],
            line: &[14.0, 12.0, 9.0, 7.5, 7.8, 7.7, 6.5, 3.5, 2.5, 2.5],
            blank: &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
            present: &[0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5, 0.0, 0.0],
        };
        let fates = signals.fates(9.0, 10);
        // The second sample begins the stroke that enters the picture, the fourth hidden one the stroke behind the crest.
        let expected = [Outside, Drawn, Drawn, Drawn, Hidden, Hidden, Covered, Covered, Covered, Beyond];
        assert_eq!(fates, expected);
    }
}
