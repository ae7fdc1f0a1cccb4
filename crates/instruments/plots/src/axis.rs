//! Ranges of values, round ticks and their labels.

use quantities::fixed;

use crate::PlotError;

/// How values are spread over an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// Equal steps of value take equal lengths.
    #[default]
    Linear,
    /// Decades evenly; values are above 0.
    Logarithmic,
}

/// A range of values and what they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What is shown, with its unit: `ground range (m)`.
    pub label: String,
    /// Lowest and highest value; `None` takes them from what is drawn.
    pub range: Option<[f64; 2]>,
    /// How values are spread.
    pub scale: Scale,
    /// Whether values count something: no ticks between whole numbers.
    pub whole: bool,
}

impl Axis {
    /// A linear axis over all that is drawn.
    pub fn new(label: impl Into<String>) -> Self {
        Self { label: label.into(), range: None, scale: Scale::Linear, whole: false }
    }

    /// The same with decades evenly spread.
    pub fn logarithmic(self) -> Self {
        Self { scale: Scale::Logarithmic, ..self }
    }

    /// The same with ticks at whole numbers alone.
    pub fn whole(self) -> Self {
        Self { whole: true, ..self }
    }

    /// The same over a fixed range.
    pub fn over(self, range: [f64; 2]) -> Self {
        Self { range: Some(range), ..self }
    }

    /// The axis with its range settled: as asked for, or over the finite ones of `values` with a margin.
    pub(crate) fn settle(&self, values: impl Iterator<Item = f64>, margin: f64) -> Result<Ruler, PlotError> {
        let log = self.scale == Scale::Logarithmic;
        let drawn = values.filter(|v| v.is_finite() && (!log || *v > 0.0));
        let range = match self.range {
            Some(range) => range,
            None => widened(extremes(drawn).ok_or_else(|| self.empty())?, margin, self.scale),
        };
        self.check(range)?;
        Ok(Ruler { range, scale: self.scale, whole: self.whole })
    }

    fn check(&self, [low, high]: [f64; 2]) -> Result<(), PlotError> {
        let least = if self.scale == Scale::Logarithmic { 0.0 } else { f64::NEG_INFINITY };
        let value = |found, expected| PlotError::Value { what: self.label.clone(), found, expected };
        if !(low.is_finite() && low > least) {
            return Err(value(low, "a finite lower end, above 0 on a logarithmic axis"));
        }
        if high.is_finite() && high > low { Ok(()) } else { Err(value(high, "an upper end above the lower")) }
    }

    fn empty(&self) -> PlotError {
        PlotError::Empty { what: self.label.clone() }
    }
}

fn widened([low, high]: [f64; 2], margin: f64, scale: Scale) -> [f64; 2] {
    match scale {
        Scale::Logarithmic if high > low => [low, high],
        Scale::Logarithmic => [low / 2.0, high * 2.0],
        Scale::Linear if high > low => [low - margin * (high - low), high + margin * (high - low)],
        Scale::Linear => {
            let room = (0.1 * high.abs()).max(0.5);
            [low - room, high + room]
        }
    }
}

/// Lowest and highest; `None` without values.
pub(crate) fn extremes(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |range, value| match range {
        None => Some([value, value]),
        Some([low, high]) => Some([low.min(value), high.max(value)]),
    })
}

/// A range of values whose ends are settled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ruler {
    pub range: [f64; 2],
    pub scale: Scale,
    /// Whether ticks of a linear range are whole numbers alone.
    pub whole: bool,
}

/// A tick: its value and its label, which is empty for minor ones.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub value: f64,
    pub label: String,
}

impl Ruler {
    /// A linear range; an empty one is widened.
    pub fn linear(range: [f64; 2]) -> Self {
        Self { range: widened(range, 0.0, Scale::Linear), scale: Scale::Linear, whole: false }
    }

