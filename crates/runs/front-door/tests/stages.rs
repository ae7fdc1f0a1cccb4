//! Scenarios on their ground: what fits is there, what does not is told.

use std::fs;
use std::path::Path;

use control_plane::MachineStage;
use front_door::{StageError, Wishes, open};
use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, LevelSwitch, LevelTurn, ShadowCache};
use landscape::Photometry;
use scenario::{Scenario, ShadowFineness};
use signal::Probe;

const GOOD: &str = r#"format = 1
title = "t"
shows = "s"
frames = 90
[landscape]
albedo = 0.7
[landscape.generated]
seed = 1
extent_m = [600, 640]
region_size_m = 40
[sun]
azimuth_deg = 10
elevation_deg = 12
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 300 }, { t_s = 100, x_m = 500, y_m = 300 }]
"#;

const POPULATION: &str = "[[features.population]]\nseed = 1\nkind = 'fresh'\ndensity_per_m2 = 0.01\n\
                          smallest_radius_m = 2\nlargest_radius_m = 20\n";

const COARSE: &str = "[landscape.coarse]\nseed = 2\nextent_m = [4600, 4800]\nregion_size_m = 200\n\
                      massif = [{ at_m = [300, -1000], height_m = 200, radius_m = 1300, detail_m = 620 }]\n\
                      [levels]\nswitch_m = 250\nblend_m = 20\n";

fn build_in(folder: &Path, tables: &str) -> Result<MachineStage, StageError> {
    let name = folder.join("t.toml");
    let scenario = Scenario::parse(name.to_str().unwrap(), &format!("{GOOD}\n{tables}"));
    let scenario = scenario.unwrap_or_else(|list| panic!("{list}"));
    let settings = front_door::settings(&scenario, &HardwareModel::ideal()).unwrap();
    front_door::build(&scenario, settings)
}

fn build(tables: &str) -> Result<MachineStage, StageError> {
    build_in(Path::new(""), tables)
}

#[test]
fn a_plain_scenario_is_terrain_alone() {
    let stage = build("").unwrap();
    assert!(stage.landscape.features().is_empty() && stage.landscape.texture().is_none());
    assert_eq!((stage.landscape.albedo(), *stage.landscape.photometry()), (0.7, Photometry::Lambert));
    let settings = &stage.settings;
    assert_eq!((settings.yoke, settings.levels, settings.shadows), (None, None, None));
}

#[test]
fn what_the_scenario_says_stands_in_the_settings() {
    let tables = format!(
        "{COARSE}[roll]\ndisplay = 'yoke'\n[shadows]\nfinest_m = 0.5\n[laws]\ntexture_in_shadow = 'off'\n"
    );
    let settings = build(&tables).unwrap().settings;
    assert_eq!(settings.yoke, Some(HardwareModel::ideal().yoke));
    assert_eq!(settings.levels, Some(LevelSwitch { range: 250.0, blend: 20.0 }));
    let fineness = ShadowFineness { finest: 0.5, ..ShadowFineness::default() };
    assert_eq!(settings.shadows, Some(fineness));
    assert_eq!(settings.laws.texture_in_shadow, scenario::TextureInShadow::Off);
    assert_eq!(build("[shadows]\nenabled = false\n").unwrap().settings.shadows, None);
}

#[test]
fn a_coarse_level_lies_around_the_fine_one() {
    let stage = build(COARSE).unwrap();
    let levels = stage.landscape.bank().levels();
    assert_eq!(levels.len(), 2);
    assert_eq!(levels[1].extent(), [-2000.0, -2080.0, 2600.0, 2720.0]);
    // The far mountain is in both: no step where they share a corner.
    let fine = stage.landscape.height(200.0, 120.0).unwrap();
    let (region, local) = levels[1].locate(200.0, 120.0).unwrap();
    let coarse = levels[1].height_and_slopes(region, local)[0];
    assert!(fine.abs() > 0.001 && (fine - coarse).abs() < 1e-9, "{fine} {coarse}");
    assert!(stage.landscape.height(300.0, -1000.0).unwrap() > 150.0);
}

