//! The registers of 36 multipliers, four pointers, and words on their way (sections 6.3, 6.5, 22 no. 8).

use hardware_model::{LatePolicy, Loader};
use landscape::Level;

use crate::clock::Clock;
use crate::drums::Arrivals;
use crate::event::{AskedFor, Event, Happening, Register};
use crate::server::{Asked, Fetched, Interrupts, Server, Wanted};

/// Hardware corner (a, b) of each colour: yellow, green, black, red.
pub const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];
const YELLOW: usize = 0;
const GREEN: usize = 1;
const BLACK: usize = 2;
const RED: usize = 3;
/// The preload register that a stop of X, of Y transfers.
const PRELOADS: [Register; 2] = [Register::XFirst, Register::YFirst];
const ALL_WORDS: u16 = 0x1ff;

/// The event table of 6.3: which two colours get new words at a stop.
fn colours_at(axis: usize, at_one: bool) -> [usize; 2] {
    match (axis, at_one) {
        (0, false) => [GREEN, RED],
        (0, true) => [YELLOW, BLACK],
        (_, false) => [BLACK, RED],
        (_, true) => [YELLOW, GREEN],
    }
}

/// A word on its way to a register.
#[derive(Debug, Clone, Copy)]
struct Carried {
    tick: i64,
    colour: usize,
    /// Axis of the preload register that waits for it; `None` for the diagonal one.
    axis: Option<usize>,
    /// None for a word of 0.
    corner: Option<[i64; 2]>,
    word: usize,
    /// Its transfer is over: strobed through to hold when it arrives.
    late: bool,
}

/// A corner with its words.
#[derive(Debug, Clone, Copy)]
struct Set {
    /// None for words of 0.
    corner: Option<[i64; 2]>,
    words: [f64; 9],
}

/// A fold, or words that come to hold late: what parts may see of the digital side.
#[derive(Debug, Clone, Copy)]
pub struct Change {
    /// When, in accumulator steps from the first sample.
    pub time: f64,
    /// Axis of the ramp that folds, and whether at 1; none where words alone arrive.
    pub fold: Option<(usize, bool)>,
    /// What the hold registers have from then on.
    pub hold: [[f64; 9]; 4],
}

/// Where and when a sweep begins, as the registers need it.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    /// Region of the eye's foot.
    pub region: [i64; 2],
    /// +1 or -1 along each axis.
    pub heading: [i64; 2],
    /// Whether each ramp meets 1 next; `None` for one that stands.
    pub rising: [Option<bool>; 2],
    /// Where the processor serves the crossings, what stands before the sets of each.
    pub interrupts: Interrupts<'a>,
    /// Level of terrain: 0 fine, 1 coarse.
    pub level: usize,
}

/// The registers in front of the multipliers, and the digital side that fills them.
#[derive(Debug, Clone)]
pub struct Registers<'a> {
    /// What feeds the D/A multipliers: `[colour][3 p + q]`.
    pub hold: [[f64; 9]; 4],
    /// Events of the registers so far.
    pub events: Vec<Event>,
    /// Folds and late words, in order.
    pub changes: Vec<Change>,
    first: [[Set; 4]; 2],
    /// Words of each preload register that have come since its colour moved, bit 3 p + q.
    come: [[u16; 4]; 2],
    /// Whether all words beyond both stops are there.
    diagonal: [bool; 4],
    /// Lattice corner that each colour stands for.
    corner: [[i64; 2]; 4],
    carried: Vec<Carried>,
    server: Server<'a>,
    start: Start<'a>,
    crossings: u32,
    level: &'a Level,
    /// Corners that the storage buffer has not when the frame begins.
    missing: &'a Arrivals,
    loader: &'a Loader,
    clock: Clock,
}

