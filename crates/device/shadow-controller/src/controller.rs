//! From boundary segments to the gate of every sweep.

use std::iter;

use hardware_model::ShadowParts;
use parts::GateEdge;
use quantities::SweepTime;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use remote_shadow::Outlines;
use signal::LANES;
use sweep_program::{LoadTiming, NoTiming};

use crate::crossing::{Bare, Crossing, Known, step};
use crate::crossings::{Crossings, Met, ROOM, Sighting};
use crate::line_generators::{
    Boundary, SegmentLoad, SegmentMiss, Service, ServiceWork, serve, serve_in_time,
};
use crate::side_by_side::SideBySide;

/// Two boundaries nearer to each other than this along a sweep are none (m): far less than a display line, far more
/// than rounding.
pub const RESOLUTION: f64 = 1e-6;

/// Sweeps that are worked on together.
const BAND: usize = 64;

/// The blanking gate of one sweep.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gate {
    /// Whether the sweep starts in shadow.
    pub dark_at_start: bool,
    /// Ground ranges at which the gate changes (m, ascending, up to the reach).
    pub toggles: Vec<f64>,
    /// By how much each of them moves along the sweep for an error of its line of the line's full scale, its length (m); 0
    /// where no line generator makes it; none at all where nobody asks.
    pub swings: Vec<f64>,
    /// Crossings up to the reach that are no boundary between light and shadow: shadows that overlap, edges of tiles.
    pub united: u32,
    /// Boundary segments that found no line generator free.
    pub dropped: u32,
    /// Most line generators in use at one time; 0 without line generators.
    pub most_in_use: u32,
    /// Boundaries that do not act, or not where they are crossed, in the order in which the sweep comes to need them.
    pub misses: Vec<SegmentMiss>,
    /// Loads that took time, in the order in which they came.
    pub loads: Vec<SegmentLoad>,
    /// Ticks that the loads took the line.
    pub load_ticks: u64,
}

impl Gate {
    /// Whether the sweep is in shadow at a ground range (m); at a change, what it changes to.
    pub fn is_dark(&self, range: f64) -> bool {
        let before = self.toggles.partition_point(|&toggle| toggle <= range);
        self.dark_at_start ^ (before % 2 == 1)
    }

    /// Lets no shadow lie beyond `reach` (m), which is not before the last change: no line generator makes that edge.
    pub fn end_at(&mut self, reach: f64) {
        if self.is_dark(reach) {
            self.toggles.push(reach);
            if !self.swings.is_empty() {
                self.swings.push(0.0);
            }
        }
    }

    /// Has it change at boundaries, which ascend.
    fn change_at(&mut self, boundaries: &[Boundary]) {
        self.toggles.clear();
        self.toggles.extend(boundaries.iter().map(|boundary| boundary.range));
        self.swings.clear();
        self.swings.extend(boundaries.iter().map(|boundary| boundary.swing));
    }

    /// Where it changes, as the comparators see it.
    pub fn edges(&self) -> impl Iterator<Item = GateEdge> {
        let pairs = self.toggles.iter().zip(self.swings());
        pairs.map(|(&range, swing)| GateEdge { range, slope: 1.0 / swing.abs() })
    }

    /// The swing of each change, 0 where nobody asked.
    pub(crate) fn swings(&self) -> impl Iterator<Item = f64> {
        self.swings.iter().copied().chain(iter::repeat(0.0))
    }
}

/// The shadow controller and its I/O processor.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowController {
    /// What it is made of.
    pub parts: ShadowParts,
    /// Centre of the map in the scan converter: north, east (m).
    pub map_centre: [f64; 2],
    /// Side of that map (m).
    pub map_side: f64,
    /// Whether gates tell their swings and how many line generators they need: a picture of ideal parts asks for neither.
    pub tells_lines: bool,
}

impl ShadowController {
    /// The gate of every sweep, up to a ground range of `reach` (m).
    ///
    /// `directions`: unit vectors (north, east) of the sweeps from left to right, less than half a turn apart in all.
    /// `shadows`: any number of lists of outlines; shadow to the right. What lies behind the eye
    /// (north, east; m) does not count. `out` gets one gate a sweep; its buffers are used again.
    pub fn gates(
        &self,
        eye: [f64; 2],
        directions: &[[f64; 2]],
        reach: f64,
        shadows: &[&Outlines],
        out: &mut Vec<Gate>,
    ) {
        self.gates_by(eye, directions, reach, shadows, |_| None::<NoTiming>, out);
    }

    /// The same with loads that take the time of `timing` of each sweep, if there is any.
    pub fn gates_by<T: Fn(f64) -> SweepTime, R: Fn(SweepTime) -> f64>(
        &self,
        eye: [f64; 2],
        directions: &[[f64; 2]],
        reach: f64,
        shadows: &[&Outlines],
        timing: impl Fn(u32) -> Option<LoadTiming<T, R>> + Sync,
        out: &mut Vec<Gate>,
    ) {
        match self.parts {
            ShadowParts::Digital { line_generators } => {
                let asks = self.tells_lines || line_generators.is_some() || timing(0).is_some();
                if asks {
                    let met = Met::new(directions, shadows, Places { eye });
                    find_known(&met, line_generators, reach, timing, out);
                } else {
                    find_bare(&Met::new(directions, shadows, Places { eye }), reach, out);
                }
            }
            ShadowParts::ScanConverter { .. } => {
                let (eye, scale) = self.reading(eye);
                find_bare(&Met::new(directions, shadows, Map { eye, scale }), reach, out);
            }
        }
    }

