//! From scan lines to planes.

use std::ops::Range;

use generator::{FrameCounts, Label, PlaneKind, Planes};
use quantities::luminance;
use rayon::prelude::*;

use crate::parameters::Parameters;
use crate::piece::{Piece, samples};
use crate::scan_line::{Sample, ScanLine, TimedLine};
use crate::scene::Scene;

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

/// Scan lines whose samples are there at a time. Chosen: some megabytes, and work for all threads.
const BLOCK: usize = 64;

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

/// Draws a scene on a screen of `size` (columns, lines): fills those of [`PLANES`] that a caller wants, and shows each scan line with its
/// number to `seen`, in order.
///
/// A sample is much larger than its pixels, so samples of [`BLOCK`] scan lines are there at a time.
pub fn draw(
    scene: &Scene,
    run: &Parameters,
    size: [usize; 2],
    planes: &mut Planes,
    mut seen: impl FnMut(usize, &ScanLine),
) -> FrameCounts {
    let axis = run.across();
    let crossings = Crossings::new(scene, axis, size[axis]);
    let line = |line: usize| ScanLine::new(scene, run, crossings.of(line), line, size[1 - axis]);
    let mut tally = Tally::default();
    for first in (0..size[axis]).step_by(BLOCK) {
        let numbers = first..(first + BLOCK).min(size[axis]);
        let block: Vec<ScanLine> = numbers.into_par_iter().map(line).collect();
        fill(scene, axis, (first, &block), planes);
        for (number, line) in (first..).zip(&block) {
            tally.add(line);
            seen(number, line);
        }
    }
    tally.counts(scene)
}

/// Fills the pixels of scan lines that follow one another, from the number `first` on.
fn fill(scene: &Scene, axis: usize, (first, block): (usize, &[ScanLine]), planes: &mut Planes) {
    let columns = planes.columns();
    for kind in PLANES {
        let Some(values) = planes.get_mut(kind) else { continue };
        let plane = Plane { values, columns, axis, first, block };
        let ray = |pixel: [usize; 2]| scene.camera.ray(pixel.map(|at| at as f64 + 0.5));
        let far = |sample: &Sample, across: f64| {
            if sample.q == 0.0 { kind.sky() } else { (across / sample.q) as f32 }
        };
        match kind {
            PlaneKind::Red => plane.set(|sample, _| sample.colour[0] as f32),
            PlaneKind::Green => plane.set(|sample, _| sample.colour[1] as f32),
            PlaneKind::Blue => plane.set(|sample, _| sample.colour[2] as f32),
            PlaneKind::Label => plane.set(|sample, _| label(scene, sample)),
            PlaneKind::Range => plane.set(|sample, pixel| far(sample, ray(pixel).truncate().length())),
            PlaneKind::Distance => plane.set(|sample, pixel| far(sample, ray(pixel).length())),
            _ => plane.set(|sample, _| luminance(sample.colour) as f32),
        }
    }
}

fn label(scene: &Scene, sample: &Sample) -> f32 {
    let label = sample.winner.map_or(Label::Sky, |[_, list]| scene.lists[list as usize].label);
    f32::from(label.code())
}

/// A plane of the screen, and the scan lines across `axis` that fill a part of it, from the number `first` on.
struct Plane<'a> {
    values: &'a mut [f32],
    columns: usize,
    axis: usize,
    first: usize,
    block: &'a [ScanLine],
}

impl Plane<'_> {
    /// Gives each pixel of the scan lines the value of its sample; `value` gets the pixel as well (column, row).
    fn set(self, value: impl Fn(&Sample, [usize; 2]) -> f32 + Sync) {
        let Self { values, columns, axis, first, block } = self;
        values.par_chunks_mut(columns).enumerate().for_each(|(row, values)| {
            if axis == 0 {
                for ((column, line), pixel) in (first..).zip(block).zip(&mut values[first..]) {
                    *pixel = value(&line.samples[row], [column, row]);
                }
            } else if let Some(line) = row.checked_sub(first).and_then(|number| block.get(number)) {
                for ((column, sample), pixel) in line.samples.iter().enumerate().zip(values) {
                    *pixel = value(sample, [column, row]);
                }
            }
        });
    }
}

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
