//! Craters of a sweep and the loads of their words.

use crate::stage::MachineStage;
use feature_generator::{CRATER_WORDS, FeatureProgram, Schedule};
use hardware_model::{BankPlace, LatePolicy, Settings};
use quantities::SweepTime;
use sweep_generator::RangeTable;
use sweep_program::{LoadLine, LoadTiming};

use crate::absent::AbsentCrater;
use crate::frame_plan::FramePlan;
use crate::late_words::LateOf;
use crate::ticks::start_of;

/// The schedule of the feature generator in one frame.
#[derive(Debug, Clone, Copy)]
pub struct FeatureLoads<'a> {
    /// Ground, scenery and settings.
    pub stage: &'a MachineStage,
    /// Ground range of each sample, by the ground-range programme.
    pub table: &'a RangeTable,
    /// Fan, eye and sun of the frame.
    pub plan: &'a FramePlan,
    /// The craters that the sweeps can meet, where they are known.
    pub among: Option<&'a [u32]>,
    /// Craters that are not in the storage buffer as the frame begins, ascending.
    pub absent: &'a [AbsentCrater],
}

impl FeatureLoads<'_> {
    /// Writes the program for sweep `sweep`, which is drawn with the set-up of sweep `drawn` up to ground range `end` (m).
    pub fn write(&self, [drawn, sweep]: [u32; 2], end: f64, program: &mut FeatureProgram) {
        let eye = [self.plan.eye[0], self.plan.eye[1]];
        let span = [self.table.ranges()[0], end];
        let start = start_of(self.stage, self.plan.frame, sweep);
        let lacks = |absent: &&AbsentCrater| absent.comes.is_none_or(|comes| comes > start);
        let absent: Vec<u32> = self.absent.iter().filter(lacks).map(|absent| absent.crater).collect();
        self.schedule(&absent).write_by(eye, self.plan.direction(drawn), span, self.timing(sweep), program);
    }

    fn schedule<'b>(&'b self, absent: &'b [u32]) -> Schedule<'b> {
        let landscape = &self.stage.landscape;
        let level = landscape.level();
        Schedule {
            features: landscape.features(),
            parts: self.stage.settings.feature_generator,
            region_origin: level.origin(),
            region_size: level.region_size(),
            among: self.among,
            absent,
        }
    }

    /// Whether loads take time, sub-generators run out, or craters lie on drums.
    pub fn is_limited(stage: &MachineStage) -> bool {
        let settings = &stage.settings;
        settings.feature_words.is_some()
            || settings.feature_generator.sub_generators.is_some()
            || settings.kind_banks.features.place != BankPlace::Local
    }

    /// Whether any crater can come late, or find no sub-generator.
    pub fn can_miss(stage: &MachineStage) -> bool {
        Self::is_limited(stage) && !stage.landscape.features().is_empty()
    }

    /// Where the model has a rate, the words of a sweep come one after another.
    fn timing(&self, sweep: u32) -> Option<LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>> {
        let rate = self.stage.settings.feature_words?;
        let on_time = self.plan.late_of(sweep).and_then(LateOf::crater);
        Some(load_timing(self.stage, self.table, (self.plan.frame, sweep), (CRATER_WORDS, rate), on_time))
    }
}

/// Loads of so many words at a rate (words a second) in one sweep of a frame, of which that numbered `on_time` is taken as in time.
pub(crate) fn load_timing<'a>(
    stage: &MachineStage,
    table: &'a RangeTable,
    place: (u64, u32),
    (words, rate): (u32, f64),
    on_time: Option<u32>,
) -> LoadTiming<impl Fn(f64) -> SweepTime + use<'a>, impl Fn(SweepTime) -> f64 + use<'a>> {
    let Settings { timebase, loader, .. } = &stage.settings;
    LoadTiming {
        line: LoadLine::new(timebase, place, words, rate),
        strobes_through: loader.late_policy == LatePolicy::StrobeThrough,
        time_of: |range| table.time_of(range),
        range_at: |time| table.range_at(time),
        on_time,
    }
}