    /// The place (north, east; m) whose shadows the sweeps meet at an eye, and how many times as far from it: a map in a scan
    /// converter is read beside its place, as `centre + (place - centre) (1 + gain) + offset side` says, lines at theirs.
    pub fn reading(&self, eye: [f64; 2]) -> ([f64; 2], f64) {
        match self.parts {
            ShadowParts::Digital { .. } => (eye, 1.0),
            ShadowParts::ScanConverter { offset, gain } => {
                let scale = 1.0 + gain;
                let place = |axis: usize| {
                    let centre = self.map_centre[axis];
                    centre + (eye[axis] - offset[axis] * self.map_side - centre) / scale
                };
                ([0, 1].map(place), scale)
            }
        }
    }
}

/// Gates of sweeps of which only ranges of crossings are known.
fn find_bare(met: &Met<'_, impl Sighting, Bare>, reach: f64, out: &mut Vec<Gate>) {
    out.resize_with(met.sweeps(), Gate::default);
    out.par_chunks_mut(BAND).enumerate().for_each_init(SideBySide::default, |lanes, (band, gates)| {
        for (sweep, group) in (band * BAND..).step_by(LANES).zip(gates.chunks_mut(LANES)) {
            lanes.find(met, sweep, reach, group);
        }
    });
}

/// Gates of sweeps whose boundaries occupy line generators.
fn find_known<T: Fn(f64) -> SweepTime, R: Fn(SweepTime) -> f64>(
    met: &Met<'_, impl Sighting, Known>,
    line_generators: Option<u32>,
    reach: f64,
    timing: impl Fn(u32) -> Option<LoadTiming<T, R>> + Sync,
    out: &mut Vec<Gate>,
) {
    out.resize_with(met.sweeps(), Gate::default);
    let room = || (Crossings::new(), Vec::with_capacity(ROOM), Vec::with_capacity(ROOM), ServiceWork::new());
    out.par_chunks_mut(BAND).enumerate().for_each_init(
        room,
        |(crossings, changes, boundaries, work), (band, gates)| {
            for (sweep, gate) in (band * BAND..).zip(gates) {
                let crossed = crossings.of(met, sweep);
                // Few lie beyond.
                let beyond = crossed.iter().rev().take_while(|crossing| crossing.range() > reach).count();
                let within = crossed.len() - beyond;
                gate.dark_at_start = unite(crossed, within, changes);
                gate.united = (within - changes.len()) as u32;
                boundaries.clear();
                boundaries.extend(changes.iter().map(|&crossing| met.boundary(sweep, crossing)));
                load(boundaries, line_generators, work, reach, timing(sweep as u32), gate);
            }
        },
    );
}

/// Changes the gate of a sweep as its line generators are served.
fn load(
    boundaries: &mut Vec<Boundary>,
    line_generators: Option<u32>,
    work: &mut ServiceWork,
    reach: f64,
    timing: Option<LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>>,
    gate: &mut Gate,
) {
    let mut load_ticks = 0;
    let service = match timing {
        None => serve(boundaries, line_generators, work),
        Some(mut timing) => {
            let service = serve_in_time(boundaries, line_generators, reach, &mut timing);
            load_ticks = timing.line.busy();
            service
        }
    };
    let Service { dropped, most_in_use, misses, loads } = service;
    (gate.dropped, gate.most_in_use, gate.load_ticks) = (dropped, most_in_use, load_ticks);
    (gate.misses, gate.loads) = (misses, loads);
    gate.change_at(boundaries);
}

/// Places where they are.
struct Places {
    eye: [f64; 2],
}

impl Sighting for Places {
    #[inline(always)]
    fn seen(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        [north - self.eye[0], east - self.eye[1]]
    }
}

/// Places of the map as the sweep meets them in a scan converter ([`ShadowController::reading`]).
struct Map {
    eye: [f64; 2],
    scale: f64,
}

impl Sighting for Map {
    fn seen(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        [(north - self.eye[0]) * self.scale, (east - self.eye[1]) * self.scale]
    }
}

/// The I/O processor's editing: of all `crossings` of a sweep those between light and shadow, of the first `within`. Returns
/// whether the sweep starts in shadow.
fn unite(crossings: &[Known], within: usize, out: &mut Vec<Known>) -> bool {
    // Outlines are closed, so beyond the last crossing there is no shadow.
    let start = -crossings.iter().map(|&crossing| step(crossing)).sum::<i32>();
    out.clear();
    let mut depth = start;
    for &crossing in &crossings[..within] {
        let before = depth;
        depth += step(crossing);
        if (before > 0) != (depth > 0) {
            add_change(out, crossing, Crossing::range);
        }
    }
    start > 0
}

/// Adds a change of the gate to those before it: two that are too near to each other are none. `range` is where each is (m).
#[inline(always)]
pub(crate) fn add_change<T: Copy>(changes: &mut Vec<T>, change: T, range: impl Fn(T) -> f64) {
    if changes.last().is_some_and(|&last| range(change) - range(last) < RESOLUTION) {
        changes.pop();
    } else {
        changes.push(change);
    }
}
