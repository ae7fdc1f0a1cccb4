//! Register sets of one sweep, each from the fold that asks for it to the fold that uses it.

use quantities::SweepTime;
use sweep_program::{
    Colour, Event, Fold, Load, Miss, NO_CORNER, PreloadRegister, RampAxis, Step, Stop, SweepProgram, Target,
};

/// A fold of the sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Counted from 0 in the sweep.
    pub number: u32,
    /// Time of the fold, from the start of the sweep (samples).
    pub time: SweepTime,
    /// Ground range of the fold (m).
    pub range: f64,
    /// Axis that folds, and the stop it folds at.
    pub fold: Fold,
}

/// A set of nine words on its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskedSet {
    /// Whose set it is.
    pub colour: Colour,
    /// Preload register that the set goes to.
    pub register: PreloadRegister,
    /// The fold that asks for it.
    pub asked: Crossing,
    /// Whether the next stop of the other axis needs it.
    pub urgent: bool,
    /// When its last word came; none if it was dropped.
    pub came: Option<SweepTime>,
    /// The fold that uses it; none if its colour moves on without.
    pub used: Option<Crossing>,
    /// Whether it came after that fold, or never.
    pub late: bool,
    /// Whether the data bank had not brought its corner: its words are 0.
    pub is_missing: bool,
}

impl AskedSet {
    /// From fold to register (samples).
    pub fn latency(&self) -> Option<f64> {
        Some(self.came?.0 - self.asked.time.0)
    }

    /// From register to use (samples): negative if late, none if it is not used or never comes.
    pub fn slack(&self) -> Option<f64> {
        Some(self.used?.time.0 - self.came?.0)
    }
}

/// Ground range (m) and fold of every stop that `program` meets, also of those that transfer nothing.
pub fn crossings(program: &SweepProgram) -> impl Iterator<Item = (f64, Fold)> {
    program.steps.iter().filter_map(|step| Some((step.range, *step.kind.fold()?)))
}

/// Sets of `program` in the order in which their fate is sealed, written into `sets`. Where words are `wired` through,
/// they come with the fold that asks.
pub fn sets_of(program: &SweepProgram, wired: bool, sets: &mut Vec<AskedSet>) {
    sets.clear();
    let mut walk = Walk { sets, wired, open: Default::default(), next: first_stops(program), number: 0 };
    program.events().for_each(|step| walk.pass(&step));
    walk.end();
    for miss in &program.misses {
        note_late(miss, sets);
    }
}

fn first_stops(program: &SweepProgram) -> [Option<Stop>; 2] {
    program.start.ramps.map(|ramp| (ramp.rate != 0.0).then(|| ramp.first_stop().1))
}

/// A miss knows when the words came, also those that the latched policy dropped.
fn note_late(miss: &Miss, sets: &mut [AskedSet]) {
    let is_it = |set: &&mut AskedSet| {
        set.used.is_some_and(|used| used.number == miss.crossing)
            && (set.colour, set.register) == (miss.colour, miss.register)
    };
    if let Some(set) = sets.iter_mut().find(is_it) {
        set.late = true;
        set.came = miss.arrival;
    }
}

/// The sweep, fold by fold.
struct Walk<'s> {
    sets: &'s mut Vec<AskedSet>,
    wired: bool,
    /// By colour and register.
    open: [[Option<AskedSet>; 2]; 4],
    next: [Option<Stop>; 2],
    number: u32,
}

impl Walk<'_> {
    fn pass(&mut self, step: &Step<Event>) {
        match step.kind {
            Event::Fold(fold) => {
                let Step { time, range, .. } = *step;
                self.fold(Crossing { number: self.number, time, range, fold });
            }
            Event::BareFold(_) => self.number += 1,
            Event::Load(load) => self.arrive(step.time, load),
        }
    }

    fn fold(&mut self, crossing: Crossing) {
        let Fold { axis, stop } = crossing.fold;
        self.next[usize::from(axis == RampAxis::Y)] = Some(opposite(stop));
        for colour in Colour::ALL.into_iter().filter(|&colour| axis.takes(stop, colour)) {
            for register in [PreloadRegister::XFirst, PreloadRegister::YFirst] {
                let used = (register == axis.register()).then_some(crossing);
                let fresh = self.asked(colour, register, crossing);
                if let Some(set) = self.open[colour as usize][register as usize].replace(fresh) {
                    self.sets.push(AskedSet { used, ..set });
                }
            }
        }
        self.number += 1;
    }

    fn asked(&self, colour: Colour, register: PreloadRegister, asked: Crossing) -> AskedSet {
        let across = register != asked.fold.axis.register();
        let axis = if register == PreloadRegister::XFirst { RampAxis::X } else { RampAxis::Y };
        let next = self.next[usize::from(axis == RampAxis::Y)];
        let urgent = across && next.is_some_and(|stop| axis.takes(stop, colour));
        let came = self.wired.then_some(asked.time);
        AskedSet { colour, register, asked, urgent, came, used: None, late: false, is_missing: false }
    }

    fn arrive(&mut self, time: SweepTime, load: Load) {
        // Words for a hold register are late: their miss says so.
        let Target::Preload(register) = load.target else { return };
        if let Some(set) = &mut self.open[load.colour as usize][register as usize] {
            set.came = Some(set.came.map_or(time, |known| if time > known { time } else { known }));
            set.is_missing |= load.corner == NO_CORNER;
        }
    }

    fn end(&mut self) {
        self.sets.extend(self.open.iter().flatten().flatten());
    }
}

fn opposite(stop: Stop) -> Stop {
    match stop {
        Stop::Zero => Stop::One,
        Stop::One => Stop::Zero,
    }
}