    /// Where `value` lies, 0 at the lower end to 1 at the upper; NaN for what a logarithm does not have.
    pub fn share(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Logarithmic => libm::log(value / low) / libm::log(high / low),
        }
    }

    /// About `target` round values within the range.
    pub fn ticks(&self, target: usize) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => self.linear_ticks(target),
            Scale::Logarithmic => self.decade_ticks(),
        }
    }

    /// Round values over `length` pixels, labels about `pitch` apart: within one decade as on a linear axis, where
    /// decades alone would label hardly any.
    pub fn round_ticks(&self, length: f32, pitch: f32) -> Vec<Tick> {
        let target = (length / pitch).clamp(1.0, 12.0) as usize;
        let ticks = self.ticks(target);
        if ticks.iter().filter(|tick| !tick.label.is_empty()).count() > 2 {
            return ticks;
        }
        let linear = Self { scale: Scale::Linear, ..*self };
        let coarse = linear.linear_ticks(target);
        let fine = if coarse.len() > 2 { coarse } else { linear.linear_ticks(2 * target) };
        if fine.is_empty() { ticks } else { fine }
    }

    fn linear_ticks(&self, target: usize) -> Vec<Tick> {
        let [low, high] = self.range;
        let least = if self.whole { 1.0 } else { 0.0 };
        let (mantissa, exponent) = round_step(((high - low) / target.max(1) as f64).max(least));
        let step = mantissa * power_of_ten(exponent);
        let first = (low / step - 1e-9).ceil();
        let count = ((high / step + 1e-9).floor() - first).clamp(-1.0, 200.0) as i64;
        let decimals = (-exponent).max(0) as usize;
        (0..=count)
            .map(|index| {
                let value = (first + index as f64) * step;
                Tick { value, label: number(value, decimals) }
            })
            .collect()
    }

    fn decade_ticks(&self) -> Vec<Tick> {
        let [low, high] = self.range;
        let [first, last] = [low, high].map(|v| libm::log10(v).floor() as i32);
        let named: &[u32] = if last - first <= 3 { &[1, 2, 5] } else { &[1] };
        let all = (first..=last).flat_map(|decade| (1..10u32).map(move |mantissa| (decade, mantissa)));
        all.filter_map(|(decade, mantissa)| {
            let value = f64::from(mantissa) * power_of_ten(decade);
            let decimals = (-decade).max(0) as usize;
            let label = if named.contains(&mantissa) { number(value, decimals) } else { String::new() };
            let inside = value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
            inside.then_some(Tick { value, label })
        })
        .collect()
    }
}

/// The round step (1, 2 or 5 times a power of ten) at or above `step`.
fn round_step(step: f64) -> (f64, i32) {
    let exponent = libm::log10(step).floor() as i32;
    let mantissa = step / power_of_ten(exponent);
    match [1.0, 2.0, 5.0].into_iter().find(|round| mantissa <= round * (1.0 + 1e-9)) {
        Some(round) => (round, exponent),
        None => (1.0, exponent + 1),
    }
}

/// `value` rounded up to 1, 2 or 5 times a power of ten; 1 for what is not above 0.
pub(crate) fn round_up(value: f64) -> f64 {
    if !(value.is_finite() && value > 0.0) {
        return 1.0;
    }
    let (mantissa, exponent) = round_step(value);
    mantissa * power_of_ten(exponent)
}

fn power_of_ten(exponent: i32) -> f64 {
    libm::pow(10.0, f64::from(exponent))
}

/// A number with a true minus sign and thousands set apart; far powers of ten as such.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    if value != 0.0 && (value.abs() >= 1e7 || (decimals > 5 && value.abs() < 0.1)) {
        return scientific(value);
    }
    let text = fixed(value, decimals);
    let (sign, size) = text.strip_prefix('-').map_or(("", text.as_str()), |size| ("−", size));
    let (whole, fraction) = size.split_once('.').map_or((size, None), |(w, f)| (w, Some(f)));
    let fraction = fraction.map_or(String::new(), |fraction| format!(".{fraction}"));
    format!("{sign}{}{fraction}", grouped(whole))
}

