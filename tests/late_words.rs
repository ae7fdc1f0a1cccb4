//! Late words forwards: the pixels told are those in which pictures drawn whole differ, and a pixel told names its words.

use std::collections::BTreeMap;

use control_plane::{ControlPlane, LateOf, LateWords, MachineStage};
use explain::{Inquiry, Late, LateEffect, LateError, Missed, late_effect};
use generator::{PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, LatePolicy, LoadDelay, ModelSource};
use lunoid_tests::{Dice, Shipped};
use machine::{OnTime, Prepare, Twice, prepare_twice};
use scenario::{Pose, PoseTable};
use signal::Probe;
use sweep_program::SweepProgram;

/// A scenario on a machine, ready to be asked.
struct Asked {
    scene: Shipped,
    stage: MachineStage,
    control: ControlPlane,
    twice: Box<dyn Twice>,
    session: Box<dyn Session>,
}

impl Asked {
    fn new(scenario: &str, model: &str, sweeps: u32) -> Self {
        let scene = Shipped::read(scenario, Some(sweeps));
        let model = HardwareModel::load(&ModelSource::BuiltIn(model.into()), &[], &[]).unwrap().model;
        let mut settings = front_door::settings(&scene.scenario, &model).unwrap();
        settings.shadow_cache = scene.settings.shadow_cache.clone();
        let stage = front_door::build(&scene.scenario, settings).unwrap();
        Self::of(scene, stage)
    }

    /// The same with a word that the model holds back.
    fn with_delay(&self, delay: LoadDelay) -> Self {
        let mut stage = self.stage.clone();
        stage.settings.loader.delays = vec![delay];
        Self::of(self.scene.clone(), stage)
    }

    fn of(scene: Shipped, stage: MachineStage) -> Self {
        let control = ControlPlane::new(stage.clone());
        let (twice, session) = (prepare_twice(stage.clone()), stage.clone().prepare());
        Self { scene, stage, control, twice, session }
    }

    fn pose(&self, frame: u64) -> Pose {
        let (update, yoke) = (self.stage.settings.timebase.update, self.stage.settings.yoke);
        let table =
            PoseTable::resolve(&self.scene.scenario, &self.stage.landscape, update, yoke, frame..frame + 1);
        table.unwrap().rows()[0].pose
    }

    /// The same with one load of a crater or else of a shadow boundary that is late in the frame: by a line just too slow.
    fn with_one_late(&self, frame: u64, is_crater: bool, policy: LatePolicy) -> Self {
        let (pose, [mut slow, mut fast]) = (self.pose(frame), [1e3_f64, 1e12]);
        for _ in 0..200 {
            let rate = (slow * fast).sqrt();
            let mut stage = self.stage.clone();
            stage.settings.loader.late_policy = policy;
            match is_crater {
                true => stage.settings.feature_words = Some(rate),
                false => stage.settings.segment_words = Some(rate),
            }
            match loads(&ControlPlane::new(stage.clone()), &stage, (frame, &pose), !is_crater).len() {
                1 => return Self::of(self.scene.clone(), stage),
                0 => fast = rate,
                _ => slow = rate,
            }
        }
        panic!("no rate makes a single load of frame {frame} late");
    }

    /// The same with lines that bring words of craters and of boundaries so many times as slowly: so few sweeps leave them time.
    fn with_slow_lines(&self, times: f64) -> Self {
        let mut stage = self.stage.clone();
        let settings = &mut stage.settings;
        for rate in [&mut settings.feature_words, &mut settings.segment_words] {
            *rate = rate.map(|rate| rate / times);
        }
        Self::of(self.scene.clone(), stage)
    }

    /// Every load of a crater or a shadow boundary in a frame that was late.
    fn loads(&self, frame: u64) -> Vec<LateWords> {
        loads(&self.control, &self.stage, (frame, &self.pose(frame)), true)
    }

    fn effect(&self, late: LateWords) -> Result<LateEffect, LateError> {
        let pose = self.pose(late.frame);
        let sweeps = match late.of {
            LateOf::Boundary(_) => self.control.sweeps_with_gates(late.frame, &pose),
            _ => self.control.sweeps(late.frame, &pose),
        };
        let sweeps = sweeps.unwrap();
        late_effect(&*self.twice, (&self.stage, &sweeps), &pose, late)
    }

