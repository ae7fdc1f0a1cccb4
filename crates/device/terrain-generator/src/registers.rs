//! Hold, XFIRST and YFIRST registers of the four colours, and the polarity flip-flops (fig. 19, 22).

use landscape::CornerWords;
use sweep_program::{
    Event, Fold, Load, NO_CORNER, PreloadRegister, RampAxis, RegisterSet, Served, Step, StepKind,
    SweepProgram, Target, WordMask,
};

/// The digital state of the terrain generator within one sweep.
///
/// A register that took all its words from one corner is kept as that corner: nine words move as one number, and are looked
/// up when the array asks for them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Registers {
    /// Corner in each register, by [`HOLD`], [`X_FIRST`], [`Y_FIRST`] and colour; [`MIXED`] where `mixed` has its words.
    corners: [[u32; 4]; 3],
    /// Words of the registers that took those of more than one corner: late and stale ones side by side.
    mixed: [[CornerWords; 4]; 3],
    polarity: [f64; 2],
    folds: [u32; 2],
}

const HOLD: usize = 0;
const X_FIRST: usize = 1;
const Y_FIRST: usize = 2;

/// No corner either: see [`NO_CORNER`].
const MIXED: u32 = NO_CORNER - 1;

/// Words of a corner that was not delivered.
const NO_WORDS: &CornerWords = &[0.0; 9];

/// Words of a corner in the storage buffer.
#[inline(always)]
pub(crate) fn words_of(corner: u32, buffer: &[CornerWords]) -> &CornerWords {
    buffer.get(corner as usize).unwrap_or(NO_WORDS)
}

impl Registers {
    /// Registers at the start of a sweep.
    pub fn at_start(program: &SweepProgram) -> Self {
        let filled = |index: fn(&RegisterSet) -> u32| program.registers.map(|set| index(&set));
        Self {
            corners: [filled(|set| set.hold), filled(|set| set.x_first), filled(|set| set.y_first)],
            mixed: [[*NO_WORDS; 4]; 3],
            polarity: program.start.ramps.map(|ramp| ramp.polarity),
            folds: [0; 2],
        }
    }

    /// Words that feed the multiplying D/As, by colour; `buffer` is the storage buffer that the program's indices mean.
    #[inline]
    pub fn hold<'w>(&'w self, buffer: &'w [CornerWords]) -> [&'w CornerWords; 4] {
        std::array::from_fn(|colour| self.words(HOLD, colour, buffer))
    }

    /// Corners whose words feed the multiplying D/As, by colour; `None` if a register has words of several.
    pub(crate) fn corners_held(&self) -> Option<[u32; 4]> {
        let corners = self.corners[HOLD];
        (!corners.contains(&MIXED)).then_some(corners)
    }

    fn words<'w>(&'w self, register: usize, colour: usize, buffer: &'w [CornerWords]) -> &'w CornerWords {
        match self.corners[register][colour] {
            MIXED => &self.mixed[register][colour],
            corner => words_of(corner, buffer),
        }
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
    #[inline]
    pub fn fold(&mut self, fold: Fold) {
        let preload = if fold.axis == RampAxis::X { X_FIRST } else { Y_FIRST };
        for colour in fold.colours() {
            let colour = colour as usize;
            self.corners[HOLD][colour] = self.corners[preload][colour];
            if self.corners[HOLD][colour] == MIXED {
                self.mixed[HOLD][colour] = self.mixed[preload][colour];
            }
        }
        self.turn(fold);
    }

    /// A stop was met and nothing is transferred.
    #[inline]
    pub fn turn(&mut self, fold: Fold) {
        let axis = usize::from(fold.axis == RampAxis::Y);
        self.polarity[axis] = -self.polarity[axis];
        self.folds[axis] += 1;
    }

    /// What happens at one instant of a sweep.
    #[inline]
    pub fn apply(&mut self, step: &Step, buffer: &[CornerWords]) {
        match &step.kind {
            StepKind::Event(Event::Fold(fold)) => self.fold(*fold),
            StepKind::Event(Event::BareFold(fold)) => self.turn(*fold),
            StepKind::Event(Event::Load(load)) => self.load(load, buffer),
            StepKind::Served(served) => self.serve(served),
        }
    }

    /// A stop was met, and all that it asks for is there.
    #[inline]
    fn serve(&mut self, served: &Served) {
        self.fold(served.fold);
        let [first, second] = served.fold.colours();
        // Not mapped: that is called, not inlined, and there are hundreds of folds a sweep.
        let [first, second] = [first as usize, second as usize];
        [self.corners[X_FIRST][first], self.corners[Y_FIRST][first]] = [served.corners[0], served.corners[1]];
        [self.corners[X_FIRST][second], self.corners[Y_FIRST][second]] =
            [served.corners[2], served.corners[3]];
    }

    /// Takes words that arrive at a register; `buffer` holds them by corner.
    #[inline]
    pub fn load(&mut self, load: &Load, buffer: &[CornerWords]) {
        let register = match load.target {
            Target::Hold => HOLD,
            Target::Preload(PreloadRegister::XFirst) => X_FIRST,
            Target::Preload(PreloadRegister::YFirst) => Y_FIRST,
        };
        let colour = load.colour as usize;
        if load.words == WordMask::ALL {
            self.corners[register][colour] = load.corner;
            return;
        }
        let mut words = *self.words(register, colour, buffer);
        let arrived = words_of(load.corner, buffer);
        for word in (0..words.len()).filter(|&word| load.words.has(word)) {
            words[word] = arrived[word];
        }
        (self.corners[register][colour], self.mixed[register][colour]) = (MIXED, words);
    }
}

