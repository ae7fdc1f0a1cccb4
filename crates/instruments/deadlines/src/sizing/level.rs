//! Figures of one level of terrain, sweep by sweep.

use hardware_model::{Budget, GroundScale};
use machine::FrameSweeps;
use machine::MachineStage;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use sweep_program::{Event, Miss, SweepProgram};

use super::tear::TearLaw;
use crate::Rehearsal;
use crate::levels::{DrawnLevel, drawn_levels};
use crate::sets::{AskedSet, crossings, sets_of};

/// What the sweeps of some frames did over one level, and what the formulas say.
pub struct LevelFigures {
    pub name: &'static str,
    /// Side of a region (m).
    pub region_size: f64,
    /// Ground range of a sweep, mean (m).
    pub range: f64,
    pub frames: u64,
    pub sweeps: u64,
    /// Folds: mean, least and most of a sweep.
    pub crossings: [f64; 3],
    /// The same by formula at the azimuth of each sweep, mean.
    pub crossings_at_azimuths: f64,
    /// Sets used and sets brought, in all.
    pub used: u64,
    pub brought: u64,
    /// From fold to urgent set: mean and most (s); none if none was brought.
    pub urgent: Option<[f64; 2]>,
    /// Urgent sets late, all sets late, those that show: in all.
    pub late_urgent: u64,
    pub late: u64,
    pub seen: u64,
    /// Urgent sets that come late by formula, at the azimuth and range programme of each sweep, in all.
    pub late_expected: f64,
    /// The formulas of section 4 over this ground.
    pub budget: Budget,
    /// One tick of the master clock (s), 0 where words are wired through.
    pub tick: f64,
}

/// Figures of one sweep, before they are averaged.
#[derive(Default)]
struct SweepFigures {
    range: f64,
    crossings: u64,
    at_azimuth: f64,
    direction: [f64; 2],
    used: u64,
    brought: u64,
    /// Number, sum and most of the latencies of urgent sets (samples).
    urgent: (u64, f64, f64),
    late_urgent: u64,
    late: u64,
    seen: u64,
}

impl LevelFigures {
    /// Runs all sweeps of the frames, by all threads of the current pool: the figures of each level.
    pub fn measure(rehearsal: &Rehearsal, frames: &[FrameSweeps<'_>], law: &TearLaw) -> Vec<Self> {
        let levels = drawn_levels(&rehearsal.stage);
        let sweeps = rehearsal.stage.settings.raster.sweeps;
        let of_sweep = |index: u32| {
            let frame = &frames[(index / sweeps) as usize];
            let programs = frame.programs(index % sweeps);
            let of_level = |of: &DrawnLevel<'_>| SweepFigures::of(frame, of, &programs[of.number], law);
            levels.iter().map(of_level).collect()
        };
        let all: Vec<Vec<SweepFigures>> =
            (0..sweeps * frames.len() as u32).into_par_iter().map(of_sweep).collect();
        let of_level = |of: &DrawnLevel<'_>| {
            let sweeps: Vec<&SweepFigures> = all.iter().map(|sweep| &sweep[of.number]).collect();
            Self::of(rehearsal, frames, of, &sweeps)
        };
        levels.iter().map(of_level).collect()
    }