    /// The picture of a frame, drawn whole.
    fn whole(&self, frame: u64) -> Vec<f32> {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        self.session.frame(frame, &self.pose(frame), &mut planes, &mut Probe::off()).unwrap();
        planes.get(PlaneKind::Intensity).unwrap().to_vec()
    }

    /// Every fold of a frame that found words missing.
    fn late(&self, frame: u64) -> Vec<LateWords> {
        let sweeps = self.control.sweeps(frame, &self.pose(frame)).unwrap();
        let of_sweep = |sweep: u32| {
            let programs = sweeps.programs(sweep);
            let of_level = programs.iter().enumerate().flat_map(|(level, program)| {
                let late =
                    move |crossing| LateWords { frame, sweep, of: LateOf::Crossing { level, crossing } };
                program.late_crossings().into_iter().map(late)
            });
            of_level.collect::<Vec<_>>()
        };
        (0..self.stage.settings.raster.sweeps).flat_map(of_sweep).collect()
    }

    /// Whether an explanation of a pixel that changed in the words' own frame names them.
    fn is_named(&self, told: &LateEffect) -> bool {
        let LateWords { frame, sweep, .. } = told.late;
        let Missed::Words(words) = &told.missed else { panic!("{:?} is no fold", told.late) };
        let inquiry = Inquiry::new(&self.stage, &*self.session, &self.control, None);
        let word = &words[0];
        let names = |late: &Late| {
            (late.crossing, late.level, late.colour) == (word.crossing, word.level, word.colour)
        };
        let is_named_at = |pixel: [usize; 2]| {
            let why = inquiry.explain(frame, &self.pose(frame), pixel).unwrap();
            why.read.iter().any(|read| read.sweep == sweep && read.late.iter().any(names))
        };
        let mut changed = told.frames[0].changed.pixels().to_vec();
        changed.sort_by(|a, b| b.by.abs().total_cmp(&a.by.abs()));
        changed.iter().any(|pixel| is_named_at([pixel.column, pixel.line]))
    }
}

/// Loads of craters, and `with_boundaries` of shadow boundaries, that were late in a frame.
fn loads(
    control: &ControlPlane,
    stage: &MachineStage,
    (frame, pose): (u64, &Pose),
    with_boundaries: bool,
) -> Vec<LateWords> {
    let sweeps =
        if with_boundaries { control.sweeps_with_gates(frame, pose) } else { control.sweeps(frame, pose) };
    let sweeps = sweeps.unwrap();
    let of_sweep = |sweep: u32| {
        let misses = sweeps.load_misses(sweep).into_iter();
        misses.map(move |miss| LateWords { frame, sweep, of: miss.of })
    };
    (0..stage.settings.raster.sweeps).flat_map(of_sweep).collect()
}

/// Pixels in which two pictures differ, by column and line.
fn differing(one: &[f32], other: &[f32], columns: usize) -> Vec<[usize; 2]> {
    let differ = (0..one.len()).filter(|&at| one[at] != other[at]);
    differ.map(|at| [at % columns, at / columns]).collect()
}

/// What is asked of some late words of a machine: `count` of `late`, or all if they are fewer, drawn by lot. The second picture is drawn whole, all sweeps again.
/// Returns how many pixels changed, and the explanations.
fn agree(asked: &Asked, mut late: Vec<LateWords>, count: usize, what: &str) -> (usize, Vec<LateEffect>) {
    let settings = &asked.stage.settings;
    let (columns, sweeps) = (settings.raster.columns as usize, settings.raster.sweeps);
    let mut dice = Dice::new(33);
    let (mut changed, mut all, mut wholes) = (0, Vec::new(), BTreeMap::new());
    for _ in 0..count.min(late.len()) {
        let late = late.swap_remove(dice.count(0, late.len() - 1));
        let told = asked.effect(late).unwrap();
        let shown = asked.twice.later(late.frame);
        assert_eq!(told.frames.len(), 1 + shown.len(), "{what}: {}", told.later);
        let on_time = OnTime { late, again: 0..sweeps };
        for effect in &told.frames {
            let pose = asked.pose(effect.frame);
            let [is, would_be] = asked.twice.twice(effect.frame, &pose, &on_time).unwrap();
            let [is, would_be] = [&is, &would_be].map(|planes| planes.get(PlaneKind::Intensity).unwrap());
            let whole = wholes.entry(effect.frame).or_insert_with(|| asked.whole(effect.frame));
            assert_eq!(is, whole, "{what}, frame {}: the machine as it is", effect.frame);
            let pixels: Vec<_> =
                effect.changed.pixels().iter().map(|pixel| [pixel.column, pixel.line]).collect();
            assert_eq!(pixels, differing(is, would_be, columns), "{what}, {late:?}");
            changed += pixels.len();
        }
        all.push(told);
    }
    eprintln!("{what}: {changed} pixels changed");
    (changed, all)
}

