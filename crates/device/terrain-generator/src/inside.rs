//! The inner wires of the array over one sweep, for whoever looks: function generators and shares of the colours.

use landscape::CornerWords;
use landscape::basis::values;
use signal::{LANES, Real};
use sweep_program::{Colour, SweepProgram};

use crate::of_parts::Tap;
use crate::{ArrayState, PartsArray, PartsTerrain, Profile, Registers, TerrainGenerator};

/// Signals inside an array over one sweep, one value a sample (fig. 19).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Inside {
    /// `g0`, `g1`, `g2` fed with X, 1-X, Y and 1-Y, signs of the polarity not yet put on.
    pub functions: [[Vec<f64>; 3]; 4],
    /// What the nine words of each colour add to the height (m), by [`sweep_program::Colour`]: before the summer, so of an
    /// array of parts without its offsets, and above the middle of the stored heights.
    pub colours: [Vec<f64>; 4],
}

impl TerrainGenerator<'_> {
    /// What runs through the array of ideal parts while `program` is swept, up to the last sample of the profile.
    pub fn inside(&self, program: &SweepProgram) -> Inside {
        let mut inside = Inside::default();
        let mut registers = Registers::at_start(program);
        let mut steps = program.steps.iter().peekable();
        let last = self.ranges.partition_point(|&range| range <= program.end_range);
        for (sample, &range) in self.ranges[..last].iter().enumerate() {
            while let Some(step) = steps.next_if(|step| step.sample <= sample) {
                registers.apply(step, self.buffer);
            }
            let lambda = range / self.region_size;
            let ramp = |axis: usize| program.start.ramps[axis].at(registers.folds()[axis], lambda).0;
            inside.add(&registers, self.buffer, [ramp(0), ramp(1)]);
        }
        inside
    }
}

impl<S: Real> PartsTerrain<'_, S> {
    /// What runs through the array of parts in lane `lane`: the group is swept once more, wire for wire as before.
    pub fn inside(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        lane: usize,
    ) -> Inside {
        let mut tapped = Tapped { lane, inside: Inside::default() };
        let (samples, mut profile) = (generator.ranges.len(), Profile::default());
        profile.resize(samples);
        let Self { array, state, address } = self;
        array.trace(generator, programs, 0..samples, *address, state, &mut profile, &mut tapped);
        tapped.inside
    }
}

/// One lane of an array of parts.
struct Tapped {
    lane: usize,
    inside: Inside,
}

impl<S: Real> Tap<S> for Tapped {
    fn see(&mut self, array: &PartsArray<S>, state: &ArrayState<S>) {
        for (fed, wires) in self.inside.functions.iter_mut().enumerate() {
            for (p, wire) in wires.iter_mut().enumerate() {
                wire.push(array.function(state, self.lane, fed, p));
            }
        }
        for colour in Colour::ALL {
            let share = array.share(state, self.lane, colour as usize);
            self.inside.colours[colour as usize].push(share);
        }
    }
}

impl Inside {
    fn add(&mut self, registers: &Registers, buffer: &[CornerWords], [x, y]: [f64; 2]) {
        let functions = [x, 1.0 - x, y, 1.0 - y].map(near);
        for (wires, values) in self.functions.iter_mut().zip(functions) {
            wires.iter_mut().zip(values).for_each(|(wire, value)| wire.push(value));
        }
        for (colour, words) in registers.hold(buffer).into_iter().enumerate() {
            let [a, b] = [colour & 1, colour >> 1];
            let signs = registers.polarity();
            let odd = [if a == 0 { signs[0] } else { -signs[0] }, if b == 0 { signs[1] } else { -signs[1] }];
            self.colours[colour].push(share(words, [functions[a], functions[2 + b]], odd));
        }
    }
}

/// `g_0p` of what a function generator is fed with.
fn near(fed: f64) -> [f64; 3] {
    let [g0, g1, g2, ..] = values(fed);
    [g0, g1, g2]
}

/// `sum e_x^p e_y^q g_p g_q f_pq` of one colour (section 6.4).
fn share(words: &CornerWords, [gx, gy]: [[f64; 3]; 2], odd: [f64; 2]) -> f64 {
    let term = |word: usize| {
        let (p, q) = (word / 3, word % 3);
        let sign = (if p == 1 { odd[0] } else { 1.0 }) * (if q == 1 { odd[1] } else { 1.0 });
        sign * gx[p] * gy[q] * words[word]
    };
    (0..9).map(term).sum()
}
