//! One scan line: which piece wins each of its samples, and what levels of detail add.

use faces::{Cover, Detail, Interpolation, Order};

use crate::parameters::Parameters;
use crate::piece::{Course, Piece, Ramp};
use crate::scene::Scene;

/// By how much (a share) the nearness of two planes that coincide may differ. Chosen: well above their rounding. Of two such faces the earlier list wins, and a level
/// may be laid upon either.
pub const COINCIDE: f64 = 1e-6;

/// A sample of a scan line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    /// Linear red, green, blue.
    pub colour: [f64; 3],
    /// How near what it shows is (1/m); 0 where there is sky.
    pub q: f64,
    /// Number of the winning piece and of its list; `None` where there is sky.
    pub winner: Option<[u32; 2]>,
    /// Brightness of the winning piece.
    pub brightness: f64,
    /// Change of its brightness from pixel to pixel.
    pub slope: f64,
    /// Brightness of the level laid upon it; 0 where there is none.
    pub level: f64,
}

/// A scan line and what it took.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScanLine {
    /// Its samples in their order.
    pub samples: Vec<Sample>,
    /// Pieces that cross it.
    pub crossed: Crossed,
    /// Samples whose sum of levels was clamped.
    pub clamped: u64,
    /// Samples at which priority and depth disagree.
    pub disagreements: u64,
}

/// Pieces that cross a scan line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Crossed {
    /// Pieces that cross the line, with a slot or without.
    pub crossings: u64,
    /// Numbers of those of them without a slot, in the order of the scene.
    pub missed: Vec<u32>,
}

impl Crossed {
    /// What crosses the scan line number `line`, and the ramps of the pieces that have a slot; see [`ScanLine::new`].
    fn new(scene: &Scene, run: &Parameters, crossing: &[u32], line: usize) -> (Self, Vec<(u32, Ramp)>) {
        let mut ramps = ramps(scene, run, crossing.iter().copied(), line);
        let crossings = ramps.len() as u64;
        let missed = without_slot(&mut ramps, scene.slots);
        (Self { crossings, missed }, ramps)
    }
}

/// A scan line of which no sample is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct TimedLine {
    /// Pieces that cross it.
    pub crossed: Crossed,
    /// Ramps that are started: those of pieces with a slot and a sample.
    pub ramps: u64,
}

impl TimedLine {
    /// The scan line number `line` of `count` samples; see [`ScanLine::new`].
    pub fn new(scene: &Scene, run: &Parameters, crossing: &[u32], line: usize, count: usize) -> Self {
        let (crossed, ramps) = Crossed::new(scene, run, crossing, line);
        let ramps = ramps.iter().filter(|(_, ramp)| !ramp.samples(count).is_empty()).count() as u64;
        Self { crossed, ramps }
    }
}

/// What wins a sample so far under both orders.
#[derive(Debug, Clone, Copy)]
struct Standing {
    /// Number of the piece that wins by lists.
    by_list: u32,
    /// Number of the piece that wins by depth.
    by_depth: u32,
    /// How near that one is (1/m); infinitely far without any.
    nearest: f64,
}

impl Standing {
    /// Nothing covers the sample.
    const NONE: Self = Self { by_list: u32::MAX, by_depth: u32::MAX, nearest: f64::NEG_INFINITY };
}

impl ScanLine {
    /// The scan line number `line` of `count` samples; `crossing` numbers the pieces that may cross it, in the order of the scene.
    pub fn new(scene: &Scene, run: &Parameters, crossing: &[u32], line: usize, count: usize) -> Self {
        let (crossed, ramps) = Crossed::new(scene, run, crossing, line);
        let mut drawn = Self { samples: vec![Sample::default(); count], crossed, ..Self::default() };
        drawn.resolve(scene, run, &ramps);
        drawn.lay_levels(scene, run, &ramps);
        drawn
    }

    /// The same without samples.
    pub fn without_samples(self) -> Self {
        Self { samples: Vec::new(), ..self }
    }

