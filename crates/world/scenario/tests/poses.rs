//! The vehicle on the ground.

use landscape::{Attitude, Bank, Landscape, Level};
use proptest::prelude::*;
use quantities::{Rate, degrees, radians};
use scenario::{Limit, Path, PoseFault, PoseTable, Scenario, Vehicle, Waypoint, Yoke, poses_csv};

/// 500 m x 500 m of `h = at + north x + east y + bend x^2 / 2`.
fn ground(at: f64, [north, east]: [f64; 2], bend: f64) -> Landscape {
    let d = 250.0;
    let words = |index: i32| {
        let [x, y] = [f64::from(index / 3) * d, f64::from(index % 3) * d];
        let mut words = [0.0; 9];
        words[0] = at + north * x + east * y + 0.5 * bend * x * x;
        words[3] = d * (north + bend * x);
        words[6] = d * d * bend;
        words[1] = d * east;
        words
    };
    let level = Level::new(d, [0.0, 0.0], [3, 3], (0..9).map(words).collect()).unwrap();
    Landscape::new(Bank::new("plane", vec![level], None).unwrap(), 1.0)
}

fn scenario(waypoints: Vec<Waypoint>) -> Scenario {
    let text = r#"
        format = 1
        title = "t"
        shows = "s"
        frames = 90
        landscape.generated = { seed = 1, extent_m = [500, 500], region_size_m = 50 }
        sun = { azimuth_deg = 0, elevation_deg = 10 }
        path.keyframes = [{ t_s = 0, x_m = 0, y_m = 0 }]
    "#;
    let scenario = Scenario::parse("t.toml", text).unwrap_or_else(|list| panic!("{list}"));
    Scenario { path: Path::new(waypoints).unwrap(), ..scenario }
}

fn waypoint(time: f64, x: f64, y: f64, heading_deg: Option<f64>) -> Waypoint {
    let heading = heading_deg.map(radians);
    Waypoint { time, at: [x, y], heading, eye_height: None, pitch: None, roll: None }
}

fn hz(rate: u64) -> Rate {
    Rate::new(rate, 1).unwrap()
}

const CHANNELS: &str = r#"
        format = 1
        title = "t"
        shows = "s"
        frames = 1
        landscape.generated = { seed = 1, extent_m = [500, 500], region_size_m = 50 }
        sun = { azimuth_deg = 0, elevation_deg = 10 }
        path.keyframes = [{ t_s = 0, x_m = 0, y_m = 0 }]
        channel = [{ name = "left", heading_deg = -90 }, { name = "ahead" }, { name = "up", pitch_deg = 80 }]
    "#;

/// The rows of `scenario` through each of its channels, and of its own camera first.
fn through(text: &str, landscape: &Landscape) -> Vec<scenario::PoseRow> {
    let own = scenario(vec![waypoint(0.0, 200.0, 300.0, Some(30.0))]);
    let channels = Scenario::parse("t.toml", text).unwrap_or_else(|list| panic!("{list}")).channels;
    let named = channels.iter().map(|channel| {
        Scenario { channels: channels.clone(), ..own.clone() }.through(&channel.name).unwrap()
    });
    let views = [own.clone()].into_iter().chain(named);
    let row = |view: Scenario| PoseTable::resolve(&view, landscape, hz(30), None, 0..1).unwrap().rows()[0];
    views.map(row).collect()
}

#[test]
fn a_channel_is_turned_with_the_vehicle_and_moves_as_it_does() {
    let rows = through(CHANNELS, &ground(20.0, [0.2, 0.1], 0.0));
    let [own, left, ahead, up] = rows[..] else { panic!("four rows") };
    let directions = rows.iter().map(|row| row.pose.attitude.to_terrain()).collect::<Vec<_>>();
    // What was to port is straight ahead of the left window.
    assert!((directions[1].x_axis + directions[0].y_axis).length() < 1e-15);
    assert!((directions[2].x_axis - directions[0].x_axis).length() < 1e-15);
    let (sin, cos) = quantities::sin_cos(radians(80.0));
    assert!(
        (directions[3].x_axis - (cos * directions[0].x_axis - sin * directions[0].z_axis)).length() < 1e-15
    );
    for other in [left, ahead, up] {
        let moves = |row: scenario::PoseRow| (row.pose.eye, row.speed, row.turn_rate, row.slope);
        assert_eq!(moves(other), moves(own));
    }
}

