//! Paths that people and programs bring: what they come to in the axes of the bank, what is noted, what is refused.

mod gpx;

use std::f64::consts::FRAC_PI_2;
use std::fs;
use std::path::Path as FilePath;

use landscape::projection::{Method, Projection};
use landscape::{Bank, FileCoordinates, Level, MapFrame, bank_file};
use quantities::{Rate, degrees, radians};
use scenario::{HeightOver, Overrides, Scenario};

const RADIUS: f64 = 1_737_400.0;

/// A scenario over generated ground of 400 m, or over the bank `ground.bank`.
fn text(path: &str, over_bank: bool) -> String {
    let ground = match over_bank {
        true => "[landscape]\nbank = \"ground.bank\"\n",
        false => "[landscape.generated]\nseed = 1\nextent_m = [400, 400]\nregion_size_m = 40\n",
    };
    format!(
        "format = 1\ntitle = \"T\"\nshows = \"T.\"\nframes = 4\n{ground}[sun]\nazimuth_deg = 100\nelevation_deg = 20\n[path]\n{path}"
    )
}

/// A bank of 1 km whose origin lies at 150 km north and -15 km east of a polar map, or of a map in degrees.
fn bank(map: Option<MapFrame>) -> Bank {
    let level = Level::new(500.0, [0.0; 2], [3, 3], vec![[0.0; 9]; 9]).unwrap();
    Bank::new("ground", vec![level], None).unwrap().with_map(map)
}

fn map(method: Method, latitude: f64, origin: [f64; 2], coordinates: FileCoordinates) -> MapFrame {
    let projection = Projection { method, latitude, longitude: 0.0, radius: RADIUS, offset: [0.0; 2] };
    MapFrame { projection: Some(projection), coordinates, origin, first_sample: [0.0; 2], spacing: [10.0; 2] }
}

fn polar() -> MapFrame {
    let method = Method::PolarStereographic { scale: 1.0 };
    map(method, -FRAC_PI_2, [150_000.0, -15_000.0], FileCoordinates::Metres)
}

fn equator() -> MapFrame {
    map(
        Method::Equirectangular { parallel: 0.0 },
        0.0,
        [RADIUS * radians(1.0), RADIUS * radians(2.0)],
        FileCoordinates::Degrees,
    )
}

/// Reads a scenario whose path file is `name` with `bytes`; `keys` are further lines of `[path]`.
fn read_over(ground: Option<&Bank>, name: &str, bytes: &[u8], keys: &str) -> Result<Scenario, Vec<String>> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), bytes).unwrap();
    if let Some(bank) = ground {
        bank_file::write(folder.path().join("ground.bank"), bank).unwrap();
    }
    let toml = text(&format!("file = \"{name}\"\n{keys}"), ground.is_some());
    Scenario::parse(folder.path().join("s.toml").to_str().unwrap(), &toml).map_err(|list| {
        let line = |problem: &diagnostics::Problem| {
            let line = problem.record().line.map(|line| format!("{line} ")).unwrap_or_default();
            format!("{line}{}", problem.title)
        };
        list.iter().map(line).collect()
    })
}

