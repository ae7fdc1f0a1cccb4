//! Ground in closed form along a stretch of a way, and a bound of the clearance over it that holds.

use features::Crater;
use landscape::bernstein::{Coefficients, DEGREE, halves};

use crate::Curvature;
use crate::line::Line;
use crate::way::Way;

/// A crater's term in the distance from its centre: `weight * rho` (m).
#[derive(Debug, Clone, Copy)]
struct Distance {
    weight: f64,
    /// Share at which the way is nearest to the centre.
    nearest: f64,
    /// Square of the least distance (m^2).
    miss: f64,
}

/// A stretch of a way on which the ground is a polynomial and multiples of distances from centres of craters.
#[derive(Debug)]
pub struct Stretch<'a> {
    line: &'a Line,
    curvature: Curvature,
    length: f64,
    distances: Vec<Distance>,
}

/// A part of a stretch: its ends (shares), the polynomial of the ground over it, and the clearance (m) at its ends.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Shares of the way.
    pub ends: [f64; 2],
    ground: Coefficients,
    /// Clearances at both ends (m).
    pub clearances: [f64; 2],
}

impl<'a> Stretch<'a> {
    /// The stretch between two shares over terrain in Bernstein form, with the craters of which it crosses no circle.
    pub fn new(
        way: &Way,
        (line, curvature): (&'a Line, Curvature),
        ends: [f64; 2],
        terrain: Coefficients,
        craters: &[Crater],
    ) -> (Self, Part) {
        let mut stretch = Self { line, curvature, length: way.length, distances: Vec::new() };
        let mut ground = terrain;
        for crater in craters {
            stretch.add(way, ends, crater, &mut ground);
        }
        let part = stretch.part(ends, ground);
        (stretch, part)
    }

    /// Adds the ring of a crater in which the stretch lies: its quadratic to the polynomial, its distance to the list.
    fn add(&mut self, way: &Way, [from, to]: [f64; 2], crater: &Crater, ground: &mut Coefficients) {
        let Passage { nearest, miss } = Passage::new(way, crater);
        let square = |share: f64| self.length * self.length * (share - nearest) * (share - nearest) + miss;
        let rho = square(0.5 * (from + to)).sqrt();
        let Some(ring) = crater.rings().find(|ring| rho < ring.outer) else { return };
        let [a, b, c] = ring.terms;
        let (start, width) = (from - nearest, to - from);
        let linear = 2.0 * self.length * self.length * start * width;
        let quadratic = self.length * self.length * width * width;
        let n = DEGREE as f64;
        for (index, height) in ground.iter_mut().enumerate() {
            let k = index as f64;
            let rest = linear * k / n + quadratic * k * (k - 1.0) / (n * (n - 1.0));
            *height += c + a * (square(from) + rest);
        }
        if b != 0.0 {
            self.distances.push(Distance { weight: b, nearest, miss });
        }
    }

    fn part(&self, ends: [f64; 2], ground: Coefficients) -> Part {
        let at = [ground[0], ground[DEGREE]];
        let clearance = |end: usize| {
            let craters: f64 =
                self.distances.iter().map(|term| term.weight * self.rho(term, ends[end])).sum();
            self.line.at(ends[end]) - at[end] - craters
        };
        Part { ends, ground, clearances: [clearance(0), clearance(1)] }
    }

    fn rho(&self, term: &Distance, share: f64) -> f64 {
        let along = self.length * (share - term.nearest);
        (along * along + term.miss).sqrt()
    }

    /// Both halves of a part.
    pub fn halves(&self, part: &Part) -> [Part; 2] {
        let [from, to] = part.ends;
        let middle = 0.5 * (from + to);
        let (near, far) = halves(&part.ground);
        [self.part([from, middle], near), self.part([middle, to], far)]
    }

    /// A clearance (m) below which no place of a part lies, once the line has been raised by `raise` times the share.
    ///
    /// A function whose second derivative is M at most lies above its chord less `M / 2` times the product of the distances to both
    /// ends.
    pub fn lowest(&self, part: &Part, raise: f64) -> f64 {
        let [a, b] = [0, 1].map(|end| part.clearances[end] + raise * part.ends[end]);
        let width = part.ends[1] - part.ends[0];
        let bulge = 0.5 * self.most_bend(part) * width * width;
        if bulge <= (b - a).abs() {
            return a.min(b);
        }
        let at = 0.5 - 0.5 * (b - a) / bulge;
        (1.0 - at) * a + at * b - bulge * at * (1.0 - at)
    }

    /// The most that the second derivative of the clearance by the share comes to over a part (m).
    fn most_bend(&self, part: &Part) -> f64 {
        let width = part.ends[1] - part.ends[0];
        let second = |k: usize| part.ground[k] - 2.0 * part.ground[k + 1] + part.ground[k + 2];
        let least = (0..DEGREE - 1).map(second).fold(f64::INFINITY, f64::min);
        let of_terrain = least * (DEGREE * (DEGREE - 1)) as f64 / (width * width);
        let square = self.length * self.length;
        let of_datum = square * self.curvature.bend(self.length * part.ends[1]);
        let of_craters: f64 = self.distances.iter().map(|term| self.least_bend(term, part.ends)).sum();
        of_datum - of_terrain - square * of_craters
    }

    /// The least that the second derivative of a distance term comes to (1/m): that of rho is `miss / rho^3`.
    fn least_bend(&self, term: &Distance, ends: [f64; 2]) -> f64 {
        let from_nearest = |share: f64| (share - term.nearest).abs();
        let share = if term.weight > 0.0 {
            let is_first = from_nearest(ends[0]) > from_nearest(ends[1]);
            if is_first { ends[0] } else { ends[1] }
        } else {
            term.nearest.clamp(ends[0], ends[1])
        };
        let rho = self.rho(term, share);
        if rho > 0.0 { term.weight * term.miss / (rho * rho * rho) } else { 0.0 }
    }
}

/// How a way passes the centre of a crater.
#[derive(Debug, Clone, Copy)]
pub struct Passage {
    nearest: f64,
    miss: f64,
}

impl Passage {
    /// Passage of a way.
    pub fn new(way: &Way, crater: &Crater) -> Self {
        let to_centre = [0, 1].map(|axis| crater.centre()[axis] - way.from[axis]);
        let [north, east] = way.step.map(|step| step / way.length);
        let nearest = (to_centre[0] * north + to_centre[1] * east) / way.length;
        let across = to_centre[0] * east - to_centre[1] * north;
        Self { nearest, miss: across * across }
    }

    /// Adds the shares inside `ends` at which a way of a length (m) crosses a circle of the crater.
    pub fn crossings(&self, length: f64, crater: &Crater, ends: [f64; 2], cuts: &mut Vec<f64>) {
        for ring in crater.rings() {
            let square = ring.outer * ring.outer - self.miss;
            if square > 0.0 {
                let half = square.sqrt() / length;
                let both = [self.nearest - half, self.nearest + half];
                cuts.extend(both.into_iter().filter(|cut| *cut > ends[0] && *cut < ends[1]));
            }
        }
    }
}
