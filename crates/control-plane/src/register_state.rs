//! Registers of the terrain generator at an instant: which words stand where, and which of them should not.

use dpu::Pointers;
use landscape::Level;
use quantities::SweepTime;
use sweep_program::{
    Colour, Event, Fold, Load, NO_CORNER, PreloadRegister, RampAxis, SweepProgram, Target, WordMask,
};

use crate::frame_sweeps::FrameSweeps;

/// One register of nine words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RegisterWords {
    /// Corner that each word is of, 3p + q, as index into the level; [`NO_CORNER`] for words of 0.
    pub corners: [u32; 9],
    /// Corner that the region asks for.
    pub wanted: u32,
}

impl RegisterWords {
    /// The corner of the first word; none if it is 0.
    pub fn corner(&self) -> Option<u32> {
        Some(self.corners[0]).filter(|&corner| corner != NO_CORNER)
    }

    /// Words that are of another corner than the region asks for.
    pub fn stale(&self) -> WordMask {
        let stale = (0..9).filter(|&word| self.corners[word] != self.wanted);
        stale.fold(WordMask(0), |mask, word| mask.or(WordMask::only(word)))
    }
}

/// The digital state of one terrain generator.
#[derive(Debug, Clone, PartialEq)]
pub struct RegisterState {
    /// By [`Colour`]: hold, x-first, y-first.
    pub colours: [[RegisterWords; 3]; 4],
    /// Polarity flip-flops s_x, s_y: +1 or -1.
    pub polarity: [f64; 2],
    /// Folds of each ramp so far.
    pub folds: [u32; 2],
    /// Folded ramps X, Y (regions).
    pub ramps: [f64; 2],
    /// Ground range (m).
    pub range: f64,
}

impl FrameSweeps<'_> {
    /// Registers of sweep `sweep` at `time`, fine level first; at the instant of an event it has happened.
    pub fn registers(&self, sweep: u32, time: SweepTime) -> Vec<RegisterState> {
        let levels = self.crossings().stage.landscape.bank().levels();
        let range = self.table().range_at(time);
        let programs = self.programs(sweep).into_iter().zip(levels);
        programs.map(|(program, level)| RegisterState::at(&program, level, time, range)).collect()
    }
}

impl RegisterState {
    fn at(program: &SweepProgram, level: &Level, time: SweepTime, range: f64) -> Self {
        let full = |corner| RegisterWords { corners: [corner; 9], wanted: corner };
        let mut state = Self {
            colours: program.registers.map(|set| [set.hold, set.x_first, set.y_first].map(full)),
            polarity: program.start.ramps.map(|ramp| ramp.polarity),
            folds: [0; 2],
            ramps: [0.0; 2],
            range,
        };
        let mut pointers = Pointers::at_start(&program.start);
        for step in program.events().take_while(|step| step.time <= time) {
            match step.kind {
                Event::Fold(fold) => {
                    state.transfer(fold);
                    state.turn(fold);
                    pointers.follow(fold);
                }
                Event::BareFold(fold) => {
                    state.turn(fold);
                    pointers.follow(fold);
                }
                Event::Load(load) => state.load(&load),
            }
        }
        state.want(&pointers, level);
        let lambda = range / level.region_size();
        let ramp = |axis: usize| program.start.ramps[axis].at(state.folds[axis], lambda).0;
        state.ramps = [ramp(0), ramp(1)];
        state
    }

    fn transfer(&mut self, fold: Fold) {
        for colour in fold.colours() {
            let [hold, x_first, y_first] = &mut self.colours[colour as usize];
            hold.corners = if fold.axis == RampAxis::X { x_first.corners } else { y_first.corners };
        }
    }

    fn turn(&mut self, fold: Fold) {
        let axis = usize::from(fold.axis == RampAxis::Y);
        self.polarity[axis] = -self.polarity[axis];
        self.folds[axis] += 1;
    }

    fn load(&mut self, load: &Load) {
        let register = match load.target {
            Target::Hold => 0,
            Target::Preload(register) => 1 + register as usize,
        };
        let words = &mut self.colours[load.colour as usize][register].corners;
        for (_, corner) in words.iter_mut().enumerate().filter(|(word, _)| load.words.has(*word)) {
            *corner = load.corner;
        }
    }

    /// What the region asks of every register, wherever its words are.
    fn want(&mut self, pointers: &Pointers, level: &Level) {
        let index = |[m, n]: [i64; 2]| level.clamped_index(m, n) as u32;
        for colour in Colour::ALL {
            let wanted = [
                pointers.corner(colour),
                pointers.ahead(colour, PreloadRegister::XFirst),
                pointers.ahead(colour, PreloadRegister::YFirst),
            ];
            for (register, wanted) in self.colours[colour as usize].iter_mut().zip(wanted) {
                register.wanted = index(wanted);
            }
        }
    }
}
