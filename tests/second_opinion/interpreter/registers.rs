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
    /// The first tick at or after `time`, counted from the last one before the sweep.
    fn seen(&self, time: f64) -> i64 {
        (self.phase + time * self.ticks_per_step).ceil() as i64
    }

    /// When a tick falls.
    fn time_of(&self, tick: i64) -> f64 {
        (tick as f64 - self.phase) / self.ticks_per_step
    }
}

/// A set that waits for an access of the storage buffer.
#[derive(Debug, Clone, Copy)]
struct Asked {
    tick: i64,
    event: u32,
    colour: usize,
    register: Axis,
    words: [f64; 9],
    /// The next stop of the other axis needs it.
    urgent: bool,
    late: bool,
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
    asked: Vec<Asked>,
    /// Ticks from which on each bank of the storage buffer is free, and up to which all have been walked.
    free: [i64; 4],
    walked: i64,
    /// Whether each ramp meets 1 next; `None` for one that stands.
    rising: [Option<bool>; 2],
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
        rising: [Option<bool>; 2],
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
            asked: Vec::new(),
            free: [i64::MIN; 4],
            walked: -1_000_000,
            rising,
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
        self.walk_banks((self.clock.phase + time * self.clock.ticks_per_step).floor() as i64);
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

    /// Tick by tick up to `last`: a bank that is free begins with the set that is most urgent, else longest asked.
    fn walk_banks(&mut self, last: i64) {
        if self.asked.is_empty() {
            self.walked = self.walked.max(last);
            return;
        }
        for tick in self.walked + 1..=last {
            for bank in 0..4 {
                if self.free[bank] > tick {
                    continue;
                }
                let mut waiting: Vec<usize> =
                    (0..self.asked.len()).filter(|&k| self.asked[k].colour == bank).collect();
                waiting.retain(|&k| self.asked[k].tick <= tick);
                let urgent =
                    waiting.iter().copied().find(|&k| self.asked[k].urgent && self.loader.urgent_first);
                if let Some(chosen) = urgent.or(waiting.first().copied()) {
                    let set = self.asked.remove(chosen);
                    self.fetch(set, tick);
                }
            }
        }
        self.walked = self.walked.max(last);
    }

    /// One access after another; held-back words come later than the last of them.
    fn fetch(&mut self, set: Asked, tick: i64) {
        let width = self.loader.words_per_access as usize;
        let begin = tick + self.loader.pointer as i64;
        let comes = |word: usize| {
            begin + (word / width + 1) as i64 * self.loader.access as i64 + self.loader.strobe as i64
        };
        self.free[set.colour] = comes(8) - self.loader.strobe as i64;
        for (word, value) in set.words.into_iter().enumerate() {
            let held = self.held_back(set.event, set.colour, set.register, word) as i64;
            let arrival = self.clock.time_of(if held > 0 { comes(8) + held } else { comes(word) });
            let late = set.late && held == 0;
            self.carried.push(Carried {
                arrival,
                colour: set.colour,
                register: set.register,
                word,
                value,
                late,
            });
        }
    }

    /// A stop of `axis` is met at `time`: transfer, then pointers, then requests.
    pub fn event(&mut self, axis: Axis, at_one: bool, time: f64) {
        self.rising[axis] = Some(!at_one);
        self.walk_banks(self.clock.seen(time) - 1);
        let colours = colours_at(axis, at_one);
        for colour in colours {
            self.hold[colour] = self.first[axis][colour];
            self.sort_out(colour, axis);
            self.corner[colour][axis] += 2 * self.heading[axis];
        }
        for colour in colours {
            for register in 0..2 {
                self.ask(axis, colour, register, time);
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
        let mut kept = Vec::new();
        for mut set in std::mem::take(&mut self.asked) {
            if set.colour != colour {
                kept.push(set);
            } else if set.register == axis && !set.late {
                self.late_words += 9;
                set.late = true;
                if strobe {
                    kept.push(set);
                }
            }
        }
        self.asked = kept;
    }

    /// Asks for the nine words of a register; a transfer without latency is wired and done at once.
    fn ask(&mut self, axis: Axis, colour: usize, register: Axis, time: f64) {
        let words = self.stored(self.ahead(colour, register));
        let (event, tick) = (self.events, self.clock.seen(time));
        if self.loader.access + self.loader.pointer + self.loader.strobe > 0 {
            let next = self.rising[register].map(|at_one| colours_at(register, at_one));
            let urgent = register != axis && next.is_some_and(|colours| colours.contains(&colour));
            self.asked.push(Asked { tick, event, colour, register, words, urgent, late: false });
            return;
        }
        for (word, value) in words.into_iter().enumerate() {
            match self.held_back(event, colour, register, word) as i64 {
                0 => self.first[register][colour][word] = value,
                held => {
                    let arrival = self.clock.time_of(tick + held);
                    self.carried.push(Carried { arrival, colour, register, word, value, late: false });
                }
            }
        }
    }

    /// Extra ticks that a fault of the model adds to this word.
    fn held_back(&self, event: u32, colour: usize, register: Axis, word: usize) -> u64 {
        let name = [Colour::Yellow, Colour::Green, Colour::Black, Colour::Red][colour];
        let waiting = [PreloadRegister::XFirst, PreloadRegister::YFirst][register];
        let meant = self.loader.delays.iter().find(|delay| {
            delay.frame.unwrap_or(self.frame) == self.frame
                && (delay.sweep, delay.crossing) == (self.sweep, event)
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
