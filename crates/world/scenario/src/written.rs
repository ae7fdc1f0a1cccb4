//! A scenario as written: the keys of its TOML file, strictly, and every fault at once.

mod albedo;
mod channels;
mod coordinates;
mod course;
mod doubts;
mod earth;
mod effect_keys;
mod effects;
mod events;
mod face_effects;
mod features;
mod gpx_names;
mod ground;
mod guests;
mod light;
mod lights;
mod object_ids;
mod overlays;
mod path_gpx;
mod path_table;
mod photographs;
mod points;
mod quaternion;
mod raster;
mod reference;
mod scenery;
mod sea;
mod sheets;
mod ships;
mod star_list;
mod stars;
mod sun;

use std::path::Path as FilePath;

use diagnostics::{Layers, Problem, ProblemList, Problems, Reader, TomlFile, similar_file};
use files::FileError;
use landscape::Photometry;
use landscape::relief::Relief;
use limits::Limit;
use quantities::radians;

use coordinates::Ground;
pub use doubts::other_unit;

use crate::{
    Display, FaceWishes, GroundSource, LawWishes, Length, LevelSwitch, Object, RollDisplay, Scalar, Scenario,
    Vehicle, VehicleShape, words,
};

/// Format of scenario files that this program reads.
pub const FORMAT: u64 = 1;

/// What takes the place of something that a scenario file says.
#[derive(Debug, Clone, Copy, Default)]
pub struct Overrides<'a> {
    /// Single keys and their values as TOML: `raster.columns` and `640`.
    pub sets: &'a [(&'a str, &'a str)],
    /// File of the bank whose ground is taken, whatever ground the scenario names itself.
    pub bank: Option<&'a FilePath>,
}

impl Scenario {
    /// Reads a scenario file, and the path file that it may name.
    ///
    /// # Errors
    /// Every fault of both files.
    pub fn read(path: impl AsRef<FilePath>) -> Result<Self, ProblemList> {
        Self::read_beside(path, &[])
    }

    /// The same of a file that may have tables of `others` as well, which somebody else reads.
    ///
    /// # Errors
    /// Every fault of both files.
    pub fn read_beside(path: impl AsRef<FilePath>, others: &[&str]) -> Result<Self, ProblemList> {
        Self::read_over(path, others, Overrides::default())
    }

    /// The same with `over` over what the file says.
    ///
    /// # Errors
    /// Every fault of the files and of the keys.
    pub fn read_over(
        path: impl AsRef<FilePath>,
        others: &[&str],
        over: Overrides,
    ) -> Result<Self, ProblemList> {
        let name = path.as_ref().display().to_string();
        let bytes = files::read_all(path.as_ref(), Limit::TextBytes)
            .map_err(|error| not_read(path.as_ref(), &name, &error))?;
        let problems = Problems::new();
        let set = |(key, value): &(&str, &str)| {
            TomlFile::parse("--set", &format!("scenario.{key} = {value}"), &problems)
                .and_then(|file| file.below("scenario", &problems))
        };
        let sets: Option<Vec<TomlFile>> = over.sets.iter().map(set).collect();
        let file = TomlFile::parse_bytes(&name, &bytes, &problems);
        let surroundings = Surroundings { folder: folder_of(path.as_ref()), others, bank: over.bank };
        let scenario = file.zip(sets).and_then(|(file, sets)| {
            let layers = Layers::new([file].into_iter().chain(sets));
            scenario(&layers.root(&problems), &surroundings, &problems)
        });
        problems.resolve(scenario)
    }

    /// Reads the text of a scenario; `name` is the path that it has or would have. References of the text start
    /// at the folder of `name`.
    ///
    /// # Errors
    /// Every fault of the text and of the path file that it may name.
    pub fn parse(name: &str, text: &str) -> Result<Self, ProblemList> {
        Self::parse_beside(name, text, &[])
    }

    /// The same of a text that may have tables of `others` as well, which somebody else reads.
    ///
    /// # Errors
    /// Every fault of the text and of the path file that it may name.
    pub fn parse_beside(name: &str, text: &str, others: &[&str]) -> Result<Self, ProblemList> {
        let problems = Problems::new();
        let surroundings = Surroundings { folder: folder_of(FilePath::new(name)), others, bank: None };
        let scenario = TomlFile::parse(name, text, &problems)
            .and_then(|file| scenario(&file.root(&problems), &surroundings, &problems));
        problems.resolve(scenario)
    }
}

