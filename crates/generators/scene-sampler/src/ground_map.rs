//! Colours of the ground over the map or under photographs, looked up pixel by pixel.

use std::sync::Arc;

use glam::DVec3;
use landscape::{Landscape, Photometry, shade};
use photo_drape::{Drape, Footprint};

use crate::slopes::Slopes;

/// What the ground looks like at the posts of a grid on the map, linear between them; or what photographs show of it.
#[derive(Debug, Clone)]
pub struct GroundMap(Texels);

#[derive(Debug, Clone)]
enum Texels {
    Colours { axes: [Axis; 2], colours: Arc<[[f32; 3]]> },
    Lit(LitSlopes),
    Photographs { drape: Arc<Drape>, half_pixel: f64, unseen: Arc<[f32]> },
}

/// Slopes of posts under a sun.
#[derive(Debug, Clone)]
struct LitSlopes {
    axes: [Axis; 2],
    slopes: Slopes,
    landscape: Arc<Landscape>,
    /// Unit vector to the sun: north, east, up.
    sun: [f64; 3],
    /// Share of the sun that reaches each post, 0 to 1; none where all do.
    lit: Option<Arc<[[f32; 1]]>>,
}

/// Posts along one axis of the map, evenly spaced but for the last of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Place of the first post (m).
    pub first: f64,
    /// Distance of most posts (m), above 0.
    pub step: f64,
    /// How many cells are `step` wide.
    pub whole: usize,
    /// Distance (m) of the posts behind those, above 0.
    pub last_step: f64,
    /// How many posts there are, at least 2.
    pub posts: usize,
}

impl Axis {
    /// The post before a place (m) and the share of the cell behind it, 0..=1; the border where the place lies beyond it.
    fn cell(&self, place: f64) -> (usize, f64) {
        let steps = (place - self.first) / self.step;
        let whole = self.whole as f64;
        let beyond = (place - self.first - whole * self.step) / self.last_step;
        let at = if steps <= whole { steps } else { whole + beyond };
        let at = at.clamp(0.0, (self.posts - 1) as f64);
        let cell = (at as usize).min(self.posts - 2);
        (cell, at - cell as f64)
    }
}

impl GroundMap {
    /// A map of `colours` (linear red, green, blue), row by row: posts along the second axis follow one another. `None` if their number is
    /// not that of the posts.
    pub fn of_colours(axes: [Axis; 2], colours: Arc<[[f32; 3]]>) -> Option<Self> {
        holds(&axes, colours.len()).then_some(Self(Texels::Colours { axes, colours }))
    }

    /// A map of slopes. A place is lit by `sun`, a unit vector to it (north, east, up), under the law of reflection of `landscape`, and has its
    /// albedo there. `None` if the number of slopes is not that of the posts.
    pub fn of_slopes(
        axes: [Axis; 2],
        slopes: Slopes,
        landscape: Arc<Landscape>,
        sun: [f64; 3],
    ) -> Option<Self> {
        let is_whole = holds(&axes, slopes.posts());
        is_whole.then_some(Self(Texels::Lit(LitSlopes { axes, slopes, landscape, sun, lit: None })))
    }

    /// The same map with cast shadow: the share of the sun that reaches each post, 0 to 1, mixed between posts. `None` if it is no map of
    /// slopes, or their number is not that of the posts.
    pub fn with_shadow(self, lit: Arc<[[f32; 1]]>) -> Option<Self> {
        let Texels::Lit(slopes) = self.0 else { return None };
        holds(&slopes.axes, lit.len()).then_some(Self(Texels::Lit(LitSlopes { lit: Some(lit), ..slopes })))
    }

    /// What photographs show in pixels of half an angle `half_pixel` (rad). `unseen` is the light of each post of their ground where none shows it.
    /// `None` if its number is not that of the posts.
    pub fn of_photographs(drape: Arc<Drape>, half_pixel: f64, unseen: Arc<[f32]>) -> Option<Self> {
        let is_whole = unseen.len() == drape.ground().heights().len();
        is_whole.then_some(Self(Texels::Photographs { drape, half_pixel, unseen }))
    }

    /// Colour (linear red, green, blue) at a place (north, east, up; m) for an eye; beyond the border that of the border.
    pub fn at(&self, place: DVec3, eye: DVec3) -> [f64; 3] {
        match &self.0 {
            Texels::Colours { axes, colours } => listed(axes, colours, place),
            Texels::Lit(slopes) => slopes.at(place, eye),
            Texels::Photographs { drape, half_pixel, unseen } => {
                let on_map = [place.x, place.y];
                let footprint = Footprint::seen(place, drape.ground().normal(on_map), eye, *half_pixel);
                let light = match drape.at(place, &footprint) {
                    Some(shown) => shown.light,
                    None => drape.ground().between(on_map, |post| [f64::from(unseen[post])])[0],
                };
                [light.clamp(0.0, 1.0); 3]
            }
        }
    }
}

impl LitSlopes {
    fn at(&self, place: DVec3, eye: DVec3) -> [f64; 3] {
        let photometry = *self.landscape.photometry();
        // Only these laws ask from where the ground is seen, and a root for each pixel costs.
        let to_eye = match photometry {
            Photometry::Lambert => DVec3::ZERO,
            _ => (eye - place).normalize_or_zero(),
        };
        let columns = self.axes[1].posts;
        let slopes = between(&self.axes, place, |post| self.slopes.at(post, columns));
        let shaded = shade(self.sun, slopes, to_eye.to_array(), photometry);
        let light = match &self.lit {
            Some(lit) => shaded * listed(&self.axes, lit, place)[0],
            None => shaded,
        };
        self.landscape.albedo_at(place.x, place.y).map(|albedo| (albedo * light).clamp(0.0, 1.0))
    }
}

