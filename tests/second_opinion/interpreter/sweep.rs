//! One sweep, in the order of section 24.

use std::collections::BTreeMap;

use scenario::{Projection, RangeLaw};

use crate::interpreter::projector::{Circuit, elevation, summits};
use crate::interpreter::ramp::Ramp;
use crate::interpreter::registers::{Clock, Registers};
use crate::interpreter::terrain::{Light, sums};
use crate::scene::{Scene, UPDATE_HZ};

/// What one sweep gave, up to the last sample within the stored area.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Record {
    /// Ground range of each sample (m).
    pub range: Vec<f64>,
    /// Signals by the name that the machine gives them.
    pub signals: BTreeMap<&'static str, Vec<f64>>,
    /// Stops met.
    pub folds: u64,
    /// Words that missed their transfer.
    pub late_words: u64,
    /// Instants of the stops, in accumulator steps from the first sample, with axis (0 is X).
    pub stops: Vec<(f64, usize)>,
    /// Whether the sweep left the stored area before its end.
    pub left_the_area: bool,
}

/// Walks sweep `sweep` of frame `frame` step by step, along the given ground ranges of its samples (m), which
/// [`range_programme`] makes.
pub fn interpret(scene: &Scene, frame: u64, sweep: u32, ranges: &[f64]) -> Record {
    let direction = azimuth(scene, sweep);
    let level = &scene.level;
    let ramps: [Ramp; 2] = std::array::from_fn(|axis| {
        let place = (scene.eye[axis] - level.origin()[axis]) / level.region_size();
        Ramp::at_start(place, direction[axis], level.region_size())
    });
    let region = [ramps[0].region, ramps[1].region];
    let heading = [ramps[0].heading, ramps[1].heading];
    let clock = clock(scene, frame, sweep);
    let rising = ramps.each_ref().map(|ramp| ramp.moves().then_some(ramp.rising));
    let registers = Registers::at_start(level, &scene.loader, clock, (frame, sweep), region, heading, rising);
    let mut walk = Walk { scene, ramps, registers, record: Record::default() };
    let mut before = 0.0;
    for (k, &range) in ranges.iter().enumerate() {
        if walk.is_outside() || !walk.step(k as f64 - 1.0, before, range) {
            walk.record.left_the_area = true;
            break;
        }
        walk.sample(range);
        before = range;
    }
    walk.record.late_words = walk.registers.late_words;
    walk.occlude();
    walk.record
}

struct Walk<'a> {
    scene: &'a Scene,
    ramps: [Ramp; 2],
    registers: Registers<'a>,
    record: Record,
}

impl Walk<'_> {
    /// One accumulator step, from ground range `from` at time `start` to `to` one step later, with every stop and
    /// every arrival within it. False if the sweep leaves the stored area.
    fn step(&mut self, start: f64, from: f64, to: f64) -> bool {
        let mut now = from;
        let time_at = |range: f64| start + (range - from) / (to - from);
        loop {
            let [x, y] = [self.ramps[0].way_to_stop(), self.ramps[1].way_to_stop()];
            let (axis, way) = if x <= y { (0, x) } else { (1, y) };
            if now + way > to {
                break;
            }
            now += way;
            let time = time_at(now);
            self.ramps.iter_mut().for_each(|ramp| ramp.advance(way));
            self.registers.receive(time);
            let at_one = self.ramps[axis].fold();
            if self.is_outside() {
                return false;
            }
            self.registers.event(axis, at_one, time);
            self.record.folds += 1;
            self.record.stops.push((time, axis));
        }
        self.ramps.iter_mut().for_each(|ramp| ramp.advance(to - now));
        self.registers.receive(start + 1.0);
        true
    }

    /// Whether a moving ramp is in a region that is not stored.
    fn is_outside(&self) -> bool {
        (0..2).any(|axis| {
            let last = self.scene.level.corners()[axis] as i64 - 2;
            self.ramps[axis].moves() && !(0..=last).contains(&self.ramps[axis].region)
        })
    }

    /// Reads every signal at a sample.
    fn sample(&mut self, range: f64) {
        let [x, y] = &self.ramps;
        let [h, h_u, h_v] = sums(&self.registers.hold, [x.value, y.value], [x.polarity, y.polarity]);
        let d = self.scene.level.region_size();
        let (hx, hy) = (h_u / d, h_v / d);
        let eta = elevation(h, self.scene.eye[2], range, self.scene.laws.curvature);
        let values = [
            ("sweep.x", x.value),
            ("sweep.y", y.value),
            ("tg.height", h),
            ("tg.slope.u", hx),
            ("tg.slope.v", hy),
            ("tg.reflectivity", light(self.scene).reflectivity(hx, hy)),
            ("dpp.elevation", eta),
        ];
        for (name, value) in values {
            self.record.signals.entry(name).or_default().push(value);
        }
        self.record.range.push(range);
    }

    /// Runs the occlusion circuit along the finished profile.
    fn occlude(&mut self) {
        let elevations = self.record.signals.get("dpp.elevation").map_or(&[][..], Vec::as_slice);
        let mut circuit = Circuit::at_start(self.scene.laws.occlusion);
        let (mut hold, mut blank) = (Vec::new(), Vec::new());
        for shown in summits(elevations) {
            circuit.step(shown);
            hold.push(circuit.held);
            blank.push(if circuit.blank { 1.0 } else { 0.0 });
        }
        self.record.signals.insert("dpp.hold", hold);
        self.record.signals.insert("dpp.blank", blank);
    }
}

