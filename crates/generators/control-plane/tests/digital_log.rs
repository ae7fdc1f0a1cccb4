//! What the list of events tells of set-ups, drums, craters and shadow boundaries: instants worked out by hand.

use std::f64::consts::PI;
use std::sync::Arc;

use control_plane::{
    ControlPlane, DataKind, DigitalEvent, DigitalUnit, EventWord, FrameSweeps, LoadedPart, MachineStage,
};
use features::{Crater, Features, Shape};
use glam::{DMat3, DVec3};
use hardware_model::{
    BankPlace, Cpu, DataBanks, Drum, DrumQueue, FeatureParts, HardwareModel, KindBank, KindBanks, Raster,
    Settings, ShadowParts,
};
use landscape::{Attitude, Bank, Landscape, Level, Sun};
use quantities::{Rate, Timebase};
use scenario::{
    Display, FieldOfView, LawWishes, Pose, RangeLaw, RangeProgramme, RasterWishes, Scalar, Scenery,
    ShadowFineness, Standing, TrackPatch,
};
use solids::{Body, Kind, Solid};
use timing::{Cause, Deadline};

/// The eye: north, east, height (m).
const EYE: [f64; 3] = [115.3, 115.2, 10.0];
/// A narrow view: every sweep goes straight ahead.
const FIELD: FieldOfView = FieldOfView { tan_half_width: 1e-4, tan_half_height: 0.2 };

/// Ten sweeps of 90 steps and a retrace of ten, ten ticks a step: frame f, sweep s begins at tick 10000 f + 1000 s. The sweep is at
/// k + 1 metres at step k.
fn settings() -> Settings {
    let rate = |hertz| Rate::new(hertz, 1).expect("not 0");
    let settings = Settings::resolve(
        &HardwareModel::ideal(),
        FIELD,
        RasterWishes::default(),
        None,
        LawWishes::default(),
        Scalar::F64,
        Display { white: 1.0, gamma: 1.0 },
    );
    let settings = settings.expect("the ideal model is consistent");
    Settings {
        raster: Raster { sweeps: 10, samples: 90, columns: 10, lines: 8, field: FIELD, refresh: rate(10) },
        timebase: Timebase::new(rate(100_000), rate(10), 10, 90, 10).expect("it fits"),
        range: RangeProgramme { law: RangeLaw::ConstantRate, start: 1.0, end: 90.0 },
        ..settings
    }
}

fn pose(heading: f64) -> Pose {
    Pose { time: 0.0, eye: EYE, attitude: Attitude { roll: 0.0, pitch: 0.0, heading }, yoke: 0.0 }
}

/// Flat ground with bowls of 5 m radius straight ahead, each so far from the eye, and patches of shadow between two ranges (m).
fn machine(settings: Settings, bowls: &[f64], patches: &[[f64; 2]]) -> ControlPlane {
    let (landscape, scenery) = scene(bowls, patches);
    ControlPlane::new(MachineStage { landscape, scenery: Arc::new(scenery), settings })
}

/// What the machine of [`machine`] draws; it stands still for two frames after it has turned about.
fn scene(bowls: &[f64], patches: &[[f64; 2]]) -> (Arc<Landscape>, Scenery) {
    let level = Level::new(10.0, [0.0; 2], [24, 24], vec![[0.0; 9]; 24 * 24]).expect("a level");
    let bowl = |ahead: &f64| Crater::new([EYE[0] + ahead, EYE[1]], Shape::Bowl { r1: 5.0 }, 0.1, 0.0);
    let bowls = bowls.iter().map(|ahead| bowl(ahead).expect("a bowl")).collect();
    let patch = |&[near, far]: &[f64; 2]| {
        let corner = |ahead: f64, right: f64| [EYE[0] + ahead, EYE[1] + right];
        let corners = [corner(far, -5.0), corner(far, 5.0), corner(near, 5.0), corner(near, -5.0)];
        TrackPatch { laid: 0.0, corners }
    };
    let scenery = Scenery::still(Sun { azimuth: 0.3, elevation: 1.0 })
        .with_patches(patches.iter().map(patch).collect())
        .with_course([0.0, PI, PI, PI].map(pose).to_vec());
    let bank = Bank::new("test", vec![level], None).expect("one level is a bank");
    (Arc::new(Landscape::new(bank, 1.0).with_features(Features::new(bowls))), scenery)
}

