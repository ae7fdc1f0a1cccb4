//! What makes places dark in one shot: the vehicle's parts, and tracks.

use glam::{DVec2, DVec3};
use quantities::radians;
use scenario::TrackPatch;
use solids::Body;

use crate::Shot;
use crate::cells::Cells;
use crate::prism::{Prism, Reach};
use crate::stretch::{Spot, Stretch};
use crate::suns::SUN_HALF_ANGLE_DEG;

/// Farthest that a track is looked for (m).
const TRACKS_REACH: f64 = 200.0;

/// What casts in one shot.
pub struct Casters {
    /// Of the whole vehicle; nothing if it has no parts.
    pub reach: Option<Reach>,
    pub parts: Vec<Part>,
    tracks: Vec<Prism>,
    cells: Cells,
    /// Ground range up to which there are tracks (m).
    pub tracks_reach: f64,
}

/// A part of the vehicle.
pub struct Part {
    pub reach: Reach,
    /// What lies behind it, for each point of the sun.
    pub shadows: Vec<Option<Prism>>,
}

impl Casters {
    /// Of the vehicle's parts where they stand, under `suns`, and of patches of track that have been laid.
    pub fn new(bodies: &[Body], shot: &Shot, suns: &[DVec3], tracks: &[TrackPatch]) -> Self {
        let middle = suns.iter().sum::<DVec3>().normalize();
        let growth = if suns.len() > 1 { libm::tan(radians(SUN_HALF_ANGLE_DEG)) } else { 0.0 };
        let part = |body: &Body| Part {
            reach: Reach::of(std::slice::from_ref(body), middle, growth),
            shadows: suns.iter().map(|&sun| Prism::shadow(body, sun)).collect(),
        };
        let [x, y, _] = shot.eye;
        let away = |[north, east]: [f64; 2]| DVec2::new(north - x, east - y).length();
        let farthest = |patch: &TrackPatch| patch.corners.map(away).into_iter().fold(0.0, f64::max);
        let near: Vec<&TrackPatch> = tracks.iter().filter(|patch| farthest(patch) <= TRACKS_REACH).collect();
        Self {
            reach: (!bodies.is_empty()).then(|| Reach::of(bodies, middle, growth)),
            parts: bodies.iter().map(part).collect(),
            tracks: near.iter().map(|patch| Prism::patch(patch)).collect(),
            cells: Cells::new(near.iter().map(|patch| box_around(patch))),
            tracks_reach: near.iter().map(|patch| farthest(patch)).fold(0.0, f64::max),
        }
    }

    /// Patches that a stretch may show; only ground has any.
    pub fn patches(&self, stretch: &Stretch) -> impl Iterator<Item = &Prism> {
        let place = |spot: Spot| spot.place.truncate().to_array();
        let near = match stretch.chord() {
            Some([a, b]) if a.of == 0 => self.cells.near(place(a), place(b)),
            Some(_) => Vec::new(),
            None => {
                let ends = stretch.spots.into_iter().flatten().filter(|spot| spot.of == 0).map(place);
                ends.flat_map(|end| self.cells.near(end, end)).collect()
            }
        };
        near.into_iter().map(|number| &self.tracks[number])
    }
}

fn box_around(patch: &TrackPatch) -> [[f64; 2]; 2] {
    let corners = patch.corners.map(DVec2::from_array);
    let low = corners.into_iter().fold(DVec2::INFINITY, DVec2::min);
    let high = corners.into_iter().fold(DVec2::NEG_INFINITY, DVec2::max);
    [low.to_array(), high.to_array()]
}
