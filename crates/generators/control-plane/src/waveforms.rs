//! Digital wires of a sweep, from its programs: told when they change, at their own instants.

use feature_generator::FeatureProgram;
use signal::{Kind, Signal, Unit};
use sweep_generator::RangeTable;
use sweep_program::{Colour, NO_CORNER, RampAxis, RegisterCorners, Stop, SweepProgram};

/// Wires of the sweep generator and of the DPU.
pub const WIRES: &[Signal] = &[
    event("sweep.fold.x", "ramp X folds: 1 at stop 1, 0 at stop 0", "fig. 17"),
    event("sweep.fold.y", "ramp Y folds: 1 at stop 1, 0 at stop 0", "fig. 17"),
    polarity("sweep.polarity.x", "flip-flop s_x: 1 where X runs north, 0 where it runs south"),
    polarity("sweep.polarity.y", "flip-flop s_y: 1 where Y runs east, 0 where it runs west"),
    event("dpu.late", "a stop found words missing: bit 3p + q for each, fine level", "section 6.3"),
];

/// Registers of the fine level.
pub const REGISTERS: &[Signal] = &[
    register("tg.yellow.hold", "corner that feeds the yellow multiplying D/As"),
    register("tg.yellow.xfirst", "corner that waits for an X stop"),
    register("tg.yellow.yfirst", "corner that waits for a Y stop"),
    register("tg.green.hold", "corner that feeds the green multiplying D/As"),
    register("tg.green.xfirst", "corner that waits for an X stop"),
    register("tg.green.yfirst", "corner that waits for a Y stop"),
    register("tg.black.hold", "corner that feeds the black multiplying D/As"),
    register("tg.black.xfirst", "corner that waits for an X stop"),
    register("tg.black.yfirst", "corner that waits for a Y stop"),
    register("tg.red.hold", "corner that feeds the red multiplying D/As"),
    register("tg.red.xfirst", "corner that waits for an X stop"),
    register("tg.red.yfirst", "corner that waits for a Y stop"),
];

/// The same of the coarse level.
pub const COARSE: &[Signal] = &[
    event("sweep.coarse.fold.x", "ramp X of the coarse level folds: 1 at stop 1, 0 at stop 0", "fig. 17"),
    event("sweep.coarse.fold.y", "ramp Y of the coarse level folds: 1 at stop 1, 0 at stop 0", "fig. 17"),
    polarity("sweep.coarse.polarity.x", "flip-flop s_x of the coarse level: 1 where X runs north"),
    polarity("sweep.coarse.polarity.y", "flip-flop s_y of the coarse level: 1 where Y runs east"),
    event("dpu.coarse.late", "a stop found words missing: bit 3p + q for each, coarse level", "section 6.3"),
    register("tg.coarse.yellow.hold", "corner that feeds the yellow multiplying D/As"),
    register("tg.coarse.yellow.xfirst", "corner that waits for an X stop"),
    register("tg.coarse.yellow.yfirst", "corner that waits for a Y stop"),
    register("tg.coarse.green.hold", "corner that feeds the green multiplying D/As"),
    register("tg.coarse.green.xfirst", "corner that waits for an X stop"),
    register("tg.coarse.green.yfirst", "corner that waits for a Y stop"),
    register("tg.coarse.black.hold", "corner that feeds the black multiplying D/As"),
    register("tg.coarse.black.xfirst", "corner that waits for an X stop"),
    register("tg.coarse.black.yfirst", "corner that waits for a Y stop"),
    register("tg.coarse.red.hold", "corner that feeds the red multiplying D/As"),
    register("tg.coarse.red.xfirst", "corner that waits for an X stop"),
    register("tg.coarse.red.yfirst", "corner that waits for a Y stop"),
];

/// Wires of the feature generator.
pub const FEATURES: &[Signal] =
    &[event("fg.centre", "the sweep passes the centre of a crater: its number in the list", "section 10")];

const fn event(name: &'static str, meaning: &'static str, figure: &'static str) -> Signal {
    Signal::digital(name, Unit::Number, Kind::Event, meaning, figure)
}

const fn polarity(name: &'static str, meaning: &'static str) -> Signal {
    Signal::digital(name, Unit::Gate, Kind::Gate, meaning, "section 6.4")
}