/// Tick, word, sweep and ticks that were left of the events that belong to no fold, in frame 1.
fn of_frame(cpu: Cpu) -> Vec<(u64, EventWord, Option<u32>, Option<i64>)> {
    let control = machine(Settings { cpu, ..settings() }, &[], &[]);
    let sweeps = control.sweeps(1, &pose(0.0)).expect("a pose that can be drawn");
    let told = |event: DigitalEvent| (event.tick.0, event.event, event.sweep.or(event.other), event.slack);
    sweeps.frame_events().into_iter().map(told).collect()
}

#[test]
fn set_ups_and_tables_in_time() {
    let found = of_frame(Cpu { sweep_setup: 400, frame_tables: 1500, ..Cpu::default() });
    // Each set-up begins with the sweep before its own; 600 ticks of each sweep are left for the tables.
    let mut expected = Vec::new();
    for sweep in 0..10 {
        let before = 9000 + 1000 * u64::from(sweep);
        expected.push((before, EventWord::SetUpBegins, Some(sweep), None));
        expected.push((before + 400, EventWord::SetUp, Some(sweep), Some(600)));
    }
    expected.push((12_700, EventWord::Tables, None, Some(7300)));
    expected.sort_by_key(|event| event.0);
    assert_eq!(found, expected);
}

#[test]
fn set_ups_and_tables_that_are_late() {
    let cpu = Cpu { sweep_setup: 1300, frame_tables: 1500, ..Cpu::default() };
    let control = machine(Settings { cpu, ..settings() }, &[], &[]);
    let events = control.sweeps(1, &pose(0.0)).expect("a pose that can be drawn").frame_events();
    let of = |word: EventWord| events.iter().filter(move |event| event.event == word);
    // One after another, each for the sweep after the one in whose time it begins; the last is given up.
    let made = [(0, 9000), (1, 10_300), (2, 11_600), (3, 12_900), (5, 14_200), (6, 15_500), (7, 16_800)];
    let begun: Vec<_> = made.into_iter().chain([(9, 18_100)]).collect();
    let found = of(EventWord::SetUpBegins).map(|event| (event.sweep.unwrap(), event.tick.0));
    assert_eq!(found.collect::<Vec<_>>(), begun);
    let late = |&(sweep, begins): &(u32, u64)| {
        let (start, ready) = (10_000 + 1000 * i64::from(sweep), begins + 1300);
        (sweep, ready, Some(start - ready as i64))
    };
    let found = of(EventWord::SetUpLate).map(|event| (event.sweep.unwrap(), event.tick.0, event.slack));
    assert_eq!(found.collect::<Vec<_>>(), made.iter().map(late).collect::<Vec<_>>());
    // Each sweep takes the last that is made as it begins.
    let old = [(1, 0), (2, 1), (3, 2), (4, 2), (5, 3), (6, 5), (7, 6), (8, 6), (9, 7)];
    let found = of(EventWord::OldSetUp).map(|event| (event.tick.0, event.sweep, event.other));
    let expected = old.map(|(sweep, other)| (10_000 + 1000 * u64::from(sweep), Some(sweep), Some(other)));
    assert_eq!(found.collect::<Vec<_>>(), expected);
    let found = of(EventWord::TablesLate).map(|event| (event.tick.0, event.slack));
    assert_eq!(found.collect::<Vec<_>>(), [(20_000, Some(-1500))]);
    assert_eq!(of(EventWord::SetUp).chain(of(EventWord::Tables)).count(), 0);
}

/// Tick from the start of the sweep, word, part and ticks that were left of the loads of a unit in frame 1, sweep 1.
fn loads(
    control: &ControlPlane,
    unit: DigitalUnit,
) -> Vec<(u64, EventWord, Option<LoadedPart>, Option<i64>)> {
    let sweeps = control.sweeps_with_gates(1, &pose(0.0)).expect("a pose that can be drawn");
    let events = sweeps.events(1).into_iter().filter(|event| event.unit == unit);
    events.map(|event| (event.tick.0 - 11_000, event.event, event.part, event.slack)).collect()
}

