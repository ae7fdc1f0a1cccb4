//! The generator and its sessions.

use generator::{
    Counter, Fact, FrameCounts, FrameError, Generator, Joined, Omission, PlaneKind, Planes, PrepareError,
    Session as GeneratorSession, Stage, Weight, check_eye,
};
use raster::{Lists, Screen};
use scenario::Pose;
use serde_json::{Value, json};
use signal::Probe;

use crate::parameters::Parameters;
use crate::picture::{self, PLANES};
use crate::row::NAME;
use crate::scene::Scene;
use crate::tile::{SIDE, Sampler};

/// The sampled generator; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampled {
    /// Run parameters that decide its pictures.
    pub parameters: Parameters,
}

const fn counter(name: &'static str) -> Counter {
    Counter { name, joined: Joined::Sum }
}

/// What a frame took and lost.
const COUNTERS: [Counter; 8] = [
    counter("faces"),
    counter("triangles"),
    counter("entries"),
    counter("lights"),
    counter("calligraphic"),
    counter("lost_surfaces"),
    counter("lost_lights"),
    counter("beam_dropped"),
];

impl Generator for Sampled {
    fn name(&self) -> &'static str {
        NAME
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        PLANES
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful()
    }

    fn record(&self) -> Value {
        let run = &self.parameters;
        json!({
            "pattern": run.pattern.name(),
            "rotate": run.rotate,
            "filter": format!("{:?}", run.filter).to_lowercase(),
            "translucent": run.translucent,
            "lights": run.lights,
            "shared_stack": run.shared_stack,
            "least_diameter_px": run.least_diameter,
            "normalise": run.normalise,
            "blending": format!("{:?}", run.blending).to_lowercase(),
            "veil": format!("{:?}", run.veil).to_lowercase(),
            "spot_px": run.spot,
            "ground_half_side_m": run.ground_half_side,
            "ground_cells": run.ground_cells,
        })
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.parameters)?))
    }
}

/// The generator made ready for one stage.
struct Session {
    stage: Stage,
    screen: Screen,
    parameters: Parameters,
}

impl Session {
    fn new(stage: Stage, parameters: Parameters) -> Result<Self, PrepareError> {
        let size = [stage.view.columns, stage.view.lines];
        let screen = Screen::new(size, SIDE as u32).map_err(|error| PrepareError::Unsupported {
            generator: NAME,
            what: error.to_string(),
            remedy: "ask for a smaller raster".into(),
        })?;
        Ok(Self { stage, screen, parameters })
    }

    fn scene(&self, frame: u64, pose: &Pose) -> Result<Scene, FrameError> {
        self.check(frame, pose)?;
        Scene::new(&self.stage, &self.parameters, &self.screen, frame, pose)
    }
}

impl GeneratorSession for Session {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        _probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let scene = self.scene(frame, pose)?;
        let picture = picture::draw(&scene, &self.screen, &self.parameters, &self.stage.view, frame)?;
        picture::fill(&picture, &scene, planes);
        let calligraphic = scene.lights.points.iter().filter(|point| point.is_calligraphic).count() as u64;
        Ok(FrameCounts::of([
            ("faces", scene.faces.work.faces),
            ("triangles", scene.faces.work.triangles),
            ("entries", picture.entries),
            ("lights", scene.lights.points.len() as u64),
            ("calligraphic", calligraphic),
            ("lost_surfaces", picture.losses.translucent),
            ("lost_lights", picture.losses.lights),
            ("beam_dropped", picture.dropped.len() as u64),
        ]))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let Stage { landscape, scenery, view } = &self.stage;
        let lacks = [
            (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
            (landscape.texture().is_some(), "texture"),
            (!landscape.silhouettes().is_empty(), "far silhouettes"),
            (view.shadows.is_some(), "remote shadow"),
        ];
        let omission = |what: &str| Omission {
            block: NAME,
            what: what.into(),
            why: "it draws faces, sheets and lights".into(),
            weight: Weight::NotModelled,
        };
        lacks.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what)).collect()
    }

    /// Lists and stacks of every sampling point of the pixel.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let scene = self.scene(frame, pose)?;
        let refused =
            |error: translucency::FeatureError| FrameError::Refused { frame, reason: error.to_string() };
        let mut lists = Lists::default();
        lists.fill(&self.screen, &scene.faces.triangles);
        let number = (pixel[1] / SIDE) * self.screen.counts()[0] as usize + pixel[0] / SIDE;
        let mut sampler = Sampler::new(&self.parameters).map_err(refused)?;
        sampler.fill(&scene, &lists, &self.screen.sub_area(number), number).map_err(refused)?;
        let entries = lists.of(number).len() + scene.lights.of(number).len();
        let mut facts = vec![Fact::new("sub-area", format!("{number}: {entries} entries"))];
        let stack = sampler.stack();
        let first = (pixel[1] % SIDE * SIDE + pixel[0] % SIDE) * stack.samples();
        for point in 0..stack.samples() {
            facts.push(Fact::new(
                "sampling point",
                format!("{point}: {}", told(&scene, stack, first + point)),
            ));
        }
        Ok(facts)
    }
}

/// The stack of a sampling point in words, near to far.
fn told(scene: &Scene, stack: &translucency::Stack, sample: usize) -> String {
    let layer = |layer: translucency::Layer<'_>| {
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
