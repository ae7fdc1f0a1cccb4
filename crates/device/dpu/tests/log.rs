//! What the service tells, event by event: one sweep on which every kind of event happens.

use std::collections::BTreeMap;

use dpu::{
    AskedSet, CornerArrival, CrossingService, LineUse, MissingCorner, Register, ServiceEvent, TimedFold,
    Watch,
};
use hardware_model::{Cpu, HardwareModel, LatePolicy, Loader};
use landscape::Level;
use proptest::prelude::{Just, any, prop_assert_eq, prop_oneof, proptest};
use quantities::{Rate, SweepTime, Tick, Timebase};
use sweep_program::{
    Colour, Event, Fold, MissCause, NO_CORNER, PreloadRegister, Ramp, RampAxis, Stop, SweepProgram,
    SweepStart, Target, WordMask,
};

/// All that was told.
#[derive(Default)]
struct Log {
    events: Vec<(u64, ServiceEvent)>,
    lines: Option<[LineUse; 4]>,
}

impl Watch for Log {
    fn tell(&mut self, tick: Tick, event: ServiceEvent) {
        self.events.push((tick.0, event));
    }

    fn end(&mut self, lines: &[LineUse; 4]) {
        self.lines = Some(*lines);
    }
}

const X_FIRST: PreloadRegister = PreloadRegister::XFirst;
const Y_FIRST: PreloadRegister = PreloadRegister::YFirst;

fn timebase() -> Timebase {
    let rate = |hertz| Rate::new(hertz, 1).expect("not 0");
    // Ten ticks a step.
    Timebase::new(rate(100_000), rate(10), 10, 90, 10).expect("it fits")
}

/// Eleven corners to the north, nine to the east.
fn level() -> Level {
    Level::new(1.0, [0.0; 2], [11, 9], vec![[0.0; 9]; 99]).expect("a level")
}

/// An access of all nine words in 20 ticks, and a strobe of 3; first asked, first served.
fn loader() -> Loader {
    Loader {
        words_per_access: 9,
        access: 20,
        strobe: 3,
        urgent_first: false,
        late_policy: LatePolicy::StrobeThrough,
        ..HardwareModel::ideal().loader
    }
}

/// Folds of a sweep to the north-east out of region (0, 0), at instants in samples; frame 0, sweep 1 begins at tick 1000.
fn log(loader: &Loader, missing: &[MissingCorner], folds: &[(f64, RampAxis, Stop)]) -> Log {
    written(loader, missing, folds).1
}

/// The same with the program that the service has written meanwhile.
fn written(
    loader: &Loader,
    missing: &[MissingCorner],
    folds: &[(f64, RampAxis, Stop)],
) -> (SweepProgram, Log) {
    let ramps = [Ramp { start: 0.25, rate: 0.7, polarity: 1.0 }; 2];
    let start = SweepStart { direction: [0.7; 2], region: [0, 0], ramps };
    let folds = folds.iter().map(|&(at, axis, stop)| {
        let time = SweepTime(at);
        TimedFold { time, range: at, sample: time.sample_at_or_after(), kind: Fold { axis, stop } }
    });
    let (level, cpu, timebase) = (level(), Cpu::default(), timebase());
    let service =
        CrossingService { level: &level, loader, cpu: &cpu, timebase: &timebase, missing, held: 0, seed: 1 };
    let (mut program, mut log) = (SweepProgram::idle(), Log::default());
    let range_at = |time: SweepTime| time.0;
    service.write_program((0, 1), start, folds, 90.0, range_at, &mut program, &mut log);
    (program, log)
}

impl Log {
    fn ticks(&self, is_it: impl Fn(&ServiceEvent) -> bool) -> Vec<u64> {
        self.events.iter().filter(|(_, event)| is_it(event)).map(|(tick, _)| *tick).collect()
    }

    fn count(&self, is_it: impl Fn(&ServiceEvent) -> bool) -> usize {
        self.ticks(is_it).len()
    }
}

fn set(crossing: u32, colour: Colour, register: PreloadRegister) -> AskedSet {
    AskedSet { crossing, colour, register: Register::Preload(register) }
}

/// Two folds of X far enough apart that all words come in time: yellow and black move twice.
fn in_time() -> Log {
    log(&loader(), &[], &[(10.0, RampAxis::X, Stop::One), (30.0, RampAxis::X, Stop::One)])
}

#[test]
fn home_registers_are_told_as_the_sweep_begins() {
    let log = in_time();
    assert_eq!(log.ticks(|event| matches!(event, ServiceEvent::Home(_))), [1000; 12]);
    let hold =
        |event: &ServiceEvent| matches!(event, ServiceEvent::Home(asked) if asked.register == Register::Hold);
    assert_eq!(log.count(hold), 4);
}

#[test]
fn stops_are_told_with_their_numbers() {
    let stops = in_time().events.into_iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Stop { crossing, fold } => Some((tick, crossing, fold.axis)),
        _ => None,
    });
    assert_eq!(stops.collect::<Vec<_>>(), [(1100, 0, RampAxis::X), (1300, 1, RampAxis::X)]);
}

