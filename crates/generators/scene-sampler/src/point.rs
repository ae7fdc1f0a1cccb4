//! One sampling point with everything that it holds, as a document.

use light_points::{Accumulation, mask_under};
use raster::{Coverage, Lists, SubArea};
use serde_json::{Value, json};
use translucency::{Feature, Layer, Loss, Stack};

use crate::parameters::Parameters;
use crate::scene::Scene;
use crate::tile::{SIDE, pixels};

/// A sampling point of a sub-area whose stacks are filled.
pub struct SamplingPoint<'a> {
    pub scene: &'a Scene,
    pub run: &'a Parameters,
    pub lists: &'a Lists,
    /// Triangles that found no place in the list.
    pub lost: &'a [u32],
    pub stack: &'a Stack,
    /// Number of the sub-area.
    pub sub_area: usize,
    /// Pixels of the sub-area.
    pub area: SubArea,
    /// Column and line of the pixel.
    pub pixel: [usize; 2],
    /// Number of the sampling point within it.
    pub number: usize,
}

impl SamplingPoint<'_> {
    /// Its list, stack with weights, colour, losses, and the veil of calligraphic points before it.
    pub fn document(&self) -> Value {
        let sample = self.pixel_of_area() * self.stack.samples() + self.number;
        let rest = self.stack.layers(sample).last().map_or(1.0, |layer| layer.rest());
        json!({
            "place_px": self.place(),
            "sub_area": self.sub_area,
            "list": self.entries(),
            "lost_entries": self.lost.iter().map(|lost| self.triangle(*lost)).collect::<Vec<_>>(),
            "stack": self.stack.layers(sample).map(|layer| self.layer(&layer)).collect::<Vec<_>>(),
            "rest": rest,
            "colour": self.stack.colour_at(sample),
            "loss": self.stack.loss_at(sample).map(|loss| self.loss(&loss)),
            "beam": self.beam(sample),
        })
    }

    fn pixel_of_area(&self) -> usize {
        self.pixel[1] % SIDE * SIDE + self.pixel[0] % SIDE
    }

    /// Where it lies on the screen (pixels).
    fn place(&self) -> [f64; 2] {
        let at = self.pixel.map(|pixel| pixel as i32);
        self.run.sampling().places(at).nth(self.number).unwrap_or_default()
    }

    /// Features that the sub-area lists, and whether they cover the point.
    fn entries(&self) -> Vec<Value> {
        let sampling = self.run.sampling();
        let (pixel, mut coverage) = (self.pixel_of_area(), Coverage::default());
        let faces = self.lists.of(self.sub_area).iter().map(|&face| {
            coverage.find(&self.scene.faces.triangles[face as usize], &self.area, &sampling);
            let mask = coverage.pixels().find(|(covered, _)| *covered == pixel).map_or(0, |(_, mask)| mask);
            with_cover(self.triangle(face), mask, self.number)
        });
        let lights = self.scene.lights.of(self.sub_area).iter().map(|&at| {
            let point = &self.scene.lights.points[at as usize];
            let drawn_by = if point.is_calligraphic { "beam" } else { "raster" };
            let entry =
                json!({ "light": point.light, "drawn_by": drawn_by, "diameter_px": point.disc.diameter });
            with_cover(entry, self.mask(at), self.number)
        });
        faces.chain(lights).collect()
    }

    /// Sampling points of the pixel under a light's disc.
    fn mask(&self, light: u32) -> u32 {
        let point = &self.scene.lights.points[light as usize];
        let mut all = pixels(&self.area).filter(|(pixel, _)| *pixel == self.pixel_of_area());
        let at = all.next().map_or([0, 0], |(_, at)| at);
        mask_under(point.middle, point.disc.diameter, at, &self.run.sampling())
    }

    fn triangle(&self, face: u32) -> Value {
        json!({ "triangle": face })
    }

    fn named(&self, feature: &Feature) -> Value {
        json!({ "feature": feature.id(), "label": self.scene.faces.labels[feature.id() as usize].name() })
    }

    fn layer(&self, layer: &Layer<'_>) -> Value {
        let mut told = self.named(layer.feature);
        // What is fixed to the eye has no depth, and stars have none either.
        let depth = (layer.q > 0.0 && layer.q.is_finite()).then(|| 1.0 / layer.q);
        told["depth_m"] = json!(depth);
        told["translucency"] = json!(layer.feature.translucency());
        told["weight"] = json!(layer.weight());
        told["light"] = json!(layer.light());
        told
    }

    fn loss(&self, loss: &Loss<'_>) -> Value {
        let nearest = loss.nearest.iter().flatten().map(|(feature, _)| self.named(feature));
        json!({ "nearest": nearest.collect::<Vec<_>>(), "bound": loss.bound })
    }

    /// Calligraphic points that cover the point, near to far: what stack and veil leave of each.
    fn beam(&self, sample: usize) -> Vec<Value> {
        let mut veil = 1.0;
        let mut told = Vec::new();
        for &at in self.scene.lights.of(self.sub_area) {
            let point = &self.scene.lights.points[at as usize];
            if !point.is_calligraphic || self.mask(at) >> self.number & 1 == 0 {
                continue;
            }
            let through = self.stack.through(sample, point.q, &point.feature);
            told.push(
                json!({ "light": point.light, "stack": through, "veil": veil, "share": through * veil }),
            );
            if self.run.veil == Accumulation::Points {
                veil *= point.feature.translucency();
            }
        }
        told
    }
}

fn with_cover(mut entry: Value, mask: u32, number: usize) -> Value {
    entry["covers"] = json!(mask >> number & 1 == 1);
    entry
}
