//! The program: greys of panels once, then a picture for every eye.

use glam::DVec3;
use photograph::Photograph;
use raster::{LARGEST_SIDE, Screen};

use crate::canvas::Look;
use crate::frame::Frame;
use crate::lie::Lie;
use crate::picture::Picture;
use crate::posts::Posts;
use crate::real::Real;
use crate::reference::{Grey, Reference};
use crate::view::Camera;
use crate::{Fill, ProgramError, Restrictions, View, Work, limits};

/// How the program runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Findings that are turned on.
    pub restrictions: Restrictions,
    /// How panels are filled.
    pub fill: Fill,
    /// Light of panels beside the photograph.
    pub outside: f64,
    /// Whether a panel that touches a void has that light too, in place of its grey.
    pub marks_voids: bool,
    /// Whether pixels on both sides of a border of panels have their mean.
    pub blends_borders: bool,
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
    pub(crate) settings: Settings,
    lie: Lie,
    size: [usize; 2],
    /// Places of the posts (m), georectangular.
    pub(crate) points: Vec<DVec3>,
    pub(crate) panels: Vec<Panel>,
    /// What its routines have done before any picture.
    pub(crate) before_pictures: Work,
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
            let mut grey = reference.grey(cell, number % 2 == 0, settings.outside, restrictions);
            let touches_void = corners.iter().any(|post| was_void[*post]);
            if touches_void && settings.marks_voids {
                grey.light = settings.outside;
            }
            Panel { posts: corners, grey, touches_void }
        };
        let panels: Vec<Panel> = posts.panels().enumerate().map(grey).collect();
        let picture = photograph.picture();
        let before_pictures = Work {
            averaged: panels.iter().map(|panel| u64::from(panel.grey.pixels)).sum(),
            panels: panels.len() as u64,
            ..Work::before_pictures(posts.size, picture.columns() * picture.lines())
        };
        Ok(Self { settings, lie, size: posts.size, points, panels, before_pictures })
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
        Ok(self.drawn(view, None)?.0)
    }

    /// The panels that the program finds at pixel `pixel` (column, line) of a view, in their order.
    ///
    /// # Errors
    /// If the listing has no room for the screen.
    pub fn looks(&self, view: &View, [column, line]: [usize; 2]) -> Result<Vec<Look>, ProgramError> {
        Ok(self.drawn(view, Some(line * view.size[0] as usize + column))?.1)
    }

    /// The picture of a view, with the looks of the panels at the pixel `watched`.
    fn drawn(&self, view: &View, watched: Option<usize>) -> Result<(Picture, Vec<Look>), ProgramError> {
        if self.settings.restrictions.limits {
            limits::check_view(view)?;
        }
        let size = view.size.map(|side| side as usize);
        let Ok(screen) = Screen::new(view.size, LARGEST_SIDE) else {
            let [found, most] = [size[0].max(size[1]), raster::LARGEST_RASTER as usize];
            return Err(ProgramError::Limit { what: "pixels along a side of the screen", found, most });
        };
        let mut frame = Frame::new(self, self.camera(view), screen, watched);
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
