//! One drive in three files over one place in three: places, times and poses are the same to the millimetre.
//!
//! The drive takes ten minutes at 100 Hz. Every stop tries its first minute alone. The drive is written as CSV with times since 1970,
//! as GPX and as TUM. The place is a cell of made heights, written as DTED, as PDS4 and as GeoTIFF.

mod place;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use landscape::{Attitude, Bank, Landscape, bank_file};
use quantities::{Rate, radians};
use scenario::{Pose, PoseTable, Scenario};
use survey::{Area, Plane, ReadOptions, SurveyOptions, survey};

/// Middle of the area (degrees) and its size (m).
const MIDDLE: [f64; 2] = [10.5, 20.5];
const SIZE: f64 = 8_000.0;
/// Sphere that stands for the Earth in all formats (m).
const EARTH: f64 = 6_378_137.0;
/// Rows of a minute of the drive, 0.01 s apart.
const MINUTE: u32 = 6_000;
/// 2026-11-26T22:00:00Z, by `date -u -d 2026-11-26T22:00:00Z +%s`.
const START: u64 = 1_795_730_400;

/// Latitude and longitude of the drive (degrees): a bend and a swing, up to 2 m/s.
fn drive(time: f64) -> [f64; 2] {
    let metre = 1.0 / (EARTH * radians(1.0));
    let (north, east) = (1.5 * time - 450.0, 200.0 * libm::sin(0.005 * time));
    [MIDDLE[0] + north * metre, MIDDLE[1] + east * metre / libm::cos(radians(MIDDLE[0]))]
}

/// Place in the bank (m), by the closed form of an equirectangular plane about the middle.
fn in_bank([latitude, longitude]: [f64; 2]) -> [f64; 2] {
    let [north, east] = [latitude - MIDDLE[0], longitude - MIDDLE[1]].map(radians);
    [0.5 * SIZE + EARTH * north, 0.5 * SIZE + EARTH * libm::cos(radians(MIDDLE[0])) * east]
}

fn csv(minutes: u32) -> String {
    let row = |row: u32| {
        let [latitude, longitude] = drive(0.01 * f64::from(row));
        let time = format!("{}.{:02}", START + u64::from(row / 100), row % 100);
        format!("{time},{latitude:.12},{longitude:.12}\n")
    };
    (0..=minutes * MINUTE).fold(String::from("t_s,lat_deg,lon_deg\n"), |text, index| text + &row(index))
}

fn gpx(minutes: u32) -> String {
    let mut text = String::from("<gpx xmlns=\"http://www.topografix.com/GPX/1/1\"><trk><trkseg>\n");
    for row in 0..=minutes * MINUTE {
        let [latitude, longitude] = drive(0.01 * f64::from(row));
        let (minute, second) = (row / MINUTE, 0.01 * f64::from(row % MINUTE));
        let time = format!("2026-11-26T22:{minute:02}:{second:05.2}Z");
        writeln!(
            text,
            "<trkpt lat=\"{latitude:.12}\" lon=\"{longitude:.12}\"><ele>7</ele><time>{time}</time></trkpt>"
        )
        .expect("a text takes all");
    }
    text + "</trkseg></trk></gpx>\n"
}

/// Rows of poses, in the frame of TUM files: z down, quaternions by half angles.
fn tum(poses: &[Pose]) -> String {
    let mut text = String::new();
    for (row, pose) in poses.iter().enumerate() {
        let Attitude { roll, pitch, heading } = pose.attitude;
        let [(sr, cr), (sp, cp), (sy, cy)] =
            [roll, pitch, heading].map(|angle| (libm::sin(0.5 * angle), libm::cos(0.5 * angle)));
        let [qx, qy, qz, qw] = [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ];
        let [x, y, z] = pose.eye;
        let time = format!("{}.{:02}", START + row as u64 / 100, row % 100);
        writeln!(text, "{time} {x:.6} {y:.6} {:.6} {qx:.9} {qy:.9} {qz:.9} {qw:.9}", -z)
            .expect("a text takes all");
    }
    text
}

