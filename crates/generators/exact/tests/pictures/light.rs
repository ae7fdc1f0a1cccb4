//! Light of the ground: photometry, light of features, texture, shadow on texture.

use std::sync::Arc;

use crate::scenes::{bumps, crater_field, landscape, laws, place, planes, pose, ray, settings, sun, value};
use generator::{Label, PlaneKind, Planes};
use hardware_model::Settings;
use landscape::{Landscape, Layer, Photometry, Source, Sun, Texture};
use scenario::{
    Curvature, FeatureLight, Laws, PixelRule, Pose, Projection, Scenery, ShadowFineness, TextureInShadow,
};

const LINES: u32 = 40;

struct Shot {
    ground: Arc<Landscape>,
    light: Sun,
    settings: Settings,
    pose: Pose,
    planes: Planes,
}

fn shoot(ground: Landscape, laws: Laws, shadows: bool) -> Shot {
    let (ground, light) = (Arc::new(ground), sun(130.0, 9.0));
    let shadows = shadows.then(ShadowFineness::default);
    let settings = Settings { shadows, ..settings(30, LINES, laws, [0.5, 45.0]) };
    let pose = pose([24.0, 24.0, ground.height(24.0, 24.0).unwrap() + 1.5], -8.0, 200.0);
    let planes = planes(&ground, Scenery::still(light), &settings, &pose);
    Shot { ground, light, settings, pose, planes }
}

fn cratered() -> Landscape {
    Landscape::clone(&landscape(bumps(5, 0.5), 0.8)).with_features(crater_field(5, 80, 8.0))
}

fn usual() -> Laws {
    laws(Projection::Exact, Curvature::None, PixelRule::Centre)
}

impl Shot {
    /// Pixels of ground with their places and ranges, but those next to a kink circle or a region's edge.
    fn ground(&self) -> Vec<(usize, [f64; 2], f64)> {
        let place = |index| {
            let range = value(&self.planes, PlaneKind::Range, index);
            (index, place(&self.settings, &self.pose, index, range), range)
        };
        let smooth = |[x, y]: [f64; 2]| {
            let slopes = |x, y| self.ground.at(x, y).map(|point| point.slopes);
            let here = slopes(x, y);
            [[1e-4, 0.0], [-1e-4, 0.0], [0.0, 1e-4], [0.0, -1e-4]].into_iter().all(|[dx, dy]| {
                let there = slopes(x + dx, y + dy);
                here.zip(there).is_some_and(|(a, b)| (0..2).all(|axis| (a[axis] - b[axis]).abs() < 1e-2))
            })
        };
        (0..30 * LINES as usize)
            .map(place)
            .filter(|(_, place, range)| range.is_finite() && smooth(*place))
            .collect()
    }

    /// Light of slopes without shadow, by the landscape's own law.
    fn shade(&self, index: usize, slopes: [f64; 2], [x, y]: [f64; 2], range: f64) -> f64 {
        let rise = (self.ground.height(x, y).unwrap() - self.pose.eye[2]) / range;
        let ray = ray(&self.settings, &self.pose, index);
        let length = libm::sqrt(1.0 + rise * rise);
        let to_eye = [-ray.direction[0] / length, -ray.direction[1] / length, -rise / length];
        self.ground.albedo() * self.light.shade(slopes, to_eye, *self.ground.photometry())
    }

    fn intensity(&self, index: usize) -> f64 {
        value(&self.planes, PlaneKind::Intensity, index)
    }
}

#[test]
fn every_law_of_reflection_from_the_slopes_of_all() {
    let specular = Photometry::Specular { strength: 0.5, exponent: 8 };
    for law in [Photometry::Lambert, Photometry::LommelSeeliger, Photometry::LunarLambert, specular] {
        let shot = shoot(cratered().with_photometry(law), usual(), false);
        let pixels = shot.ground();
        assert!(pixels.len() > 500);
        for (index, place, range) in pixels {
            let slopes = shot.ground.at(place[0], place[1]).unwrap().slopes;
            let expected = shot.shade(index, slopes, place, range).min(1.0);
            assert!((shot.intensity(index) - expected).abs() < 1e-3, "{law:?} {index}: {expected}");
        }
    }
}