/// Words that parts make late: four or ten of each machine, drawn by lot.
#[test]
#[ignore = "long: .ci/long runs it"]
fn what_is_told_is_the_difference_of_whole_pictures() {
    let mut named = 0;
    // Each word on a tube that glows on takes eight pictures.
    for (scenario, model, frame, count) in [
        ("full-drive", "pra-nominal", 3, 10),
        ("descent", "pra-frugal", 20, 10),
        ("nominal-drive", "pra-overloaded", 17, 4),
    ] {
        let asked = Asked::new(scenario, model, 24);
        let what = format!("{scenario} on {model}");
        let (changed, all) = agree(&asked, asked.late(frame), count, &what);
        assert!(changed > 0, "{what}");
        for told in all.iter().filter(|told| !told.frames[0].changed.pixels().is_empty()) {
            let is_named = asked.is_named(told);
            // Its words change far ground alone, which this tube shows in pixels whose own sample is another: open.
            assert!(
                is_named || model == "pra-overloaded",
                "{what}, {:?}: no changed pixel names the words",
                told.late
            );
            named += usize::from(is_named);
        }
    }
    assert!(named >= 10, "{named} of 24 late words changed pixels and were named by one");
}

/// Words of craters and of shadow boundaries, of a machine whose banks share a drum and of one with a memory for each kind.
#[test]
#[ignore = "long: .ci/long runs it"]
fn what_is_told_of_craters_and_boundaries_is_the_difference_of_whole_pictures() {
    let mut changed = [0; 2];
    for (scenario, model, frame, count) in
        [("full-drive", "pra-nominal", 3, 5), ("nominal-drive", "pra-overloaded", 17, 3)]
    {
        let asked = Asked::new(scenario, model, 24).with_slow_lines(32.0);
        let all = asked.loads(frame);
        let (boundaries, craters): (Vec<_>, Vec<_>) =
            all.into_iter().partition(|late| matches!(late.of, LateOf::Boundary(_)));
        for (sum, (late, kind)) in changed.iter_mut().zip([(craters, "craters"), (boundaries, "boundaries")])
        {
            let what = format!("{scenario} on {model}, {} {kind}", late.len());
            *sum += agree(&asked, late, count, &what).0;
        }
    }
    assert!(changed.iter().all(|pixels| *pixels > 0), "pixels of craters and of boundaries: {changed:?}");
}

/// Loads over a line so fast that a single one of the frame is late, and the same machine whose loads take no time: two machines, two
/// pictures, no word of `twice`. Late words act from where they come, or not in their sweep.
#[test]
fn a_load_on_time_draws_the_machine_whose_loads_take_no_time() {
    let mut changed = 0;
    for (scenario, frame, is_crater) in
        [("craters", 4, true), ("full-drive", 3, false), ("full-drive", 40, false)]
    {
        let plain = Asked::new(scenario, "ideal", 48);
        let columns = plain.stage.settings.raster.columns as usize;
        let expected = plain.whole(frame);
        for policy in [LatePolicy::StrobeThrough, LatePolicy::Latched] {
            let asked = plain.with_one_late(frame, is_crater, policy);
            let late = asked.loads(frame)[0];
            let told = asked.effect(late).unwrap();
            let pixels: Vec<_> =
                told.frames[0].changed.pixels().iter().map(|pixel| [pixel.column, pixel.line]).collect();
            let what = format!("{scenario}, frame {frame}, {policy:?}, {late:?}");
            assert_eq!(pixels, differing(&asked.whole(frame), &expected, columns), "{what}");
            eprintln!("{what}: {} pixels", pixels.len());
            changed += usize::from(!pixels.is_empty());
            // Whoever names it by its neighbour is told which were late.
            let of = if is_crater { LateOf::Crater(u32::MAX) } else { LateOf::Boundary(u32::MAX) };
            let refused = asked.effect(LateWords { of, ..late }).unwrap_err().to_string();
            assert!(refused.contains("late in sweep"), "{refused}");
        }
    }
    assert!(changed >= 2, "{changed} of 6 late loads changed a pixel");
}