impl<'a> Registers<'a> {
    /// Makes the registers as a sweep begins: all of them full.
    pub fn at_start(
        (level, missing): (&'a Level, &'a Arrivals),
        loader: &'a Loader,
        clock: Clock,
        start: Start<'a>,
    ) -> Self {
        // Yellow and black at the even one of K, K + 1, red and green at the odd one; likewise in L (6.5, rule 4).
        let corner = CORNERS.map(|side| {
            std::array::from_fn(|axis| {
                let parity = side[axis] as i64;
                let region = start.region[axis];
                if region.rem_euclid(2) == parity { region } else { region + 1 }
            })
        });
        let empty = Set { corner: None, words: [0.0; 9] };
        let mut registers = Self {
            hold: [[0.0; 9]; 4],
            events: Vec::new(),
            changes: Vec::new(),
            first: [[empty; 4]; 2],
            come: [[0; 4]; 2],
            diagonal: [true; 4],
            corner,
            carried: Vec::new(),
            server: Server::at_start(loader, start.interrupts, clock.begun),
            start,
            crossings: 0,
            level,
            missing,
            loader,
            clock,
        };
        for colour in 0..4 {
            registers.hold[colour] = registers.home(colour, Register::Hold, corner[colour]).words;
            for axis in 0..2 {
                let ahead = registers.ahead(colour, Some(axis));
                registers.first[axis][colour] = registers.home(colour, PRELOADS[axis], ahead);
            }
        }
        registers
    }

    /// What a register holds as the sweep begins.
    fn home(&mut self, colour: usize, register: Register, corner: [i64; 2]) -> Set {
        let (tick, corner) = (self.clock.seen(0.0), self.stored(corner));
        self.note(tick, Happening::Home { colour, register, corner });
        self.look_up(tick, colour, register, None, corner)
    }

    /// The words of a corner, or of none if the storage buffer has not got it at `tick`.
    fn look_up(
        &mut self,
        tick: i64,
        colour: usize,
        register: Register,
        crossing: Option<u32>,
        corner: [i64; 2],
    ) -> Set {
        let is_there =
            self.missing.get(&corner).is_none_or(|arrival| arrival.is_some_and(|comes| comes <= tick));
        if !is_there {
            self.note(tick, Happening::Absent { colour, register, crossing, corner });
        }
        self.set(is_there.then_some(corner))
    }

    /// Takes in every word that has arrived by `time`.
    pub fn receive(&mut self, time: f64) {
        self.receive_ticks(self.clock.last_before(time));
    }

    fn receive_ticks(&mut self, last: i64) {
        self.walk(last);
        let (mut arrived, still): (Vec<_>, Vec<_>) =
            self.carried.drain(..).partition(|word| word.tick <= last);
        self.carried = still;
        arrived.sort_by_key(|word| word.tick);
        for Carried { tick, colour, axis, corner, word, late } in arrived {
            let value = self.set(corner).words[word];
            let Some(axis) = axis else {
                self.diagonal[colour] |= word == 8;
                continue;
            };
            let register = if late {
                self.hold[colour][word] = value;
                self.changes.push(Change { time: self.clock.time_of(tick), fold: None, hold: self.hold });
                Register::Hold
            } else {
                self.first[axis][colour].words[word] = value;
                if word == 0 {
                    self.first[axis][colour].corner = corner;
                }
                self.come[axis][colour] |= 1 << word;
                PRELOADS[axis]
            };
            self.note(tick, Happening::Load { colour, register, corner, words: 1 << word });
        }
    }

    /// Lets the lines work up to a tick.
    fn walk(&mut self, last: i64) {
        for Fetched { asked: set, begins, comes } in self.server.walk(last) {
            let asked = set.set();
            self.note(begins, Happening::Access { set: asked, corner: set.corner });
            let found = self.look_up(begins, set.colour, asked.register, Some(set.crossing), set.corner);
            let axis = match set.wanted {
                Wanted::Preload(register) => Some(usize::from(register == Register::YFirst)),
                Wanted::Diagonal => None,
            };
            for word in 0..9 {
                let held = axis.map_or(0, |axis| self.held_back(set.crossing, set.colour, axis, word));
                self.carried.push(Carried {
                    tick: if held > 0 { comes[8] + held } else { comes[word] },
                    colour: set.colour,
                    axis,
                    corner: found.corner,
                    word,
                    late: set.late && held == 0,
                });
            }
        }
    }

