//! Stretches of real sweeps: what stands in the registers between two events, and the samples that are drawn from it.

use control_plane::{ControlPlane, MachineStage};
use landscape::CornerWords;
use landscape::basis::{FAR, NEAR};
use scenario::Pose;
use sweep_program::{Ramp, SweepProgram};
use terrain_generator::{Region, Registers, Segment, Span};

use super::double::Double;
use crate::StudyError;

/// Sweeps of a frame that are looked at.
const SWEEPS: u32 = 12;
/// Fewer samples than this are not expanded by the machine either.
const LEAST: usize = 3;

/// A stretch between two events: one polynomial of degree 10 along the sweep.
#[derive(Debug, Clone)]
pub struct Stretch {
    /// Words in the hold registers, by colour.
    pub hold: [CornerWords; 4],
    /// States of the polarity flip-flops of X and Y.
    pub polarity: [f64; 2],
    /// The expansion that the machine makes.
    pub segment: Segment,
    /// Samples of the stretch, with their true heights.
    pub points: Vec<Point>,
}

/// A sample of a stretch.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// Ramps X and Y.
    pub ramps: [f64; 2],
    /// Place in the stretch, -1..=1.
    pub place: f64,
    /// Height (m), to twice the digits of f64.
    pub height: f64,
}

/// The stretches of sweeps spread over the frame of `pose`.
///
/// # Errors
/// If the pose cannot be drawn.
pub fn stretches(stage: &MachineStage, frame: u64, pose: &Pose) -> Result<Vec<Stretch>, StudyError> {
    let (control, settings) = (ControlPlane::new(stage.clone()), &stage.settings);
    let samples = settings.raster.samples as usize;
    let ranges: Vec<f64> = (0..samples).map(|sample| settings.range.at_sample(sample, samples)).collect();
    let (all, level) = (settings.raster.sweeps, stage.landscape.level());
    let frame = control.sweeps(frame, pose)?;
    let chosen = all.min(SWEEPS);
    let mut found = Vec::new();
    for index in 0..chosen {
        let programs = frame.programs((2 * index + 1) * all / (2 * chosen));
        let sweep = Sweep {
            program: &programs[0],
            ranges: &ranges,
            buffer: level.words(),
            size: level.region_size(),
        };
        sweep.stretches(&mut found);
    }
    Ok(found)
}

struct Sweep<'a> {
    program: &'a SweepProgram,
    ranges: &'a [f64],
    buffer: &'a [CornerWords],
    size: f64,
}

impl Sweep<'_> {
    fn stretches(&self, found: &mut Vec<Stretch>) {
        let mut registers = Registers::at_start(self.program);
        let last = self.ranges.partition_point(|&range| range <= self.program.end_range);
        let (mut sample, mut begin) = (0, self.ranges[0]);
        for step in self.program.steps.iter().filter(|step| step.sample < last) {
            if step.kind.changes_hold() && step.sample > sample {
                found.extend(self.stretch(&registers, [begin, step.range], sample..step.sample));
                (sample, begin) = (step.sample, step.range);
            }
            registers.apply(step, self.buffer);
        }
        if sample < last {
            found.extend(self.stretch(&registers, [begin, self.ranges[last - 1]], sample..last));
        }
    }

    fn stretch(
        &self,
        registers: &Registers,
        [begin, end]: [f64; 2],
        samples: std::ops::Range<usize>,
    ) -> Option<Stretch> {
        let (middle, half_length) = (0.5 * (begin + end), 0.5 * (end - begin));
        if samples.len() < LEAST || half_length <= 0.0 {
            return None;
        }
        let (folds, ramps) = (registers.folds(), &self.program.start.ramps);
        let at = |range: f64| [0, 1].map(|axis| ramps[axis].at(folds[axis], range / self.size));
        let [(x, x_rate), (y, y_rate)] = at(middle);
        let span = Span {
            middle: [x, y],
            half: [x_rate, y_rate].map(|rate| rate * half_length / self.size),
            half_length,
            across: [0.0; 2],
        };
        let (hold, polarity) = (registers.hold(self.buffer).map(|words| *words), registers.polarity());
        let point = |&range: &f64| {
            let way = Double::ratio(range, self.size);
            let exact = [0, 1].map(|axis| ramp(&ramps[axis], folds[axis], way));
            Point {
                ramps: at(range).map(|(ramp, _)| ramp),
                place: (range - middle) / half_length,
                height: height(&hold, polarity, exact).to_f64(),
            }
        };
        let points = self.ranges[samples].iter().map(point).collect();
        Some(Stretch {
            segment: Segment::expand(&Region::of(hold.each_ref(), polarity), &span),
            hold,
            polarity,
            points,
        })
    }
}

/// [`Ramp::at`] without its rounding.
fn ramp(ramp: &Ramp, folds: u32, way: Double) -> Double {
    let (start, rate) = (Double::from(ramp.start), Double::from(ramp.rate));
    if folds == 0 {
        return start + rate * way;
    }
    let rises = ramp.rate > 0.0;
    let one = Double::from(1.0);
    let first = if rises { one - start } else { start };
    let speed = Double::from(ramp.rate.abs());
    let since = speed * way - first - Double::from(f64::from(folds - 1));
    if rises == (folds % 2 == 1) { one - since } else { since }
}

/// The sum of section 6.4, `sum e_x^p e_y^q g_p(X_a) g_q(Y_b) f_pq`.
fn height(hold: &[CornerWords; 4], polarity: [f64; 2], [x, y]: [Double; 2]) -> Double {
    let ([gx, gy], mut sum) = ([functions(x, polarity[0]), functions(y, polarity[1])], Double::default());
    for (colour, words) in hold.iter().enumerate() {
        let (a, b) = (colour & 1, colour >> 1);
        for (word, &value) in words.iter().enumerate() {
            sum = sum + gx[3 * a + word / 3] * gy[3 * b + word % 3] * Double::from(value);
        }
    }
    sum
}

/// `g_ip` with its sign, index `3 i + p`; `g_1p` of the ramp is `g_0p` of its complement but for the sign of `p = 1`.
fn functions(ramp: Double, polarity: f64) -> [Double; 6] {
    let horner =
        |c: &[f64; 6]| c.iter().rev().fold(Double::default(), |sum, &c| sum * ramp + Double::from(c));
    std::array::from_fn(|index| {
        let (far, p) = (index / 3, index % 3);
        let value = horner(if far == 1 { &FAR[p] } else { &NEAR[p] });
        if p == 1 { Double::from(polarity) * value } else { value }
    })
}
