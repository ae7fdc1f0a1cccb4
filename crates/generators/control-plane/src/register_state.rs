//! Registers of the terrain generator at an instant: which words stand where, and which of them should not.

use dpu::Pointers;
use landscape::Level;
use quantities::SweepTime;
use sweep_program::{
    Colour, Event, NO_CORNER, PreloadRegister, RampAxis, RegisterCorners, SweepProgram, WordMask,
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
    /// Ground range at that instant (m).
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
        let mut corners = RegisterCorners::at_start(&program.registers);
        let (mut pointers, mut folds) = (Pointers::at_start(&program.start), [0; 2]);
        for step in program.events().take_while(|step| step.time <= time) {
            corners.follow(&step.kind);
            if let Event::Fold(fold) | Event::BareFold(fold) = step.kind {
                folds[usize::from(fold.axis == RampAxis::Y)] += 1;
                pointers.follow(fold);
            }
        }
        let lambda = range / level.region_size();
        let ramp = |axis: usize| program.start.ramps[axis].at(folds[axis], lambda).0;
        let polarity = |axis: usize| {
            let start = program.start.ramps[axis].polarity;
            if folds[axis] % 2 == 0 { start } else { -start }
        };
        Self {
            colours: Colour::ALL.map(|colour| registers_of(colour, &corners, &pointers, level)),
            polarity: [polarity(0), polarity(1)],
            folds,
            ramps: [ramp(0), ramp(1)],
            range,
        }
    }
}

/// Registers of a colour, with what the region asks of each, wherever its words are.
fn registers_of(
    colour: Colour,
    corners: &RegisterCorners,
    pointers: &Pointers,
    level: &Level,
) -> [RegisterWords; 3] {
    let wanted = [
        pointers.corner(colour),
        pointers.ahead(colour, PreloadRegister::XFirst),
        pointers.ahead(colour, PreloadRegister::YFirst),
    ];
    std::array::from_fn(|register| {
        let [m, n] = wanted[register];
        RegisterWords { corners: corners.of(colour)[register], wanted: level.clamped_index(m, n) as u32 }
    })
}
