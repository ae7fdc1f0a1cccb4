//! A plan as written: the keys of its TOML file, strictly, and every fault at once.

use std::path::Path;

use diagnostics::{Placed, Problem, ProblemList, Problems, Reader, TomlFile};
use limits::Limit;
use replay::TruthItems;

use crate::draws::Draw;
use crate::plan::{Fault, FlightDraws, KeyDraw, Plan, PoseDraws};
use crate::{Splits, check};

/// Format of plans that this program reads.
pub const FORMAT: u64 = 1;

/// Most samples of one combination, so that numbers of samples fit 64 bits.
const MOST_DRAWS: u64 = 1_000_000_000;
/// Largest number of blocks that a reach may span: beyond it hardly any place is left.
const MOST_BLOCKS: f64 = 4.0;
/// Largest seed: TOML has whole numbers of 63 bits.
const MOST_SEED: u64 = i64::MAX as u64;

impl Plan {
    /// Reads the plan in the file `path`, and opens every combination of it with the ends of what is drawn, before any ground is made.
    ///
    /// # Errors
    /// Every fault of the file; or of the scenarios, machines and keys that it names.
    pub fn read(path: &Path) -> Result<Self, ProblemList> {
        let name = path.display().to_string();
        let bytes = files::read_all(path, Limit::TextBytes);
        let bytes = bytes.map_err(|error| Problem::of_file(&name, error.to_string()))?;
        let problems = Problems::new();
        let file = TomlFile::parse_bytes(&name, &bytes, &problems);
        let read = file.as_ref().and_then(|file| plan(&file.root(&problems), path, bytes));
        let plan = problems.resolve(read)?;
        let problems = Problems::new();
        if let Some(file) = &file {
            check::check(&plan, &file.root(&problems));
        }
        problems.into_result()?;
        Ok(plan)
    }
}

fn plan(root: &Reader, path: &Path, text: Vec<u8>) -> Option<Plan> {
    if !root.format_version(FORMAT) && root.has("format") {
        return None;
    }
    let title = root.string("title").required();
    let about = root.string("about").help("say in one sentence what the data set is for").required();
    let licence = root.string("licence").help("an SPDX expression, as \"CC0-1.0\"").required();
    let licence_file = optional_text(root, "licence_file");
    let seed = root.u64("seed").at_most(MOST_SEED).required();
    let draws = root.u64("draws").between(1, MOST_DRAWS).required();
    let scenarios = names(root, "scenarios");
    let machines = names(root, "machines");
    let truth = truth(root);
    let counters = root.string_list("counters").default(Vec::new());
    let compare = root.bool("compare").default(false);
    let set = sets(root);
    let keys = keys(&root.table_or_empty("draw"));
    let pose = root.table("pose").map(|table| pose(&table));
    let splits = root.table("splits").map(|table| splits(&table));
    let faults = faults(root);
    root.finish();
    Some(Plan {
        path: path.to_owned(),
        text,
        title: title?,
        about: about?,
        licence: licence?,
        licence_file: licence_file?,
        seed: seed?,
        draws: draws?,
        scenarios: scenarios?,
        machines: machines?,
        faults: faults?,
        truth: truth?,
        counters: counters?,
        compare: compare?,
        set: set?,
        keys: keys?,
        pose: pose??,
        splits: splits??,
    })
}

fn optional_text(table: &Reader, key: &str) -> Option<Option<String>> {
    if table.has(key) {
        table.string(key).required().map(Some)
    } else {
        table.know(key);
        Some(None)
    }
}

/// Names, at least one, no two alike.
fn names(root: &Reader, key: &str) -> Option<Vec<String>> {
    let differ = |names: &Vec<String>| !names.is_empty() && twice(names).is_none();
    root.string_list(key).must("at least one name, and none twice", differ).required()
}