/// Four bowls and one sub-generator, whose words take 150 ticks, from 100 ticks before the sweep on. The first is met at
/// 25.04 m, tick 240.4, and left at 35.04 m, tick 340.4. The second waits for it and is met at tick 540.4; it still has the
/// sub-generator when the third is met at tick 570.4. The fourth is met at tick 650.4, ten ticks after the second is left.
#[test]
fn craters_in_time_late_and_dropped() {
    let settings = Settings {
        feature_words: Some(8.0 * 100_000.0 / 150.0),
        feature_generator: FeatureParts { sub_generators: Some(1), ..FeatureParts::default() },
        ..settings()
    };
    let control = machine(settings, &[30.04, 60.04, 63.04, 71.04], &[]);
    let part = Some(LoadedPart::SubGenerator(1, 0));
    let expected = [
        (50, EventWord::CraterLoad, part, Some(240 - 50)),
        (491, EventWord::CraterLoad, part, Some(540 - 491)),
        (571, EventWord::CraterDropped, None, None),
        (791, EventWord::CraterLate, part, Some(650 - 791)),
    ];
    assert_eq!(loads(&control, DigitalUnit::FeatureGenerator), expected);
}

/// Four edges of shadow across the sweep and three line generators, whose words take 250 ticks.
#[test]
fn boundaries_in_time_late_and_dropped() {
    let settings = Settings {
        segment_words: Some(4.0 * 100_000.0 / 250.0),
        shadow_controller: ShadowParts::Digital { line_generators: Some(3) },
        shadows: Some(ShadowFineness { finest: 1.0, angle: 0.02, reach: None }),
        ..settings()
    };
    let control = machine(settings, &[], &[[20.04, 30.04], [40.04, 50.04]]);
    let part = |number| Some(LoadedPart::LineGenerator(number));
    let expected = [
        (150, EventWord::SegmentLoad, part(0), Some(190 - 150)),
        (400, EventWord::SegmentLate, part(1), Some(290 - 400)),
        (491, EventWord::SegmentDropped, None, None),
        (650, EventWord::SegmentLate, part(2), Some(390 - 650)),
    ];
    assert_eq!(loads(&control, DigitalUnit::ShadowController), expected);
}

/// The view turns about, and a drum brings what lies behind, corner by corner, the nearest first.
#[test]
fn records_come_as_the_drum_turns() {
    let drum = Drum { rotation: 300, word: 3.0, record_words: 9, queue: DrumQueue::Fifo, count: 1 };
    let data_banks = DataBanks { drum: Some(drum), ..settings().data_banks };
    let control = machine(Settings { data_banks, ..settings() }, &[], &[]);
    let figures = control.drums(DataKind::Fine)[0];
    let sweeps = control.sweeps(1, &pose(PI)).expect("a pose that can be drawn");
    let records = sweeps.frame_events();
    assert!(records.len() > 40 && records.iter().all(|event| event.event == EventWord::Record));
    let mut free = 10_000;
    let mut nearest = 0.0;
    for event in &records {
        assert_eq!(
            (event.unit, event.level, event.words),
            (DigitalUnit::Drum(DataKind::Fine, 0), Some(0), 9)
        );
        let [m, n] = event.corner.expect("a record of one corner");
        let place = figures.place((24 * m + n) as u32);
        assert_eq!(event.tick.0, figures.passes(place, free) + figures.transfer, "{m} {n}");
        free = event.tick.0;
        let [north, east] = [10.0 * m as f64 - EYE[0], 10.0 * n as f64 - EYE[1]];
        let distance = north * north + east * east;
        assert!(distance >= nearest, "{m} {n} after one farther away");
        nearest = distance;
    }
}

/// Records of craters, boundaries and bodies on drums of their own, two words a tick, squares of one region.
fn kinds_on_drums(place: BankPlace) -> Settings {
    let drum = Drum { rotation: 600, word: 3.0, record_words: 9, queue: DrumQueue::Fifo, count: 1 };
    let base = settings();
    let bank = |bank: KindBank| KindBank { place, record_words: 24, ..bank };
    let KindBanks { features, shadows, polyhedra, .. } = base.kind_banks;
    let (features, shadows, polyhedra) = (bank(features), bank(shadows), bank(polyhedra));
    let shadow_fineness = ShadowFineness { finest: 5.0, angle: 0.1, reach: None };
    Settings {
        data_banks: DataBanks { drum: Some(drum), ..base.data_banks },
        kind_banks: KindBanks { features, shadows, polyhedra, ..base.kind_banks },
        feature_words: Some(1e6),
        segment_words: Some(1e6),
        shadows: Some(shadow_fineness),
        ..base
    }
}

