//! The program of one sweep.

use std::iter;

use quantities::SweepTime;

use crate::{Colour, PreloadRegister};

/// Axis of a ramp: X runs north, Y runs east.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RampAxis {
    /// Axis X, which runs north.
    X,
    /// Axis Y, which runs east.
    Y,
}

impl RampAxis {
    /// The preload register that a fold of this axis transfers.
    #[inline]
    pub fn register(self) -> PreloadRegister {
        match self {
            Self::X => PreloadRegister::XFirst,
            Self::Y => PreloadRegister::YFirst,
        }
    }

    /// Whether a fold of this axis at `stop` gives `colour` new words (event table of 6.3).
    #[inline]
    pub fn takes(self, stop: Stop, colour: Colour) -> bool {
        let far = match self {
            Self::X => colour.at_far_x(),
            Self::Y => colour.at_far_y(),
        };
        far == (stop == Stop::Zero)
    }
}

/// Limit stop of a ramp.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stop {
    /// The ramp fell to 0.
    Zero,
    /// The ramp rose to 1.
    One,
}

/// One of the two folded ramps at the start of a sweep (section 6.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Value of the ramp as the sweep starts, 0..=1.
    pub start: f64,
    /// Change of the ramp a region of ground range, signed: `cos theta * s_x` or `sin theta * s_y`.
    pub rate: f64,
    /// Polarity flip-flop: +1 where the region is crossed in its own orientation, -1 where it is mirrored.
    pub polarity: f64,
}

impl Ramp {
    /// Way from the start to the stop that is met first, 0..=1, and that stop; a ramp that stands meets none.
    #[inline]
    pub fn first_stop(&self) -> (f64, Stop) {
        if self.rate > 0.0 { (1.0 - self.start, Stop::One) } else { (self.start, Stop::Zero) }
    }

    /// Value (0..=1) and signed rate at range `lambda` (in regions), after `folds` folds.
    #[inline]
    pub fn at(&self, folds: u32, lambda: f64) -> (f64, f64) {
        if folds == 0 {
            return ((self.start + self.rate * lambda).clamp(0.0, 1.0), self.rate);
        }
        let (first, stop) = self.first_stop();
        let speed = self.rate.abs();
        let way = (speed * lambda - (first + f64::from(folds - 1))).clamp(0.0, 1.0);
        let left_one = (stop == Stop::One) == (folds % 2 == 1);
        if left_one { (1.0 - way, -speed) } else { (way, speed) }
    }
}

/// What sweep set-up computes: all else follows from the folds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepStart {
    /// Cosine and sine of the sweep's azimuth against north.
    pub direction: [f64; 2],
    /// Region (K, L) of the eye's foot; may lie outside the stored area by one.
    pub region: [i64; 2],
    /// Folded ramps X and Y.
    pub ramps: [Ramp; 2],
}

/// A ramp met its stop: fold, polarity and register transfer happen in this instant, wired.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fold {
    /// Ramp that folds, by its axis.
    pub axis: RampAxis,
    /// Stop that the ramp meets.
    pub stop: Stop,
}

impl Fold {
    /// The two colours that it gives new words, in order (event table of 6.3).
    #[inline]
    pub fn colours(self) -> [Colour; 2] {
        // By number, without a branch: nobody can guess which stop comes next.
        let (far, other) = match self.axis {
            RampAxis::X => (1, 2),
            RampAxis::Y => (2, 1),
        };
        let first = if self.stop == Stop::Zero { far } else { 0 };
        [Colour::ALL[first], Colour::ALL[first + other]]
    }
}

/// Which of the nine words of a set arrive together: bit `3 p + q`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct WordMask(pub u16);

impl WordMask {
    /// All nine words of a corner.
    pub const ALL: Self = Self(0x1ff);

    /// Only word `3 p + q`.
    pub fn only(word: usize) -> Self {
        Self(1 << word)
    }

    /// The words of `self` that are not in `other`.
    pub fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Words `from` up to, not including, `until`.
    pub fn range(from: u32, until: u32) -> Self {
        Self(((1 << until) - (1 << from)) as u16)
    }

