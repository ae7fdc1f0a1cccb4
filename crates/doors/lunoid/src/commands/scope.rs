//! How a page of the scope is asked for.

use clap::{Args, ValueEnum};
use plots::{Place, Theme};
use scope::ScopeWishes;

use command_line::values;

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
    /// Where the picture ends: ground range (m), or sweep time with `us`.
    #[arg(long, value_name = "PLACE", value_parser = place, allow_hyphen_values = true)]
    pub to: Option<Place>,
    /// Along what it runs; the other one stands at the top. With `xy` two signals are drawn, the second over the first.
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
    /// Horizontal axis of ground range.
    #[default]
    Range,
    /// Horizontal axis of sweep time.
    Time,
    /// The second of two signals over the first.
    Xy,
}

/// Paper of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ThemeWord {
    /// Dark ink on white paper.
    #[default]
    Light,
    /// Bright phosphor on dark glass.
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

    /// The same without the words of the command line.
    pub fn wishes(&self) -> ScopeWishes {
        ScopeWishes {
            cursors: self.cursor.clone(),
            from: self.from,
            to: self.to,
            xy: None,
            by_time: self.axis == AxisWord::Time,
            linear: self.linear,
            width: self.width,
            height: self.height,
            theme: if self.theme == ThemeWord::Dark { Theme::Dark } else { Theme::Light },
        }
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
