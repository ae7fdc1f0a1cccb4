//! Albedo out of light.

use glam::DVec3;
use landscape::Sun;
use photo_drape::{Choice, LEAST_COSINE};
use quantities::sin_cos;

use crate::{drape, from_above, hill, plane};

const AZIMUTH: f64 = 0.7;

#[test]
fn the_albedo_of_a_plane_comes_back() {
    for [north, east] in [[0.0, 0.0], [0.2, -0.1], [-0.15, 0.05]] {
        let sun = Sun { azimuth: AZIMUTH, elevation: 0.6 };
        let light = 0.4 * sun.reflectivity([north, east]);
        let photo = from_above(700.0, |_, _| light, Some([sun.azimuth, sun.elevation]));
        let drape = drape(plane([north, east]), vec![photo], 20.0, Choice::Best).unwrap();
        let albedo = drape.albedo().unwrap();
        let known: Vec<f64> = albedo.values.iter().copied().filter(|value| !value.is_nan()).collect();
        assert!(known.len() > 100 && known.iter().all(|value| (value - 0.4).abs() < 1e-4), "{north} {east}");
        assert_eq!((albedo.shadowed, albedo.inferred), (0, 0));
        assert_eq!(albedo.missing + known.len(), 21 * 21);
        // Texels: posts are their centres, the northern line first.
        let map = albedo.map(drape.ground(), 0.9).unwrap();
        assert_eq!((map.area(), map.size()), ([-10.0, -10.0, 410.0, 410.0], [21, 21]));
        let [middle, corner] = [[200.0, 200.0], [0.0, 0.0]].map(|[x, y]| map.at(x, y).unwrap()[0]);
        assert!((middle - 0.4).abs() < 1e-4, "{middle}");
        assert_eq!(corner, f64::from(0.9_f32), "beside the photograph");
    }
}

#[test]
fn steep_ground_is_divided_by_no_less_than_a_tenth() {
    let sun = Sun { azimuth: 0.0, elevation: 0.05 };
    assert!(sun.reflectivity([0.0; 2]) < LEAST_COSINE);
    let photo = from_above(700.0, |_, _| 0.03, Some([sun.azimuth, sun.elevation]));
    let drape = drape(plane([0.0; 2]), vec![photo], 20.0, Choice::Best).unwrap();
    let albedo = drape.albedo().unwrap().values[10 * 21 + 10];
    assert!((albedo - 0.03 / LEAST_COSINE).abs() < 1e-4, "{albedo}");
}

#[test]
fn shadow_has_the_albedo_of_the_ground_around_it() {
    // Lit ground returns more to the east; the hill's shadow falls there too.
    let sun = [-std::f64::consts::FRAC_PI_2, 0.7];
    let photo = from_above(1100.0, |column, _| 0.05 + 0.1 * column as f64 / 400.0, Some(sun));
    let drape = drape(hill(), vec![photo], 5.0, Choice::Best).unwrap();
    let albedo = drape.albedo().unwrap();
    // More posts than those that face away from the sun: the hill casts a shadow.
    let up = drape.sun_of(0).unwrap();
    let posts = (0..81).flat_map(|row| (0..81).map(move |column| [row, column]));
    let places = posts.map(|post| drape.ground().post(post));
    let away = places.filter(|place| drape.ground().normal([place.x, place.y]).dot(up) <= 0.0).count();
    assert!(albedo.shadowed > 3 * away, "{} of which {away} face away", albedo.shadowed);
    // A post in the shadow, and what lies around it: no darker than the lit ground.
    let post = |north: f64, east: f64| albedo.values[(north / 5.0) as usize * 81 + (east / 5.0) as usize];
    let dark = post(200.0, 250.0);
    assert!(!dark.is_nan() && dark > 0.05 / sin_cos(0.7).0 * 0.9 && dark < 1.0, "{dark}");
    let (sin, cos) = sin_cos(0.7);
    assert!((drape.sun_of(0).unwrap() - DVec3::new(0.0, -cos, sin)).length() < 1e-12);
}