fn twice(names: &[String]) -> Option<&String> {
    names.iter().enumerate().find(|(at, name)| names[..*at].contains(name)).map(|(_, name)| name)
}

fn truth(root: &Reader) -> Option<Option<TruthItems>> {
    let names = root.string_list("truth").placed();
    if !root.has("truth") {
        names.optional();
        return Some(None);
    }
    let names = names.required()?;
    if names.value.is_empty() {
        return Some(None);
    }
    let read: Result<TruthItems, _> = names.value.join(",").parse();
    let refused = |title: String| root.report(Problem::of(&names, title));
    match read {
        Ok(items) if items.iter().any(|item| item.kinds().is_empty()) => {
            refused(
                "`truth` has \"pose\", which is no plane: the manifest has the pose of every sample".into(),
            );
            None
        }
        Ok(items) => Some(Some(items)),
        Err(error) => {
            refused(error.to_string());
            None
        }
    }
}

/// `KEY=VALUE`, as `--set` takes them.
fn sets(root: &Reader) -> Option<Vec<(String, String)>> {
    let texts: Placed<Vec<String>> = root.string_list("set").placed().default(Placed {
        value: Vec::new(),
        place: root.place("set"),
        key: "set".into(),
    })?;
    let split = |text: &String| {
        let pair = text.split_once('=').map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned()));
        if pair.is_none() {
            let problem = Problem::of(&texts, format!("`set` has {text:?}")).found(text.clone());
            root.report(problem.expected("texts KEY=VALUE, as \"scenario.raster.columns=160\""));
        }
        pair
    };
    let split: Vec<_> = texts.value.iter().map(split).collect();
    split.into_iter().collect()
}

/// The tables `number`, `whole` and `one_of` of keys that are drawn, in the order of their names.
fn keys(table: &Reader) -> Option<Vec<KeyDraw>> {
    let mut all: Vec<Option<KeyDraw>> = Vec::new();
    if let Some(of) = table.optional_table("number") {
        all.extend(each(&of, |key| numbers(&of, key).map(Draw::Number)));
    }
    if let Some(of) = table.optional_table("whole") {
        all.extend(each(&of, |key| wholes(&of, key).map(Draw::Whole)));
    }
    if let Some(of) = table.optional_table("one_of") {
        let some = |values: &Vec<String>| !values.is_empty();
        all.extend(each(&of, |key| {
            of.string_list(key).must("at least one value", some).required().map(Draw::OneOf)
        }));
    }
    let mut keys = all.into_iter().collect::<Option<Vec<_>>>()?;
    keys.sort_by(|a, b| a.key.cmp(&b.key));
    match keys.windows(2).find(|pair| pair[0].key == pair[1].key) {
        None => Some(keys),
        Some(pair) => {
            let title = format!("`{}` is drawn twice", pair[0].key);
            table.report(Problem::at(table.table_place(), title).expected("one range for a key"));
            None
        }
    }
}

fn each<'a>(table: &Reader<'a>, read: impl Fn(&'a str) -> Option<Draw>) -> Vec<Option<KeyDraw>> {
    let key = |key: &'a str| Some(KeyDraw { key: key.to_owned(), draw: read(key)? });
    table.keys().into_iter().map(key).collect()
}

/// Two numbers `[low, high]`.
fn numbers(table: &Reader, key: &str) -> Option<[f64; 2]> {
    table.f64_array::<2>(key).must("low and high, low not above high", |[low, high]| low <= high).required()
}

/// Two whole numbers `[first, last]`.
fn wholes(table: &Reader, key: &str) -> Option<[u64; 2]> {
    let ascend = |ends: &Vec<u64>| ends.len() == 2 && ends[0] <= ends[1];
    let ends = table.u64_list(key).must("first and last, first not above last", ascend).required()?;
    Some([ends[0], ends[1]])
}

