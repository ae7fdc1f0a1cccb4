//! Planes of truth: each against the landscape at the place that the pixel shows.

use std::sync::Arc;

use crate::scenes::{bumps, crater_field, landscape, laws, place, planes, pose, settings, sun, value};
use generator::PlaneKind;
use hardware_model::Settings;
use landscape::Landscape;
use scenario::{Curvature, PixelRule, Projection, Scenery, ShadowFineness};

#[test]
fn heights_and_normals_are_the_landscape_s() {
    let ground = Landscape::clone(&landscape(bumps(9, 0.4), 0.8)).with_features(crater_field(9, 40, 9.0));
    let ground = Arc::new(ground);
    let laws = laws(Projection::Exact, Curvature::Parabolic, PixelRule::LineMean);
    let settings =
        Settings { shadows: Some(ShadowFineness::default()), ..settings(30, 40, laws, [0.5, 45.0]) };
    let pose = pose([24.0, 24.0, ground.height(24.0, 24.0).unwrap() + 1.5], -8.0, 20.0);
    let found = planes(&ground, Scenery::still(sun(130.0, 9.0)), &settings, &pose);
    let (mut seen, mut off) = (0, 0);
    for index in 0..30 * 40 {
        let of = |kind| value(&found, kind, index);
        let normal = [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp].map(of);
        let range = of(PlaneKind::Range);
        if of(PlaneKind::Label) == 0.0 {
            assert_eq!((range, of(PlaneKind::Height), normal), (f64::INFINITY, 0.0, [0.0; 3]));
            assert_eq!((of(PlaneKind::Reflectivity), of(PlaneKind::Shadow)), (0.0, 0.0));
            continue;
        }
        let [x, y] = place(&settings, &pose, index, range);
        let Some(point) = ground.at(x, y) else { continue };
        assert!((of(PlaneKind::Height) - point.height).abs() < 1e-4, "{index}");
        let length: f64 = normal.iter().map(|part| part * part).sum();
        assert!((length - 1.0).abs() < 1e-6);
        let slopes = [-normal[0] / normal[2], -normal[1] / normal[2]];
        off += usize::from((0..2).any(|axis| (slopes[axis] - point.slopes[axis]).abs() > 1e-3));
        seen += 1;
    }
    assert!(seen > 500, "{seen}");
    // A range in f32 may lie on the other side of a kink circle.
    assert!(off * 200 < seen, "{off} of {seen}");
    let all = PlaneKind::ALL.iter().flat_map(|&kind| found.get(kind).unwrap());
    assert!(all.into_iter().all(|value| !value.is_nan()));
}
