//! All photographs over the ground.

use std::sync::Arc;

use glam::DVec3;
use landscape::Landscape;
use photograph::Photograph;
use sight::Posts;

use crate::layer::{Layer, Look};
use crate::triangle;
use crate::{DrapeError, Footprint, Ground};

/// Which photograph rules where several see a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Choice {
    /// The one with most pixels on a square metre; of equals the first.
    #[default]
    Best,
    /// All, by their pixels on a square metre.
    Blend,
}

/// What photographs show of a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Mean light in the footprint.
    pub light: f64,
    /// Number of the photograph that weighs most, from 0.
    pub photograph: usize,
    /// Its pixel I, J there.
    pub pixel: [f64; 2],
    /// Its pixels on a square metre.
    pub weight: f64,
    /// How many photographs see the place.
    pub seen_by: usize,
}

/// Photographs over the posts of ground.
#[derive(Debug, Clone)]
pub struct Drape {
    ground: Arc<Ground>,
    layers: Vec<Layer>,
    choice: Choice,
}

impl Drape {
    /// The photographs of `landscape` over its posts. A camera in landscape axes has east, north, up (m) of it. A map in metres, a map in degrees
    /// and a camera on a body stand in the coordinates of the elevation file that the bank was made of.
    ///
    /// # Errors
    /// If there is no photograph, or one cannot be laid over this ground.
    pub fn new(landscape: &Landscape, ground: Ground, choice: Choice) -> Result<Self, DrapeError> {
        let photographs = landscape.photographs();
        if photographs.is_empty() {
            return Err(DrapeError::None);
        }
        let posts = mesh(&ground)?;
        let layer = |(at, photograph): (usize, &Photograph)| {
            Layer::new(photograph, at + 1, landscape.bank(), &ground, &posts)
        };
        let layers = photographs.iter().enumerate().map(layer).collect::<Result<_, _>>()?;
        Ok(Self { ground: ground.into(), layers, choice })
    }

    /// Posts under the photographs.
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// The same posts, to be kept by whoever draws them.
    pub fn shared_ground(&self) -> Arc<Ground> {
        self.ground.clone()
    }

    /// The photographs, in their order.
    pub fn photographs(&self) -> impl ExactSizeIterator<Item = &Photograph> {
        self.layers.iter().map(|layer| &layer.photograph)
    }

    /// Light of a place of the ground (north, east, up; m) in a footprint; none where no photograph sees it.
    pub fn at(&self, place: DVec3, footprint: &Footprint) -> Option<Shown> {
        let (mut best, mut seen_by) = (None::<(usize, Look)>, 0);
        let (mut sum, mut weights) = (0.0, 0.0);
        for (number, layer) in self.layers.iter().enumerate() {
            let Some(look) = layer.look(&self.ground, place, footprint) else { continue };
            seen_by += 1;
            if best.is_none_or(|(_, best)| look.weight > best.weight) {
                best = Some((number, look));
            }
            if self.choice == Choice::Blend {
                (sum, weights) = (sum + look.weight * layer.light(&look), weights + look.weight);
            }
        }
        let (photograph, look) = best?;
        let light = if weights > 0.0 { sum / weights } else { self.layers[photograph].light(&look) };
        Some(Shown { light, photograph, pixel: look.pixel, weight: look.weight, seen_by })
    }

    /// Whether a photograph shows a place of the ground (north, east, up; m).
    pub fn is_shown(&self, place: DVec3) -> bool {
        self.layers.iter().any(|layer| layer.shows(&self.ground, place).is_some())
    }

    /// Mean light of the pixels of a photograph (from 0) whose centres lie in a triangle of the ground (north, east, up; m), with their number; none
    /// where there is no such pixel.
    pub fn mean_in(&self, photograph: usize, corners: [DVec3; 3]) -> Option<(f64, u32)> {
        let layer = &self.layers[photograph];
        let [a, b, c] = corners.map(|corner| layer.pixel(corner));
        let picture = layer.photograph.picture();
        let (mut sum, mut count) = (0.0, 0_u32);
        triangle::pixels([a?, b?, c?], [picture.columns(), picture.lines()], |column, line| {
            sum += layer.photograph.light_of(column, line);
            count += 1;
        });
        (count > 0).then(|| (sum / f64::from(count), count))
    }

    /// Direction to the sun of a photograph (from 0): north, east, up.
    ///
    /// # Errors
    /// If the photograph does not say.
    pub fn sun_of(&self, photograph: usize) -> Result<DVec3, DrapeError> {
        let sun = self.layers[photograph].photograph.sun();
        let [azimuth, elevation] = sun.ok_or(DrapeError::NoSun { number: photograph + 1 })?;
        Ok(DVec3::from_array(landscape::Sun { azimuth, elevation }.direction()))
    }
}

/// The triangles of the posts, for lines of sight.
fn mesh(ground: &Ground) -> Result<Posts, DrapeError> {
    let [rows, columns] = ground.size();
    let [south, west] = ground.corner();
    let north = south + (rows - 1) as f64 * ground.spacing();
    let heights = ground.heights().chunks(columns).rev().flatten().copied().collect();
    Posts::new([rows, columns], [north, west], ground.spacing(), heights)
        .map_err(|error| DrapeError::Camera { number: 1, error })
}