    /// The words of both.
    pub fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The words of either.
    pub fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether no word is left.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether word `3 p + q` is among them.
    pub fn has(self, word: usize) -> bool {
        self.0 >> word & 1 == 1
    }
}

/// Where arriving words go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Target {
    /// A preload register: in time.
    Preload(PreloadRegister),
    /// Straight through to the hold register: late, under the strobe-through policy.
    Hold,
}

/// Index of a corner that the data bank has not delivered: its words are 0.
pub const NO_CORNER: u32 = u32::MAX;

/// Words arrive at the registers of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Load {
    /// Colour whose registers the words go to.
    pub colour: Colour,
    /// Register of that colour that the words go to.
    pub target: Target,
    /// Index of the corner in the storage buffer; [`NO_CORNER`] brings words of 0.
    pub corner: u32,
    /// Words that arrive, bit `3 p + q`.
    pub words: WordMask,
}

/// What happens at one instant of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// A ramp folds, and two colours take their preload register.
    Fold(Fold),
    /// A ramp folds and nothing is transferred: the loader is off.
    BareFold(Fold),
    /// Words arrive at the registers of a colour.
    Load(Load),
}

impl Event {
    /// The fold, if a ramp folds.
    #[inline]
    pub fn fold(&self) -> Option<&Fold> {
        match self {
            Self::Fold(fold) | Self::BareFold(fold) => Some(fold),
            Self::Load(_) => None,
        }
    }
}

/// One event, or several of one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepKind {
    /// One event by itself.
    Event(Event),
    /// A ramp folds, and all that the fold asks for arrives in the same instant.
    Served(Served),
}

impl From<Event> for StepKind {
    fn from(event: Event) -> Self {
        Self::Event(event)
    }
}

impl From<Served> for StepKind {
    fn from(served: Served) -> Self {
        Self::Served(served)
    }
}

impl StepKind {
    /// The fold, if a ramp folds.
    #[inline]
    pub fn fold(&self) -> Option<&Fold> {
        match self {
            Self::Event(event) => event.fold(),
            Self::Served(Served { fold, .. }) => Some(fold),
        }
    }

    /// Whether the words that feed the D/As are others after this step.
    #[inline]
    pub fn changes_hold(&self) -> bool {
        !matches!(self, Self::Event(Event::Load(Load { target: Target::Preload(_), .. })))
    }
}

/// A fold whose words nothing holds up: it and four loads in one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Served {
    /// The fold, which transfers what waits before the words arrive.
    pub fold: Fold,
    /// Corners of the words for XFIRST and YFIRST of the first of its colours, then of the second: whole sets.
    pub corners: [u32; 4],
}

impl Served {
    /// The loads, in order.
    pub fn loads(&self) -> [Load; 4] {
        let [first, second] = self.fold.colours();
        let (x, y) = (Target::Preload(PreloadRegister::XFirst), Target::Preload(PreloadRegister::YFirst));
        let [a, b, c, d] = self.corners;
        [(first, x, a), (first, y, b), (second, x, c), (second, y, d)].map(|(colour, target, corner)| Load {
            colour,
            target,
            corner,
            words: WordMask::ALL,
        })
    }
}

/// One instant of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step<K = StepKind> {
    /// When, on the sweep clock.
    pub time: SweepTime,
    /// Ground range then (m).
    pub range: f64,
    /// First sample that sees it.
    pub sample: usize,
    /// Event or events of the instant.
    pub kind: K,
}

impl Step {
    /// A step at an instant.
    #[inline]
    pub fn new(time: SweepTime, range: f64, kind: impl Into<StepKind>) -> Self {
        Self { time, range, sample: time.sample_at_or_after(), kind: kind.into() }
    }

    /// What happens, one by one.
    fn events(&self) -> impl Iterator<Item = Step<Event>> + use<> {
        let Self { time, range, sample, kind } = *self;
        let (first, loads) = match kind {
            StepKind::Event(event) => (event, None),
            StepKind::Served(served) => (Event::Fold(served.fold), Some(served.loads())),
        };
        let loads = loads.into_iter().flatten().map(Event::Load);
        iter::once(first).chain(loads).map(move |kind| Step { time, range, sample, kind })
    }
}

