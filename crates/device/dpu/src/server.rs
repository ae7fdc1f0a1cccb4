//! Who answers a fold: four banks with wired pointers, an I/O processor, or the processor itself (hardware 4.4).

use std::ops::Range;

use hardware_model::{Cpu, CrossingServer, IoProcessor, Loader};
use quantities::{Tick, unit_interval};
use smallvec::SmallVec;
use sweep_program::{Colour, PreloadRegister, WordMask};

use crate::accesses::Accesses;
use crate::watch::{LineUse, Register};

/// What a set is wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// The set goes to this preload register.
    Register(PreloadRegister),
    /// The register of the corner beyond both stops.
    Diagonal,
}

impl Wanted {
    /// Returns the register for which the set is wanted.
    pub fn register(self) -> Register {
        match self {
            Self::Register(register) => Register::Preload(register),
            Self::Diagonal => Register::Diagonal,
        }
    }
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

/// Jobs before one line; most often a fold leaves four, and the next finds them served.
type Queue = SmallVec<[Job; 8]>;

/// The queue within one sweep. What waits at the last fold is served on into retrace; nothing of it waits for the next sweep
/// (our choice).
#[derive(Debug)]
pub(crate) struct Server<'a> {
    loader: &'a Loader,
    programme: IoProcessor,
    accesses: Accesses,
    cpu: &'a Cpu,
    /// Seed and place of the sweep, for what the processor happens to be at.
    seed: u64,
    place: [u64; 2],
    /// What waits for each line, in order of number, and so of the time at which it was asked for.
    queues: [Queue; 4],
    free_at: [Tick; 4],
    /// Folds whose interrupt was handled, or whose chain of commands was started.
    begun: Vec<u32>,
    lines: [LineUse; 4],
}

impl<'a> Server<'a> {
    /// `held` is when a processor that serves the crossings is done with a set-up that no interrupt breaks.
    pub fn new(loader: &'a Loader, cpu: &'a Cpu, seed: u64, place: [u64; 2], held: Tick) -> Self {
        Self {
            loader,
            programme: loader.channel_programme(),
            accesses: Accesses::of(loader),
            cpu,
            seed,
            place,
            queues: Default::default(),
            free_at: [held; 4],
            begun: Vec::new(),
            lines: [LineUse::default(); 4],
        }
    }

    /// Bank of a colour; a processor has one line for all.
    fn line_of(&self, colour: Colour) -> usize {
        if self.loader.served_by == CrossingServer::WiredPointers { colour as usize } else { 0 }
    }

    #[inline]
    pub fn ask(&mut self, job: Job) {
        let line = self.line_of(job.colour);
        self.queues[line].push(job);
        let waiting = self.queues[line].len() as u32;
        self.lines[line].longest_queue = self.lines[line].longest_queue.max(waiting);
    }

    /// What waits behind the two colours of a fold, to be changed or dropped, in order of number.
    pub fn retain(&mut self, colours: [Colour; 2], mut keep: impl FnMut(&mut Job) -> bool) {
        let [first, second] = colours.map(|colour| self.line_of(colour));
        if first == second {
            return self.queues[first].retain_mut(|job| !colours.contains(&job.colour) || keep(job));
        }
        let is_before = |a: &Queue, b: &Queue| match (a.last(), b.last()) {
            (Some(a), Some(b)) => a.number < b.number,
            _ => true,
        };
        let order = [first, second];
        let order =
            if is_before(&self.queues[first], &self.queues[second]) { order } else { [second, first] };
        order.into_iter().for_each(|line| self.queues[line].retain_mut(&mut keep));
    }

    pub fn use_of_lines(&self) -> [LineUse; 4] {
        self.lines
    }

    /// Lines that serve sets.
    pub fn lines(&self) -> Range<usize> {
        0..if self.loader.served_by == CrossingServer::WiredPointers { Colour::ALL.len() } else { 1 }
    }

    /// The next set of a line whose service begins before `end`, at any time if that is open.
    #[inline]
    pub fn next(&mut self, line: usize, end: Option<Tick>) -> Option<Served> {
        let queue = &mut self.queues[line];
        let first = queue.first()?;
        let start = first.asked.max(self.free_at[line]);
        if end.is_some_and(|end| start >= end) {
            return None;
        }
        let waits = || queue.iter().take_while(|job| job.asked <= start);
        let urgent = if self.loader.urgent_first { waits().position(|job| job.urgent) } else { None };
        let job = queue.remove(urgent.unwrap_or(0));
        let Opening { rest, interrupt, order } = self.open(&job, start);
        let set = self.programme.chain + self.loader.pointer;
        let begin = Tick(start.0 + rest + interrupt + order + set);
        let end = self.accesses.end(begin);
        self.lines[line].busy += end.0 - start.0 - rest;
        self.lines[line].interrupts += interrupt;
        self.free_at[line] = end;
        Some(Served { job, begin, waited: start > job.asked })
    }

