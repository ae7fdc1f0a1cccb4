//! Hold, XFIRST and YFIRST registers of the four colours, and the polarity flip-flops (fig. 19, 22).

use landscape::CornerWords;
use sweep_program::{
    Fold, Load, PreloadRegister, RampAxis, RegisterSet, Step, StepKind, SweepProgram, Target,
};

/// The digital state of the terrain generator within one sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Registers {
    hold: [CornerWords; 4],
    x_first: [CornerWords; 4],
    y_first: [CornerWords; 4],
    polarity: [f64; 2],
    folds: [u32; 2],
}

impl Registers {
    /// Registers at the start of a sweep; `buffer` is the storage buffer that the program's indices mean.
    pub fn at_start(program: &SweepProgram, buffer: &[CornerWords]) -> Self {
        let filled = |index: fn(&RegisterSet) -> u32| {
            std::array::from_fn(|colour| stored(buffer, index(&program.registers[colour])))
        };
        Self {
            hold: filled(|set| set.hold),
            x_first: filled(|set| set.x_first),
            y_first: filled(|set| set.y_first),
            polarity: program.start.ramps.map(|ramp| ramp.polarity),
            folds: [0; 2],
        }
    }

    /// Words that feed the multiplying D/As, by colour.
    pub fn hold(&self) -> &[CornerWords; 4] {
        &self.hold
    }

    /// Polarity flip-flops s_x, s_y: +1 or -1.
    pub fn polarity(&self) -> [f64; 2] {
        self.polarity
    }

    /// Folds of each ramp so far.
    pub fn folds(&self) -> [u32; 2] {
        self.folds
    }

    /// A stop was met: two colours take their preload register, the polarity of the axis flips.
    pub fn fold(&mut self, fold: Fold) {
        let preload = if fold.axis == RampAxis::X { &self.x_first } else { &self.y_first };
        for colour in sweep_program::Colour::ALL {
            if fold.axis.takes(fold.stop, colour) {
                self.hold[colour as usize] = preload[colour as usize];
            }
        }
        self.turn(fold);
    }

    /// A stop was met and nothing is transferred.
    pub fn turn(&mut self, fold: Fold) {
        let axis = usize::from(fold.axis == RampAxis::Y);
        self.polarity[axis] = -self.polarity[axis];
        self.folds[axis] += 1;
    }

    /// What happens at one instant of a sweep.
    pub fn apply(&mut self, step: &Step, buffer: &[CornerWords]) {
        match &step.kind {
            StepKind::Fold(fold) => self.fold(*fold),
            StepKind::BareFold(fold) => self.turn(*fold),
            StepKind::Load(load) => self.load(load, buffer),
        }
    }

    /// Words arrive.
    pub fn load(&mut self, load: &Load, buffer: &[CornerWords]) {
        let register = match load.target {
            Target::Hold => &mut self.hold,
            Target::Preload(PreloadRegister::XFirst) => &mut self.x_first,
            Target::Preload(PreloadRegister::YFirst) => &mut self.y_first,
        };
        let (set, words) = (&mut register[load.colour as usize], stored(buffer, load.corner));
        for word in 0..words.len() {
            if load.words.has(word) {
                set[word] = words[word];
            }
        }
    }
}

/// Words of a corner, 0 for one that was not delivered.
fn stored(buffer: &[CornerWords], corner: u32) -> CornerWords {
    buffer.get(corner as usize).copied().unwrap_or_default()
}