fn pose(table: &Reader) -> Option<PoseDraws> {
    let within = |key: &str, most: f64| {
        let field = table.f64_array::<2>(key).between(-most, most);
        field.must("low and high, low not above high", |[low, high]| low <= high)
    };
    let metres = |key: &str| within(key, 1e7).unit("m");
    let x_m = metres("x_m").required();
    let y_m = metres("y_m").required();
    let heading_deg = within("heading_deg", 36_000.0).unit("degrees").required();
    let flies = ["z_m", "pitch_deg", "roll_deg"].into_iter().any(|key| table.has(key));
    let help = "z_m with pitch_deg and roll_deg for a vehicle that flies; none of them for one on its wheels";
    let flown = |field: diagnostics::Field<'_, [f64; 2]>| match flies {
        true => field.help(help).required().map(Some),
        false => field.optional().map(Some).or(Some(None)),
    };
    let z_m = flown(metres("z_m"));
    let pitch_deg = flown(within("pitch_deg", 90.0).unit("degrees"));
    let roll_deg = flown(within("roll_deg", 180.0).unit("degrees"));
    let frames = if table.has("frames") {
        wholes(table, "frames")
    } else {
        table.know("frames");
        Some([0, 0])
    };
    let flight = match (z_m?, pitch_deg?, roll_deg?) {
        (Some(z_m), Some(pitch_deg), Some(roll_deg)) => Some(FlightDraws { z_m, pitch_deg, roll_deg }),
        _ => None,
    };
    Some(PoseDraws { x_m: x_m?, y_m: y_m?, heading_deg: heading_deg?, flight, frames: frames? })
}

fn splits(table: &Reader) -> Option<Splits> {
    let block = table.f64("block_m").between(1e-3, 1e7).unit("m").required();
    let reach = table.f64("reach_m").between(0.0, 1e7).unit("m").placed().required();
    let share = |key: &str| table.f64(key).between(0.0, 1.0).required();
    let shares = [share("train"), share("validation"), share("test")];
    let (block, reach, [train, validation, test]) = (block?, reach?, shares);
    let shares = [train?, validation?, test?];
    let sum: f64 = shares.iter().sum();
    if (sum - 1.0).abs() > 1e-9 {
        let title = format!("`{}` sum up to {sum}", ["train", "validation", "test"].join("`, `"));
        table.report(Problem::at(&table.place("train"), title).expected("shares that sum up to 1"));
        return None;
    }
    if reach.value > MOST_BLOCKS * block {
        let title = format!("`reach_m` = {} spans more than {MOST_BLOCKS} blocks", reach.value);
        let problem = Problem::of(&reach, title).expected(format!("at most {} m", MOST_BLOCKS * block));
        table.report(
            problem.help("make `block_m` larger: a place needs all its ground in blocks of one split"),
        );
        return None;
    }
    Some(Splits { block_m: block, reach_m: reach.value, shares })
}

/// The faults; without any, the healthy machine alone.
fn faults(root: &Reader) -> Option<Vec<Fault>> {
    let tables = root.tables("fault");
    if tables.is_empty() {
        let is_left_out = !root.has("fault");
        return is_left_out.then(|| vec![Fault { name: "none".into(), overlay: None, keys: Vec::new() }]);
    }
    let read: Vec<Option<Fault>> = tables.iter().map(fault).collect();
    let faults = read.into_iter().collect::<Option<Vec<Fault>>>()?;
    let names: Vec<String> = faults.iter().map(|fault| fault.name.clone()).collect();
    if let Some(name) = twice(&names) {
        let title = format!("two faults are called {name:?}");
        let place = &tables.last()?.place("name");
        root.report(Problem::at(place, title).expected("a name of its own for each fault"));
        return None;
    }
    Some(faults)
}

fn fault(table: &Reader) -> Option<Fault> {
    let name = table.string("name").required();
    let overlay = optional_text(table, "overlay");
    let keys = keys(table);
    Some(Fault { name: name?, overlay: overlay?, keys: keys? })
}
