//! What makes a column differ: the timing, the parts or both, by what remains when one side is made ideal.

use picture::GreyPicture;
use serde::Serialize;

use super::four::Four;

/// Whose work a difference is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Class {
    /// Late words, corners, set-ups, bodies.
    Timing,
    /// Analog parts, tubes, yoke.
    Parts,
    /// Each has a hand in it, or neither alone would show.
    Both,
}

impl Class {
    /// All, in the order of tables.
    pub const ALL: [Self; 3] = [Self::Timing, Self::Parts, Self::Both];

    /// Returns the word for the class in tables and documents.
    pub fn word(self) -> &'static str {
        match self {
            Self::Timing => "timing",
            Self::Parts => "parts",
            Self::Both => "both",
        }
    }
}

/// How a difference that the timing has a hand in comes to the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// It is there with ideal parts: it lies where the ideal machine's sweeps lie.
    Straight,
    /// It is there with the real parts alone, which move it, blur it and keep it from frame to frame.
    ThroughParts,
}

/// One pixel, in levels of 255.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pixel {
    /// Column from 0 at the left.
    pub column: usize,
    /// Line from 0 at the top.
    pub line: usize,
    /// Machine against ideal machine.
    pub difference: u32,
    /// What remains without the timing: digital side ideal, against ideal.
    pub parts_alone: u32,
    /// What remains without the parts: analog side ideal, against ideal.
    pub timing_alone: u32,
    /// Which side of the machine causes the difference: timing, parts or both.
    pub class: Class,
    /// Unless it is the parts' alone.
    pub way: Option<Way>,
}

/// A column that differs.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The pixel that differs most, the first of several.
    pub worst: Pixel,
    /// Of these pixels, the worst that the timing has a hand in.
    pub timed: Option<Pixel>,
    /// Mean of the absolute differences of all its pixels (levels).
    pub mean: f64,
    /// Of all pixels that differ by more.
    pub class: Class,
    /// Lines of pixels that the timing has a hand in and that no line of the record reaches.
    pub untraced: Vec<usize>,
}

impl Column {
    /// Whether every pixel that differs is accounted for.
    pub fn is_accounted_for(&self) -> bool {
        self.untraced.is_empty()
    }
}

/// Columns that differ by more than `levels` of 255 anywhere; `is_reached` says whether any line of the record reaches a
/// pixel by its [`Way`].
pub fn judge(four: &Four, levels: u32, is_reached: impl Fn(&Pixel, Way) -> bool) -> Vec<Column> {
    (0..four.machine.columns()).filter_map(|column| judge_column(four, levels, column, &is_reached)).collect()
}

fn judge_column(
    four: &Four,
    levels: u32,
    column: usize,
    is_reached: &impl Fn(&Pixel, Way) -> bool,
) -> Option<Column> {
    let lines = four.machine.lines();
    let beyond: Vec<Pixel> = (0..lines).filter_map(|line| four.pixel(column, line, levels)).collect();
    let worst = worst_of(beyond.iter())?;
    let sum: u32 = (0..lines).map(|line| difference(&four.machine, &four.ideal, column, line)).sum();
    let timed = || beyond.iter().filter_map(|pixel| Some((pixel, pixel.way?)));
    Some(Column {
        worst,
        timed: worst_of(timed().map(|(pixel, _)| pixel)),
        mean: f64::from(sum) / lines as f64,
        class: beyond.iter().map(|pixel| pixel.class).reduce(joined)?,
        untraced: timed()
            .filter(|(pixel, way)| !is_reached(pixel, *way))
            .map(|(pixel, _)| pixel.line)
            .collect(),
    })
}

fn joined(a: Class, b: Class) -> Class {
    if a == b { a } else { Class::Both }
}

fn worst_of<'a>(pixels: impl Iterator<Item = &'a Pixel>) -> Option<Pixel> {
    pixels.copied().reduce(|worst, pixel| if pixel.difference > worst.difference { pixel } else { worst })
}

