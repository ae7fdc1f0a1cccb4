//! The inner wires of an array over one sweep, for whoever looks.

use landscape::CornerWords;
use landscape::basis::{derivatives, values};
use signal::{LANES, Real};
use sweep_program::{RampAxis, SweepProgram};

use crate::inner::InnerWire;
use crate::of_parts::Tap;
use crate::terms::{TERMS, factors, sign, word_of};
use crate::{ArrayState, PartsArray, PartsTerrain, Polynomials, Profile, Registers, TerrainGenerator};

/// Waveforms of some wires of one sweep, one value a sample, in the order in which they were asked for.
pub type Inside = Vec<Vec<f64>>;

impl TerrainGenerator<'_> {
    /// What `wires` of an array of ideal parts carry while program `lane` of a group is swept, up to the last sample of its
    /// profile. The sums are those of the machine's own scalar.
    pub fn inside<S: Real>(
        &self,
        programs: &[SweepProgram; LANES],
        lane: usize,
        wires: &[InnerWire],
    ) -> Inside {
        let program = &programs[lane];
        let mut inside = vec![Vec::new(); wires.len()];
        let mut registers = Registers::at_start(program);
        let mut steps = program.steps.iter().peekable();
        let last = self.ranges.partition_point(|&range| range <= program.end_range);
        for (sample, &range) in self.ranges[..last].iter().enumerate() {
            while let Some(step) = steps.next_if(|step| step.sample <= sample) {
                registers.apply(step, self.buffer);
            }
            let lambda = range / self.region_size;
            let ramps =
                std::array::from_fn(|axis| program.start.ramps[axis].at(registers.folds()[axis], lambda).0);
            let now = Instant::new(ramps, &registers, self);
            inside.iter_mut().zip(wires).for_each(|(values, wire)| values.push(now.value(*wire)));
        }
        if wires.iter().any(|wire| matches!(wire, InnerWire::Sum(_))) {
            let mut profile = Profile::<S>::default();
            self.trace_by(&mut Polynomials::default(), programs, &mut profile);
            self.put_sums((program, lane), last, wires, &profile, &mut inside);
        }
        inside
    }

    /// Sums of a lane at the first `samples` samples, from the profile that the array has put out.
    fn put_sums<S: Real>(
        &self,
        (program, lane): (&SweepProgram, usize),
        samples: usize,
        wires: &[InnerWire],
        profile: &Profile<S>,
        inside: &mut Inside,
    ) {
        let [cos, sin] = program.start.direction;
        let at = |sample: usize, sum: usize| {
            let [height, along, across] =
                [&profile.height, &profile.along, &profile.across].map(|wire| wire[sample][lane].to_f64());
            match sum {
                0 => height + self.datum,
                1 => cos * along - sin * across,
                _ => sin * along + cos * across,
            }
        };
        for (values, wire) in inside.iter_mut().zip(wires) {
            if let InnerWire::Sum(sum) = wire {
                *values = (0..samples).map(|sample| at(sample, *sum)).collect();
            }
        }
    }

    /// What the accumulator of an axis holds at each of `ranges` (m, ascending).
    fn accumulated(
        &self,
        program: &SweepProgram,
        axis: usize,
        ranges: impl Iterator<Item = f64>,
    ) -> Vec<f64> {
        let is_of_axis = |own: RampAxis| (own == RampAxis::Y) == (axis == 1);
        let folds =
            program.steps.iter().filter(|step| step.kind.fold().is_some_and(|fold| is_of_axis(fold.axis)));
        let (mut folds, mut count) = (folds.peekable(), 0);
        let value = |range: f64| {
            while folds.next_if(|fold| fold.range <= range).is_some() {
                count += 1;
            }
            program.start.ramps[axis].at(count, range / self.region_size).0
        };
        ranges.map(value).collect()
    }
}

