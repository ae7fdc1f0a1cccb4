//! The photograph as the program reads it: pixels of posts, greys of panels.

use glam::DVec3;
use photo_camera::{Affine, Axes, Camera, Ellipsoid};
use photograph::{Photograph, Placement};
use picture::Depth;

use crate::lie::Lie;
use crate::real::Real;
use crate::{ProgramError, Restrictions};

/// Micrometres in a metre.
const MICROMETRES: f64 = 1e6;

/// A photograph in georectangular axes.
pub(crate) struct Reference<'a> {
    photograph: &'a Photograph,
    /// Axes x, y, z of the image, georectangular.
    axes: [DVec3; 3],
    /// Perspective centre (m), georectangular.
    centre: DVec3,
    /// Focal length and principal point (m).
    focal_length: f64,
    principal_point: [f64; 2],
    affine: Affine,
}

/// The grey of a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grey {
    /// Light of the panel, 0 or more.
    pub light: f64,
    /// Number of pixels in its mean; 0 for a look at its middle, or beside the photograph.
    pub pixels: u32,
    /// Pixel I, J of the photograph in the middle of the panel: the mean of its corners'.
    pub source: [f64; 2],
}

impl<'a> Reference<'a> {
    /// The camera of `photograph` over posts that lie as `lie` says.
    ///
    /// # Errors
    /// If the photograph is a map, or its camera stands in other axes.
    pub fn new(photograph: &'a Photograph, lie: &Lie, real: Real) -> Result<Self, ProgramError> {
        let expected = lie.axes();
        let Placement::Camera { camera, axes } = photograph.placement() else {
            return Err(ProgramError::Axes { found: "no camera: it is a map", expected: word(&expected) });
        };
        if *axes != expected {
            return Err(ProgramError::Axes { found: word(axes), expected: word(&expected) });
        }
        Ok(Self::of_camera(photograph, camera, axes, real))
    }

    fn of_camera(photograph: &'a Photograph, camera: &Camera, axes: &Axes, real: Real) -> Self {
        let turned = |vector: DVec3| match axes {
            Axes::Body(_) => vector,
            Axes::Landscape => Lie::from_plane(vector.x, vector.y, vector.z),
        };
        let middle = match axes {
            Axes::Body(_) => DVec3::ZERO,
            Axes::Landscape => DVec3::X * Ellipsoid::MOON.semi_major(),
        };
        Self {
            photograph,
            axes: camera.orientation().axes().map(|axis| real.vector(turned(axis))),
            centre: real.vector(middle + turned(camera.centre())),
            focal_length: camera.focal_length(),
            principal_point: camera.principal_point(),
            affine: camera.affine(),
        }
    }

    /// Pixel I, J of a georectangular point (m). The listing does not ask whether the point is before the camera.
    pub fn pixel(&self, point: DVec3) -> [f64; 2] {
        let from = point - self.centre;
        let [x, y, z] = self.axes.map(|axis| axis.dot(from));
        let [x0, y0] = self.principal_point;
        let at = |zero: f64, across: f64| MICROMETRES * (zero - self.focal_length * across / z);
        self.affine.pixel([at(x0, x), at(y0, y)])
    }

    /// Whether a pixel I, J lies in the photograph.
    pub fn holds(&self, pixel: [f64; 2]) -> bool {
        self.photograph.holds(pixel)
    }

    /// Grey of the panel whose corners have these pixels. `is_first` says that it has the south-western post of its cell, whose four posts have
    /// the pixels `cell`: south-west, south-east, north-west, north-east. `outside` is the light beside the photograph.
    pub fn grey(
        &self,
        cell: [[f64; 2]; 4],
        is_first: bool,
        outside: f64,
        restrictions: Restrictions,
    ) -> Grey {
        let [sw, se, nw, ne] = cell;
        let corners = if is_first { [sw, se, nw] } else { [se, ne, nw] };
        let mut mean = Mean::new(self.photograph, restrictions.signed_bytes);
        match restrictions.box_average {
            true => self.each_of_box(cell, is_first, |column, line| mean.add(column, line)),
            false => {
                let picture = self.photograph.picture();
                let size = [picture.columns(), picture.lines()];
                photo_drape::triangle_pixels(corners, size, |column, line| mean.add(column, line));
            }
        }
        let source = [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / 3.0);
        let look = || self.photograph.light(source).unwrap_or(outside);
        Grey { light: mean.light().unwrap_or_else(look), pixels: mean.count, source }
    }

    /// Calls `each` for the pixels of half a box: columns from the south-eastern to the south-western post, lines from the south-eastern to the
    /// north-western one, cut along the line between these two (IM_REFAVG). The listing counts upward alone; here the ends are put in order.
    fn each_of_box(
        &self,
        [sw, se, nw, _]: [[f64; 2]; 4],
        is_first: bool,
        mut each: impl FnMut(usize, usize),
    ) {
        let [a, b, c] = [sw, se, nw].map(|pixel| pixel.map(f64::trunc));
        let slope = if c[0] == b[0] { 0.0 } else { (c[1] - b[1]) / (c[0] - b[0]) };
        let picture = self.photograph.picture();
        let within = |at: f64, count: usize| (0.0..count as f64).contains(&at).then_some(at as usize);
        let [low, high] = [a[0].min(b[0]), a[0].max(b[0])];
        let up = c[1] >= b[1];
        let mut column = low;
        while column <= high {
            let cut = (slope * (column - b[0]) + b[1]).trunc();
            // The second half leaves out the column of the south-western post.
            let (from, to) = match (is_first, up) {
                (true, true) => (b[1], cut),
                (true, false) => (cut, b[1]),
                (false, true) => (cut + 1.0, c[1]),
                (false, false) => (c[1], cut - 1.0),
            };
            let mut line = from;
            while line <= to && (is_first || column != a[0]) {
                if let (Some(x), Some(y)) = (within(column, picture.columns()), within(line, picture.lines()))
                {
                    each(x, y);
                }
                line += 1.0;
            }
            column += 1.0;
        }
    }
}

/// A running mean of pixels.
struct Mean<'a> {
    photograph: &'a Photograph,
    is_signed: bool,
    sum: f64,
    count: u32,
}

impl<'a> Mean<'a> {
    fn new(photograph: &'a Photograph, is_signed: bool) -> Self {
        Self { photograph, is_signed, sum: 0.0, count: 0 }
    }

    fn add(&mut self, column: usize, line: usize) {
        self.count += 1;
        self.sum += match self.is_signed {
            true => f64::from(self.byte(column, line) as i8),
            false => self.photograph.light_of(column, line),
        };
    }

    /// The code of a pixel in 8 bits.
    fn byte(&self, column: usize, line: usize) -> u8 {
        let picture = self.photograph.picture();
        let code = picture.code(column, line);
        if picture.depth() == Depth::Sixteen { (code >> 8) as u8 } else { code as u8 }
    }

    fn light(&self) -> Option<f64> {
        let mean = (self.count > 0).then(|| self.sum / f64::from(self.count))?;
        Some(match self.is_signed {
            // The screen shows the bits of the byte as 0 to 255.
            true => {
                let code = mean.trunc() as i8 as u8;
                f64::from(self.photograph.transfer().intensity(u16::from(code), Depth::Eight))
            }
            false => mean,
        })
    }
}

fn word(axes: &Axes) -> &'static str {
    match axes {
        Axes::Body(_) => "the axes of a body",
        Axes::Landscape => "the axes of a landscape",
    }
}