impl Four {
    /// The pixel, if it differs by more than `levels`. A side has a hand in it if it changes it by more than `levels`
    /// while the other is ideal, or while the other is as it is.
    fn pixel(&self, column: usize, line: usize, levels: u32) -> Option<Pixel> {
        let between = |a: &GreyPicture, b: &GreyPicture| difference(a, b, column, line);
        let Self { machine, ideal, parts_alone, timing_alone } = self;
        let found = between(machine, ideal);
        if found <= levels {
            return None;
        }
        let [without_timing, without_parts] = [parts_alone, timing_alone].map(|alone| between(alone, ideal));
        let is_straight = without_parts > levels;
        let is_timed = is_straight || between(machine, parts_alone) > levels;
        let is_parts = without_timing > levels || between(machine, timing_alone) > levels;
        let class = match (is_timed, is_parts) {
            (true, false) => Class::Timing,
            (false, true) => Class::Parts,
            _ => Class::Both,
        };
        let way =
            (class != Class::Parts).then_some(if is_straight { Way::Straight } else { Way::ThroughParts });
        let (difference, parts_alone, timing_alone) = (found, without_timing, without_parts);
        Some(Pixel { column, line, difference, parts_alone, timing_alone, class, way })
    }
}

fn difference(a: &GreyPicture, b: &GreyPicture, column: usize, line: usize) -> u32 {
    let at = line * a.columns() + column;
    u32::from(a.codes()[at].abs_diff(b.codes()[at]))
}

#[cfg(test)]
mod tests {
    use picture::{Depth, GreyPicture};

    use super::{Class, Column, Four, Way, judge};

    fn picture(codes: &[u16]) -> GreyPicture {
        GreyPicture::new(codes.len() / 2, 2, Depth::Eight, codes.to_vec()).unwrap()
    }

    /// Columns: equal, timing, parts, both, neither alone, timing through the parts.
    fn four() -> Four {
        Four {
            ideal: picture(&[50, 50, 50, 50, 50, 50, 9, 9, 9, 9, 9, 9]),
            machine: picture(&[58, 70, 70, 90, 62, 70, 9, 9, 9, 9, 9, 9]),
            parts_alone: picture(&[50, 50, 70, 70, 56, 50, 9, 9, 9, 9, 9, 9]),
            timing_alone: picture(&[58, 70, 50, 70, 56, 54, 9, 9, 9, 9, 9, 9]),
        }
    }

    fn columns(is_reached: impl Fn(usize, Way) -> bool) -> Vec<Column> {
        judge(&four(), 8, |pixel, way| is_reached(pixel.column, way))
    }

    #[test]
    fn classes_follow_from_what_remains() {
        let found: Vec<_> = columns(|_, _| true)
            .into_iter()
            .map(|column| (column.worst.column, column.class, column.timed.and_then(|pixel| pixel.way)))
            .collect();
        let (straight, through) = (Some(Way::Straight), Some(Way::ThroughParts));
        let expected = [
            (1, Class::Timing, straight),
            (2, Class::Parts, None),
            (3, Class::Both, straight),
            (4, Class::Both, through),
            (5, Class::Both, through),
        ];
        assert_eq!(found, expected);
        let column = columns(|_, _| true).remove(2);
        let worst = column.worst;
        assert_eq!(
            (worst.difference, worst.parts_alone, worst.timing_alone, column.mean),
            (40, 20, 20, 20.0)
        );
    }

    /// A difference without a line: only the parts need none.
    #[test]
    fn what_no_line_reaches_is_untraced() {
        let untraced = |is_reached: &dyn Fn(usize, Way) -> bool| -> Vec<usize> {
            let all = columns(is_reached).into_iter().filter(|column| !column.is_accounted_for());
            all.map(|column| column.worst.column).collect()
        };
        assert_eq!(untraced(&|_, _| false), [1, 3, 4, 5]);
        assert_eq!(untraced(&|column, _| column != 3), [3]);
        assert_eq!(untraced(&|_, way| way == Way::Straight), [4, 5]);
        assert!(untraced(&|_, _| true).is_empty());
    }
}
