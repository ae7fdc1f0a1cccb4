//! `docs/scenario-format.md` is true: its examples are read, its keys are all keys, each of them counts.

use std::collections::BTreeSet;
use std::fs;

use landscape::projection::{Method, Projection};
use landscape::{Bank, FileCoordinates, Level, MapFrame, Photometry, bank_file};
use quantities::radians;
use scenario::{
    GroundSource, LevelSwitch, RockArea, RollDisplay, Scenario, ShadowFineness, StarSource, StarWish,
    Sunlight,
};

const DOC: &str = include_str!("../../../../docs/scenario-format.md");

/// Whole scenarios, and pieces of them.
fn examples() -> (Vec<&'static str>, Vec<&'static str>) {
    blocks("toml").into_iter().partition(|text| text.starts_with("format"))
}

/// Contents of the fenced blocks of a language.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let starts = DOC.match_indices(&opening).map(|(at, _)| at + opening.len());
    starts.map(|start| &DOC[start..start + DOC[start..].find("```").unwrap()]).collect()
}

/// Table of a generator in the examples.
const GENERATOR: &str = "lunsim";

/// Keys in the first column of the tables, but those of a table that the page gives to one generator: the crate `registry`
/// holds them to the same page.
fn documented_keys() -> BTreeSet<&'static str> {
    let rows = DOC.lines().filter_map(|line| line.strip_prefix("| `"));
    let keys = rows.map(|row| row.split('`').next().unwrap());
    let reader = |key: &str| format!("`{}` alone reads this table", key.split('.').next().unwrap());
    keys.filter(|key| !DOC.contains(&reader(key))).collect()
}

/// A bank near the places of the documented track.
fn kepler() -> Bank {
    let [latitude, longitude] = [8.12, -38.01].map(radians);
    let projection = Projection {
        method: Method::Orthographic,
        latitude,
        longitude,
        radius: 1_737_400.0,
        offset: [0.0; 2],
    };
    let map = MapFrame {
        projection: Some(projection),
        coordinates: FileCoordinates::Metres,
        origin: [-500.0, -500.0],
        first_sample: [0.0; 2],
        spacing: [50.0; 2],
    };
    let level = Level::new(1000.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    Bank::new("Kepler", vec![level], None).unwrap().with_map(Some(map))
}

/// Parses in a folder that holds the documented path files.
fn parse(text: &str) -> Scenario {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("drive.csv"), blocks("csv")[2]).unwrap();
    fs::write(folder.path().join("drive.tum"), blocks("tum")[0]).unwrap();
    fs::write(folder.path().join("craters.csv"), blocks("csv")[0]).unwrap();
    fs::write(folder.path().join("stars.csv"), blocks("csv")[1]).unwrap();
    fs::write(folder.path().join("walk.gpx"), blocks("gpx")[0]).unwrap();
    bank_file::write(folder.path().join("kepler.bank"), &kepler()).unwrap();
    fs::write(folder.path().join("mast.obj"), blocks("obj")[0]).unwrap();
    let name = folder.path().join("s.toml");
    fs::write(&name, text).unwrap();
    let mut scenario =
        Scenario::read_beside(&name, &[GENERATOR]).unwrap_or_else(|list| panic!("{list}\n{text}"));
    // Folders differ from one parse to the next.
    scenario.path = scenario.path.named("drive");
    scenario.driven = scenario.driven.map(|driven| driven.named("driven"));
    scenario.driven_file = scenario.driven_file.map(|path| path.file_name().unwrap().into());
    scenario.notes.clear();
    scenario.path_file = scenario.path_file.map(|path| path.file_name().unwrap().into());
    if let GroundSource::Bank(path) = &mut scenario.ground {
        *path = path.file_name().unwrap().into();
    }
    for effect in &mut scenario.faces.effects {
        effect.file = effect.file.file_name().unwrap().into();
    }
    for photograph in &mut scenario.photographs {
        photograph.file = photograph.file.file_name().unwrap().into();
        photograph.camera = photograph.camera.file_name().unwrap().into();
    }
    if let Some(map) = &mut scenario.albedo_map {
        map.file = map.file.file_name().unwrap().into();
    }
    let list = scenario.features.list.iter_mut().map(|list| &mut list.file);
    for file in list.chain(scenario.objects.iter_mut().flat_map(|object| &mut object.files)) {
        *file = file.file_name().unwrap().into();
    }
    if let Some(StarWish { source: StarSource::Catalogue { file, .. }, .. }) = &mut scenario.effects.stars {
        *file = file.file_name().unwrap().into();
    }
    scenario
}

#[test]
fn all_examples_are_read() {
    let (examples, pieces) = examples();
    assert_eq!((examples.len(), pieces.len()), (10, 6));
    let drive = parse(examples[1]);
    assert_eq!(drive.path.waypoints().len(), 3);
    let tum = parse(&examples[1].replace("drive.csv", "drive.tum"));
    let first = tum.path.waypoints()[0];
    assert_eq!((first.time, first.at, first.eye_height), (0.0, [500.0, 800.0], Some(3.2)));
    let heading = first.heading.unwrap();
    assert!((heading - std::f64::consts::FRAC_PI_4).abs() < 1e-12, "{heading}");
    for piece in pieces {
        let base = examples[1].replace("bank = \"kepler.bank\"", "");
        let sunless = base.replace("[sun]\nazimuth_deg = 95\nelevation_deg = 8\n", "");
        let base = if piece.contains("[sun]") { sunless } else { base };
        let ground = "[landscape.generated]\nseed = 1\nextent_m = [2000, 2000]\nregion_size_m = 40\n";
        parse(&format!("{base}\n{ground}\n{piece}"));
    }
}