    /// What stands before the first set of a fold that is served, once for all of its sets.
    fn open(&mut self, job: &Job, start: Tick) -> Opening {
        let opens = self.loader.served_by != CrossingServer::WiredPointers;
        // The newest stand last, and an urgent set may go before those of an older fold.
        if !opens || self.begun.iter().rev().any(|&fold| fold == job.crossing) {
            return Opening::default();
        }
        self.begun.push(job.crossing);
        if self.loader.served_by == CrossingServer::IoProcessor {
            return Opening { order: self.programme.order, ..Opening::default() };
        }
        let interrupted = start == job.asked;
        let share = unit_interval(self.seed, &[self.place[0], self.place[1], u64::from(job.crossing)]);
        let rest = if interrupted { (share * self.cpu.longest_instruction as f64) as u64 } else { 0 };
        Opening { rest, interrupt: self.cpu.crossing(), order: 0 }
    }

    /// When the last word of a set is in its register.
    pub fn last(&self, served: &Served) -> Tick {
        self.accesses.last(served.begin)
    }

    /// The words of a set and when they are in their register.
    pub fn arrivals(&self, served: &Served) -> impl Iterator<Item = (Tick, WordMask)> + use<> {
        self.accesses.arrivals(served.begin)
    }
}

/// Ticks before the first set of a fold.
#[derive(Debug, Clone, Copy, Default)]
struct Opening {
    /// Rest of the instruction that the processor is at, which is the interrupted task's.
    rest: u64,
    /// Time of the interrupt itself (ticks).
    interrupt: u64,
    /// The order that starts the chain of an I/O processor.
    order: u64,
}

#[cfg(test)]
mod tests {
    use hardware_model::{Cpu, CrossingServer, HardwareModel, IoProcessor, Loader};
    use quantities::{Tick, unit_interval};
    use sweep_program::{Colour, PreloadRegister};

    use super::{Job, Server, Wanted};

    fn loader(served_by: CrossingServer, words_per_access: u32, io_processor: IoProcessor) -> Loader {
        let [pointer, access, strobe] = [1, 5, 2];
        Loader {
            served_by,
            words_per_access,
            pointer,
            access,
            strobe,
            io_processor,
            ..HardwareModel::ideal().loader
        }
    }

    fn job(number: u32, colour: Colour, asked: u64, crossing: u32) -> Job {
        let wanted = Wanted::Register(PreloadRegister::XFirst);
        Job { number, colour, wanted, corner: 0, asked: Tick(asked), crossing, urgent: false, late: false }
    }

    /// Sets of the folds at `asked`, four each; begin and end of service, last word.
    fn served(loader: &Loader, asked: &[u64]) -> (Vec<[u64; 2]>, u64) {
        let cpu = Cpu::default();
        let mut server = Server::new(loader, &cpu, 0, [0; 2], Tick(0));
        for (crossing, &asked) in asked.iter().enumerate() {
            for set in 0..4 {
                let number = (4 * crossing + set) as u32;
                server.ask(Job {
                    urgent: set == 0,
                    ..job(number, Colour::ALL[set / 2], asked, crossing as u32)
                });
            }
        }
        let mut sets = Vec::new();
        while let Some(found) = server.lines().find_map(|line| server.next(line, None)) {
            sets.push([found.begin.0, server.last(&found).0]);
        }
        (sets, server.use_of_lines()[0].busy)
    }

    const PROGRAMME: IoProcessor = IoProcessor { order: 7, chain: 3, edit: 2 };

    /// Order, command, pointer, nine accesses with a word each to be edited, strobe.
    #[test]
    fn an_uncontended_set_takes_the_sum_of_its_parts() {
        let (sets, _) = served(&loader(CrossingServer::IoProcessor, 1, PROGRAMME), &[100]);
        let begin = 100 + 7 + 3 + 1;
        assert_eq!(sets[0], [begin, begin + 9 * (5 + 2) + 2]);
        // Two words an access: five accesses, nine words edited.
        let (sets, _) = served(&loader(CrossingServer::IoProcessor, 2, PROGRAMME), &[100]);
        assert_eq!(sets[0], [begin, begin + 5 * 5 + 9 * 2 + 2]);
    }

