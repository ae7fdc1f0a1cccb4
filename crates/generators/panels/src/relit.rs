//! Ground lit anew by the scenario's sun.

use std::sync::Arc;

use generator::{PrepareError, Stage};
use glam::DVec3;
use landscape::Landscape;
use photo_drape::{Drape, Ground};
use rayon::prelude::*;
use scene_sampler::{Axis, GroundMap};

use crate::prepared::refused;

/// Albedo out of photographs on the landscape, and the slopes of its posts.
#[derive(Debug)]
pub struct Relit {
    landscape: Arc<Landscape>,
    slopes: Arc<Vec<[f32; 2]>>,
    axes: [Axis; 2],
    /// The posts that cast shadow; none where the scenario has no cast shadow.
    caster: Option<Arc<Drape>>,
}

impl Relit {
    /// The landscape with the albedo that the photographs give; where they give none it keeps its own.
    ///
    /// # Errors
    /// If a photograph does not say where its sun was.
    pub fn new(drape: &Arc<Drape>, stage: &Stage) -> Result<Self, PrepareError> {
        let remedy = "give its camera file a sun, or switch panels.relight off";
        let albedo = drape.albedo().map_err(|error| refused(&error, remedy))?;
        let ground = drape.ground();
        let landscape = &stage.landscape;
        let map = albedo.map(ground, landscape.albedo()).map_err(|error| refused(&error, remedy))?;
        Ok(Self {
            landscape: Arc::new((**landscape).clone().with_albedo_map(Some(map))),
            slopes: ground.slopes().to_vec().into(),
            axes: [0, 1].map(|axis| even(ground, axis)),
            caster: stage.view.shadows.is_some().then(|| drape.clone()),
        })
    }

    /// Its light under a sun (unit vector to it: north, east, up), with the shadows that its posts cast where the scenario has cast shadow.
    pub fn map(&self, sun: [f64; 3]) -> Option<GroundMap> {
        let map = GroundMap::of_slopes(self.axes, self.slopes.clone(), self.landscape.clone(), sun)?;
        let Some(caster) = &self.caster else { return Some(map) };
        let shadowed = caster.ground().shadowed(DVec3::from_array(sun));
        let lit: Vec<[f32; 1]> =
            shadowed.into_par_iter().map(|is_dark| [if is_dark { 0.0 } else { 1.0 }]).collect();
        map.with_shadow(lit.into())
    }
}

/// Places of the posts along an axis of the map.
fn even(ground: &Ground, axis: usize) -> Axis {
    let posts = ground.size()[axis];
    let step = ground.spacing();
    Axis { first: ground.corner()[axis], step, whole: posts - 1, last_step: step, posts }
}