fn read(name: &str, text: &str) -> Scenario {
    read_over(None, name, text.as_bytes(), "").unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

fn faults(name: &str, text: &str) -> Vec<String> {
    read_over(None, name, text.as_bytes(), "").expect_err(text)
}

/// Notes without the name of the file.
fn notes(scenario: &Scenario) -> Vec<&str> {
    scenario.notes.iter().map(|note| note.split_once(": ").map_or(note.as_str(), |(_, rest)| rest)).collect()
}

fn places(scenario: &Scenario) -> Vec<(f64, [f64; 2])> {
    scenario.path.waypoints().iter().map(|waypoint| (waypoint.time, waypoint.at)).collect()
}

/// `shared/cases/22-path-csv-epoch-times`, and its kin.
#[test]
fn times_since_1970_drive() {
    let rows = |times: [&str; 4]| {
        let row = |(index, time): (usize, &&str)| format!("{time},{},200\n", 100 + index);
        times.iter().enumerate().map(row).collect::<String>()
    };
    let expected = [0.0, 1.0, 2.0, 3.0].map(|time| (time, [100.0 + time, 200.0]));
    let epoch = ["1700000000", "1700000001", "1700000002", "1700000003"];
    let thousandths = epoch.map(|time| format!("{time}000"));
    for (name, times) in [
        ("t_s", epoch),
        ("t_ms", thousandths.each_ref().map(String::as_str)),
        ("t_s", ["100000000", "100000001", "100000002", "100000003"]),
        (
            "t_s",
            ["2026-11-26T22:00:00Z", "2026-11-26T22:00:01Z", "2026-11-26T22:00:02Z", "2026-11-26T22:00:03Z"],
        ),
        (
            "t_utc",
            ["2026-12-31T23:59:59", "2027-01-01T00:00:00", "2027-01-01 00:00:01.0", "2027-01-01T00:00:02"],
        ),
    ] {
        let read = read("drive.csv", &format!("{name},x_m,y_m\n{}", rows(times)));
        assert_eq!(places(&read), expected, "{times:?}");
        assert!(notes(&read)[0].contains("times count from the first row"), "{:?}", read.notes);
        assert_eq!(read.path_beside_mission(Rate::new(1, 1).unwrap()), None);
    }
    let plain = read("drive.csv", &format!("t_s,x_m,y_m\n{}", rows(["0", "1", "2", "3"])));
    assert_eq!((places(&plain), notes(&plain)), (expected.to_vec(), vec![]));
    let tum = read("drive.tum", "1700000000.5 1 2 -3 0 0 0 1\n1700000001.5 2 2 -3 0 0 0 1\n");
    assert_eq!(places(&tum), [(0.0, [1.0, 2.0]), (1.0, [2.0, 2.0])]);
    assert!(notes(&tum)[0].contains("times count from the first row"), "{:?}", tum.notes);
    assert_eq!(notes(&read("drive.tum", "1000 1 2 -3 0 0 0 1\n1001 2 2 -3 0 0 0 1\n")), [""; 0]);
    // Half the times since 1970, and thousandths of a second called seconds.
    assert_eq!(faults("drive.csv", "t_s,x_m,y_m\n0,1,2\n1700000000,2,2\n").len(), 1);
    assert_eq!(faults("drive.csv", "t_s,x_m,y_m\n1700000000000,1,2\n1700000001000,2,2\n").len(), 2);
}

#[test]
fn times_that_do_not_rise_are_refused_with_their_line() {
    for (rows, line) in [
        ("0,1,2\n1,2,2\n1,3,2\n", "4 t = 1 s after t = 1 s"),
        ("0,1,2\n1,2,2\n1,2,2\n1,3,2\n", "5 t = 1 s after t = 1 s"),
        ("0,1,2\n2,2,2\n1,3,2\n3,4,2\n", "4 t = 1 s after t = 2 s"),
        ("1700000005,1,2\n1700000004,2,2\n", "3 t = -1 s after t = 0 s"),
        ("2026-01-01T00:00:01Z,1,2\n2026-01-01T01:00:01+01:00,2,2\n", "3 t = 0 s after t = 0 s"),
    ] {
        let found = faults("drive.csv", &format!("t_s,x_m,y_m\n{rows}"));
        assert!(found.len() == 1 && found[0].starts_with(line), "{found:?}");
    }
    // What stands there twice is there once.
    let twice = read("p.csv", "t_s,x_m,y_m\n0,1,2\n1,2,2\n1,2,2\n1,2,2\n2,3,2\n");
    assert_eq!(places(&twice), [(0.0, [1.0, 2.0]), (1.0, [2.0, 2.0]), (2.0, [3.0, 2.0])]);
    assert!(notes(&twice)[0].contains("2 points repeat the one before"), "{:?}", twice.notes);
}

#[test]
fn a_path_beside_the_mission_is_told() {
    let update = Rate::new(1, 1).unwrap();
    let told = |rows: &str| read("p.csv", &format!("t_s,x_m,y_m\n{rows}")).path_beside_mission(update);
    assert!(told("-9,1,2\n-3,2,2\n").unwrap().contains("before the mission begins"));
    assert!(told("-9,1,2\n0,2,2\n").unwrap().contains("before the mission begins"));
    assert!(told("3,1,2\n9,2,2\n").unwrap().contains("the last frame is at t = 3.000 s"));
    assert!(told("5000,1,2\n5001,2,2\n").unwrap().contains("begins at t = 5000 s"));
    for quiet in ["0,1,2\n", "-9,1,2\n1,2,2\n", "2.5,1,2\n9,2,2\n", "0,1,2\n0.5,2,2\n", "-1,1,2\n"] {
        assert_eq!(told(quiet), None, "{quiet}");
    }
}

/// `shared/cases/27-path-standstill-quadratic`: a path of that kind took minutes when a halt was searched from row to row.
#[test]
fn a_long_halt_is_read_in_time_that_grows_with_it() {
    let mut text = String::from("t_s,x_m,y_m\n0,90,200\n");
    (0..200_000).for_each(|row| text += &format!("{:.2},100,200\n", 10.0 + 0.01 * f64::from(row)));
    let path = read("still.csv", &text).path;
    let heading = |time: f64| path.at(time).heading;
    assert!((0..10_000).all(|frame| heading(10.0 + 0.2 * f64::from(frame)) == 0.0));
    // A halt at the start looks whither the vehicle will go.
    let waits: String = (0..50_000).map(|row| format!("{},100,200\n", row)).collect();
    let path = read("still.csv", &format!("t_s,x_m,y_m\n{waits}60000,100,300\n")).path;
    assert!((path.at(1.0).heading - FRAC_PI_2).abs() < 1e-9);
}

#[test]
fn angles_are_in_the_unit_of_their_name() {
    let headings = |text: &str| {
        let read = read("p.csv", text);
        read.path.waypoints().iter().map(|waypoint| degrees(waypoint.heading.unwrap())).collect::<Vec<f64>>()
    };
    for text in [
        "t_s,x_m,y_m,heading_deg\n0,1,2,90\n1,1,3,45\n",
        "t_s,x_m,y_m,heading_rad\n0,1,2,1.5707963267948966\n1,1,3,0.7853981633974483\n",
        "T_S;X_M;Y_M;Heading_Rad\n0;1;2;1,5707963267948966\n1;1;3;0,7853981633974483\n",
        "t_s,x_m,y_m,qx,qy,qz,qw\n0,1,2,0,0,0.7071067811865476,0.7071067811865476\n1,1,3,0,0,0.3826834323650898,0.9238795325112867\n",
        "qw,qz,qy,qx,t_s,x_m,y_m\n0.7071067811865476,0.7071067811865476,0,0,0,1,2\n0.9238795325112867,0.3826834323650898,0,0,1,1,3\n",
    ] {
        let found = headings(text);
        assert!((found[0] - 90.0).abs() < 1e-9 && (found[1] - 45.0).abs() < 1e-9, "{text}: {found:?}");
    }
    for (text, said) in [
        ("t_s,x_m,y_m,q0,q1,q2,q3\n0,1,2,0,0,0,1\n", "unknown column `q0`"),
        ("0,1,2,-3,0,0,0,1\n1,1,2,-3,0,0,0,1\n", "a first row of numbers, not of names"),
        ("t_s,x_m,y_m,qx,qy,qz\n0,1,2,0,0,0\n", "a quaternion of fewer than four columns"),
        ("t_s,x_m,y_m,qx,qy,qz,qw,heading_deg\n0,1,2,0,0,0,1,5\n", "a quaternion and angles"),
        ("t_s,x_m,y_m,qx,qy,qz,qw\n0,1,2,0,0,0,2\n", "a quaternion of length 2"),
        ("t_s,x_m,y_m,heading_deg,heading_rad\n0,1,2,0,0\n", "say the same"),
    ] {
        let found = faults("p.csv", text);
        assert!(found[0].contains(said), "{text}: {found:?}");
    }
    let order = "# t tx ty tz qw qx qy qz\n0 1 2 -3 1 0 0 0\n";
    assert!(faults("p.tum", order)[0].contains("in another order"));
    let parts = order.replace("qw qx qy qz", "quaternion (W, X, Y, Z)");
    assert!(faults("p.tum", &parts)[0].contains("in another order"));
    assert!(
        read("p.tum", &order.replace("qw qx qy qz", "qx qy qz qw").replace("1 0 0 0", "0 0 0 1"))
            .notes
            .is_empty()
    );
}

#[test]
fn degrees_that_look_like_radians_are_told() {
    let told = |rows: &str| {
        let read = read("p.csv", &format!("t_s,x_m,y_m,heading_deg\n{rows}"));
        read.notes.iter().any(|note| note.contains("heading_rad"))
    };
    // East, in radians; a turn on the spot; a drive to the south-west.
    assert!(told("0,1,1,1.5708\n1,1,2,1.5708\n2,1,3,1.5708\n"));
    assert!(told("0,1,1,0\n1,1,1,1.5\n2,1,1,3.1\n3,1,1,6.2\n"));
    assert!(told("0,9,9,-2.36\n1,8,8,-2.36\n2,7,7,-2.36\n"));
    // North with a few degrees, more than 2 pi, a single row, all zero.
    assert!(!told("0,1,1,3\n1,2,1.05,3\n2,3,1.1,3\n"));
    assert!(!told("0,1,1,3\n1,1,1,6\n2,1,1,9\n"));
    assert!(!told("0,1,1,3\n"));
    assert!(!told("0,1,1,0\n1,1,2,0\n"));
}

#[test]
fn angles_in_the_other_unit_are_told() {
    let told =
        |name: &str, rows: &str| notes(&read("p.csv", &format!("t_s,x_m,y_m,{name}\n{rows}"))).join("; ");
    // East, in degrees under a header of radians; beyond a turn under either.
    assert!(
        told("heading_rad", "0,1,1,90\n1,1,2,90\n").contains("heading_rad goes up to 90, more than 2 pi")
    );
    assert!(told("heading_deg", "0,1,1,450\n1,1,2,450\n").contains("heading_deg goes up to 450"));
    // A few degrees from north, either side.
    let north = "0,1,1,2\n1,9,1.3,2.5\n2,18,1,-2\n3,26,1,0\n";
    assert!(told("heading_rad", north).contains("only if they are those of a column heading_deg"));
    assert_eq!(told("heading_deg", north), "");
    assert_eq!(told("heading_rad", "0,1,1,1.5708\n1,1,2,1.5708\n"), "");
    assert_eq!(told("heading_deg,pitch_deg", "0,1,1,90,-3\n1,1,2,90,3\n"), "");
}

#[test]
fn roll_that_no_picture_shows_is_told() {
    let told = |roll: [&str; 2], keys: &str| {
        let rows = format!("0,1,1,90,{}\n1,1,2,90,{}\n", roll[0], roll[1]);
        let file = format!("t_s,x_m,y_m,heading_deg,roll_deg\n{rows}");
        notes(&read_over(None, "p.csv", file.as_bytes(), keys).unwrap()).join("; ")
    };
    assert!(told(["0", "-3"], "").contains("roll_deg turns no picture"));
    assert_eq!(told(["0", "0"], ""), "");
    for display in ["yoke", "none"] {
        assert_eq!(told(["0", "-3"], &format!("[roll]\ndisplay = \"{display}\"\n")), "");
    }
}

#[test]
fn headings_across_the_way_are_told() {
    let told = |rows: &str| {
        let read = read("p.csv", &format!("t_s,x_m,y_m,heading_deg\n{rows}"));
        notes(&read).join("; ")
    };
    // Headings from east, anticlockwise, on a bend: or x and y exchanged.
    let bend = "0,10,10,20\n1,13.4,19.4,20\n2,19.8,27.1,40\n3,26.2,34.8,40\n";
    let compass = "0,10,10,70\n1,13.4,19.4,70\n2,19.8,27.1,50\n3,26.2,34.8,50\n";
    assert_eq!(told(compass), "");
    assert!(told("0,10,10,0\n1,10,20,0\n2,10,30,0\n").contains("exchanged"));
    assert!(told("0,10,10,-80\n1,11,5,-80\n2,12,0,-80\n").is_empty());
    assert!(told("0,10,10,160\n1,20,10,160\n2,30,10,160\n").is_empty(), "backwards");
    let across = "0,10,10,100\n1,20,10,80\n2,30,10,100\n";
    assert!(
        told(across).contains("exchanged") || told(across).contains("across its way"),
        "{}",
        told(across)
    );
    assert!(told("0,10,10,135\n1,20,20,135\n2,30,30,135\n").contains("across its way"));
    assert!(told("0,10,10,-90\n1,20,10,-80\n2,30,10,-100\n").contains("across its way"));
    // Only one leg of two.
    assert_eq!(told("0,10,10,90\n1,20,10,90\n2,20,30,90\n3,20,50,90\n"), "");
    // From east, anticlockwise: 45 degrees are the same in both, so the bend is near enough to be let pass.
    assert!(!told(bend).contains("exchanged"));
}

#[test]
fn heights_name_what_they_count_from() {
    let of = |text: &str| {
        let path = read("p.csv", text).path;
        (path.height_over(), path.waypoints()[0].eye_height)
    };
    assert_eq!(of("t_s,x_m,y_m,z_m\n0,1,2,30\n"), (HeightOver::Datum, Some(30.0)));
    assert_eq!(of("t_s,x_m,y_m,height_m\n0,1,2,30\n"), (HeightOver::Ground, Some(30.0)));
    assert_eq!(of("t_s,x_m,y_m\n0,1,2\n"), (HeightOver::Datum, None));
    assert!(faults("p.csv", "t_s,x_m,y_m,z_m,height_m\n0,1,2,3,4\n")[0].contains("both say how high"));
    assert!(faults("p.csv", "t_s,x_m,y_m,height_m\n0,1,2,-4\n")[0].contains("`height_m` must be"));
}

#[test]
fn shipped_scenarios_are_beyond_doubt() {
    let folder = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("../../../scenarios");
    let mut read = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let scenario = Scenario::read_beside(&path, &["faces", "lod", "lunsim", "panels"])
            .unwrap_or_else(|list| panic!("{list}"));
        let update = scenario.raster.update.unwrap_or(Rate::new(30, 1).unwrap());
        assert_eq!(
            (&scenario.notes[..], scenario.path_beside_mission(update)),
            (&[][..], None),
            "{}",
            path.display()
        );
        read += 1;
    }
    assert!(read > 10, "{read} scenarios");
}