/// Craters that the loads of a sweep name.
fn craters_of(sweeps: &FrameSweeps<'_>, sweep: u32) -> Vec<u32> {
    let mut craters: Vec<u32> = sweeps.events(sweep).into_iter().filter_map(|event| event.crater).collect();
    craters.sort_unstable();
    craters
}

/// The view turns about: craters behind come square by square, and a sweep knows those that were there as it began.
#[test]
fn a_crater_is_drawn_from_the_first_sweep_after_its_record() {
    let ahead = [-15.0, -36.0, -57.0, -78.0, 20.0];
    for place in [BankPlace::Apart, BankPlace::Together] {
        let control = machine(kinds_on_drums(place), &ahead, &[]);
        let turned = pose(PI);
        let sweeps = control.sweeps(1, &turned).expect("a pose that can be drawn");
        let events = sweeps.frame_events();
        let came: Vec<(u64, [i64; 2])> = events
            .iter()
            .filter(|event| event.event == EventWord::FeatureRecord)
            .map(|event| (event.tick.0, event.corner.expect("a square")))
            .collect();
        assert_eq!(came.len(), 4, "{place:?}: {events:?}");
        let drums = if place == BankPlace::Apart { DataKind::Features } else { DataKind::Fine };
        let of_craters = |event: &&DigitalEvent| event.event == EventWord::FeatureRecord;
        assert!(events.iter().filter(of_craters).all(|event| event.unit == DigitalUnit::Drum(drums, 0)));
        let mut grew = 0;
        for sweep in 0..10 {
            let begins = 10_000 + 1000 * u64::from(sweep);
            let there = |crater: &u32| {
                let north = ((EYE[0] + ahead[*crater as usize]) / 10.0).floor() as i64;
                let record = came.iter().find(|(_, [m, _])| *m == north);
                record.is_some_and(|&(tick, _)| tick <= begins)
            };
            let expected: Vec<u32> = (0..4).filter(there).collect();
            grew += usize::from(!expected.is_empty() && expected.len() < 4);
            assert_eq!(craters_of(&sweeps, sweep), expected, "{place:?}, sweep {sweep}");
            let lacking: Vec<u32> = (0..4).filter(|&crater| sweeps.lacks_crater(crater, sweep)).collect();
            assert!(lacking.iter().all(|crater| !expected.contains(crater)), "{lacking:?} {expected:?}");
            assert_eq!(lacking.len() + expected.len(), 4);
        }
        assert!(grew > 0, "all came at once");
        // In the first frame all is there, and what a model keeps in a memory of its own never comes.
        let first = control.sweeps(0, &pose(0.0)).expect("a pose that can be drawn");
        assert_eq!((craters_of(&first, 0), first.frame_events().len()), (vec![4], 0));
    }
    let local = machine(kinds_on_drums(BankPlace::Local), &ahead, &[]);
    let sweeps = local.sweeps(1, &pose(PI)).expect("a pose that can be drawn");
    assert!(sweeps.frame_events().iter().all(|event| event.event == EventWord::Record));
    assert_eq!(craters_of(&sweeps, 0), [0, 1, 2, 3]);
}

/// The same of patches of shadow: the gate of a sweep has those whose square was whole as it began, and a missing patch leaves no
/// edge behind.
#[test]
fn a_shadow_acts_from_the_first_sweep_after_its_square() {
    let patches = [[-18.0, -12.0], [-38.0, -32.0], [-58.0, -52.0]];
    let control = machine(kinds_on_drums(BankPlace::Apart), &[], &patches);
    let turned = pose(PI);
    let sweeps = control.sweeps_with_gates(1, &turned).expect("a pose that can be drawn");
    let came: Vec<u64> = sweeps
        .frame_events()
        .iter()
        .filter(|event| event.event == EventWord::ShadowRecord)
        .map(|event| event.tick.0)
        .collect();
    assert_eq!(came.len(), 3);
    let mut counts = Vec::new();
    for sweep in 0..10 {
        let begins = 10_000 + 1000 * u64::from(sweep);
        let gate = sweeps.gate(sweep).expect("shadows are asked for");
        let there = came.iter().filter(|&&tick| tick <= begins).count();
        assert_eq!(gate.loads.len(), 2 * there, "sweep {sweep}");
        assert!(!gate.dark_at_start && !gate.is_dark(89.0), "sweep {sweep}");
        let north = EYE[0] - 15.0;
        assert_eq!(sweeps.lacks_shadows([north, EYE[1]], sweep), gate.loads.is_empty(), "sweep {sweep}");
        counts.push(there);
    }
    assert!(counts[0] < 3 && counts[9] == 3, "{counts:?}");
}

