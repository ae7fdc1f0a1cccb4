//! Places of a line that matter, found by bounds that hold: nothing is sampled, so no ridge and no rim is stepped over.

use std::ops::ControlFlow;

use crate::stretch::{Part, Stretch};

/// Halvings of a stretch after which a touch is not told from a crossing.
const DEPTH: u32 = 48;

/// Who looks along a stretch.
pub trait Searcher {
    /// Height (m) by which the end of the line has been raised.
    fn raise(&self) -> f64 {
        0.0
    }

    /// Whether a part between two shares whose clearance (m), the raise included, is nowhere below `bound` needs no look.
    fn passes(&self, shares: [f64; 2], bound: f64) -> bool;

    /// Looks at a place: its share and the clearance (m) of the line that has not been raised. A break ends the way.
    fn look(&mut self, share: f64, clearance: f64) -> ControlFlow<()>;
}

/// Looks at a part of a stretch, its halves and so on, until all of it passes.
pub fn search(stretch: &Stretch<'_>, part: &Part, searcher: &mut impl Searcher) -> ControlFlow<()> {
    for end in 0..2 {
        searcher.look(part.ends[end], part.clearances[end])?;
    }
    within(stretch, part, searcher, DEPTH)
}

fn within(stretch: &Stretch<'_>, part: &Part, searcher: &mut impl Searcher, depth: u32) -> ControlFlow<()> {
    if depth == 0 || searcher.passes(part.ends, stretch.lowest(part, searcher.raise())) {
        return ControlFlow::Continue(());
    }
    let [near, far] = stretch.halves(part);
    searcher.look(near.ends[1], near.clearances[1])?;
    within(stretch, &near, searcher, depth - 1)?;
    within(stretch, &far, searcher, depth - 1)
}

/// Ends the way at any ground that stands above the line by more than `touch` (m).
pub struct Hides {
    pub touch: f64,
    pub blocked: bool,
}

/// Finds the first share at which ground stands above the line by more than `touch` (m).
pub struct First {
    pub touch: f64,
    pub share: Option<f64>,
}

/// Finds the least clearance (m), to within `touch`.
pub struct Least {
    pub touch: f64,
    pub clearance: f64,
}

/// Raises the end of the line until no ground stands above it by more than `touch` (m).
pub struct Rises {
    pub touch: f64,
    pub raise: f64,
}

impl Searcher for Hides {
    fn passes(&self, _: [f64; 2], bound: f64) -> bool {
        bound >= -self.touch
    }

    fn look(&mut self, _: f64, clearance: f64) -> ControlFlow<()> {
        self.blocked = clearance < -self.touch;
        if self.blocked { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Searcher for First {
    fn passes(&self, shares: [f64; 2], bound: f64) -> bool {
        bound >= -self.touch || self.share.is_some_and(|share| shares[0] >= share)
    }

    fn look(&mut self, share: f64, clearance: f64) -> ControlFlow<()> {
        if clearance < -self.touch && self.share.is_none_or(|first| share < first) {
            self.share = Some(share);
        }
        ControlFlow::Continue(())
    }
}

impl Searcher for Least {
    fn passes(&self, _: [f64; 2], bound: f64) -> bool {
        bound >= self.clearance - self.touch
    }

    fn look(&mut self, _: f64, clearance: f64) -> ControlFlow<()> {
        self.clearance = self.clearance.min(clearance);
        ControlFlow::Continue(())
    }
}

impl Searcher for Rises {
    fn raise(&self) -> f64 {
        self.raise
    }

    fn passes(&self, _: [f64; 2], bound: f64) -> bool {
        bound >= -self.touch
    }

    fn look(&mut self, share: f64, clearance: f64) -> ControlFlow<()> {
        if share > 0.0 && clearance + self.raise * share < -self.touch {
            self.raise = -clearance / share;
        }
        ControlFlow::Continue(())
    }
}
