//! Loader, processor and drums.

use std::f64::consts::PI;

use quantities::radians;

use super::{CrossingBudget, GroundScale, SET, SETS_LOADED, SweepBudget};
use crate::{Cpu, CrossingServer, Drum, HardwareModel, IoProcessor, Loader};

/// Share of a region by which a set may be late before it shows (hardware section 4.5).
const GRACE: f64 = 0.1;
/// Width of the field of view (degrees) and fastest turn of the rover (degrees/s), a reading of a damaged scan
/// (section 3).
const FIELD_DEG: f64 = 50.0;
const TURN_DEG_S: f64 = 10.0;

/// The way of coefficient words (hardware sections 4.4 and 4.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoaderBudget {
    /// From a fold to the arrival of the set that may be wanted at once, at worst (s).
    pub urgent: f64,
    /// Lateness that does not show (s).
    pub grace: f64,
    /// Urgent sets that come after the next stop of the other axis, a sweep, mean over azimuth; none with a register
    /// that holds the corner beyond both stops.
    pub late: f64,
    /// Share of the difference between stale and new words that the height steps by at most, `S0(v t / d)`.
    pub step: f64,
    /// Time that the sets of one sweep occupy the buffer, with pointers and accesses (s); of four banks, the mean.
    pub busy: f64,
    /// The same as a share of the drawn part of the sweep.
    pub load: f64,
}

impl LoaderBudget {
    pub(super) fn of(
        model: &HardwareModel,
        ground: GroundScale,
        sweep: &SweepBudget,
        crossings: &CrossingBudget,
    ) -> Self {
        let loader = &model.loader;
        let urgent = model.seconds(before_first_set(loader, &model.cpu) + urgent_ticks(loader));
        let share = urgent / crossings.axis;
        let expected = ground.range / ground.region_size * share * 2.0 / PI;
        let banks = if loader.served_by == CrossingServer::WiredPointers { 4.0 } else { 1.0 };
        let order = loader.channel_programme().order;
        let crossing = model.seconds(order) + SETS_LOADED * model.seconds(set_ticks(loader));
        let busy = crossings.mean * crossing / banks;
        Self {
            urgent,
            grace: GRACE * crossings.axis,
            late: if loader.diagonal_register { 0.0 } else { expected.min(crossings.mean) },
            step: step(share.min(1.0)),
            busy,
            load: busy / sweep.active,
        }
    }
}

/// Height step of a late set, S0 of hardware section 4.5.
fn step(e: f64) -> f64 {
    e * e * e * (10.0 - 15.0 * e + 6.0 * e * e)
}

fn set_ticks(loader: &Loader) -> u64 {
    let IoProcessor { chain, edit, .. } = loader.channel_programme();
    let accesses = u64::from(9_u32.div_ceil(loader.words_per_access)) * loader.access;
    chain + loader.pointer + accesses + SET as u64 * edit
}

/// Without precedence the urgent set may be the last: of two in its colour's bank, or of four.
fn urgent_ticks(loader: &Loader) -> u64 {
    let before = match (loader.urgent_first, loader.served_by) {
        (true, _) => 0,
        (false, CrossingServer::WiredPointers) => 1,
        (false, _) => 3,
    };
    (1 + before) * set_ticks(loader) + loader.strobe
}

/// From a fold to the first set, at worst: an interrupt to be served, or the order to an I/O processor.
fn before_first_set(loader: &Loader, cpu: &Cpu) -> u64 {
    match loader.served_by {
        CrossingServer::CpuInterrupt => cpu.longest_instruction.max(unbroken(cpu)) + cpu.crossing(),
        CrossingServer::IoProcessor => loader.io_processor.order,
        CrossingServer::WiredPointers => 0,
    }
}

/// The set-up that an interrupt may have to wait for.
fn unbroken(cpu: &Cpu) -> u64 {
    if cpu.has_one_level() { cpu.sweep_setup } else { 0 }
}