/// What a frame's record has of the banks: a deadline for every record that it asks for, misses with their square, shares of a drum.
#[test]
fn the_timing_record_has_the_banks() {
    let ahead = [-15.0, -36.0, -57.0];
    let control = machine(kinds_on_drums(BankPlace::Together), &ahead, &[[-18.0, -12.0]]);
    let turned = pose(PI);
    let timing = control.frame(1, &turned).expect("a pose that can be drawn");
    let slack = &timing.deadlines[&Deadline::FEATURE_RECORD];
    assert_eq!((slack.count, slack.missed), (3, 3));
    assert_eq!(timing.deadlines[&Deadline::SHADOW_RECORD].missed, 1);
    let misses: Vec<_> =
        timing.misses.iter().filter(|miss| miss.deadline == Deadline::FEATURE_RECORD).collect();
    assert!(misses.iter().all(|miss| miss.cause == Cause::Drum && miss.came.is_some()));
    assert_eq!(misses.len(), 3);
    let least = misses.iter().filter_map(|miss| miss.came).fold(0.0, f64::max);
    // Ten ticks a step.
    assert_eq!(slack.least, Some(-(10.0 * least).round() as i64));
    let busy = |unit: &str| timing.units.iter().find(|found| found.unit == unit).map(|found| found.busy);
    let shares = ["fine", "features", "shadows"].map(|kind| busy(&format!("drum.fine.0.{kind}")).unwrap());
    assert!(shares.iter().all(|&share| share > 0));
    assert_eq!(busy("drum.fine.0"), Some(shares.iter().sum()));
    let first = control.frame(0, &pose(0.0)).expect("a pose that can be drawn");
    assert_eq!(first.deadlines[&Deadline::CORNER].missed, 0);
}

/// A block stands behind the vehicle, which turns about: it is projected from the first frame that begins after its record.
#[test]
fn a_body_is_drawn_from_the_first_frame_after_its_record() {
    let wide = |settings: Settings| {
        let field = FieldOfView { tan_half_width: 0.3, tan_half_height: 0.2 };
        Settings { shadows: None, raster: Raster { field, ..settings.raster }, ..settings }
    };
    let settings = wide(kinds_on_drums(BankPlace::Apart));
    let solid = Arc::new(Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).expect("a box"));
    let foot = DVec3::new(EYE[0] - 70.0, EYE[1], 0.0);
    let body = Body::place(0, Kind::Culture, &solid, foot, &DMat3::IDENTITY, 3.0);
    let (landscape, scenery) = scene(&[], &[]);
    let standing = vec![Standing { from: 0.0, until: 9.0, body }];
    let scenery = Arc::new(scenery.with_bodies(standing));
    let stage = MachineStage { landscape, scenery, settings };
    let control = ControlPlane::new(stage.clone());
    let projected = |frame: u64, heading: f64| {
        let sweeps = control.sweeps(frame, &pose(heading)).expect("a pose that can be drawn");
        control.delivery(&sweeps, 0.0).census.drawn
    };
    let record = control.sweeps(1, &pose(PI)).expect("a pose that can be drawn").frame_events();
    let came = record.iter().find(|event| event.event == EventWord::BodyRecord).expect("it comes");
    assert!(came.tick.0 > 10_000 && came.tick.0 < 20_000, "{came:?}");
    assert_eq!(came.unit, DigitalUnit::Drum(DataKind::Polyhedra, 0));
    assert_eq!([projected(1, PI), projected(2, PI)], [0, 1]);
    let timing = control.frame(1, &pose(PI)).expect("a pose that can be drawn");
    // 30 words do not fit into one record of 24.
    assert_eq!(timing.deadlines[&Deadline::BODY_RECORD].missed, 2);
    let timing = control.frame(2, &pose(PI)).expect("a pose that can be drawn");
    let slack = &timing.deadlines[&Deadline::BODY_RECORD];
    assert_eq!((slack.count, slack.missed), (2, 0));
    // In a memory of the generator it is there at once.
    let settings = wide(kinds_on_drums(BankPlace::Local));
    let local = ControlPlane::new(MachineStage { settings, ..stage });
    let sweeps = local.sweeps(1, &pose(PI)).expect("a pose that can be drawn");
    assert_eq!(local.delivery(&sweeps, 0.0).census.drawn, 1);
}
