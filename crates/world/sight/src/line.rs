//! A straight line over a datum that bends.

use crate::curvature::{Curvature, Law};

/// A stretch of the line over one triangle: shares of the way from the observer (0..=1) and heights of the ground (m) at both ends.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    pub shares: [f64; 2],
    pub ground: [f64; 2],
}

/// A straight line over a datum that bends: heights (m) above the datum of both ends, and how far it sags below its chord.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    pub start: f64,
    pub end: f64,
    sag: Sag,
}

/// How far the line lies below its chord at a share of the way (m): `share drop(whole) - drop(share whole)`.
#[derive(Debug, Clone, Copy)]
enum Sag {
    /// Drop (m) over the whole way, by a parabola; 0 where the datum is flat.
    Parabola(f64),
    /// Below a sphere's tangent plane.
    Sphere(Sphere),
}

/// The sag of a line over a sphere.
#[derive(Debug, Clone, Copy)]
struct Sphere {
    curvature: Curvature,
    /// Length of the way (m).
    whole: f64,
    /// Drop (m) over the whole way.
    drop: f64,
    /// Share of the largest sag.
    deepest: f64,
}

impl Line {
    /// The line between two heights (m) over a distance (m).
    pub fn new(start: f64, end: f64, curvature: Curvature, distance: f64) -> Self {
        let drop = curvature.drop(distance);
        let sag = match curvature.0 {
            Law::Flat | Law::Parabola { .. } => Sag::Parabola(drop),
            Law::Sphere { radius } => {
                let deepest = steep(radius, drop / distance) / distance;
                Sag::Sphere(Sphere { curvature, whole: distance, drop, deepest })
            }
        };
        Self { start, end, sag }
    }

    /// The same line to another height (m).
    pub fn ending_at(self, end: f64) -> Self {
        Self { end, ..self }
    }

    #[inline(always)]
    fn chord(&self, share: f64) -> f64 {
        (1.0 - share) * self.start + share * self.end
    }

    /// Height (m) above the datum at a share of the way.
    #[inline(always)]
    pub fn at(&self, share: f64) -> f64 {
        self.chord(share) - self.sag.at(share)
    }

    /// A height (m) below which the line does not fall between two shares.
    #[inline(always)]
    pub fn lowest(&self, [a, b]: [f64; 2]) -> f64 {
        self.chord(a).min(self.chord(b)) - self.sag.most([a, b])
    }

    /// Clearance (m) at both ends of a piece. The ends of the way belong to observer and target.
    #[inline(always)]
    pub fn clearances(&self, piece: &Piece) -> [f64; 2] {
        [0, 1].map(|end| self.at(piece.shares[end]) - piece.ground[end])
    }

    /// The share inside a piece at which a curved line comes nearest to the ground, where it does so inside.
    pub fn nearest(&self, piece: &Piece) -> Option<f64> {
        let [a, b] = piece.shares;
        if a == b || self.sag.is_flat() {
            return None;
        }
        let [at_a, at_b] = self.clearances(piece);
        let nearest = self.sag.nearest([a, b], (at_b - at_a) / (b - a));
        (nearest > a.min(b) && nearest < a.max(b)).then_some(nearest)
    }

    /// The share inside a piece at which the end of a curved line must rise most to clear it, where it must do so inside.
    ///
    /// Over a piece the clearance is `p + q t - sag(t)`, so the end must rise by `-(p / t + q - sag(t) / t)`.
    pub fn raised_most(&self, piece: &Piece) -> Option<f64> {
        let [a, b] = piece.shares;
        if a == b || self.sag.is_flat() {
            return None;
        }
        let at_ends = self.clearances(piece);
        let share = self.sag.raised_most([a, b], at_ends);
        (share > a.min(b) && share < a.max(b)).then_some(share)
    }

    /// Clearance (m) at a share inside a piece.
    pub fn clearance(&self, piece: &Piece, share: f64) -> f64 {
        let [a, b] = piece.shares;
        let part = (share - a) / (b - a);
        self.at(share) - ((1.0 - part) * piece.ground[0] + part * piece.ground[1])
    }
}

impl Sag {
    #[inline(always)]
    fn is_flat(&self) -> bool {
        matches!(self, Self::Parabola(0.0))
    }

    #[inline(always)]
    fn at(&self, share: f64) -> f64 {
        match self {
            Self::Parabola(bend) => bend * share * (1.0 - share),
            Self::Sphere(sphere) => sphere.at(share),
        }
    }

    /// Its most between two shares: it is concave.
    #[inline(always)]
    fn most(&self, [a, b]: [f64; 2]) -> f64 {
        match self {
            Self::Parabola(bend) => {
                let sag = |share: f64| share * (1.0 - share);
                let middle = (a - 0.5) * (b - 0.5) < 0.0;
                bend * if middle { 0.25 } else { sag(a).max(sag(b)) }
            }
            Self::Sphere(sphere) => sphere.at(sphere.deepest.clamp(a.min(b), a.max(b))),
        }
    }

    /// The share at which a clearance of a mean slope (m a share) between two shares is least, on a datum that bends.
    fn nearest(&self, [a, b]: [f64; 2], slope: f64) -> f64 {
        match self {
            Self::Parabola(bend) => 0.5 * (a + b) - slope / (2.0 * bend),
            Self::Sphere(sphere) => sphere.nearest([a, b], slope),
        }
    }

    /// The share at which a clearance, by its values at two shares, asks most of the end of the line, on a datum
    /// that bends.
    fn raised_most(&self, [a, b]: [f64; 2], at: [f64; 2]) -> f64 {
        let slope = (at[1] - at[0]) / (b - a);
        match self {
            Self::Parabola(bend) => {
                let q = slope - bend * (a + b);
                let p = at[0] - a * (q + bend * a);
                (p.max(0.0) / bend).sqrt()
            }
            Self::Sphere(sphere) => sphere.raised_most([a, b], at[0], slope),
        }
    }
}

// Apart from the parabola, whose few operations are what most lines cost.
impl Sphere {
    #[inline(never)]
    fn at(&self, share: f64) -> f64 {
        share * self.drop - self.curvature.drop(share * self.whole)
    }

    /// Slope (m a share) of the drop between two shares.
    fn slope(&self, [a, b]: [f64; 2]) -> f64 {
        let drops = [a, b].map(|share| self.curvature.drop(share * self.whole));
        (drops[1] - drops[0]) / (b - a)
    }

    #[inline(never)]
    fn nearest(&self, shares: [f64; 2], slope: f64) -> f64 {
        steep(self.curvature.reach(), (self.slope(shares) - slope) / self.whole) / self.whole
    }

    #[inline(never)]
    fn raised_most(&self, [a, b]: [f64; 2], at_a: f64, slope: f64) -> f64 {
        let q = slope - self.slope([a, b]);
        let p = (at_a - self.curvature.drop(a * self.whole) - a * q).max(0.0);
        let radius = self.curvature.reach();
        radius * (p * (2.0 * radius + p)).sqrt() / ((radius + p) * self.whole)
    }
}

/// Distance (m) at which a sphere of a radius (m) falls by a slope.
fn steep(radius: f64, slope: f64) -> f64 {
    radius * slope / (1.0 + slope * slope).sqrt()
}
