//! Sweep programs of both terrain generators: what the signal plane runs and what the timing record is made of.

use crate::stage::MachineStage;
use dpu::{CrossingService, MissingCorner, Watch};
use feature_generator::FeatureProgram;
use hardware_model::{Loader, Settings};
use landscape::Level;
use sweep_generator::RangeTable;
use sweep_program::SweepProgram;

use crate::absent::AbsentCrater;
use crate::blocks::Coarse;
use crate::feature_loads::FeatureLoads;
use crate::frame_plan::FramePlan;
use crate::late_words::LateOf;

/// The service of the crossings in one frame.
#[derive(Debug, Clone, Copy)]
pub struct Crossings<'a> {
    /// Ground, scenery and settings.
    pub stage: &'a MachineStage,
    /// The second terrain generator, if it is there.
    pub coarse: Option<&'a Coarse>,
    /// Ground range of each sample, by the ground-range programme.
    pub table: &'a RangeTable,
    /// Fan, eye and sun of the frame.
    pub plan: &'a FramePlan,
    /// Corners that are not in the storage buffer of the fine and of the coarse level.
    pub missing: [&'a [MissingCorner]; 2],
    /// Ticks from the start of each sweep in which a processor that serves the crossings is at a set-up that no interrupt
    /// breaks; empty if there are none.
    pub held: &'a [u64],
    /// Craters that are not in the storage buffer as the frame begins, ascending.
    pub absent_craters: &'a [AbsentCrater],
}

impl<'a> Crossings<'a> {
    /// Writes the program of the fine level for sweep `sweep`, which is drawn with the set-up of sweep `drawn`.
    pub fn write_fine(&self, [drawn, sweep]: [u32; 2], program: &mut SweepProgram, watch: &mut impl Watch) {
        let Settings { range, loader, .. } = &self.stage.settings;
        let level = self.stage.landscape.level();
        let far = self.coarse.map_or(range.end, |_| self.plan.switch.range);
        let end = self.plan.way_to_edge(drawn, level).min(far).min(range.end);
        let service = self.service(sweep, level, loader, self.missing[0]);
        self.plan.write_program([drawn, sweep], &service, self.table, end, program, watch);
        self.bring_on_time(sweep, 0, program);
    }

    /// The same for the coarse level.
    pub fn write_coarse(
        &self,
        coarse: &Coarse,
        [drawn, sweep]: [u32; 2],
        program: &mut SweepProgram,
        watch: &mut impl Watch,
    ) {
        let level = &self.stage.landscape.bank().levels()[1];
        let end = self.plan.way_to_edge(drawn, level).min(self.stage.settings.range.end);
        let service = self.service(sweep, level, &coarse.loader, self.missing[1]);
        self.plan.write_program([drawn, sweep], &service, self.table, end, program, watch);
        self.bring_on_time(sweep, 1, program);
    }

    /// Craters that sweep `sweep`, drawn with the set-up of sweep `drawn`, meets up to ground range `end` (m), and their loads.
    pub fn feature_program(&self, [drawn, sweep]: [u32; 2], end: f64) -> FeatureProgram {
        let &Self { stage, table, plan, absent_craters: absent, .. } = self;
        let mut program = FeatureProgram::default();
        FeatureLoads { stage, table, plan, among: None, absent }.write([drawn, sweep], end, &mut program);
        program
    }

    /// Brings late words on time where the plan asks for it, in the program of `level` for `sweep`.
    fn bring_on_time(&self, sweep: u32, level: usize, program: &mut SweepProgram) {
        match self.plan.late_of(sweep) {
            Some(LateOf::Crossing { level: asked, crossing }) if asked == level => {
                program.bring_on_time(crossing);
            }
            _ => {}
        }
    }

    fn service(
        &self,
        sweep: u32,
        level: &'a Level,
        loader: &'a Loader,
        missing: &'a [MissingCorner],
    ) -> CrossingService<'a> {
        let Settings { cpu, timebase, seed, .. } = &self.stage.settings;
        let held = self.held.get(sweep as usize).copied().unwrap_or(0);
        CrossingService { level, loader, cpu, timebase, missing, held, seed: *seed }
    }
}
