//! One pixel: its faces, piece by piece.

use generator::{FaceScene, ScreenFace};

use crate::grid::extent;
use crate::mean::Mean;
use crate::piece::{Linear, Piece, doubled_area, edges};

/// Pieces smaller than this (pixels squared) are passed over. Chosen: a million of them would not be seen.
const LEAST_AREA: f64 = 1e-13;

/// A pixel and the faces that may show in it.
pub struct Pixel<'a> {
    scene: &'a FaceScene,
    at: [usize; 2],
    faces: Vec<Candidate>,
}

/// A face that may show in a pixel.
#[derive(Clone)]
struct Candidate {
    number: u32,
    edges: Vec<Linear>,
    q: Linear,
    order: (i32, u32),
    is_opaque: bool,
}

impl Candidate {
    /// Whether a piece lies wholly beside the face.
    fn is_beside(&self, piece: &Piece) -> bool {
        self.edges.iter().any(|edge| piece.range(edge)[1] <= 0.0)
    }
}

impl<'a> Pixel<'a> {
    /// The pixel at column and line `at`; `faces` are the numbers of those that reach its line.
    pub fn new(scene: &'a FaceScene, faces: &[u32], at: [usize; 2]) -> Self {
        let square = Piece::pixel(at);
        let (left, right) = (at[0] as f64, at[0] as f64 + 1.0);
        let reaches = |face: &ScreenFace| {
            let [low, high] = extent(face, 0);
            low < right && high > left && doubled_area(&face.corners) != 0.0
        };
        let middle = [left + 0.5, at[1] as f64 + 0.5];
        let candidate = |&number: &u32| {
            let face = &scene.faces[number as usize];
            if !reaches(face) {
                return None;
            }
            let edges: Vec<Linear> = edges(&face.corners).collect();
            let look = (scene.looks)(number as usize, middle);
            let is_invisible = look.translucency == [1.0; 3] && look.light == [0.0; 3];
            let candidate = Candidate {
                number,
                edges,
                q: Linear(face.q),
                // The higher priority, then the lower id, is nearer.
                order: (-face.priority, face.id),
                is_opaque: look.translucency == [0.0; 3],
            };
            (!is_invisible && !candidate.is_beside(&square)).then_some(candidate)
        };
        let mut faces: Vec<Candidate> = faces.iter().filter_map(candidate).collect();
        // The nearer are taken first, so that what they hide falls away early.
        faces.sort_by(|a, b| {
            square.range(&b.q)[1].total_cmp(&square.range(&a.q)[1]).then(a.order.cmp(&b.order))
        });
        Self { scene, at, faces }
    }

    /// Its mean light, and the share of light from behind that comes through.
    pub fn mean(&self) -> Mean {
        let all: Vec<u32> = (0..self.faces.len() as u32).collect();
        self.part(&Piece::pixel(self.at), &[], &all)
    }

    /// Mean times area of a piece that all of `over` cover and that `open` may cover in part.
    fn part(&self, piece: &Piece, over: &[u32], open: &[u32]) -> Mean {
        if piece.area() < LEAST_AREA {
            return Mean::default();
        }
        let hidden = self.nearest_wall(piece, over);
        let room = 1.0 - self.scene.coincidence;
        let is_hidden =
            |face: u32| hidden.is_some_and(|least| piece.range(&self.face(face).q)[1] < least * room);
        // A face beside the piece must not cut it: pieces would multiply.
        let may_show = |face: u32| !is_hidden(face) && !self.face(face).is_beside(piece);
        let Some(at) = open.iter().position(|&face| may_show(face)) else {
            let over: Vec<u32> = over.iter().copied().filter(|&face| !is_hidden(face)).collect();
            return self.covered(piece, &over);
        };
        let (face, open) = (open[at], &open[at + 1..]);
        let mut inside = piece.clone();
        let mut sum = Mean::default();
        for edge in &self.face(face).edges {
            let [within, outside] = inside.cut(edge);
            sum = sum.add(self.part(&outside, over, open));
            inside = within;
        }
        sum.add(self.part(&inside, &[over, &[face]].concat(), open))
    }

