//! Words of craters and of shadow boundaries that come late (hardware sections 3.7 and 7): what the record says, and that
//! nothing else changes in the picture.

use std::collections::BTreeSet;
use std::sync::Arc;

use control_plane::{ControlPlane, DigitalEvent, EventWord, MachineStage};
use features::{Crater, Features, Shape};
use generator::{PlaneKind, Planes};
use hardware_model::{LatePolicy, ShadowParts};
use lunoid_tests::{ComparedScene, Dice, level_of, plane};
use machine::Prepare;
use rayon::ThreadPoolBuilder;
use scenario::{ShadowFineness, TrackPatch};
use signal::Probe;
use sweep_program::Fan;
use timing::{Cause, Deadline, FrameTiming, Missed};

use crate::timing::rig::busy;

const SWEEPS: u32 = 21;
/// Words a second that leave some craters late, and some boundaries.
const SLOW: f64 = 0.02e6;

fn scene() -> ComparedScene {
    let mut scene = ComparedScene::over(level_of(32.0, [0.0; 2], [17; 2], plane(32.0, 0.0, [0.0; 2])));
    scene.sweeps = SWEEPS;
    // Low enough to see what is near.
    scene.eye[2] = 1.5;
    scene
}

fn words(stage: MachineStage, rate: Option<f64>, policy: LatePolicy) -> MachineStage {
    let mut stage = stage;
    (stage.settings.feature_words, stage.settings.segment_words) = (rate, rate);
    stage.settings.loader.late_policy = policy;
    stage
}

/// Bowls ahead of the eye, anywhere in the field of view.
fn craters(scene: &ComparedScene) -> Vec<Crater> {
    let (mut dice, [x, y, _]) = (Dice::new(11), scene.eye);
    let one = |_| {
        let (range, side, r1) = (dice.between(8.0, 110.0), dice.between(-0.4, 0.4), dice.between(0.5, 3.0));
        Crater::new([x + range, y + side * range], Shape::Bowl { r1 }, 0.2 * r1, 0.0).expect("a bowl")
    };
    (0..30).map(one).collect()
}

fn cratered(scene: &ComparedScene) -> MachineStage {
    let stage = scene.stage();
    let ground = (*stage.landscape).clone().with_features(Features::new(craters(scene)));
    MachineStage { landscape: Arc::new(ground), ..stage }
}

/// Dark bars across the view, the farther the narrower: outer sweeps meet the first alone.
fn barred(scene: &ComparedScene) -> MachineStage {
    let mut stage = scene.stage();
    let [x, y, _] = scene.eye;
    let bar = |k: u32| {
        let [near, far] = [6.0 + 3.0 * f64::from(k), 7.0 + 3.5 * f64::from(k)].map(|range| x + range);
        let half = [40.0, 4.0, 3.0, 2.0][k as usize];
        let [west, east] = [y - half, y + half];
        TrackPatch { laid: 0.0, corners: [[far, west], [far, east], [near, east], [near, west]] }
    };
    let patches = (0..4).map(bar).collect();
    stage.scenery = Arc::new((*stage.scenery).clone().with_patches(patches));
    stage.settings.shadows = Some(ShadowFineness { finest: 0.5, angle: 5e-3, reach: None });
    stage
}

fn timed(stage: &MachineStage, scene: &ComparedScene) -> FrameTiming {
    ControlPlane::new(stage.clone()).frame(0, &scene.pose()).expect("a pose over flat ground")
}

fn picture(stage: &MachineStage, scene: &ComparedScene) -> Vec<f32> {
    let session = stage.clone().prepare();
    let mut planes = Planes::new(SWEEPS as usize, scene.lines as usize, &[PlaneKind::Intensity]);
    session.frame(0, &scene.pose(), &mut planes, &mut Probe::off()).expect("a pose over flat ground");
    planes.get(PlaneKind::Intensity).expect("the plane asked for").to_vec()
}

/// Columns in which two pictures differ.
fn columns(a: &[f32], b: &[f32]) -> BTreeSet<u32> {
    let differs = |index: usize| (a[index] != b[index]).then_some(index as u32 % SWEEPS);
    (0..a.len()).filter_map(differs).collect()
}

fn misses(frame: &FrameTiming, deadline: Deadline) -> Vec<&Missed> {
    frame.misses.iter().filter(|missed| missed.deadline == deadline).collect()
}