const fn register(name: &'static str, meaning: &'static str) -> Signal {
    Signal::digital(name, Unit::Corner, Kind::Bus, meaning, "fig. 22")
}

/// Instants, in samples from the start of the sweep, and values.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Changes {
    /// Instants of the changes, ascending (samples).
    pub times: Vec<f64>,
    /// The value from each of them on.
    pub values: Vec<f64>,
}

impl Changes {
    /// One more change, behind all others.
    pub fn push(&mut self, time: f64, value: f64) {
        self.times.push(time);
        self.values.push(value);
    }

    /// A value that stays until another comes; at one instant the last stands.
    pub fn becomes(&mut self, time: f64, value: f64) {
        if self.values.last() == Some(&value) {
            return;
        }
        if self.times.last() == Some(&time) {
            self.times.pop();
            self.values.pop();
        }
        self.push(time, value);
    }
}

/// What a digital wire of the terrain path did in a sweep.
pub fn changes(name: &str, program: &SweepProgram) -> Changes {
    let name = name.replacen("coarse.", "", 1);
    match name.split('.').collect::<Vec<_>>()[..] {
        ["sweep", "fold", axis] => folds(program, axis),
        ["sweep", "polarity", axis] => polarities(program, axis),
        ["dpu", "late"] => late(program),
        ["tg", colour, place] => register_of(program, colour, place),
        _ => Changes::default(),
    }
}

/// The craters in the sub-generators, when the sweep passes their centres.
pub fn feature_centres(program: &FeatureProgram, table: &RangeTable) -> Changes {
    let mut passed: Vec<(f64, u32)> = program
        .loads
        .iter()
        .map(|load| (load.middle, load.crater))
        .filter(|(range, _)| *range > 0.0)
        .collect();
    passed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut changes = Changes::default();
    for (range, crater) in passed {
        let time = table.time_of(range).0;
        if time.is_finite() {
            changes.push(time, f64::from(crater));
        }
    }
    changes
}

fn axis_of(word: &str) -> RampAxis {
    if word == "x" { RampAxis::X } else { RampAxis::Y }
}

fn folds(program: &SweepProgram, axis: &str) -> Changes {
    let mut changes = Changes::default();
    for step in &program.steps {
        if let Some(fold) = step.kind.fold().filter(|fold| fold.axis == axis_of(axis)) {
            changes.push(step.time.0, f64::from(u8::from(fold.stop == Stop::One)));
        }
    }
    changes
}

fn polarities(program: &SweepProgram, axis: &str) -> Changes {
    let start = program.start.ramps[usize::from(axis == "y")].polarity > 0.0;
    let mut changes = Changes { times: vec![beginning(program)], values: vec![f64::from(u8::from(start))] };
    for (fold, time) in folds(program, axis).times.into_iter().enumerate() {
        changes.push(time, f64::from(u8::from(start == (fold % 2 == 1))));
    }
    changes
}

/// When the state at the start of a sweep holds: at the first sample, or with a step on the way from the eye's foot to it.
fn beginning(program: &SweepProgram) -> f64 {
    program.steps.first().map_or(0.0, |step| step.time.0.min(0.0))
}

fn late(program: &SweepProgram) -> Changes {
    let mut misses: Vec<(f64, f64)> =
        program.misses.iter().map(|miss| (miss.time.0, f64::from(miss.words.0))).collect();
    misses.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut changes = Changes::default();
    misses.into_iter().for_each(|(time, words)| changes.push(time, words));
    changes
}

/// The corner whose first word a register holds: single words may be of another while they come in.
fn register_of(program: &SweepProgram, colour: &str, place: &str) -> Changes {
    let Some(colour) = Colour::ALL.into_iter().find(|known| known.name() == colour) else {
        return Changes::default();
    };
    let register = ["hold", "xfirst", "yfirst"].iter().position(|known| *known == place).unwrap_or(0);
    let mut corners = RegisterCorners::at_start(&program.registers);
    let mut changes = Changes::default();
    let mut tell = |time: f64, corners: &RegisterCorners| {
        let corner = corners.of(colour)[register][0];
        changes.becomes(time, if corner == NO_CORNER { -1.0 } else { f64::from(corner) });
    };
    tell(beginning(program), &corners);
    for step in program.events() {
        corners.follow(&step.kind);
        tell(step.time.0, &corners);
    }
    changes
}
