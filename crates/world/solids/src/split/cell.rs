//! A convex room of space, cut smaller plane by plane.

use glam::DVec3;

use super::plane::Plane;

/// A convex polyhedron by its faces, each a convex polygon.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    faces: Vec<Vec<DVec3>>,
}

impl Cell {
    /// A box between two corners (m).
    pub fn boxed(low: DVec3, high: DVec3) -> Self {
        let pick = |bits: usize| {
            let axis = |bit: usize, axis: usize| if bits >> bit & 1 == 0 { low[axis] } else { high[axis] };
            DVec3::new(axis(0, 0), axis(1, 1), axis(2, 2))
        };
        let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
        Self { faces: sides.map(|side| side.map(pick).to_vec()).to_vec() }
    }

    /// The parts in front of and behind a plane; `None` for a part without a volume.
    pub fn cut(&self, plane: &Plane, slack: f64) -> [Option<Self>; 2] {
        let reached = self.faces.iter().fold([false; 2], |[front, back], face| {
            let [in_front, behind] = plane.reaches(face, slack);
            [front | in_front, back | behind]
        });
        match reached {
            [true, true] => {}
            [front, back] => return [front, back].map(|whole| whole.then(|| self.clone())),
        }
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for face in &self.faces {
            let halves = plane.cut(face, slack);
            let [in_front, behind] = plane.reaches(face, slack);
            front.extend(in_front.then_some(halves.front));
            back.extend(behind.then_some(halves.back));
        }
        let lid = lid(plane, &front, slack);
        [front, back].map(|mut faces| {
            faces.extend((lid.len() > 2).then(|| lid.clone()));
            (faces.len() > 3).then_some(Self { faces })
        })
    }

    /// What lies behind a plane.
    pub fn behind(&self, plane: &Plane, slack: f64) -> Option<Self> {
        let [_, back] = self.cut(plane, slack);
        back
    }

    /// All corners, each once.
    pub fn corners(&self) -> Vec<DVec3> {
        let mut corners: Vec<DVec3> = self.faces.iter().flatten().copied().collect();
        corners.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
        corners.dedup();
        corners
    }

    /// A place inside.
    pub fn middle(&self) -> DVec3 {
        let corners = self.corners();
        corners.iter().sum::<DVec3>() / corners.len() as f64
    }

    /// Volume (m3).
    pub fn volume(&self) -> f64 {
        let middle = self.middle();
        let pyramid = |face: &Vec<DVec3>| {
            let area = face.windows(2).map(|edge| (edge[0] - face[0]).cross(edge[1] - face[0])).sum::<DVec3>();
            area.dot(face[0] - middle).abs() / 6.0
        };
        self.faces.iter().map(pyramid).sum()
    }

    /// Whether it is thinner than `slack` (m): its volume over its largest face.
    pub fn is_thin(&self, slack: f64) -> bool {
        let area = |face: &Vec<DVec3>| {
            let sum = face.windows(2).map(|edge| (edge[0] - face[0]).cross(edge[1] - face[0])).sum::<DVec3>();
            0.5 * sum.length()
        };
        let largest = self.faces.iter().map(area).fold(0.0, f64::max);
        self.volume() <= slack * largest
    }
}

/// The convex polygon that closes a cut: corners on the plane, in order around their middle.
fn lid(plane: &Plane, faces: &[Vec<DVec3>], slack: f64) -> Vec<DVec3> {
    let mut corners: Vec<DVec3> = Vec::new();
    for &corner in faces.iter().flatten().filter(|corner| plane.height(**corner).abs() <= slack) {
        if !corners.contains(&corner) {
            corners.push(corner);
        }
    }
    let middle = corners.iter().sum::<DVec3>() / corners.len().max(1) as f64;
    let along = plane.normal.any_orthonormal_vector();
    let across = plane.normal.cross(along);
    // Grows with the angle from `along`, from 0 to 4.
    let turn = |corner: &DVec3| {
        let [x, y] = [along, across].map(|axis| axis.dot(*corner - middle));
        let part = y / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if x < 0.0 { 2.0 - part } else if y < 0.0 { 4.0 + part } else { part }
    };
    corners.sort_by(|a, b| turn(a).total_cmp(&turn(b)));
    corners
}
