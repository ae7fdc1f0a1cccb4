//! Side by side in vectors against one sweep, one stretch, one sample at a time: the same bits.

use std::ops::Range;

use fearless_simd::Level as Width;
use landscape::{CornerWords, Level};
use proptest::prelude::{any, prop_assert_eq, proptest};
use signal::{LANES, Real};
use sweep_program::{Event, NO_CORNER, StepKind, SweepProgram, WordMask};

use super::Polynomials;
use crate::array::array;
use crate::programs::program;
use crate::{Method, OUT_OF_SIGHT, Profile, Region, Registers, Segment, Span, TerrainGenerator};

/// Height and slopes of one sweep at the samples of `span`.
fn one_by_one<S: Real>(
    generator: &TerrainGenerator<'_>,
    program: &SweepProgram,
    span: Range<usize>,
) -> Vec<[S; 3]> {
    let TerrainGenerator { buffer, region_size, ranges, datum } = *generator;
    let (mut registers, mut steps) = (Registers::at_start(program), program.steps.iter().peekable());
    let last = ranges.iter().take_while(|&&range| range <= program.end_range).count();
    let [cos, sin] = program.start.direction;
    let (mut out, mut sample) = (Vec::new(), span.start);
    while sample < span.end {
        if sample >= last {
            out.push([OUT_OF_SIGHT, 0.0, 0.0].map(S::from_f64));
            sample += 1;
            continue;
        }
        let is_kept = |kind: &StepKind| !kind.changes_hold();
        let mut begin = ranges[sample.saturating_sub(1)];
        while let Some(step) = steps.next_if(|step| step.sample <= sample) {
            registers.apply(step, buffer);
            begin = if is_kept(&step.kind) { begin } else { begin.max(step.range) };
        }
        let next = steps.clone().find(|step| !is_kept(&step.kind));
        let until = next.map_or(last, |step| step.sample.min(last)).max(sample + 1);
        let end = next.map_or(program.end_range, |step| step.range).min(ranges[ranges.len() - 1]);
        let polarity = registers.polarity();
        let ramps = |range: f64| {
            [0, 1].map(|axis| program.start.ramps[axis].at(registers.folds()[axis], range / region_size))
        };
        let at = |range: f64| {
            let place = ramps(range).map(|(value, _)| value);
            let [height, hu, hv] = array(registers.hold(buffer), polarity, place);
            [height, (hu * cos + hv * sin) / region_size, (hv * cos - hu * sin) / region_size]
        };
        let (mut polynomials, middle, half_length) = match ranges[sample..until] {
            [only] => (at(only).map(|value| vec![value]), only, 1.0),
            [near, far] => {
                let (first, last) = (at(near), at(far));
                let line = |k: usize| vec![0.5 * (first[k] + last[k]), 0.5 * (last[k] - first[k])];
                ([line(0), line(1), line(2)], 0.5 * (near + far), 0.5 * (far - near))
            }
            _ => {
                let (middle, half_length) = (0.5 * (begin + end), 0.5 * (end - begin));
                let span = Span {
                    middle: ramps(middle).map(|(value, _)| value),
                    half: ramps(middle).map(|(_, rate)| rate * half_length / region_size),
                    half_length,
                    across: [-sin * polarity[0] / region_size, cos * polarity[1] / region_size],
                };
                let segment = Segment::expand(&Region::of(registers.hold(buffer), polarity), &span);
                let signals = [segment.height.to_vec(), segment.along.to_vec(), segment.across.to_vec()];
                (signals, middle, half_length)
            }
        };
        polynomials[0][0] -= datum;
        for range in &ranges[sample..until.min(span.end)] {
            let s = (S::from_f64(*range) - S::from_f64(middle)) * S::from_f64(1.0 / half_length);
            out.push(polynomials.each_ref().map(|coefficients| {
                let mut sum = S::ZERO;
                coefficients.iter().rev().for_each(|&coefficient| sum = sum * s + S::from_f64(coefficient));
                sum
            }));
        }
        sample = until;
    }
    out
}

fn level(region_size: f64) -> Level {
    let word = |k: usize| f64::from((k * 2_654_435 % 1009) as u32) / 504.0 - 1.0;
    let words: Vec<CornerWords> = (0..196).map(|k| std::array::from_fn(|n| word(9 * k + n))).collect();
    Level::new(region_size, [0.0; 2], [14, 14], words).unwrap()
}

