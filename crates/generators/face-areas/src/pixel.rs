//! One pixel: its faces, piece by piece.

use generator::{FaceScene, ScreenFace};

use crate::grid::extent;
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
            let is_invisible = look.translucency == 1.0 && look.light == [0.0; 3];
            let candidate = Candidate {
                number,
                edges,
                q: Linear(face.q),
                // The higher priority, then the lower id, is nearer.
                order: (-face.priority, face.id),
                is_opaque: look.translucency == 0.0,
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

    /// Its mean light (linear red, green, blue).
    pub fn light(&self) -> [f64; 3] {
        let all: Vec<u32> = (0..self.faces.len() as u32).collect();
        self.part(&Piece::pixel(self.at), &[], &all)
    }

    /// Light times area of a piece that all of `over` cover and that `open` may cover in part.
    fn part(&self, piece: &Piece, over: &[u32], open: &[u32]) -> [f64; 3] {
        if piece.area() < LEAST_AREA {
            return [0.0; 3];
        }
        let hidden = self.nearest_wall(piece, over);
        let is_hidden = |face: u32| hidden.is_some_and(|least| piece.range(&self.face(face).q)[1] < least);
        // A face beside the piece must not cut it: pieces would multiply.
        let may_show = |face: u32| !is_hidden(face) && !self.face(face).is_beside(piece);
        let Some(at) = open.iter().position(|&face| may_show(face)) else {
            let over: Vec<u32> = over.iter().copied().filter(|&face| !is_hidden(face)).collect();
            return self.covered(piece, &over);
        };
        let (face, open) = (open[at], &open[at + 1..]);
        let mut inside = piece.clone();
        let mut sum = [0.0; 3];
        for edge in &self.face(face).edges {
            let [within, outside] = inside.cut(edge);
            sum = add(sum, self.part(&outside, over, open));
            inside = within;
        }
        add(sum, self.part(&inside, &[over, &[face]].concat(), open))
    }

    fn face(&self, number: u32) -> &Candidate {
        &self.faces[number as usize]
    }

    /// The least q on a piece of the opaque face of `over` whose least is largest: what is farther all over is hidden.
    fn nearest_wall(&self, piece: &Piece, over: &[u32]) -> Option<f64> {
        let walls = over.iter().filter(|&&face| self.face(face).is_opaque);
        walls.map(|&face| piece.range(&self.face(face).q)[0]).max_by(f64::total_cmp)
    }

    /// Light times area of a piece that `faces` cover all over.
    fn covered(&self, piece: &Piece, faces: &[u32]) -> [f64; 3] {
        if piece.area() < LEAST_AREA {
            return [0.0; 3];
        }
        let crossing = (0..faces.len()).flat_map(|i| (0..i).map(move |j| [i, j])).find_map(|[i, j]| {
            let apart = self.face(faces[i]).q.less(&self.face(faces[j]).q);
            let [least, most] = piece.range(&apart);
            // Planes that touch within rounding do not cross.
            let rounding = 1e-12 * piece.range(&self.face(faces[i]).q)[1].abs();
            (least < -rounding && most > rounding).then_some(apart)
        });
        match crossing {
            Some(line) => {
                piece.cut(&line).iter().fold([0.0; 3], |sum, part| add(sum, self.covered(part, faces)))
            }
            None => self.composed(piece, faces),
        }
    }

    /// The same where no two of the faces cross.
    fn composed(&self, piece: &Piece, faces: &[u32]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mut order = faces.to_vec();
        for (area, middles) in piece.triangles() {
            let middle = [0, 1].map(|axis| middles.iter().map(|place| place[axis]).sum::<f64>() / 3.0);
            order.sort_by(|&a, &b| {
                let [a, b] = [a, b].map(|face| self.face(face));
                b.q.at(middle).total_cmp(&a.q.at(middle)).then(a.order.cmp(&b.order))
            });
            for place in middles {
                let light = self.seen(&order, place).map(|channel| area / 3.0 * channel);
                sum = add(sum, light);
            }
        }
        sum
    }

    /// Light of faces, near to far, at a place.
    fn seen(&self, faces: &[u32], place: [f64; 2]) -> [f64; 3] {
        let (mut light, mut through) = ([0.0; 3], 1.0);
        for &face in faces {
            let look = (self.scene.looks)(self.face(face).number as usize, place);
            light = add(light, look.light.map(|channel| through * channel));
            through *= look.translucency;
            if through == 0.0 {
                break;
            }
        }
        light
    }
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
