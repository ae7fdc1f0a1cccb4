//! The sweeps of one frame, as the digital side makes them.

use std::borrow::Cow;

use crate::stage::MachineStage;
use generator::FrameError;
use hardware_model::{Loader, Settings, SweepMemoryKind};
use quantities::{SweepClock, SweepTime, Tick};
use scenario::Pose;
use shadow_controller::Gate;
use sweep_generator::RangeTable;
use sweep_memory::View;
use sweep_program::SweepProgram;

use crate::blocks::Coarse;
use crate::control_plane::ControlPlane;
use crate::crossings::Crossings;
use crate::data_kind::DataKind;
use crate::delivery::{Delivery, ShadowBoundary, Supply};
use crate::digital::{DigitalFrame, crossing_times};
use crate::frame_plan::FramePlan;
use crate::raster::WrittenRaster;
use crate::sight::vertices;
use crate::squares::SquareGrid;

/// Sweep programs of one frame: with the set-ups that are ready and the corners that are there.
#[derive(Debug)]
pub struct FrameSweeps<'a> {
    stage: Cow<'a, MachineStage>,
    coarse: Option<Coarse>,
    table: &'a RangeTable,
    plan: FramePlan,
    digital: DigitalFrame,
    /// Shadow gates of all sweeps, if they were asked for.
    pub(crate) gates: Vec<Gate>,
}

impl ControlPlane {
    /// The programs by which sweep `sweep` of frame `frame` is drawn: that of the fine level, then that of the coarse
    /// one where there is one.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn programs(&self, frame: u64, pose: &Pose, sweep: u32) -> Result<Vec<SweepProgram>, FrameError> {
        Ok(self.sweeps(frame, pose)?.programs(sweep))
    }

    /// All sweeps of frame `frame` with their shadow gates, whose boundaries their events then tell as well.
    ///
    /// # Errors
    /// If the pose cannot be drawn, or the shadow cache not be kept.
    pub fn sweeps_with_gates(&self, frame: u64, pose: &Pose) -> Result<FrameSweeps<'_>, FrameError> {
        let sweeps = self.sweeps(frame, pose)?;
        let gates = self.shadow_gates(&sweeps, pose.time)?;
        Ok(FrameSweeps { gates, ..sweeps })
    }

    /// All sweeps of frame `frame`: what the frame has in common is worked out once.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn sweeps(&self, frame: u64, pose: &Pose) -> Result<FrameSweeps<'_>, FrameError> {
        self.sweeps_of(Cow::Borrowed(self.stage()), frame, pose)
    }

    /// The same behind another loader, all else as it is.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn sweeps_behind(
        &self,
        loader: &Loader,
        frame: u64,
        pose: &Pose,
    ) -> Result<FrameSweeps<'_>, FrameError> {
        let stage = self.stage().clone();
        let settings = Settings { loader: loader.clone(), ..stage.settings };
        self.sweeps_of(Cow::Owned(MachineStage { settings, ..stage }), frame, pose)
    }

    /// Shadow gates of all sweeps.
    ///
    /// # Errors
    /// If the shadow cache cannot be kept.
    pub(crate) fn shadow_gates(&self, sweeps: &FrameSweeps<'_>, time: f64) -> Result<Vec<Gate>, FrameError> {
        let supply = self.supply(sweeps);
        let gates = supply.shadow_gates(time);
        supply.check_cache()?;
        Ok(gates)
    }

    /// Boundaries of shadow on the ground, of which the gates at `time` (s) are made.
    pub fn shadow_lines(&self, sweeps: &FrameSweeps<'_>, time: f64) -> Vec<ShadowBoundary> {
        self.supply(sweeps).shadow_lines(time)
    }

    /// What the I/O processors bring for the frame of `sweeps` at `time` (s).
    pub fn delivery(&self, sweeps: &FrameSweeps<'_>, time: f64) -> Delivery {
        let mut delivery = Delivery::default();
        self.supply(sweeps).deliver(time, &mut delivery);
        delivery
    }

    fn supply<'a>(&'a self, sweeps: &'a FrameSweeps<'_>) -> Supply<'a> {
        Supply {
            stage: self.stage(),
            blocks: self.blocks(),
            footings: self.footings(),
            plan: sweeps.plan(),
            raster: *self.raster(),
            table: self.table(),
            ready: sweeps.digital().ready_vertices(),
            absent_shadows: sweeps.digital().absent_shadows.as_ref(),
            absent_bodies: &sweeps.digital().absent_bodies,
            gated: 0..sweeps.plan().fan.sweeps,
        }
    }

    fn sweeps_of<'a>(
        &'a self,
        stage: Cow<'a, MachineStage>,
        frame: u64,
        pose: &Pose,
    ) -> Result<FrameSweeps<'a>, FrameError> {
        let plan = self.plan(frame, pose)?;
        let coarse = self.blocks().coarse.as_ref().map(|_| Coarse::new(&stage.settings.loader));
        let table = self.table();
        let mut sweeps =
            FrameSweeps { stage, coarse, table, plan, digital: DigitalFrame::default(), gates: Vec::new() };
        let wanted = vertices(&sweeps.stage, self.blocks(), &sweeps.plan, pose.time);
        sweeps.digital = self.digital_of(&sweeps.crossings(), wanted);
        Ok(sweeps)
    }
}