#[cfg(test)]
mod tests {
    use landscape::CornerWords;
    use quantities::SweepTime;
    use sweep_program::{
        Colour, Event, Fold, Load, NO_CORNER, PreloadRegister, RampAxis, Served, Step, StepKind, Stop,
        Target, WordMask,
    };

    use super::Registers;

    /// Corner k of the buffer has k as all its words; hold registers have corners 0 to 3, XFIRST 4 to 7, YFIRST 8 to 11.
    fn filled() -> (Registers, Vec<CornerWords>) {
        let corners = [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]];
        let registers = Registers { corners, polarity: [1.0; 2], ..Registers::default() };
        (registers, (0..13).map(|corner| [f64::from(corner); 9]).collect())
    }

    /// Event table of 6.3: yellow and black lie at the near x, yellow and green at the near y.
    #[test]
    fn a_fold_gives_each_colour_what_waits_for_it() {
        for (axis, stop, held) in [
            (RampAxis::X, Stop::One, [4.0, 1.0, 6.0, 3.0]),
            (RampAxis::X, Stop::Zero, [0.0, 5.0, 2.0, 7.0]),
            (RampAxis::Y, Stop::One, [8.0, 9.0, 2.0, 3.0]),
            (RampAxis::Y, Stop::Zero, [0.0, 1.0, 10.0, 11.0]),
        ] {
            let (mut registers, buffer) = filled();
            registers.fold(Fold { axis, stop });
            assert_eq!(registers.hold(&buffer).map(|words| words[0]), held, "{axis:?} at {stop:?}");
            let turned = usize::from(axis == RampAxis::Y);
            assert_eq!([registers.polarity[turned], registers.polarity[1 - turned]], [-1.0, 1.0]);
        }
    }

    /// Without transfer pulses a ramp turns, and every colour keeps its words.
    #[test]
    fn a_bare_fold_turns_the_ramp_alone() {
        let (mut registers, buffer) = filled();
        let step = |kind| Step { time: SweepTime(0.0), range: 1.0, sample: 1, kind };
        registers.apply(
            &step(StepKind::Event(Event::BareFold(Fold { axis: RampAxis::Y, stop: Stop::One }))),
            &buffer,
        );
        assert_eq!(registers.hold(&buffer).map(|words| words[0]), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(registers.polarity, [1.0, -1.0]);
        let target = Target::Preload(PreloadRegister::YFirst);
        let load = Load { colour: Colour::Yellow, target, corner: 12, words: WordMask::ALL };
        registers.apply(&step(StepKind::Event(Event::Load(load))), &buffer);
        assert_eq!(registers.hold(&buffer)[Colour::Yellow as usize][0], 0.0);
        registers
            .apply(&step(StepKind::Event(Event::Fold(Fold { axis: RampAxis::Y, stop: Stop::One }))), &buffer);
        assert_eq!(registers.hold(&buffer)[Colour::Yellow as usize], &[12.0; 9]);
        assert_eq!(registers.polarity, [1.0, 1.0]);
    }

    /// A fold that finds all its words: each of its two colours gets its own two corners, and the others keep theirs.
    #[test]
    fn what_a_fold_finds_goes_to_the_colours_that_asked() {
        let folds = [(RampAxis::X, Stop::One), (RampAxis::X, Stop::Zero), (RampAxis::Y, Stop::One)];
        for (axis, stop) in folds {
            let (mut registers, _) = filled();
            let buffer: Vec<CornerWords> = (0..30).map(|corner| [f64::from(corner); 9]).collect();
            let fold = Fold { axis, stop };
            let served = Served { fold, corners: [20, 21, 22, 23] };
            let kind = StepKind::Served(served);
            registers.apply(&Step { time: SweepTime(0.0), range: 1.0, sample: 1, kind }, &buffer);
            // What waits for an X stop, and for a Y stop: seen as the next fold of every colour transfers it.
            let transferred = |axis: RampAxis| {
                let mut next = registers.clone();
                [Stop::Zero, Stop::One].into_iter().for_each(|stop| next.fold(Fold { axis, stop }));
                next.hold(&buffer).map(|words| words[0])
            };
            let (mut x, mut y) = ([4.0, 5.0, 6.0, 7.0], [8.0, 9.0, 10.0, 11.0]);
            let [first, second] = fold.colours().map(|colour| colour as usize);
            [x[first], y[first], x[second], y[second]] = [20.0, 21.0, 22.0, 23.0];
            assert_eq!(transferred(RampAxis::X), x, "{fold:?}");
            assert_eq!(transferred(RampAxis::Y), y, "{fold:?}");
        }
    }

    #[test]
    fn a_word_that_comes_alone_goes_through_the_fold_with_the_others() {
        let (mut registers, buffer) = filled();
        let target = Target::Preload(PreloadRegister::XFirst);
        registers.load(&Load { colour: Colour::Red, target, corner: 12, words: WordMask::only(4) }, &buffer);
        registers.fold(Fold { axis: RampAxis::X, stop: Stop::Zero });
        let expected = [7.0, 7.0, 7.0, 7.0, 12.0, 7.0, 7.0, 7.0, 7.0];
        assert_eq!(registers.hold(&buffer)[Colour::Red as usize], &expected);
        assert_eq!(registers.hold(&buffer)[Colour::Green as usize], &[5.0; 9]);
        assert_eq!(registers.corners_held(), None);
        // A corner that was not delivered leaves nothing of them.
        let nothing =
            Load { colour: Colour::Red, target: Target::Hold, corner: NO_CORNER, words: WordMask::ALL };
        registers.load(&nothing, &buffer);
        assert_eq!(registers.hold(&buffer)[Colour::Red as usize], &[0.0; 9]);
        assert_eq!(registers.corners_held(), Some([0, 5, 2, NO_CORNER]));
    }
}
