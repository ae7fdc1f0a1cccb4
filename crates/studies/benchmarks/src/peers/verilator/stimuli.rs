//! What the verilated control plane is fed with: the set-up of every sweep, and the ground range of every tick.

use control_plane::{ControlPlane, FrameSweeps, MachineStage};
use quantities::{SweepTime, Tick, Timebase};
use scenario::Pose;
use std::fmt::Write as _;
use sweep_program::{Ramp, Stop, SweepProgram};

/// Parts of a metre in which a ground range counts.
const PARTS: f64 = (1u64 << 40) as f64;
/// A ground range that is never reached.
const NEVER: u64 = u64::MAX;
/// Instants of a sweep that differ by less are one (samples).
const ALIKE: f64 = 1e-9;

/// Set-ups and ranges of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Stimuli {
    /// Bytes of the set-ups, as `peers/control_plane.cpp` reads them.
    pub sweeps: Vec<u8>,
    /// Ground range of each tick of each phase, as `$readmemh` reads it.
    pub ranges: String,
    /// Sweeps after which ticks fall alike again.
    pub phases: u32,
    /// Places of a phase, a power of two.
    pub ticks: u32,
    /// Ticks of pointer, access and strobe.
    pub loader: [u64; 3],
}

impl Stimuli {
    /// Those of frame 0 of `stage`, on two levels; `plane` is its control plane.
    ///
    /// # Errors
    /// If the pose cannot be drawn, there is one level, or a fold lies before its sweep: the other control plane has no ticks there.
    pub fn new(stage: &MachineStage, plane: &ControlPlane, pose: &Pose) -> Result<Self, String> {
        let settings = &stage.settings;
        let frame = plane.sweeps(0, pose).map_err(|error| error.to_string())?;
        let (timebase, count) = (&settings.timebase, settings.raster.sweeps);
        let phases = phases(timebase, count);
        let ticks: Vec<u64> =
            (0..count).map(|sweep| begin(timebase, sweep + 1).0 - begin(timebase, sweep).0).collect();
        let longest = ticks.iter().max().copied().unwrap_or(0) as u32 + 1;
        let place = longest.next_power_of_two();
        let mut sweeps = count.to_le_bytes().to_vec();
        for (sweep, &ticks) in (0..count).zip(&ticks) {
            let programs = frame.programs(sweep);
            let [fine, coarse] = programs.as_slice() else { return Err("expected two levels".to_owned()) };
            let way = fine.start.direction.map(|cosine| if cosine < 0.0 { -2 } else { 2 });
            sweeps.extend(
                [(sweep % phases) as i32, ticks as i32].into_iter().chain(way).flat_map(i32::to_le_bytes),
            );
            for (level, program) in stage.landscape.bank().levels().iter().zip([fine, coarse]) {
                if program.steps.first().is_some_and(|step| step.time < SweepTime(0.0)) {
                    return Err(format!("sweep {sweep}: a fold before its first sample"));
                }
                write_level(&mut sweeps, program, level.region_size(), level.corners());
            }
        }
        let loader = [settings.loader.pointer, settings.loader.access, settings.loader.strobe];
        Ok(Self { sweeps, ranges: ranges(&frame, timebase, [phases, place]), phases, ticks: place, loader })
    }
}

/// The set-up of one level.
fn write_level(bytes: &mut Vec<u8>, program: &SweepProgram, region: f64, corners: [usize; 2]) {
    let [x, y] = program.start.ramps.map(|ramp| folds(&ramp, region));
    let wide = [x.0[0], y.0[0], x.0[1], y.0[1], fixed(program.end_range)];
    let regions = program.start.region.map(|line| line as i32);
    let lasts = corners.map(|count| count as i32 - 1);
    let narrow = [x.1, y.1].into_iter().chain(regions).chain(lasts);
    bytes.extend(wide.into_iter().flat_map(u64::to_le_bytes));
    bytes.extend(narrow.flat_map(i32::to_le_bytes));
}

/// Ground range of the first fold of a ramp and from fold to fold, and whether the first one is at the stop at one.
fn folds(ramp: &Ramp, region: f64) -> ([u64; 2], i32) {
    let (way, stop) = ramp.first_stop();
    let speed = ramp.rate.abs();
    let ranges = if speed > 0.0 { [way, 1.0].map(|way| fixed(way / speed * region)) } else { [NEVER, 0] };
    (ranges, i32::from(stop == Stop::One))
}

/// A ground range (m) in [`PARTS`] of a metre.
fn fixed(range: f64) -> u64 {
    (range * PARTS).round() as u64
}

/// The first tick of a sweep of frame 0 that is not before its first sample.
fn begin(timebase: &Timebase, sweep: u32) -> Tick {
    timebase.sweep_clock(0, sweep).tick_at_or_after(SweepTime(0.0))
}

/// Sweeps after which ticks fall alike again; all sweeps if there is no such number.
fn phases(timebase: &Timebase, count: u32) -> u32 {
    let first = |sweep: u32| timebase.sweep_clock(0, sweep).instant_of(begin(timebase, sweep)).0;
    let is_period =
        |&period: &u32| (period..count).all(|sweep| (first(sweep) - first(sweep - period)).abs() < ALIKE);
    (1..count).find(is_period).unwrap_or(count)
}

/// Ground range of each tick of each phase: a line a number.
fn ranges(frame: &FrameSweeps<'_>, timebase: &Timebase, [phases, places]: [u32; 2]) -> String {
    let mut text = String::new();
    for sweep in 0..phases {
        let (clock, first) = (timebase.sweep_clock(0, sweep), begin(timebase, sweep));
        for tick in 0..u64::from(places) {
            let range = frame.table().range_at(clock.instant_of(Tick(first.0 + tick)));
            let range = if range.is_finite() { fixed(range) } else { NEVER };
            let _ = writeln!(text, "{range:016x}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use quantities::{Rate, Timebase};
    use sweep_program::Ramp;

    use super::{NEVER, fixed, folds, phases};

    #[test]
    fn folds_come_at_even_ranges_and_never_for_a_ramp_that_stands() {
        let ramp = Ramp { start: 0.25, rate: -0.5, polarity: 1.0 };
        assert_eq!(folds(&ramp, 300.0), ([fixed(150.0), fixed(600.0)], 0));
        assert_eq!(folds(&Ramp { rate: 0.0, ..ramp }, 300.0).0, [NEVER, 0]);
        assert_eq!(fixed(1.5), 3 << 39);
    }

    /// 20 000 000 ticks over 15 750 sweeps are 80 000 over 63.
    #[test]
    fn ticks_fall_alike_after_whole_ticks() {
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let timebase = Timebase::new(rate(20_000_000), rate(30), 525, 1000, 208).unwrap();
        assert_eq!(phases(&timebase, 525), 63);
    }
}
