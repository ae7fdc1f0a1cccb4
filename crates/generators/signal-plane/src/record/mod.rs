//! Waveforms of a group that has just run.

mod inner;
mod units;

use control_plane::waveforms::{Changes, feature_centres};
use control_plane::{RANGE, is_state, state_changes};
use mixing_unit::Inputs;
use polyhedron_generator::Overlay;
use scenario::Occlusion;
use signal::{Axis, Lanes, Probe, Real, Signal, Waveform};

use self::inner::{Together, of_lane};
use crate::group::Group;
use crate::scales::MICROSECONDS;
use crate::signal_table::signals;
use crate::workspace::Workspace;

/// A group that has run, ready to be looked at.
pub struct Recorded<'a, S> {
    /// Group of sweeps that has run.
    pub group: &'a Group<'a, S>,
    /// Its programs and signals.
    pub work: &'a Workspace<S>,
    /// Lines that each sweep left.
    pub rows: &'a [f32],
}

/// The gate at each sample: the profile is below the held elevation, and the hold has not moved.
fn blanked(elevation: &[f64], hold: &[f64]) -> Vec<f64> {
    let moved = |k: usize| k == 0 || hold[k] > hold[k - 1];
    let gate = |(k, now): (usize, &f64)| f64::from(u8::from(*now < hold[k] && !moved(k)));
    elevation.iter().enumerate().map(gate).collect()
}

/// How much each value is above the one before.
fn rises(values: &[f64]) -> Vec<f64> {
    let first = values.first().map(|_| 0.0);
    first.into_iter().chain(values.windows(2).map(|pair| pair[1] - pair[0])).collect()
}