    /// A stop of `axis` is met at `time`: transfer, then pointers, then requests.
    pub fn event(&mut self, axis: usize, at_one: bool, time: f64) {
        let seen = self.clock.seen(time);
        self.start.rising[axis] = Some(!at_one);
        self.walk(seen - 1);
        let crossing = self.crossings;
        self.note(seen, Happening::Stop { axis, at_one, crossing });
        self.crossings += 1;
        let colours = colours_at(axis, at_one);
        if self.loader.stop_after_crossings.is_some_and(|last| crossing >= last) {
            for colour in colours {
                let register = PRELOADS[axis];
                self.note(seen, Happening::Late { colour, register, crossing, words: ALL_WORDS });
            }
            self.changes.push(Change { time, fold: Some((axis, at_one)), hold: self.hold });
            return;
        }
        self.transfer(axis, at_one, time);
        for colour in colours {
            let Set { corner, .. } = self.first[axis][colour];
            self.note(seen, Happening::Transfer { colour, register: PRELOADS[axis], crossing, corner });
            self.overwrite(colour, axis, seen);
            self.sort_out(colour, axis, seen, crossing);
            self.corner[colour][axis] += 2 * self.start.heading[axis];
        }
        for colour in colours {
            self.renew(axis, colour, crossing, seen);
        }
    }

    /// Hold takes what waits for a stop of `axis`. The stop at which the stored ground ends does so too, though it is nobody's event:
    /// parts that run ahead of the beam see it.
    pub fn transfer(&mut self, axis: usize, at_one: bool, time: f64) {
        for colour in colours_at(axis, at_one) {
            self.hold[colour] = self.first[axis][colour].words;
        }
        self.changes.push(Change { time, fold: Some((axis, at_one)), hold: self.hold });
    }

    /// What waits in the other preload register of a colour that moves is of no use, full or not.
    fn overwrite(&mut self, colour: usize, axis: usize, seen: i64) {
        let other = 1 - axis;
        if self.come[other][colour] == ALL_WORDS {
            let corner = self.first[other][colour].corner;
            self.note(seen, Happening::Wasted { colour, register: PRELOADS[other], corner });
        }
        self.come[0][colour] = 0;
        self.come[1][colour] = 0;
    }

    /// Words still carried for a colour that has just moved on: those that this transfer needed are late and, under
    /// strobe-through, go to hold when they come; all others are for a place that the colour has left.
    fn sort_out(&mut self, colour: usize, axis: usize, seen: i64, crossing: u32) {
        let strobe = self.loader.late_policy == LatePolicy::StrobeThrough;
        let mut missing = 0;
        self.carried.retain_mut(|word| {
            if word.colour != colour {
                return true;
            }
            let needed = word.axis == Some(axis) && !word.late;
            if needed {
                missing |= 1 << word.word;
                word.late = true;
            }
            needed && strobe
        });
        let mut dropped = Vec::new();
        self.server.queue.retain_mut(|set| {
            if set.colour != colour {
                return true;
            }
            let needed = set.wanted == Wanted::Preload(PRELOADS[axis]) && !set.late;
            if needed {
                missing = ALL_WORDS;
                set.late = true;
            }
            let kept = needed && strobe;
            dropped.extend((!kept).then(|| set.set()));
            kept
        });
        dropped.into_iter().for_each(|set| self.note(seen, Happening::Cancelled(set)));
        if missing != 0 {
            let register = PRELOADS[axis];
            self.note(seen, Happening::Late { colour, register, crossing, words: missing });
        }
    }

    /// What a colour that has moved needs: both preload registers, and the diagonal one where there is one.
    fn renew(&mut self, axis: usize, colour: usize, crossing: u32, seen: i64) {
        let loader = self.loader;
        let wired = loader.is_wired_through();
        let moves_over = loader.diagonal_register && !wired && self.diagonal[colour];
        for register in 0..2 {
            let corner = self.stored(self.ahead(colour, Some(register)));
            let set = AskedFor { colour, register: PRELOADS[register], crossing };
            if wired {
                self.note(seen, Happening::Wanted(set));
                self.note(seen, Happening::Access { set, corner });
                self.put(set, register, seen, corner);
            } else if moves_over && register != axis {
                self.note(seen, Happening::Diagonal { set, corner });
                self.put(set, register, seen, corner);
            } else {
                self.ask(axis, colour, Wanted::Preload(PRELOADS[register]), crossing, seen, corner);
            }
        }
        if loader.diagonal_register && !wired {
            self.diagonal[colour] = false;
            let corner = self.stored(self.ahead(colour, None));
            self.ask(axis, colour, Wanted::Diagonal, crossing, seen, corner);
        }
    }

