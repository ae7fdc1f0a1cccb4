//! The way of a line over the mesh: piece by piece, and past blocks that it clears.

use std::ops::ControlFlow;

use crate::Posts;
use crate::line::Piece;

/// Share of a cell by which the blocks of a strip are chosen wider than the line, so that rounding leaves none out. Chosen.
const SLACK: f64 = 1e-6;

/// Who looks along the way.
pub trait Judge {
    /// Whether ground up to a height (m) between two shares of the way needs no look.
    fn passes(&self, shares: [f64; 2], highest: f64) -> bool;

    /// Looks at one piece; a break ends the way.
    fn look(&mut self, piece: Piece) -> ControlFlow<()>;
}

/// A way on the map, in posts. Its axis `main` is the one along which it goes farther; places begin with that axis.
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    main: usize,
    from: [f64; 2],
    to: [f64; 2],
    /// Change of the other axis along the main one, -1..=1.
    slope: f64,
}

impl Ray {
    /// The way between two places (row, column); `None` where they are one.
    pub fn new(from: [f64; 2], to: [f64; 2]) -> Option<Self> {
        let [rows, columns] = [0, 1].map(|axis| (to[axis] - from[axis]).abs());
        let main = usize::from(columns > rows);
        let turned = |at: [f64; 2]| [at[main], at[1 - main]];
        let [from, to] = [turned(from), turned(to)];
        let slope = (to[1] - from[1]) / (to[0] - from[0]);
        (from != to).then_some(Self { main, from, to, slope })
    }

    /// Length of the way (posts).
    pub fn length(&self) -> f64 {
        let [along, across] = [0, 1].map(|axis| self.to[axis] - self.from[axis]);
        (along * along + across * across).sqrt()
    }

    /// Whether the pieces come from the target to the observer.
    pub fn is_reversed(&self) -> bool {
        self.to[0] < self.from[0]
    }

    /// Goes along the whole way that lies over the mesh, in the order of rising `main`.
    pub fn walk(&self, posts: &Posts, judge: &mut impl Judge) {
        let Some(reach) = self.over(posts) else { return };
        let last = posts.size()[self.main] - 2;
        let mut strip = (reach[0] as usize).min(last);
        let mut level = 0;
        // A way that only touches the mesh has one strip all the same.
        while strip <= last && ((strip as f64) < reach[1] || strip as f64 == reach[0]) {
            let width = 1 << level;
            if self.passes(posts, judge, level, strip, reach) {
                strip += width;
                level = self.wider(posts, level, strip);
            } else if level > 0 {
                level -= 1;
            } else if self.look(posts, judge, strip, reach).is_break() {
                return;
            } else {
                strip += 1;
            }
        }
    }

    /// The next level up, where a block begins at the strip.
    fn wider(&self, posts: &Posts, level: usize, strip: usize) -> usize {
        let up = level + 1;
        if up < posts.block_levels() && strip.is_multiple_of(1 << up) {
            up
        } else {
            level.min(strip.trailing_zeros() as usize)
        }
    }

    /// First and last `main` at which the way lies over the mesh. An end on the mesh stays as it is, to the bit.
    fn over(&self, posts: &Posts) -> Option<[f64; 2]> {
        let most = [self.main, 1 - self.main].map(|axis| (posts.size()[axis] - 1) as f64);
        let ends = if self.is_reversed() { [self.to, self.from] } else { [self.from, self.to] };
        let inside = |across: f64| (0.0..=most[1]).contains(&across);
        if self.slope == 0.0 && !inside(self.from[1]) {
            return None;
        }
        let at_border = |border: f64| self.from[0] + (border - self.from[1]) / self.slope;
        let borders = [at_border(0.0), at_border(most[1])];
        let [low, high] = [borders[0].min(borders[1]), borders[0].max(borders[1])];
        let first = if inside(ends[0][1]) { ends[0][0] } else { low.max(ends[0][0]) };
        let last = if inside(ends[1][1]) { ends[1][0] } else { high.min(ends[1][0]) };
        let [first, last] = [first.max(0.0), last.min(most[0])];
        (first <= last).then_some([first, last])
    }

