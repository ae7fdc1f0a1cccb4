//! Digital signals: levels, words and pulses.

use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, mix};
use crate::frame::SMALL;
use crate::lettering;

use super::clock::View;
use super::page::{Logic, LogicLane, RegisterColour};

/// From one lane to the next.
pub(crate) const LANE: f32 = 24.0;
/// Height of a level and of a word.
const HIGH: f32 = 15.0;
/// Size of the text of words.
const WORD: f32 = 11.0;
/// A word narrower than this is not told from the next.
const NARROW: f32 = 3.0;

/// A lane in its area.
pub(crate) struct Lane<'p, 'a> {
    pub lane: &'p LogicLane<'a>,
    pub view: &'p View<'a>,
    pub area: Area,
}

impl Lane<'_, '_> {
    /// Draws it, with its name at the left.
    pub fn draw(&self, canvas: &mut Canvas) {
        let (area, palette) = (self.area, canvas.palette());
        let at = (area.left - 10.0, self.low() - 3.0);
        canvas.text(self.lane.name, at, Anchor::Right, SMALL, palette.ink);
        canvas.fill(Area { top: self.low(), height: 1.0, ..area }, palette.faint);
        canvas.clip(area);
        match &self.lane.logic {
            Logic::Levels(changes) => self.levels(canvas, changes),
            Logic::Words(changes, colour) => self.words(canvas, changes, *colour),
            Logic::Pulses(pulses) => self.pulses(canvas, pulses),
        }
        canvas.unclip();
    }

    fn low(&self) -> f32 {
        (self.area.bottom() - 5.0).floor()
    }

    /// Column of an instant, held within the page: what stood before its edge goes on from there.
    fn x(&self, instant: f64) -> f32 {
        let [first, last] = self.view.window;
        let (left, right) = (self.area.left, self.area.right());
        let x = self.view.x(instant.clamp(first, last));
        if x.is_finite() { x.clamp(left, right) } else { left }
    }

    /// Each value with the columns between which it stands.
    fn stretches<'v, T>(&self, changes: &'v [(f64, T)]) -> Vec<(f32, f32, &'v T)> {
        let last = self.view.window[1];
        let ends = changes.iter().skip(1).map(|change| change.0).chain([last]);
        let all = changes.iter().zip(ends).map(|((from, value), to)| (self.x(*from), self.x(to), value));
        all.filter(|(from, to, _)| to > from).collect()
    }

    fn levels(&self, canvas: &mut Canvas, changes: &[(f64, bool)]) {
        let (low, palette) = (self.low(), canvas.palette());
        let mut edge: Vec<(f32, f32)> = Vec::new();
        for (from, to, &high) in self.stretches(changes) {
            let top = if high { low - HIGH } else { low };
            let band = Area { left: from, top, width: to - from, height: low - top };
            canvas.fill(band, mix(palette.paper, palette.traces[0], 0.3));
            edge.extend([(from, top + 0.5), (to, top + 0.5)]);
        }
        canvas.line(&edge, 1.3, palette.traces[0]);
    }

    fn words(&self, canvas: &mut Canvas, changes: &[(f64, Option<String>)], colour: Option<RegisterColour>) {
        let palette = canvas.palette();
        let edge = colour.map_or(palette.traces[5], |colour| colour.of(palette));
        let mut crowded = None;
        for (from, to, word) in self.stretches(changes) {
            if to - from < NARROW {
                crowded = Some((crowded.map_or(from, |(from, _)| from), to));
                continue;
            }
            self.crowd(canvas, crowded.take(), edge);
            let edge = if word.is_some() { edge } else { palette.late };
            self.word(canvas, [from, to], word.as_deref().unwrap_or("none"), edge);
        }
        self.crowd(canvas, crowded, edge);
    }

    /// Words that follow one another too fast to be told apart.
    fn crowd(&self, canvas: &mut Canvas, stretch: Option<(f32, f32)>, colour: Colour) {
        if let Some((from, to)) = stretch {
            let band = Area { left: from, top: self.low() - HIGH, width: to - from, height: HIGH };
            canvas.fill(band, mix(canvas.palette().paper, colour, 0.75));
        }
    }

    fn word(&self, canvas: &mut Canvas, [from, to]: [f32; 2], text: &str, edge: Colour) {
        let (low, palette) = (self.low(), canvas.palette());
        let (top, middle, slope) = (low - HIGH, low - HIGH / 2.0, ((to - from) / 3.0).min(4.0));
        let (a, b) = (from + slope, to - slope);
        let outline = [(from, middle), (a, top), (b, top), (to, middle), (b, low), (a, low), (from, middle)];
        canvas.polygon(&outline, mix(palette.paper, edge, 0.24));
        canvas.line(&outline, 1.1, edge);
        if lettering::width(text, WORD) + 2.0 * slope + 2.0 <= to - from {
            canvas.text(text, ((from + to) / 2.0, low - 3.5), Anchor::Middle, WORD, palette.ink);
        }
    }

    fn pulses(&self, canvas: &mut Canvas, pulses: &[(f64, String)]) {
        let (low, palette) = (self.low(), canvas.palette());
        let seen: Vec<(f32, &str)> = pulses
            .iter()
            .filter(|(at, _)| self.view.shows(*at))
            .map(|(at, text)| (self.x(*at), text.as_str()))
            .collect();
        let (mut drawn, mut written) = (f32::NEG_INFINITY, f32::NEG_INFINITY);
        for (index, &(x, text)) in seen.iter().enumerate() {
            // Closer than this they are a band in any case.
            if x - drawn >= 1.0 {
                canvas.line(&[(x, low), (x, low - HIGH)], 1.3, palette.traces[1]);
                drawn = x;
            }
            let next = seen.get(index + 1).map_or(self.area.right(), |next| next.0);
            let width = lettering::width(text, WORD);
            if x + 4.0 + width < next && x + 4.0 > written {
                canvas.text(text, (x + 3.0, low - 4.0), Anchor::Left, WORD, palette.soft);
                written = x + 4.0 + width;
            }
        }
    }
}
