//! States of the digital side on their wires, held to what the timing record counts and to the events, one by one.

use control_plane::{ControlPlane, DigitalEvent, EventWord};
use generator::Planes;
use machine::Prepare;
use quantities::{SweepTime, Timebase};
use signal::{Probe, Waveform};
use sweep_program::Colour;

use crate::timing::order::mission;
use crate::timing::rig::{busy, frame};

const FRAME: u64 = 60;
const SWEEPS: u32 = 5;

/// The mission of `order.rs`, in which records are edited too: waveforms of all sweeps of a frame, and its control plane.
struct Watched {
    control: ControlPlane,
    waves: Vec<Waveform>,
    timebase: Timebase,
}

impl Watched {
    fn new() -> Self {
        let (mut stage, course) = mission();
        stage.settings.kind_banks.terrain_edit = 11.0;
        let timebase = stage.settings.timebase;
        let patterns = ["cpu.*", "loader.*", "drum.*", "channel.*", "editor.*", "buffer.*"];
        let mut probe = Probe::new(patterns.map(str::to_owned).into(), 0..SWEEPS);
        let pose = &course[FRAME as usize];
        let session = stage.clone().prepare();
        session.frame(FRAME, pose, &mut Planes::new(0, 0, &[]), &mut probe).expect("a pose over flat ground");
        Self { control: ControlPlane::new(stage), waves: probe.waveforms, timebase }
    }

    fn wave(&self, name: &str, sweep: u32) -> &Waveform {
        let found = self.waves.iter().find(|wave| (wave.signal.name, wave.sweep) == (name, sweep));
        found.unwrap_or_else(|| panic!("{name} of sweep {sweep}"))
    }

    /// Ticks of the frame in which a wire has a value that counts, and how many there may be more or less by rounding.
    fn held(&self, name: &str, counts: impl Fn(f64) -> bool) -> [f64; 2] {
        let (a_sample, samples) =
            (self.timebase.ticks_per_sample(), f64::from(self.timebase.sweep_samples()));
        let (mut ticks, mut changes) = (0.0, 0);
        for sweep in 0..SWEEPS {
            let Waveform { times, values, .. } = self.wave(name, sweep);
            let ends = times.iter().skip(1).copied().chain([samples]);
            let spells = times.iter().zip(ends).zip(values).filter(|(_, value)| counts(**value));
            ticks += spells.map(|((begin, end), _)| (end - begin) * a_sample).sum::<f64>();
            changes += times.len();
        }
        [ticks, 2.0 * changes as f64]
    }

    fn events(&self) -> Vec<DigitalEvent> {
        let (_, course) = mission();
        let sweeps = self.control.sweeps(FRAME, &course[FRAME as usize]).expect("a pose over flat ground");
        let of_sweeps = (0..SWEEPS).flat_map(|sweep| sweeps.events(sweep));
        of_sweeps.chain(sweeps.frame_events()).collect()
    }

    /// Tick of the master clock at an instant of a sweep (samples).
    fn tick(&self, sweep: u32, time: f64) -> f64 {
        let before = SweepTime(time - 0.5 / self.timebase.ticks_per_sample());
        self.timebase.sweep_clock(FRAME, sweep).tick_at_or_after(before).0 as f64
    }
}

/// What a wire of changes has at an instant.
fn at(wave: &Waveform, time: f64) -> f64 {
    wave.values[wave.times.partition_point(|&change| change <= time) - 1]
}

#[test]
fn units_of_the_banks_are_at_work_for_as_long_as_the_record_counts() {
    let (_, course) = mission();
    let watched = Watched::new();
    let record = frame(&watched.control, FRAME, &course[FRAME as usize]);
    for number in 0..2 {
        let expected = busy(&record, &format!("drum.fine.{number}")) as f64;
        for (wire, idle) in [("heads", 0.0), ("reads", -1.0)] {
            let name = format!("drum.{number}.{wire}");
            let [ticks, rounding] = watched.held(&name, |value| value > idle);
            assert!(expected > 1000.0 && (ticks - expected).abs() <= rounding, "{name}: {ticks}, {expected}");
        }
        // Each drum has its own channel here, which carries what the heads read.
        let [reading, rounding] = watched.held(&format!("drum.{number}.heads"), |value| value == 2.0);
        let [carried, _] = watched.held(&format!("channel.{number}.drum"), |drum| drum == f64::from(number));
        assert!((reading - carried).abs() <= rounding, "drum {number}: {reading} {carried}");
    }
    let [edited, rounding] = watched.held("editor.fine.record", |record| record >= 0.0);
    let expected = busy(&record, "editor.fine") as f64;
    assert!(expected > 1000.0 && (edited - expected).abs() <= rounding, "{edited}, {expected}");
}

