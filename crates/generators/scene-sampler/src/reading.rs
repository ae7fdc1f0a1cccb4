//! What a sub-area took, and what can be looked at of it.

use raster::{Lists, SubArea};
use translucency::Stack;

use crate::scene::Scene;
use crate::tile::{SIDE, pixels};

/// Counts of one sub-area after its features were drawn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// Triangles of its list.
    pub triangles: u32,
    /// Light points of the raster whose discs meet it.
    pub raster_points: u32,
    /// Calligraphic points whose discs meet it.
    pub calligraphic: u32,
    /// Pixels of it, 1 to 64.
    pub pixels: u32,
    /// Most features that one of its sampling points holds, the opaque one with them.
    pub depth: u32,
    /// Largest share of light (0 to 1) that all features of a sampling point let through.
    pub rest: f64,
    /// How near the opaque surface of its middle pixel is (1/m); 0 for sky.
    pub q: f64,
    /// Losses of its sampling points, each of surfaces and of lights.
    pub lost: u32,
    /// Pixels with a sampling point that lost something, as bits: 8 times the row in the sub-area plus the column in it.
    pub lost_in: u64,
}

impl Reading {
    /// Counts what is listed for the sub-area of a number; nothing is known of its sampling points.
    pub fn counted(scene: &Scene, lists: &Lists, area: &SubArea, number: usize) -> Self {
        let lights = scene.lights.of(number);
        let is_drawn_by_beam = |point: &&u32| scene.lights.points[**point as usize].is_calligraphic;
        let calligraphic = lights.iter().filter(is_drawn_by_beam).count();
        Self {
            triangles: lists.of(number).len() as u32,
            raster_points: (lights.len() - calligraphic) as u32,
            calligraphic: calligraphic as u32,
            pixels: (area.columns().len() * area.rows().len()) as u32,
            ..Self::default()
        }
    }

    /// The same with what is read off its stacks.
    pub fn of(stack: &Stack, scene: &Scene, lists: &Lists, area: &SubArea, number: usize) -> Self {
        let (mut depth, mut rest) = (0, 0.0);
        for (pixel, _) in pixels(area) {
            for sample in pixel * stack.samples()..(pixel + 1) * stack.samples() {
                let of_sample =
                    stack.layers(sample).fold((0, 1.0), |(count, _), layer| (count + 1, layer.rest()));
                (depth, rest) = (of_sample.0.max(depth), of_sample.1.max(rest));
            }
        }
        let middle = SIDE * (area.rows().len() / 2) + area.columns().len() / 2;
        let losses = stack.losses();
        Self {
            depth,
            rest,
            q: stack.surface(middle).map_or(0.0, |(_, q)| q),
            lost: u32::try_from(losses.translucent + losses.lights).unwrap_or(u32::MAX),
            lost_in: pixels(area)
                .filter(|(pixel, _)| has_lost(stack, *pixel))
                .fold(0, |bits, (pixel, _)| bits | 1 << pixel),
            ..Self::counted(scene, lists, area, number)
        }
    }

    /// Entries of its list: triangles and raster points.
    pub fn entries(&self) -> u64 {
        u64::from(self.triangles) + u64::from(self.raster_points)
    }

    /// Light points whose discs meet it, calligraphic or not.
    pub fn lights(&self) -> u32 {
        self.raster_points + self.calligraphic
    }
}

/// Whether a sampling point of a pixel lost something to the limits.
fn has_lost(stack: &Stack, pixel: usize) -> bool {
    let samples = pixel * stack.samples()..(pixel + 1) * stack.samples();
    samples.into_iter().any(|sample| stack.loss_at(sample).is_some())
}