/// A machine that looks at turns needs the poses before, whatever else it remembers.
#[test]
fn a_switch_that_minds_turns_has_the_course() {
    let of = |tables: &str, level_turn: LevelTurn| {
        let scenario = Scenario::parse("t.toml", &format!("{GOOD}\n{tables}")).unwrap();
        let ideal = HardwareModel { level_turn, ..HardwareModel::ideal() };
        let settings = front_door::settings(&scenario, &ideal).unwrap();
        front_door::build(&scenario, settings).unwrap().scenery.course().len()
    };
    let minds = LevelTurn { rate: 0.1, share: 0.5 };
    assert_eq!([of(COARSE, minds), of(COARSE, LevelTurn::NEVER), of("", minds)], [90, 0, 0]);
}

#[test]
fn craters_of_a_list_come_first() {
    let folder = tempfile::tempdir().unwrap();
    let list = "x_m,y_m,radius_m,depth_m,rim_m,type\n300,300,10,2,0,1\n# far\n320,310,20,5,1,2\n";
    fs::write(folder.path().join("c.csv"), list).unwrap();
    let stage = build_in(folder.path(), &format!("[features]\nlist = 'c.csv'\n{POPULATION}")).unwrap();
    let craters = stage.landscape.features().craters();
    assert!(craters.len() > 100, "{}", craters.len());
    assert_eq!((craters.get(0).centre(), craters.get(1).centre()), ([300.0, 300.0], [320.0, 310.0]));
    let [low, high] = [[0.0, 0.0], [600.0, 640.0]];
    assert!(craters.iter().all(|crater| (0..2).all(|axis| {
        crater.centre()[axis] - crater.outer() >= low[axis]
            && crater.centre()[axis] + crater.outer() <= high[axis]
    })));
}

#[test]
fn craters_over_the_edge_are_named_by_row() {
    let folder = tempfile::tempdir().unwrap();
    let list = "x_m,y_m,radius_m,depth_m,rim_m,type\n300,300,10,2,0,1\n595,300,10,2,0,1\n5,5,10,2,0,1\n";
    fs::write(folder.path().join("c.csv"), list).unwrap();
    let text = build_in(folder.path(), "[features]\nlist = 'c.csv'\n").unwrap_err().to_string();
    let words = ["c.csv: row 2", "x = 595 m, y = 300 m", "x 0..600 m, y 0..640 m", "so are 1 others"];
    assert!(words.iter().all(|word| text.contains(word)), "{text}");
}

#[test]
fn what_cannot_be_strewn_is_told() {
    for (tables, expected) in [
        (
            format!("{POPULATION}area_m = [0, 0, 700, 600]\n"),
            "population]] 1: craters outside the problem area",
        ),
        (POPULATION.replace("= 20", "= 400"), "largest radius 400 m"),
        (POPULATION.replace("0.01", "1e5"), "craters: expected at most"),
        (
            "[[object]]\nid = 'a'\nmodel = 'flag'\nx_m = 9000\ny_m = 0\n".into(),
            "object \"a\" at t = 0 s: x = 9000.00 m",
        ),
    ] {
        let text = build(&tables).unwrap_err().to_string();
        assert!(text.contains(expected), "{tables}: {text}");
    }
}

#[test]
fn a_bank_of_one_level_has_nothing_to_go_over_to() {
    let scenario = Scenario::parse("t.toml", &format!("{GOOD}{COARSE}")).unwrap();
    let settings = front_door::settings(&scenario, &HardwareModel::ideal()).unwrap();
    let one = front_door::bank(&Scenario { coarse: None, ..scenario.clone() }).unwrap();
    let refused = front_door::over(one, &scenario, settings);
    assert!(matches!(refused, Err(StageError::OneLevel)), "{refused:?}");
}

#[test]
fn texture_lies_over_the_regions() {
    let stage =
        build("[texture]\nsource = 'pattern'\nlayer = [{ cell_m = 1, amplitude = 0.1, range_m = 50 }]\n");
    let stage = stage.unwrap();
    assert_eq!(stage.landscape.texture().unwrap().reach(), 50.0);
}

