//! Service of the crossings: from folds to a sweep program.

use quantities::SweepTime;
use sweep_program::{SweepProgram, SweepStart};

use crate::at_once::serve_at_once;
use crate::home::Pointers;
use crate::service::Service;
use crate::unit::{CrossingService, TimedFold};
use crate::watch::Watch;

impl CrossingService<'_> {
    /// Writes the program of the sweep at `place` (frame, sweep) into `program`, whose buffers are reused. `folds`
    /// ends where the profile ends, at `end_range` (m); `range_at` gives the range of an instant. `watch` is told
    /// what happens, `&mut ()` if nobody wants to know.
    pub fn write_program<W: Watch>(
        &self,
        place: (u64, u32),
        start: SweepStart,
        folds: impl Iterator<Item = TimedFold>,
        end_range: f64,
        range_at: impl Fn(SweepTime) -> f64,
        program: &mut SweepProgram,
        watch: &mut W,
    ) {
        program.start = start;
        let pointers = Pointers::at_start(&start);
        program.registers = pointers.home_registers(self.level);
        program.end_range = end_range;
        program.steps.clear();
        program.misses.clear();
        if self.has_all_at_once() && !W::LISTENS {
            return serve_at_once(self.level, pointers, folds, &mut program.steps);
        }
        let mut service = Service::new(self, place, &start, pointers, watch);
        service.look_up_home(program);
        for fold in folds {
            service.reach(fold, &range_at, program);
            service.serve(fold, program);
        }
        service.finish(&range_at, program);
        while program.steps.last().is_some_and(|step| step.range > end_range) {
            program.steps.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::unit::{CrossingService, MissingCorner, TimedFold};
    use crate::watch::{ServiceEvent, Watch};
    use hardware_model::{Cpu, HardwareModel, LoadDelay, Loader};
    use landscape::Level;
    use proptest::prelude::{any, prop_assert_eq, proptest};
    use quantities::{Rate, SweepTime, Tick, Timebase};
    use sweep_program::{
        Colour, Event, Fold, Load, NO_CORNER, PreloadRegister, Ramp, RampAxis, RegisterSet, Step, StepKind,
        Stop, SweepProgram, SweepStart, Target, WordMask,
    };

    /// Listens, so that nothing is left out.
    struct Listener;

    impl Watch for Listener {
        fn tell(&mut self, _: Tick, _: ServiceEvent) {}
    }

    /// Numbers of the frame and of the sweep.
    const PLACE: (u64, u32) = (3, 7);

    fn timebase() -> Timebase {
        let rate = |hertz| Rate::new(hertz, 1).expect("not 0");
        Timebase::new(rate(20_000_000), rate(30), 525, 100, 10).expect("it fits")
    }

    /// A fold in a sweep that passes a metre a sample.
    fn timed(time: SweepTime, fold: Fold) -> TimedFold {
        Step { time, range: time.0, sample: time.sample_at_or_after(), kind: fold }
    }

    fn program(
        level: &Level,
        start: &SweepStart,
        folds: &[TimedFold],
        (loader, missing): (&Loader, &[MissingCorner]),
        watch: &mut impl Watch,
    ) -> SweepProgram {
        let (cpu, timebase) = (&Cpu::default(), &timebase());
        let service = CrossingService { level, loader, cpu, timebase, missing, held: 0, seed: 1 };
        let registers = [RegisterSet::default(); 4];
        let mut program =
            SweepProgram { start: *start, registers, steps: Vec::new(), end_range: 0.0, misses: Vec::new() };
        let range_at = |time: SweepTime| time.0;
        service.write_program(PLACE, *start, folds.iter().copied(), 90.0, range_at, &mut program, watch);
        program
    }

    fn level() -> Level {
        Level::new(1.0, [0.0; 2], [11, 9], vec![[0.0; 9]; 99]).unwrap()
    }

    /// What is loaded after a first fold at X = 1, on a sweep to the north-east out of region (0, 0).
    fn loads(delays: Vec<LoadDelay>, missing: &[MissingCorner]) -> Vec<Load> {
        let ramps = [Ramp { start: 0.25, rate: 0.7, polarity: 1.0 }; 2];
        let start = SweepStart { direction: [0.7; 2], region: [0, 0], ramps };
        let fold = Fold { axis: RampAxis::X, stop: Stop::One };
        let folds = [timed(SweepTime(1.0), fold)];
        let loader = Loader { delays, ..HardwareModel::ideal().loader };
        let program = program(&level(), &start, &folds, (&loader, missing), &mut ());
        let load = |kind: &Event| if let Event::Load(load) = kind { Some(*load) } else { None };
        program.events().filter_map(|step| load(&step.kind)).collect()
    }

    fn load(colour: Colour, register: PreloadRegister, corner: u32) -> Load {
        Load { colour, target: Target::Preload(register), corner, words: WordMask::ALL }
    }

    /// Yellow has moved from corner (0, 0) to (2, 0), black from (0, 1) to (2, 1): what lies two further on either axis
    /// waits for the next fold (6.3). Nine corners make a row.
    #[test]
    fn a_fold_asks_for_the_next_corners_of_its_colours() {
        let (x_first, y_first) = (PreloadRegister::XFirst, PreloadRegister::YFirst);
        let expected = [
            load(Colour::Yellow, x_first, 4 * 9),
            load(Colour::Yellow, y_first, 2 * 9 + 2),
            load(Colour::Black, x_first, 4 * 9 + 1),
            load(Colour::Black, y_first, 2 * 9 + 3),
        ];
        assert_eq!(loads(vec![], &[]), expected);
    }

    #[test]
    fn a_corner_counts_from_the_tick_at_which_the_drum_has_brought_it() {
        for (arrival, found) in [(Some(Tick(0)), 36), (Some(Tick(u64::MAX)), NO_CORNER), (None, NO_CORNER)] {
            let loads = loads(vec![], &[MissingCorner { corner: 36, arrival }]);
            assert_eq!(loads[0], load(Colour::Yellow, PreloadRegister::XFirst, found), "{arrival:?}");
        }
    }

    #[test]
    fn a_word_held_back_comes_alone() {
        let (colour, register) = (Colour::Yellow, PreloadRegister::XFirst);
        let delay = LoadDelay { frame: None, sweep: 7, crossing: 0, colour, register, word: 4, ticks: 10 };
        let loads = loads(vec![delay], &[]);
        let whole = load(colour, register, 36);
        assert_eq!(loads[0], Load { words: WordMask::ALL.without(WordMask::only(4)), ..whole });
        assert_eq!(loads[4], Load { words: WordMask::only(4), ..whole });
        assert_eq!(loads.len(), 5);
    }

    /// Ticks at which folds were seen, and sets that were overwritten unused.
    #[derive(Default)]
    struct Tally {
        seen: Vec<Tick>,
        wasted: u32,
    }

    impl Watch for Tally {
        fn tell(&mut self, tick: Tick, event: ServiceEvent) {
            match event {
                ServiceEvent::Stop { .. } => self.seen.push(tick),
                ServiceEvent::Wasted { .. } => self.wasted += 1,
                _ => {}
            }
        }
    }

    /// The corner beyond both stops moves over with the fold: at the next fold of its colour it is there, even if that is
    /// within the same tick.
    #[test]
    fn what_moves_over_from_the_diagonal_register_is_there_within_the_tick() {
        let ramps = [Ramp { start: 0.25, rate: 0.7, polarity: 1.0 }; 2];
        let start = SweepStart { direction: [0.7; 2], region: [0, 0], ramps };
        let folds = [Stop::One, Stop::Zero, Stop::One].map(|stop| Fold { axis: RampAxis::X, stop });
        let times = [1.001, 1.002, 1.003];
        let folds = [0, 1, 2].map(|k| timed(SweepTime(times[k]), folds[k]));
        let loader = Loader { access: 5, diagonal_register: true, ..HardwareModel::ideal().loader };
        let mut tally = Tally::default();
        program(&level(), &start, &folds, (&loader, &[]), &mut tally);
        assert!(tally.seen[0] > Tick(0) && tally.seen.iter().all(|tick| *tick == tally.seen[0]));
        // Y-first of yellow and black, which moved over with the first fold.
        assert_eq!(tally.wasted, 2);
    }

    /// Lockstep found it: two sets of 1 + 5 ticks after the fold that asks, and a strobe of 2, yellow's diagonal word is there
    /// (Y-first comes from the one that the sweep begins with). A Y fold less than a tick before is seen in that very tick,
    /// and has to fetch its word all the same.
    #[test]
    fn a_diagonal_word_is_at_hand_at_the_instant_of_the_fold_not_at_the_tick_that_sees_it() {
        let loader = Loader {
            diagonal_register: true,
            pointer: 1,
            access: 5,
            strobe: 2,
            ..HardwareModel::ideal().loader
        };
        let ramps = [Ramp { start: 0.25, rate: 0.7, polarity: 1.0 }; 2];
        let start = SweepStart { direction: [0.7; 2], region: [0, 0], ramps };
        let clock = timebase().sweep_clock(PLACE.0, PLACE.1);
        let first = clock.tick_at_or_after(SweepTime(1.0));
        let is_at_hand = |ticks: f64| {
            let origin = clock.instant_of(first).0;
            let time = |ticks: f64| SweepTime(origin + ticks / timebase().ticks_per_sample());
            let fold = |axis, ticks| timed(time(ticks), Fold { axis, stop: Stop::One });
            let folds = [fold(RampAxis::X, -0.3), fold(RampAxis::Y, ticks)];
            let steps = program(&level(), &start, &folds, (&loader, &[]), &mut ()).steps;
            // Yellow goes from corner (2, 0) to (2, 2): two further north lies (4, 2).
            let wanted =
                StepKind::Event(Event::Load(load(Colour::Yellow, PreloadRegister::XFirst, 4 * 9 + 2)));
            let came = steps.iter().find(|step| step.kind == wanted).expect("it is fetched or moved over");
            came.time == folds[1].time
        };
        let there = f64::from(2 * (1 + 5) + 2);
        let found = [there - 1.3, there - 0.3, there + 0.3].map(is_at_hand);
        assert_eq!(found, [false, false, true]);
    }

    proptest! {
        /// The short way of a service without delays writes what the long one does.
        #[test]
        fn at_once_is_in_time(
            axes in proptest::collection::vec(any::<bool>(), 0..60),
            signs in any::<[bool; 2]>(),
            region in proptest::array::uniform2(-1..12i64),
        ) {
            let ramps = [0, 1].map(|axis| Ramp {
                start: 0.25,
                rate: if signs[axis] { 0.7 } else { -0.7 },
                polarity: if region[axis] % 2 == 0 { 1.0 } else { -1.0 },
            });
            let direction = [0, 1].map(|axis: usize| ramps[axis].rate * ramps[axis].polarity);
            let start = SweepStart { direction, region, ramps };
            let mut next = ramps.map(|ramp| ramp.first_stop().1);
            let folds: Vec<TimedFold> = axes.iter().enumerate().map(|(k, &is_y)| {
                let axis = usize::from(is_y);
                let stop = next[axis];
                next[axis] = if stop == Stop::One { Stop::Zero } else { Stop::One };
                let at = 1.3 * k as f64;
                let fold = Fold { axis: if is_y { RampAxis::Y } else { RampAxis::X }, stop };
                timed(SweepTime(at), fold)
            }).collect();
            let (level, loader) = (level(), HardwareModel::ideal().loader);
            let mut short = program(&level, &start, &folds, (&loader, &[]), &mut ());
            short.steps = short.events().map(Step::from).collect();
            prop_assert_eq!(short, program(&level, &start, &folds, (&loader, &[]), &mut Listener));
        }
    }
}