/// Shares of the processor's time (hardware section 4.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CpuBudget {
    /// Share for the set-up of sweeps.
    pub sweep_setup: f64,
    /// Visibility and tables of frames.
    pub frame_tables: f64,
    /// One crossing by interrupt, without its words (s), whoever serves the crossings.
    pub crossing: f64,
    /// Interrupts of crossings, without the words; 0 where others serve them.
    pub interrupts: f64,
    /// Words of crossings: moved by its program, or memory cycles that others take from it for them.
    pub loads: f64,
    /// Sum of the shares `sweep_setup`, `frame_tables`, `interrupts` and `loads`.
    pub total: f64,
    /// A hundred vertices of polyhedra, beside them.
    pub hundred_vertices: f64,
}

impl CpuBudget {
    pub(super) fn of(
        model: &HardwareModel,
        sweep: &SweepBudget,
        crossings: &CrossingBudget,
        loader: &LoaderBudget,
    ) -> Self {
        let cpu = &model.cpu;
        let sweep_setup = model.seconds(cpu.sweep_setup) / sweep.period;
        let frame_tables = model.seconds(cpu.frame_tables) / sweep.frame;
        let serves = model.loader.served_by == CrossingServer::CpuInterrupt;
        let if_it_serves = |time: f64| if serves { time / sweep.period } else { 0.0 };
        let crossing = model.seconds(cpu.crossing());
        let interrupts = if_it_serves(crossings.mean * crossing);
        let stolen = crossings.mean * model.seconds(cpu.stolen((SETS_LOADED * SET) as u64)) / sweep.period;
        let loads = if serves { if_it_serves(loader.busy) } else { stolen };
        Self {
            sweep_setup,
            frame_tables,
            crossing,
            interrupts,
            loads,
            total: sweep_setup + frame_tables + interrupts + loads,
            hundred_vertices: 100.0 * model.seconds(cpu.vertex) / sweep.frame,
        }
    }
}

/// Drums of one level (hardware section 4.7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrumBudget {
    /// Corners of the regions that the field of view touches.
    pub corners: f64,
    /// Words of these corners: nine each.
    pub words: f64,
    /// Time to transfer them all, after a snap turn (s), without latency.
    pub fill: f64,
    /// New corners a second in the fastest turn of the rover, 10 degrees/s.
    pub turning: f64,
    /// Share of the drums' time that this takes with records fetched one by one.
    pub load: f64,
}

impl DrumBudget {
    pub(super) fn of(model: &HardwareModel, ground: GroundScale) -> Option<Self> {
        let Drum { rotation, word, record_words, count, .. } = model.data_banks.drum?;
        let channels = model.data_banks.channels;
        let word = word.max(channels.word);
        let at_once = channels.count.map_or(count, |channels| channels.min(count));
        let words = SET * sector_corners(ground);
        let seconds = |ticks: f64| ticks / model.master_clock.hertz();
        let ratio = ground.range / ground.region_size;
        let turning = 0.5 * ratio * ratio * radians(TURN_DEG_S);
        let record = f64::from(record_words);
        let fetch = seconds(0.5 * rotation as f64 + record * word);
        Some(Self {
            corners: words / SET,
            words,
            fill: seconds(words * word) / f64::from(at_once),
            turning,
            load: turning * SET / record * fetch / f64::from(count),
        })
    }
}

/// Corners of all regions that a sector of the field of view touches, mean over place and heading. A corner belongs
/// to one if the sector meets the square of two regions around it: the area of a Minkowski sum, in regions.
pub(crate) fn sector_corners(ground: GroundScale) -> f64 {
    let (radius, angle) = (ground.range / ground.region_size, radians(FIELD_DEG));
    let area = 0.5 * angle * radius * radius;
    let perimeter = (2.0 + angle) * radius;
    area + 4.0 * perimeter / PI + 4.0
}