    fn of(
        rehearsal: &Rehearsal,
        frames: &[FrameSweeps<'_>],
        of: &DrawnLevel<'_>,
        all: &[&SweepFigures],
    ) -> Self {
        let stage = &rehearsal.stage;
        let total = all.len().max(1) as f64;
        let sum = |value: fn(&SweepFigures) -> u64| all.iter().map(|sweep| value(sweep)).sum::<u64>();
        let mean =
            |value: fn(&SweepFigures) -> f64| all.iter().map(|sweep| value(sweep)).sum::<f64>() / total;
        let range = mean(|sweep| sweep.range);
        let region_size = of.level.region_size();
        let budget = rehearsal.model_as_run().budget(GroundScale { region_size, range });
        // A fold is seen with the next tick of the clock: half a tick later, in the mean.
        let is_wired = stage.settings.loader.is_wired_through();
        let tick = if is_wired { 0.0 } else { 1.0 / stage.settings.timebase.master.hertz() };
        let urgent_mean = budget.loader.urgent + 0.5 * tick;
        let ranges = frames.first().map_or(&[][..], |frame| frame.table().ranges());
        let expected = all.iter().map(|sweep| late_expected(stage, ranges, region_size, sweep, urgent_mean));
        Self {
            name: of.name,
            region_size,
            range,
            frames: frames.len() as u64,
            sweeps: all.len() as u64,
            crossings: [
                mean(|sweep| sweep.crossings as f64),
                all.iter().map(|sweep| sweep.crossings).min().unwrap_or(0) as f64,
                all.iter().map(|sweep| sweep.crossings).max().unwrap_or(0) as f64,
            ],
            crossings_at_azimuths: mean(|sweep| sweep.at_azimuth),
            used: sum(|sweep| sweep.used),
            brought: sum(|sweep| sweep.brought),
            urgent: urgent(all, stage.settings.timebase.sample_rate().hertz()),
            late_urgent: sum(|sweep| sweep.late_urgent),
            late: sum(|sweep| sweep.late),
            seen: sum(|sweep| sweep.seen),
            late_expected: expected.sum(),
            budget,
            tick,
        }
    }
}

fn urgent(all: &[&SweepFigures], samples_a_second: f64) -> Option<[f64; 2]> {
    let (mut count, mut sum, mut most) = (0, 0.0, 0.0_f64);
    for (of_sweep, total, longest) in all.iter().map(|sweep| sweep.urgent) {
        count += of_sweep;
        sum += total;
        most = most.max(longest);
    }
    (count > 0).then(|| [sum / count as f64, most].map(|samples| samples / samples_a_second))
}

/// Urgent sets of one sweep that a stop of the other axis meets within `urgent` (s) of a stop of the one: section 4.5,
/// with the rate of each sample in place of a constant one.
fn late_expected(stage: &MachineStage, ranges: &[f64], size: f64, sweep: &SweepFigures, urgent: f64) -> f64 {
    if stage.settings.loader.diagonal_register {
        return 0.0;
    }
    let samples = urgent * stage.settings.timebase.sample_rate().hertz();
    let [x, y] = sweep.direction.map(|cosine| cosine.abs() / size);
    let of_step = |pair: &[f64]| {
        let [near, far] = [pair[0], pair[1].min(sweep.range)];
        let way = (far - near).max(0.0);
        let within = (pair[1] - pair[0]) * samples;
        way * (x * (within * y).min(1.0) + y * (within * x).min(1.0))
    };
    let foot = [0.0, ranges.first().copied().unwrap_or(0.0)];
    of_step(&foot) + ranges.windows(2).map(of_step).sum::<f64>()
}

impl SweepFigures {
    fn of(frame: &FrameSweeps<'_>, of: &DrawnLevel<'_>, program: &SweepProgram, law: &TearLaw) -> Self {
        let mut sets = Vec::new();
        sets_of(program, frame.loader().is_wired_through(), &mut sets);
        let direction = program.start.direction;
        let range = program.end_range;
        let seen = |miss: &&Miss| law.is_seen(miss, program, of.level, frame.table());
        let count = |is: fn(&&AskedSet) -> bool| sets.iter().filter(is).count() as u64;
        Self {
            range,
            crossings: crossings(program).count() as u64,
            at_azimuth: range * (direction[0].abs() + direction[1].abs()) / of.level.region_size(),
            direction,
            // Each of two colours takes a set, those of the home registers too.
            used: 2 * transfers(program),
            brought: count(|set| set.came.is_some()),
            urgent: latencies(&sets),
            late_urgent: count(|set| set.late && set.urgent),
            late: count(|set| set.late),
            seen: program.misses.iter().filter(seen).count() as u64,
        }
    }
}

fn transfers(program: &SweepProgram) -> u64 {
    program.events().filter(|step| matches!(step.kind, Event::Fold(_))).count() as u64
}

fn latencies(sets: &[AskedSet]) -> (u64, f64, f64) {
    let urgent = sets.iter().filter(|set| set.urgent).filter_map(AskedSet::latency);
    urgent.fold((0, 0.0, 0.0), |(count, sum, most), latency| (count + 1, sum + latency, latency.max(most)))
}
