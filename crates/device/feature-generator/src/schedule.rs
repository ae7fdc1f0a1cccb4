//! Control side: which craters a sweep meets, and which sub-generator makes each.

use features::{Crater, Features};
use hardware_model::{FeatureParts, Organisation};
use quantities::SweepTime;
use sweep_program::{LoadTiming, NoTiming};

use crate::SubGeneratorPlace;
use crate::chord::{foot, half_chord};
use crate::loads::{FeatureArrival, FeatureMiss, bring};

/// What programs are written from: the same for every sweep of a frame.
#[derive(Debug, Clone, Copy)]
pub struct Schedule<'a> {
    /// All craters of the problem area.
    pub features: &'a Features,
    /// Sub-generators and their organisation.
    pub parts: FeatureParts,
    /// South-west corner of region (0, 0): north, east (m).
    pub region_origin: [f64; 2],
    /// Side of the regions by which features are grouped (m).
    pub region_size: f64,
    /// The craters that the sweep can meet, ascending, where that is known; otherwise all are asked.
    pub among: Option<&'a [u32]>,
    /// Craters whose words no storage buffer has as the sweep begins, ascending: the sweep does not know of them.
    pub absent: &'a [u32],
}

/// A crater in a sub-generator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureLoad {
    /// Index of the crater.
    pub crater: u32,
    /// Which sub-generator of its type, from 0.
    pub sub_generator: u32,
    /// Ground range at which the sweep passes the centre (m).
    pub middle: f64,
    /// Distance of the centre beside the sweep, positive to the right (m).
    pub side: f64,
    /// Ground range from which it is drawn, where its words come behind its edge; negative infinity if they are in time
    /// (m).
    pub from: f64,
}

/// Loads of one sweep. Reused from sweep to sweep: once warm, nothing is allocated.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FeatureProgram {
    /// Craters that are drawn, ascending: the order of the sum.
    pub loads: Vec<FeatureLoad>,
    /// Ground range at which the profile ends (m).
    pub end_range: f64,
    /// Craters that found no free sub-generator.
    pub dropped: u32,
    /// Most sub-generators in use at once, by crater type.
    pub most_in_use: [u32; 3],
    /// Craters that are not drawn, or not from their edge on, in the order in which the sweep meets them.
    pub misses: Vec<FeatureMiss>,
    /// Loads that took time, in the order in which they came.
    pub arrivals: Vec<FeatureArrival>,
    /// Ticks that the loads took the line.
    pub load_ticks: u64,
    found: Vec<u32>,
    requests: Vec<Request>,
    /// Range at which each sub-generator is free again, by crater type.
    busy: [Vec<f64>; 3],
}

impl FeatureProgram {
    /// What of the program one sub-generator draws.
    pub fn share_of(&self, place: SubGeneratorPlace, features: &Features) -> Self {
        let is_own = |load: &&FeatureLoad| {
            load.sub_generator == place.number && features.crater(load.crater).type_number() == place.kind
        };
        let loads = self.loads.iter().filter(is_own).copied().collect();
        Self { loads, end_range: self.end_range, ..Self::default() }
    }
}

/// A crater that asks for a sub-generator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Request {
    pub load: FeatureLoad,
    /// Crater type, from 0.
    pub kind: usize,
    /// Ranges at which the sweep enters and leaves the footprint (m).
    pub entry: f64,
    pub exit: f64,
    /// Range from which the sub-generator is taken (m).
    pub taken: f64,
    /// Range at which it is free again (m).
    pub freed: f64,
}

/// A sweep over the ground.
#[derive(Debug, Clone, Copy)]
struct Line {
    eye: [f64; 2],
    direction: [f64; 2],
    from: f64,
    to: f64,
}

impl Schedule<'_> {
    /// Writes the program of the sweep from `eye` (north, east; m) along the unit vector `direction`, between two
    /// ground ranges (m). Loads take no time.
    pub fn write(&self, eye: [f64; 2], direction: [f64; 2], span: [f64; 2], program: &mut FeatureProgram) {
        self.write_by(eye, direction, span, None::<NoTiming>, program);
    }

    /// The same with loads that take the time of `timing`, if there is any.
    pub fn write_by(
        &self,
        eye: [f64; 2],
        direction: [f64; 2],
        [from, to]: [f64; 2],
        timing: Option<LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>>,
        program: &mut FeatureProgram,
    ) {
        let line = Line { eye, direction, from, to };
        self.find(&line, program);
        let request = |&index: &u32| self.request(index, &line);
        program.requests.extend(program.found.iter().map(request));
        program.order();
        match timing {
            None => program.serve(self.parts.sub_generators),
            Some(timing) => program.serve_in_time(&self.parts, timing),
        }
        program.loads.sort_unstable_by_key(|load| load.crater);
    }

    /// Which craters the sweep meets.
    fn find(&self, &Line { eye, direction, from, to }: &Line, program: &mut FeatureProgram) {
        program.clear(to);
        if self.features.is_empty() {
            return;
        }
        match self.among {
            None => self.features.along(eye, direction, from, to, &mut program.found),
            Some(among) => self.features.along_among(among, eye, direction, from, to, &mut program.found),
        }
        if !self.absent.is_empty() {
            program.found.retain(|crater| self.absent.binary_search(crater).is_err());
        }
    }

    fn request(&self, index: u32, line: &Line) -> Request {
        let crater = &self.features.crater(index);
        let [middle, side] = line.foot(crater);
        let half = half_chord(crater.outer(), side);
        let (entry, exit) = ((middle - half).max(line.from), (middle + half).min(line.to));
        let (taken, freed) = match self.parts.organisation {
            Organisation::Scheduled => (entry, exit),
            Organisation::ByRegion => (self.region(line, entry)[0], self.region(line, exit)[1]),
        };
        let load = FeatureLoad { crater: index, sub_generator: 0, middle, side, from: f64::NEG_INFINITY };
        Request { load, kind: crater.type_number() as usize - 1, entry, exit, taken, freed }
    }

    /// Ranges at which the sweep enters and leaves the region that it is in at `range` (m).
    fn region(&self, line: &Line, range: f64) -> [f64; 2] {
        let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
        for axis in 0..2 {
            let (start, rate) = (line.eye[axis] - self.region_origin[axis], line.direction[axis]);
            if rate != 0.0 {
                let line = ((start + range * rate) / self.region_size).floor();
                // The edge between two regions is one place for both, to the last bit.
                let meets = [line, line + 1.0].map(|line| (line * self.region_size - start) / rate);
                ends[0] = ends[0].max(meets[0].min(meets[1]));
                ends[1] = ends[1].min(meets[0].max(meets[1]));
            }
        }
        ends
    }
}

