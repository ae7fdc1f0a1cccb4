//! A comparator: thresholds, charge of a decision, delay (hardware sections 3.6 and 6).
//!
//! The input is straight over a step. Beyond a threshold the overdrive gathers charge; the decision is found by halving the time
//! in which it does, and the output follows the delay later. An input that goes back before leaves no trace.

use super::figures::sigma;
use super::kit::Kit;

/// Longest delay in all, in delays and in seconds: 500 ns of 40 ns.
const LONGEST: [f64; 2] = [12.5, 500e-9];

/// A start of a step that is nearer to 0 than this part of its end is at 0.
const AT_ZERO: f64 = 1e-9;

/// Figures of one comparator; times in steps, voltages as shares of full scale.
#[derive(Debug, Clone, Copy)]
pub struct ComparatorFigures {
    /// Middle of both thresholds.
    pub offset: f64,
    /// Distance of both thresholds.
    pub hysteresis: f64,
    /// From a decision to the output.
    pub delay: f64,
    /// Area of overdrive that a decision takes.
    pub charge: f64,
    /// From a passing to a decision at the latest.
    pub patience: f64,
    /// Deviation of the thresholds' noise.
    pub noise: f64,
}

impl ComparatorFigures {
    /// Number `number` of the comparators called `part`, without noise.
    pub fn of(kit: &Kit<'_>, part: &str, number: usize) -> Self {
        let figures = &kit.analog.comparator;
        let delay = kit.figure(part, number, figures.delay, sigma::SWITCHING);
        let overdrive = kit.figure(part, number, kit.share(figures.overdrive), sigma::SWITCHING);
        let longest = (LONGEST[0] * delay).min(LONGEST[1].max(delay));
        Self {
            offset: kit.drawn.error(&format!("{part}.offset"), number, kit.share(figures.offset)),
            hysteresis: figures.hysteresis,
            delay: delay / kit.step,
            charge: overdrive / kit.step,
            patience: (longest - delay).max(0.0) / kit.step,
            noise: 0.0,
        }
    }

    /// From the instant at which a ramp of `slope` (full scales a step; infinite: a jump) passes a threshold to the output.
    pub fn on_ramp(&self, slope: f64) -> f64 {
        let fills = if self.charge == 0.0 { 0.0 } else { (2.0 * self.charge / slope).sqrt() };
        self.delay + fills.min(self.patience)
    }
}

/// A change of an output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trip {
    /// When (steps from the first sample).
    pub at: f64,
    /// The output from then on.
    pub high: bool,
}

#[derive(Debug, Clone, Copy)]
struct Passing {
    since: f64,
    threshold: f64,
    charge: f64,
}

/// A comparator along a sweep.
#[derive(Debug, Clone, Copy)]
pub struct Comparator {
    figures: ComparatorFigures,
    high: bool,
    passing: Option<Passing>,
    /// How near the input has come to a threshold without a decision that is safe from rounding (shares of full scale).
    pub nearest: f64,
}

/// The input seen from the output: beyond the threshold is positive; time in steps from the begin of the step.
#[derive(Debug, Clone, Copy)]
struct Line {
    start: f64,
    change: f64,
}

impl Comparator {
    /// A comparator with this output.
    pub fn new(figures: ComparatorFigures, high: bool) -> Self {
        Self { figures, high, passing: None, nearest: f64::INFINITY }
    }

    /// The step to `sample` with its deviate of noise and the input at both ends; adds what it trips to.
    pub fn step(&mut self, sample: usize, deviate: f64, input: [f64; 2], trips: &mut Vec<Trip>) {
        let begin = sample as f64 - 1.0;
        let start = if input[0].abs() < input[1].abs() * AT_ZERO { 0.0 } else { input[0] };
        let input = [start, input[1]];
        let shift = self.figures.noise * deviate;
        let (mut now, mut is_start) = (0.0, true);
        while let Some(passing) = self.passing.or_else(|| self.passes(begin, [now, shift], is_start, input)) {
            now = (passing.since - begin).max(now);
            is_start = false;
            let line = self.line(passing.threshold, input);
            let Some(next) = self.follow(&passing, line, [begin, now], trips) else { break };
            now = next;
        }
    }

    fn line(&self, threshold: f64, [u0, u1]: [f64; 2]) -> Line {
        let sign = if self.high { -1.0 } else { 1.0 };
        Line { start: sign * (u0 - threshold), change: sign * (u1 - u0) }
    }

    /// Whether the input passes the threshold from `now` on.
    fn passes(
        &mut self,
        begin: f64,
        [now, shift]: [f64; 2],
        is_start: bool,
        input: [f64; 2],
    ) -> Option<Passing> {
        let ComparatorFigures { offset, hysteresis, .. } = self.figures;
        let threshold = offset + if self.high { -0.5 } else { 0.5 } * hysteresis + shift;
        let line = self.line(threshold, input);
        let highest = line.start.max(line.start + line.change);
        if highest != 0.0 {
            self.nearest = self.nearest.min(highest.abs());
        }
        let at = if line.change > 0.0 {
            Some((-line.start / line.change).max(now)).filter(|at| *at <= 1.0)
        } else {
            (is_start && line.start > 0.0).then_some(now)
        }?;
        Some(Passing { since: begin + at, threshold, charge: 0.0 })
    }

    /// What comes of a passing from `now` on; the instant at which it comes to an end within the step.
    fn follow(
        &mut self,
        passing: &Passing,
        line: Line,
        [begin, now]: [f64; 2],
        trips: &mut Vec<Trip>,
    ) -> Option<f64> {
        let left = 1.0 - now;
        let over = Line { start: (line.start + line.change * now).max(0.0), change: line.change };
        let turns_back = if over.change < 0.0 { -over.start / over.change } else { f64::INFINITY };
        let lasts = left.min(turns_back);
        let waits = (self.figures.patience - (begin + now - passing.since)).max(0.0);
        let needs = self.figures.charge - passing.charge;
        let decides = over.fills(needs, lasts).unwrap_or(f64::INFINITY).min(waits);
        if decides <= lasts {
            self.passing = None;
            self.high = !self.high;
            trips.push(Trip { at: begin + now + decides + self.figures.delay, high: self.high });
            return Some(now + decides);
        }
        let area = over.area(lasts);
        if turns_back <= left {
            self.nearest = self.nearest.min((needs - area).abs()).min((waits - lasts).abs());
            self.passing = None;
            return Some(now + turns_back);
        }
        self.passing = Some(Passing { charge: passing.charge + area, ..*passing });
        None
    }
}

impl Line {
    /// Area of the overdrive up to a time.
    fn area(&self, time: f64) -> f64 {
        time * (self.start + 0.5 * self.change * time)
    }

    /// When the area has come to `charge`, if by `end`; the overdrive does not turn back before.
    fn fills(&self, charge: f64, end: f64) -> Option<f64> {
        if charge <= 0.0 {
            return Some(0.0);
        }
        if self.area(end) < charge {
            return None;
        }
        let (mut early, mut late) = (0.0, end);
        loop {
            let middle = 0.5 * (early + late);
            if middle <= early || middle >= late {
                break;
            }
            let bound = if self.area(middle) < charge { &mut early } else { &mut late };
            *bound = middle;
        }
        Some(late)
    }
}