#[test]
fn a_channel_may_look_where_a_vehicle_may_not() {
    let text = CHANNELS.replace("pitch_deg = 80", "pitch_deg = -90");
    let rows = through(&text, &ground(20.0, [0.0, 0.0], 0.0));
    assert!((degrees(rows[3].pose.attitude.pitch) + 90.0).abs() < 1e-9);
}

proptest! {
    #[test]
    fn on_a_plane_the_attitude_is_that_of_the_slope(
        slopes in [-0.5..0.5f64, -0.5..0.5f64],
        heading in 0.0..360.0f64,
    ) {
        let landscape = ground(20.0, slopes, 0.0);
        let scenario = scenario(vec![waypoint(0.0, 200.0, 300.0, Some(heading))]);
        let table = PoseTable::resolve(&scenario, &landscape, hz(30), None, 0..1).unwrap();
        let pose = table.rows()[0].pose;
        let expected = Attitude::on_slope(slopes, radians(heading));
        prop_assert!((pose.attitude.pitch - expected.pitch).abs() < 1e-12);
        prop_assert!((pose.attitude.roll - expected.roll).abs() < 1e-12);
        prop_assert!((pose.attitude.heading - expected.heading).abs() < 1e-12);
        let height = 20.0 + 200.0 * slopes[0] + 300.0 * slopes[1] + 1.6334;
        prop_assert!((pose.eye[2] - height).abs() < 1e-10);
    }
}

#[test]
fn the_nose_is_up_uphill_and_starboard_down_across() {
    let landscape = ground(0.0, [0.1, 0.0], 0.0);
    let pose = |heading: f64| {
        let scenario = scenario(vec![waypoint(0.0, 250.0, 250.0, Some(heading))]);
        PoseTable::resolve(&scenario, &landscape, hz(30), None, 0..1).unwrap().rows()[0].pose.attitude
    };
    // Uphill is north: heading west has it to starboard, which is then up.
    assert!(pose(0.0).pitch > 0.09 && pose(180.0).pitch < -0.09);
    assert!(pose(270.0).roll < -0.09 && pose(90.0).roll > 0.09);
}

#[test]
fn wheels_bridge_what_lies_between_them() {
    // On h = b x^2 / 2 a secant through x - a and x + a has the slope b x, whatever the wheelbase 2 a.
    let landscape = ground(0.0, [0.0, 0.0], 0.01);
    let vehicle = Vehicle { wheelbase: 80.0, ..Vehicle::default() };
    let stand = vehicle.stand(&landscape, [100.0, 250.0], 0.0).unwrap();
    assert!((stand.slopes[0] - 1.0).abs() < 1e-12, "{:?}", stand.slopes);
    // Turned by 90 degrees the short track feels the same.
    let across = vehicle.stand(&landscape, [100.0, 250.0], radians(90.0)).unwrap();
    assert!((across.slopes[0] - 1.0).abs() < 1e-12, "{:?}", across.slopes);
    assert!((stand.ground - 50.0).abs() < 1e-10);
}

#[test]
fn any_part_of_a_table_is_the_same() {
    let landscape = ground(0.0, [0.1, 0.05], 0.0);
    let points = vec![
        waypoint(0.0, 100.0, 100.0, None),
        waypoint(1.0, 102.0, 103.0, None),
        waypoint(3.0, 108.0, 103.0, Some(10.0)),
    ];
    let scenario = scenario(points);
    let rate = Rate::new(30_000, 1001).unwrap();
    let whole = PoseTable::resolve(&scenario, &landscape, rate, None, 0..90).unwrap();
    let part = PoseTable::resolve(&scenario, &landscape, rate, None, 40..50).unwrap();
    assert_eq!(whole.rows()[40..50], *part.rows());
    assert_eq!(whole.rows()[89].pose.time, 89.0 / (30_000.0 / 1001.0));
}

