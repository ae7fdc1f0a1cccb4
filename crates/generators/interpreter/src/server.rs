//! Who brings the words: accesses of the storage buffer, tick by tick (sections 6.3, 22 no. 7; sheet of the DPU).

use hardware_model::{Cpu, CrossingServer, Loader};

use crate::event::{AskedFor, Register};

/// Which register a set is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// The set goes to this preload register.
    Preload(Register),
    /// The corner beyond both stops.
    Diagonal,
}

/// A set of nine words that waits.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Tick at which it was asked for.
    pub tick: i64,
    /// The stop that did.
    pub crossing: u32,
    /// Yellow, green, black, red.
    pub colour: usize,
    /// Register for which the set is meant.
    pub wanted: Wanted,
    /// Corner that it is of.
    pub corner: [i64; 2],
    /// The next stop of the other axis needs it.
    pub urgent: bool,
    /// Its stop has passed: straight on to hold.
    pub late: bool,
}

impl Asked {
    /// What it is, for the event list.
    pub fn set(&self) -> AskedFor {
        let register = match self.wanted {
            Wanted::Preload(register) => register,
            Wanted::Diagonal => Register::Diagonal,
        };
        AskedFor { colour: self.colour, register, crossing: self.crossing }
    }
}

/// A set on its way.
#[derive(Debug, Clone, Copy)]
pub struct Fetched {
    /// The set that was asked for.
    pub asked: Asked,
    /// Tick at which its first access begins.
    pub begins: i64,
    /// Tick at which each word is in its register.
    pub comes: [i64; 9],
}

/// What stands before the first set of a stop where the processor serves the crossings.
#[derive(Debug, Clone, Copy)]
pub struct Interrupts<'a> {
    /// Processor that serves the crossings.
    pub cpu: &'a Cpu,
    /// Tick until which it is at a set-up that no interrupt breaks; none if it is at none.
    pub held: Option<i64>,
    /// Numbers of the frame and of the sweep.
    pub place: (u64, u32),
    /// The share of the longest instruction that is left at an interrupt: drawn by frame, sweep and stop.
    pub draw: fn(u64, [u64; 3]) -> f64,
    /// The seed that it is drawn from.
    pub seed: u64,
}

impl Interrupts<'_> {
    /// Ticks of the interrupt of a stop; of a processor that is at something the rest of its instruction comes before.
    fn ticks(&self, crossing: u32, interrupts_a_task: bool) -> i64 {
        let (frame, sweep) = self.place;
        let share = (self.draw)(self.seed, [frame, u64::from(sweep), u64::from(crossing)]);
        let rest = if interrupts_a_task { share * self.cpu.longest_instruction as f64 } else { 0.0 };
        rest as i64 + self.cpu.crossing() as i64
    }
}

/// The lines over which words come: one a colour, or one for all.
#[derive(Debug, Clone)]
pub struct Server<'a> {
    loader: &'a Loader,
    interrupts: Interrupts<'a>,
    /// Tick from which on each line is free.
    free: [i64; 4],
    walked: i64,
    /// Stops whose chain of commands has been started: sets of a later one may go before those of an earlier.
    ordered: Vec<u32>,
    /// What waits, the longest asked first.
    pub queue: Vec<Asked>,
}

impl<'a> Server<'a> {
    /// Idle, from well before the sweep on.
    pub fn at_start(loader: &'a Loader, interrupts: Interrupts<'a>, begun: i64) -> Self {
        Self {
            loader,
            interrupts,
            free: [interrupts.held.unwrap_or(i64::MIN); 4],
            walked: begun - 1_000_000,
            ordered: Vec::new(),
            queue: Vec::new(),
        }
    }

    /// Tick by tick up to `last`: what each free line begins with.
    pub fn walk(&mut self, last: i64) -> Vec<Fetched> {
        let mut served = Vec::new();
        while self.walked < last && !self.queue.is_empty() {
            self.walked += 1;
            for line in 0..self.lines() {
                // A set that takes no time leaves the tick to the next.
                while self.free[line] <= self.walked
                    && let Some(set) = self.begin(line)
                {
                    served.push(set);
                }
            }
        }
        self.walked = self.walked.max(last);
        served
    }

    fn lines(&self) -> usize {
        if self.loader.served_by == CrossingServer::WiredPointers { 4 } else { 1 }
    }

    /// A free line begins with the set that is most urgent, else longest asked.
    fn begin(&mut self, line: usize) -> Option<Fetched> {
        let here = |set: &Asked| (self.lines() == 1 || set.colour == line) && set.tick <= self.walked;
        let urgent = self.queue.iter().position(|set| here(set) && set.urgent && self.loader.urgent_first);
        let chosen = urgent.or_else(|| self.queue.iter().position(here))?;
        let set = self.queue.remove(chosen);
        let chain = self.loader.channel_programme();
        let mut now = self.walked;
        if !self.ordered.contains(&set.crossing) {
            now += match self.loader.served_by {
                CrossingServer::CpuInterrupt => self.interrupts.ticks(set.crossing, now == set.tick),
                CrossingServer::IoProcessor | CrossingServer::WiredPointers => chain.order as i64,
            };
            self.ordered.push(set.crossing);
        }
        now += (chain.chain + self.loader.pointer) as i64;
        let begins = now;
        let width = self.loader.words_per_access as usize;
        let mut comes = [0; 9];
        for first in (0..9).step_by(width) {
            let words = first..(first + width).min(9);
            now += self.loader.access as i64 + chain.edit as i64 * words.len() as i64;
            words.for_each(|word| comes[word] = now + self.loader.strobe as i64);
        }
        self.free[line] = now;
        Some(Fetched { asked: set, begins, comes })
    }
}