/// A word that the model holds back, and the same machine without that: two machines, two pictures, no word of `twice`.
#[test]
fn a_word_on_time_draws_the_machine_that_does_not_hold_it_back() {
    let mut dice = Dice::new(1970);
    for (scenario, frame) in [("full-drive", 2), ("descent", 20), ("craters", 10)] {
        let plain = Asked::new(scenario, "ideal", 48);
        let columns = plain.stage.settings.raster.columns as usize;
        let expected = plain.whole(frame);
        let sweeps = plain.control.sweeps(frame, &plain.pose(frame)).unwrap();
        let mut changed = 0;
        for _ in 0..5 {
            let sweep = dice.count(0, 47) as u32;
            let delay =
                LoadDelay { frame: Some(frame), sweep, ..some_delay(&sweeps.programs(sweep)[0], &mut dice) };
            let asked = plain.with_delay(delay);
            let late = asked.late(frame);
            assert_eq!(late.len(), 1, "{scenario}, {delay:?}: {late:?}");
            let told = asked.effect(late[0]).unwrap();
            let pixels: Vec<_> =
                told.frames[0].changed.pixels().iter().map(|pixel| [pixel.column, pixel.line]).collect();
            assert_eq!(pixels, differing(&asked.whole(frame), &expected, columns), "{scenario}, {delay:?}");
            assert_eq!((told.frames.len(), told.later.contains("no tube")), (1, true));
            changed += usize::from(!pixels.is_empty());
        }
        eprintln!("{scenario}: {changed} of 5 words held back changed pixels");
        assert!(changed > 0, "{scenario}");
    }
}

/// A word of a set that a fold of `program` transfers, held back from the fold that asks for it until a while after.
fn some_delay(program: &SweepProgram, dice: &mut Dice) -> LoadDelay {
    let folds: Vec<_> =
        program.steps.iter().filter_map(|step| Some((step.time.0, *step.kind.fold()?))).collect();
    loop {
        let due = dice.count(0, folds.len() - 1);
        let (time, fold) = folds[due];
        let colour = fold.colours()[dice.count(0, 1)];
        let asks = (0..due).rfind(|&earlier| folds[earlier].1.colours().contains(&colour));
        let Some(crossing) = asks else { continue };
        // 48 sweeps of 1000 samples and their retrace in a tenth of a second, at a tick a nanosecond: 2000 ticks a sample.
        let ticks = ((time - folds[crossing].0 + 40.0) * 2000.0) as u64;
        let (register, word) = (fold.axis.register(), dice.count(0, 8));
        return LoadDelay { frame: None, sweep: 0, crossing: crossing as u32, colour, register, word, ticks };
    }
}

#[test]
fn what_was_not_late_is_refused_and_late_ones_are_named() {
    let asked = Asked::new("descent", "pra-frugal", 48);
    let frame = 20;
    let late = asked.late(frame);
    let said = |late: LateWords| asked.effect(late).unwrap_err().to_string();
    let (first, sweep) = (late[0], late[0].sweep);
    let LateOf::Crossing { crossing, .. } = first.of else { panic!("{first:?} is no fold") };
    let at = |level: usize, crossing: u32| LateWords { of: LateOf::Crossing { level, crossing }, ..first };
    let not = (0..).find(|crossing| !late.contains(&at(0, *crossing))).unwrap();
    let beside = said(at(0, not));
    assert!(beside.starts_with(&format!("{sweep}:{not}: no word")), "{beside}");
    assert!(beside.contains(&format!("are crossings {crossing}")), "{beside}");
    let beyond = said(at(0, 100_000));
    assert!(beyond.contains("has crossings 0.."), "{beyond}");
    assert!(said(LateWords { sweep: 48, ..first }).contains("sweeps 0..48"));
    assert!(said(at(1, crossing)).contains("one level of terrain"));
    let ideal = Asked::new("descent", "ideal", 48);
    let none = ideal.effect(first).unwrap_err().to_string();
    assert!(none.contains("none of frame 20"), "{none}");
}