impl<S: Real> Recorded<'_, S> {
    /// What `probe` wants of lane `lane`, which is sweep `sweep`.
    pub fn waveforms(&self, probe: &Probe, lane: usize, sweep: u32) -> Vec<Waveform> {
        let mut together = self.together(probe, lane, sweep);
        let of = |signal: &Signal| {
            let Changes { times, values } = match signal.axis {
                Axis::Ground => sampled(self.along_the_ground(signal.name, lane, &mut together)),
                Axis::Display => sampled(self.down_the_display(signal.name, lane, sweep)),
                Axis::Changes if is_state(signal) => {
                    state_changes(signal, &self.group.crossings(), self.group.digital, sweep)
                }
                Axis::Changes => self.digital(signal.name, (lane, sweep), &mut together),
                // The read beam scans lines when the sweeps are done.
                Axis::Line => Changes::default(),
            };
            Waveform { signal: *signal, frame: self.group.plan.frame, sweep, times, values }
        };
        signals().iter().filter(|signal| probe.wants(signal)).map(of).collect()
    }

    fn digital(&self, name: &str, (lane, sweep): (usize, u32), together: &mut Together) -> Changes {
        let Self { group, work, .. } = self;
        match name {
            "fg.centre" if group.blocks.features => feature_centres(&work.features[lane], group.table),
            "fg.centre" => Changes::default(),
            _ if name.starts_with("sc.") => self.line_generator(name, lane, sweep),
            "yoke.angle" => Changes { times: vec![0.0], values: vec![group.plan.yoke] },
            _ if name.contains(".word") => together.remove(name).unwrap_or_default(),
            _ => self.logic(name, lane),
        }
    }

    fn along_the_ground(&self, name: &str, lane: usize, together: &mut Together) -> Vec<f64> {
        let ranges = self.group.table.ranges();
        if name == RANGE {
            return ranges.to_vec();
        }
        let in_sight = ranges.partition_point(|&range| range <= self.group.end_range(lane, self.work));
        let mut values = together.remove(name).map_or_else(|| self.values(name, lane), |of| of.values);
        values.truncate(in_sight);
        // Beyond the problem area a wire keeps its last value, so nothing changes and nothing is drawn; where a generator is
        // not there, it is 0.
        let beyond = match name {
            "dpp.derivative" | "sm.video" => 0.0,
            _ => values.last().copied().unwrap_or(0.0),
        };
        values.resize(ranges.len(), beyond);
        values
    }

    fn values(&self, name: &str, lane: usize) -> Vec<f64> {
        let Self { group, work, .. } = self;
        let (profile, projected) = (&work.profile, &work.projected);
        let composite = group.composite(work);
        let of = |values: &[Lanes<S>]| of_lane(values, lane);
        let on_datum = |values: &[Lanes<S>]| {
            of(values).into_iter().map(|height| height + group.plan.eye[2]).collect::<Vec<_>>()
        };
        let drawn =
            |values: &[Lanes<S>]| of(values).into_iter().map(|signed| signed.max(0.0)).collect::<Vec<_>>();
        let direction = work.programs[lane].start.direction;
        match name {
            "tg.height" => on_datum(&profile.height),
            "tg.slope.u" => slope(&of(&profile.along), &of(&profile.across), direction, 0),
            "tg.slope.v" => slope(&of(&profile.along), &of(&profile.across), direction, 1),
            "tg.reflectivity" => drawn(&profile.reflectivity),
            "mu.height" => on_datum(composite.height),
            "mu.reflectivity" => drawn(composite.reflectivity),
            "dpp.elevation" => of(&projected.elevation),
            "dpp.hold" => of(&projected.hold),
            "dpp.y" => of(&projected.line),
            "dpp.derivative" => self.derivative(lane),
            "dpp.blank" => self.blank(lane),
            "sm.video" => self.video(lane),
            _ => self.of_added_blocks(name, lane, direction),
        }
    }

    /// The gate that turns the write beam off.
    fn blank(&self, lane: usize) -> Vec<f64> {
        let Self { group, work, .. } = self;
        match group.parts.beam {
            Some(_) => work.driven.blank(lane),
            None => blanked(&of_lane(&work.projected.elevation, lane), &of_lane(&work.projected.hold, lane)),
        }
    }

    /// What the circuit of occlusion by derivative compares with 0 (tangents a microsecond): 0 where there is none.
    fn derivative(&self, lane: usize) -> Vec<f64> {
        let Self { group, work, .. } = self;
        let settings = &group.stage.settings;
        let samples = group.table.ranges().len();
        if settings.laws.occlusion != Occlusion::Derivative {
            return vec![0.0; samples];
        }
        let (rates, a_second) = match &group.parts.beam {
            Some(beam) => (beam.processor.derivative(&work.driven, lane), 1.0),
            None => (
                Some(rises(&of_lane(&work.projected.elevation, lane))),
                settings.timebase.sample_rate().hertz(),
            ),
        };
        let in_microseconds = |rate: f64| rate * a_second / MICROSECONDS;
        rates.map_or_else(|| vec![0.0; samples], |rates| rates.into_iter().map(in_microseconds).collect())
    }

    /// What drives the write beam: from parts it comes behind the delay line that meets the position.
    fn video(&self, lane: usize) -> Vec<f64> {
        let Self { group, work, .. } = self;
        let intensity = match group.parts.beam {
            Some(_) => of_lane(&work.driven.intensity, lane),
            None => of_lane(group.composite(work).reflectivity, lane),
        };
        let seen = |(video, blank): (f64, f64)| if blank > 0.5 { 0.0 } else { video.max(0.0) };
        intensity.into_iter().zip(self.blank(lane)).map(seen).collect()
    }

    /// Signals of blocks that may not be there: 0 throughout if they are not.
    fn of_added_blocks(&self, name: &str, lane: usize, direction: [f64; 2]) -> Vec<f64> {
        let Self { group, work, .. } = self;
        let of = |values: &[Lanes<S>]| of_lane(values, lane);
        let features = &work.feature_profile;
        let samples = group.table.ranges().len();
        let has_features = group.blocks.features;
        match name {
            "fg.height" if has_features => of(&features.height),
            "fg.slope.u" if has_features => slope(&of(&features.along), &of(&features.across), direction, 0),
            "fg.slope.v" if has_features => slope(&of(&features.along), &of(&features.across), direction, 1),
            "fg.or" if has_features => of(&features.present),
            "fg.grain" if has_features => up_to(of(&work.grain), samples),
            "fg.reflectivity" if has_features => {
                of(&work.lit.reflectivity).into_iter().map(|signed| signed.max(0.0)).collect()
            }
            "sc.or" => self.mixed(|inputs| inputs.vs2_gate(lane)),
            "txg.texture" if group.blocks.texture => up_to(of(&work.texture), samples),
            _ => vec![0.0; samples],
        }
    }

    fn mixed<T>(&self, of: impl FnOnce(Inputs<'_, S>) -> T) -> T {
        let lists = self.group.toggle_lists(self.work);
        of(self.group.inputs(self.work, &lists))
    }

    fn down_the_display(&self, name: &str, lane: usize, sweep: u32) -> Vec<f64> {
        let lines = self.group.raster.lines;
        let rule = self.group.stage.settings.laws.pixel_rule;
        let (mut overlay, mut row) = (Overlay::default(), vec![0.0; lines]);
        let mut seen = || self.group.compose_bodies(sweep, lane, &self.work.projected.line, &mut overlay);
        match name {
            "sm.write" => row.copy_from_slice(&self.rows[lane * lines..][..lines]),
            "pg.present" if seen() => overlay.present(rule, &mut row),
            "pg.reflectivity" if seen() => overlay.write(rule, &mut row),
            _ => {}
        }
        row.into_iter().map(f64::from).collect()
    }
}

/// Values at all `samples`: 0 beyond the last.
fn up_to(mut values: Vec<f64>, samples: usize) -> Vec<f64> {
    values.resize(samples, 0.0);
    values
}

/// Values at the samples.
fn sampled(values: Vec<f64>) -> Changes {
    Changes { times: Vec::new(), values }
}

/// Slope to the north (axis 0) or the east (axis 1) from those along and across a sweep.
fn slope(along: &[f64], across: &[f64], [cos, sin]: [f64; 2], axis: usize) -> Vec<f64> {
    let (a, b) = if axis == 0 { (cos, -sin) } else { (sin, cos) };
    along.iter().zip(across).map(|(along, across)| a * along + b * across).collect()
}
