//! Where the camera stands: closed forms.

use glam::DVec3;
use photo_camera::Image;
use photo_make::{MakeError, Reach, Stand, Wishes};
use quantities::radians;

use crate::{attitudes, craters, plane, stage, wishes};

#[test]
fn the_optical_axis_meets_the_centre_with_the_ground_sample() {
    let stage = stage(plane(7.0, [0.05, -0.02]), craters());
    for wishes in attitudes() {
        let stand = Stand::new(&stage.landscape, &wishes).expect("a stand");
        let [north, east] = wishes.centre;
        let centre = DVec3::new(east, north, stage.landscape.height(north, east).expect("ground"));
        let Image::Front { pixel, depth } = stand.camera.project(centre) else { panic!("in front") };
        assert!((pixel[0] - 24.0).abs() < 1e-9 && (pixel[1] - 18.0).abs() < 1e-9, "{pixel:?}");
        assert!((depth - stand.distance).abs() < 1e-9);
        assert!((stand.camera.centre().z - centre.z - 300.0).abs() < 1e-9);
        // One pixel to the right lies one ground sample away, across the axis.
        let rays = [[24.0, 18.0], [25.0, 18.0], [24.0, 19.0]].map(|pixel| stand.camera.ray(pixel));
        let on = rays.map(|ray| ray.on_plane(centre, rays[0].direction).expect("ahead"));
        assert!(
            ((on[1] - on[0]).length() - 2.0).abs() < 1e-9 && ((on[2] - on[0]).length() - 2.0).abs() < 1e-9
        );
    }
}

/// In a vertical picture the upper edge looks along the heading, and right is 90 degrees clockwise from it.
#[test]
fn up_is_the_heading() {
    let stage = stage(plane(0.0, [0.0; 2]), craters());
    for heading in [0.0, 90.0, 215.0] {
        let wishes = Wishes { heading: radians(heading), ..wishes() };
        let camera = Stand::new(&stage.landscape, &wishes).expect("a stand").camera;
        let on = |pixel| camera.ray(pixel).on_plane(DVec3::ZERO, DVec3::Z).expect("ground");
        let [up, right] = [on([24.0, 8.0]) - on([24.0, 18.0]), on([34.0, 18.0]) - on([24.0, 18.0])];
        let azimuth = |v: DVec3| libm::atan2(v.x, v.y).to_degrees().rem_euclid(360.0);
        let apart = |found: f64, expected: f64| ((found - expected + 540.0).rem_euclid(360.0) - 180.0).abs();
        assert!(apart(azimuth(up), heading) < 1e-9, "{}", azimuth(up));
        assert!(apart(azimuth(right), heading + 90.0) < 1e-9, "{}", azimuth(right));
    }
}

/// Positive roll turns the right side down: a level horizon rises to the left in camera axes.
#[test]
fn roll_is_right_side_down() {
    let stage = stage(plane(0.0, [0.0; 2]), craters());
    let rolled = Wishes { pitch: radians(-30.0), roll: radians(10.0), ..wishes() };
    let camera = Stand::new(&stage.landscape, &rolled).expect("a stand").camera;
    let [right, up, against] = camera.orientation().axes();
    let expected = -libm::sin(radians(10.0)) * libm::cos(radians(30.0));
    assert!((right.z - expected).abs() < 1e-12, "{right}");
    assert!((right.cross(up) - against).length() < 1e-12);
}

#[test]
fn a_field_of_view_is_the_angle_between_the_edges() {
    let stage = stage(plane(0.0, [0.0; 2]), craters());
    let wishes = Wishes { reach: Reach::Field(radians(40.0)), ..wishes() };
    let stand = Stand::new(&stage.landscape, &wishes).expect("a stand");
    let edges = [[0.0, 18.0], [48.0, 18.0]].map(|pixel| stand.camera.ray(pixel).direction);
    let angle = libm::acos(edges[0].dot(edges[1]));
    assert!((angle - radians(40.0)).abs() < 1e-9, "{angle}");
}

#[test]
fn stands_that_cannot_be_are_refused() {
    let stage = stage(plane(0.0, [0.9, 0.0]), craters());
    let stand = |wishes: Wishes| Stand::new(&stage.landscape, &wishes);
    let beside = stand(Wishes { centre: [200.0, 401.0], ..wishes() }).expect_err("beside");
    assert!(matches!(beside, MakeError::Centre { east: 401.0, .. }), "{beside}");
    assert!(beside.to_string().contains("from 0 to 400 m east"), "{beside}");
    // Looking south and down at a hill that rises to the north, the camera is inside the hill.
    let under =
        Wishes { heading: radians(180.0), pitch: radians(-20.0), reach: Reach::Height(30.0), ..wishes() };
    let under = stand(under).expect_err("under ground");
    assert!(matches!(under, MakeError::UnderGround { .. }), "{under}");
}