impl From<Step<Event>> for Step {
    fn from(Step { time, range, sample, kind }: Step<Event>) -> Self {
        Self { time, range, sample, kind: StepKind::Event(kind) }
    }
}

/// Corners in the three registers of a colour at sweep start, as indices into the storage buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RegisterSet {
    /// Feeds the multiplying D/As.
    pub hold: u32,
    /// Waits for an X stop.
    pub x_first: u32,
    /// Waits for a Y stop.
    pub y_first: u32,
}

/// Words that came after the fold they were meant for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miss {
    /// The fold that found them missing, counted from 0 in the sweep.
    pub crossing: u32,
    /// When that fold was.
    pub time: SweepTime,
    /// When the last of the words arrived; `None` if they were dropped before anyone fetched them.
    pub arrival: Option<SweepTime>,
    /// Colour whose registers were late.
    pub colour: Colour,
    /// Which preload register was stale.
    pub register: PreloadRegister,
    /// Index of the corner in the storage buffer.
    pub corner: u32,
    /// Words that came late, bit `3 p + q`.
    pub words: WordMask,
    /// Reason why they came late.
    pub cause: MissCause,
}

/// Why words came late.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MissCause {
    /// One load takes longer than the stops were apart.
    Access,
    /// The load waited for others.
    Queue,
    /// The model holds the word back.
    HeldBack,
}

/// The program of one sweep: steps in order of time; at one instant in order of cause.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepProgram {
    /// Where the ramps start.
    pub start: SweepStart,
    /// What the registers hold then, by [`Colour`].
    pub registers: [RegisterSet; 4],
    /// Folds and arrivals. [`events`](Self::events) has them one by one.
    pub steps: Vec<Step>,
    /// Ground range at which the profile ends (m): end of the programme or edge of the problem area.
    pub end_range: f64,
    /// Loads that came too late.
    pub misses: Vec<Miss>,
}

impl SweepProgram {
    /// A program that draws nothing, to be written over.
    pub fn idle() -> Self {
        let still = Ramp { start: 0.0, rate: 0.0, polarity: 1.0 };
        let start = SweepStart { direction: [1.0, 0.0], region: [0, 0], ramps: [still; 2] };
        let registers = [RegisterSet::default(); 4];
        Self { start, registers, steps: Vec::new(), end_range: 0.0, misses: Vec::new() }
    }

    /// Lets samples stand at `instants` places of a step: each fold and arrival is seen by the first of them.
    pub fn see_at(&mut self, instants: u32) {
        for step in &mut self.steps {
            step.sample = SweepTime(step.time.0 * f64::from(instants)).sample_at_or_after();
        }
    }

    /// Folds and arrivals one by one.
    pub fn events(&self) -> impl Iterator<Item = Step<Event>> {
        self.steps.iter().flat_map(Step::events)
    }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use super::{Event, Fold, RampAxis, Step, Stop, SweepProgram};
    use crate::Colour;

    #[test]
    fn the_first_instant_at_or_after_a_fold_sees_it() {
        let fold = Event::Fold(Fold { axis: RampAxis::X, stop: Stop::One });
        let seen = |time, instants| {
            let mut program = SweepProgram::idle();
            program.steps.push(Step::new(SweepTime(time), 100.0, fold));
            program.see_at(instants);
            program.steps[0].sample
        };
        assert_eq!([1, 2, 4, 5].map(|instants| seen(2.5, instants)), [3, 5, 10, 13]);
        assert_eq!([1, 2, 4].map(|instants| seen(3.0, instants)), [3, 6, 12]);
        assert_eq!([1, 4].map(|instants| seen(-0.5, instants)), [0, 0]);
    }

    #[test]
    fn a_fold_gives_words_to_the_two_colours_that_its_stop_leaves() {
        for axis in [RampAxis::X, RampAxis::Y] {
            for stop in [Stop::Zero, Stop::One] {
                let taken = Colour::ALL.into_iter().filter(|&colour| axis.takes(stop, colour));
                assert_eq!(Vec::from(Fold { axis, stop }.colours()), taken.collect::<Vec<_>>());
            }
        }
    }
}