impl FeatureLoad {
    /// Ground range at which the sweep meets the footprint of its `crater` (m); below 0 behind the eye.
    pub fn edge(&self, crater: &Crater) -> f64 {
        self.middle - half_chord(crater.outer(), self.side)
    }
}

impl Line {
    /// Range at which the line passes the centre of a crater, and the distance of the centre to the right (m).
    fn foot(&self, crater: &Crater) -> [f64; 2] {
        foot([0, 1].map(|axis| crater.centre()[axis] - self.eye[axis]), self.direction)
    }
}

impl FeatureProgram {
    fn clear(&mut self, end_range: f64) {
        (self.end_range, self.dropped, self.most_in_use) = (end_range, 0, [0; 3]);
        self.load_ticks = 0;
        self.arrivals.clear();
        self.misses.clear();
        self.loads.clear();
        self.found.clear();
        self.requests.clear();
        self.busy.iter_mut().for_each(Vec::clear);
    }

    /// Requests in the order in which the sweep comes to need sub-generators.
    fn order(&mut self) {
        self.requests.sort_unstable_by(|a, b| {
            let by_range = a.taken.total_cmp(&b.taken).then(a.entry.total_cmp(&b.entry));
            by_range.then(a.load.crater.cmp(&b.load.crater))
        });
    }

    /// Gives sub-generators to the requests, nearest first.
    fn serve(&mut self, limit: Option<u32>) {
        for request in &self.requests {
            match take(&mut self.busy[request.kind], request, limit) {
                Some(sub_generator) => self.loads.push(FeatureLoad { sub_generator, ..request.load }),
                None => {
                    self.dropped += 1;
                    self.misses.push(FeatureMiss::occupied(request));
                }
            }
        }
        // The first free one is taken, so as many were opened as were ever in use at once.
        self.most_in_use = self.busy.each_ref().map(|busy| busy.len() as u32);
    }

    /// The same where words take time. Of the free sub-generators that is taken which has been free for longest: its words
    /// can come soonest.
    fn serve_in_time(
        &mut self,
        parts: &FeatureParts,
        mut timing: LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>,
    ) {
        for index in 0..self.requests.len() {
            let request = self.requests[index];
            let busy = &mut self.busy[request.kind];
            let Some(found) = longest_free(busy, &request, parts.sub_generators) else {
                self.dropped += 1;
                self.misses.push(FeatureMiss::occupied(&request));
                continue;
            };
            busy[found.0 as usize] = request.freed;
            let in_use = busy.iter().filter(|&&freed| freed > request.taken).count() as u32;
            self.most_in_use[request.kind] = self.most_in_use[request.kind].max(in_use);
            let found = bring(&mut timing, &request, found, parts.organisation);
            self.loads.extend(found.load);
            self.misses.extend(found.miss);
            self.arrivals.push(found.arrival);
        }
        self.load_ticks = timing.line.busy();
    }
}

/// The first sub-generator that is free, if there is one.
fn take(busy: &mut Vec<f64>, request: &Request, limit: Option<u32>) -> Option<u32> {
    if let Some(free) = busy.iter().position(|&freed| freed <= request.taken) {
        busy[free] = request.freed;
        return Some(free as u32);
    }
    let next = busy.len() as u32;
    limit.is_none_or(|limit| next < limit).then(|| {
        busy.push(request.freed);
        next
    })
}

/// The sub-generator that has been free for longest, and the range since when; one that was not used yet has been free
/// always. `None` if all are taken.
fn longest_free(busy: &mut Vec<f64>, request: &Request, limit: Option<u32>) -> Option<(u32, f64)> {
    let next = busy.len() as u32;
    if limit.is_none_or(|limit| next < limit) {
        busy.push(f64::NEG_INFINITY);
        return Some((next, f64::NEG_INFINITY));
    }
    let free = busy.iter().copied().enumerate().filter(|&(_, freed)| freed <= request.taken);
    free.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, freed)| (index as u32, freed))
}
