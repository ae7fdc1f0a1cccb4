//! Angles: one grammar, and nothing that reads two ways.

use photo_camera::{Axis, parse_angle, write_angle};

use crate::Random;

#[test]
fn both_forms_give_the_same_angle() {
    for (text, axis, degrees) in [
        ("122:30:00 W", Axis::Longitude, -122.5_f64),
        ("122:30:0W", Axis::Longitude, -122.5),
        (" -122.5 ", Axis::Longitude, -122.5),
        ("+122.5", Axis::Longitude, 122.5),
        ("0:30:36 S", Axis::Latitude, -0.51),
        ("37:22:47 N", Axis::Latitude, 37.0 + 22.0 / 60.0 + 47.0 / 3600.0),
    ] {
        let angle = parse_angle(text, axis).expect(text);
        assert!((angle - degrees.to_radians()).abs() < 1e-15, "{text}: {angle}");
    }
}

#[test]
fn what_could_be_read_two_ways_is_refused() {
    for text in [
        "-122:02:17 W",
        "-122:-02:-17",
        "122:-02:17 W",
        "122:02:17",
        "122:02:17 N",
        "122:02 W",
        "122:60:00 W",
        "122:02:60 W",
        "122.5:02:17 W",
        "181",
        "122 02 17",
        "",
        "NaN",
        "inf",
        "1e2",
        "--5",
        "122.5W",
        "1:2:3:4 W",
        "::W",
    ] {
        let refused = parse_angle(text, Axis::Longitude);
        let told = refused.expect_err(text).to_string();
        assert!(told.contains(&format!("\"{text}\"")) && told.contains("122:05:03 W"), "{told}");
    }
    assert!(parse_angle("90:00:01 N", Axis::Latitude).is_err());
}

#[test]
fn a_written_angle_is_read_back_within_half_a_microsecond_of_arc() {
    let mut random = Random(1);
    for _ in 0..2000 {
        let angle = random.between(-90.0, 90.0).to_radians();
        let text = write_angle(angle, Axis::Latitude);
        let back = parse_angle(&text, Axis::Latitude).expect(&text);
        assert!((back - angle).abs() <= (0.51e-6_f64 / 3600.0).to_radians(), "{text}");
    }
}

#[test]
fn seconds_are_never_written_as_sixty() {
    assert_eq!(write_angle((37.0_f64 - 1e-12).to_radians(), Axis::Latitude), "37:00:00.000000 N");
}
