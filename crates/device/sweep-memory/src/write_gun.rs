//! The write gun of a scan converter of real parts: deflection, and a beam that leaves charge.

use hardware_model::AnalogParts;
use parts::Spread;
use signal::{Breaks, LANES, Lanes, Real, Stretches};

use crate::FarStroke;
use crate::aim::{Aim, Dots};
use crate::deflection::Deflection;
use crate::exposure::{Charge, Levels, Target};
use crate::stroke::Stroke;

/// What drives the gun for a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Copy)]
pub struct Drive<'a, S> {
    /// Line position that the deflection is told, whether the beam is on or not (lines from the top of a row).
    pub position: &'a [Lanes<S>],
    /// Intensity, negative in local shadow.
    pub intensity: &'a [Lanes<S>],
    /// Where the intensity jumps or bends between samples; `None` if it does not.
    pub breaks: Option<&'a Breaks<S>>,
    /// Where the beam is on, by the clock of both.
    pub on: &'a Stretches,
    /// Silhouettes behind the last sample, lane by lane, nearest first; `None` if there are none.
    pub far: Option<&'a [Vec<FarStroke>; LANES]>,
}

/// A write gun made ready for a run.
#[derive(Debug, Clone)]
pub struct WriteGun<S> {
    lines: usize,
    deflection: Option<Deflection<S>>,
    charge: Option<Charge>,
}

/// Buffers of a worker.
#[derive(Debug, Clone, Default)]
pub struct GunWork {
    aim: Aim,
    cuts: Vec<Cut>,
    covered: Vec<f32>,
}

/// Where the drive of a beam jumps or bends between two samples.
#[derive(Debug, Clone, Copy)]
struct Cut {
    /// The step ends at this sample.
    sample: usize,
    /// Share of the step.
    share: f32,
    /// Drive just before and just after it.
    drive: [f32; 2],
}

impl<S: Real> WriteGun<S> {
    /// The gun of `parts` for sweeps of `samples` samples, one every `h` seconds, and `lines` lines a row. The part
    /// itself is drawn from `seed` where parts spread.
    pub fn new(parts: &AnalogParts, seed: u64, h: f64, samples: usize, lines: usize) -> Self {
        let spread = parts.spread.then(|| Spread::new(seed));
        let deflection = |bandwidth| Deflection::new(bandwidth, spread.as_ref(), h, lines);
        let nominal = lines as f64 / (samples.max(2) - 1) as f64;
        Self {
            lines,
            deflection: parts.memory.deflection.map(deflection),
            charge: Charge::new(parts.memory.write_compensation, nominal),
        }
    }

    /// Writes the first `rows.len() / lines` sweeps of a group into `rows`, `lines` values a sweep, cleared before.
    pub fn write_stretches(&self, drive: &Drive<'_, S>, work: &mut GunWork, rows: &mut [f32]) {
        let GunWork { aim, cuts, covered } = work;
        match self.charge {
            None => self.write(drive, Levels { covered }, (aim, cuts), rows),
            Some(charge) => self.write(drive, charge, (aim, cuts), rows),
        }
    }

    fn write(
        &self,
        drive: &Drive<'_, S>,
        mut target: impl Target,
        (aim, cuts): (&mut Aim, &mut Vec<Cut>),
        rows: &mut [f32],
    ) {
        debug_assert!(rows.len() / self.lines <= LANES);
        let deflection = self.deflection.as_ref();
        aim.take((drive.position, drive.intensity), deflection, (&target, self.lines));
        for (lane, row) in rows.chunks_exact_mut(self.lines).enumerate() {
            target.begin(row);
            let mut top = self.lines as f32;
            drive.list_cuts(lane, &target, cuts);
            for &stretch in &drive.on[lane] {
                top = top.min(Beam { aim, cuts, lane }.write(stretch, &mut target, row));
            }
            for stroke in drive.far_strokes(lane, top) {
                let drive = target.drive(stroke.start);
                target.leave_exactly(Stroke { start: drive, end: drive, ..stroke }, row);
            }
            target.finish(row);
        }
    }
}

impl<S: Real> Drive<'_, S> {
    fn list_cuts(&self, lane: usize, target: &impl Target, cuts: &mut Vec<Cut>) {
        cuts.clear();
        let single = |value: S| value.to_f64() as f32;
        cuts.extend(self.breaks.iter().flat_map(|breaks| &breaks[lane]).map(|place| Cut {
            sample: place.sample,
            share: single(place.share),
            drive: [place.before, place.after].map(|value| target.drive(single(value))),
        }));
    }
}

