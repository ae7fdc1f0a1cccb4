//! Light points of one sweep at the third video switch, and what its sampling points say of calligraphic ones.

use std::ops::Range;

use light_points::{Accumulation, Share, Veil};
use polyhedron_generator::{BodyFade, PartsSwitch, Run};

use crate::placing::Point;
use crate::sight::Before;
use crate::table::{Chord, PointTable};

/// Sampling points on a sweep in each of its lines. Chosen: a disc of the least diameter has ten or more.
pub const SAMPLES_A_LINE: usize = 8;

/// The third video switch as light points pass it.
#[derive(Debug, Clone, Copy)]
pub struct Third<'a> {
    /// The switch of parts; `None` if it switches at once and without error.
    pub parts: Option<&'a PartsSwitch>,
    /// Intensity that the light of a point must exceed to open it, where it is keyed by its own input.
    pub key: Option<f32>,
}

/// Buffers of a worker, and what the sweeps say that it has drawn.
#[derive(Debug, Clone, Default)]
pub struct LightSwitch {
    /// Stretches in sight, chord by chord.
    pieces: Vec<[f32; 2]>,
    /// Those of each chord.
    seen: Vec<Range<usize>>,
    runs: Vec<Run>,
    fade: BodyFade,
    /// Made at the first sweep with a calligraphic point, as long as a sweep.
    veil: Option<Veil>,
    /// Sweep, point and share.
    shares: Vec<(u32, u32, Share)>,
}

impl LightSwitch {
    /// Lays the points that sweep `sweep` meets by `chords` over its `row`, and samples the calligraphic ones.
    pub fn lay<L: Fn(usize) -> f32>(
        &mut self,
        sweep: u32,
        (table, chords): (&PointTable, &[Chord]),
        before: &Before<'_, L>,
        third: Third<'_>,
        row: &mut [f32],
    ) {
        self.find(table, chords, before);
        for (number, chord) in chords.iter().enumerate().rev() {
            let point = table.point(chord);
            if !point.is_calligraphic && third.key.is_none_or(|key| point.added > key) {
                self.write(number, point, third, row);
            }
        }
        if chords.iter().any(|chord| table.point(chord).is_calligraphic) {
            self.sample(sweep, table, chords, row.len());
        }
    }

    /// Takes what the sweeps since the last call say of calligraphic points: sweep, number of the point in its table, share.
    pub fn take_shares(&mut self) -> Vec<(u32, u32, Share)> {
        std::mem::take(&mut self.shares)
    }

    fn find<L: Fn(usize) -> f32>(&mut self, table: &PointTable, chords: &[Chord], before: &Before<'_, L>) {
        self.pieces.clear();
        self.seen.clear();
        for chord in chords {
            let begin = self.pieces.len();
            before.find(table.point(chord), chord.ends, &mut self.pieces);
            self.seen.push(begin..self.pieces.len());
        }
    }

    /// Lays what is seen of the point of chord `number` over a row.
    fn write(&mut self, number: usize, point: &Point, third: Third<'_>, row: &mut [f32]) {
        let pieces = &self.pieces[self.seen[number].clone()];
        match third.parts {
            None => mix(pieces, point, row),
            Some(parts) => {
                self.runs.clear();
                let reflectivity = point.added;
                self.runs.extend(pieces.iter().map(|&[top, bottom]| Run {
                    top,
                    bottom,
                    reflectivity,
                    ramp: 0.0,
                }));
                parts.write_through(&self.runs, point.translucency, &mut self.fade, row);
            }
        }
    }

    /// Reads the points of a sweep out, near to far: each dims those behind it.
    fn sample(&mut self, sweep: u32, table: &PointTable, chords: &[Chord], lines: usize) {
        let samples = lines * SAMPLES_A_LINE;
        let veil = self.veil.get_or_insert_with(|| Veil::new(samples, Accumulation::Points));
        veil.lift();
        for (chord, seen) in chords.iter().zip(&self.seen) {
            let (point, pieces) = (table.point(chord), &self.pieces[seen.clone()]);
            let in_sight = |sample: usize| {
                let place = place_of(sample);
                f64::from(u8::from(pieces.iter().any(|[top, bottom]| *top <= place && place < *bottom)))
            };
            let share = veil.read_out(under(chord.ends, samples), in_sight, point.translucency);
            if point.is_calligraphic {
                self.shares.push((sweep, chord.point, share));
            }
        }
    }
}

/// Line position of a sampling point.
fn place_of(sample: usize) -> f32 {
    (sample as f32 + 0.5) / SAMPLES_A_LINE as f32
}

/// Sampling points of a sweep between two line positions.
fn under(ends: [f32; 2], samples: usize) -> Range<usize> {
    // Conversion saturates: what lies above the picture begins with it.
    let [first, end] = ends.map(|end| ((end * SAMPLES_A_LINE as f32 - 0.5).ceil() as usize).min(samples));
    first..end
}

/// Lays pieces of a point over a row: each line shows the share that they cover.
fn mix(pieces: &[[f32; 2]], point: &Point, row: &mut [f32]) {
    let (Some([top, _]), Some([_, bottom])) = (pieces.first(), pieces.last()) else { return };
    let opacity = (1.0 - point.translucency) as f32;
    let lines = top.floor().max(0.0) as usize..(bottom.ceil().max(0.0) as usize).min(row.len());
    for line in lines {
        let [above, below] = [line as f32, line as f32 + 1.0];
        let cover: f32 =
            pieces.iter().map(|[top, bottom]| (bottom.min(below) - top.max(above)).max(0.0)).sum();
        row[line] = row[line] * (1.0 - cover * opacity) + cover * point.added;
    }
}
