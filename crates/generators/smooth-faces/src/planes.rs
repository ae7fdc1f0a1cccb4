//! From scan lines to planes.

use std::ops::Range;

use generator::{FrameCounts, Label, PlaneKind, Planes};
use glam::DVec3;
use quantities::luminance;
use rayon::prelude::*;
use signal::Probe;

use crate::parameters::Parameters;
use crate::piece::{Piece, samples};
use crate::scan_line::{Sample, ScanLine, TimedLine};
use crate::scene::Scene;
use crate::signals;

/// The planes that are filled.
pub const PLANES: [PlaneKind; 7] = [
    PlaneKind::Intensity,
    PlaneKind::Range,
    PlaneKind::Label,
    PlaneKind::Red,
    PlaneKind::Green,
    PlaneKind::Blue,
    PlaneKind::Distance,
];

/// Scan lines whose values are there at a time. Chosen: some megabytes, work for all threads, and few lists of crossings.
const BLOCK: usize = 256;

/// Numbers of the pieces that may cross each scan line, [`BLOCK`] lines after [`BLOCK`] lines.
struct Crossings(Vec<BlockCrossings>);

impl Crossings {
    fn new(scene: &Scene, axis: usize, lines: usize) -> Self {
        let range = |piece: &Piece| samples(piece.extent(axis), lines);
        let ranges: Vec<_> = scene.pieces.par_iter().map(range).collect();
        let block =
            |block: usize| BlockCrossings::new(&ranges, block * BLOCK..lines.min((block + 1) * BLOCK));
        Self((0..lines.div_ceil(BLOCK)).into_par_iter().map(block).collect())
    }

    fn of(&self, line: usize) -> &[u32] {
        self.0[line / BLOCK].of(line % BLOCK)
    }
}

/// Numbers of the pieces that may cross each scan line of a block, line by line in one list.
struct BlockCrossings {
    /// Where the numbers of each line begin; one more than there are lines.
    starts: Vec<usize>,
    pieces: Vec<u32>,
}

impl BlockCrossings {
    /// The pieces with some `ranges` of lines that cross `lines`.
    fn new(ranges: &[Range<usize>], lines: Range<usize>) -> Self {
        let inside = || {
            (0..).zip(ranges).filter(|(_, range)| range.start < lines.end && lines.start < range.end).map(
                |(number, range)| {
                    let from = range.start.max(lines.start) - lines.start;
                    (number, from..range.end.min(lines.end) - lines.start)
                },
            )
        };
        let mut starts = vec![0; lines.len() + 1];
        inside().flat_map(|(_, range)| range).for_each(|line| starts[line + 1] += 1);
        (0..lines.len()).for_each(|line| starts[line + 1] += starts[line]);
        let mut next = starts.clone();
        let mut pieces = vec![0; starts[lines.len()]];
        for (number, range) in inside() {
            for line in range {
                pieces[next[line]] = number;
                next[line] += 1;
            }
        }
        Self { starts, pieces }
    }

    fn of(&self, line: usize) -> &[u32] {
        &self.pieces[self.starts[line]..self.starts[line + 1]]
    }
}

/// The scan lines of a scene on a screen of `size` (columns, lines), without samples.
pub fn timed_lines(scene: &Scene, run: &Parameters, size: [usize; 2]) -> Vec<TimedLine> {
    let axis = run.across();
    let crossings = Crossings::new(scene, axis, size[axis]);
    let line = |line: usize| TimedLine::new(scene, run, crossings.of(line), line, size[1 - axis]);
    (0..size[axis]).into_par_iter().map(line).collect()
}

/// Draws a scene on a screen of `size` (columns, lines): fills those of [`PLANES`] that a caller wants, and records the scan lines that the
/// probe of `frame` asks for.
///
/// A sample is much larger than its pixels, so a line keeps its samples only where the probe asks for them.
pub fn draw(
    scene: &Scene,
    run: &Parameters,
    size: [usize; 2],
    planes: &mut Planes,
    (frame, probe): (u64, &mut Probe),
) -> FrameCounts {
    let axis = run.across();
    let crossings = Crossings::new(scene, axis, size[axis]);
    let kinds: Vec<PlaneKind> = PLANES.into_iter().filter(|kind| planes.get(*kind).is_some()).collect();
    let mut tally = Tally::default();
    for first in (0..size[axis]).step_by(BLOCK) {
        let numbers = first..(first + BLOCK).min(size[axis]);
        let wants = |line: usize| probe.wants_sweep(line as u32);
        let line = |number: usize| {
            let line = ScanLine::new(scene, run, crossings.of(number), number, size[1 - axis]);
            let values = values(scene, &kinds, (axis, number), &line.samples);
            FilledLine { values, line: if wants(number) { line } else { line.without_samples() } }
        };
        let block: Vec<FilledLine> = numbers.into_par_iter().map(line).collect();
        for (place, kind) in kinds.iter().enumerate() {
            let columns = planes.columns();
            let Some(plane) = planes.get_mut(*kind) else { continue };
            fill(plane, columns, axis, |number| {
                Some(block.get(number.checked_sub(first)?)?.values[place].as_slice())
            });
        }
        for (number, FilledLine { line, .. }) in (first..).zip(&block) {
            tally.add(line);
            signals::record((frame, number), scene, run, line, probe);
        }
    }
    tally.counts(scene)
}