#[test]
fn the_full_landscape_reads_as_it_is_meant() {
    let scenario = parse(examples().0[2]);
    assert_eq!(scenario.coarse.as_ref().unwrap().massifs.len(), 1);
    assert_eq!(scenario.levels, Some(LevelSwitch { range: 1500.0, blend: 200.0 }));
    let craters = &scenario.features.list.as_ref().unwrap().craters;
    assert_eq!((craters.len(), craters.get(1).outer(), craters.get(2).depth()), (3, 35.0, 9.0));
    assert_eq!(scenario.features.populations[0].area, None);
    assert_eq!(scenario.features.populations[1].area, Some([400.0, 600.0, 1600.0, 1800.0]));
    assert_eq!(scenario.photometry, Photometry::Specular { strength: 0.5, exponent: 8 });
    assert_eq!(scenario.silhouettes[0].outline()[1][1], libm::tan(radians(1.4)));
    let Sunlight::Angles { drift: Some(drift), .. } = &scenario.sun else { panic!("{:?}", scenario.sun) };
    assert_eq!(drift.stations[0].0, 10.0);
    let shadows = ShadowFineness { finest: 0.2, angle: 0.8e-3, reach: Some(3000.0) };
    assert_eq!(scenario.shadows, Some(shadows));
    assert_eq!(scenario.rocks.unwrap().area, RockArea::AlongPath(60.0));
    let ids: Vec<&str> = scenario.objects.iter().map(|object| object.id.as_str()).collect();
    assert_eq!(ids, ["lm", "mast", "flag"]);
    assert!(scenario.objects[0].present && !scenario.objects[2].present);
    assert_eq!(scenario.objects[1].parts[0].vertices().len(), 5);
    let events: Vec<(f64, usize)> = scenario.events.iter().map(|event| (event.time, event.object)).collect();
    assert_eq!(events, [(2.0, 2), (5.0, 1), (8.0, 1)]);
    assert_eq!(scenario.roll, RollDisplay::Yoke);
    assert_eq!(scenario.files().len(), 3);
}

#[test]
fn a_scenario_reads_as_it_is_meant() {
    let scenario = parse(examples().0[0]);
    assert_eq!(scenario.sun.first().unwrap().azimuth, 110f64.to_radians());
    assert_eq!(scenario.vehicle, scenario::Vehicle::default());
    let field = scenario.field.of_picture(525, 315);
    assert!((field.tan_half_width - 0.466307658).abs() < 1e-9);
    assert!((field.tan_half_height - 0.267949192).abs() < 1e-9);
    assert_eq!(scenario.raster.refresh.unwrap().to_string(), "60 Hz");
    let GroundSource::Generated(relief) = &scenario.ground else { panic!("{:?}", scenario.ground) };
    assert_eq!((relief.seed, relief.extent, relief.region_size), (7, [6000.0, 6000.0], 40.0));
    assert_eq!((relief.massifs.len(), relief.rilles.len()), (1, 1));
}