/// Words that come late, alone, or from a corner that was not delivered, and folds that bring none.
fn disturb(program: &mut SweepProgram, ranges: &[f64], changes: &[(usize, usize, u8)]) {
    let count = program.steps.len();
    for &(index, later, what) in changes.iter().filter(|_| count > 0) {
        let step = &mut program.steps[index % count];
        let StepKind::Event(event) = &mut step.kind else { continue };
        *event = match *event {
            Event::Fold(fold) if what == 0 => Event::BareFold(fold),
            Event::Load(load) => {
                step.sample = (step.sample + later).min(ranges.len() - 1);
                step.range = step.range.max(ranges[step.sample]);
                let words = if what == 1 { WordMask::only(index % 9) } else { load.words };
                let corner = if what == 2 { NO_CORNER } else { load.corner };
                Event::Load(sweep_program::Load { words, corner, ..load })
            }
            event => event,
        };
    }
    program.steps.sort_by(|a, b| (a.sample, a.range).partial_cmp(&(b.sample, b.range)).expect("numbers"));
}

fn assert_same<S: Real>(
    generator: &TerrainGenerator<'_>,
    programs: &[SweepProgram; LANES],
    span: Range<usize>,
) -> Result<(), proptest::test_runner::TestCaseError> {
    let bits = |value: S| (value.to_f64().to_bits(), value);
    let mut methods = [Polynomials::<S>::default(), Polynomials::default()];
    methods[0].vectors = Width::baseline();
    for method in &mut methods {
        let mut profile = Profile::<S>::default();
        profile.resize(generator.ranges.len());
        // Twice: what the buffers held must not matter.
        for _ in 0..2 {
            method.trace(generator, programs, span.clone(), &mut profile);
        }
        for (lane, program) in programs.iter().enumerate() {
            let expected = one_by_one::<S>(generator, program, span.clone());
            for sample in 0..generator.ranges.len() {
                let values = profile.ground(sample).map(|signal| bits(signal[lane]));
                let expected = match sample.checked_sub(span.start) {
                    Some(k) if k < expected.len() => expected[k],
                    _ => [S::ZERO; 3],
                };
                prop_assert_eq!(values, expected.map(bits), "lane {}, sample {}", lane, sample);
            }
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn side_by_side_is_one_by_one(
        region_size in 5.0..120.0f64,
        eye in proptest::array::uniform2(0.01..12.99f64),
        (angle, spread) in (0.0..6.3f64, 0.0..0.2f64),
        (samples, step, growth) in (3..260usize, 0.3..30.0f64, 0.0..0.04f64),
        cut in (0..300usize, 0..300usize),
        changes in proptest::collection::vec((any::<usize>(), 0..20usize, 0..4u8), 0..12),
        narrow in any::<bool>(),
    ) {
        let level = level(region_size);
        let ranges: Vec<f64> = (0..samples)
            .scan((0.0, step), |(range, step), _| {
                *range += *step;
                *step *= 1.0 + growth;
                Some(*range)
            })
            .collect();
        let programs = std::array::from_fn(|lane| {
            let (sin, cos) = quantities::sin_cos(angle + spread * lane as f64);
            let eye = eye.map(|regions| regions * region_size);
            let mut program = program(&level, eye, [cos, sin], &ranges);
            if lane % 2 == 1 {
                disturb(&mut program, &ranges, &changes);
            }
            program
        });
        let generator = TerrainGenerator { buffer: level.words(), region_size, ranges: &ranges, datum: 0.37 };
        let [first, end] = [cut.0.min(cut.1), cut.0.max(cut.1)].map(|sample| sample.min(samples));
        if narrow {
            assert_same::<f32>(&generator, &programs, first..end)?;
        } else {
            assert_same::<f64>(&generator, &programs, first..end)?;
        }
    }
}

/// Level ground at the eye's height: what is straight through the array has no other zero than a polynomial.
#[test]
fn zero_is_zero() {
    let level = Level::new(10.0, [0.0; 2], [14, 14], vec![[0.0; 9]; 196]).unwrap();
    let ranges: Vec<f64> = (1..40).map(|k| f64::from(k * k) * 0.1).collect();
    let programs = std::array::from_fn(|_| program(&level, [30.0, 40.0], [0.8, -0.6], &ranges));
    for datum in [0.0, -0.0] {
        let generator = TerrainGenerator { buffer: level.words(), region_size: 10.0, ranges: &ranges, datum };
        assert_same::<f32>(&generator, &programs, 0..ranges.len()).unwrap();
    }
}
