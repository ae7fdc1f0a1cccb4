//! What a line of sight is asked: whether something blocks it, and how high its target has to stand.

use std::ops::ControlFlow;

use crate::line::{Line, Piece};
use crate::ray::Judge;

/// Ends the way at the first ground above the line.
pub struct Blocked {
    pub line: Line,
    pub blocked: bool,
    pub void: bool,
}

/// Raises the end of the line wherever ground stands above it.
pub struct Raised {
    pub line: Line,
    pub void: bool,
}

/// Keeps all pieces of a line.
#[derive(Default)]
pub struct Kept(pub Vec<Piece>);

impl Judge for Blocked {
    fn passes(&self, shares: [f64; 2], highest: f64) -> bool {
        self.line.lowest(shares) >= highest
    }

    fn look(&mut self, piece: Piece) -> ControlFlow<()> {
        if is_void(&piece) {
            self.void = true;
            return ControlFlow::Continue(());
        }
        self.blocked = lowest(&self.line, &piece) < 0.0;
        if self.blocked { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Judge for Raised {
    fn passes(&self, shares: [f64; 2], highest: f64) -> bool {
        self.line.lowest(shares) >= highest
    }

    fn look(&mut self, piece: Piece) -> ControlFlow<()> {
        if is_void(&piece) {
            self.void = true;
        } else {
            self.line.end += missing(&self.line, &piece);
        }
        ControlFlow::Continue(())
    }
}

impl Judge for Kept {
    fn passes(&self, _: [f64; 2], _: f64) -> bool {
        false
    }

    fn look(&mut self, piece: Piece) -> ControlFlow<()> {
        self.0.push(piece);
        ControlFlow::Continue(())
    }
}

/// Whether a piece has no ground at one of its ends.
pub fn is_void(piece: &Piece) -> bool {
    piece.ground[0].is_nan() || piece.ground[1].is_nan()
}

/// Least clearance (m) over a piece, its observer and target left out.
pub fn lowest(line: &Line, piece: &Piece) -> f64 {
    let at_ends = line.clearances(piece);
    let own = |end: usize| piece.shares[end] <= 0.0 || piece.shares[end] >= 1.0;
    let ends = [0, 1].map(|end| if own(end) { f64::INFINITY } else { at_ends[end] });
    let inside = line.nearest(piece).map_or(f64::INFINITY, |share| line.clearance(piece, share));
    ends[0].min(ends[1]).min(inside)
}

/// Height (m) by which the end of the line must rise to clear a piece: the largest of -clearance / share.
pub fn missing(line: &Line, piece: &Piece) -> f64 {
    let at_ends = line.clearances(piece);
    let own = |share: f64| share <= 0.0 || share >= 1.0;
    let at_end = |end: usize| if own(piece.shares[end]) { 0.0 } else { -at_ends[end] / piece.shares[end] };
    let ends = at_end(0).max(at_end(1)).max(0.0);
    match line.raised_most(piece) {
        Some(share) => ends.max(-line.clearance(piece, share) / share),
        None => ends,
    }
}
