//! Edges of a picture: where a shift by a fraction of a pixel is a large step of grey.

use generator::{PlaneKind, Planes, Shade};

use crate::metrics::CompareError;
use crate::ridges::ridge_mask;

/// Planes that [`edge_mask`] looks at.
pub const EDGE_PLANES: [PlaneKind; 6] = [
    PlaneKind::Range,
    PlaneKind::NormalNorth,
    PlaneKind::NormalEast,
    PlaneKind::NormalUp,
    PlaneKind::Shadow,
    PlaneKind::Label,
];

/// What counts as an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeLimits {
    /// Step of range that makes a ridge, in units of the nearer range.
    pub jump: f32,
    /// Turn of the normal (length of the difference of unit vectors) that makes a kink.
    pub kink: f32,
}

impl Default for EdgeLimits {
    /// A fifth of the range; a turn that changes Lambert's factor by 0.02 at most, five levels of 255.
    fn default() -> Self {
        Self { jump: 0.2, kink: 0.02 }
    }
}

/// The pixels along edges, and how many each kind of edge leaves out by itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeMask {
    /// True along an edge, line by line from the top.
    pub pixels: Vec<bool>,
    /// Along ridge lines: jumps of range.
    pub ridges: usize,
    /// Along outlines: changes of label.
    pub outlines: usize,
    /// Along the boundaries of remote shadow.
    pub shadows: usize,
    /// Along kinks: crater rims, edges between the faces of a body.
    pub kinks: usize,
}

impl EdgeMask {
    /// Number of pixels that the mask leaves out.
    pub fn masked(&self) -> usize {
        self.pixels.iter().filter(|pixel| **pixel).count()
    }

    /// Their share of the picture, 0 to 1.
    pub fn share(&self) -> f64 {
        self.masked() as f64 / self.pixels.len() as f64
    }
}

/// The pixels within one pixel of an edge. `planes` holds [`EDGE_PLANES`], as `exact` fills them.
///
/// Four kinds of edges, each between two pixels that are neighbours in a line or a column:
///
/// - **ridges**, by [`ridge_mask`] with `limits.jump`;
/// - **outlines**: the labels differ;
/// - **shadows**: one pixel is lit and the other in remote shadow. The border of local shadow is none: there the light
///   falls to 0 without a step;
/// - **kinks**: the normals differ by more than `limits.kink` beyond what they differ by on either side of the two. A
///   smooth ground turns from pixel to pixel by amounts that change little, however far the pixels lie apart on it, and
///   so does not count, while at a rim one turn stands out between its neighbours.
///
/// Of a ridge the mask is the nearer pixel with its eight neighbours; of the others, every pixel whose centre lies
/// within one pixel of the middle between the two, along lines and columns: two by three.
///
/// # Errors
/// [`CompareError::MissingPlane`], [`CompareError::Range`].
pub fn edge_mask(planes: &Planes, limits: &EdgeLimits) -> Result<EdgeMask, CompareError> {
    let scene = EdgeScene::of(planes)?;
    let ridges = ridge_mask(scene.range, scene.columns, scene.lines, limits.jump)?;
    let outlines = scene.mask(|a, b, _| scene.label[a] != scene.label[b]);
    let shadows = scene.mask(|a, b, _| scene.is_shadow_step(a, b));
    let kinks = scene.mask(|a, b, around| scene.is_kink(a, b, around, limits.kink));
    let count = |mask: &[bool]| mask.iter().filter(|pixel| **pixel).count();
    let counts = [&ridges, &outlines, &shadows, &kinks].map(|mask| count(mask));
    let pixels = (0..ridges.len()).map(|at| ridges[at] || outlines[at] || shadows[at] || kinks[at]).collect();
    let [ridges, outlines, shadows, kinks] = counts;
    Ok(EdgeMask { pixels, ridges, outlines, shadows, kinks })
}

/// The planes by name.
struct EdgeScene<'a> {
    columns: usize,
    lines: usize,
    range: &'a [f32],
    label: &'a [f32],
    shadow: &'a [f32],
    normal: [&'a [f32]; 3],
}

/// The pixels on either side of a pair, where the picture has them.
type Around = [Option<usize>; 2];

impl<'a> EdgeScene<'a> {
    fn of(planes: &'a Planes) -> Result<Self, CompareError> {
        let get = |kind: PlaneKind| planes.get(kind).ok_or(CompareError::MissingPlane { kind: kind.name() });
        Ok(Self {
            columns: planes.columns(),
            lines: planes.lines(),
            range: get(PlaneKind::Range)?,
            label: get(PlaneKind::Label)?,
            shadow: get(PlaneKind::Shadow)?,
            normal: [get(PlaneKind::NormalNorth)?, get(PlaneKind::NormalEast)?, get(PlaneKind::NormalUp)?],
        })
    }

    /// The mask of every pair of neighbours that `is_edge`.
    fn mask(&self, is_edge: impl Fn(usize, usize, Around) -> bool) -> Vec<bool> {
        let mut mask = vec![false; self.columns * self.lines];
        for line in 0..self.lines {
            for column in 0..self.columns {
                let at = line * self.columns + column;
                if column + 1 < self.columns {
                    let around = [(column > 0).then(|| at - 1), (column + 2 < self.columns).then(|| at + 2)];
                    if is_edge(at, at + 1, around) {
                        self.cover(&mut mask, [line.saturating_sub(1), column], [line + 2, column + 2]);
                    }
                }
                if line + 1 < self.lines {
                    let (above, below) = (at.checked_sub(self.columns), at + 2 * self.columns);
                    let around = [above, (line + 2 < self.lines).then_some(below)];
                    if is_edge(at, at + self.columns, around) {
                        self.cover(&mut mask, [line, column.saturating_sub(1)], [line + 2, column + 2]);
                    }
                }
            }
        }
        mask
    }

    /// Covers a box of pixels, `from` up to and without `to` (line, column), as far as it lies in the picture.
    fn cover(&self, mask: &mut [bool], from: [usize; 2], to: [usize; 2]) {
        for line in from[0]..to[0].min(self.lines) {
            mask[line * self.columns..][from[1]..to[1].min(self.columns)].fill(true);
        }
    }

    fn is_shadow_step(&self, a: usize, b: usize) -> bool {
        let is = |at: usize, shade: Shade| self.shadow[at] == f32::from(shade.code());
        (is(a, Shade::Lit) && is(b, Shade::Remote)) || (is(a, Shade::Remote) && is(b, Shade::Lit))
    }

    fn is_kink(&self, a: usize, b: usize, [before, after]: Around, limit: f32) -> bool {
        let usual = [before.map(|at| self.turn(at, a)), after.map(|at| self.turn(b, at))];
        let usual = usual.into_iter().flatten().reduce(f32::max);
        usual.is_some_and(|usual| self.turn(a, b) > usual + limit)
    }

    /// Length of the difference of two normals.
    fn turn(&self, a: usize, b: usize) -> f32 {
        let squares = self.normal.iter().map(|part| (part[a] - part[b]) * (part[a] - part[b]));
        squares.sum::<f32>().sqrt()
    }
}