/// Ground range of every sample (m) under the scene's law.
pub fn range_programme(scene: &Scene) -> Vec<f64> {
    let (start, end) = (scene.range.start, scene.range.end);
    let count = scene.samples as usize;
    let steps = (count - 1) as f64;
    let sample = |k: usize| {
        let k = k as f64;
        match scene.range.law {
            RangeLaw::ConstantRate => (k + 1.0) * end / count as f64,
            RangeLaw::TwoRate { switch, fine_share } => {
                let fine = (fine_share * steps).round().clamp(1.0, steps - 1.0);
                let (fine_step, coarse_step) = (switch / (fine + 1.0), (end - switch) / (steps - fine));
                fine_step * (k.min(fine) + 1.0) + coarse_step * (k - fine).max(0.0)
            }
            RangeLaw::ConstantElevation => {
                let (near, far) = (1.0 / start, 1.0 / end);
                1.0 / (near + k * (far - near) / steps)
            }
            RangeLaw::Geometric => start * libm::pow(end / start, k / steps),
        }
    };
    (0..count).map(sample).collect()
}

/// Direction of a sweep over the ground: cosine (north) and sine (east) of its azimuth (section 15.3).
fn azimuth(scene: &Scene, sweep: u32) -> [f64; 2] {
    let count = f64::from(scene.sweeps);
    let place = (2.0 * f64::from(sweep) + 1.0 - count) / count;
    let tan_beta = place * widest(scene);
    let (cos_beta, sin_beta) =
        (1.0 / (1.0 + tan_beta * tan_beta).sqrt(), tan_beta / (1.0 + tan_beta * tan_beta).sqrt());
    let (cos, sin) = (whole(libm::cos(scene.heading)), whole(libm::sin(scene.heading)));
    [cos * cos_beta - sin * sin_beta, sin * cos_beta + cos * sin_beta]
}

/// Far below one accumulator step a sweep: counts as nothing (section 6.5).
fn whole(cosine: f64) -> f64 {
    if cosine.abs() < 1e-15 { 0.0 } else { cosine }
}

/// Largest tangent of beta that a corner of the picture needs.
fn widest(scene: &Scene) -> f64 {
    let (right, down) = (scene.field.tan_half_width, scene.field.tan_half_height);
    match scene.laws.projection {
        Projection::AsReported | Projection::Corrected => right,
        Projection::Exact => {
            let forward = |y: f64| libm::cos(scene.pitch) + y * libm::sin(scene.pitch);
            (right / forward(down)).max(right / forward(-down))
        }
    }
}

fn clock(scene: &Scene, frame: u64, sweep: u32) -> Clock {
    let steps_a_sweep = u64::from(scene.samples + scene.retrace());
    let steps_a_second = UPDATE_HZ * u64::from(scene.sweeps) * steps_a_sweep;
    let first_step = (frame * u64::from(scene.sweeps) + u64::from(sweep)) * steps_a_sweep;
    let over = u128::from(first_step) * u128::from(scene.master_hz) % u128::from(steps_a_second);
    Clock {
        ticks_per_step: scene.master_hz as f64 / steps_a_second as f64,
        phase: over as f64 / steps_a_second as f64,
    }
}

fn light(scene: &Scene) -> Light {
    let (e, a) = (scene.sun.elevation, scene.sun.azimuth);
    Light {
        level: [libm::cos(e) * libm::cos(a), libm::cos(e) * libm::sin(a)],
        up: libm::sin(e),
        albedo: scene.albedo,
    }
}
