//! Sample, ground range and time of one sweep, and where they lie on a page.

use crate::PlotError;
use crate::axis::{Axis, Ruler, Tick};
use crate::mark::Area;

use super::{Along, Line, Place};

/// The clock of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock<'a> {
    /// Place of each sample, ascending: ground range, or across the line of sight (m), or counted along a scan line.
    pub ranges: &'a [f64],
    /// From sample to sample (µs); of a row and of a scan line 1.
    pub period: f64,
    /// What it is the clock of.
    pub line: Line,
}

impl Clock<'_> {
    pub(crate) fn check(&self) -> Result<(), PlotError> {
        let value = |what: &str, found, expected| PlotError::Value { what: what.into(), found, expected };
        if self.ranges.is_empty() {
            return Err(PlotError::Empty { what: self.line.place()[0].into() });
        }
        if let Some(&bad) = self.ranges.iter().find(|range| !range.is_finite()) {
            return Err(value(self.line.place()[0], bad, "a finite number"));
        }
        if let Some(pair) = self.ranges.windows(2).find(|pair| pair[1] <= pair[0]) {
            return Err(value(self.line.place()[0], pair[1], "more than at the sample before"));
        }
        let is_period = self.period.is_finite() && self.period > 0.0;
        if is_period { Ok(()) } else { Err(value("sample period", self.period, "a time above 0 µs")) }
    }

    /// Returns the instant of the last sample (samples).
    pub(crate) fn end(&self) -> f64 {
        self.ranges.len().saturating_sub(1) as f64
    }

    /// Time of an instant (µs).
    pub(crate) fn time_at(&self, instant: f64) -> f64 {
        instant * self.period
    }

    /// Ground range of an instant (m): straight between samples, as that of the nearest end beyond them.
    pub(crate) fn range_at(&self, instant: f64) -> f64 {
        between(self.ranges, instant)
    }

    /// The instant of a place in the sweep.
    pub(crate) fn instant_of(&self, place: Place) -> Result<f64, PlotError> {
        let (instant, found, what) = match place {
            Place::Range(range) => {
                (self.instant_of_range(range), range, self.line.place_with_unit(self.line.place()[0]))
            }
            Place::Time(time) => {
                (Some(time / self.period), time, self.line.instant_with_unit(self.line.instant()[0]))
            }
        };
        let inside = instant.filter(|instant| (0.0..=self.end()).contains(instant));
        let expected = "a place between the first and the last sample";
        inside.ok_or(PlotError::Value { what, found, expected })
    }

    fn instant_of_range(&self, range: f64) -> Option<f64> {
        let after = self.ranges.partition_point(|&known| known < range);
        let right = *self.ranges.get(after)?;
        if right == range {
            return Some(after as f64);
        }
        let left = *self.ranges.get(after.checked_sub(1)?)?;
        Some((after - 1) as f64 + (range - left) / (right - left))
    }
}

/// The value at an instant, straight between those of the samples; NaN without samples.
pub(crate) fn between(values: &[f64], instant: f64) -> f64 {
    let last = values.len().saturating_sub(1);
    let instant = instant.clamp(0.0, last as f64);
    let sample = (instant as usize).min(last);
    let (Some(&left), share) = (values.get(sample), instant - sample as f64) else { return f64::NAN };
    match values.get(sample + 1) {
        Some(&right) if share > 0.0 => left * (1.0 - share) + right * share,
        _ => left,
    }
}

/// A stretch of a sweep over the width of a page.
#[derive(Debug, Clone)]
pub(crate) struct View<'a> {
    pub clock: Clock<'a>,
    pub along: Along,
    /// First and last instant that are seen.
    pub window: [f64; 2],
    left: f32,
    width: f32,
    ruler: Ruler,
}

impl<'a> View<'a> {
    /// The stretch between two places.
    pub fn new(
        clock: Clock<'a>,
        along: Along,
        [from, to]: [Option<Place>; 2],
        area: Area,
    ) -> Result<Self, PlotError> {
        let instant_of = |place: Option<Place>, end| place.map_or(Ok(end), |place| clock.instant_of(place));
        let window = [instant_of(from, 0.0)?, instant_of(to, clock.end())?];
        let ends = window.map(|instant| value(&clock, along, instant));
        let ([place, _], [instant, _]) = (clock.line.place(), clock.line.instant());
        let axis = match along {
            Along::LogRange => Axis::new(clock.line.place_with_unit(place)).logarithmic(),
            Along::Range => Axis::new(clock.line.place_with_unit(place)),
            Along::Time => Axis::new(clock.line.instant_with_unit(instant)),
        };
        let axis = if from.is_some() || to.is_some() { axis.over(ends) } else { axis };
        // A sweep may begin at the foot of the eye, where there is no logarithm.
        let samples = clock.ranges.iter().copied();
        let ruler = match along {
            Along::LogRange => axis.settle(samples, 0.0)?,
            _ => axis.settle(ends.into_iter(), 0.0)?,
        };
        Ok(Self { clock, along, window, left: area.left, width: area.width, ruler })
    }

    /// Column of an instant; NaN for what a logarithm does not have.
    pub fn x(&self, instant: f64) -> f32 {
        self.at(value(&self.clock, self.along, instant))
    }