    /// Gives each sample to the piece that wins it; pieces of levels stand aside.
    fn resolve(&mut self, scene: &Scene, run: &Parameters, ramps: &[(u32, Ramp)]) {
        let mut standings = vec![Standing::NONE; self.samples.len()];
        let is_base = |(piece, _): &&(u32, Ramp)| {
            scene.lists[scene.pieces[*piece as usize].list as usize].level.is_none()
        };
        for (piece, ramp) in ramps.iter().filter(is_base) {
            let paint = Paint::new(scene, run, *piece, ramp);
            for sample in ramp.samples(self.samples.len()) {
                let [q, brightness] = paint.course.at(sample as f64 + 0.5);
                let standing = &mut standings[sample];
                // Pieces come in the order of their priorities, so the first one stays.
                let is_first = standing.by_list == u32::MAX;
                let is_nearest = is_first || q > standing.nearest * (1.0 + COINCIDE);
                if is_first {
                    standing.by_list = *piece;
                }
                if is_nearest {
                    (standing.by_depth, standing.nearest) = (*piece, q);
                }
                if (run.order == Order::Lists && is_first) || (run.order == Order::Depth && is_nearest) {
                    self.samples[sample] = paint.sample([q, brightness]);
                }
            }
        }
        let differs = |standing: &&Standing| standing.by_list != standing.by_depth;
        self.disagreements = standings.iter().filter(differs).count() as u64;
    }

    /// Lays levels of detail upon what the samples show, the last list first.
    fn lay_levels(&mut self, scene: &Scene, run: &Parameters, ramps: &[(u32, Ramp)]) {
        for (number, ramp) in ramps.iter().rev() {
            let piece = &scene.pieces[*number as usize];
            let Some(detail) = scene.lists[piece.list as usize].level else { continue };
            let paint = Paint::new(scene, run, *number, ramp);
            for at in ramp.samples(self.samples.len()) {
                let [q, brightness] = paint.course.at(at as f64 + 0.5);
                let above = paint.sample([q, brightness]);
                let sample = &mut self.samples[at];
                if is_before(run.order, piece.list, q, sample) {
                    self.clamped += u64::from(lay(sample, &above, detail));
                }
            }
        }
    }
}

/// Ramps of those of some pieces that cross a scan line.
fn ramps(
    scene: &Scene,
    run: &Parameters,
    pieces: impl Iterator<Item = u32>,
    line: usize,
) -> Vec<(u32, Ramp)> {
    let (across, at) = (run.across(), line as f64 + 0.5);
    let ramp = |piece: u32| Some((piece, scene.pieces[piece as usize].ramp(across, at, run.interpolation)?));
    pieces.filter_map(ramp).collect()
}

/// Takes from the ramps of a scan line those beyond its slots, and returns their pieces.
fn without_slot(ramps: &mut Vec<(u32, Ramp)>, slots: Option<u32>) -> Vec<u32> {
    let slots = slots.map_or(usize::MAX, |slots| slots as usize).min(ramps.len());
    ramps.drain(slots..).map(|(piece, _)| piece).collect()
}

/// What a piece gives to its samples on a scan line.
struct Paint {
    course: Course,
    colour: [f64; 3],
    /// Numbers of the piece and of its list.
    of: [u32; 2],
    ambient: f64,
}

impl Paint {
    fn new(scene: &Scene, run: &Parameters, piece: u32, ramp: &Ramp) -> Self {
        let of = &scene.pieces[piece as usize];
        Self {
            course: ramp.course(run.interpolation),
            colour: of.colour,
            of: [piece, of.list],
            ambient: run.ambient,
        }
    }

    /// The sample at which the piece is as near as `q` (1/m) and has this brightness.
    #[inline(always)]
    fn sample(&self, [q, brightness]: [f64; 2]) -> Sample {
        let colour = faces::lit(self.colour, self.ambient, brightness).map(|channel| channel.clamp(0.0, 1.0));
        Sample { colour, q, winner: Some(self.of), brightness, slope: self.course.slope, level: 0.0 }
    }
}