/// A picture of 2 x 1 pixels, the west one of code 128, the east one white.
fn with_map(picture: picture::AnyPicture, keys: &str) -> Result<MachineStage, StageError> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("map.png"), picture.encode_png(&[]).unwrap()).unwrap();
    let tables = format!("[landscape.albedo_map]\nfile = 'map.png'\n{keys}");
    build_in(folder.path(), &tables)
}

#[test]
fn a_picture_is_a_map_of_albedo() {
    let grey = || picture::GreyPicture::new(2, 1, picture::Depth::Eight, vec![128, 255]).unwrap().into();
    let stage = with_map(grey(), "").unwrap();
    let srgb = picture::Curve::Srgb.light(128.0 / 255.0) as f32;
    let map = stage.landscape.albedo_map().unwrap();
    assert_eq!(map.area(), [0.0, 0.0, 600.0, 640.0]);
    assert_eq!(stage.landscape.albedo_at(300.0, 160.0), [f64::from(srgb); 3]);
    assert_eq!(stage.landscape.albedo_at(300.0, 480.0), [1.0; 3]);
    assert!(!stage.stage().is_colourful());
    let keys = "curve = 'linear'\nblack = 0.2\nwhite = 0.7\narea_m = [100, 200, 300, 400]";
    let stage = with_map(grey(), keys).unwrap();
    let [found, ..] = stage.landscape.albedo_at(200.0, 250.0);
    assert!((found - (0.2 + 0.5 * 128.0 / 255.0)).abs() < 1e-7, "{found}");
    // Beside it the one number holds.
    assert_eq!(stage.landscape.albedo_at(99.0, 250.0), [0.7; 3]);
    let red = picture::ColourPicture::new(1, 1, picture::Depth::Eight, vec![255, 0, 0]).unwrap();
    let stage = with_map(red.into(), "").unwrap();
    assert_eq!(stage.landscape.albedo_at(1.0, 1.0), [1.0, 0.0, 0.0]);
    assert!(stage.stage().is_colourful());
}

#[test]
fn a_map_that_is_not_there_is_told_with_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let error = build_in(folder.path(), "[landscape.albedo_map]\nfile = 'no.png'").unwrap_err().to_string();
    assert!(
        error.starts_with("[landscape] albedo_map: ") && error.contains("no.png: no such file"),
        "{error}"
    );
}

/// Relief that throws shadows, on a small raster.
const SHADOWED: &str = "[landscape.generated.undulation]\nrms_height_m = 20\nhurst = 0.9\nlongest_m = 300\n\
                        shortest_m = 160\nwaves = 20\n[raster]\nsweeps = 24\nsamples_per_sweep = 40\n[shadows]\n";

/// Draws frame 0 of shadowed ground, with a folder of boundaries that is wished or none, and `kept` for want of one.
fn draw_keeping(wished: Option<&Path>, kept: &Path) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.toml");
    fs::write(&path, format!("{GOOD}\n{SHADOWED}")).unwrap();
    let wishes = Wishes { shadow_cache: wished.map(Path::to_owned), ..Wishes::default() };
    let mut opened = open(&path, &wishes).unwrap_or_else(|error| panic!("{error}"));
    opened.keep_shadows(ShadowCache::of_run(kept));
    let stage = opened.stage().unwrap();
    let pose = opened.poses(&stage, 0..1).unwrap().rows()[0].pose;
    let [columns, lines] = [stage.view.columns, stage.view.lines].map(|count| count as usize);
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
    let session = opened.generator.prepare(stage).unwrap();
    session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
}

#[test]
fn the_machine_that_draws_keeps_its_shadows_where_they_are_wished() {
    let folder = tempfile::tempdir().unwrap();
    let [kept, wished] = ["kept", "wished"].map(|name| folder.path().join(name));
    draw_keeping(Some(&wished), &kept);
    assert!(!kept.exists() && fs::read_dir(&wished).unwrap().count() == 1);
    draw_keeping(None, &kept);
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 1);
}
