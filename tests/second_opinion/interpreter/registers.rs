//! Three registers for each of 36 multipliers, four pointers, and words on their way (sections 6.3, 6.5, 22 no. 8).

use hardware_model::{LatePolicy, Loader};
use landscape::Level;
use sweep_program::{Colour, PreloadRegister};

/// Axis of a ramp, and the register that its stops transfer: 0 is X and XFIRST, 1 is Y and YFIRST.
pub type Axis = usize;

/// Hardware corner (a, b) of each colour: yellow, green, black, red.
pub const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];
const YELLOW: usize = 0;
const GREEN: usize = 1;
const BLACK: usize = 2;
const RED: usize = 3;

/// The event table of 6.3: which two colours get new words at a stop.
fn colours_at(axis: Axis, at_one: bool) -> [usize; 2] {
    match (axis, at_one) {
        (0, false) => [RED, GREEN],
        (0, true) => [YELLOW, BLACK],
        (_, false) => [RED, BLACK],
        (_, true) => [GREEN, YELLOW],
    }
}

/// Master ticks seen from one sweep; times are in accumulator steps from its first sample.
#[derive(Debug, Clone, Copy)]
pub struct Clock {
    /// Ticks in one step.
    pub ticks_per_step: f64,
    /// Part of a tick that has passed when the sweep begins, 0..1.
    pub phase: f64,
}

impl Clock {
    /// `latency` ticks after the first tick at or after `time`.
    fn later(&self, time: f64, latency: u64) -> f64 {
        let seen = (self.phase + time * self.ticks_per_step).ceil();
        (seen + latency as f64 - self.phase) / self.ticks_per_step
    }
}

/// A word on its way to a register.
#[derive(Debug, Clone, Copy)]
struct Carried {
    arrival: f64,
    colour: usize,
    register: Axis,
    word: usize,
    value: f64,
    /// Its transfer is over: strobed through to hold when it arrives.
    late: bool,
}

/// The registers in front of the multipliers, and the digital side that fills them.
#[derive(Debug, Clone)]
pub struct Registers<'a> {
    /// What feeds the D/A multipliers: `[colour][3 p + q]`.
    pub hold: [[f64; 9]; 4],
    /// Words that missed their transfer so far.
    pub late_words: u64,
    first: [[[f64; 9]; 4]; 2],
    /// Lattice corner that each colour stands for.
    pub corner: [[i64; 2]; 4],
    carried: Vec<Carried>,
    events: u32,
    level: &'a Level,
    heading: [i64; 2],
    loader: &'a Loader,
    clock: Clock,
    frame: u64,
    sweep: u32,
}

impl<'a> Registers<'a> {
    /// All registers full, for a sweep that starts in `region` and goes along `heading`.
    pub fn at_start(
        level: &'a Level,
        loader: &'a Loader,
        clock: Clock,
        (frame, sweep): (u64, u32),
        region: [i64; 2],
        heading: [i64; 2],
    ) -> Self {
        // Yellow and black at the even one of K, K + 1, red and green at the odd one; likewise in L (6.5, rule 4).
        let corner = CORNERS.map(|side| {
            std::array::from_fn(|axis| {
                let parity = side[axis] as i64;
                if region[axis].rem_euclid(2) == parity { region[axis] } else { region[axis] + 1 }
            })
        });
        let mut registers = Self {
            hold: [[0.0; 9]; 4],
            late_words: 0,
            first: [[[0.0; 9]; 4]; 2],
            corner,
            carried: Vec::new(),
            events: 0,
            level,
            heading,
            loader,
            clock,
            frame,
            sweep,
        };
        for colour in 0..4 {
            registers.hold[colour] = registers.stored(corner[colour]);
            for register in 0..2 {
                registers.first[register][colour] = registers.stored(registers.ahead(colour, register));
            }
        }
        registers
    }

    /// Takes in every word that has arrived by `time`.
    pub fn receive(&mut self, time: f64) {
        let (arrived, still_carried): (Vec<_>, Vec<_>) =
            self.carried.drain(..).partition(|word| word.arrival <= time);
        self.carried = still_carried;
        for Carried { colour, register, word, value, late, .. } in arrived {
            match late {
                true => self.hold[colour][word] = value,
                false => self.first[register][colour][word] = value,
            }
        }
    }

    /// A stop of `axis` is met at `time`: transfer, then pointers, then requests.
    pub fn event(&mut self, axis: Axis, at_one: bool, time: f64) {
        let colours = colours_at(axis, at_one);
        for colour in colours {
            self.hold[colour] = self.first[axis][colour];
            self.sort_out(colour, axis);
            self.corner[colour][axis] += 2 * self.heading[axis];
        }
        for colour in colours {
            for register in 0..2 {
                self.ask(colour, register, time);
            }
        }
        self.events += 1;
    }

    /// Words still carried for a colour that has just moved on: those that this transfer needed are late and, under
    /// strobe-through, go to hold when they come; all others are for a place that the colour has left.
    fn sort_out(&mut self, colour: usize, axis: Axis) {
        let strobe = self.loader.late_policy == LatePolicy::StrobeThrough;
        let mut kept = Vec::new();
        for mut word in std::mem::take(&mut self.carried) {
            if word.colour != colour {
                kept.push(word);
            } else if word.register == axis && !word.late {
                self.late_words += 1;
                word.late = true;
                if strobe {
                    kept.push(word);
                }
            }
        }
        self.carried = kept;
    }

    /// Asks for the nine words of a register; a transfer without latency is wired and done at once.
    fn ask(&mut self, colour: usize, register: Axis, time: f64) {
        let words = self.stored(self.ahead(colour, register));
        for (word, value) in words.into_iter().enumerate() {
            let latency = self.loader.access + self.held_back(colour, register, word);
            if latency == 0 {
                self.first[register][colour][word] = value;
                continue;
            }
            let arrival = self.clock.later(time, latency);
            self.carried.push(Carried { arrival, colour, register, word, value, late: false });
        }
    }

    /// Extra ticks that a fault of the model adds to this word.
    fn held_back(&self, colour: usize, register: Axis, word: usize) -> u64 {
        let name = [Colour::Yellow, Colour::Green, Colour::Black, Colour::Red][colour];
        let waiting = [PreloadRegister::XFirst, PreloadRegister::YFirst][register];
        let meant = self.loader.delays.iter().find(|delay| {
            delay.frame.unwrap_or(self.frame) == self.frame
                && (delay.sweep, delay.crossing) == (self.sweep, self.events)
                && (delay.colour, delay.register, delay.word) == (name, waiting, word)
        });
        meant.map_or(0, |delay| delay.ticks)
    }

    /// One array step, that is two corners, ahead of the pointer along an axis.
    fn ahead(&self, colour: usize, axis: Axis) -> [i64; 2] {
        let mut corner = self.corner[colour];
        corner[axis] += 2 * self.heading[axis];
        corner
    }

    /// Words of a corner; pointers clamp to the last stored one.
    fn stored(&self, corner: [i64; 2]) -> [f64; 9] {
        let [north, east] = self.level.corners();
        let m = corner[0].max(0).min(north as i64 - 1) as usize;
        let n = corner[1].max(0).min(east as i64 - 1) as usize;
        self.level.words()[m * east + n]
    }
}