/// Whether a level of a list, as near as `q`, may be laid upon a sample.
fn is_before(order: Order, list: u32, q: f64, sample: &Sample) -> bool {
    match (sample.winner, order) {
        (None, _) => true,
        (Some([_, below]), Order::Lists) => list < below,
        (Some(_), Order::Depth) => q >= sample.q * (1.0 - COINCIDE),
    }
}

/// Lays a level upon a sample; whether a sum was clamped.
fn lay(sample: &mut Sample, above: &Sample, detail: Detail) -> bool {
    let levels = [0, 1, 2].map(|channel| detail.combine(sample.colour[channel], above.colour[channel]));
    if sample.winner.is_none() {
        *sample = *above;
    }
    sample.colour = levels.map(|level| level.intensity);
    sample.level = above.brightness;
    sample.winner = above.winner.filter(|_| detail == Detail::Replace).or(sample.winner);
    levels.iter().any(|level| level.is_clamped)
}

/// First samples of all ramps that are started on a scan line of `count` samples.
pub fn entries(scene: &Scene, run: &Parameters, line: usize, count: usize) -> Vec<usize> {
    let mut ramps = ramps(scene, run, 0..scene.pieces.len() as u32, line);
    without_slot(&mut ramps, scene.slots);
    let samples = ramps.iter().map(|(_, ramp)| ramp.samples(count));
    samples.filter(|samples| !samples.is_empty()).map(|samples| samples.start).collect()
}

/// A piece at the middle of a sample, with how near it is (1/m) and its brightness.
pub type PieceAt = (u32, [f64; 2]);

/// What a scan line has at the middle of a sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Covers {
    /// Pieces that have a slot, in the order of their lists.
    pub drawn: Vec<PieceAt>,
    /// Pieces without a slot on the line.
    pub missed: Vec<PieceAt>,
    /// Pieces that cross the whole line, and how many of them have no slot.
    pub counts: [usize; 2],
}

/// All pieces at the middle of a sample.
pub fn covers(scene: &Scene, run: &Parameters, [line, sample]: [usize; 2]) -> Covers {
    let mut crossing = ramps(scene, run, 0..scene.pieces.len() as u32, line);
    let all = crossing.clone();
    let missing = without_slot(&mut crossing, scene.slots);
    let is_missed = |piece: &u32| missing.binary_search(piece).is_ok();
    let at = |(piece, ramp): &(u32, Ramp)| {
        let is_in = ramp.samples(usize::MAX >> 12).contains(&sample);
        is_in.then(|| (*piece, ramp.course(run.interpolation).at(sample as f64 + 0.5)))
    };
    let (missed, drawn) = all.iter().filter_map(at).partition(|(piece, _)| is_missed(piece));
    Covers { drawn, missed, counts: [all.len(), missing.len()] }
}

/// Pieces at the middle of a sample that found no slots in the frame.
pub fn lost_covers<'a>(
    scene: &'a Scene,
    run: &Parameters,
    [line, sample]: [usize; 2],
) -> Vec<(&'a Piece, [f64; 2])> {
    let at = sample as f64 + 0.5;
    let cover = |piece: &'a Piece| {
        let ramp = piece.ramp(run.across(), line as f64 + 0.5, run.interpolation)?;
        ramp.samples(sample + 1).contains(&sample).then(|| (piece, ramp.course(run.interpolation).at(at)))
    };
    scene.lost.iter().filter_map(cover).collect()
}

/// The cover that `faces` judges by.
pub fn cover(scene: &Scene, (piece, [q, _]): PieceAt) -> Cover {
    Cover { priority: scene.pieces[piece as usize].list as i32, depth: 1.0 / q }
}

/// Where brightness runs linearly, in one word.
pub fn interpolation_word(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Screen => "on the screen",
        Interpolation::Perspective => "in space",
    }
}