/// Yellow takes corner (2, 0) first, which it begins with, then (4, 0): asked for at tick 1100, there at 1123.
#[test]
fn a_transfer_tells_its_corner_and_how_long_it_was_there() {
    let transfers = in_time().events.into_iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Transfer { crossing, colour: Colour::Yellow, register, corner, slack } => {
            Some((tick, crossing, register, corner, slack))
        }
        _ => None,
    });
    let expected = [(1100, 0, X_FIRST, 2 * 9, None), (1300, 1, X_FIRST, 4 * 9, Some(1300 - 1123))];
    assert_eq!(transfers.collect::<Vec<_>>(), expected);
}

/// Y-first of both colours is full and is overwritten by the second fold of X.
#[test]
fn a_full_set_that_is_overwritten_is_wasted() {
    let wasted = in_time().events.into_iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Wasted { colour, register, corner } => Some((tick, colour, register, corner)),
        _ => None,
    });
    let expected = [(1300, Colour::Yellow, Y_FIRST, 2 * 9 + 2), (1300, Colour::Black, Y_FIRST, 2 * 9 + 3)];
    assert_eq!(wasted.collect::<Vec<_>>(), expected);
}

/// A bank serves one set after another.
#[test]
fn sets_are_wanted_fetched_and_loaded() {
    let log = in_time();
    let wanted = |asked: AskedSet| log.ticks(|event| *event == ServiceEvent::Wanted(asked));
    assert_eq!(wanted(set(0, Colour::Yellow, X_FIRST)), [1100]);
    assert_eq!(wanted(set(0, Colour::Yellow, Y_FIRST)), [1100]);
    let access = |register| {
        log.ticks(|event| {
            let ServiceEvent::Access(asked) = event else { return false };
            asked.crossing == Some(0) && asked.colour == Colour::Black && asked.register == register
        })
    };
    assert_eq!(access(Register::Preload(X_FIRST)), [1100]);
    assert_eq!(access(Register::Preload(Y_FIRST)), [1120]);
    let load = |target| {
        log.ticks(|event| {
            let ServiceEvent::Load(load) = event else { return false };
            load.colour == Colour::Black && load.target == target && load.words == WordMask::ALL
        })
    };
    assert_eq!(load(Target::Preload(X_FIRST)), [1123, 1323]);
    assert_eq!(load(Target::Preload(Y_FIRST)), [1143, 1343]);
    assert!(log.lines.is_some_and(|lines| lines[0].busy == 80), "four accesses of yellow");
}

/// The next fold comes 15 ticks after the first: X-first of both colours is on its way, Y-first waits.
#[test]
fn a_set_that_its_colour_leaves_is_cancelled_and_one_on_its_way_is_late() {
    let log = log(&loader(), &[], &[(10.0, RampAxis::X, Stop::One), (11.5, RampAxis::X, Stop::One)]);
    let cancelled = |asked: AskedSet| log.ticks(|event| *event == ServiceEvent::Cancelled(asked));
    assert_eq!(cancelled(set(0, Colour::Yellow, Y_FIRST)), [1115]);
    assert_eq!(cancelled(set(0, Colour::Black, Y_FIRST)), [1115]);
    assert_eq!(log.count(|event| matches!(event, ServiceEvent::Cancelled(_))), 2);
    let late = log.events.iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Late { miss, range } => Some((*tick, miss.crossing, miss.colour, miss.cause, *range)),
        _ => None,
    });
    let at = |colour| (1115, 1, colour, MissCause::Access, 11.5);
    assert_eq!(late.collect::<Vec<_>>(), [at(Colour::Yellow), at(Colour::Black)]);
    let holds =
        |event: &ServiceEvent| matches!(event, ServiceEvent::Load(load) if load.target == Target::Hold);
    assert_eq!(log.ticks(holds), [1123; 2]);
    assert_eq!(log.events.last().map(|(tick, _)| *tick), Some(1115), "late words are told at the end");
}

/// Y-first waits behind X-first when the fold of Y finds it missing; it is fetched all the same.
#[test]
fn a_late_set_comes() {
    let log = log(&loader(), &[], &[(10.0, RampAxis::X, Stop::One), (11.5, RampAxis::Y, Stop::One)]);
    let late_sets = log.events.iter().filter_map(|(tick, event)| match event {
        ServiceEvent::LateSet { slack } => Some((*tick, *slack)),
        _ => None,
    });
    // Yellow moves with both folds; black's Y-first is nobody's.
    assert_eq!(late_sets.collect::<Vec<_>>(), [(1143, 1115 - 1143)]);
}