fn not_read(path: &FilePath, name: &str, error: &FileError) -> Problem {
    let problem = Problem::of_file(name, error.to_string());
    match similar_file(path) {
        Some(similar) if !files::is_there(path) => {
            problem.help(format!("did you mean {}?", similar.display()))
        }
        _ => problem,
    }
}

/// Tracks are patches of remote shadow: nothing draws them where there is none. `[shadows]` that is switched off may
/// stand beside them, so that both are switched on together.
fn check_tracks(root: &Reader) {
    if root.has("tracks") && !root.has("shadows") {
        let problem = root.problem("tracks", "`[tracks]` without `[shadows]`: nothing would draw them");
        root.report(problem.expected("`[shadows]`, since tracks are patches of remote shadow"));
    }
}

/// The vehicle's own shadow is remote shadow too.
fn check_own_shadow(root: &Reader, vehicle: &Reader) {
    if let Some(key) = ["model", "file"].into_iter().find(|key| vehicle.has(key) && !root.has("shadows")) {
        let title =
            format!("`vehicle.{key}` without `[shadows]`: nothing would draw the vehicle's own shadow");
        vehicle.report(vehicle.problem(key, title).expected("`[shadows]`, or no shape of the vehicle"));
    }
}

fn folder_of(path: &FilePath) -> &FilePath {
    path.parent().unwrap_or(FilePath::new(""))
}

/// What lies around the text of a scenario.
struct Surroundings<'a> {
    /// Folder at which references start.
    folder: &'a FilePath,
    /// Tables that somebody else reads.
    others: &'a [&'a str],
    /// Bank that takes the place of the scenario's ground.
    bank: Option<&'a FilePath>,
}

fn scenario(root: &Reader, surroundings: &Surroundings, problems: &Problems) -> Option<Scenario> {
    let Surroundings { folder, others, bank } = *surroundings;
    if !root.format_version(FORMAT) && root.has("format") {
        return None;
    }
    let title = root.string("title").required();
    let shows = root.string("shows").help("say in one sentence what the scenario shows").required();
    let machine = machine(root);
    let length = length(root);
    let ground =
        root.table("landscape").map(|table| (ground::ground(&table, folder), albedo::albedo(&table, folder)));
    let database =
        root.optional_table("landscape").map_or(Some(None), |table| ground::database(&table, folder));
    let features = features::features(&root.table_or_empty("features"), folder, problems);
    let lies_on = bank.map(Ground::Bank).or_else(|| match &ground.as_ref()?.0.as_ref()?.0 {
        GroundSource::Bank(bank) => Some(Ground::Bank(bank)),
        GroundSource::Generated(_) => Some(Ground::Generated),
    });
    let is_generated = matches!(lies_on, Some(Ground::Generated));
    let sun_table = root.table("sun");
    let sun = sun_table.as_ref().map(|table| sun::sun(table, is_generated));
    let photographs = photographs::photographs(&root.tables("photograph"), folder);
    let shadows = part(root, "shadows", light::shadows);
    let photometry = part(root, "photometry", light::photometry);
    let texture = part(root, "texture", light::texture);
    let silhouettes = all(root.tables("silhouette").iter().map(light::silhouette));
    let rocks = part(root, "rocks", scenery::rocks);
    let groups = guests::groups(&root.tables("group"));
    let objects = scenery::objects(&root.tables("object"), groups.as_deref(), folder, problems);
    let event_tables = root.tables("event");
    let events = match &objects {
        Some(objects) => events::events(&event_tables, objects),
        // Without the ids of all objects nothing can be said about events.
        None => {
            event_tables.iter().for_each(Reader::ignore_rest);
            None
        }
    };
    let display_table = root.table_or_empty("display");
    let (display, white_magnitude) = (display(&display_table), white_magnitude(&display_table));
    let effects =
        effects::effects(root, sun_table.as_ref(), objects.as_deref(), folder, white_magnitude, problems);
    let faces = face_wishes(root, objects.as_deref(), folder);
    let tracks = part(root, "tracks", scenery::tracks);
    let vehicle_table = root.table_or_empty("vehicle");
    let vehicle_shape = scenery::optional_shape(&vehicle_table, folder, problems);
    let vehicle = vehicle(&vehicle_table);
    let path = root.table("path").map(|table| course::course(&table, folder, lies_on, problems));
    let raster = root.table_or_empty("raster");
    let (wishes, field) = (raster::wishes(&raster), raster::field_of_view(&raster, &raster));
    let channels = channels::channels(&root.tables("channel"), &raster);
    let levels = part(root, "levels", levels);
    let roll_table = root.table_or_empty("roll");
    let roll = roll(&roll_table);
    if let (Some(Some(course)), false) = (&path, roll_table.has("display")) {
        let note = doubts::hidden_roll(course.path.waypoints());
        note.into_iter().for_each(|note| problems.note(format!("{}: {note}", course.path.name())));
    }
    let range = root.optional_table("range").map(|table| words::range(&table));
    let laws = laws(&root.table_or_empty("laws"));
    let scalar = scalar(&root.table_or_empty("run"));
    others.iter().filter_map(|table| root.optional_table(table)).for_each(|table| table.ignore_rest());
    check_levels(root, ground.as_ref().and_then(|ground| ground.0.as_ref()), &levels);
    check_tracks(root);
    check_own_shadow(root, &vehicle_table);
    root.finish();
    let ((ground, albedo), course::Course { path, path_file, driven }) = (ground?, path??);
    let (driven, driven_file) = driven.unzip();
    let (ground, coarse) = ground?;
    let (albedo, albedo_map) = albedo?;
    let (vehicle, (vehicle_files, parts)) = (vehicle?, vehicle_shape?.unzip());
    let vehicle_shape = parts.map(|parts| VehicleShape { parts, eye_height: vehicle.eye_height });
    Some(Scenario {
        title: title?,
        shows: shows?,
        machine: machine?,
        length: length?,
        ground,
        coarse,
        features: features?,
        database: database?,
        albedo,
        albedo_map,
        photographs: photographs?,
        photometry: photometry?.unwrap_or(Photometry::Lambert),
        texture: texture?,
        silhouettes: silhouettes?,
        sun: sun??,
        shadows: shadows?.flatten(),
        rocks: rocks?,
        objects: objects?,
        groups: groups?,
        events: events?,
        effects: effects?,
        faces: faces?,
        tracks: tracks?,
        levels: levels?,
        roll: roll?,
        vehicle,
        vehicle_shape,
        vehicle_files: vehicle_files.unwrap_or_default(),
        path,
        path_file,
        driven,
        driven_file,
        raster: wishes,
        field: field?,
        channels: channels?,
        channel: None,
        range: range.flatten(),
        laws,
        display: display?,
        scalar: scalar?,
        notes: problems.take_notes(),
    })
}