    /// The order is given once for the four sets of a crossing.
    #[test]
    fn four_sets_of_a_crossing_share_its_order() {
        let set = 3 + 1 + 9 * (5 + 2);
        let (sets, busy) = served(&loader(CrossingServer::IoProcessor, 1, PROGRAMME), &[100]);
        let begins: Vec<u64> = sets.iter().map(|set| set[0]).collect();
        assert_eq!(begins, [0, 1, 2, 3].map(|number| 100 + 7 + number * set + 3 + 1));
        assert_eq!(busy, 7 + 4 * set);
        // Also where sets of a later crossing go before those of an earlier one.
        let (sets, busy) = served(&loader(CrossingServer::IoProcessor, 1, PROGRAMME), &[100, 101]);
        assert_eq!((sets.len() as u64, busy), (8, 2 * (7 + 4 * set)));
        // The first set of the second crossing is urgent, and second in line.
        assert_eq!(sets[1][0], 100 + 7 + set + 7 + 3 + 1);
    }

    /// Recognition waits for the rest of the instruction at hand, which is the interrupted task's time; a fold that is seen
    /// while the processor serves another interrupts nothing.
    #[test]
    fn an_interrupt_waits_for_the_instruction_at_hand() {
        let (cpu, seed, place) =
            (Cpu { longest_instruction: 1000, interrupt: 300, ..Cpu::default() }, 5, [2, 7]);
        let loader = loader(CrossingServer::CpuInterrupt, 1, PROGRAMME);
        let mut server = Server::new(&loader, &cpu, seed, place, Tick(0));
        assert_eq!(server.lines(), 0..1);
        for (crossing, asked) in [(0, 100), (1, 101)] {
            server.ask(job(crossing, Colour::Red, asked, crossing));
        }
        let rest = (unit_interval(seed, &[2, 7, 0]) * 1000.0) as u64;
        assert!(rest > 10);
        let set = 9 * 5;
        let [first, second] = [server.next(0, None), server.next(0, None)].map(Option::unwrap);
        assert_eq!((first.begin, first.waited), (Tick(100 + rest + cpu.crossing() + 1), false));
        assert_eq!((second.begin, second.waited), (Tick(first.begin.0 + set + cpu.crossing() + 1), true));
        let [used, ..] = server.use_of_lines();
        assert_eq!(used.busy, 2 * (cpu.crossing() + 1 + set));
        assert_eq!((used.interrupts, used.longest_queue), (2 * cpu.crossing(), 2));
    }

    #[test]
    fn what_waits_behind_a_fold_is_offered_in_order_of_number() {
        use Colour::{Black, Green, Yellow};
        let cpu = Cpu::default();
        for server in [CrossingServer::WiredPointers, CrossingServer::IoProcessor] {
            for colours in [[Yellow, Green, Black], [Green, Yellow, Black], [Yellow, Black, Green]] {
                let loader = loader(server, 1, PROGRAMME);
                let mut server = Server::new(&loader, &cpu, 0, [0; 2], Tick(0));
                for (number, colour) in (0..).zip(colours) {
                    server.ask(job(number, colour, 100, 0));
                }
                let mut offered = Vec::new();
                server.retain([Yellow, Green], |job| {
                    offered.push(job.number);
                    job.colour == Green
                });
                let expected: Vec<u32> =
                    (0..).zip(colours).filter(|(_, c)| *c != Black).map(|(n, _)| n).collect();
                assert_eq!(offered, expected, "{colours:?}");
                let mut left = Vec::new();
                while let Some(found) = server.lines().find_map(|line| server.next(line, None)) {
                    left.push(found.job.colour);
                }
                left.sort();
                assert_eq!(left, [Green, Black], "{colours:?}");
            }
        }
        let wired = loader(CrossingServer::WiredPointers, 1, PROGRAMME);
        assert_eq!(Server::new(&wired, &cpu, 0, [0; 2], Tick(0)).lines(), 0..4);
    }

    #[test]
    fn others_have_no_channel_programme() {
        for (server, count) in [(CrossingServer::WiredPointers, 4), (CrossingServer::CpuInterrupt, 8)] {
            let [with, without] = [PROGRAMME, IoProcessor::default()]
                .map(|programme| served(&loader(server, 1, programme), &[100, 101]));
            assert_eq!(with, without);
            assert!(with.0.len() >= count);
        }
        let without = served(&loader(CrossingServer::IoProcessor, 1, IoProcessor::default()), &[100]);
        assert_eq!(without.1, 4 * (1 + 9 * 5));
    }
}
