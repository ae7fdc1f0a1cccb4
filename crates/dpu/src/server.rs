//! Who answers a fold: four banks with wired pointers, an I/O processor, or the processor itself (hardware 4.4).

use hardware_model::{Cpu, CrossingServer, Loader};
use quantities::{Tick, unit_interval};
use sweep_program::{Colour, PreloadRegister, WordMask};

use crate::watch::LineUse;

/// Words of a set.
const SET: u32 = 9;

/// What a set is wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// A preload register.
    Register(PreloadRegister),
    /// The register of the corner beyond both stops.
    Diagonal,
}

/// A set that was asked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Job {
    pub number: u32,
    pub colour: Colour,
    pub wanted: Wanted,
    /// Index in the level.
    pub corner: u32,
    /// When the fold was seen.
    pub asked: Tick,
    /// The fold, counted from 0 in the sweep.
    pub crossing: u32,
    /// Whether the next stop of the other axis needs it.
    pub urgent: bool,
    /// Whether a fold has already found it missing.
    pub late: bool,
}

/// A set on its way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Served {
    pub job: Job,
    /// When the first access begins.
    pub begin: Tick,
    /// Whether it had to wait for others.
    pub waited: bool,
}

/// The queue within one sweep; retrace clears it (our choice).
#[derive(Debug)]
pub(crate) struct Server<'a> {
    loader: &'a Loader,
    cpu: &'a Cpu,
    /// Seed and place of the sweep, for what the processor happens to be at.
    seed: u64,
    place: [u64; 2],
    queue: Vec<Job>,
    free_at: [Tick; 4],
    /// Folds whose interrupt was handled.
    handled: Vec<u32>,
    lines: [LineUse; 4],
}

impl<'a> Server<'a> {
    /// `held` is when a processor that serves the crossings is done with a set-up that no interrupt breaks.
    pub fn new(loader: &'a Loader, cpu: &'a Cpu, seed: u64, place: [u64; 2], held: Tick) -> Self {
        Self {
            loader,
            cpu,
            seed,
            place,
            queue: Vec::new(),
            free_at: [held; 4],
            handled: Vec::new(),
            lines: [LineUse::default(); 4],
        }
    }

    /// Bank of a colour; a processor has one line for all.
    fn line_of(&self, colour: Colour) -> usize {
        if self.loader.served_by == CrossingServer::WiredPointers { colour as usize } else { 0 }
    }

    pub fn ask(&mut self, job: Job) {
        self.queue.push(job);
        let line = self.line_of(job.colour);
        let waiting = self.queue.iter().filter(|job| self.line_of(job.colour) == line).count() as u32;
        self.lines[line].longest_queue = self.lines[line].longest_queue.max(waiting);
    }

    /// What waits, to be changed or dropped.
    pub fn retain(&mut self, keep: impl FnMut(&mut Job) -> bool) {
        self.queue.retain_mut(keep);
    }

    pub fn use_of_lines(&self) -> [LineUse; 4] {
        self.lines
    }

    /// The next set whose service begins before `end`, at any time if that is open.
    pub fn next(&mut self, end: Option<Tick>) -> Option<Served> {
        (0..self.free_at.len()).find_map(|line| self.next_of_line(line, end))
    }

    fn next_of_line(&mut self, line: usize, end: Option<Tick>) -> Option<Served> {
        let own = || self.queue.iter().filter(|job| self.line_of(job.colour) == line);
        let start = own().map(|job| job.asked).min()?.max(self.free_at[line]);
        if end.is_some_and(|end| start >= end) {
            return None;
        }
        let rank = |job: &Job| (!(job.urgent && self.loader.urgent_first), job.number);
        let first = own().filter(|job| job.asked <= start).min_by_key(|job| rank(job))?.number;
        let index = self.queue.iter().position(|job| job.number == first)?;
        let job = self.queue.remove(index);
        let (rest, interrupt) = self.recognition(&job, start);
        let begin = Tick(start.0 + rest + interrupt + self.loader.pointer);
        let end = Tick(begin.0 + u64::from(self.accesses()) * self.loader.access);
        self.lines[line].busy += end.0 - start.0 - rest;
        self.lines[line].interrupts += interrupt;
        self.free_at[line] = end;
        Some(Served { job, begin, waited: start > job.asked })
    }

    /// Time from the start of a service to its pointers: the rest of the instruction that the processor is at, which is
    /// the interrupted task's, and the interrupt itself, once for all sets of a fold.
    fn recognition(&mut self, job: &Job, start: Tick) -> (u64, u64) {
        let is_served_so = self.loader.served_by == CrossingServer::CpuInterrupt;
        // The newest stand last, and an urgent set may go before those of an older fold.
        if !is_served_so || self.handled.iter().rev().any(|&fold| fold == job.crossing) {
            return (0, 0);
        }
        self.handled.push(job.crossing);
        let interrupted = start == job.asked;
        let share = unit_interval(self.seed, &[self.place[0], self.place[1], u64::from(job.crossing)]);
        let rest = if interrupted { (share * self.cpu.longest_instruction as f64) as u64 } else { 0 };
        (rest, self.cpu.crossing())
    }

    fn accesses(&self) -> u32 {
        SET.div_ceil(self.loader.words_per_access)
    }

    /// The words of a set and when they are in their register, access by access.
    pub fn arrivals(&self, served: &Served) -> impl Iterator<Item = (Tick, WordMask)> + use<> {
        let begin = served.begin.0;
        let Loader { words_per_access: width, access, strobe, .. } = *self.loader;
        (0..self.accesses()).map(move |number| {
            let words = WordMask::range(number * width, ((number + 1) * width).min(SET));
            (Tick(begin + u64::from(number + 1) * access + strobe), words)
        })
    }
}
