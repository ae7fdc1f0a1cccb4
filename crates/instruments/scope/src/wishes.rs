//! How a page is asked for, and whether that is there.

use plots::{Along, Clock, Line, Place, ScopeLook, Theme};

use crate::ScopeError;

/// What is asked for over what a page is by itself.
#[derive(Debug, Clone, Default)]
pub struct ScopeWishes {
    /// One or two cursors.
    pub cursors: Vec<Place>,
    /// Where the page begins.
    pub from: Option<Place>,
    /// Place where the page ends.
    pub to: Option<Place>,
    /// Two signals, the first across and the second up, in place of a page.
    pub xy: Option<[String; 2]>,
    /// Whether it runs along sweep time, not along ground range.
    pub by_time: bool,
    /// Whether ground range runs evenly, not by its decades.
    pub linear: bool,
    /// Width of the page (pixels).
    pub width: Option<u32>,
    /// Height of each panel of curves (pixels).
    pub height: Option<u32>,
    /// Ink on paper, or phosphor on glass.
    pub theme: Theme,
}

impl ScopeWishes {
    /// What is asked for, over what a page of a `line` is by itself.
    ///
    /// # Errors
    /// If a row is asked for what only a sweep has.
    pub(crate) fn look(&self, title: &str, facts: Vec<String>, line: Line) -> Result<ScopeLook, ScopeError> {
        if !line.has_time() {
            self.expect_no_time(line)?;
        }
        let page = ScopeLook::titled(title);
        let along = match (self.by_time, self.linear || !line.has_time()) {
            (true, _) => Along::Time,
            (false, true) => Along::Range,
            (false, false) => Along::LogRange,
        };
        let (theme, from, to, cursors) = (self.theme, self.from, self.to, self.cursors.clone());
        let [width, height] = [(self.width, page.width), (self.height, page.height)]
            .map(|(asked, usual)| asked.unwrap_or(usual));
        Ok(ScopeLook { facts, width, height, theme, along, from, to, cursors, ..page })
    }

    /// Refuses places that are not on the page.
    pub(crate) fn expect_places(&self, clock: &Clock<'_>) -> Result<(), ScopeError> {
        let (Some(&near), Some(&far)) = (clock.ranges.first(), clock.ranges.last()) else { return Ok(()) };
        let end = (clock.ranges.len() - 1) as f64 * clock.period;
        let cursors = self.cursors.iter().map(|place| ("--cursor", place));
        let ends = [("--from", &self.from), ("--to", &self.to)];
        let ends = ends.into_iter().filter_map(|(option, place)| Some((option, place.as_ref()?)));
        cursors.chain(ends).try_for_each(|(option, place)| {
            let (found, unit, [low, high]) = match *place {
                Place::Range(range) if clock.line == Line::ScanLine => (range, "", [near, far]),
                Place::Range(range) => (range, " m", [near, far]),
                Place::Time(time) => (time, " us", [0.0, end]),
            };
            match (low..=high).contains(&found) {
                true => Ok(()),
                false => Err(ScopeError::Beyond { option, found, unit, low, high }),
            }
        })
    }

    /// A row of a grid lies across the line of sight, and a scan line is a line of the picture: no time runs along them.
    fn expect_no_time(&self, line: Line) -> Result<(), ScopeError> {
        let mut places = self.cursors.iter().chain(&self.from).chain(&self.to);
        let given = match places.find(|place| matches!(place, Place::Time(_))) {
            Some(Place::Time(time)) => format!("{time}us"),
            _ if self.by_time => "--axis time".into(),
            _ => return Ok(()),
        };
        Err(ScopeError::NoTime { given, line })
    }
}
