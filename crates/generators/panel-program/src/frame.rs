//! A picture in the making: panel by panel onto a canvas.

use raster::Screen;

use crate::blend::blend;
use crate::canvas::{Canvas, Look};
use crate::depth::{DepthBuffer, DepthPlane, NoDepth};
use crate::fill::written;
use crate::picture::Picture;
use crate::real::Real;
use crate::screen::{Corners, Shape, depth, shape};
use crate::view::Camera;
use crate::work::{FillPieces, Work};
use crate::{Filler, Program};

/// A picture in the making.
pub(crate) struct Frame<'a> {
    program: &'a Program,
    camera: Camera,
    screen: Screen,
    filler: Filler,
    /// What the routine FILL of the listing does.
    pieces: FillPieces,
    canvas: Canvas,
}

impl<'a> Frame<'a> {
    /// An empty picture. The panels at the pixel `watched` will be listed.
    pub fn new(program: &'a Program, camera: Camera, screen: Screen, watched: Option<usize>) -> Self {
        let size = screen.size().map(|side| side as usize);
        let (pixels, settings) = (size[0] * size[1], &program.settings);
        Self {
            program,
            camera,
            screen,
            filler: Filler::new(settings.fill, size),
            pieces: FillPieces {
                // The listing clears picture and depth buffer.
                cells: 2 * pixels as u64,
                panels: program.panels.len() as u64,
                records: size[1] as u64,
                ..FillPieces::default()
            },
            canvas: Canvas {
                picture: Picture::new(pixels),
                buffer: DepthBuffer::new(pixels, settings.restrictions.linear_depth),
                writes: 0,
                watched,
                looks: Vec::new(),
            },
        }
    }

    /// Draws the panel of a number.
    pub fn panel(&mut self, number: usize) {
        let restrictions = self.program.settings.restrictions;
        let panel = &self.program.panels[number];
        let points = panel.posts.map(|post| self.program.points[post]);
        let real = Real::new(restrictions.real4);
        let corners = Corners {
            places: points.map(|point| self.camera.place(point)),
            distances: points.map(|point| real.of(self.camera.distance(point))),
        };
        let shape = shape(&corners, &self.camera, &self.screen, restrictions);
        let depth = depth(&corners, &self.camera, restrictions);
        let counts = &mut self.canvas.picture.counts;
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
                let (canvas, light) = (&mut self.canvas, panel.grey.light as f32);
                for corners in fan {
                    self.filler.fill(corners, |column, row| {
                        let value = depth.at([column, row].map(|at| at as f64 + 0.5));
                        canvas.write(row * columns + column, value, (number, light));
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
        let canvas = &mut self.canvas;
        // A depth that is exact on the ground belongs to the middle of a pixel, that of the listing to its number.
        let middle = if matches!(depth, DepthPlane::Written { .. }) { 0.0 } else { 0.5 };
        let real = Real::new(restrictions.real4);
        written::fill(corners, lines, real, &mut self.pieces.written, |column, row| {
            let value = real.of(depth.at([column, row].map(|at| at as f64 + middle)));
            let pixel = (row - 1) as usize * columns + (column - 1) as usize;
            canvas.write(pixel, value, (number, light));
        });
    }

    /// The picture, and the looks of the panels at the pixel that is watched.
    pub fn finish(self) -> (Picture, Vec<Look>) {
        let Self { program, camera, screen, filler, pieces, canvas } = self;
        let Canvas { mut picture, buffer, writes, watched, mut looks } = canvas;
        let columns = screen.size()[0] as usize;
        let distance = |pixel: usize, value: f64| {
            let place = [pixel % columns, pixel / columns].map(|at| at as f64 + 0.5);
            match program.settings.restrictions.linear_depth {
                true => value,
                false => camera.stretch(place) / value,
            }
        };
        for pixel in 0..picture.panel.len() {
            if picture.writes[pixel] > 0 {
                picture.distance[pixel] = distance(pixel, buffer.value(pixel)) as f32;
            }
        }
        for (look, pixel) in looks.iter_mut().zip(watched.into_iter().cycle()) {
            look.distance = distance(pixel, look.distance);
        }
        let pieces = FillPieces { pixels: writes, ..pieces };
        if program.settings.blends_borders {
            blend(&mut picture, &program.panels, columns);
        }
        picture.work = match program.settings.restrictions.both_ends {
            true => pieces.written.as_fill_work(pieces.cells),
            false => filler.work,
        };
        let posts = program.points.len() as u64;
        picture.listing =
            Work { affine: 1, projected: posts, measured: posts, fill: pieces, ..program.before_pictures };
        (picture, looks)
    }
}