#[test]
fn a_corner_beyond_both_stops_moves_over() {
    let loader = Loader { diagonal_register: true, ..loader() };
    let log = log(&loader, &[], &[(10.0, RampAxis::X, Stop::One)]);
    let moved = log.events.iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Diagonal(asked) => Some((*tick, asked.colour, asked.register, asked.corner)),
        _ => None,
    });
    let y_first = Register::Preload(Y_FIRST);
    let expected = [(1100, Colour::Yellow, y_first, 2 * 9 + 2), (1100, Colour::Black, y_first, 2 * 9 + 3)];
    assert_eq!(moved.collect::<Vec<_>>(), expected);
    let diagonal = AskedSet { crossing: 0, colour: Colour::Yellow, register: Register::Diagonal };
    assert_eq!(log.ticks(|event| *event == ServiceEvent::Wanted(diagonal)), [1100]);
}

#[test]
fn a_corner_that_no_drum_has_brought_is_absent() {
    let missing = [MissingCorner { corner: 4 * 9, arrival: None }];
    let log = log(&loader(), &missing, &[(10.0, RampAxis::X, Stop::One), (30.0, RampAxis::X, Stop::One)]);
    let absent = log.events.iter().filter_map(|(tick, event)| match event {
        ServiceEvent::Absent(asked) => Some((*tick, asked.corner, asked.arrival)),
        _ => None,
    });
    assert_eq!(absent.collect::<Vec<_>>(), [(1100, 4 * 9, CornerArrival::NotInFrame)]);
    let empty = |event: &ServiceEvent| matches!(event, ServiceEvent::Transfer { colour: Colour::Yellow, corner, .. } if *corner == NO_CORNER);
    assert_eq!(log.ticks(empty), [1300], "its words are 0");
}

/// Stops, loads and late words with their ticks, as they were told; the ramps end at tick 1900, and what comes later is in no
/// program.
fn told(log: &Log) -> Vec<String> {
    let mut told: Vec<_> = log
        .events
        .iter()
        .filter_map(|(tick, event)| match event {
            ServiceEvent::Stop { fold, .. } => Some(format!("{tick} {fold:?}")),
            ServiceEvent::Load(load) => (*tick <= 1900).then(|| format!("{tick} {load:?}")),
            ServiceEvent::Late { miss, .. } => Some(format!("{tick} {miss:?}")),
            _ => None,
        })
        .collect();
    told.sort();
    told
}

/// The same as they stand in the program, which the analog side, registers at an instant and digital wires follow.
fn in_program(program: &SweepProgram) -> Vec<String> {
    // Ten ticks a step; an instant that was made from a tick is that tick.
    let seen = |time: SweepTime| 1000 + (10.0 * time.0 - 1e-9).ceil() as u64;
    let steps = program.events().map(|step| match step.kind {
        Event::Fold(fold) | Event::BareFold(fold) => format!("{} {fold:?}", seen(step.time)),
        Event::Load(load) => format!("{} {load:?}", seen(step.time)),
    });
    let misses = program.misses.iter().map(|miss| format!("{} {miss:?}", seen(miss.time)));
    let mut all: Vec<_> = steps.chain(misses).collect();
    all.sort();
    all
}

proptest! {
    /// Who follows the program and who hears the events follow one and the same service.
    #[test]
    fn the_program_has_what_is_told(
        gaps in proptest::collection::vec((0.05..12.0f64, any::<bool>()), 1..12),
        access in 0..40u64,
        diagonal_register in any::<bool>(),
        late_policy in prop_oneof![Just(LatePolicy::StrobeThrough), Just(LatePolicy::Latched)],
        stop_after_crossings in proptest::option::of(0..12u32),
        absent in any::<bool>(),
    ) {
        let strobe = access.min(3);
        let loader = Loader { access, strobe, diagonal_register, late_policy, stop_after_crossings, ..loader() };
        let (mut at, mut stops) = (0.0, [Stop::One; 2]);
        let folds: Vec<_> = gaps.iter().map(|&(gap, is_y)| {
            at += gap;
            let stop = stops[usize::from(is_y)];
            stops[usize::from(is_y)] = if stop == Stop::One { Stop::Zero } else { Stop::One };
            (at, if is_y { RampAxis::Y } else { RampAxis::X }, stop)
        }).take_while(|&(at, ..)| at < 89.0).collect();
        let missing: Vec<_> =
            [2 * 9, 4 * 9].into_iter().filter(|_| absent).map(|corner| MissingCorner { corner, arrival: None }).collect();
        let (program, log) = written(&loader, &missing, &folds);
        prop_assert_eq!(told(&log), in_program(&program));
    }
}

/// A tally by kind: what is told twice or not at all shows here, whatever it is.
#[test]
fn every_event_is_told_once() {
    let mut tally = BTreeMap::<String, u32>::new();
    for (_, event) in in_time().events {
        let text = format!("{event:?}");
        let kind: String = text.chars().take_while(|c| c.is_alphanumeric()).collect();
        *tally.entry(kind).or_default() += 1;
    }
    let expected = [
        ("Access", 8),
        ("Home", 12),
        ("Load", 8),
        ("Stop", 2),
        ("Transfer", 4),
        ("Wanted", 8),
        ("Wasted", 2),
    ];
    assert_eq!(tally, expected.map(|(kind, count)| (kind.to_owned(), count)).into());
}
