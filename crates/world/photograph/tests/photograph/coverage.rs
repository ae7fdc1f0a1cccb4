//! How much of a ground a photograph shows, and a photograph of other ground.

use glam::DVec3;
use photo_camera::Light;
use photograph::{Coverage, PhotoError};
use picture::Depth;

use crate::{from_above, picture};

#[test]
fn points_are_counted_where_they_fall() {
    let photo = from_above(picture(40, 30, Depth::Eight, |_, _| 9), Light::default());
    // The footprint is 80 m x 60 m; every 10 m from -100 to 100 m there are 8 x 6 posts inside, edges to the south and east out.
    let posts = (0..21)
        .flat_map(|row| (0..21).map(move |column| [row, column].map(|at| f64::from(at) * 10.0 - 100.0)));
    let points = posts.map(|[north, east]| DVec3::new(east, north, 0.0));
    let above = [DVec3::new(0.0, 0.0, 2000.0)];
    let found = photo.coverage(points.chain(above)).expect("some inside");
    assert_eq!((found.points(), found.behind), (442, 1));
    assert!((8 * 6..=9 * 7).contains(&found.inside), "{found:?}");
    assert_eq!(found.outside, 441 - found.inside);
}

#[test]
fn a_photograph_of_other_ground_is_refused_with_the_pixels_found() {
    let photo = from_above(picture(40, 30, Depth::Eight, |_, _| 9), Light::default());
    let far = [DVec3::new(400.0, 0.0, 0.0), DVec3::new(500.0, 0.0, 0.0), DVec3::new(0.0, 0.0, 2000.0)];
    let refused = photo.coverage(far).expect_err("other ground");
    assert!(matches!(
        refused,
        PhotoError::NothingInCommon { points: 3, behind: 1, columns: 40, lines: 30, .. }
    ));
    let text = refused.to_string();
    assert!(text.contains("no pixel in common") && text.contains("I 220 to 270, J 15 to 15"), "{text}");
    let behind = photo.coverage([DVec3::new(0.0, 0.0, 2000.0)]).expect_err("behind");
    assert!(behind.to_string().contains("at no pixel"), "{behind}");
    assert!(matches!(photo.coverage([]), Err(PhotoError::NothingInCommon { points: 0, .. })));
    assert_eq!(Coverage::default().points(), 0);
}
