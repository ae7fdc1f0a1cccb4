//! The program: greys of panels once, then a picture for every eye.

use glam::DVec3;
use photograph::Photograph;
use raster::{LARGEST_SIDE, Screen};

use crate::depth::{DepthBuffer, DepthPlane, NoDepth};
use crate::fill::written;
use crate::lie::Lie;
use crate::picture::{Counts, Picture};
use crate::posts::Posts;
use crate::real::Real;
use crate::reference::{Grey, Reference};
use crate::screen::{Corners, Shape, depth, shape};
use crate::view::Camera;
use crate::{Fill, FillWork, Filler, ProgramError, Restrictions, View, limits};

/// How the program runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Findings that are turned on.
    pub restrictions: Restrictions,
    /// How panels are filled.
    pub fill: Fill,
    /// Light of panels beside the photograph.
    pub outside: f64,
}

/// A panel with its grey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panel {
    /// Numbers of its posts.
    pub posts: [usize; 3],
    /// Grey of the whole panel.
    pub grey: Grey,
    /// Whether one of its posts was void.
    pub touches_void: bool,
}

/// Posts with their panels, ready to be seen from anywhere.
#[derive(Debug, Clone)]
pub struct Program {
    settings: Settings,
    lie: Lie,
    size: [usize; 2],
    /// Places of the posts (m), georectangular.
    points: Vec<DVec3>,
    panels: Vec<Panel>,
}

impl Program {
    /// Lays `photograph` over `posts`, which lie as `lie` says.
    ///
    /// # Errors
    /// If the photograph stands in other axes, voids cannot be filled, the fill is not the listing's where both ends of a span are asked for, or the
    /// listing has no room for it.
    pub fn new(
        posts: &Posts,
        lie: Lie,
        photograph: &Photograph,
        settings: Settings,
    ) -> Result<Self, ProgramError> {
        let restrictions = settings.restrictions;
        if restrictions.both_ends && settings.fill != Fill::EdgeBuffer {
            return Err(ProgramError::WrittenFill);
        }
        if restrictions.limits {
            limits::check(posts, photograph)?;
        }
        let real = Real::new(restrictions.real4);
        let (places, was_void) = posts.filled(restrictions)?;
        let points: Vec<DVec3> = places.iter().map(|place| lie.point(*place, real)).collect();
        let reference = Reference::new(photograph, &lie, real)?;
        if restrictions.limits {
            limits::check_frame(&reference, &points)?;
        }
        let grey = |(number, corners): (usize, [usize; 3])| {
            let cell = cell_of(number, posts.size).map(|post| reference.pixel(points[post]));
            let grey = reference.grey(cell, number % 2 == 0, settings.outside, restrictions);
            Panel { posts: corners, grey, touches_void: corners.iter().any(|post| was_void[*post]) }
        };
        let panels = posts.panels().enumerate().map(grey).collect();
        Ok(Self { settings, lie, size: posts.size, points, panels })
    }

    /// Its panels, two a cell, cells in the order of their south-western posts.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// Places of the posts on the screen (column, row; pixels, not cut to whole numbers) with their distances from the eye (m).
    pub fn posts_on_screen(&self, view: &View) -> Vec<([f64; 2], f64)> {
        let camera = self.camera(view);
        let place =
            |point: &DVec3| (camera.projection.project(camera.place(*point)), camera.distance(*point));
        self.points.iter().map(place).collect()
    }

    /// The picture of a view.
    ///
    /// # Errors
    /// If the listing has no room for the screen.
    pub fn draw(&self, view: &View) -> Result<Picture, ProgramError> {
        if self.settings.restrictions.limits {
            limits::check_view(view)?;
        }
        let size = view.size.map(|side| side as usize);
        let Ok(screen) = Screen::new(view.size, LARGEST_SIDE) else {
            let [found, most] = [size[0].max(size[1]), raster::LARGEST_RASTER as usize];
            return Err(ProgramError::Limit { what: "pixels along a side of the screen", found, most });
        };
        let mut frame = Frame {
            program: self,
            camera: self.camera(view),
            screen,
            filler: Filler::new(self.settings.fill, size),
            written: FillWork::default(),
            buffer: DepthBuffer::new(size[0] * size[1], self.settings.restrictions.linear_depth),
            picture: Picture::new(size[0] * size[1]),
        };
        // The listing clears picture and depth buffer.
        frame.written.cleared += 2 * (size[0] * size[1]) as u64;
        (0..self.panels.len()).for_each(|number| frame.panel(number));
        Ok(frame.finish())
    }

