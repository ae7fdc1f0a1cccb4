//! Programs for tests: every corner arrives in the instant of its fold.

use landscape::Level;
use quantities::SweepTime;
use sweep_program::{
    Colour, Event, Fold, Load, Ramp, RampAxis, RegisterSet, Step, StepKind, Stop, SweepProgram, SweepStart,
    Target, WordMask,
};

/// The program of a sweep from `eye` (m) along `direction`, to the last of `ranges` or the edge of the level.
pub(crate) fn program(level: &Level, eye: [f64; 2], direction: [f64; 2], ranges: &[f64]) -> SweepProgram {
    let foot = level.in_regions(eye[0], eye[1]);
    let region = foot.map(|place| place.floor() as i64);
    let ramps = std::array::from_fn(|axis| {
        let polarity = if region[axis] % 2 == 0 { 1.0 } else { -1.0 };
        let local = foot[axis] - region[axis] as f64;
        let start = if polarity > 0.0 { local } else { 1.0 - local };
        Ramp { start, rate: direction[axis] * polarity, polarity }
    });
    let mut registers = [RegisterSet::default(); 4];
    for (colour, corner) in corners(level, region) {
        registers[colour as usize].hold = corner;
    }
    let edge = (0..2).map(|axis| {
        let last = (level.corners()[axis] - 1) as f64;
        let way = if direction[axis] > 0.0 { last - foot[axis] } else { foot[axis] };
        way / direction[axis].abs()
    });
    let end = ranges[ranges.len() - 1] / level.region_size();
    let end_range = edge.fold(end, f64::min) * level.region_size();
    let start = SweepStart { direction, region, ramps };
    let steps = steps(level, &start, foot, end_range, ranges);
    SweepProgram { start, registers, steps, end_range, misses: Vec::new() }
}

/// Colours and stored corners of a region.
fn corners(level: &Level, [k, l]: [i64; 2]) -> [(Colour, u32); 4] {
    [[k, l], [k, l + 1], [k + 1, l], [k + 1, l + 1]]
        .map(|[m, n]| (Colour::of_corner(m, n), level.clamped_index(m, n) as u32))
}

fn steps(level: &Level, start: &SweepStart, foot: [f64; 2], end: f64, ranges: &[f64]) -> Vec<Step> {
    let (mut region, mut steps) = (start.region, Vec::new());
    let mut rates = start.ramps.map(|ramp| ramp.rate);
    loop {
        let way = |axis: usize| {
            let line = region[axis] + i64::from(start.direction[axis] > 0.0);
            (line as f64 - foot[axis]) / start.direction[axis] * level.region_size()
        };
        let axis = usize::from(way(1) < way(0));
        let range = way(axis);
        if range >= end {
            return steps;
        }
        let ramp = if axis == 0 { RampAxis::X } else { RampAxis::Y };
        let stop = if rates[axis] > 0.0 { Stop::One } else { Stop::Zero };
        rates[axis] = -rates[axis];
        region[axis] += if start.direction[axis] > 0.0 { 1 } else { -1 };
        let sample = ranges.partition_point(|&z| z < range);
        let mut push = |kind| {
            steps.push(Step { time: SweepTime(sample as f64), range, sample, kind: StepKind::Event(kind) })
        };
        push(Event::Fold(Fold { axis: ramp, stop }));
        for (colour, corner) in corners(level, region).into_iter().filter(|(c, _)| ramp.takes(stop, *c)) {
            push(Event::Load(Load { colour, target: Target::Hold, corner, words: WordMask::ALL }));
        }
    }
}
