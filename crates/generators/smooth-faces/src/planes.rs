//! From scan lines to planes.

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

/// Numbers of the pieces that may cross each scan line, line by line in one list.
struct Crossings {
    /// Where the numbers of each line begin; one more than there are lines.
    starts: Vec<usize>,
    pieces: Vec<u32>,
}

impl Crossings {
    fn new(scene: &Scene, axis: usize, lines: usize) -> Self {
        let range = |piece: &Piece| samples(piece.extent(axis), lines);
        let ranges: Vec<_> = scene.pieces.iter().map(range).collect();
        let mut starts = vec![0; lines + 1];
        ranges.iter().flat_map(Clone::clone).for_each(|line| starts[line + 1] += 1);
        (0..lines).for_each(|line| starts[line + 1] += starts[line]);
        let mut next = starts.clone();
        let mut pieces = vec![0; starts[lines]];
        for (number, range) in ranges.into_iter().enumerate() {
            for line in range {
                pieces[next[line]] = number as u32;
                next[line] += 1;
            }
        }
        Self { starts, pieces }
    }

    fn of(&self, line: usize) -> &[u32] {
        &self.pieces[self.starts[line]..self.starts[line + 1]]
    }
}

/// All scan lines of a scene on a screen of `size` (columns, lines).
pub fn scan_lines(scene: &Scene, run: &Parameters, size: [usize; 2]) -> Vec<ScanLine> {
    each_line(scene, run, size, ScanLine::new)
}

/// The same without samples.
pub fn timed_lines(scene: &Scene, run: &Parameters, size: [usize; 2]) -> Vec<TimedLine> {
    each_line(scene, run, size, TimedLine::new)
}

/// A value of each scan line: of the numbers of pieces that may cross it, of its own number, and of the number of its samples.
fn each_line<T: Send>(
    scene: &Scene,
    run: &Parameters,
    size: [usize; 2],
    of_line: impl Fn(&Scene, &Parameters, &[u32], usize, usize) -> T + Sync,
) -> Vec<T> {
    let axis = run.across();
    let (lines, samples) = (size[axis], size[1 - axis]);
    let crossings = Crossings::new(scene, axis, lines);
    let line = |line: usize| of_line(scene, run, crossings.of(line), line, samples);
    (0..lines).into_par_iter().map(line).collect()
}

/// Fills those of [`PLANES`] that a caller wants.
pub fn fill(scene: &Scene, run: &Parameters, lines: &[ScanLine], planes: &mut Planes) {
    let (axis, columns) = (run.across(), planes.columns());
    for kind in PLANES {
        let Some(values) = planes.get_mut(kind) else { continue };
        values.par_iter_mut().enumerate().for_each(|(at, value)| {
            let pixel = [at % columns, at / columns];
            let sample = &lines[pixel[axis]].samples[pixel[1 - axis]];
            *value = of_sample(kind, sample, scene, pixel);
        });
    }
}

fn of_sample(kind: PlaneKind, sample: &Sample, scene: &Scene, pixel: [usize; 2]) -> f32 {
    let ray = || scene.camera.ray(pixel.map(|at| at as f64 + 0.5));
    let label = sample.winner.map_or(Label::Sky, |[_, list]| scene.lists[list as usize].label);
    match kind {
        PlaneKind::Red => sample.colour[0] as f32,
        PlaneKind::Green => sample.colour[1] as f32,
        PlaneKind::Blue => sample.colour[2] as f32,
        PlaneKind::Label => f32::from(label.code()),
        PlaneKind::Range | PlaneKind::Distance if sample.q == 0.0 => kind.sky(),
        PlaneKind::Range => (ray().truncate().length() / sample.q) as f32,
        PlaneKind::Distance => (ray().length() / sample.q) as f32,
        _ => luminance(sample.colour) as f32,
    }
}

/// What a frame took and lost.
pub fn counts(scene: &Scene, lines: &[ScanLine]) -> FrameCounts {
    let fallen = scene.lists.iter().filter(|list| list.has_fallen).count() as u64;
    let sum = |of: fn(&ScanLine) -> u64| lines.iter().map(of).sum();
    FrameCounts::of([
        ("lists", scene.lists.len() as u64),
        ("faces", scene.faces),
        ("pieces", scene.pieces.len() as u64),
        ("crossings", sum(|line| line.crossed.crossings)),
        ("most_crossings", lines.iter().map(|line| line.crossed.crossings).max().unwrap_or(0)),
        ("missed", sum(|line| line.crossed.missed.len() as u64)),
        ("fallen_levels", fallen),
        ("lost_faces", scene.lost_faces),
        ("late", scene.late),
        ("suns", scene.lists.iter().filter(|list| list.has_own_sun).count() as u64),
        ("words", scene.words),
        ("clamped", sum(|line| line.clamped)),
        ("disagreements", sum(|line| line.disagreements)),
    ])
}
