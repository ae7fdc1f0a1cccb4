//! A drive that grows has the poses of a path with the same waypoints, to the bit.

use landscape::{Attitude, Bank, Landscape, Level};
use quantities::{Rate, degrees, radians, unit_interval};
use scenario::{Driven, DrivenError, Path, Pose, PoseTable, Scenario, Waypoint, Yoke};

const TEXT: &str = r#"
format = 1
title = "t"
shows = "s"
frames = 40
landscape.generated = { seed = 1, extent_m = [500, 500], region_size_m = 50 }
sun = { azimuth_deg = 0, elevation_deg = 10 }
path.keyframes = [{ t_s = 0, x_m = 0, y_m = 0 }]
channel = [{ name = "port", heading_deg = -70, pitch_deg = 5 }]
"#;

/// Ground that rises by a tenth to the north.
fn slope() -> Landscape {
    let d = 250.0;
    let words = |index: i32| {
        let mut words = [0.0; 9];
        (words[0], words[3]) = (0.1 * d * f64::from(index / 3), 0.1 * d);
        words
    };
    let level = Level::new(d, [0.0, 0.0], [3, 3], (0..9).map(words).collect()).unwrap();
    Landscape::new(Bank::new("plane", vec![level], None).unwrap(), 1.0)
}

fn yoke() -> Yoke {
    Yoke {
        step: radians(0.05),
        rate: radians(15.0),
        travel: radians(40.0),
        natural: Some(60.0),
        damping: 0.15,
    }
}

fn scenario() -> Scenario {
    Scenario::parse("t.toml", TEXT).unwrap_or_else(|list| panic!("{list}"))
}

/// Eye and attitude of a frame: more than whole turns, on uneven degrees.
fn told(frame: u64) -> ([f64; 3], Attitude) {
    let random = |key: u64| unit_interval(11, &[frame, key]) - 0.5;
    let eye = [250.0 + 100.0 * random(0), 250.0 + 100.0 * random(1), 60.0 + 9.0 * random(2)];
    let [heading, pitch, roll] = [1700.0 * random(3), 50.0 * random(4), 120.0 * random(5)].map(radians);
    (eye, Attitude { heading, pitch, roll })
}

/// The poses of `count` frames of a drive that grows, and those of its path.
fn both(scenario: &Scenario, update: Rate, yoke: Option<Yoke>, count: u64) -> [Vec<Pose>; 2] {
    let landscape = slope();
    let mut driven = Driven::new(scenario, update, yoke);
    let mut waypoints = Vec::new();
    let mut poses = Vec::new();
    for frame in 0..count {
        let (eye, attitude) = told(frame);
        let Attitude { heading, pitch, roll } = attitude;
        let (heading, pitch, roll) = (Some(heading), Some(pitch), Some(roll));
        let at = [eye[0], eye[1]];
        waypoints.push(Waypoint { time: driven.time(), at, heading, eye_height: Some(eye[2]), pitch, roll });
        poses.push(driven.push(&landscape, eye, attitude).unwrap());
    }
    assert_eq!(driven.frames(), count);
    waypoints.push(Waypoint { time: driven.time(), ..waypoints[waypoints.len() - 1] });
    let replayed = Scenario { driven: Some(Path::new(waypoints).unwrap()), ..scenario.clone() };
    let table = PoseTable::resolve(&replayed, &landscape, update, yoke, 0..count).unwrap();
    [poses, table.rows().iter().map(|row| row.pose).collect()]
}

#[test]
fn poses_are_those_of_the_path_to_the_bit() {
    for update in [Rate::new(30, 1).unwrap(), Rate::new(30_000, 1001).unwrap(), Rate::new(7, 1).unwrap()] {
        for yoke in [None, Some(yoke())] {
            let [grown, path] = both(&scenario(), update, yoke, 40);
            assert_eq!(grown, path);
            assert_eq!(grown.iter().any(|pose| pose.yoke != 0.0), yoke.is_some());
        }
    }
}

#[test]
fn poses_through_a_channel_too() {
    let through = scenario().through("port").unwrap();
    let [grown, path] = both(&through, Rate::new(30, 1).unwrap(), Some(yoke()), 20);
    assert_eq!(grown, path);
    assert_ne!(grown, both(&scenario(), Rate::new(30, 1).unwrap(), Some(yoke()), 20)[0]);
}

#[test]
fn what_is_refused_is_not_driven() {
    let landscape = slope();
    let mut driven = Driven::new(&scenario(), Rate::new(30, 1).unwrap(), Some(yoke()));
    let (eye, attitude) = told(0);
    let first = driven.clone().push(&landscape, eye, attitude).unwrap();
    let under = driven.push(&landscape, [eye[0], eye[1], 1.0], attitude).unwrap_err();
    assert!(
        matches!(&under, DrivenError::Problems(problems) if problems.to_string().contains("eye under ground"))
    );
    let none = driven.push(&landscape, [f64::NAN, eye[1], eye[2]], attitude).unwrap_err();
    assert!(matches!(none, DrivenError::Waypoint(_)));
    assert_eq!((driven.frames(), driven.push(&landscape, eye, attitude).unwrap()), (0, first));
}

#[test]
fn a_vehicle_stands_on_the_ground_or_flies() {
    let (landscape, driven) = (slope(), Driven::new(&scenario(), Rate::new(30, 1).unwrap(), None));
    let stood = driven.stand(&landscape, [200.0, 250.0], 0.0, None).unwrap();
    let height = scenario().vehicle.eye_height;
    assert!((stood.eye[2] - 20.0 - height).abs() < 1e-9);
    assert!((degrees(stood.attitude.pitch) - degrees(libm::atan(0.1))).abs() < 1e-6);
    let flown = driven.stand(&landscape, [200.0, 250.0], 1.0, Some(90.0)).unwrap();
    assert_eq!(
        (flown.eye, flown.attitude),
        ([200.0, 250.0, 90.0], Attitude { heading: 1.0, pitch: 0.0, roll: 0.0 })
    );
    assert!(driven.stand(&landscape, [-50.0, 250.0], 0.0, None).is_err());
}

/// A frame without a row of its own would stand still, or drive at another speed.
#[test]
fn what_was_driven_has_a_row_a_frame() {
    let row = |time: f64| Waypoint {
        time,
        at: [100.0 + time, 100.0],
        heading: Some(0.0),
        eye_height: None,
        pitch: None,
        roll: None,
    };
    let resolve = |times: &[f64]| {
        let driven = Path::new(times.iter().map(|time| row(*time)).collect()).unwrap();
        let scenario = Scenario { driven: Some(driven), ..scenario() };
        PoseTable::resolve(&scenario, &slope(), Rate::new(2, 1).unwrap(), None, 0..4)
    };
    assert_eq!(resolve(&[0.0, 0.5, 1.0, 1.5]).unwrap().rows().len(), 4);
    let said = resolve(&[0.0, 0.5]).unwrap_err().to_string();
    assert!(said.contains("no row of this time, expected one pose a frame"), "{said}");
    assert_eq!(resolve(&[0.0, 1.0, 1.5]).unwrap_err().iter().next().unwrap().frames, 1..2);
}