#[test]
fn speed_and_turn_rate_are_those_of_the_drive() {
    // 3 m/s north up a slope of 0.75 is 3.75 m/s along the ground; 20 degrees in 4 s.
    let landscape = ground(0.0, [0.75, 0.0], 0.0);
    let points = vec![waypoint(0.0, 100.0, 100.0, Some(0.0)), waypoint(4.0, 112.0, 100.0, Some(20.0))];
    let table = PoseTable::resolve(&scenario(points), &landscape, hz(10), None, 0..40).unwrap();
    for row in table.rows() {
        assert!((row.speed - 3.75).abs() < 1e-9, "frame {}: {}", row.frame, row.speed);
        assert!((degrees(row.turn_rate) - 5.0).abs() < 1e-9, "frame {}: {}", row.frame, row.turn_rate);
    }
}

#[test]
fn the_turn_of_a_row_is_that_since_the_frame_before() {
    let landscape = ground(0.0, [0.0, 0.0], 0.0);
    let points = [0.0, 10.0, 40.0].iter().zip([0.0, 1.0, 2.0]);
    let points = points.map(|(heading, time)| waypoint(time, 100.0, 100.0, Some(*heading))).collect();
    let table = PoseTable::resolve(&scenario(points), &landscape, hz(10), None, 0..20).unwrap();
    let rows = table.rows();
    let turn = |from: usize| (rows[from + 1].pose.attitude.heading - rows[from].pose.attitude.heading) * 10.0;
    for frame in 1..20 {
        assert!((rows[frame].turn_rate - turn(frame - 1)).abs() < 1e-12, "frame {frame}");
    }
    assert!((rows[0].turn_rate - turn(0)).abs() < 1e-12);
    assert!(degrees(rows[19].turn_rate) > 1.5 * degrees(rows[1].turn_rate));
}

#[test]
fn what_the_vehicle_cannot_do_is_reported() {
    let landscape = ground(0.0, [0.1, 0.0], 0.0);
    let points = vec![
        waypoint(0.0, 100.0, 100.0, None),
        waypoint(1.0, 104.0, 100.0, None),
        waypoint(2.0, 114.0, 100.0, None),
        waypoint(3.0, 118.0, 100.0, None),
    ];
    let table = PoseTable::resolve(&scenario(points), &landscape, hz(10), None, 0..31).unwrap();
    let [report] = table.limits() else { panic!("{:?}", table.limits()) };
    assert_eq!((report.what, report.allowed), (Limit::Speed, 4.877));
    assert!(report.frames.contains(&report.frame) && (10..20).contains(&report.frame), "{report:?}");
    let text = report.to_string();
    assert!(text.starts_with("speed ") && text.contains("limit is 4.88 m/s"), "{text}");

    let steep = ground(0.0, [0.6, 0.0], 0.0);
    let spin = vec![waypoint(0.0, 100.0, 100.0, Some(0.0)), waypoint(1.0, 100.5, 100.0, Some(90.0))];
    let table = PoseTable::resolve(&scenario(spin), &steep, hz(10), None, 0..11).unwrap();
    let found: Vec<Limit> = table.limits().iter().map(|report| report.what).collect();
    assert_eq!(found, [Limit::Turn, Limit::Slope]);
}

#[test]
fn a_drive_at_the_limit_is_within_it() {
    let landscape = ground(0.0, [0.0, 0.0], 0.0);
    let points = vec![waypoint(0.0, 100.0, 100.0, None), waypoint(10.0, 148.77, 100.0, None)];
    let table = PoseTable::resolve(&scenario(points), &landscape, hz(30), None, 0..300).unwrap();
    assert_eq!(table.limits(), []);
}

#[test]
fn leaving_the_area_is_one_problem_for_all_its_frames() {
    let landscape = ground(0.0, [0.0, 0.0], 0.0);
    let points = vec![waypoint(0.0, 490.0, 250.0, None), waypoint(10.0, 510.0, 250.0, None)];
    let problems = PoseTable::resolve(&scenario(points), &landscape, hz(10), None, 0..100).unwrap_err();
    let list: Vec<_> = problems.iter().collect();
    assert_eq!(list.len(), 1, "{problems}");
    // The front wheels leave 1.15 m before the centre.
    let PoseFault::Outside { wheels, extent } = list[0].fault else { panic!("{problems}") };
    assert_eq!((wheels, extent), (true, [0.0, 0.0, 500.0, 500.0]));
    assert_eq!(list[0].frames, 45..100);
    assert!(problems.to_string().contains("frame 45 (t = 4.500 s, x = 499.00 m, y = 250.00 m): a wheel"));
}