/// The bank of the area in an elevation file.
fn bank(file: &Path) -> Bank {
    let elevation = survey::read(file, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    let [latitude, longitude] = MIDDLE.map(radians);
    let area = Area::Centred { latitude, longitude, size: [SIZE; 2], plane: Plane::Equirectangular };
    let options = SurveyOptions { area, held_out: 0.0, ..SurveyOptions::new(2_000.0) };
    survey(&elevation, &options, &mut |_| {}).unwrap_or_else(|error| panic!("{error}")).bank
}

/// Poses at `update` frames a second of the path of `minutes` in `file`, over the bank that lies beside it.
fn poses(folder: &Path, file: &str, minutes: u32, ground: &Bank, update: u64) -> Vec<Pose> {
    let text = format!(
        "format = 1\ntitle = \"T\"\nshows = \"T.\"\nduration_s = {}\n[landscape]\nbank = \"place.bank\"\n[sun]\n\
         azimuth_deg = 100\nelevation_deg = 15\n[path]\nfile = \"{file}\"\n",
        60 * minutes
    );
    let scenario = Scenario::parse(folder.join("s.toml").to_str().expect("a plain name"), &text);
    let scenario = scenario.unwrap_or_else(|list| panic!("{list}"));
    let update = Rate::new(update, 1).expect("a rate");
    let landscape = Landscape::new(ground.clone(), 1.0);
    let table = PoseTable::resolve(&scenario, &landscape, update, None, 0..scenario.frames(update));
    table.unwrap_or_else(|problems| panic!("{problems}")).rows().iter().map(|row| row.pose).collect()
}

/// Largest distance of two eyes (m), and largest turn between two attitudes (rad).
fn apart(a: &[Pose], b: &[Pose]) -> [f64; 2] {
    assert_eq!(a.len(), b.len());
    let distance = |(a, b): (&Pose, &Pose)| {
        let square: f64 = a.eye.iter().zip(b.eye).map(|(a, b)| (a - b) * (a - b)).sum();
        let angles = |pose: &Pose| [pose.attitude.roll, pose.attitude.pitch, pose.attitude.heading];
        let turn =
            angles(a).iter().zip(angles(b)).map(|(a, b)| libm::sin(0.5 * (a - b)).abs()).fold(0.0, f64::max);
        [square.sqrt(), 2.0 * turn]
    };
    a.iter()
        .zip(b)
        .map(distance)
        .fold([0.0; 2], |most, found| [0, 1].map(|index: usize| most[index].max(found[index])))
}

#[test]
fn a_minute_is_the_same_in_every_file() {
    expect_one_drive(1);
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn a_drive_is_the_same_in_every_file() {
    expect_one_drive(10);
}

fn expect_one_drive(minutes: u32) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("cell.dt0"), place::dted()).unwrap();
    fs::write(at("cell.tif"), place::geotiff()).unwrap();
    fs::write(at("cell.xml"), place::pds4()).unwrap();
    fs::write(at("cell.dat"), place::samples()).unwrap();
    fs::write(at("drive.csv"), csv(minutes)).unwrap();
    fs::write(at("drive.gpx"), gpx(minutes)).unwrap();
    let mut first: Option<Vec<Pose>> = None;
    for file in ["cell.dt0", "cell.xml", "cell.tif"] {
        let ground = bank(&at(file));
        bank_file::write(at("place.bank"), &ground).unwrap();
        let fine = poses(folder.path(), "drive.csv", minutes, &ground, 100);
        fs::write(at("drive.tum"), tum(&fine)).unwrap();
        let [by_csv, by_gpx, by_tum] = ["drive.csv", "drive.gpx", "drive.tum"]
            .map(|file| poses(folder.path(), file, minutes, &ground, 10));
        assert_eq!(by_csv.len(), 600 * minutes as usize);
        for (frame, pose) in by_csv.iter().enumerate() {
            let [x, y] = in_bank(drive(0.1 * frame as f64));
            assert!(
                (pose.eye[0] - x).abs() < 1e-3 && (pose.eye[1] - y).abs() < 1e-3,
                "{frame}: {pose:?}, {x} {y}"
            );
        }
        for (name, other) in
            [("GPX", &by_gpx), ("TUM", &by_tum), ("the other bank", first.get_or_insert(by_csv.clone()))]
        {
            let [distance, turn] = apart(&by_csv, other);
            println!("{file}, {name}: {distance:.1e} m, {turn:.1e} rad");
            assert!(distance < 1e-3 && turn < 1e-5, "{file}, {name}: {distance} m, {turn} rad");
        }
    }
}