#[test]
fn what_a_storage_buffer_lacks_comes_record_by_record() {
    let watched = Watched::new();
    let records: Vec<(f64, f64)> = watched
        .events()
        .iter()
        .filter(|event| event.event == EventWord::Record)
        .map(|event| (event.tick.0 as f64, f64::from(event.words / 9)))
        .collect();
    assert!(records.len() > 3, "{records:?}");
    let first = watched.wave("buffer.fine.lacks", 0).values[0];
    let came_by =
        |tick: f64| records.iter().filter(|(at, _)| *at <= tick).map(|(_, corners)| corners).sum::<f64>();
    for sweep in 0..SWEEPS {
        let Waveform { times, values, .. } = watched.wave("buffer.fine.lacks", sweep);
        for (time, value) in times.iter().zip(values) {
            assert_eq!(*value, first - came_by(watched.tick(sweep, *time)), "sweep {sweep}, {time}");
        }
    }
}

#[test]
fn sets_wait_from_their_crossing_to_their_fetch() {
    let watched = Watched::new();
    let events = watched.events();
    let mut most = 0.0_f64;
    for colour in Colour::ALL {
        for sweep in 0..SWEEPS {
            let own: Vec<&DigitalEvent> = events
                .iter()
                .filter(|event| (event.sweep, event.colour) == (Some(sweep), Some(colour)))
                .collect();
            let [waiting, crossing] = ["waiting", "crossing"]
                .map(|wire| watched.wave(&format!("loader.{}.{wire}", colour.name()), sweep));
            let clock = watched.timebase.sweep_clock(FRAME, sweep);
            let samples = f64::from(watched.timebase.sweep_samples());
            for now in own.iter().filter(|event| clock.instant_of(event.tick).0 < samples) {
                let so_far = |word: EventWord| {
                    own.iter().filter(|event| event.event == word && event.tick <= now.tick).count() as f64
                };
                let time = clock.instant_of(now.tick).0.max(0.0);
                let expected =
                    so_far(EventWord::Wanted) - so_far(EventWord::Cancelled) - so_far(EventWord::Access);
                assert_eq!(at(waiting, time), expected, "{colour:?}, sweep {sweep}, {now:?}");
                let last =
                    own.iter().rfind(|event| event.event == EventWord::Access && event.tick <= now.tick);
                let last = last.and_then(|event| event.crossing).map_or(-1.0, f64::from);
                assert_eq!(at(crossing, time), last, "{colour:?}, sweep {sweep}, {now:?}");
                most = most.max(expected);
            }
            assert!(waiting.values.iter().all(|value| *value >= 0.0), "{:?}", waiting.values);
        }
    }
    assert!(most >= 2.0, "{most}");
}

#[test]
fn the_processor_is_at_the_set_up_that_it_began_last() {
    let watched = Watched::new();
    let (_, course) = mission();
    let sweeps = watched.control.sweeps(FRAME, &course[FRAME as usize]).expect("a pose over flat ground");
    let of_cpu = [EventWord::SetUpBegins, EventWord::SetUp, EventWord::SetUpLate];
    let events = sweeps.frame_events();
    let mut begun = 0;
    for sweep in 0..SWEEPS {
        assert_eq!(watched.wave("cpu.drawn", sweep).values, [f64::from(sweeps.set_up_of(sweep))]);
        let wave = watched.wave("cpu.set_up", sweep);
        for (&time, &value) in wave.times.iter().zip(&wave.values) {
            let tick = watched.tick(sweep, time);
            let before =
                events.iter().filter(|event| of_cpu.contains(&event.event) && event.tick.0 as f64 <= tick);
            // Of one tick a set-up that begins comes behind one that is made.
            let last = before.max_by_key(|event| (event.tick, event.event == EventWord::SetUpBegins));
            // With the last sweep begins the set-up of the next frame's first.
            let expected = match last {
                Some(_) if sweep == SWEEPS - 1 => -1.0,
                Some(event) if event.event == EventWord::SetUpBegins => event.sweep.map_or(-1.0, f64::from),
                _ => -1.0,
            };
            assert_eq!(value, expected, "sweep {sweep}, {time}");
            begun += usize::from(value >= 0.0);
        }
    }
    assert!(begun >= 2, "{begun}");
}