/// Sea, ships, effects of files and plumes.
fn face_wishes(root: &Reader, objects: Option<&[Object]>, folder: &FilePath) -> Option<FaceWishes> {
    let sea = part(root, "sea", sea::sea);
    let ships = ships::ships(&root.tables("ship"), sea.as_ref().map(Option::as_ref));
    let effects = face_effects::effects(&root.tables("effect"), objects, folder);
    let plumes = face_effects::plumes(&root.tables("plume"), objects);
    Some(FaceWishes { sea: sea?, ships: ships?, effects: effects?, plumes: plumes? })
}

/// A scenario names a model and never a file: it must not reach out of its folder.
fn machine(root: &Reader) -> Option<String> {
    let field = words::model_name(root, "machine");
    field.help("a model file is named on the command line: --machine FILE").default("ideal".into())
}

fn length(root: &Reader) -> Option<Length> {
    let frames = root
        .u64("frames")
        .between(1, Limit::Frames.value())
        .help(Limit::Frames.to_string())
        .optional()
        .map(Length::Frames);
    let seconds =
        root.f64("duration_s").above(0.0).at_most(10_000.0).unit("s").optional().map(Length::Seconds);
    match (root.has("frames"), root.has("duration_s")) {
        (true, true) => {
            let title = "`frames` and `duration_s` both say how long the scenario is";
            root.report(root.problem("duration_s", title).expected("one of the two"));
            None
        }
        (false, false) => {
            let title = "missing key `frames` or `duration_s`";
            root.report(root.problem("frames", title).expected("`frames`, a whole number, or `duration_s`"));
            None
        }
        _ => frames.or(seconds),
    }
}

fn levels(table: &Reader) -> Option<LevelSwitch> {
    let range = table.f64("switch_m").above(0.0).at_most(1e6).unit("m").placed().required();
    let blend = table.f64("blend_m").at_least(0.0).unit("m").placed();
    let (range, blend) = (range?, if table.has("blend_m") { Some(blend.optional()?) } else { None });
    if let Some(blend) = blend.as_ref().filter(|blend| blend.value > range.value) {
        let title = format!("`{}` = {} is longer than the way to the switch", blend.key, blend.value);
        table.report(Problem::of(blend, title).expected(format!("at most {} m", range.value)));
        return None;
    }
    Some(LevelSwitch { range: range.value, blend: blend.map_or(0.0, |blend| blend.value) })
}

