//! The signal table of the machine, and waveforms of a group that has just run.

use std::sync::OnceLock;

use signal::{Lanes, Probe, Real, Signal, Unit, Waveform};
use sweep_program::{RampAxis, StepKind, SweepProgram};

use crate::control_plane::FramePlan;
use crate::signal_plane::Workspace;

/// Signals of the sweep generator, recorded from the program.
const SWEEP: &[Signal] = &[
    Signal::ground("sweep.x", Unit::Region, "folded ramp to the north (fig. 17)"),
    Signal::ground("sweep.y", Unit::Region, "folded ramp to the east (fig. 17)"),
    Signal::ground("sweep.range", Unit::Metre, "ground range (section 6.2)"),
];

/// Every signal that the machine can record, in the order of the figure.
pub fn signals() -> &'static [Signal] {
    static TABLE: OnceLock<Vec<Signal>> = OnceLock::new();
    TABLE.get_or_init(|| {
        [
            SWEEP,
            terrain_generator::SIGNALS,
            mixing_unit::SIGNALS,
            display_projection_processor::SIGNALS,
            sweep_memory::SIGNALS,
        ]
        .concat()
    })
}

/// A group that has run, ready to be looked at.
pub(crate) struct Recorded<'a, S> {
    pub plan: &'a FramePlan,
    pub ranges: &'a [f64],
    pub region_size: f64,
    pub work: &'a Workspace<S>,
    /// Lines that each sweep left, `lines` a sweep.
    pub rows: &'a [f32],
    pub lines: usize,
}

/// The gate at each sample: the profile is below the held elevation, and the hold has not moved.
fn blanked(elevation: &[f64], hold: &[f64]) -> Vec<f64> {
    let moved = |k: usize| k == 0 || hold[k] > hold[k - 1];
    let gate = |(k, now): (usize, &f64)| f64::from(u8::from(*now < hold[k] && !moved(k)));
    elevation.iter().enumerate().map(gate).collect()
}

impl<S: Real> Recorded<'_, S> {
    /// What `probe` wants of lane `lane`, which is sweep `sweep`.
    pub fn waveforms(&self, probe: &Probe, lane: usize, sweep: u32) -> Vec<Waveform> {
        let wanted = signals().iter().filter(|signal| probe.wants(signal));
        wanted
            .map(|signal| {
                let values = self.values(signal.name, lane);
                Waveform { signal: *signal, frame: self.plan.frame, sweep, values }
            })
            .collect()
    }

    fn values(&self, name: &str, lane: usize) -> Vec<f64> {
        let program = &self.work.programs[lane];
        let [cos, sin] = program.start.direction;
        let (profile, projected) = (&self.work.profile, &self.work.projected);
        let in_sight = self.in_sight(program);
        let of = |values: &[Lanes<S>]| {
            values[..in_sight].iter().map(|value| value[lane].to_f64()).collect::<Vec<_>>()
        };
        let slope = |along: f64, across: f64| {
            let pairs = of(&profile.along).into_iter().zip(of(&profile.across));
            pairs.map(|(g, c)| g * along + c * across).collect()
        };
        let mut values: Vec<f64> = match name {
            "sweep.x" => self.ramp(program, RampAxis::X),
            "sweep.y" => self.ramp(program, RampAxis::Y),
            "sweep.range" => self.ranges.to_vec(),
            "tg.height" | "mu.height" => {
                of(&profile.height).into_iter().map(|height| height + self.plan.eye[2]).collect()
            }
            "tg.slope.u" => slope(cos, -sin),
            "tg.slope.v" => slope(sin, cos),
            "tg.reflectivity" | "mu.reflectivity" => {
                of(&profile.reflectivity).into_iter().map(|signed| signed.max(0.0)).collect()
            }
            "dpp.elevation" => of(&projected.elevation),
            "dpp.hold" => of(&projected.hold),
            "dpp.y" => of(&projected.line),
            "dpp.blank" => blanked(&of(&projected.elevation), &of(&projected.hold)),
            "sm.write" => {
                return self.rows[lane * self.lines..][..self.lines].iter().map(|&v| f64::from(v)).collect();
            }
            other => unreachable!("{other} stands in the table without being recorded"),
        };
        // Beyond the problem area a wire keeps its last value.
        let last = values.last().copied().unwrap_or(0.0);
        values.resize(self.ranges.len(), last);
        values
    }

    /// Samples before the end of the profile.
    fn in_sight(&self, program: &SweepProgram) -> usize {
        self.ranges.partition_point(|&range| range <= program.end_range)
    }

    fn ramp(&self, program: &SweepProgram, axis: RampAxis) -> Vec<f64> {
        let ramp = &program.start.ramps[usize::from(axis == RampAxis::Y)];
        let mut folds = program
            .steps
            .iter()
            .filter(|step| matches!(step.kind, StepKind::Fold(fold) if fold.axis == axis))
            .peekable();
        let mut count = 0;
        let value = |&range: &f64| {
            while folds.next_if(|fold| fold.range <= range).is_some() {
                count += 1;
            }
            ramp.at(count, range / self.region_size).0
        };
        self.ranges[..self.in_sight(program)].iter().map(value).collect()
    }
}