    /// Share of the way from the observer at a `main`.
    fn share(&self, main: f64) -> f64 {
        (main - self.from[0]) / (self.to[0] - self.from[0])
    }

    /// The other axis at a `main`; exact at both ends.
    fn across(&self, main: f64) -> f64 {
        if main == self.to[0] { self.to[1] } else { self.from[1] + (main - self.from[0]) * self.slope }
    }

    /// Whether all blocks of a strip pass.
    fn passes(&self, posts: &Posts, judge: &impl Judge, level: usize, strip: usize, reach: [f64; 2]) -> bool {
        let width = 1usize << level;
        let ends = [(strip as f64).max(reach[0]), ((strip + width) as f64).min(reach[1])];
        let across = ends.map(|main| self.across(main));
        let last = (posts.size()[1 - self.main] - 2) >> level;
        let block = |across: f64| (across.max(0.0) as usize >> level).min(last);
        let [low, high] = [across[0].min(across[1]) - SLACK, across[0].max(across[1]) + SLACK];
        let of_block = |other: usize| posts.highest(self.main, level, [strip >> level, other]);
        let highest = (block(low)..=block(high)).map(of_block).fold(f64::NEG_INFINITY, f64::max);
        judge.passes(ends.map(|main| self.share(main)), highest)
    }

    /// Looks at the pieces of a strip that is one cell wide.
    fn look(&self, posts: &Posts, judge: &mut impl Judge, strip: usize, reach: [f64; 2]) -> ControlFlow<()> {
        let (points, count) = self.crossings(strip, reach);
        let ground = |[main, across]: [f64; 2]| self.ground(posts, strip, main, across);
        let mut before = (self.share(points[0][0]), ground(points[0]));
        for &point in &points[1..count] {
            let after = (self.share(point[0]), ground(point));
            judge.look(Piece { shares: [before.0, after.0], ground: [before.1, after.1] })?;
            before = after;
        }
        ControlFlow::Continue(())
    }

    /// Both ends of the way through a strip, and where it crosses sides and diagonals of cells between them, in order.
    fn crossings(&self, strip: usize, reach: [f64; 2]) -> ([[f64; 2]; 6], usize) {
        let first = (strip as f64).max(reach[0]);
        let last = ((strip + 1) as f64).min(reach[1]);
        let [near, far] = [first, last].map(|main| [main, self.across(main)]);
        let (mut points, mut count) = ([near; 6], 1);
        let mut add = |main: f64, across: f64| {
            if count < 5 && main > first && main < last {
                points[count] = [main, across];
                count += 1;
            }
        };
        for side in between(near[1], far[1]) {
            add(self.from[0] + (side - self.from[1]) / self.slope, side);
        }
        let offset = self.from[0] - self.from[1];
        for diagonal in between(near[0] - near[1], far[0] - far[1]) {
            let main = self.from[0] + (diagonal - offset) / (1.0 - self.slope);
            add(main, main - diagonal);
        }
        points[count] = far;
        points[1..count].sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
        (points, count + 1)
    }

    /// Height of the ground (m) at a point of a strip; NaN at a void.
    fn ground(&self, posts: &Posts, strip: usize, main: f64, across: f64) -> f64 {
        let most = posts.size()[1 - self.main] - 1;
        let across = across.clamp(0.0, most as f64);
        let column = (across as usize).min(most - 1);
        let share = main - strip as f64;
        let other = across - column as f64;
        // On a diagonal both shares are one number; rounding must not pick a triangle.
        let other = if (share - other).abs() < 1e-12 { share } else { other };
        posts.in_cell(self.main, [strip, column], [share, other])
    }
}

/// Whole numbers strictly between two numbers.
fn between(a: f64, b: f64) -> impl Iterator<Item = f64> {
    let (low, high) = (a.min(b), a.max(b));
    let first = low.floor() + 1.0;
    (0..3).map(move |step| first + f64::from(step)).take_while(move |&whole| whole < high)
}