#[test]
fn an_eye_under_ground_and_a_wild_tilt_are_refused() {
    let landscape = ground(100.0, [0.0, 0.0], 0.0);
    let low = Waypoint { eye_height: Some(99.0), ..waypoint(0.0, 100.0, 100.0, None) };
    let problems = PoseTable::resolve(&scenario(vec![low]), &landscape, hz(10), None, 0..2).unwrap_err();
    assert!(problems.to_string().contains("eye under ground, z = 99.000 m"), "{problems}");
    let stated = |pitch: f64| {
        let diving = Waypoint { pitch: Some(radians(pitch)), ..waypoint(0.0, 100.0, 100.0, None) };
        PoseTable::resolve(&scenario(vec![diving]), &landscape, hz(10), None, 0..2)
    };
    let problems = stated(-91.0).unwrap_err();
    assert!(problems.to_string().contains("pitch of -91.0 deg, expected at most 90 deg"), "{problems}");
    assert!(stated(-90.0).is_ok());
    let cliff = ground(0.0, [2.5, 0.0], 0.0);
    let standing = scenario(vec![waypoint(0.0, 100.0, 100.0, Some(0.0))]);
    let problems = PoseTable::resolve(&standing, &cliff, hz(10), None, 0..1).unwrap_err();
    assert!(problems.to_string().contains("pitch of 68.2 deg"), "{problems}");
}

/// What has no wheels on the ground may be anywhere above it, and roll as it likes: generators say what they can draw.
#[test]
fn a_flyer_may_leave_the_area_and_roll() {
    let landscape = ground(0.0, [0.0, 0.0], 0.0);
    let flyer = |x: f64, z: f64, roll: f64| Waypoint {
        eye_height: Some(z),
        pitch: Some(radians(-90.0)),
        roll: Some(radians(roll)),
        ..waypoint(0.0, x, 100.0, Some(0.0))
    };
    let resolve = |flyer| PoseTable::resolve(&scenario(vec![flyer]), &landscape, hz(10), None, 0..1);
    for (x, z, roll) in [(-1e6, 1e6, 180.0), (600.0, -50.0, -120.0), (100.0, 1e6, 90.0)] {
        let pose = resolve(flyer(x, z, roll)).unwrap().rows()[0].pose;
        assert_eq!((pose.eye, pose.attitude.roll), ([x, 100.0, z], radians(roll)));
    }
    let problems = resolve(flyer(100.0, -50.0, 0.0)).unwrap_err();
    assert!(problems.to_string().contains("eye under ground, z = -50.000 m"), "{problems}");
    let problems = resolve(flyer(100.0, 5.0, 181.0)).unwrap_err();
    assert!(problems.to_string().contains("roll of 181.0 deg, expected at most 180 deg"), "{problems}");
    // Between two rolls the way may lead over half a turn.
    let rolling = vec![flyer(100.0, 5.0, 170.0), Waypoint { time: 0.4, ..flyer(100.0, 5.0, -170.0) }];
    let table = PoseTable::resolve(&scenario(rolling), &landscape, hz(10), None, 0..5).unwrap();
    let rolls = table.rows().iter().map(|row| degrees(row.pose.attitude.roll));
    let expected: [f64; 5] = [170.0, 175.0, 180.0, -175.0, -170.0];
    for (roll, right) in rolls.zip(expected) {
        assert!(
            ((roll - right + 540.0).rem_euclid(360.0) - 180.0).abs() < 1e-9 && roll.abs() <= 180.0,
            "{roll}"
        );
    }
    for grounded in [
        Waypoint { roll: None, ..flyer(600.0, 5.0, 0.0) },
        Waypoint { pitch: None, ..flyer(600.0, 5.0, 0.0) },
    ] {
        assert!(resolve(grounded).unwrap_err().to_string().contains("the vehicle is outside"));
    }
}

#[test]
fn a_flyer_needs_no_ground_under_its_wheels() {
    let landscape = ground(0.0, [1.0, 0.0], 0.0);
    let flyer = |time, z| Waypoint {
        eye_height: Some(z),
        pitch: Some(0.1),
        roll: Some(-0.1),
        ..waypoint(time, 0.0, 0.0, Some(45.0))
    };
    let path = vec![flyer(0.0, 30.0), flyer(10.0, 50.0)];
    let table = PoseTable::resolve(&scenario(path), &landscape, hz(10), None, 0..10).unwrap();
    let row = table.rows()[5];
    assert!((row.pose.eye[2] - 31.0).abs() < 1e-12 && (row.speed - 2.0).abs() < 1e-12, "{row:?}");
    assert_eq!((row.pose.attitude.pitch, row.pose.attitude.roll), (0.1, -0.1));
    assert_eq!(table.limits(), []);
}