/// Listed texels at the four posts around a place, mixed.
fn listed<const N: usize>(axes: &[Axis; 2], texels: &[[f32; N]], place: DVec3) -> [f64; N] {
    between(axes, place, |[row, column]| texels[row * axes[1].posts + column])
}

/// Texels at the four posts around a place, mixed. Each is asked for by its row and column.
fn between<const N: usize>(
    axes: &[Axis; 2],
    place: DVec3,
    texel: impl Fn([usize; 2]) -> [f32; N],
) -> [f64; N] {
    let ((row, v), (column, u)) = (axes[0].cell(place.x), axes[1].cell(place.y));
    let along = |row: usize| mix(&doubles(&texel([row, column])), &doubles(&texel([row, column + 1])), u);
    mix(&along(row), &along(row + 1), v)
}

fn doubles<const N: usize>(texel: &[f32; N]) -> [f64; N] {
    let mut doubles = [0.0; N];
    for channel in 0..N {
        doubles[channel] = f64::from(texel[channel]);
    }
    doubles
}

/// Whether a grid has as many posts.
fn holds(axes: &[Axis; 2], texels: usize) -> bool {
    axes.iter().all(|axis| axis.posts >= 2) && axes[0].posts * axes[1].posts == texels
}

fn mix<const N: usize>(a: &[f64; N], b: &[f64; N], share: f64) -> [f64; N] {
    let mut mixed = [0.0; N];
    for channel in 0..N {
        mixed[channel] = (1.0 - share) * a[channel] + share * b[channel];
    }
    mixed
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Posts at 10, 12, 14, 14.5 and 15 along the first axis, 0 and 4 along the second; red is the place's first part, green the second.
    fn map() -> GroundMap {
        let north = Axis { first: 10.0, step: 2.0, whole: 2, last_step: 0.5, posts: 5 };
        let east = Axis { first: 0.0, step: 4.0, whole: 1, last_step: 4.0, posts: 2 };
        let colour = |x: f32| [0.0, 4.0].map(|y| [x, y, 1.0]);
        let colours: Vec<_> = [10.0, 12.0, 14.0, 14.5, 15.0].into_iter().flat_map(colour).collect();
        GroundMap::of_colours([north, east], colours.into()).unwrap()
    }

    fn at([north, east]: [f64; 2]) -> [f64; 3] {
        map().at(DVec3::new(north, east, 0.0), DVec3::Z)
    }

    #[test]
    fn a_plane_comes_back_between_posts_of_any_distance() {
        for place in [[10.0, 0.0], [11.3, 2.5], [14.0, 4.0], [14.2, 1.0], [14.9, 3.9], [15.0, 0.5]] {
            let [red, green, blue] = at(place);
            assert!((red - place[0]).abs() < 1e-6 && (green - place[1]).abs() < 1e-6, "{place:?}");
            assert!((blue - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn beyond_the_border_it_is_the_borders() {
        assert_eq!(at([-5.0, 99.0]), [10.0, 4.0, 1.0]);
        assert_eq!(at([99.0, -1.0]), [15.0, 0.0, 1.0]);
    }

    #[test]
    fn colours_must_be_as_many_as_posts() {
        let axis = Axis { first: 0.0, step: 1.0, whole: 1, last_step: 1.0, posts: 2 };
        assert!(GroundMap::of_colours([axis; 2], vec![[0.0; 3]; 3].into()).is_none());
    }

    #[test]
    fn slopes_by_heights_are_those_that_a_list_has() {
        let north = Axis { first: 0.0, step: 2.0, whole: 3, last_step: 2.0, posts: 4 };
        let east = Axis { first: 5.0, step: 3.0, whole: 2, last_step: 1.0, posts: 5 };
        let places = [vec![0.0, 2.0, 4.0, 6.0], vec![5.0, 8.0, 11.0, 12.0, 13.0]];
        let heights: Vec<f64> = (0..20).map(|post| f64::from(post * post % 7)).collect();
        let between = Slopes::Between { places: places.clone().into(), heights: heights.clone().into() };
        let height = |row: usize, column: usize| heights[row * 5 + column];
        let listed: Vec<_> =
            (0..20).map(|post| crate::slopes_between(&places, [post / 5, post % 5], height)).collect();
        // By hand: over 4 m to the north; on both borders to the east over one cell of 3 m and of 1 m.
        let by_hand = [height(2, 0) - height(0, 0), height(1, 1) - height(1, 0), height(3, 4) - height(3, 3)];
        assert_eq!(between.at([1, 0], 5), [(by_hand[0] / 4.0) as f32, (by_hand[1] / 3.0) as f32]);
        assert_eq!(between.at([3, 4], 5)[1], by_hand[2] as f32);
        for post in 0..20 {
            assert_eq!(between.at([post / 5, post % 5], 5), listed[post]);
        }
        let level = landscape::Level::new(100.0, [-50.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        let bank = landscape::Bank::new("", vec![level], None).unwrap();
        let ground = Arc::new(Landscape::new(bank, 0.5));
        let sun = [0.6, 0.0, 0.8];
        let map = |slopes| GroundMap::of_slopes([north, east], slopes, ground.clone(), sun).unwrap();
        let maps = [map(between), map(Slopes::Listed(listed.into()))];
        for place in [[0.0, 5.0], [1.3, 7.7], [3.9, 12.4], [6.0, 13.0], [9.0, 2.0]] {
            let [a, b] = maps.each_ref().map(|map| map.at(DVec3::new(place[0], place[1], 0.0), DVec3::Z));
            assert_eq!(a, b, "{place:?}");
        }
    }
}
