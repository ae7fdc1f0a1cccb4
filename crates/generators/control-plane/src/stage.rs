//! A stage with the machine that draws it.

use std::collections::BTreeMap;
use std::sync::Arc;

use generator::{Along, PrepareError, Scan, Stage};
use hardware_model::Settings;
use landscape::Landscape;
use scenario::{BodyShading, Scenery, Standing};

/// Name of the signal that says where a sample of a sweep is (m).
pub const RANGE: &str = "sweep.range";

/// The world, and the settings of the hybrid machine that draws it; the view is part of these settings.
#[derive(Debug, Clone)]
pub struct MachineStage {
    /// Ground: terrain, craters, texture and albedo.
    pub landscape: Arc<Landscape>,
    /// Light, bodies and tracks over time.
    pub scenery: Arc<Scenery>,
    /// Settings of the machine.
    pub settings: Settings,
}

impl MachineStage {
    /// `stage` for a machine of `settings`.
    ///
    /// # Errors
    /// If the view of the stage is not the one that the settings give.
    pub fn new(stage: Stage, settings: Settings) -> Result<Self, PrepareError> {
        let Stage { landscape, scenery, view } = stage;
        if view != settings.view() {
            return Err(PrepareError::Unsupported {
                generator: "hybrid",
                what: "another view than the one that its settings give".into(),
                remedy: "make the stage and the machine from the same settings".into(),
            });
        }
        let scenery = match settings.laws.body_shading {
            BodyShading::Flat => scenery,
            BodyShading::Smooth => Arc::new(rounded(&scenery)),
        };
        Ok(Self { landscape, scenery, settings })
    }

    /// The same for any generator: world and view.
    pub fn stage(&self) -> Stage {
        let Self { landscape, scenery, settings } = self;
        Stage { landscape: Arc::clone(landscape), scenery: Arc::clone(scenery), view: settings.view() }
    }

    /// How the signals of the machine run.
    pub fn scan(&self) -> Scan {
        scan(&self.settings)
    }
}

/// The same scenery with normals at the corners of its bodies. Those of one shape share it afterwards too.
fn rounded(scenery: &Scenery) -> Scenery {
    let mut shapes = BTreeMap::new();
    let round = |standing: &Standing| {
        let solid = &standing.body.solid;
        let shape = shapes.entry(Arc::as_ptr(solid) as usize).or_insert_with(|| Arc::new(solid.rounded()));
        Standing { body: standing.body.rounded(shape), ..standing.clone() }
    };
    let standing = scenery.standing().iter().map(round).collect();
    scenery.clone().with_bodies(standing)
}

/// How the signals of a machine of `settings` run.
pub fn scan(settings: &Settings) -> Scan {
    Scan { line: "sweep", timebase: settings.timebase, place: RANGE, along: Along::Range }
}
