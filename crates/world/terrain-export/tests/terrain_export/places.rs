//! Scenarios over an export by places of the sphere: a descent from 100 km, and the sun of the landscape. The export that ships.

use landscape::{Landscape, bank_file};
use quantities::{Rate, degrees, radians};
use scenario::{Pose, PoseTable, Scenario, Scenery};
use terrain_export::{Exported, Wishes, write_folder};

use crate::{USUAL, bare, exported, ground};

/// Time (s), latitude and longitude (deg), altitude (m), heading, pitch and roll (deg).
const DESCENT: [(f64, [f64; 2], f64, [f64; 3]); 4] = [
    (0.0, [26.001, 3.035], 100_000.0, [0.0, -90.0, 0.0]),
    (20.0, [26.02, 3.002], 41_000.0, [350.0, -90.0, 0.0]),
    (50.0, [26.015, 3.01], 900.0, [355.0, -60.0, 4.0]),
    (60.0, [26.018, 3.0205], 12.0, [10.0, -3.0, -1.0]),
];

/// Rate of the poses.
fn rate() -> Rate {
    Rate::new(10, 1).unwrap()
}

#[test]
fn a_descent_by_latitude_longitude_and_altitude_is_the_same_in_the_axes_of_the_bank() {
    let (ground, exported) = exported(USUAL);
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("built");
    write_folder(&exported, &out).unwrap();
    let bank = bank_file::read(out.join("ground.bank")).unwrap();
    let landscape = Landscape::new(bank, 1.0);
    let frame = ground.description().frame;
    let [[south, west], _] = ground.description().grid.extent();
    let in_bank = |[latitude, longitude]: [f64; 2]| {
        let [north, east] = frame.forward(radians(latitude), radians(longitude));
        [north - south, east - west]
    };
    let poses = |name: &str, head: &str, place: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let row = |(time, at, height, [heading, pitch, roll]): (f64, [f64; 2], f64, [f64; 3])| {
            let [a, b] = place(at);
            format!("{time},{a},{b},{height},{heading},{pitch},{roll}\n")
        };
        std::fs::write(out.join(name), format!("{head}\n{}", DESCENT.map(row).concat())).unwrap();
        let text = format!(
            "format = 1\ntitle = \"Descent\"\nshows = \"A descent.\"\nduration_s = 60\n[landscape]\nbank = \"ground.bank\"\n\
             database = \"terrain.lod\"\n[sun]\nsub_solar_deg = [1.5, 80.0]\n[path]\nfile = \"{name}\"\n"
        );
        let scenario = Scenario::parse(out.join("s.toml").to_str().unwrap(), &text)
            .unwrap_or_else(|list| panic!("{list}"));
        let table =
            PoseTable::resolve(&scenario, &landscape, rate(), None, 0..601).unwrap_or_else(|e| panic!("{e}"));
        let poses: Vec<Pose> = table.rows().iter().map(|row| row.pose).collect();
        (scenario, poses)
    };
    let angles = "heading_deg,pitch_deg,roll_deg";
    let (scenario, sphere) = poses("a.csv", &format!("t_s,lat_deg,lon_deg,altitude_m,{angles}"), &|at| at);
    let (_, plane) = poses("b.csv", &format!("t_s,x_m,y_m,z_m,{angles}"), &in_bank);
    assert_eq!((sphere.len(), sphere[0].eye[2], sphere[600].eye[2]), (601, 100_000.0, 12.0));
    let apart =
        |(a, b): (&Pose, &Pose)| (0..3).map(|axis| (a.eye[axis] - b.eye[axis]).abs()).fold(0.0, f64::max);
    let worst = sphere.iter().zip(&plane).map(apart).fold(0.0, f64::max);
    println!("{worst:.1e} m apart at most");
    assert!(worst < 1e-3, "{worst} m");
    for (a, b) in sphere.iter().zip(&plane) {
        let [a, b] = [a, b].map(|pose| pose.attitude);
        assert_eq!((a.pitch, a.roll), (b.pitch, b.roll));
        assert!((a.heading - b.heading).abs() < 1e-12);
    }
    // The sun of the scenario is the one that made the light map, at the centre of the area.
    let scenery = Scenery::of(&scenario, &landscape, rate()).unwrap_or_else(|e| panic!("{e}"));
    let sun = scenery.sun(0.0);
    let light = ground.description().light.unwrap();
    let lit = ephemeris::sun_direction(frame.centre(), light.sub_solar);
    let [elevation, azimuth] = ephemeris::elevation_and_azimuth(lit).map(degrees);
    // The bank's own place is the middle of its stored regions, a part of a region beside the centre of the area.
    assert!((degrees(sun.elevation) - elevation).abs() < 0.002, "{sun:?}, {elevation}");
    assert!((degrees(sun.azimuth) - azimuth).abs() < 0.002, "{sun:?}, {azimuth}");
}

/// Files of the scenario `built-ground`, which ship beside their landscape.
const SHIPPED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios/built-ground");

#[test]
fn the_files_of_built_ground_are_the_export_of_its_landscape() {
    let text = std::fs::read_to_string(format!("{SHIPPED}/landscape.toml")).unwrap();
    let wishes = Wishes { step: Some(0.001), ..USUAL };
    let exported = Exported::new(&ground(&text), &bare(), &text, wishes, &mut |_| {}).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("built");
    write_folder(&exported, &out).unwrap();
    let boulders = (0..9).map(|number| format!("boulders/{number}.obj"));
    let files = ["craters.csv", "ground.bank", "ground.bank.toml", "terrain.lod"].map(str::to_owned);
    for file in files.into_iter().chain(boulders) {
        let [made, shipped] = [out.join(&file), std::path::Path::new(SHIPPED).join(&file)]
            .map(|path| std::fs::read(path).unwrap());
        assert!(made == shipped, "{file} is not what `lunoid terrain export` makes of landscape.toml");
    }
}

/// The scenario of an export has the sun of its light map, wherever the bank has its middle.
#[test]
fn the_scenario_has_the_sun_of_the_landscape() {
    let (ground, exported) = exported(USUAL);
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("built");
    write_folder(&exported, &out).unwrap();
    let scenario = Scenario::read(out.join("scenario.toml")).unwrap_or_else(|list| panic!("{list}"));
    let bank = bank_file::read(out.join("ground.bank")).unwrap();
    let landscape = Landscape::new(bank, 0.5);
    let sun = Scenery::of(&scenario, &landscape, rate()).unwrap_or_else(|e| panic!("{e}")).sun(0.0);
    let centre = ground.description().frame.centre();
    let lit = ephemeris::sun_direction(centre, ground.description().light.unwrap().sub_solar);
    let [elevation, azimuth] = ephemeris::elevation_and_azimuth(lit);
    assert!((sun.elevation - elevation).abs() < 1e-9 && (sun.azimuth - azimuth).abs() < 1e-9, "{sun:?}");
    assert!(exported.scenario.contains("sub_solar_deg = [1.5, 80]"), "{}", exported.scenario);
}
