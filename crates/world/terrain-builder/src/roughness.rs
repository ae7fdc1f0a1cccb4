//! Roughness of a feature: passes of seeded random heights on posts.

use quantities::unit_interval;

use crate::growth::posts_over;
use crate::height_grid::{Area, HeightGrid, Posts};
use crate::refused::{Refused, expect};

/// Names the use of a hash.
const PASS: u64 = u64::from_be_bytes(*b"roughnes");
/// Most passes of one feature (chosen).
const MOST_PASSES: usize = 1000;

/// Passes of roughness. A pass is named by its seed, so the last one is undone by taking its seed away.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    /// Seed of each pass, in any order.
    pub seeds: Vec<u64>,
    /// Height from the lowest to the highest that one pass adds (m).
    pub scale: f64,
    /// Distance between the posts of the passes (m).
    pub spacing: f64,
    /// Radius over which heights are smoothed (m); 0 leaves them as they are.
    pub smoothing: f64,
}

impl Roughness {
    /// Posts over an area, once all numbers are in order.
    pub(crate) fn check(&self, area: Area) -> Result<Posts, Refused> {
        let scale = self.scale;
        expect((0.0..=1e5).contains(&scale), "scale_m", scale, "a height from 0 m to 1e5 m")?;
        let passes = self.seeds.len();
        expect(passes <= MOST_PASSES, "seeds", format!("{passes} seeds"), "at most 1000 seeds")?;
        let posts = posts_over(area, self.spacing)?;
        let reach = self.smoothing / self.spacing;
        let is_radius = (0.0..=50.0).contains(&reach);
        expect(is_radius, "smoothing_m", self.smoothing, "0 m to 50 times `spacing_m`")?;
        Ok(posts)
    }

    /// Heights over an area. A pass adds a number of -0.5 to 0.5 times the scale at each post, faded to 0 at the border; as reported
    /// a number of 0 to 1 without a fade, which lifts the ground by half the scale.
    ///
    /// # Errors
    /// If a number is out of range, or the posts are too many.
    pub fn heights(&self, area: Area, is_lifted: bool) -> Result<HeightGrid, Refused> {
        let posts = self.check(area)?;
        let (scale, reach) = (self.scale, self.smoothing / self.spacing);
        let mut seeds = self.seeds.clone();
        seeds.sort_unstable();
        let middle = if is_lifted { 0.0 } else { 0.5 };
        let rough = HeightGrid::new(posts, |post| scale * sum_of_passes(&seeds, post, middle));
        let smooth = if reach > 0.0 { smoothed(&rough, self.smoothing) } else { rough };
        if is_lifted {
            return Ok(smooth);
        }
        Ok(HeightGrid::new(posts, |post| posts.fade(posts.place(post)) * smooth.post(post)))
    }
}

fn sum_of_passes(seeds: &[u64], post: [usize; 2], middle: f64) -> f64 {
    let words = [PASS, post[0] as u64, post[1] as u64];
    seeds.iter().map(|&seed| unit_interval(seed, &words) - middle).sum()
}

/// Means over the posts within a radius, weighted by `(1 - d^2 / r^2)^2`.
fn smoothed(rough: &HeightGrid, radius: f64) -> HeightGrid {
    let posts = *rough.posts();
    let step = posts.step();
    let reach = step.map(|step| (radius / step) as usize);
    HeightGrid::new(posts, |post| {
        let [rows, columns] = around(&posts, post, reach);
        let near = rows.flat_map(|row| columns.clone().map(move |column| [row, column]));
        let (mut sum, mut weights) = (0.0, 0.0);
        for other in near {
            let way = [0, 1].map(|axis| step[axis] * (other[axis] as f64 - post[axis] as f64));
            let left = (1.0 - (way[0] * way[0] + way[1] * way[1]) / (radius * radius)).max(0.0);
            sum += left * left * rough.post(other);
            weights += left * left;
        }
        sum / weights
    })
}

fn around(posts: &Posts, post: [usize; 2], reach: [usize; 2]) -> [std::ops::RangeInclusive<usize>; 2] {
    [0, 1].map(|axis| {
        let high = (post[axis] + reach[axis]).min(posts.count[axis] - 1);
        post[axis].saturating_sub(reach[axis])..=high
    })
}