impl FrameSweeps<'_> {
    /// The programs of one sweep: fine level, then the coarse one where there is one.
    pub fn programs(&self, sweep: u32) -> Vec<SweepProgram> {
        let mut programs = Vec::new();
        self.write_programs(sweep, &mut programs);
        programs
    }

    /// The same into `programs`, whose buffers are used again.
    pub fn write_programs(&self, sweep: u32, programs: &mut Vec<SweepProgram>) {
        let (crossings, sweeps) = (self.crossings(), [self.set_up_of(sweep), sweep]);
        programs.resize_with(1 + usize::from(self.coarse.is_some()), SweepProgram::idle);
        crossings.write_fine(sweeps, &mut programs[0], &mut ());
        if let Some(coarse) = &self.coarse {
            crossings.write_coarse(coarse, sweeps, &mut programs[1], &mut ());
        }
    }

    /// Direction over the ground that sweep `sweep` should have, whatever set-up it is drawn with: unit vector, north and
    /// east.
    pub fn direction(&self, sweep: u32) -> [f64; 2] {
        self.plan.direction(sweep)
    }

    /// The shadow gate of a sweep, if gates were asked for.
    pub fn gate(&self, sweep: u32) -> Option<&Gate> {
        self.gates.get(sweep as usize)
    }

    /// The shadow gate with which a sweep is drawn: that of its set-up, if gates were asked for.
    pub(crate) fn drawn_gate(&self, sweep: u32) -> Option<&Gate> {
        self.gate(self.set_up_of(sweep))
    }

    /// Shadow boundaries that the gates of all sweeps were given, and crossings that united with others and are none; 0
    /// where no gates were asked for.
    pub fn shadow_edges(&self) -> [u64; 2] {
        let sum = |of: fn(&Gate) -> u64| self.gates.iter().map(of).sum();
        [sum(|gate| gate.toggles.len() as u64 + u64::from(gate.dropped)), sum(|gate| u64::from(gate.united))]
    }

    /// Where the centre of pixel (column, line) of the picture lies in what the sweeps wrote: sweep and cell of the sweep,
    /// whole numbers at their centres; beyond the first or last there is nothing.
    pub fn place_of(&self, pose: &Pose, pixel: [usize; 2]) -> [f64; 2] {
        let Settings { raster, laws, sweep_memory, yoke, .. } = &self.stage.settings;
        let size = [raster.columns as usize, raster.lines as usize];
        let written = WrittenRaster::new(&self.stage.settings);
        let tube = *sweep_memory == SweepMemoryKind::ScanConverter;
        let view = View {
            fan: self.plan.fan,
            projection: laws.projection,
            pitch: self.plan.pitch,
            raster: written.field,
            field: raster.field,
            yoke: if yoke.is_some() { pose.yoke } else { 0.0 },
        };
        view.source(size, written.lines, pixel, tube)
    }

    /// Where the read beam finds what pixel (column, line) shows: [`place_of`](Self::place_of), beside it where the tube is not read
    /// where it was written.
    pub fn read_at(&self, pose: &Pose, pixel: [usize; 2]) -> [f64; 2] {
        let Settings { raster, analog, seed, .. } = &self.stage.settings;
        let tube = WrittenRaster::new(&self.stage.settings).on_tube(raster.sweeps);
        tube.read_at(&analog.memory, *seed, self.plan.frame, self.place_of(pose, pixel))
    }

    /// Whether a crater, by its number in the list, is in no storage buffer as `sweep` begins.
    pub fn lacks_crater(&self, crater: u32, sweep: u32) -> bool {
        let start = self.clock(sweep).tick_at_or_after(SweepTime(0.0));
        let absent = &self.digital.absent_craters;
        let found = absent.binary_search_by_key(&crater, |absent| absent.crater);
        found.is_ok_and(|index| absent[index].comes.is_none_or(|comes| comes > start))
    }

    /// Whether the boundaries of shadow in the square of a place (north, east; m) are in no storage buffer as `sweep` begins.
    pub fn lacks_shadows(&self, place: [f64; 2], sweep: u32) -> bool {
        let start = self.clock(sweep).tick_at_or_after(SweepTime(0.0));
        self.digital.absent_shadows.as_ref().is_some_and(|absent| absent.lacks(place, start))
    }

    /// Cells of a sweep: its lines, or finer ones where the yoke turns the picture.
    pub fn cells(&self) -> usize {
        WrittenRaster::new(&self.stage.settings).lines
    }

    /// The sweep whose set-up `sweep` is drawn with: itself, or an earlier one if its own is not ready.
    pub fn set_up_of(&self, sweep: u32) -> u32 {
        self.digital.drawn(sweep)
    }

    /// What the crossings of each sweep take of the processor (ticks); empty if they never take anything.
    pub fn crossing_ticks(&self) -> Vec<u64> {
        crossing_times(&self.crossings()).iter().map(|taken| taken.interrupts + taken.words).collect()
    }

    /// Vertices of polyhedra that the frame asks the processor for.
    pub fn vertices_asked(&self) -> u64 {
        self.digital.vertices
    }

    /// The loader that the sweeps run behind.
    pub fn loader(&self) -> &Loader {
        &self.stage.settings.loader
    }

    /// The clock of a sweep.
    pub(crate) fn clock(&self, sweep: u32) -> SweepClock {
        self.stage.settings.timebase.sweep_clock(self.plan.frame, sweep)
    }

    /// The tick that an instant of a sweep was made from: turned back half a tick earlier, rounding makes it no other.
    pub(crate) fn tick_of(&self, sweep: u32, time: SweepTime) -> Tick {
        let half = 0.5 / self.stage.settings.timebase.ticks_per_sample();
        self.clock(sweep).tick_at_or_after(SweepTime(time.0 - half))
    }

    /// The ground-range programme of every sweep.
    pub fn table(&self) -> &RangeTable {
        self.table
    }

    /// The squares of a kind beside terrain that has a bank.
    pub(crate) fn grid(&self, kind: DataKind) -> Option<SquareGrid> {
        let found = self.digital.grids.iter().find(|(known, _)| *known == kind);
        found.map(|&(_, grid)| grid)
    }

    pub(crate) fn plan(&self) -> &FramePlan {
        &self.plan
    }

    pub(crate) fn digital(&self) -> &DigitalFrame {
        &self.digital
    }

    /// The service of the crossings, with what is missing.
    pub(crate) fn crossings(&self) -> Crossings<'_> {
        Crossings {
            stage: &self.stage,
            coarse: self.coarse.as_ref(),
            table: self.table,
            plan: &self.plan,
            missing: self.digital.missing(),
            held: &self.digital.held,
            absent_craters: &self.digital.absent_craters,
        }
    }
}