/// A place of the polar map, by the closed form, in degrees.
fn polar_degrees(place: [f64; 2]) -> [f64; 2] {
    polar().point(place).unwrap().map(degrees)
}

#[test]
fn places_come_into_the_axes_of_the_bank() {
    let expected = [[100.0, 200.0], [130.0, 260.0]];
    let near = |scenario: &Scenario| {
        let found = places(scenario);
        found
            .iter()
            .zip(expected)
            .all(|((_, at), place)| (at[0] - place[0]).abs() < 1e-6 && (at[1] - place[1]).abs() < 1e-6)
    };
    let rows = |name: &str, places: [[f64; 2]; 2]| {
        format!("t_s,{name}\n0,{},{}\n1,{},{}\n", places[0][0], places[0][1], places[1][0], places[1][1])
    };
    let over = |map: MapFrame, name: &str, text: &str, keys: &str| {
        read_over(Some(&bank(Some(map))), name, text.as_bytes(), keys)
            .unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
    };
    let lon_lat = expected.map(polar_degrees);
    let turned = lon_lat.map(|[latitude, longitude]| [longitude, latitude]);
    let in_file = expected.map(|[x, y]| [x + 150_000.0, y - 15_000.0]);
    for (text, keys) in [
        (rows("x_m,y_m", expected), ""),
        (rows("x_m,y_m", expected), "coordinates = \"bank\"\n"),
        (rows("lat_deg,lon_deg", lon_lat), ""),
        (rows("lon_deg,lat_deg", turned), "coordinates = \"lon-lat\"\n"),
        (rows("lat_rad,lon_rad", lon_lat.map(|pair| pair.map(radians))), "coordinates = \"lon-lat\"\n"),
        (rows("x_m,y_m", in_file), "coordinates = \"file\"\n"),
        (rows("northing_m,easting_m", in_file), "coordinates = \"file\"\n"),
    ] {
        let read = over(polar(), "p.csv", &text, keys);
        assert!(near(&read), "{text}{keys}: {:?}", places(&read));
    }
    let [[lat0, lon0], [lat1, lon1]] = expected.map(|place| equator().point(place).unwrap().map(degrees));
    assert!((lat0 - 1.0).abs() < 0.01 && (lon0 - 2.0).abs() < 0.01);
    assert!(near(&over(equator(), "p.csv", &rows("lat_deg,lon_deg", [[lat0, lon0], [lat1, lon1]]), "")));
    let tum = "0 150100 -14800 -3 0 0 0 1\n1 150130 -14740 -3 0 0 0 1\n";
    assert!(near(&over(polar(), "p.tum", tum, "coordinates = \"file\"\n")));
}