    /// Words that take no time: wired, or moved over from the diagonal register.
    fn put(
        &mut self,
        AskedFor { colour, register, crossing }: AskedFor,
        axis: usize,
        seen: i64,
        corner: [i64; 2],
    ) {
        let Set { corner, words } = self.look_up(seen, colour, register, Some(crossing), corner);
        let mut come = 0;
        for word in 0..9 {
            match self.held_back(crossing, colour, axis, word) {
                0 => {
                    self.first[axis][colour].words[word] = words[word];
                    if word == 0 {
                        self.first[axis][colour].corner = corner;
                    }
                    come |= 1 << word;
                }
                held => self.carried.push(Carried {
                    tick: seen + held,
                    colour,
                    axis: Some(axis),
                    corner,
                    word,
                    late: false,
                }),
            }
        }
        self.come[axis][colour] |= come;
        if come != 0 {
            self.note(seen, Happening::Load { colour, register, corner, words: come });
        }
    }

    fn ask(
        &mut self,
        axis: usize,
        colour: usize,
        wanted: Wanted,
        crossing: u32,
        tick: i64,
        corner: [i64; 2],
    ) {
        let other = 1 - axis;
        let next = self.start.rising[other].map(|at_one| colours_at(other, at_one));
        let urgent = wanted == Wanted::Preload(PRELOADS[other])
            && next.is_some_and(|colours| colours.contains(&colour));
        let asked = Asked { tick, crossing, colour, wanted, corner, urgent, late: false };
        self.note(tick, Happening::Wanted(asked.set()));
        self.server.queue.push(asked);
    }

    /// Extra ticks that a fault of the model adds to this word.
    fn held_back(&self, crossing: u32, colour: usize, axis: usize, word: usize) -> i64 {
        let (frame, sweep) = self.start.interrupts.place;
        let meant = self.loader.delays.iter().find(|delay| {
            self.start.level == 0
                && delay.frame.unwrap_or(frame) == frame
                && (delay.sweep, delay.crossing) == (sweep, crossing)
                && (delay.colour as usize, delay.register as usize, delay.word) == (colour, axis, word)
        });
        meant.map_or(0, |delay| delay.ticks as i64)
    }

    /// One array step, that is two corners, ahead of the pointer along an axis, or along both.
    fn ahead(&self, colour: usize, axis: Option<usize>) -> [i64; 2] {
        std::array::from_fn(|k| {
            let moves = axis.is_none_or(|axis| axis == k);
            self.corner[colour][k] + if moves { 2 * self.start.heading[k] } else { 0 }
        })
    }

    /// Pointers clamp to the last stored corner.
    fn stored(&self, corner: [i64; 2]) -> [i64; 2] {
        let corners = self.level.corners();
        std::array::from_fn(|axis| corner[axis].clamp(0, corners[axis] as i64 - 1))
    }

    /// The words of a stored corner, or 0.
    fn set(&self, corner: Option<[i64; 2]>) -> Set {
        let words = |[m, n]: [i64; 2]| self.level.words()[m as usize * self.level.corners()[1] + n as usize];
        Set { corner, words: corner.map_or([0.0; 9], words) }
    }

    fn note(&mut self, tick: i64, what: Happening) {
        // Words of one access are one event.
        if let (Happening::Load { colour, register, corner, words }, Some(last)) =
            (what, self.events.last_mut())
            && let Event {
                tick: before,
                what: Happening::Load { colour: c, register: r, corner: k, words: w },
                ..
            } = last
            && (*before, *c, *r, *k) == (tick, colour, register, corner)
        {
            *w |= words;
            return;
        }
        self.events.push(Event { tick, level: Some(self.start.level), what });
    }
}