/// Far powers of ten; rounding errors beyond ten digits are not shown.
fn scientific(value: f64) -> String {
    let text = format!("{value:.9e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    format!("{mantissa}e{exponent}").replace('-', "−")
}

/// A measured value in `digits` significant digits.
pub(crate) fn reading(value: f64, digits: i32) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    let text = if (1e-3..1e6).contains(&size) {
        let decimals = (digits - 1 - libm::log10(size).floor() as i32).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        let digits = (digits - 1).max(0) as usize;
        format!("{value:.digits$e}")
    };
    text.replace('-', "−")
}

fn grouped(digits: &str) -> String {
    if digits.len() < 5 {
        return digits.to_owned();
    }
    let first = digits.len() % 3;
    let groups =
        digits.as_bytes()[first..].chunks(3).map(|group| String::from_utf8_lossy(group).into_owned());
    let head = (first > 0).then(|| digits[..first].to_owned());
    head.into_iter().chain(groups).collect::<Vec<_>>().join("\u{a0}")
}

#[cfg(test)]
mod tests {
    use super::{Axis, Ruler, Scale, number, reading, round_up};

    fn labels(range: [f64; 2], scale: Scale, target: usize) -> Vec<String> {
        Ruler { range, scale, whole: false }.ticks(target).into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels([0.0, 10.0], Scale::Linear, 5), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(labels([-0.31, 0.3], Scale::Linear, 4), ["−0.2", "0.0", "0.2"]);
        assert_eq!(labels([9_990.0, 10_010.0], Scale::Linear, 2), ["9990", "10\u{a0}000", "10\u{a0}010"]);
        let frames = Ruler { whole: true, ..Ruler::linear([0.0, 3.0]) };
        assert_eq!(
            frames.ticks(9).into_iter().map(|tick| tick.label).collect::<Vec<_>>(),
            ["0", "1", "2", "3"]
        );
        let decades = labels([8.0, 120.0], Scale::Logarithmic, 5);
        assert_eq!(decades, ["", "", "10", "20", "", "", "50", "", "", "", "", "100"]);
    }

    #[test]
    fn numbers_read_well() {
        assert_eq!(number(-0.0, 1), "0.0");
        assert_eq!(number(-0.04, 1), "0.0");
        assert_eq!(number(-1234567.0, 0), "−1\u{a0}234\u{a0}567");
        assert_eq!([number(1.2e8, 0), number(-2e-7, 7)], ["1.2e8", "−2e−7"]);
        let readings = [0.0, 1234.5678, -0.012345, 1e300, -1e-300, 99999.6].map(|value| reading(value, 5));
        assert_eq!(readings, ["0", "1234.6", "−0.012345", "1.0000e300", "−1.0000e−300", "100000"]);
        assert_eq!((round_up(0.012), round_up(5.0), round_up(f64::NAN)), (0.02, 5.0, 1.0));
    }

    #[test]
    fn ranges_come_from_finite_values() {
        let ruler = |axis: Axis, values: &[f64]| axis.settle(values.iter().copied(), 0.0).map(|r| r.range);
        assert_eq!(ruler(Axis::new("h"), &[f64::NAN, 1.0, 3.0]).unwrap(), [1.0, 3.0]);
        assert_eq!(ruler(Axis::new("h"), &[2.0]).unwrap(), [1.5, 2.5]);
        assert_eq!(ruler(Axis::new("r").logarithmic(), &[0.0, -1.0, 2.0, 8.0]).unwrap(), [2.0, 8.0]);
        assert!(ruler(Axis::new("h"), &[f64::NAN]).is_err());
        assert!(ruler(Axis::new("h").over([1.0, 1.0]), &[]).is_err());
        assert!(ruler(Axis::new("h").over([0.0, 1.0]).logarithmic(), &[]).is_err());
    }
}