    fn camera(&self, view: &View) -> Camera {
        let ends = [self.points[0], self.points[(self.size[0] - 1) * self.size[1]]];
        Camera::new(view, &self.lie, ends, self.settings.restrictions)
    }
}

/// Posts of the cell of a panel: south-west, south-east, north-west, north-east.
fn cell_of(panel: usize, [_, columns]: [usize; 2]) -> [usize; 4] {
    let cell = panel / 2;
    let sw = cell / (columns - 1) * columns + cell % (columns - 1);
    [sw, sw + 1, sw + columns, sw + columns + 1]
}

/// A picture in the making.
struct Frame<'a> {
    program: &'a Program,
    camera: Camera,
    screen: Screen,
    filler: Filler,
    /// Cost of the fill of the listing.
    written: FillWork,
    buffer: DepthBuffer,
    picture: Picture,
}

impl Frame<'_> {
    fn panel(&mut self, number: usize) {
        let restrictions = self.program.settings.restrictions;
        let points = self.program.panels[number].posts.map(|post| self.program.points[post]);
        let real = Real::new(restrictions.real4);
        let corners = Corners {
            places: points.map(|point| self.camera.place(point)),
            distances: points.map(|point| real.of(self.camera.distance(point))),
        };
        let shape = shape(&corners, &self.camera, &self.screen, restrictions);
        let depth = depth(&corners, &self.camera, restrictions);
        let counts = &mut self.picture.counts;
        match (shape, depth) {
            (Shape::Discarded, _) => counts.discarded += 1,
            (Shape::Unseen, _) => counts.unseen += 1,
            (_, Err(NoDepth::EdgeOn)) => counts.edge_on += 1,
            (_, Err(NoDepth::Determinant)) => counts.lost += 1,
            (Shape::Whole(all), Ok(depth)) => {
                counts.filled += 1;
                all.into_iter().for_each(|corners| self.whole(number, corners, &depth));
            }
            (Shape::Fine(fan), Ok(depth)) => {
                counts.filled += 1;
                let columns = self.screen.size()[0] as usize;
                let (picture, buffer) = (&mut self.picture, &mut self.buffer);
                let light = self.program.panels[number].grey.light as f32;
                for corners in fan {
                    self.filler.fill(corners, |column, row| {
                        let value = depth.at([column, row].map(|at| at as f64 + 0.5));
                        write(picture, buffer, row * columns + column, value, (number, light));
                    });
                }
            }
        }
    }

    /// Fills whole-number corners as the listing does. Column and row 1 are the first of the screen.
    fn whole(&mut self, number: usize, corners: [[i64; 2]; 3], depth: &DepthPlane) {
        let restrictions = self.program.settings.restrictions;
        let [columns, lines] = self.screen.size().map(|side| side as usize);
        let light = self.program.panels[number].grey.light as f32;
        let (picture, buffer) = (&mut self.picture, &mut self.buffer);
        // A depth that is exact on the ground belongs to the middle of a pixel, that of the listing to its number.
        let middle = if matches!(depth, DepthPlane::Written { .. }) { 0.0 } else { 0.5 };
        let real = Real::new(restrictions.real4);
        written::fill(corners, lines, real, &mut self.written, |column, row| {
            let value = real.of(depth.at([column, row].map(|at| at as f64 + middle)));
            let pixel = (row - 1) as usize * columns + (column - 1) as usize;
            write(picture, buffer, pixel, value, (number, light));
        });
    }

    fn finish(mut self) -> Picture {
        let columns = self.screen.size()[0] as usize;
        for pixel in 0..self.picture.panel.len() {
            if self.picture.writes[pixel] > 0 {
                let value = self.buffer.value(pixel);
                let place = [pixel % columns, pixel / columns].map(|at| at as f64 + 0.5);
                let distance = match self.program.settings.restrictions.linear_depth {
                    true => value,
                    false => self.camera.stretch(place) / value,
                };
                self.picture.distance[pixel] = distance as f32;
            }
        }
        self.picture.work = match self.program.settings.restrictions.both_ends {
            true => self.written,
            false => self.filler.work,
        };
        self.picture
    }
}

/// Writes a panel (its number and light) into a pixel, if it is the nearest there.
fn write(
    picture: &mut Picture,
    buffer: &mut DepthBuffer,
    pixel: usize,
    value: f64,
    (number, light): (usize, f32),
) {
    if buffer.keep(pixel, value) {
        picture.light[pixel] = light;
        picture.panel[pixel] = number as u32;
        picture.writes[pixel] = picture.writes[pixel].saturating_add(1);
    }
}

impl Counts {
    /// All panels of the frame.
    pub fn panels(&self) -> u64 {
        self.filled + self.discarded + self.unseen + self.edge_on + self.lost
    }
}