/// A scan line, and what each plane has of it.
struct FilledLine {
    line: ScanLine,
    /// Of each plane that is wanted, the values of all samples.
    values: Vec<Vec<f32>>,
}

/// What planes of some kinds have of the samples of a scan line, `number` across `axis`. Few samples at a time pass all planes, so that
/// they are still at hand.
fn values(
    scene: &Scene,
    kinds: &[PlaneKind],
    (axis, number): (usize, usize),
    samples: &[Sample],
) -> Vec<Vec<f32>> {
    let mut values: Vec<Vec<f32>> = kinds.iter().map(|_| Vec::with_capacity(samples.len())).collect();
    for (chunk, samples) in samples.chunks(AT_HAND).enumerate() {
        let pixel = |at: usize| {
            let at = chunk * AT_HAND + at;
            if axis == 0 { [number, at] } else { [at, number] }
        };
        for (kind, values) in kinds.iter().zip(&mut values) {
            give(scene, *kind, pixel, samples, values);
        }
    }
    values
}

/// Samples that pass all planes at a time: they fit the nearest memory. Chosen.
const AT_HAND: usize = 64;

/// Adds to a plane what it has of some samples; `pixel` says where each of them is.
fn give(
    scene: &Scene,
    kind: PlaneKind,
    pixel: impl Fn(usize) -> [usize; 2],
    samples: &[Sample],
    values: &mut Vec<f32>,
) {
    let ray = |at: usize| scene.camera.ray(pixel(at).map(|at| at as f64 + 0.5));
    let far = |(at, sample): (usize, &Sample), length: fn(DVec3) -> f64| {
        if sample.q == 0.0 { kind.sky() } else { (length(ray(at)) / sample.q) as f32 }
    };
    let (all, numbered) = (samples.iter(), samples.iter().enumerate());
    match kind {
        PlaneKind::Red => values.extend(all.map(|sample| sample.colour[0] as f32)),
        PlaneKind::Green => values.extend(all.map(|sample| sample.colour[1] as f32)),
        PlaneKind::Blue => values.extend(all.map(|sample| sample.colour[2] as f32)),
        PlaneKind::Label => values.extend(all.map(|sample| label(scene, sample))),
        PlaneKind::Range => values.extend(numbered.map(|sample| far(sample, |ray| ray.truncate().length()))),
        PlaneKind::Distance => values.extend(numbered.map(|sample| far(sample, DVec3::length))),
        _ => values.extend(all.map(|sample| luminance(sample.colour) as f32)),
    }
}

fn label(scene: &Scene, sample: &Sample) -> f32 {
    let label = sample.winner.map_or(Label::Sky, |[_, list]| scene.lists[list as usize].label);
    f32::from(label.code())
}

/// Gives each pixel of a plane of so many `columns` its value of the scan lines across `axis`. `line` has these by their numbers, as far
/// as there are any.
fn fill<'a>(
    plane: &mut [f32],
    columns: usize,
    axis: usize,
    line: impl Fn(usize) -> Option<&'a [f32]> + Sync,
) {
    if axis == 1 {
        let rows = plane.par_chunks_mut(columns).enumerate();
        return rows.for_each(|(row, pixels)| {
            if let Some(values) = line(row) {
                pixels.copy_from_slice(values);
            }
        });
    }
    let lines: Vec<(usize, &[f32])> =
        (0..columns).filter_map(|column| Some((column, line(column)?))).collect();
    plane.par_chunks_mut(columns).enumerate().with_min_len(ROWS).for_each(|(row, pixels)| {
        for (column, values) in &lines {
            pixels[*column] = values[row];
        }
    });
}

/// Rows of a plane that a thread fills at least. Chosen: a task is worth its start.
const ROWS: usize = 32;

/// What the scan lines of a frame took and lost.
#[derive(Default)]
struct Tally {
    crossings: u64,
    most_crossings: u64,
    missed: u64,
    clamped: u64,
    disagreements: u64,
}

impl Tally {
    fn add(&mut self, line: &ScanLine) {
        self.crossings += line.crossed.crossings;
        self.most_crossings = self.most_crossings.max(line.crossed.crossings);
        self.missed += line.crossed.missed.len() as u64;
        self.clamped += line.clamped;
        self.disagreements += line.disagreements;
    }

    /// What the whole frame took and lost.
    fn counts(&self, scene: &Scene) -> FrameCounts {
        let fallen = scene.lists.iter().filter(|list| list.has_fallen).count() as u64;
        FrameCounts::of([
            ("lists", scene.lists.len() as u64),
            ("faces", scene.faces),
            ("pieces", scene.pieces.len() as u64),
            ("crossings", self.crossings),
            ("most_crossings", self.most_crossings),
            ("missed", self.missed),
            ("fallen_levels", fallen),
            ("lost_faces", scene.lost_faces),
            ("late", scene.late),
            ("suns", scene.lists.iter().filter(|list| list.has_own_sun).count() as u64),
            ("words", scene.words),
            ("clamped", self.clamped),
            ("disagreements", self.disagreements),
        ])
    }
}