#[test]
fn keyframes_have_the_coordinates_of_files() {
    let folder = tempfile::tempdir().unwrap();
    bank_file::write(folder.path().join("ground.bank"), &bank(Some(polar()))).unwrap();
    let read = |path: &str| {
        let name = folder.path().join("s.toml");
        Scenario::parse(name.to_str().unwrap(), &text(path, true)).map_err(|list| list.to_string())
    };
    let [latitude, longitude] = polar_degrees([100.0, 200.0]);
    let on_sphere = format!("t_s = 0, lat_deg = {latitude}, lon_deg = {longitude}, heading_deg = 10");
    let waypoint =
        |path: &str| read(path).unwrap_or_else(|said| panic!("{path}: {said}")).path.waypoints()[0];
    let lon_lat = waypoint(&format!("coordinates = \"lon-lat\"\nkeyframes = [{{ {on_sphere} }}]\n"));
    assert!((lon_lat.at[0] - 100.0).abs() < 1e-6 && (lon_lat.at[1] - 200.0).abs() < 1e-6, "{lon_lat:?}");
    assert!((degrees(lon_lat.heading.unwrap()) - 10.0 - longitude).abs() < 1e-4);
    let in_file = "coordinates = \"file\"\nkeyframes = [{ t_s = 0, x_m = 150100, y_m = -14800 }]\n";
    assert_eq!(waypoint(in_file).at, [100.0, 200.0]);
    let mixed = read(&format!("keyframes = [{{ {on_sphere} }}]\n")).unwrap_err();
    assert!(
        mixed.contains("unknown key `path.keyframes[0].lat_deg`") || mixed.contains("lat_deg"),
        "{mixed}"
    );
    assert!(read("coordinates = \"lon-lat\"\nkeyframes = []\n").is_err());
}