impl<S> Drive<'_, S> {
    /// Silhouettes rise from the highest place that the beam has written, each hidden by what is before it.
    fn far_strokes(&self, lane: usize, top: f32) -> impl Iterator<Item = Stroke> + use<'_, S> {
        let far = self.far.map_or(&[][..], |far| &far[lane]);
        far.iter().scan(top, |from, &FarStroke { line, intensity }| {
            let stroke = Stroke { from: *from, to: line.min(*from), start: intensity, end: intensity };
            *from = stroke.to;
            Some(stroke)
        })
    }
}

/// The beam of one lane.
struct Beam<'a> {
    aim: &'a Aim,
    cuts: &'a [Cut],
    lane: usize,
}

impl Beam<'_> {
    /// Leaves what it writes in a stretch of time (samples); the highest place that it comes to. A beam that is nowhere
    /// writes nothing.
    fn write(&self, stretch: [f64; 2], target: &mut impl Target, row: &mut [f32]) -> f32 {
        let Self { aim: Aim { places, dots, .. }, cuts, lane } = *self;
        let mut top = f32::INFINITY;
        let last = places.len().saturating_sub(1) as f64;
        let [begin, end] = [stretch[0].max(0.0), stretch[1].min(last)];
        if stretch[0].is_nan() || begin >= end {
            return top;
        }
        let mut ahead = &cuts[cuts.partition_point(|cut| cut.sample <= begin as usize)..];
        for sample in begin as usize + 1..=end.ceil() as usize {
            let origin = (sample - 1) as f64;
            let own = ahead.iter().take_while(|cut| cut.sample == sample).count();
            let is_whole = own == 0 && origin >= begin && sample as f64 <= end;
            let Dots { lines, charges } = &dots[sample];
            let touched = row.get_mut(lines[lane] as usize..).and_then(|rest| rest.first_chunk_mut());
            if let Some([upper, lower]) = touched.filter(|_| is_whole) {
                *upper += charges[0][lane];
                *lower += charges[1][lane];
                top = top.min(places[sample - 1][lane]).min(places[sample][lane]);
                continue;
            }
            let within = [(begin - origin).max(0.0) as f32, (end - origin).min(1.0) as f32];
            self.strokes(sample, &ahead[..own], within, |stroke, share, speed| {
                top = top.min(stroke.to).min(stroke.from);
                target.leave(stroke, share, speed, row);
            });
            ahead = &ahead[own..];
        }
        top
    }

    /// The strokes of a step, as far as it lies `within` two shares, each with its share of the step and the speed of the beam in
    /// it.
    fn strokes(&self, sample: usize, cuts: &[Cut], within: [f32; 2], mut draw: impl FnMut(Stroke, f32, f32)) {
        let ends = |all: &[Lanes<f32>]| [all[sample - 1][self.lane], all[sample][self.lane]];
        let ([before, after], drives) = (ends(&self.aim.places), ends(&self.aim.drives));
        let place = |share: f32| before + (after - before) * share;
        let speed = (after - before).abs();
        pieces(drives, cuts, within, |[from, to], [start, end]| {
            if speed.is_finite() && (start + end).is_finite() {
                draw(Stroke { from: place(from), to: place(to), start, end }, to - from, speed);
            }
        });
    }
}

/// The parts of a step between its cuts, as far as they lie `within` two shares of it: shares and drives at their ends.
fn pieces(ends: [f32; 2], cuts: &[Cut], within: [f32; 2], mut visit: impl FnMut([f32; 2], [f32; 2])) {
    let (mut from, mut start) = (0.0_f32, ends[0]);
    let last = Cut { sample: 0, share: 1.0, drive: [ends[1]; 2] };
    for cut in cuts.iter().chain([&last]) {
        let (to, end) = (cut.share, cut.drive[0]);
        let part = [from.max(within[0]), to.min(within[1])];
        if part[0] < part[1] {
            visit(part, part.map(|share| start + (end - start) * ((share - from) / (to - from))));
        }
        (from, start) = (to, cut.drive[1]);
    }
}

#[cfg(test)]
mod tests;
