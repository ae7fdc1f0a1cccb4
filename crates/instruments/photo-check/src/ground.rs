//! The posts of an elevation grid in the axes of a photograph.

use std::f64::consts::PI;

use glam::DVec3;
use photo_camera::voids::Filled;
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture, PictureError};
use survey::{Affine, Elevation, Frame};

use crate::GroundError;
use crate::rule::Rule;

/// An elevation grid as a photograph takes it.
#[derive(Debug, Clone)]
pub struct Ground {
    /// Heights after the fill, and the mask of what was void.
    pub filling: Filled,
    size: [usize; 2],
    affine: Affine,
    frame: Frame,
    rule: Rule,
}

impl Ground {
    /// The grid of `elevation` with the heights of `filling`, for `photo`.
    ///
    /// # Errors
    /// If the places of the file do not go with the photograph.
    pub fn new(elevation: &Elevation, filling: Filled, photo: &Photograph) -> Result<Self, GroundError> {
        Ok(Self {
            filling,
            size: [elevation.lines, elevation.columns],
            affine: elevation.affine,
            frame: elevation.frame,
            rule: Rule::of(elevation.frame, photo.placement())?,
        })
    }

    /// The ground of every second post each way.
    pub fn coarser(&self) -> Self {
        let [lines, columns] = self.size;
        let kept: Vec<usize> = (0..lines)
            .step_by(2)
            .flat_map(|line| (0..columns).step_by(2).map(move |column| line * columns + column))
            .collect();
        let heights = kept.iter().map(|post| self.filling.heights[*post]).collect();
        let was_void = kept.iter().map(|post| self.filling.was_void[*post]).collect();
        Self {
            filling: Filled { heights, was_void, ..self.filling },
            size: self.size.map(|count| count.div_ceil(2)),
            affine: Affine { step: self.affine.step.map(|step| 2.0 * step), ..self.affine },
            ..*self
        }
    }

    /// Number of lines and of posts in a line.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// How the coordinates of the file are meant.
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Whether a post was void in the file.
    pub fn was_void(&self, [line, column]: [usize; 2]) -> bool {
        self.filling.was_void[line * self.size[1] + column]
    }

    /// White where the file has no height, black elsewhere: a pixel a post, in the order of the file.
    ///
    /// # Errors
    /// Never, for a grid of one post or more.
    pub fn mask(&self) -> Result<GreyPicture, PictureError> {
        let codes = self.filling.was_void.iter().map(|void| if *void { Depth::Eight.white() } else { 0 });
        GreyPicture::new(self.size[1], self.size[0], Depth::Eight, codes.collect())
    }

    /// Whether the first line lies north of the others, and the first post west of the others of its line.
    pub fn begins_north_west(&self) -> [bool; 2] {
        [self.affine.step[0] < 0.0, self.affine.step[1] > 0.0]
    }

    /// Height of a post after the fill (m); none where a void stays.
    pub fn height(&self, [line, column]: [usize; 2]) -> Option<f64> {
        let height = self.filling.heights[line * self.size[1] + column];
        (!height.is_nan()).then_some(height)
    }

    /// Height between the posts (m), bilinear, at continuous line and column; none outside the grid or beside a void.
    pub fn height_between(&self, [line, column]: [f64; 2]) -> Option<f64> {
        self.between([line, column], |post| self.height(post))
    }