#[test]
fn headings_on_the_sphere_count_from_true_north() {
    let [latitude, longitude] = polar_degrees([0.0, 0.0]);
    let text = format!("t_s,lat_deg,lon_deg,heading_deg\n0,{latitude},{longitude},10\n");
    let read = read_over(Some(&bank(Some(polar()))), "p.csv", text.as_bytes(), "").unwrap();
    // Longitude 0 runs up from the south pole, so true north turns with the longitude.
    let heading = degrees(read.path.waypoints()[0].heading.unwrap());
    assert!((heading - 10.0 - longitude).abs() < 1e-4, "{heading}");
    let text = "t_s,x_m,y_m,heading_deg\n0,150000,-15000,10\n";
    let read =
        read_over(Some(&bank(Some(polar()))), "p.csv", text.as_bytes(), "coordinates = \"file\"\n").unwrap();
    assert_eq!(read.path.waypoints()[0].heading, Some(radians(10.0)));
}

#[test]
fn coordinates_that_lead_nowhere_are_refused() {
    let lon_lat = "t_s,lat_deg,lon_deg\n0,1,2\n";
    let in_plane = "t_s,x_m,y_m\n0,1,2\n";
    let unknown = MapFrame { projection: None, ..polar() };
    for (ground, name, text, keys, said) in [
        (None, "p.csv", lon_lat, "", "over generated ground"),
        (None, "p.csv", in_plane, "coordinates = \"file\"\n", "over generated ground"),
        (Some(None), "p.csv", lon_lat, "", "does not say where it came from"),
        (Some(Some(unknown)), "p.csv", lon_lat, "", "names no known projection"),
        (Some(Some(equator())), "p.csv", in_plane, "coordinates = \"file\"\n", "is in degrees"),
        (Some(Some(polar())), "p.csv", lon_lat, "coordinates = \"file\"\n", "columns of other coordinates"),
        (
            Some(Some(polar())),
            "p.csv",
            in_plane,
            "coordinates = \"lon-lat\"\n",
            "columns of other coordinates",
        ),
        (
            Some(Some(polar())),
            "p.csv",
            "t_s,lat_deg,lon_deg\n0,91,2\n",
            "",
            "`lat_deg` must be a number from -90 to 90",
        ),
        (Some(Some(polar())), "p.csv", "t_s,lat_deg,lon_deg\n0,90,2\n", "", "does not show"),
        (Some(Some(polar())), "p.csv", "t_s,lat_deg\n0,9\n", "", "missing column `lon_deg`"),
        (
            Some(Some(polar())),
            "p.tum",
            "0 1 2 3 0 0 0 1\n",
            "coordinates = \"lon-lat\"\n",
            "a TUM file has places in metres",
        ),
        (Some(Some(polar())), "p.csv", in_plane, "coordinates = \"utm\"\n", "must be one of"),
        (Some(Some(polar())), "p.csv", in_plane, "heights = \"above-ground\"\n", "without a GPX file"),
    ] {
        let bank = ground.map(bank);
        let found = read_over(bank.as_ref(), name, text.as_bytes(), keys).expect_err(text);
        assert!(found.iter().any(|title| title.contains(said)), "{text}{keys}: {found:?}");
    }
    let keyframes = text("keyframes = [{ t_s = 0, x_m = 50, y_m = 80 }]\ncoordinates = \"file\"\n", false);
    let found = Scenario::parse("s.toml", &keyframes).unwrap_err().to_string();
    assert!(found.contains("over generated ground"), "{found}");
    // The bank of the command line takes the place of the scenario's.
    let folder = tempfile::tempdir().unwrap();
    let other = folder.path().join("other.bank");
    bank_file::write(&other, &bank(Some(equator()))).unwrap();
    fs::write(folder.path().join("p.csv"), lon_lat).unwrap();
    let name = folder.path().join("s.toml");
    fs::write(&name, text("file = \"p.csv\"\n", true)).unwrap();
    let over = |bank: Option<&FilePath>| Scenario::read_over(&name, &[], Overrides { sets: &[], bank });
    assert!(over(None).unwrap_err().to_string().contains("ground.bank"));
    let at = over(Some(&other)).unwrap().path.waypoints()[0].at;
    assert!(at.iter().all(|place| place.abs() < 1e-6), "{at:?}");
}

