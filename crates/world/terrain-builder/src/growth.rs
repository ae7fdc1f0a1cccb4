//! Ground that grows from control points: mountains, valleys and plateaus in one feature.

mod curve;

use crate::height_grid::{Area, HeightGrid, Posts};
use crate::refused::{Refused, expect};

pub use curve::{Pick, runs};

/// Most iterations of growth: more change nothing in f64.
const MOST_ITERATIONS: u32 = 64;
/// Most posts of one feature's own grid (chosen).
const MOST_POSTS: f64 = 4e6;

/// A point that the ground grows to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControlPoint {
    /// Place: north, east (m).
    pub at: [f64; 2],
    /// Height that the ground grows to (m).
    pub height: f64,
    /// Weight against other points; 0 has no say.
    pub weight: f64,
    /// Height that growth begins from (m).
    pub initial: f64,
}

/// Control points over an area.
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// Area that the feature may change (m).
    pub area: Area,
    /// Distance between the feature's own posts (m).
    pub spacing: f64,
    /// Points by themselves; each goes to the nearest post.
    pub points: Vec<ControlPoint>,
    /// Curves: each runs through its picks, with every post between them.
    pub curves: Vec<Vec<Pick>>,
    /// Steps of growth, each half of the way that is left. None: all the way.
    pub iterations: Option<u32>,
}

/// Where the document does otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct GrowthReported {
    /// Heights are sums of height over distance, added up at each iteration, not weighted means.
    pub is_sum: bool,
    /// The run along a curve is divided by the number of posts between its picks, not by that number plus one.
    pub divides_by_between: bool,
}

impl Growth {
    /// The points on their posts, those of curves behind the others. Of points on one post the last one stays; the number of points
    /// that were dropped comes second.
    ///
    /// # Errors
    /// If the area is empty or has too many posts, a number is out of range, or no point has weight.
    fn seated(&self, reported: GrowthReported) -> Result<(Posts, Vec<Seat>, usize), Refused> {
        let posts = self.posts()?;
        let divides = reported.divides_by_between;
        let curves = self.curves.iter().flat_map(|picks| curve::points(&posts, picks, divides));
        let mut seats: Vec<Seat> = Vec::new();
        let mut dropped = 0;
        for point in self.points.iter().copied().chain(curves) {
            check(&point)?;
            let post = posts.nearest(point.at);
            let before = seats.len();
            seats.retain(|seat| seat.post != post);
            dropped += before - seats.len();
            seats.push(Seat { post, point });
        }
        let has_say = seats.iter().any(|seat| seat.point.weight > 0.0);
        expect(has_say, "points", "without any weight", "at least one point of weight above 0")?;
        Ok((posts, seats, dropped))
    }

    /// Refuses what cannot grow.
    pub(crate) fn check(&self) -> Result<(), Refused> {
        self.seated(GrowthReported::default()).map(|_| ())
    }

    fn posts(&self) -> Result<Posts, Refused> {
        let posts = posts_over(self.area, self.spacing)?;
        let iterations = self.iterations.unwrap_or(1);
        let is_count = (1..=MOST_ITERATIONS).contains(&iterations);
        expect(is_count, "iterations", iterations, "a whole number from 1 to 64")?;
        Ok(posts)
    }

    /// Heights of the feature on its own posts, and how many points were dropped because a later one has the same post.
    ///
    /// # Errors
    /// If the area is empty or has too many posts, a number is out of range, or no point has weight.
    pub fn grown(&self, reported: GrowthReported) -> Result<(HeightGrid, usize), Refused> {
        let (posts, seats, dropped) = self.seated(reported)?;
        let heights = if reported.is_sum {
            let iterations = f64::from(self.iterations.unwrap_or(1));
            HeightGrid::new(posts, |post| iterations * sums(&seats, post)[0])
        } else {
            // 2^-m is exact.
            let left = self.iterations.map_or(0.0, |m| 1.0 / (1u128 << m) as f64);
            HeightGrid::new(posts, |post| {
                posts.fade(posts.place(post)) * grown_at(&posts, &seats, post, left)
            })
        };
        Ok((heights, dropped))
    }

    /// Sums of one iteration as reported at a post: heights over distances, and weights over distances, distances in posts and at
    /// least 1. Nothing in the document reads the second.
    ///
    /// # Errors
    /// As those of [`grown`](Self::grown).
    pub fn reported_sums(&self, post: [usize; 2]) -> Result<[f64; 2], Refused> {
        let (_, seats, _) = self.seated(GrowthReported::default())?;
        Ok(sums(&seats, post))
    }
}

/// A point on a post of the feature.
struct Seat {
    post: [usize; 2],
    point: ControlPoint,
}

/// Posts over an area, once both are in order.
pub(crate) fn posts_over(area: Area, spacing: f64) -> Result<Posts, Refused> {
    let is_length = (1e-3..=1e7).contains(&spacing);
    expect(is_length, "spacing_m", spacing, "a length from 0.001 m to 1e7 m")?;
    let sides = [0, 1].map(|axis| area[1][axis] - area[0][axis]);
    let count = (sides[0] / spacing) * (sides[1] / spacing);
    expect(count <= MOST_POSTS, "spacing_m", spacing, "a longer one: a feature has at most 4 million posts")?;
    expect(sides.iter().all(|side| *side > 0.0), "longitude_deg", "empty", "a range that is not empty")?;
    Ok(Posts::new(area, spacing))
}

fn check(point: &ControlPoint) -> Result<(), Refused> {
    let heights = [point.height, point.initial];
    let is_height = heights.iter().all(|height| height.abs() <= 1e6);
    expect(is_height, "points", format!("{heights:?} m high"), "heights of at most 1e6 m either way")?;
    let is_weight = (0.0..=1e9).contains(&point.weight);
    expect(is_weight, "points", format!("of weight {}", point.weight), "weights from 0 to 1e9")
}

/// Sums of height over distance and of weight over distance, distances in posts.
fn sums(seats: &[Seat], post: [usize; 2]) -> [f64; 2] {
    seats.iter().fold([0.0; 2], |[heights, weights], seat| {
        let way = [0, 1].map(|axis| post[axis] as f64 - seat.post[axis] as f64);
        let distance = (way[0] * way[0] + way[1] * way[1]).sqrt().max(1.0);
        [heights + seat.point.height / distance, weights + seat.point.weight / distance]
    })
}

/// Height with a share of the growth left to do.
fn grown_at(posts: &Posts, seats: &[Seat], post: [usize; 2], left: f64) -> f64 {
    let places = seats.iter().map(|seat| (posts.place(seat.post), &seat.point));
    let [height, initial] = shepard(places, posts.place(post));
    height + left * (initial - height)
}

/// Means of height and initial height, weighted by weight over the square of the distance (Shepard's interpolation of power 2). At
/// a point that has weight they are the point's own.
fn shepard<'p>(points: impl Iterator<Item = ([f64; 2], &'p ControlPoint)>, place: [f64; 2]) -> [f64; 2] {
    let mut sums = [0.0; 3];
    for (at, point) in points.filter(|(_, point)| point.weight > 0.0) {
        let way = [place[0] - at[0], place[1] - at[1]];
        let square = way[0] * way[0] + way[1] * way[1];
        if square == 0.0 {
            return [point.height, point.initial];
        }
        let weight = point.weight / square;
        sums[0] += weight * point.height;
        sums[1] += weight * point.initial;
        sums[2] += weight;
    }
    [sums[0] / sums[2], sums[1] / sums[2]]
}