/// Whatever differs from the picture of words in time stands in the record, sweep by sweep.
fn expect_traced(stage: &MachineStage, scene: &ComparedScene, deadline: Deadline) {
    let in_time = picture(&words(stage.clone(), None, LatePolicy::StrobeThrough), scene);
    for policy in [LatePolicy::StrobeThrough, LatePolicy::Latched] {
        let stage = words(stage.clone(), Some(SLOW), policy);
        let frame = timed(&stage, scene);
        let late: BTreeSet<u32> = misses(&frame, deadline).iter().map(|missed| missed.sweep).collect();
        let changed = columns(&picture(&stage, scene), &in_time);
        assert!(changed.is_subset(&late), "{policy:?}: {changed:?} changed, late in {late:?}");
        assert!(changed.len() > 5 && late.len() < SWEEPS as usize, "{policy:?}: {changed:?}, {late:?}");
        let slack = &frame.deadlines[&deadline];
        assert_eq!(slack.missed as usize, misses(&frame, deadline).len());
        assert!(slack.count > slack.missed);
    }
}

#[test]
fn columns_with_late_craters_are_those_of_the_record() {
    let scene = scene();
    expect_traced(&cratered(&scene), &scene, Deadline::FEATURE);
}

#[test]
fn columns_with_late_boundaries_are_those_of_the_record() {
    let scene = scene();
    expect_traced(&barred(&scene), &scene, Deadline::SEGMENT);
}

#[test]
fn a_late_crater_has_its_edge_its_part_and_its_cause() {
    let scene = scene();
    let mut stage = words(cratered(&scene), Some(SLOW), LatePolicy::StrobeThrough);
    stage.settings.feature_generator.sub_generators = Some(1);
    let frame = timed(&stage, &scene);
    let (all, [x, y, _]) = (craters(&scene), scene.eye);
    let settings = &stage.settings;
    let fan = Fan::covering(settings.laws.projection, 0.0, &settings.raster.field, SWEEPS).expect("level");
    let found = misses(&frame, Deadline::FEATURE);
    for missed in &found {
        let crater = &all[missed.crater.expect("a crater") as usize];
        let [cos, sin] = fan.direction(missed.sweep, [1.0, 0.0]);
        let [north, east] = [crater.centre()[0] - x, crater.centre()[1] - y];
        let (middle, side) = (north * cos + east * sin, east * cos - north * sin);
        let edge = middle - (crater.outer() * crater.outer() - side * side).sqrt();
        assert!((missed.range_m.expect("a range") - edge).abs() < 1e-9, "{missed:?}");
        match missed.cause {
            Cause::Occupied => assert!(missed.part.is_none() && missed.came.is_none()),
            Cause::Queue | Cause::Access => {
                assert_eq!(missed.part.as_deref(), Some("sub-generator.1.0"));
                assert!(missed.came.is_none_or(|came| came > missed.due), "{missed:?}");
            }
            other => panic!("{other}"),
        }
        assert_eq!(missed.words, 0xff);
    }
    let causes: BTreeSet<Cause> = found.iter().map(|missed| missed.cause).collect();
    assert!(causes.len() == 3 && found.len() > 10, "{causes:?}, {}", found.len());
    // Eight words at 0.02 a microsecond of 20 ticks, once a load.
    let loads = busy(&frame, "feature-generator.load") / 8000;
    let occupied = found.iter().filter(|missed| missed.cause == Cause::Occupied).count() as u64;
    assert_eq!(busy(&frame, "feature-generator.load") % 8000, 0);
    assert!(loads > 10 && loads <= frame.deadlines[&Deadline::FEATURE].count - occupied, "{loads}");
}

#[test]
fn without_a_rate_nothing_is_timed() {
    let scene = scene();
    for stage in [cratered(&scene), barred(&scene)] {
        let frame = timed(&words(stage, None, LatePolicy::Latched), &scene);
        assert!(!frame.deadlines.contains_key(&Deadline::FEATURE) && frame.misses.is_empty());
        assert!(!frame.deadlines.contains_key(&Deadline::SEGMENT));
        assert!(frame.units.iter().all(|unit| !unit.unit.ends_with(".load")), "{:?}", frame.units);
    }
}