    /// A value of the posts, bilinear at continuous line and column; none outside the grid or beside a post without one.
    pub fn between(&self, at: [f64; 2], value: impl Fn([usize; 2]) -> Option<f64>) -> Option<f64> {
        let inside = |axis: usize| (0.0..=(self.size[axis] - 1) as f64).contains(&at[axis]);
        if !inside(0) || !inside(1) {
            return None;
        }
        let first = [0, 1].map(|axis| (at[axis] as usize).min(self.size[axis] - 2));
        let share = [0, 1].map(|axis| at[axis] - first[axis] as f64);
        let mut sum = 0.0;
        for [down, across] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
            let part = |axis: usize, step: usize| if step == 1 { share[axis] } else { 1.0 - share[axis] };
            let weight = part(0, down) * part(1, across);
            // A corner without weight need not have a value: posts themselves can always be asked.
            if weight > 0.0 {
                sum += weight * value([first[0] + down, first[1] + across])?;
            }
        }
        Some(sum)
    }

    /// Coordinates of the file (m or rad; north, east) at continuous line and column.
    fn coordinates(&self, [line, column]: [f64; 2]) -> [f64; 2] {
        let Affine { first, step } = self.affine;
        [first[0] + line * step[0], first[1] + column * step[1]]
    }

    /// Continuous line and column of coordinates of the file (m or rad; north, east), inside the grid or not.
    pub fn post_at(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        let Affine { first, step } = self.affine;
        let apart = east - first[1];
        let apart = match self.frame {
            Frame::Plane(_) => apart,
            // Longitudes are compared modulo a turn, counted from the first column in its direction.
            Frame::Geographic { .. } => {
                let turn = 2.0 * PI * step[1].signum();
                let within = (apart / turn).rem_euclid(1.0) * turn;
                // Just before the first column is before it, not a turn behind it.
                if within / step[1] > (self.size[1] - 1) as f64 + 0.5 { within - turn } else { within }
            }
        };
        [(north - first[0]) / step[0], apart / step[1]]
    }

    /// The ground point of the photograph at continuous line and column and a height (m); none where the map projection of the
    /// file has no inverse.
    pub fn point(&self, at: [f64; 2], height: f64) -> Option<DVec3> {
        self.point_of(self.coordinates(at), height)
    }

    /// The ground point of coordinates of the file (m or rad; north, east) at a height (m).
    pub fn point_of(&self, coordinates: [f64; 2], height: f64) -> Option<DVec3> {
        self.rule.point(coordinates, height)
    }

    /// Continuous line and column under a ground point, inside the grid or not, and its height (m). None where the map of the file
    /// does not show the place.
    pub fn post_of(&self, point: DVec3) -> Option<([f64; 2], f64)> {
        match self.rule.place(point) {
            None => Some((self.post_at([point.y, point.x]), point.z)),
            Some(place) => {
                let coordinates = self.coordinates_of([place.latitude, place.longitude])?;
                Some((self.post_at(coordinates), place.height))
            }
        }
    }

    /// Coordinates of the file of a latitude and longitude (rad); none where its map does not show the place.
    pub fn coordinates_of(&self, [latitude, longitude]: [f64; 2]) -> Option<[f64; 2]> {
        match self.frame {
            Frame::Geographic { .. } => Some([latitude, longitude]),
            Frame::Plane(projection) => {
                let middle = self.coordinates(self.size.map(|count| 0.5 * (count - 1) as f64));
                projection?.forward_near(latitude, longitude, middle)
            }
        }
    }

    /// Ground points of all known posts, line by line.
    pub fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        let [lines, columns] = self.size;
        let posts = (0..lines).flat_map(move |line| (0..columns).map(move |column| [line, column]));
        posts.filter_map(|post| self.point(post.map(|at| at as f64), self.height(post)?))
    }

    /// Metres to the north and to the east of one step of line and of one step of column, signed, at a line.
    pub fn steps(&self, line: f64) -> [f64; 2] {
        let step = self.affine.step;
        match self.frame {
            Frame::Plane(_) => step,
            Frame::Geographic { radius } => {
                let latitude = self.coordinates([line, 0.0])[0];
                [step[0] * radius, step[1] * radius * libm::cos(latitude)]
            }
        }
    }

    /// Direction of true north at the middle of the grid, clockwise from the grid's north (rad); 0 where it is not known or not
    /// meant.
    pub fn true_north(&self) -> f64 {
        let middle = self.coordinates(self.size.map(|count| 0.5 * (count - 1) as f64));
        match &self.rule {
            Rule::Projected(_, projection) => projection.true_north(middle).unwrap_or(0.0),
            _ => 0.0,
        }
    }

    /// What whoever reads the check should know: the sphere of the file is not that of the camera, or the camera stands in the
    /// ground.
    pub fn doubts(&self, placement: &Placement) -> Vec<String> {
        self.other_sphere().into_iter().chain(self.camera_below(placement)).collect()
    }

    fn camera_below(&self, placement: &Placement) -> Option<String> {
        let Placement::Camera { camera, .. } = placement else { return None };
        let (post, height) = self.post_of(camera.centre())?;
        let below = self.height_between(post)? - height;
        (below >= 0.0).then(|| format!("the camera stands {below:.1} m under the ground of the grid"))
    }

    fn other_sphere(&self) -> Option<String> {
        let (Rule::Geographic(body) | Rule::Projected(body, _)) = &self.rule else { return None };
        let sphere = self.frame.sphere()?;
        let is_other = body.eccentricity_squared() == 0.0 && (sphere - body.semi_major()).abs() > 1.0;
        is_other.then(|| {
            let radius = body.semi_major();
            format!("heights stand on a sphere of {sphere} m, and the camera on one of {radius} m")
        })
    }
}
