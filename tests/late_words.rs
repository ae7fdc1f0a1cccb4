//! Late words forwards: the pixels told are those in which pictures drawn whole differ, and a pixel told names its words.

use std::collections::BTreeMap;

use control_plane::{ControlPlane, LateCrossing, MachineStage};
use explain::{Inquiry, Late, LateEffect, LateError, late_effect};
use generator::{PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, LoadDelay, ModelSource};
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

    fn effect(&self, late: LateCrossing) -> Result<LateEffect, LateError> {
        late_effect(&*self.twice, (&self.stage, &self.control), &self.pose(late.frame), late)
    }

    /// The picture of a frame, drawn whole.
    fn whole(&self, frame: u64) -> Vec<f32> {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        self.session.frame(frame, &self.pose(frame), &mut planes, &mut Probe::off()).unwrap();
        planes.get(PlaneKind::Intensity).unwrap().to_vec()
    }

    /// Every fold of a frame that found words missing.
    fn late(&self, frame: u64) -> Vec<LateCrossing> {
        let sweeps = self.control.sweeps(frame, &self.pose(frame)).unwrap();
        let of_sweep = |sweep: u32| {
            let programs = sweeps.programs(sweep);
            let of_level = programs.iter().enumerate().flat_map(|(level, program)| {
                let late = move |crossing| LateCrossing { frame, sweep, level, crossing };
                program.late_crossings().into_iter().map(late)
            });
            of_level.collect::<Vec<_>>()
        };
        (0..self.stage.settings.raster.sweeps).flat_map(of_sweep).collect()
    }

    /// Whether an explanation of a pixel that changed in the words' own frame names them.
    fn is_named(&self, told: &LateEffect) -> bool {
        let LateCrossing { frame, sweep, crossing, .. } = told.late;
        let inquiry = Inquiry::new(&self.stage, &*self.session, &self.control, None);
        let word = &told.words[0];
        let names =
            |late: &Late| (late.crossing, late.level, late.colour) == (crossing, word.level, word.colour);
        let is_named_at = |pixel: [usize; 2]| {
            let why = inquiry.explain(frame, &self.pose(frame), pixel).unwrap();
            why.read.iter().any(|read| read.sweep == sweep && read.late.iter().any(names))
        };
        let mut changed = told.frames[0].changed.pixels().to_vec();
        changed.sort_by(|a, b| b.by.abs().total_cmp(&a.by.abs()));
        changed.iter().any(|pixel| is_named_at([pixel.column, pixel.line]))
    }
}

/// Pixels in which two pictures differ, by column and line.
fn differing(one: &[f32], other: &[f32], columns: usize) -> Vec<[usize; 2]> {
    let differ = (0..one.len()).filter(|&at| one[at] != other[at]);
    differ.map(|at| [at % columns, at / columns]).collect()
}

/// Words that parts make late: ten of each machine, drawn by lot. The second picture is drawn whole, all sweeps again.
#[test]
fn what_is_told_is_the_difference_of_whole_pictures() {
    let mut named = 0;
    let sweeps = 48;
    for (scenario, model, frame) in [
        ("full-drive", "pra-nominal", 3),
        ("descent", "pra-frugal", 20),
        ("nominal-drive", "pra-overloaded", 17),
    ] {
        let asked = Asked::new(scenario, model, sweeps);
        let columns = asked.stage.settings.raster.columns as usize;
        let mut late = asked.late(frame);
        let mut dice = Dice::new(33);
        let mut changed = 0;
        let mut wholes = BTreeMap::new();
        for _ in 0..10 {
            let late = late.swap_remove(dice.count(0, late.len() - 1));
            let told = asked.effect(late).unwrap();
            let shown = asked.twice.later(frame);
            assert_eq!(told.frames.len(), 1 + shown.len(), "{scenario}: {}", told.later);
            let on_time = OnTime { late, again: 0..sweeps };
            for effect in &told.frames {
                let pose = asked.pose(effect.frame);
                let [is, would_be] = asked.twice.twice(effect.frame, &pose, &on_time).unwrap();
                let [is, would_be] = [&is, &would_be].map(|planes| planes.get(PlaneKind::Intensity).unwrap());
                let whole = wholes.entry(effect.frame).or_insert_with(|| asked.whole(effect.frame));
                assert_eq!(is, whole, "{scenario}, frame {}: the machine as it is", effect.frame);
                let pixels: Vec<_> =
                    effect.changed.pixels().iter().map(|pixel| [pixel.column, pixel.line]).collect();
                assert_eq!(pixels, differing(is, would_be, columns), "{scenario}, {late:?}");
                changed += pixels.len();
            }
            if !told.frames[0].changed.pixels().is_empty() {
                let is_named = asked.is_named(&told);
                // Its words change far ground alone, which this tube shows in pixels whose own sample is another: open.
                assert!(
                    is_named || model == "pra-overloaded",
                    "{scenario}, {late:?}: no changed pixel names the words"
                );
                named += usize::from(is_named);
            }
        }
        eprintln!("{scenario} on {model}: {changed} pixels changed, {named} words named so far");
        assert!(changed > 0, "{scenario} on {model}");
    }
    assert!(named >= 10, "{named} of 30 late words changed pixels and were named by one");
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
        for _ in 0..10 {
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
        eprintln!("{scenario}: {changed} of 10 words held back changed pixels");
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
    let said = |late: LateCrossing| asked.effect(late).unwrap_err().to_string();
    let first = late[0];
    let not = (0..).find(|crossing| !late.contains(&LateCrossing { crossing: *crossing, ..first })).unwrap();
    let beside = said(LateCrossing { crossing: not, ..first });
    assert!(beside.starts_with(&format!("{}:{not}: no word", first.sweep)), "{beside}");
    assert!(beside.contains(&format!("are crossings {}", first.crossing)), "{beside}");
    let beyond = said(LateCrossing { crossing: 100_000, ..first });
    assert!(beyond.contains("has crossings 0.."), "{beyond}");
    assert!(said(LateCrossing { sweep: 48, ..first }).contains("sweeps 0..48"));
    assert!(said(LateCrossing { level: 1, ..first }).contains("one level of terrain"));
    let ideal = Asked::new("descent", "ideal", 48);
    let none = ideal.effect(first).unwrap_err().to_string();
    assert!(none.contains("none of frame 20"), "{none}");
}
