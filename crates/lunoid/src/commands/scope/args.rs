//! How a page of the scope is asked for.

use clap::{Args, ValueEnum};
use plots::{Along, Clock, Line, Place, ScopeLook, Theme};

use crate::{Failure, values};

/// How a picture of one sweep is drawn.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Pictures of a sweep")]
pub struct ScopeArgs {
    /// One or two cursors, each at a ground range (m) or, with `us`, at a sweep time (µs): every value there, the
    /// difference and its slope are written below. On a row of LUNSIM's they are at places to the right of the line of
    /// sight (m), negative to its left.
    #[arg(long, value_name = "A[,B]", value_delimiter = ',', value_parser = place, allow_hyphen_values = true)]
    pub cursor: Vec<Place>,
    /// Where the picture begins: ground range (m), or sweep time with `us`.
    #[arg(long, value_name = "PLACE", value_parser = place, allow_hyphen_values = true)]
    pub from: Option<Place>,
    /// Where it ends.
    #[arg(long, value_name = "PLACE", value_parser = place, allow_hyphen_values = true)]
    pub to: Option<Place>,
    /// Along what it runs; the other one stands at the top.
    #[arg(long, value_enum, default_value_t)]
    pub axis: AxisWord,
    /// Ground range evenly, not its decades.
    #[arg(long)]
    pub linear: bool,
    /// Width of the page (pixels) [default: 1200].
    #[arg(long, value_parser = values::whole(600..=8000_u32))]
    pub width: Option<u32>,
    /// Height of each panel of curves (pixels) [default: 180].
    #[arg(long, value_parser = values::whole(120..=8000_u32))]
    pub height: Option<u32>,
    /// Ink on paper, or phosphor on glass.
    #[arg(long, value_enum, default_value_t)]
    pub theme: ThemeWord,
}

/// Along what a page runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum AxisWord {
    /// Ground range.
    #[default]
    Range,
    /// Sweep time.
    Time,
}

/// Paper of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ThemeWord {
    /// Ink on paper.
    #[default]
    Light,
    /// Phosphor on glass.
    Dark,
}

impl ScopeArgs {
    /// The first option that is not as it is by itself.
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            (!self.cursor.is_empty(), "--cursor"),
            (self.from.is_some(), "--from"),
            (self.to.is_some(), "--to"),
            (self.axis != AxisWord::default(), "--axis"),
            (self.linear, "--linear"),
            (self.width.is_some(), "--width"),
            (self.height.is_some(), "--height"),
            (self.theme != ThemeWord::default(), "--theme"),
        ];
        given.into_iter().find_map(|(is_given, option)| is_given.then_some(option))
    }

    /// What is asked for, over what a page of a `line` is by itself.
    ///
    /// # Errors
    /// If a row is asked for what only a sweep has.
    pub fn look(&self, title: &str, facts: Vec<String>, line: Line) -> Result<ScopeLook, Failure> {
        if line == Line::Row {
            self.expect_no_time()?;
        }
        let page = ScopeLook::titled(title);
        let along = match (self.axis, self.linear || line == Line::Row) {
            (AxisWord::Time, _) => Along::Time,
            (AxisWord::Range, true) => Along::Range,
            (AxisWord::Range, false) => Along::LogRange,
        };
        let theme = if self.theme == ThemeWord::Dark { Theme::Dark } else { Theme::Light };
        let (from, to, cursors) = (self.from, self.to, self.cursor.clone());
        let [width, height] = [(self.width, page.width), (self.height, page.height)]
            .map(|(asked, usual)| asked.unwrap_or(usual));
        Ok(ScopeLook { facts, width, height, theme, along, from, to, cursors, ..page })
    }

    /// Refuses places that are not on the page.
    pub fn expect_places(&self, clock: &Clock<'_>) -> Result<(), Failure> {
        let (Some(&near), Some(&far)) = (clock.ranges.first(), clock.ranges.last()) else { return Ok(()) };
        let end = (clock.ranges.len() - 1) as f64 * clock.period;
        let cursors = self.cursor.iter().map(|place| ("--cursor", place));
        let ends = [("--from", &self.from), ("--to", &self.to)];
        let ends = ends.into_iter().filter_map(|(option, place)| Some((option, place.as_ref()?)));
        cursors.chain(ends).try_for_each(|(option, place)| {
            let (found, unit, [low, high]) = match *place {
                Place::Range(range) => (range, " m", [near, far]),
                Place::Time(time) => (time, " us", [0.0, end]),
            };
            match (low..=high).contains(&found) {
                true => Ok(()),
                false => Err(Failure::usage(format!(
                    "{option} {found}{unit}: the samples lie from {low:.3} to {high:.3}{unit}; expected a place there"
                ))),
            }
        })
    }

    /// A row of a grid lies across the line of sight: nothing runs along it.
    fn expect_no_time(&self) -> Result<(), Failure> {
        let mut places = self.cursor.iter().chain(&self.from).chain(&self.to);
        let given = match places.find(|place| matches!(place, Place::Time(_))) {
            Some(Place::Time(time)) => format!("{time}us"),
            _ if self.axis == AxisWord::Time => "--axis time".into(),
            _ => return Ok(()),
        };
        Err(Failure::usage(format!(
            "{given}: a row has no sweep time; expected places to the right of the line of sight in metres, as -120.5"
        )))
    }
}

fn place(text: &str) -> Result<Place, String> {
    let (number, of): (&str, fn(f64) -> Place) = match text.strip_suffix("us") {
        Some(number) => (number, Place::Time),
        None => (text.strip_suffix('m').unwrap_or(text), Place::Range),
    };
    let value = number.trim().parse().ok().filter(|value: &f64| value.is_finite()).map(of);
    // A place of a row may lie to the left; no time is before the sweep.
    value.filter(|place| !matches!(place, Place::Time(time) if *time < 0.0)).ok_or_else(|| {
        format!(
            "`{text}`: expected a ground range in metres, as 120.5, or a sweep time in microseconds, as 8.2us"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::{Place, place};

    #[test]
    fn places_have_units() {
        assert_eq!(place("120.5"), Ok(Place::Range(120.5)));
        assert_eq!(place("120m"), Ok(Place::Range(120.0)));
        assert_eq!(place("8.25us"), Ok(Place::Time(8.25)));
        assert_eq!(place("-12.5"), Ok(Place::Range(-12.5)));
        for bad in ["", "us", "-1us", "inf", "NaN", "3km", "1,2"] {
            assert!(place(bad).is_err(), "{bad}");
        }
    }
}
