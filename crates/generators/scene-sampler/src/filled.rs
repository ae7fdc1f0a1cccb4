//! The sub-area of a pixel with its stacks filled: for whoever looks inside.

use generator::Fact;
use raster::{Lists, Screen};
use serde_json::Value;
use translucency::{FeatureError, Layer};

use crate::parameters::Parameters;
use crate::point::SamplingPoint;
use crate::scene::Scene;
use crate::tile::{SIDE, Sampler};

/// A sub-area whose features lie in its stacks.
pub struct Filled<'a> {
    scene: &'a Scene,
    lists: &'a Lists,
    run: Parameters,
    screen: Screen,
    sampler: Sampler,
    pixel: [usize; 2],
    number: usize,
}

impl<'a> Filled<'a> {
    /// Fills the stacks of the sub-area that holds `pixel` (column and line).
    ///
    /// # Errors
    /// If a light is no number.
    pub fn new(
        scene: &'a Scene,
        lists: &'a Lists,
        screen: &Screen,
        run: &Parameters,
        pixel: [usize; 2],
    ) -> Result<Self, FeatureError> {
        let number = (pixel[1] / SIDE) * screen.counts()[0] as usize + pixel[0] / SIDE;
        let mut sampler = Sampler::new(run)?;
        sampler.fill(scene, lists, &screen.sub_area(number), number)?;
        Ok(Self { scene, lists, run: *run, screen: *screen, sampler, pixel, number })
    }

    /// Number of the sub-area.
    pub fn number(&self) -> usize {
        self.number
    }

    /// Features that the sub-area lists: triangles and light points.
    pub fn entries(&self) -> usize {
        self.lists.of(self.number).len() + self.scene.lights.of(self.number).len()
    }

    /// How near the opaque surface of the pixel is (1/m); `None` for sky.
    pub fn nearness(&self) -> Option<f64> {
        let pixel = self.pixel[1] % SIDE * SIDE + self.pixel[0] % SIDE;
        self.sampler.stack().surface(pixel).map(|(_, q)| q)
    }

    /// The stack of every sampling point of the pixel in words, near to far.
    pub fn facts(&self) -> Vec<Fact> {
        let stack = self.sampler.stack();
        let first = (self.pixel[1] % SIDE * SIDE + self.pixel[0] % SIDE) * stack.samples();
        let fact = |point: usize| {
            Fact::new("sampling point", format!("{point}: {}", told(self.scene, stack, first + point)))
        };
        (0..stack.samples()).map(fact).collect()
    }

    /// Everything that sampling point `number` of the pixel holds, as a document; `None` if there is no such point. `lost` are the
    /// triangles that found no place in the list of the sub-area.
    pub fn document(&self, number: usize, lost: &[u32]) -> Option<Value> {
        let stack = self.sampler.stack();
        let point = SamplingPoint {
            scene: self.scene,
            run: &self.run,
            lists: self.lists,
            lost,
            stack,
            sub_area: self.number,
            area: self.screen.sub_area(self.number),
            pixel: self.pixel,
            number,
        };
        (number < stack.samples()).then(|| point.document())
    }
}

/// The stack of a sampling point in words, near to far.
fn told(scene: &Scene, stack: &translucency::Stack, sample: usize) -> String {
    let layer = |layer: Layer<'_>| {
        let label = scene.faces.labels[layer.feature.id() as usize].name();
        let at = if layer.q > 0.0 && layer.q.is_finite() {
            format!(" at {:.3} m", 1.0 / layer.q)
        } else {
            String::new()
        };
        format!("{label}{at}, weight {:.4}", layer.weight())
    };
    let mut words: Vec<String> = stack.layers(sample).map(layer).collect();
    if let Some(loss) = stack.loss_at(sample) {
        words.push(format!("lost to the limits: at most {:.4} of light", loss.bound[1]));
    }
    let [red, green, blue] = stack.colour_at(sample);
    words.push(format!("red {red:.4}, green {green:.4}, blue {blue:.4}"));
    words.join("; ")
}