#[test]
fn poses_of_a_run_can_be_driven_again() {
    let landscape = ground(0.0, [0.1, 0.05], 0.0);
    let points = vec![waypoint(0.0, 100.0, 100.0, None), waypoint(3.0, 108.0, 103.0, Some(10.0))];
    let first = PoseTable::resolve(&scenario(points), &landscape, hz(30), None, 0..90).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("poses.csv"), poses_csv(&first)).unwrap();
    let text = r#"
        format = 1
        title = "again"
        shows = "the same"
        frames = 90
        landscape.generated = { seed = 1, extent_m = [500, 500], region_size_m = 50 }
        sun = { azimuth_deg = 0, elevation_deg = 10 }
        path.file = "poses.csv"
    "#;
    let name = folder.path().join("again.toml");
    let again = Scenario::parse(name.to_str().unwrap(), text).unwrap_or_else(|list| panic!("{list}"));
    let second = PoseTable::resolve(&again, &landscape, hz(30), None, 0..90).unwrap();
    for (a, b) in first.rows().iter().zip(second.rows()) {
        assert_eq!(a.pose.eye, b.pose.eye);
        assert!((a.pose.attitude.heading - b.pose.attitude.heading).abs() < 1e-14);
        assert!((a.pose.attitude.pitch - b.pose.attitude.pitch).abs() < 1e-14);
        assert!((a.pose.attitude.roll - b.pose.attitude.roll).abs() < 1e-14);
    }
}

#[test]
fn the_yoke_is_where_it_is_whatever_part_is_asked_for() {
    // Eastward over a ground that bends to the north: the vehicle rolls ever more, then turns about.
    let landscape = ground(0.0, [0.0, 0.0], 0.004);
    let points = vec![
        waypoint(0.0, 20.0, 100.0, Some(90.0)),
        waypoint(2.0, 60.0, 120.0, Some(90.0)),
        waypoint(3.0, 60.0, 121.0, Some(270.0)),
    ];
    let scenario = scenario(points);
    let yoke = Some(Yoke {
        step: radians(0.1),
        rate: radians(4.0),
        travel: radians(40.0),
        natural: None,
        damping: 1.0,
    });
    let swings = yoke.map(|yoke| Yoke { natural: Some(20.0), damping: 0.1, ..yoke });
    let resolve = |yoke, frames| PoseTable::resolve(&scenario, &landscape, hz(30), yoke, frames).unwrap();
    for yoke in [yoke, swings] {
        let whole = resolve(yoke, 0..90);
        for part in [0..7, 7..8, 8..41, 89..90] {
            let rows = &whole.rows()[part.start as usize..part.end as usize];
            assert_eq!(rows, resolve(yoke, part.clone()).rows(), "{part:?}");
        }
    }
    let (whole, swinging) = (resolve(yoke, 0..90), resolve(swings, 0..90));
    let off = whole.rows().iter().zip(swinging.rows()).map(|(a, b)| (a.pose.yoke - b.pose.yoke).abs());
    let most = off.fold(0.0, f64::max);
    assert!((radians(0.02)..radians(0.5)).contains(&most), "{}", degrees(most));
    let rows = whole.rows();
    assert!((rows[0].pose.yoke - rows[0].pose.attitude.roll).abs() <= radians(0.0501));
    let lags = rows.iter().filter(|row| (row.pose.yoke - row.pose.attitude.roll).abs() > radians(1.0));
    assert!(lags.count() > 20, "a slow yoke lags");
    for pair in rows.windows(2) {
        let moved = degrees(pair[1].pose.yoke - pair[0].pose.yoke).abs();
        assert!(moved < 0.2001, "frame {}: {moved}", pair[1].frame);
    }
    let without = PoseTable::resolve(&scenario, &landscape, hz(30), None, 0..90).unwrap();
    assert!(without.rows().iter().all(|row| row.pose.yoke == 0.0));
}
