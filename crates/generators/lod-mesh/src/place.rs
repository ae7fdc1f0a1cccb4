//! What a pixel shows of the ground: its tile, and how far that has morphed.

use generator::Fact;
use glam::DVec3;
use lod_tiles::{Surface, Terrain, Tile};
use scene_sampler::Camera;

use crate::ground::finest;
use crate::prepared::Prepared;

/// A place of the ground that a pixel shows.
pub struct Seen {
    /// Place: north, east, up (m), on the map.
    place: DVec3,
}

/// Distance (m) of an eye from the middle of a tile: what its level follows from.
pub fn distance(terrain: &Terrain, tile: Tile, eye: DVec3) -> f64 {
    let [x, y, z] = terrain.middle(tile);
    (DVec3::new(y, x, z) - eye).length()
}

impl Seen {
    /// What pixel `pixel` shows of a surface that is as near as `q` (1/m).
    pub fn new(camera: &Camera, pixel: [usize; 2], q: f64) -> Self {
        let seen = camera.eye + camera.ray(pixel.map(|at| at as f64 + 0.5)) / q;
        Self { place: seen + DVec3::Z * camera.drop_at(seen) }
    }

    /// The tile under the place.
    pub fn tile(&self, terrain: &Terrain) -> Tile {
        terrain.locate([self.place.y, self.place.x]).0
    }

    /// Tile, level, fraction and heights (m) under the place.
    pub fn facts(&self, prepared: &Prepared, surface: &Surface<'_>, eye: DVec3) -> Vec<Fact> {
        let DVec3 { x: north, y: east, .. } = self.place;
        let on_map = [east, north];
        let (tile, within) = surface.terrain.locate(on_map);
        let state = surface.tile_state(tile);
        let distance = distance(surface.terrain, tile, eye);
        let [drawn, whole, finest] =
            [surface.under(on_map), surface.unmorphed(on_map), finest(prepared, on_map)];
        let level = format!(
            "{} (range to {:.0} m), {:.4} of the way to the next; middle of the tile {distance:.1} m away",
            state.level, prepared.table.ends[state.level], state.fraction
        );
        let heights = format!(
            "{drawn:.4} m as drawn; {whole:.4} m before morphing; {finest:.4} m by the finest triangles{}",
            prepared
                .stage
                .landscape
                .height(north, east)
                .map_or(String::new(), |true_height| format!("; {true_height:.4} m by the landscape"))
        );
        vec![
            Fact::new("ground", format!("{north:.2} m north, {east:.2} m east")),
            Fact::new(
                "tile",
                format!(
                    "column {}, row {}; cell {:.2}, {:.2} of it",
                    tile.column, tile.row, within[0], within[1]
                ),
            ),
            Fact::new("level", level),
            Fact::new("height", heights),
        ]
    }
}