impl<S: Real> PartsTerrain<'_, S> {
    /// What `wires` of an array of parts carry in lane `lane`, at all samples: the group is swept once more, wire for wire as
    /// before.
    pub fn inside(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        lane: usize,
        wires: &[InnerWire],
    ) -> Inside {
        let mut tapped =
            Tapped { lane, wires, inside: vec![Vec::new(); wires.len()], region_size: generator.region_size };
        let (samples, mut profile) = (generator.ranges.len(), Profile::default());
        profile.resize(samples);
        let Self { array, state, address } = self;
        array.trace(generator, programs, 0..samples, *address, state, &mut profile, &mut tapped);
        let mut inside = tapped.inside;
        let last = generator.ranges.partition_point(|&range| range <= programs[lane].end_range);
        generator.put_sums((&programs[lane], lane), last, wires, &profile, &mut inside);
        for (values, wire) in inside.iter_mut().zip(wires) {
            if let InnerWire::Accumulator(axis) = wire {
                let ranges = (0..samples).map(|sample| array.accumulated(generator.ranges, sample));
                *values = generator.accumulated(&programs[lane], *axis, ranges);
            }
        }
        inside
    }
}

/// One lane of an array of parts.
struct Tapped<'a> {
    lane: usize,
    wires: &'a [InnerWire],
    inside: Inside,
    region_size: f64,
}

impl<S: Real> Tap<S> for Tapped<'_> {
    fn see(&mut self, array: &PartsArray<S>, state: &ArrayState<S>) {
        for (values, wire) in self.inside.iter_mut().zip(self.wires) {
            values.extend(array.wire(*wire, state, self.lane, self.region_size));
        }
    }
}

/// An array of ideal parts at one instant.
struct Instant<'a> {
    ramps: [f64; 2],
    functions: [[f64; 3]; 4],
    derivatives: [[f64; 3]; 4],
    polarity: [f64; 2],
    hold: [&'a CornerWords; 4],
    region_size: f64,
}

impl<'a> Instant<'a> {
    fn new([x, y]: [f64; 2], registers: &'a Registers, generator: &'a TerrainGenerator<'_>) -> Self {
        let fed = [x, 1.0 - x, y, 1.0 - y];
        Self {
            ramps: [x, y],
            functions: fed.map(|fed| near(values(fed))),
            derivatives: fed.map(|fed| near(derivatives(fed))),
            polarity: registers.polarity(),
            hold: registers.hold(generator.buffer),
            region_size: generator.region_size,
        }
    }

    /// What a wire carries; the sums come from the profile.
    fn value(&self, wire: InnerWire) -> f64 {
        match wire {
            InnerWire::Accumulator(axis) | InnerWire::Ramp(axis) => self.ramps[axis],
            InnerWire::Function { fed, order } => self.functions[fed][order],
            InnerWire::Derivative { fed, order } => self.derivatives[fed][order],
            InnerWire::Product { sum, term } => self.product(sum, term),
            InnerWire::Converter { sum, term } => self.converted(sum, term),
            InnerWire::Colour(colour) => {
                let terms = (0..TERMS).filter(|&term| word_of(term)[0] == colour);
                terms.map(|term| self.converted(0, term)).sum()
            }
            InnerWire::Sum(_) => 0.0,
        }
    }

    /// `e_x e_y g_p g_q` (section 6.4).
    fn product(&self, sum: usize, term: usize) -> f64 {
        let [x, y] = factors(sum, term);
        self.factor(0, x) * self.factor(1, y)
    }

    fn factor(&self, axis: usize, unit: usize) -> f64 {
        let curves = if unit < 6 { &self.functions } else { &self.derivatives };
        sign(unit, self.polarity[axis]) * curves[2 * axis + unit / 3 % 2][unit % 3]
    }

    fn converted(&self, sum: usize, term: usize) -> f64 {
        let [colour, word] = word_of(term);
        let scale = if sum == 0 { 1.0 } else { 1.0 / self.region_size };
        self.product(sum, term) * self.hold[colour][word] * scale
    }
}

/// Those of the near end.
fn near<const N: usize>(all: [f64; N]) -> [f64; 3] {
    [all[0], all[1], all[2]]
}

/// Words in the hold registers of all colours over a sweep, and when they are there (samples from the start of the sweep):
/// at its beginning, and whenever any of them is another.
pub fn held_words(program: &SweepProgram, buffer: &[CornerWords]) -> Vec<(f64, [CornerWords; 4])> {
    let mut registers = Registers::at_start(program);
    let beginning = program.steps.first().map_or(0.0, |step| step.time.0.min(0.0));
    let mut held = vec![(beginning, registers.hold(buffer).map(|words| *words))];
    for step in &program.steps {
        registers.apply(step, buffer);
        let now = registers.hold(buffer).map(|words| *words);
        if held.last().is_none_or(|(_, before)| *before != now) {
            held.push((step.time.0, now));
        }
    }
    held
}