#[test]
fn as_reported_features_are_lit_as_if_on_level_ground() {
    let shot = shoot(cratered(), Laws { feature_light: FeatureLight::AsReported, ..usual() }, false);
    let mut features = 0;
    for (index, place, range) in shot.ground() {
        let rise = shot.ground.features().at(place[0], place[1]);
        let terrain = shot.ground.terrain_at(place[0], place[1]).unwrap().slopes;
        let slopes = if rise.present { rise.slopes } else { terrain };
        let expected = shot.shade(index, slopes, place, range);
        assert!((shot.intensity(index) - expected).abs() < 1e-3, "{index}: {expected}");
        assert_eq!(value(&shot.planes, PlaneKind::Label, index), if rise.present { 2.0 } else { 1.0 });
        features += usize::from(rise.present);
    }
    assert!(features > 100, "{features}");
}

#[test]
fn texture_is_added_behind_the_shadow_switch() {
    let layers = [Layer { cell: 0.7, amplitude: 0.2, range: 30.0 }];
    let texture = Texture::new(&layers, Source::Random, 11, 8.0, [0.0; 2]).unwrap();
    for (law, shadows) in
        [(TextureInShadow::On, true), (TextureInShadow::Off, true), (TextureInShadow::Off, false)]
    {
        let laws = Laws { texture_in_shadow: law, ..usual() };
        let shot = shoot(cratered().with_texture(Some(texture.clone())), laws, shadows);
        let mut counts = [0; 3];
        for (index, place, range) in shot.ground() {
            let slopes = shot.ground.at(place[0], place[1]).unwrap().slopes;
            let lit = shot.shade(index, slopes, place, range);
            let [hx, hy] = slopes;
            let [north, east, up] = shot.light.direction();
            let signed =
                shot.ground.albedo() * (up - hx * north - hy * east) / libm::sqrt(1.0 + hx * hx + hy * hy);
            let added = texture.at(place[0], place[1], range);
            let shade = value(&shot.planes, PlaneKind::Shadow, index);
            let expected = match (law, shade) {
                (TextureInShadow::On, 2.0) => added,
                (TextureInShadow::Off, 2.0) => 0.0,
                (TextureInShadow::On, _) => lit + added,
                // Ground that turns from the sun is remote shadow too, where there is any.
                (TextureInShadow::Off, 1.0) if shadows => 0.0,
                (TextureInShadow::Off, _) => signed + added,
            };
            let found = shot.intensity(index);
            assert!(
                (found - expected.clamp(0.0, 1.0)).abs() < 2e-3,
                "{law:?} {index}: {found}, not {expected}"
            );
            assert!((value(&shot.planes, PlaneKind::Reflectivity, index) - lit).abs() < 1e-3);
            counts[shade as usize] += 1;
        }
        assert!(counts[0] > 20 && counts[1] > 20 && (counts[2] > 20) == shadows, "{counts:?}");
    }
}

#[test]
fn ground_without_data_has_a_label_of_its_own() {
    // Regions of 8 m: two of them, ahead of the eye, have no data.
    let voids = [[0, 1], [1, 2]];
    let bank = landscape(bumps(5, 0.5), 0.8).bank().clone().with_voids(voids.to_vec()).unwrap();
    let shot = shoot(Landscape::new(bank, 0.8), usual(), false);
    let mut found = [0; 2];
    for (index, place, _) in shot.ground() {
        let is_void = voids.contains(&place.map(|at| (at / 8.0) as u32));
        let expected = if is_void { Label::Void } else { Label::Terrain };
        assert_eq!(value(&shot.planes, PlaneKind::Label, index), f64::from(expected.code()), "{place:?}");
        found[usize::from(is_void)] += 1;
    }
    assert!(found.iter().all(|count| *count > 20), "{found:?}");
}