/// Line generators that are too few are in the record without any rate.
#[test]
fn boundaries_without_a_line_generator_are_in_the_record() {
    let scene = scene();
    let mut stage = words(barred(&scene), None, LatePolicy::Latched);
    stage.settings.shadow_controller = ShadowParts::Digital { line_generators: Some(2) };
    let frame = timed(&stage, &scene);
    let found = misses(&frame, Deadline::SEGMENT);
    assert!(found.iter().all(|missed| missed.cause == Cause::Occupied && missed.range_m.is_some()));
    assert!(found.len() >= SWEEPS as usize, "{}", found.len());
}

#[test]
fn threads_and_order_do_not_matter() {
    let scene = scene();
    for stage in [cratered(&scene), barred(&scene)] {
        let stage = words(stage, Some(SLOW), LatePolicy::StrobeThrough);
        let by = |threads: usize, frames: [u64; 3]| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let control = ControlPlane::new(stage.clone());
            let mut all = pool.install(|| {
                frames.map(|frame| control.frame(frame, &scene.pose()).expect("a pose over flat ground"))
            });
            all.sort_by_key(|frame| frame.frame);
            all
        };
        assert_eq!(by(1, [0, 7, 3]), by(2, [3, 0, 7]));
    }
}

/// Words of an event and of its kinds: in time, late, dropped.
const CRATER: [EventWord; 3] = [EventWord::CraterLoad, EventWord::CraterLate, EventWord::CraterDropped];
const SEGMENT: [EventWord; 3] = [EventWord::SegmentLoad, EventWord::SegmentLate, EventWord::SegmentDropped];

/// The list of events has as many loads as the record, and each miss of the record at its tick.
fn expect_listed(
    stage: &MachineStage,
    scene: &ComparedScene,
    deadline: Deadline,
    [load, late, dropped]: [EventWord; 3],
) {
    for (rate, parts) in [(Some(SLOW), None), (Some(SLOW), Some(1)), (None, Some(1)), (None, None)] {
        let mut stage = words(stage.clone(), rate, LatePolicy::StrobeThrough);
        stage.settings.feature_generator.sub_generators = parts;
        stage.settings.shadow_controller = ShadowParts::Digital { line_generators: parts };
        let (control, case) =
            (ControlPlane::new(stage.clone()), format!("{deadline:?}, {rate:?}, {parts:?}"));
        let frame = control.frame(0, &scene.pose()).expect("a pose over flat ground");
        let sweeps = control.sweeps_with_gates(0, &scene.pose()).expect("a pose over flat ground");
        let events: Vec<DigitalEvent> = (0..SWEEPS).flat_map(|sweep| sweeps.events(sweep)).collect();
        let of = |word: EventWord| events.iter().filter(move |event| event.event == word);
        let missed = misses(&frame, deadline);
        assert_eq!(of(late).count() + of(dropped).count(), missed.len(), "{case}");
        assert_eq!(missed.is_empty(), rate.is_none() && parts.is_none(), "{case}");
        if let Some(slack) = frame.deadlines.get(&deadline).filter(|_| rate.is_some()) {
            assert_eq!((of(load).count() + missed.len()) as u64, slack.count, "{case}");
            assert!(of(load).all(|event| event.slack.is_some_and(|slack| slack >= 0)), "{case}");
        }
        assert!(of(load).count() > 5 && of(load).all(|event| event.words > 0), "{case}");
        for missed in missed {
            let is_it = |event: &&DigitalEvent| {
                (event.sweep, event.crater, event.range)
                    == (Some(missed.sweep), missed.crater, missed.range_m)
            };
            let event =
                of(late).chain(of(dropped)).find(is_it).unwrap_or_else(|| panic!("{case}: {missed:?}"));
            let part = event.part.map(|part| part.to_string());
            assert_eq!((event.event == late, part), (missed.came.is_some(), missed.part.clone()), "{case}");
            let clock = stage.settings.timebase.sweep_clock(0, missed.sweep);
            if let Some(came) = missed.came {
                assert_eq!(clock.instant_of(event.tick).0, came, "{case}: {missed:?}");
            }
        }
    }
}

#[test]
fn craters_are_listed_as_the_record_has_them() {
    let scene = scene();
    expect_listed(&cratered(&scene), &scene, Deadline::FEATURE, CRATER);
}

#[test]
fn boundaries_are_listed_as_the_record_has_them() {
    let scene = scene();
    expect_listed(&barred(&scene), &scene, Deadline::SEGMENT, SEGMENT);
}