/// A coarse level that no sweep goes over to would be made and not drawn.
fn check_levels(
    root: &Reader,
    ground: Option<&(GroundSource, Option<Relief>)>,
    levels: &Option<Option<LevelSwitch>>,
) {
    let Some((GroundSource::Generated(_), coarse)) = ground else { return };
    let (title, expected) = match (coarse, levels) {
        (Some(_), Some(None)) => ("`landscape.coarse` without `levels`", "[levels] with `switch_m`"),
        (None, Some(Some(_))) => ("`levels` on ground of one level", "[landscape.coarse], or no [levels]"),
        _ => return,
    };
    root.report(root.problem("levels", title).expected(expected));
}

fn roll(table: &Reader) -> Option<RollDisplay> {
    table
        .one_of("display", &[("none", RollDisplay::None), ("yoke", RollDisplay::Yoke)])
        .default(RollDisplay::None)
}

/// A table that may be missing; nothing where it is there and wrong.
fn part<T>(root: &Reader, key: &str, read: impl Fn(&Reader) -> Option<T>) -> Option<Option<T>> {
    match root.optional_table(key) {
        Some(table) => read(&table).map(Some),
        // What is there and no table has been reported.
        None => (!root.has(key)).then_some(None),
    }
}

/// All of them, every one read even if one before it is wrong.
fn all<T>(parts: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    let read: Vec<Option<T>> = parts.collect();
    read.into_iter().collect()
}

/// `area_m`, where it is there: south, west, north, east edge.
fn area(table: &Reader) -> Option<Option<[f64; 4]>> {
    let ascends = |[south, west, north, east]: &[f64; 4]| south < north && west < east;
    let rule = "south, west, north, east edge in ascending order";
    let edges = table.f64_array::<4>("area_m").between(-1e7, 1e7).unit("m").must(rule, ascends);
    if table.has("area_m") { edges.optional().map(Some) } else { Some(edges.optional()) }
}

/// What another file held; its problems become this reading's.
fn take_over<T>(read: Result<T, ProblemList>, problems: &Problems) -> Option<T> {
    read.map_err(|list| list.iter().cloned().for_each(|problem| problems.push(problem))).ok()
}

fn vehicle(table: &Reader) -> Option<Vehicle> {
    let usual = Vehicle::default();
    let metres = |key: &str, most: f64| table.f64(key).above(0.0).at_most(most).unit("m");
    let degrees = |key: &str, most: f64| {
        let field = table.f64(key).above(0.0).at_most(most).unit("degrees");
        field.map(radians)
    };
    let eye_height = metres("eye_height_m", 1e5).default(usual.eye_height);
    let wheelbase = metres("wheelbase_m", 100.0).default(usual.wheelbase);
    let track = metres("track_m", 100.0).default(usual.track);
    let max_speed = table.f64("max_speed_m_s").above(0.0).unit("m/s").default(usual.max_speed);
    let max_turn = degrees("max_turn_deg_s", 3600.0).default(usual.max_turn);
    let max_slope = degrees("max_slope_deg", 90.0).default(usual.max_slope);
    Some(Vehicle {
        eye_height: eye_height?,
        wheelbase: wheelbase?,
        track: track?,
        max_speed: max_speed?,
        max_turn: max_turn?,
        max_slope: max_slope?,
    })
}

fn laws(table: &Reader) -> LawWishes {
    LawWishes {
        projection: words::projection(table).optional(),
        curvature: words::curvature(table).optional(),
        occlusion: words::occlusion(table).optional(),
        pixel_rule: words::pixel_rule(table).optional(),
        feature_light: words::feature_light(table, "feature_light").optional(),
        body_visibility: words::body_visibility(table, "body_visibility").optional(),
        shadowed_bodies: words::shadowed_bodies(table).optional(),
        body_shading: words::body_shading(table, "body_shading").optional(),
        texture_in_shadow: words::texture_in_shadow(table).optional(),
    }
}

fn display(table: &Reader) -> Option<Display> {
    let white = table.f64("white").above(0.0).at_most(1000.0).default(1.0);
    let gamma = table.f64("gamma").between(0.25, 4.0).default(1.0);
    Some(Display { white: white?, gamma: gamma? })
}

/// Magnitude of a star that shows white. Chosen: that of Sirius, the brightest star of the sky.
fn white_magnitude(table: &Reader) -> Option<f64> {
    table.f64("white_magnitude").between(-50.0, 50.0).default(-1.46)
}

fn scalar(table: &Reader) -> Option<Scalar> {
    table.one_of("scalar", &[("f32", Scalar::F32), ("f64", Scalar::F64)]).default(Scalar::F32)
}
