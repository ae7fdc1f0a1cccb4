//! Signals of one sweep, by name.

use std::collections::BTreeMap;

use signal::Waveform;

/// Signals that an explanation reads.
pub(crate) const SIGNALS: &[&str] = &[
    "sweep.range",
    "sweep.x",
    "sweep.y",
    "sweep.coarse.x",
    "sweep.coarse.y",
    "tg.*height",
    "tg.slope.*",
    "tg.reflectivity",
    "fg.*",
    "sc.gate",
    "fg.grain",
    "txg.texture",
    "mu.*",
    "dpp.*",
    "pg.*",
    "sm.*",
];

/// Sampled signals of one sweep.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SweepColumn(BTreeMap<&'static str, Vec<f64>>);

impl SweepColumn {
    /// Those of `waveforms`, which are of one sweep.
    pub fn new(waveforms: Vec<Waveform>) -> Self {
        Self(waveforms.into_iter().map(|wave| (wave.signal.name, wave.values)).collect())
    }

    /// Value of a signal at a sample or line; 0 where there is none.
    pub fn at(&self, signal: &str, index: usize) -> f64 {
        self.all(signal).get(index).copied().unwrap_or(0.0)
    }

    /// All values of a signal.
    pub fn all(&self, signal: &str) -> &[f64] {
        self.0.get(signal).map_or(&[], Vec::as_slice)
    }

    /// The sample at the end of the last stroke that is not blanked and crosses the middle of `cell`.
    pub fn stroke_across(&self, cell: usize) -> Option<usize> {
        let (line, blank) = (self.all("dpp.y"), self.all("dpp.blank"));
        let middle = cell as f64 + 0.5;
        let crosses = |k: &usize| {
            let (from, to) = (line[k - 1], line[*k]);
            from.min(to) <= middle && middle <= from.max(to) && blank.get(*k).is_none_or(|gate| *gate < 0.5)
        };
        let first_below = line.first().is_some_and(|first| *first <= middle);
        (1..line.len()).rev().find(crosses).or(first_below.then_some(0))
    }

    /// The last sample that has a say in `cell`: the last whose stroke leaves anything there, or the last of all where the sweep
    /// does not reach up to the top of the cell, for what is missing there might have filled it.
    pub fn last_in(&self, cell: usize) -> usize {
        let (line, blank) = (self.all("dpp.y"), self.all("dpp.blank"));
        let [top, bottom] = [cell as f64, cell as f64 + 1.0];
        let is_drawn = |k: &usize| blank.get(*k).is_none_or(|gate| *gate < 0.5);
        let touches = |k: &usize| {
            let (from, to) = (line[k - 1], line[*k]);
            from.min(to) < bottom && top < from.max(to) && is_drawn(k)
        };
        let is_filled = (0..line.len()).any(|k| line[k] <= top && is_drawn(&k));
        let is_below_first = line.first().is_some_and(|first| *first < bottom);
        let found = (1..line.len()).rev().find(touches).or(is_below_first.then_some(0));
        found.filter(|_| is_filled).unwrap_or(line.len().saturating_sub(1))
    }

    /// Samples from the first hidden one after `sample` up to the one that is seen again, if any are hidden at once.
    pub fn hidden_behind(&self, sample: usize) -> Option<[usize; 2]> {
        let blank = self.all("dpp.blank");
        let first = sample + 1;
        let hidden = blank.get(first..)?.iter().take_while(|gate| **gate > 0.5).count();
        (hidden > 0).then_some([first, first + hidden])
    }

    /// The highest line that the profile reaches, and the sample that does.
    pub fn highest(&self) -> Option<(f64, usize)> {
        let lines = self.all("dpp.y").iter().copied().enumerate();
        lines.map(|(sample, line)| (line, sample)).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

#[cfg(test)]
mod tests {
    use super::SweepColumn;
    use std::collections::BTreeMap;

    fn column(line: &[f64], blank: &[f64]) -> SweepColumn {
        SweepColumn(BTreeMap::from([("dpp.y", line.to_vec()), ("dpp.blank", blank.to_vec())]))
    }

    #[test]
    fn the_stroke_is_the_one_that_is_seen() {
        // Up to line 4, down behind the crest to 7, up again to 1.
        let line = [9.0, 6.2, 4.0, 7.0, 6.0, 1.0];
        let column = column(&line, &[0.0, 0.0, 0.0, 1.0, 1.0, 0.0]);
        assert_eq!(column.stroke_across(7), Some(1));
        assert_eq!(column.stroke_across(4), Some(5), "the last stroke stays");
        assert_eq!(column.stroke_across(0), None, "sky");
        assert_eq!(column.stroke_across(9), Some(0), "below the first sample");
        let last_in = [9, 6, 4, 1, 0].map(|cell| column.last_in(cell));
        assert_eq!(last_in, [0, 2, 5, 5, 5], "no stroke comes to line 0");
        let low = self::column(&[9.0, 6.2, 6.4, 6.5], &[0.0; 4]);
        assert_eq!([8, 6].map(|cell| low.last_in(cell)), [1, 3], "6 is not filled to its top");
        assert_eq!(column.hidden_behind(2), Some([3, 5]));
        assert_eq!(column.hidden_behind(1), None);
        assert_eq!(column.highest(), Some((1.0, 5)));
    }
}
