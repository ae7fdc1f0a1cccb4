//! What a pixel shows of the ground: its panel, and what photographs show there.

use generator::{Fact, Label};
use glam::DVec3;
use photo_drape::Footprint;
use scene_sampler::Camera;

use crate::greys::{Grey, Source, grey};
use crate::prepared::Prepared;
use crate::signals::Sample;

/// A place of the ground that a pixel shows.
pub struct Seen {
    /// Place: north, east, up (m), on the map.
    place: DVec3,
    /// Distance (m) from the eye.
    distance: f64,
}

impl Seen {
    /// What pixel `pixel` shows of a surface that is as near as `q` (1/m).
    pub fn new(camera: &Camera, pixel: [usize; 2], q: f64) -> Self {
        let to = camera.ray(pixel.map(|at| at as f64 + 0.5)) / q;
        let seen = camera.eye + to;
        Self { place: seen + DVec3::Z * camera.drop_at(seen), distance: to.length() }
    }

    /// Panel, distance, light and photograph's pixel at the place.
    pub fn sample(&self, prepared: &Prepared, camera: &Camera) -> Sample {
        let on_map = [self.place.x, self.place.y];
        let ground = prepared.drape.ground();
        let (cell, shares) = ground.cell(on_map);
        let shown = prepared.drape.at(self.place, &self.footprint(prepared, camera));
        let unseen = || ground.between(on_map, |post| [f64::from(prepared.unseen[post])])[0];
        Sample {
            panel: Some(prepared.mesh.panel_at(cell, shares) as u32),
            depth: self.distance,
            grey: shown.map_or_else(unseen, |shown| shown.light),
            source: shown.map(|shown| shown.pixel),
            writes: 0.0,
            touches_void: false,
        }
    }

    /// Terrain, terrain without data, or terrain that no photograph shows.
    pub fn label(&self, prepared: &Prepared) -> Label {
        let is_void = prepared.stage.landscape.is_void(self.place.x, self.place.y);
        match prepared.drape.is_shown(self.place) {
            _ if is_void => Label::Void,
            false => Label::Inferred,
            true => Label::Terrain,
        }
    }

    /// What the pixel covers of the ground.
    fn footprint(&self, prepared: &Prepared, camera: &Camera) -> Footprint {
        let normal = prepared.drape.ground().normal([self.place.x, self.place.y]);
        Footprint::seen(self.place, normal, camera.eye, 0.5 / camera.focal())
    }

    /// Panel, posts, photograph, pixels and light at the place.
    pub fn facts(&self, prepared: &Prepared, camera: &Camera) -> Vec<Fact> {
        let ground = prepared.drape.ground();
        let on_map = [self.place.x, self.place.y];
        let (cell, shares) = ground.cell(on_map);
        let panel = prepared.mesh.panel_at(cell, shares);
        let corners = prepared.mesh.corners(panel);
        let Grey { light, source } = grey(&prepared.drape, prepared.run.choice, corners, &prepared.unseen);
        let [south_west, heights] = [format!("row {}, column {}", cell[0], cell[1]), heights(corners)];
        let mut facts = vec![
            Fact::new("ground", format!("{:.2} m north, {:.2} m east", on_map[0], on_map[1])),
            Fact::new(
                "panel",
                format!("{panel}; south-western post of its cell: {south_west}; posts {heights} m high"),
            ),
            Fact::new("light of the panel", format!("{light:.4}, {}", told(source))),
        ];
        facts.push(match prepared.drape.at(self.place, &self.footprint(prepared, camera)) {
            None => Fact::new("photographs", "none sees this place"),
            Some(shown) => Fact::new(
                "photographs",
                format!(
                    "{} of {} see this place; number {} rules: pixel I {:.2}, J {:.2}, {:.3} pixels a square metre, light {:.4}",
                    shown.seen_by,
                    prepared.drape.photographs().len(),
                    shown.photograph + 1,
                    shown.pixel[0],
                    shown.pixel[1],
                    shown.weight,
                    shown.light
                ),
            ),
        });
        facts
    }
}

fn heights(corners: [DVec3; 3]) -> String {
    corners.map(|corner| format!("{:.3}", corner.z)).join(", ")
}

fn told(source: Source) -> String {
    match source {
        Source::Mean { photograph, pixels } => {
            format!("mean of {pixels} pixels of photograph {}", photograph + 1)
        }
        Source::Look { photograph } => format!("a look at its middle, photograph {}", photograph + 1),
        Source::Unseen => "of no photograph: inferred from around, or `panels.outside`".into(),
    }
}