/// From 100 km to the ground by latitude, longitude, altitude and attitude: as a file, by keyframes, and in the axes of the bank.
#[test]
fn a_descent_has_places_of_the_sphere_and_altitudes() {
    let ground = bank(Some(equator()));
    let rows = [
        (0.0, [1.001, 2.002], 100_000.0, [10.0, -90.0, 0.0]),
        (50.0, [1.003, 2.001], 20_000.0, [20.0, -80.0, 3.0]),
        (90.0, [1.004, 2.003], 12.5, [30.0, -5.0, -2.0]),
    ];
    let degree = RADIUS * radians(1.0);
    let file = |head: &str, at: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let row = |(time, place, height, [heading, pitch, roll]): (f64, [f64; 2], f64, [f64; 3])| {
            let [a, b] = at(place);
            format!("{time},{a},{b},{height},{heading},{pitch},{roll}\n")
        };
        let text = format!("{head}\n{}", rows.map(row).concat());
        read_over(Some(&ground), "p.csv", text.as_bytes(), "").unwrap_or_else(|e| panic!("{text}: {e:?}"))
    };
    let sphere = file("t_s,lat_deg,lon_deg,altitude_m,heading_deg,pitch_deg,roll_deg", &|place| place);
    let plane = file("t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg", &|[latitude, longitude]| {
        [(latitude - 1.0) * degree, (longitude - 2.0) * degree]
    });
    let frames = rows.map(|(time, [latitude, longitude], height, [heading, pitch, roll])| {
        format!(
            "{{ t_s = {time:?}, lat_deg = {latitude:?}, lon_deg = {longitude:?}, z_m = {height:?}, heading_deg = {heading:?}, \
             pitch_deg = {pitch:?}, roll_deg = {roll:?} }}"
        )
    });
    let folder = tempfile::tempdir().unwrap();
    bank_file::write(folder.path().join("ground.bank"), &ground).unwrap();
    let keyframes = format!("coordinates = \"lon-lat\"\nkeyframes = [{}]\n", frames.join(", "));
    let name = folder.path().join("s.toml");
    let keyed = Scenario::parse(name.to_str().unwrap(), &text(&keyframes, true)).unwrap();
    assert_eq!(keyed.path.height_over(), HeightOver::Datum);
    for step in 0..=90 {
        let [sphere, plane, keyed] =
            [&sphere, &plane, &keyed].map(|scenario| scenario.path.at(f64::from(step)));
        for other in [plane, keyed] {
            let apart = [0, 1].map(|axis| (sphere.at[axis] - other.at[axis]).abs());
            assert!(apart.iter().all(|apart| *apart < 1e-6), "{step} s: {apart:?} m");
            assert_eq!(
                (sphere.eye_height, sphere.pitch, sphere.roll),
                (other.eye_height, other.pitch, other.roll)
            );
            assert!((sphere.heading - other.heading).abs() < 1e-12);
        }
    }
    let partly = keyframes.replacen(", z_m = 20000.0", "", 1);
    let refused = Scenario::parse(name.to_str().unwrap(), &text(&partly, true)).unwrap_err().to_string();
    assert!(refused.contains("z_m is given for some waypoints only"), "{refused}");
    let twice = "t_s,lat_deg,lon_deg,altitude_m,height_m\n0,1,2,3,4\n";
    let refused = read_over(Some(&ground), "p.csv", twice.as_bytes(), "").unwrap_err();
    assert!(refused[0].contains("`altitude_m` and `height_m` both say"), "{refused:?}");
}

#[test]
fn exchanged_coordinates_are_told() {
    let over = |map: MapFrame, text: &str, keys: &str| {
        let read = read_over(Some(&bank(Some(map))), "p.csv", text.as_bytes(), keys).unwrap();
        notes(&read).join("; ")
    };
    let file = "coordinates = \"file\"\n";
    assert!(over(polar(), "t_s,x_m,y_m\n0,-14800,150100\n1,-14740,150130\n", file).contains("exchanged"));
    assert!(
        over(polar(), "t_s,northing_m,easting_m\n0,-14800,150100\n1,-14800,150200\n", file)
            .contains("exchanged")
    );
    assert!(
        over(equator(), "t_s,lat_deg,lon_deg\n0,2.01,1.01\n1,2.02,1.02\n", "")
            .contains("latitude and longitude exchanged")
    );
    assert_eq!(over(polar(), "t_s,x_m,y_m\n0,150100,-14800\n1,150130,-14740\n", file), "");
    assert_eq!(over(polar(), "t_s,x_m,y_m\n0,1,2\n1,3,4\n", file), "");
}