/// Each key, and a change in one of the two examples that sets it to something else.
const CHANGES: &[(&str, usize, &str, &str)] = &[
    ("title", 0, "\"First light\"", "\"Second light\""),
    ("shows", 0, "\"The rover", "\"A rover"),
    ("machine", 0, "\"ideal\"", "\"pra-nominal\""),
    ("frames", 0, "frames = 90", "frames = 91"),
    ("duration_s", 1, "duration_s = 12.5", "duration_s = 12"),
    ("landscape.albedo", 0, "albedo = 0.8", "albedo = 0.9"),
    ("landscape.bank", 1, "kepler.bank", "tycho.bank"),
    ("landscape.database", 1, "bank = \"kepler.bank\"", "bank = \"kepler.bank\"\ndatabase = \"kepler.lod\""),
    ("sun.azimuth_deg", 0, "azimuth_deg = 110", "azimuth_deg = -110"),
    ("sun.elevation_deg", 0, "elevation_deg = 12", "elevation_deg = 13"),
    ("vehicle.eye_height_m", 0, "eye_height_m = 1.6334", "eye_height_m = 2"),
    ("vehicle.wheelbase_m", 0, "wheelbase_m = 2.3", "wheelbase_m = 2.4"),
    ("vehicle.track_m", 0, "track_m = 1.83", "track_m = 1.84"),
    ("vehicle.max_speed_m_s", 0, "max_speed_m_s = 4.877", "max_speed_m_s = 5"),
    ("vehicle.max_turn_deg_s", 0, "max_turn_deg_s = 10", "max_turn_deg_s = 11"),
    ("vehicle.max_slope_deg", 0, "max_slope_deg = 25", "max_slope_deg = 26"),
    ("path.keyframes", 0, "  { t_s = 0, x_m = 500, y_m = 800 },\n", ""),
    ("path.keyframes.t_s", 0, "t_s = 3", "t_s = 4"),
    ("path.keyframes.x_m", 0, "x_m = 512", "x_m = 513"),
    ("path.keyframes.y_m", 0, "y_m = 806", "y_m = 807"),
    ("path.keyframes.heading_deg", 0, "heading_deg = 40", "heading_deg = 41"),
    ("path.file", 1, "drive.csv", "drive.tum"),
    ("path.coordinates", 1, "file = \"drive.csv\"", "file = \"drive.csv\"\ncoordinates = \"file\""),
    ("path.driven", 1, "file = \"drive.csv\"", "file = \"drive.csv\"\ndriven = \"drive.csv\""),
    ("path.keyframes.z_m", 8, "z_m = 900", "z_m = 901"),
    ("path.keyframes.pitch_deg", 8, "pitch_deg = -60", "pitch_deg = -61"),
    ("path.keyframes.roll_deg", 8, "roll_deg = 2", "roll_deg = 3"),
    ("path.keyframes.lat_deg", 7, "8.1207", "8.1208"),
    ("path.keyframes.lon_deg", 7, "-38.0093", "-38.0094"),
    ("path.track", 9, "track = 1", "track = 2"),
    ("path.segment", 9, "segment = 1", "segment = 2"),
    ("path.heights", 9, "\"unused\"", "\"above-ground\""),
    ("raster.sweeps", 0, "sweeps = 525", "sweeps = 526"),
    ("raster.samples_per_sweep", 0, "samples_per_sweep = 1000", "samples_per_sweep = 999"),
    ("raster.columns", 0, "columns = 525", "columns = 526"),
    ("raster.lines", 0, "lines = 315", "lines = 316"),
    ("raster.update_hz", 0, "update_hz = 30", "update_hz = \"60/7\""),
    ("raster.refresh_hz", 0, "refresh_hz = 60", "refresh_hz = 90"),
    ("raster.field_of_view_deg", 0, "[50, 30]", "[50, 40]"),
    ("channel.name", 0, "name = \"left\"", "name = \"port\""),
    ("channel.heading_deg", 0, "heading_deg = -40", "heading_deg = -41"),
    ("channel.pitch_deg", 0, "pitch_deg = 3", "pitch_deg = 4"),
    ("channel.roll_deg", 0, "roll_deg = 1", "roll_deg = 2"),
    ("channel.field_of_view_deg", 0, "[30, 20]", "[30, 21]"),
    ("range.programme", 0, "\"two-rate\"", "\"geometric\""),
    ("range.start_m", 0, "start_m = 1.5", "start_m = 1.6"),
    ("range.end_m", 0, "end_m = 4000", "end_m = 4001"),
    ("range.switch_m", 0, "switch_m = 60", "switch_m = 61"),
    ("range.fine_share", 0, "fine_share = 0.4", "fine_share = 0.5"),
    ("laws.projection", 0, "\"exact\"", "\"as-reported\""),
    ("laws.curvature", 0, "\"parabolic\"", "\"none\""),
    ("laws.occlusion", 0, "\"peak-hold\"", "\"derivative\""),
    ("laws.pixel_rule", 0, "\"line-mean\"", "\"centre\""),
    ("display.white", 0, "white = 0.45", "white = 0.5"),
    ("display.white_magnitude", 0, "white = 0.45", "white = 0.45\nwhite_magnitude = 2"),
    ("display.gamma", 0, "gamma = 2.2", "gamma = 1"),
    ("run.scalar", 0, "\"f32\"", "\"f64\""),
    ("landscape.generated.seed", 0, "seed = 7", "seed = 8"),
    ("landscape.generated.extent_m", 0, "[6000, 6000]", "[6000, 6400]"),
    ("landscape.generated.region_size_m", 0, "region_size_m = 40", "region_size_m = 50"),
    ("landscape.generated.tilt_m_per_m", 0, "[0.01, 0.0]", "[0.01, 0.1]"),
    ("landscape.generated.undulation.rms_height_m", 0, "rms_height_m = 12", "rms_height_m = 13"),
    ("landscape.generated.undulation.hurst", 0, "hurst = 0.8", "hurst = 0.9"),
    ("landscape.generated.undulation.longest_m", 0, "longest_m = 3000", "longest_m = 3001"),
    ("landscape.generated.undulation.shortest_m", 0, "shortest_m = 160", "shortest_m = 161"),
    ("landscape.generated.undulation.waves", 0, "waves = 300", "waves = 301"),
    ("landscape.generated.craters.smallest_radius_m", 0, "smallest_radius_m = 80", "smallest_radius_m = 81"),
    ("landscape.generated.craters.largest_radius_m", 0, "largest_radius_m = 400", "largest_radius_m = 401"),
    ("landscape.generated.craters.density", 0, "density = 0.02", "density = 0.03"),
    ("landscape.generated.craters.subdued_depth_ratio", 0, "ratio = 0.04", "ratio = 0.05"),
    ("landscape.generated.craters.fresh_depth_ratio", 0, "ratio = 0.18", "ratio = 0.19"),
    ("landscape.generated.massif.at_m", 0, "[4200, 3000]", "[4200, 3001]"),
    ("landscape.generated.massif.height_m", 0, "height_m = 700", "height_m = -700"),
    ("landscape.generated.massif.radius_m", 0, "radius_m = 1300", "radius_m = 1301"),
    ("landscape.generated.massif.detail_m", 0, "detail_m = 200", "detail_m = 201"),
    ("landscape.generated.massif.ruggedness", 0, "ruggedness = 0.6", "ruggedness = 0.7"),
    ("landscape.generated.rille.through_m", 0, "[2500, 800]", "[2500, 801]"),
    ("landscape.generated.rille.azimuth_deg", 0, "azimuth_deg = 70", "azimuth_deg = 71"),
    ("landscape.generated.rille.width_m", 0, "width_m = 350", "width_m = 351"),
    ("landscape.generated.rille.depth_m", 0, "depth_m = 60", "depth_m = -60"),
    ("landscape.generated.rille.meander.swing_m", 0, "swing_m = 200", "swing_m = 201"),
    ("landscape.generated.rille.meander.length_m", 0, "length_m = 1500", "length_m = 1501"),
    ("landscape.albedo_map.file", 3, "fields.png", "meadows.png"),
    ("photograph.file", 3, "fields-above.png", "meadows.png"),
    ("photograph.camera", 3, "fields-above.json", "meadows.json"),
    ("sea.square_m", 6, "square_m = 10", "square_m = 11"),
    ("sea.area_m", 6, "[0, 0, 1000, 1200]", "[0, 0, 1000, 1210]"),
    ("sea.height_m", 6, "height_m = 1.5", "height_m = 1.6"),
    (
        "sea.pattern",
        6,
        "pattern = \"two-sine\"\nlength_m = 45\nsecond_length_m = 26\nsecond_azimuth_deg = 33",
        "pattern = \"swell\"\nlength_m = 45",
    ),
    (
        "sea.seed",
        6,
        "pattern = \"two-sine\"\nlength_m = 45\nsecond_length_m = 26\nsecond_azimuth_deg = 33",
        "pattern = \"random\"\nseed = 7",
    ),
    ("sea.length_m", 6, "\nlength_m = 45", "\nlength_m = 46"),
    ("sea.second_length_m", 6, "second_length_m = 26", "second_length_m = 27"),
    ("sea.second_azimuth_deg", 6, "azimuth_deg = 33", "azimuth_deg = 34"),
    ("sea.normals", 6, "normals = 32", "normals = 33"),
    ("sea.normals_deg", 6, "normals_deg = 72", "normals_deg = 73"),
    ("sea.state", 6, "state = 3", "state = 1"),
    ("sea.mean", 6, "mean = 0.45", "mean = \"as-reported\""),
    ("sea.colour", 6, "[0.1, 0.2, 0.3]", "[0.1, 0.2, 0.4]"),
    ("sea.waves.wind_m_s", 6, "wind_m_s = 9", "wind_m_s = 10"),
    ("sea.waves.towards_deg", 6, "towards_deg = 40", "towards_deg = 41"),
    ("sea.waves.seed", 6, "seed = 2, components", "seed = 3, components"),
    ("sea.waves.components", 6, "components = 48", "components = 49"),
    ("sea.waves.shortest_m", 6, "shortest_m = 6", "shortest_m = 7"),
    ("ship.id", 6, "id = \"lph\"", "id = \"other\""),
    ("ship.type", 6, "\"lph-2\"", "\"dd963\""),
    ("ship.x_m", 6, "x_m = 600", "x_m = 601"),
    ("ship.y_m", 6, "y_m = 500", "y_m = 501"),
    ("ship.heading_deg", 6, "heading_deg = 20", "heading_deg = 21"),
    ("ship.speed_m_s", 6, "speed_m_s = 6", "speed_m_s = 7"),
    ("ship.hull", 6, "hull = \"box\"\ngap_m = 1.2", "hull = \"wedges\""),
    ("ship.gap_m", 6, "gap_m = 1.2", "gap_m = 1.3"),
    ("ship.pitch.amplitude_deg", 6, "amplitude_deg = 4", "amplitude_deg = 5"),
    ("ship.pitch.period_s", 6, "period_s = 8", "period_s = 8.5"),
    ("ship.pitch.phase_deg", 6, "phase_deg = 10", "phase_deg = 11"),
    ("ship.roll.amplitude_deg", 6, "amplitude_deg = 6", "amplitude_deg = 7"),
    ("ship.roll.period_s", 6, "period_s = 11", "period_s = 10"),
    ("ship.roll.phase_deg", 6, "phase_deg = 20", "phase_deg = 21"),
    ("ship.heave.amplitude_m", 6, "amplitude_m = 1.1", "amplitude_m = 1.2"),
    ("ship.heave.period_s", 6, "period_s = 9", "period_s = 10"),
    ("ship.heave.phase_deg", 6, "phase_deg = 30", "phase_deg = 31"),
    ("ship.sway.amplitude_m", 6, "amplitude_m = 0.9", "amplitude_m = 0.8"),
    ("ship.sway.period_s", 6, "period_s = 12", "period_s = 13"),
    ("ship.sway.phase_deg", 6, "phase_deg = 40", "phase_deg = 41"),
    ("ship.bow_wake.height_m", 6, "height_m = 5", "height_m = 6"),
    ("ship.bow_wake.length_m", 6, "length_m = 35.5", "length_m = 36"),
    ("ship.bow_wake.lean", 6, "lean = 0.2", "lean = 0.3"),
    ("ship.bow_wake.colour", 6, "[0.9, 0.9, 0.8]", "[0.9, 0.9, 0.7]"),
    ("ship.bow_wake.frames", 6, "frames = 3 }", "frames = 4 }"),
    ("ship.stern_wake.length_m", 6, "length_m = 350", "length_m = 360"),
    ("ship.stern_wake.width_m", 6, "width_m = 24", "width_m = 25"),
    ("ship.stern_wake.detail", 6, "\"add-soft\"", "\"replace\""),
    ("ship.stern_wake.colour", 6, "[0.8, 0.9, 0.9]", "[0.7, 0.9, 0.9]"),
    ("effect.file", 6, "smoke.toml", "fire.toml"),
    ("effect.x_m", 6, "x_m = 550", "x_m = 551"),
    ("effect.y_m", 6, "y_m = 470", "y_m = 471"),
    ("effect.above_m", 6, "above_m = 3", "above_m = 4"),
    ("effect.heading_deg", 6, "heading_deg = 15", "heading_deg = 16"),
    ("effect.on", 6, "on = \"buoy\"", "on = \"vehicle\""),
    ("effect.at_m", 6, "[0.5, 0.1, 1.4]", "[0.5, 0.1, 1.5]"),
    ("plume.x_m", 6, "x_m = 540", "x_m = 541"),
    ("plume.y_m", 6, "y_m = 460", "y_m = 461"),
    ("plume.above_m", 6, "above_m = 0.2", "above_m = 0.3"),
    ("plume.heading_deg", 6, "heading_deg = 25", "heading_deg = 26"),
    ("plume.on", 6, "on = \"vehicle\"", "on = \"buoy\""),
    ("plume.at_m", 6, "[-1.3, 0.8]", "[-1.3, 0.9]"),
    ("plume.speed_m_s", 6, "speed_m_s = 3", "speed_m_s = 4"),
    ("plume.launch_deg", 6, "launch_deg = 50", "launch_deg = 51"),
    ("plume.spread_deg", 6, "spread_deg = 9", "spread_deg = 10"),
    ("plume.azimuth_deg", 6, "azimuth_deg = 170", "azimuth_deg = 171"),
    ("plume.faces", 6, "faces = 20", "faces = 21"),
    ("plume.frames", 6, "frames = 3\n", "frames = 4\n"),
    ("plume.copies", 6, "copies = 5", "copies = 6"),
    ("plume.colour", 6, "[0.5, 0.4, 0.4]", "[0.5, 0.4, 0.3]"),
    ("landscape.albedo_map.area_m", 3, "[100, 100, 300, 300]", "[100, 100, 300, 301]"),
    ("landscape.albedo_map.black", 3, "black = 0.1", "black = 0.2"),
    ("landscape.albedo_map.white", 3, "white = 0.6", "white = 0.7"),
    ("landscape.albedo_map.curve", 3, "\"linear\"", "\"srgb\""),
    ("group.name", 3, "group = \"stage\"\n", ""),
    ("group.sun.azimuth_deg", 3, "azimuth_deg = 220", "azimuth_deg = 221"),
    ("group.sun.elevation_deg", 3, "elevation_deg = 50", "elevation_deg = -50"),
    ("group.sun.rate_deg_s", 3, "rate_deg_s = 3 ", "rate_deg_s = 4 "),
    ("object.colour", 3, "[0.9, 0.2, 0.1]", "[0.9, 0.2, 0.2]"),
    ("object.photometry.law", 3, "law = \"specular\"", "law = \"lambert\""),
    ("object.photometry.strength", 3, "strength = 3", "strength = 4"),
    ("object.photometry.exponent", 3, "exponent = 20", "exponent = 21"),
    ("object.open", 3, "open = true", "open = false"),
    ("object.group", 3, "group = \"stage\"\n", ""),
    ("object.priority", 3, "priority = 2", "priority = -2"),
    ("object.moves.spin_deg_s", 3, "spin_deg_s = 30", "spin_deg_s = -30"),
    ("object.moves.keyframes.t_s", 3, "t_s = 6", "t_s = 7"),
    ("object.moves.keyframes.x_m", 3, "x_m = 161", "x_m = 162"),
    ("object.moves.keyframes.y_m", 3, "y_m = 201", "y_m = 202"),
    ("object.moves.keyframes.above_m", 3, "above_m = 2", "above_m = 3"),
    ("object.moves.keyframes.heading_deg", 3, "heading_deg = 9", "heading_deg = 8"),
    ("object.moves.keyframes.pitch_deg", 3, "pitch_deg = 4", "pitch_deg = 3"),
    ("object.moves.keyframes.roll_deg", 3, "roll_deg = 5", "roll_deg = 6"),
    ("laws.feature_light", 2, "feature_light = \"as-reported\"", "feature_light = \"combined\""),
    ("laws.body_visibility", 2, "body_visibility = \"as-reported\"", "body_visibility = \"depth\""),
    ("laws.shadowed_bodies", 2, "\"vanish\"", "\"dark\""),
    ("laws.body_shading", 2, "\"smooth\"", "\"flat\""),
    ("laws.texture_in_shadow", 2, "texture_in_shadow = \"on\"", "texture_in_shadow = \"off\""),
    ("roll.display", 2, "\"yoke\"", "\"none\""),
    ("landscape.albedo_map.file", 2, "\"maria.png\"", "\"mast.obj\""),
    ("landscape.albedo_map.area_m", 2, "[0, 0, 5000, 6000]", "[0, 0, 5000, 7000]"),
    ("landscape.albedo_map.black", 2, "black = 0.05", "black = 0.06"),
    ("landscape.albedo_map.white", 2, "white = 0.4", "white = 0.5"),
    ("landscape.albedo_map.curve", 2, "curve = \"linear\"", "curve = \"srgb\""),
    ("landscape.coarse.seed", 2, "seed = 6", "seed = 7"),
    ("landscape.coarse.extent_m", 2, "[80000, 80000]", "[80000, 81600]"),
    ("landscape.coarse.region_size_m", 2, "region_size_m = 800", "region_size_m = 400"),
    ("landscape.coarse.tilt_m_per_m", 2, "[0.001, 0.0]", "[0.001, 0.1]"),
    ("landscape.coarse.undulation", 2, "rms_height_m = 40", "rms_height_m = 41"),
    ("landscape.coarse.craters", 2, "smallest_radius_m = 1600", "smallest_radius_m = 1700"),
    ("landscape.coarse.massif", 2, "height_m = 2500", "height_m = 2600"),
    ("landscape.coarse.rille", 2, "width_m = 3600", "width_m = 3700"),
    ("levels.switch_m", 2, "switch_m = 1500", "switch_m = 1600"),
    ("levels.blend_m", 2, "blend_m = 200", "blend_m = 100"),
    ("features.list", 2, "list = \"craters.csv\"\n", ""),
    ("features.population.seed", 2, "seed = 1\n", "seed = 4\n"),
    ("features.population.kind", 2, "\"fresh\"", "\"degraded\""),
    ("features.population.density_per_m2", 2, "density_per_m2 = 0.001\n", "density_per_m2 = 0.003\n"),
    ("features.population.reference_m", 2, "reference_m = 1.5", "reference_m = 1.6"),
    ("features.population.slope", 2, "slope = 2.1", "slope = 2.3"),
    ("features.population.smallest_radius_m", 2, "smallest_radius_m = 2\n", "smallest_radius_m = 3\n"),
    ("features.population.largest_radius_m", 2, "largest_radius_m = 40", "largest_radius_m = 41"),
    ("features.population.area_m", 2, "[400, 600, 1600, 1800]", "[400, 600, 1600, 1900]"),
    (
        "features.population.primaries",
        2,
        "primaries = [{",
        "primaries = [{ x_m = 1, y_m = 2, radius_m = 3 }, {",
    ),
    ("features.population.primaries.x_m", 2, "x_m = 1000,", "x_m = 1001,"),
    ("features.population.primaries.y_m", 2, "y_m = 1200,", "y_m = 1201,"),
    ("features.population.primaries.radius_m", 2, "radius_m = 120", "radius_m = 121"),
    ("sun.drift.t_s", 2, "t_s = 10, azimuth", "t_s = 11, azimuth"),
    ("sun.drift.azimuth_deg", 2, "110.5", "110.6"),
    ("sun.drift.elevation_deg", 2, "elevation_deg = 6.5", "elevation_deg = 6.6"),
    ("sun.step_s", 2, "step_s = 2", "step_s = 3"),
    ("sun.at", 4, "22:00:00Z", "22:00:01Z"),
    ("sun.sub_solar_deg", 8, "[1.2, 41.5]", "[1.2, 41.4]"),
    ("sun.place.longitude_deg", 4, "longitude_deg = 30.77", "longitude_deg = 30.78"),
    ("sun.place.latitude_deg", 4, "latitude_deg = 20.19", "latitude_deg = 20.18"),
    ("shadows.enabled", 2, "enabled = true", "enabled = false"),
    ("shadows.finest_m", 2, "finest_m = 0.2", "finest_m = 0.3"),
    ("shadows.angle_mrad", 2, "angle_mrad = 0.8", "angle_mrad = 0.9"),
    ("shadows.reach_m", 2, "reach_m = 3000", "reach_m = 3001"),
    ("photometry.law", 2, "\"specular\"", "\"lunar-lambert\""),
    ("photometry.strength", 2, "strength = 0.5", "strength = 0.6"),
    ("photometry.exponent", 2, "exponent = 8", "exponent = 9"),
    ("texture.source", 2, "\"random\"", "\"pattern\""),
    ("texture.seed", 2, "seed = 9", "seed = 8"),
    ("texture.crater_gain", 2, "crater_gain = [1.5, 2, 0.5]", "crater_gain = [1.5, 2, 0.6]"),
    ("texture.layer.cell_m", 2, "cell_m = 0.4", "cell_m = 0.5"),
    ("texture.layer.amplitude", 2, "amplitude = 0.04", "amplitude = 0.05"),
    ("texture.layer.range_m", 2, "range_m = 60", "range_m = 61"),
    ("silhouette.reflectivity", 2, "reflectivity = 0.4", "reflectivity = 0.5"),
    ("silhouette.outline_deg", 2, "[310, 1.4]", "[310, 1.5]"),
    ("rocks.seed", 2, "[rocks]\nseed = 3", "[rocks]\nseed = 4"),
    ("rocks.density_per_m2", 2, "density_per_m2 = 0.002\nslope", "density_per_m2 = 0.003\nslope"),
    ("rocks.slope", 2, "slope = 2.2", "slope = 2.3"),
    ("rocks.smallest_m", 2, "smallest_m = 0.2", "smallest_m = 0.3"),
    ("rocks.largest_m", 2, "largest_m = 3", "largest_m = 4"),
    ("rocks.radius_m", 2, "radius_m = 60\n", "radius_m = 61\n"),
    ("rocks.area_m", 2, "radius_m = 60\n", "area_m = [1, 2, 3, 4]\n"),
    ("object.id", 2, "id = \"lm\"", "id = \"lem\""),
    ("object.model", 2, "\"lander\"", "\"rover\""),
    ("object.file", 2, "file = \"mast.obj\"", "model = \"marker\""),
    ("object.x_m", 2, "x_m = 500", "x_m = 501"),
    ("object.y_m", 2, "y_m = 800", "y_m = 801"),
    ("object.heading_deg", 2, "heading_deg = 30", "heading_deg = 31"),
    ("object.pitch_deg", 2, "pitch_deg = 2", "pitch_deg = 3"),
    ("object.roll_deg", 2, "roll_deg = -3", "roll_deg = 3"),
    ("object.scale", 2, "scale = 1.5", "scale = 1.6"),
    ("object.present", 2, "x_m = 500\n", "x_m = 500\npresent = false\n"),
    ("event.t_s", 2, "t_s = 2\n", "t_s = 3\n"),
    ("event.action", 2, "\"delete\"", "\"move\"\nx_m = 9\ny_m = 9"),
    ("event.object", 2, "\"delete\"\nobject = \"mast\"", "\"delete\"\nobject = \"lm\""),
    ("event.x_m", 2, "x_m = 507", "x_m = 506"),
    ("event.y_m", 2, "y_m = 793", "y_m = 794"),
    ("event.heading_deg", 2, "heading_deg = 15", "heading_deg = 16"),
    ("vehicle.model", 2, "[vehicle]\nmodel = \"rover\"", "[vehicle]\nmodel = \"marker\""),
    ("vehicle.file", 2, "[vehicle]\nmodel = \"rover\"", "[vehicle]\nfile = \"mast.obj\""),
    ("tracks.patch_length_m", 2, "patch_length_m = 0.2", "patch_length_m = 0.3"),
    ("tracks.patch_width_m", 2, "patch_width_m = 0.25", "patch_width_m = 0.26"),
    ("tracks.spacing_m", 2, "spacing_m = 0.35", "spacing_m = 0.36"),
    ("light.id", 5, "\"beacon\"", "\"lighthouse\""),
    ("light.x_m", 5, "x_m = 180", "x_m = 181"),
    ("light.y_m", 5, "y_m = 210", "y_m = 211"),
    ("light.above_m", 5, "above_m = 3.5", "above_m = 3"),
    (
        "light.on",
        5,
        "id = \"cart\"",
        "id = \"truck\"\nmodel = \"rover\"\nx_m = 1\ny_m = 1\n[[object]]\nid = \"cart\"",
    ),
    ("light.at_m", 5, "[1.2, 0, 0.8]", "[1.2, 0, 0.9]"),
    ("light.azimuth_deg", 5, "azimuth_deg = 75", "azimuth_deg = 76"),
    ("light.elevation_deg", 5, "elevation_deg = 22", "elevation_deg = 23"),
    ("light.magnitude", 5, "magnitude = -4.1", "magnitude = -4"),
    ("light.diameter_m", 5, "diameter_m = 0.4", "diameter_m = 0.5"),
    ("light.intensity", 5, "intensity = 2", "intensity = 3"),
    ("light.colour", 5, "[1, 0.3, 0.2]", "[1, 0.3, 0.3]"),
    ("light.priority", 5, "priority = 5", "priority = -5"),
    ("light.calligraphic", 5, "calligraphic = true", "calligraphic = false"),
    ("light.beam.heading_deg", 5, "heading_deg = 7", "heading_deg = 8"),
    ("light.beam.pitch_deg", 5, "pitch_deg = -8", "pitch_deg = 8"),
    ("light.beam.half_angle_deg", 5, "half_angle_deg = 25", "half_angle_deg = 26"),
    ("light.beam.power", 5, "power = 6", "power = 7"),
    ("light.flash.period_s", 5, "period_s = 1.5", "period_s = 1.6"),
    ("light.flash.duty", 5, "duty = 0.2", "duty = 0.3"),
    ("light.flash.phase", 5, "phase = 0.25", "phase = 0.5"),
    ("light.from_s", 5, "from_s = 0.5", "from_s = 0.6"),
    ("light.until_s", 5, "until_s = 1.75", "until_s = 1.8"),
    ("light.moves", 5, "spin_deg_s = 90", "spin_deg_s = -90"),
    ("light.count", 5, "count = 12", "count = 13"),
    ("light.to.x_m", 5, "x_m = 240", "x_m = 241"),
    ("light.to.y_m", 5, "y_m = 221", "y_m = 222"),
    ("light.to.above_m", 5, "above_m = 0.6", "above_m = 0.7"),
    ("sheet.id", 5, "\"dust\"", "\"fog\""),
    ("sheet.corners_m", 5, "[210, 230, 9], [210, 190, 9]", "[210, 230, 8], [210, 190, 8]"),
    ("sheet.height", 5, "height = \"foot\"", "height = \"datum\""),
    ("sheet.colour", 5, "[0.5, 0.45, 0.4]", "[0.5, 0.45, 0.5]"),
    ("sheet.tau", 5, "tau = 0.7", "tau = 0.8"),
    ("sheet.kappa_1_m", 5, "kappa_1_m = 0.05", "kappa_1_m = 0.06"),
    ("sheet.thickness_m", 5, "thickness_m = 11", "thickness_m = 12"),
    ("sheet.priority", 5, "priority = 4", "priority = -4"),
    ("sheet.from_s", 5, "from_s = 0.125", "from_s = 0.25"),
    ("sheet.until_s", 5, "until_s = 1.625", "until_s = 1.7"),
    ("sheet.moves", 5, "x_m = 168", "x_m = 169"),
    ("overlay.id", 5, "\"visor\"", "\"window\""),
    ("overlay.corners", 5, "[1, -0.8], [-1, -0.8]", "[1, -0.7], [-1, -0.7]"),
    ("overlay.colour", 5, "[0.2, 0.15, 0.1]", "[0.2, 0.15, 0.2]"),
    ("overlay.tau", 5, "tau = 0.35", "tau = 0.3"),
    ("overlay.priority", 5, "priority = 3", "priority = -3"),
    ("overlay.from_s", 5, "from_s = 0.375", "from_s = 0.25"),
    ("overlay.until_s", 5, "until_s = 1.875", "until_s = 2"),
    ("stars.seed", 5, "seed = 5", "seed = 6"),
    ("stars.count", 5, "count = 300", "count = 301"),
    ("stars.brightest", 5, "brightest = -1", "brightest = -2"),
    ("stars.faintest", 5, "faintest = 5.5", "faintest = 5"),
    ("stars.file", 5, "seed = 5\ncount = 300\nbrightest = -1\nfaintest = 5.5", "file = \"stars.csv\""),
    ("stars.calligraphic", 5, "calligraphic = false", "calligraphic = true"),
    ("stars.turn_deg", 5, "[20, 70, 10]", "[20, 70, 11]"),
    ("earth.azimuth_deg", 5, "azimuth_deg = 200", "azimuth_deg = 201"),
    ("earth.elevation_deg", 5, "elevation_deg = 40", "elevation_deg = 41"),
    ("earth.diameter_deg", 5, "diameter_deg = 2", "diameter_deg = 3"),
    ("earth.albedo", 5, "[0.3, 0.35, 0.5]", "[0.3, 0.35, 0.6]"),
    ("sun.disc", 5, "disc = true", "disc = false"),
];

