//! Registers at an instant of a sweep, and the late words that are in force then.

use serde::Serialize;
use sweep_program::{
    Colour, Load, Miss, MissCause, NO_CORNER, PreloadRegister, RampAxis, StepKind, SweepProgram, Target,
    WordMask,
};

/// Words that missed the stop they were meant for.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Late {
    /// Fold of the sweep that found them missing, from 0.
    pub crossing: u32,
    /// Whose registers.
    pub colour: &'static str,
    /// Which register was stale.
    pub register: &'static str,
    /// When they were due (samples of the sweep).
    pub due: f64,
    /// When the last one came; none if never.
    pub came: Option<f64>,
    /// Words, bit 3p + q.
    pub words: u16,
    /// Why: `access`, `queue` or `held-back`, as in the timing record.
    pub cause: &'static str,
    /// Whether the hold register is still wrong for them at the sample.
    pub in_force: bool,
}

/// Digital state of the terrain generator at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Corner in each hold register, by [`Colour`]; none if the data bank did not deliver it.
    pub held: [Option<u32>; 4],
    /// Polarity flip-flops.
    pub polarity: [f64; 2],
}

/// The state when sample `sample` is taken.
pub fn state_at(program: &SweepProgram, sample: usize) -> State {
    let mut sets = program.registers;
    let mut polarity = program.start.ramps.map(|ramp| ramp.polarity);
    for step in program.steps.iter().take_while(|step| step.sample <= sample) {
        match step.kind {
            StepKind::Fold(fold) | StepKind::BareFold(fold) => {
                let axis = usize::from(fold.axis == RampAxis::Y);
                polarity[axis] = -polarity[axis];
                if matches!(step.kind, StepKind::BareFold(_)) {
                    continue;
                }
                for colour in Colour::ALL.into_iter().filter(|&colour| fold.axis.takes(fold.stop, colour)) {
                    let set = &mut sets[colour as usize];
                    set.hold = if fold.axis == RampAxis::X { set.x_first } else { set.y_first };
                }
            }
            StepKind::Load(Load { colour, target, corner, words }) if words.has(0) => {
                let set = &mut sets[colour as usize];
                match target {
                    Target::Hold => set.hold = corner,
                    Target::Preload(PreloadRegister::XFirst) => set.x_first = corner,
                    Target::Preload(PreloadRegister::YFirst) => set.y_first = corner,
                }
            }
            StepKind::Load(_) => {}
        }
    }
    State { held: sets.map(|set| (set.hold != NO_CORNER).then_some(set.hold)), polarity }
}

/// The misses of a program up to `sample`.
pub fn late(program: &SweepProgram, sample: usize) -> Vec<Late> {
    let missed = program.misses.iter().filter(|miss| miss.time.0 <= sample as f64);
    missed.map(|miss| told(miss, in_force(program, miss, sample))).collect()
}

fn told(miss: &Miss, in_force: bool) -> Late {
    Late {
        crossing: miss.crossing,
        colour: miss.colour.name(),
        register: match miss.register {
            PreloadRegister::XFirst => "x-first",
            PreloadRegister::YFirst => "y-first",
        },
        due: miss.time.0,
        came: miss.arrival.map(|time| time.0),
        words: miss.words.0,
        cause: match miss.cause {
            MissCause::Access => "access",
            MissCause::Queue => "queue",
            MissCause::HeldBack => "held-back",
        },
        in_force,
    }
}

/// Whether nothing has put the hold register right since: neither the words themselves nor another transfer.
fn in_force(program: &SweepProgram, miss: &Miss, sample: usize) -> bool {
    let mut waiting = miss.words;
    let since = program.steps.iter().skip_while(|step| step.time.0 <= miss.time.0);
    for step in since.take_while(|step| step.sample <= sample) {
        match step.kind {
            StepKind::Fold(fold) if fold.axis.takes(fold.stop, miss.colour) => return false,
            StepKind::Load(Load { colour, target: Target::Hold, words, .. }) if colour == miss.colour => {
                waiting = waiting.without(words);
            }
            _ => {}
        }
    }
    waiting != WordMask(0)
}