    fn face(&self, number: u32) -> &Candidate {
        &self.faces[number as usize]
    }

    /// The least q on a piece of the opaque face of `over` whose least is largest: what is farther all over is hidden.
    fn nearest_wall(&self, piece: &Piece, over: &[u32]) -> Option<f64> {
        let walls = over.iter().filter(|&&face| self.face(face).is_opaque);
        walls.map(|&face| piece.range(&self.face(face).q)[0]).max_by(f64::total_cmp)
    }

    /// Mean times area of a piece that `faces` cover all over.
    fn covered(&self, piece: &Piece, faces: &[u32]) -> Mean {
        if piece.area() < LEAST_AREA {
            return Mean::default();
        }
        let crossing = (0..faces.len()).flat_map(|i| (0..i).map(move |j| [i, j])).find_map(|[i, j]| {
            let apart = self.face(faces[i]).q.less(&self.face(faces[j]).q);
            let [least, most] = piece.range(&apart);
            // Planes that touch within rounding do not cross, nor do those that coincide.
            let rounding = self.scene.coincidence.max(1e-12) * piece.range(&self.face(faces[i]).q)[1].abs();
            (least < -rounding && most > rounding).then_some(apart)
        });
        match crossing {
            Some(line) => {
                piece.cut(&line).iter().fold(Mean::default(), |sum, part| sum.add(self.covered(part, faces)))
            }
            None => self.composed(piece, faces),
        }
    }

    /// The same where no two of the faces cross.
    fn composed(&self, piece: &Piece, faces: &[u32]) -> Mean {
        let mut sum = Mean::default();
        let mut order = faces.to_vec();
        for (area, middles) in piece.triangles() {
            let middle = [0, 1].map(|axis| middles.iter().map(|place| place[axis]).sum::<f64>() / 3.0);
            self.sort(&mut order, middle);
            for place in middles {
                sum = sum.add(self.seen(&order, place).times(area / 3.0));
            }
        }
        sum
    }

    /// Near to far at a place.
    fn sort(&self, faces: &mut [u32], at: [f64; 2]) {
        let nearness = |face: u32| self.face(face).q.at(at);
        near_to_far(faces, nearness, |face| self.face(face).order, self.scene.coincidence);
    }

    /// Light of faces, near to far, at a place, and what comes through from behind them.
    fn seen(&self, faces: &[u32], place: [f64; 2]) -> Mean {
        seen(self.scene, faces.iter().map(|&face| self.face(face).number), place)
    }
}

/// Orders faces near to far; of those that coincide with the nearest of them, the first in `order` comes first.
pub fn near_to_far(
    faces: &mut [u32],
    nearness: impl Fn(u32) -> f64,
    order: impl Fn(u32) -> (i32, u32),
    coincidence: f64,
) {
    faces.sort_by(|&a, &b| nearness(b).total_cmp(&nearness(a)).then(order(a).cmp(&order(b))));
    let mut first = 0;
    while coincidence > 0.0 && first < faces.len() {
        let least = nearness(faces[first]) * (1.0 - coincidence);
        let count = faces[first..].partition_point(|&face| nearness(face) >= least).max(1);
        faces[first..first + count].sort_by_key(|&face| order(face));
        first += count;
    }
}

/// Light at a place of faces in their order, near to far, and what comes through from behind them.
pub fn seen(scene: &FaceScene, faces: impl IntoIterator<Item = u32>, place: [f64; 2]) -> Mean {
    let mut seen = Mean { light: [0.0; 3], through: [1.0; 3] };
    for face in faces {
        let look = (scene.looks)(face as usize, place);
        for channel in 0..3 {
            seen.light[channel] += seen.through[channel] * look.light[channel];
            seen.through[channel] *= look.translucency[channel];
        }
        if seen.through == [0.0; 3] {
            break;
        }
    }
    seen
}