#[test]
fn every_documented_key_changes_something() {
    let (examples, _) = examples();
    let read: Vec<Scenario> = examples.iter().map(|text| parse(text)).collect();
    for (key, example, from, to) in CHANGES {
        let text = examples[*example];
        assert_eq!(text.matches(from).count(), 1, "{key}: {from} stands once in the example");
        assert_ne!(parse(&text.replace(from, to)), read[*example], "{key} changes nothing");
    }
}

#[test]
fn the_tables_name_every_key_and_no_other() {
    let mut tried: BTreeSet<&str> = CHANGES.iter().map(|change| change.0).collect();
    tried.insert("format");
    assert_eq!(documented_keys(), tried);
    // Keys that the reader asks for stand in its message about an unknown one.
    let tables = [
        "",
        "landscape",
        "landscape.generated",
        "landscape.coarse",
        "landscape.albedo_map",
        "levels",
        "features",
        "photometry",
        "texture",
        "sun",
        "shadows",
        "rocks",
        "stars",
        "earth",
        "tracks",
        "vehicle",
        "path",
        "raster",
        "laws",
        "roll",
        "display",
        "run",
    ];
    for table in tables {
        let text = format!("{}\n{table}{}stray = 1\n", "format = 1", if table.is_empty() { "" } else { "." });
        let list = Scenario::parse("t.toml", &text).unwrap_err();
        let stray = list.iter().find(|problem| problem.title.starts_with("unknown key")).unwrap().clone();
        let expected = stray.expected.unwrap();
        let prefix = if table.is_empty() { String::new() } else { format!("{table}.") };
        for key in expected.trim_start_matches("one of ").trim_start_matches("only ").split(", ") {
            let path = format!("{prefix}{key}");
            let is_documented = documented_keys().iter().any(|known| {
                *known == path || known.strip_prefix(&path).is_some_and(|rest| rest.starts_with('.'))
            });
            assert!(is_documented, "`{path}` is a key that the page does not name");
        }
    }
}

#[test]
fn what_is_left_out_has_the_documented_default() {
    let scenario = parse(examples().0[1]);
    assert_eq!((scenario.machine.as_str(), scenario.albedo), ("ideal", 1.0));
    assert_eq!((scenario.display.white, scenario.display.gamma), (1.0, 1.0));
    assert_eq!(scenario.scalar, scenario::Scalar::F32);
    assert_eq!(scenario.raster, scenario::RasterWishes::default());
    assert_eq!(scenario.laws, scenario::LawWishes::default());
    assert_eq!(scenario.range, None);
    assert_eq!((scenario.photometry, scenario.roll), (Photometry::Lambert, RollDisplay::None));
    let none = scenario::EffectWishes { white_magnitude: -1.46, ..Default::default() };
    assert_eq!(scenario.effects, none);
    assert_eq!((&scenario.features, scenario.shadows), (&scenario::CraterWishes::default(), None));
    assert!(scenario.objects.is_empty() && scenario.rocks.is_none() && scenario.tracks.is_none());
    assert_eq!(scenario.files().len(), 2);
}