    /// Whether an instant is seen.
    pub fn shows(&self, instant: f64) -> bool {
        (self.window[0]..=self.window[1]).contains(&instant)
    }

    fn at(&self, value: f64) -> f32 {
        self.left + self.ruler.share(value) as f32 * self.width
    }

    /// Columns and labels of round values of what the page runs along.
    pub fn ticks(&self) -> Vec<(f32, String)> {
        let ticks = self.ruler.round_ticks(self.width, 85.0);
        self.seen(ticks.into_iter().map(|tick| (self.at(tick.value), tick.label)))
    }

    /// The same of the other: time along range, range along time.
    pub fn other_ticks(&self) -> Vec<(f32, String)> {
        let of_range = self.along == Along::Time;
        let ends = self.window.map(|instant| match of_range {
            true => self.clock.range_at(instant),
            false => self.clock.time_at(instant),
        });
        let ruler = Ruler::linear(ends);
        let place = |tick: &Tick| match of_range {
            true => self.clock.instant_of(Place::Range(tick.value)),
            false => self.clock.instant_of(Place::Time(tick.value)),
        };
        let ticks = ruler.round_ticks(self.width, 85.0).into_iter();
        self.seen(ticks.filter_map(|tick| Some((self.x(place(&tick).ok()?), tick.label))))
    }

    fn seen(&self, ticks: impl Iterator<Item = (f32, String)>) -> Vec<(f32, String)> {
        ticks.filter(|(x, _)| *x >= self.left - 0.01 && *x <= self.left + self.width + 0.01).collect()
    }
}

fn value(clock: &Clock<'_>, along: Along, instant: f64) -> f64 {
    if along == Along::Time { clock.time_at(instant) } else { clock.range_at(instant) }
}

#[cfg(test)]
mod tests {
    use super::{Clock, View, between};
    use crate::mark::Area;
    use crate::scope::{Along, Line, Place};

    const AREA: Area = Area { left: 100.0, top: 0.0, width: 400.0, height: 100.0 };

    #[test]
    fn places_and_instants_go_back_and_forth() {
        let clock = Clock { ranges: &[1.0, 2.0, 4.0, 8.0, 16.0], period: 0.5, line: Line::Sweep };
        assert_eq!(clock.instant_of(Place::Range(3.0)).unwrap(), 1.5);
        assert_eq!(clock.instant_of(Place::Range(1.0)).unwrap(), 0.0);
        assert_eq!(clock.instant_of(Place::Range(16.0)).unwrap(), 4.0);
        assert_eq!(clock.instant_of(Place::Time(1.25)).unwrap(), 2.5);
        assert_eq!(clock.range_at(2.5), 6.0);
        for outside in [Place::Range(0.5), Place::Range(17.0), Place::Time(-0.1), Place::Time(f64::NAN)] {
            assert!(clock.instant_of(outside).is_err(), "{outside:?}");
        }
        assert_eq!(between(&[3.0], 7.0), 3.0);
        assert_eq!(between(&[0.0, 10.0], 0.25), 2.5);
        assert!(between(&[], 0.0).is_nan());
    }

    #[test]
    fn a_geometric_sweep_is_even_in_time_and_in_decades() {
        let clock = Clock { ranges: &[1.0, 2.0, 4.0, 8.0, 16.0], period: 0.5, line: Line::Sweep };
        let of = |along| View::new(clock, along, [None; 2], AREA).unwrap();
        for sample in 0..5u8 {
            let expected = 100.0 + 100.0 * f32::from(sample);
            assert!((of(Along::LogRange).x(sample.into()) - expected).abs() < 1e-3);
            assert!((of(Along::Time).x(sample.into()) - expected).abs() < 1e-3);
        }
        // A fifteenth of the range is passed after the first sample of four.
        assert!((of(Along::Range).x(1.0) - (100.0 + 400.0 / 15.0)).abs() < 1e-3);
        assert_eq!(of(Along::LogRange).ticks().iter().filter(|(_, label)| label == "10").count(), 1);
    }

    #[test]
    fn ticks_of_the_other_axis_lie_where_the_first_says() {
        let ranges: Vec<f64> = (0..=100).map(f64::from).collect();
        let clock = Clock { ranges: &ranges, period: 0.1, line: Line::Sweep };
        let view = View::new(clock, Along::Range, [None; 2], AREA).unwrap();
        for (x, label) in view.other_ticks() {
            // 10 µs over 400 pixels.
            let time: f32 = label.parse().unwrap();
            assert!((x - (100.0 + 40.0 * time)).abs() < 1e-3, "{label} at {x}");
        }
    }

    #[test]
    fn a_window_is_what_is_seen() {
        let clock = Clock { ranges: &[1.0, 2.0, 4.0, 8.0, 16.0], period: 0.5, line: Line::Sweep };
        let ends = [Some(Place::Range(2.0)), Some(Place::Time(1.5))];
        let view = View::new(clock, Along::Range, ends, AREA).unwrap();
        assert_eq!(view.window, [1.0, 3.0]);
        assert_eq!((view.x(1.0), view.x(3.0)), (100.0, 500.0));
        let backwards = View::new(clock, Along::Range, [ends[1], ends[0]], AREA);
        assert!(backwards.is_err());
    }
}
