//! Whether everything that a plan names can be opened, and fits together, before any ground is made.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path};

use diagnostics::{Problem, Reader};
use front_door::{OpenError, Opened, open};
use limits::Limit;

use crate::plan::{Combination, KeyDraw, Plan};

/// Opens each combination with the ends of the drawn ranges. A problem has the place of the plan that asks for what is wrong.
pub(crate) fn check(plan: &Plan, root: &Reader) {
    files(plan, root);
    samples(plan, root);
    set_once(plan, root);
    let (mut rasters, mut counters) = (Rasters::default(), BTreeSet::new());
    for of in plan.all() {
        let (scenario, name) = (plan.file(&plan.scenarios[of.scenario]), &plan.scenarios[of.scenario]);
        for end in 0..ends(plan, of) {
            let drawn = at_end(plan, of, end);
            match open(&scenario, &plan.wishes(of, &drawn, false)) {
                Ok(opened) => {
                    counters.extend(opened.generator.counters().iter().map(|counter| counter.name));
                    rasters.add(name, &opened, plan, root);
                    if plan.pose.frames[1] >= opened.frames() {
                        let title = format!("{name} has no frame {}", plan.pose.frames[1]);
                        let place = root.table_or_empty("pose").place("frames");
                        let problem = Problem::at(&place, title);
                        root.report(problem.expected(format!("frames of 0..{}", opened.frames())));
                        return;
                    }
                    if plan.pose.frames != [0, 0] && remembers_frames(&opened) {
                        let title = format!("{} shows frames before its own", plan.machines[of.machine]);
                        let place = root.table_or_empty("pose").place("frames");
                        let problem = Problem::at(&place, title).expected("frames = [0, 0]");
                        root.report(
                            problem.help("a sample of such a machine is the first picture of a drive"),
                        );
                        return;
                    }
                }
                Err(error) => {
                    report(plan, root, of, &error);
                    // One fault of a combination is one error.
                    return;
                }
            }
        }
    }
    for name in plan.counters.iter().filter(|name| !counters.contains(name.as_str())) {
        let known: Vec<&str> = counters.iter().copied().collect();
        let problem = root.problem("counters", format!("no counter is called {name:?}")).found(name);
        root.report(problem.expected(format!("some of {}", known.join(", "))));
    }
}

/// Whether a picture of the machine shows something of frames before its own.
fn remembers_frames(opened: &Opened) -> bool {
    opened.generator.remembers_frames() || (opened.is_machine() && opened.settings.remembers_frames())
}

/// A key is set for all samples or drawn for each, and drawn once.
fn set_once(plan: &Plan, root: &Reader) {
    for (key, _) in &plan.set {
        let drawn = plan.keys.iter().chain(plan.faults.iter().flat_map(|fault| &fault.keys));
        if drawn.into_iter().any(|other| other.key == *key) {
            let problem = root.problem("set", format!("`{key}` is set for all samples, and drawn as well"));
            root.report(problem.expected("a value for all samples, or a draw"));
        }
    }
}

/// A data set has no more samples than a scenario may have frames.
fn samples(plan: &Plan, root: &Reader) {
    let samples = plan.samples();
    if !Limit::Frames.allows(samples) {
        let title = format!("{samples} samples of {} combinations", plan.combinations());
        let problem = root.problem("draws", title).expected(format!("at most {}", Limit::Frames.value()));
        root.report(problem.help(Limit::Frames.to_string()));
    }
}

fn files(plan: &Plan, root: &Reader) {
    let names: Vec<Option<&str>> = plan.scenarios.iter().map(|file| stem(file)).collect();
    if let Some(at) = (1..names.len()).find(|at| names[..*at].contains(&names[*at])) {
        let title = format!("two scenarios are called {:?}", names[at].unwrap_or_default());
        root.report(root.problem("scenarios", title).expected("files of different names"));
    }
    if let Some(name) = &plan.licence_file
        && !is_beside(name)
    {
        let title = format!("`licence_file`: {name}: not beside the plan");
        root.report(root.problem("licence_file", title).expected("a text in the plan's folder or below it"));
    } else if let Some(name) = &plan.licence_file
        && !files::is_file(plan.file(name))
    {
        let title = format!("`licence_file`: {}: no such file", plan.file(name).display());
        root.report(root.problem("licence_file", title).expected("a text beside the plan"));
    }
}

/// Whether a path stays in the folder in which it begins.
fn is_beside(name: &str) -> bool {
    Path::new(name).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
}

/// Name of a scenario: that of its file without the ending.
pub(crate) fn stem(file: &str) -> Option<&str> {
    Path::new(file).file_stem()?.to_str()
}

/// Number of ends that the keys of a combination have; at least one.
fn ends(plan: &Plan, of: Combination) -> usize {
    keys(plan, of).map(|key| key.draw.ends().len()).max().unwrap_or(1)
}

fn keys(plan: &Plan, of: Combination) -> impl Iterator<Item = &KeyDraw> {
    plan.keys.iter().chain(&plan.faults[of.fault].keys)
}

/// Every key at its end `end`, or at its last one.
fn at_end(plan: &Plan, of: Combination, end: usize) -> Vec<(String, String)> {
    let value = |KeyDraw { key, draw }: &KeyDraw| {
        let ends = draw.ends();
        (key.clone(), ends[end.min(ends.len() - 1)].clone())
    };
    keys(plan, of).map(value).collect()
}

/// Rasters that were met: a data set has pictures of one size.
#[derive(Default)]
struct Rasters {
    found: BTreeMap<[u32; 2], String>,
}

impl Rasters {
    fn add(&mut self, scenario: &str, opened: &Opened, plan: &Plan, root: &Reader) {
        let raster = &opened.settings.raster;
        let size = [raster.columns, raster.lines];
        if self.found.contains_key(&size) {
            return;
        }
        if let Some(([columns, lines], first)) = self.found.first_key_value() {
            let title = format!(
                "{first} has pictures of {columns} x {lines} pixels, and {scenario} some of {} x {}",
                size[0], size[1]
            );
            let key = if plan.scenarios.len() > 1 { "scenarios" } else { "machines" };
            let problem = root.problem(key, title).expected("pictures of one size");
            let help =
                "set it for all, as set = [\"scenario.raster.columns=160\", \"scenario.raster.lines=120\"]";
            root.report(problem.help(help));
        }
        self.found.insert(size, scenario.to_owned());
    }
}

/// One problem for each fault, at the key of the plan that asks for what is wrong.
fn report(plan: &Plan, root: &Reader, of: Combination, error: &OpenError) {
    let [scenario, machine] = [&plan.scenarios[of.scenario], &plan.machines[of.machine]];
    let fault = &plan.faults[of.fault];
    let said = error.to_string();
    let titles: Vec<String> = match error {
        OpenError::Problems(list) => list.records().into_iter().map(|record| told(&record)).collect(),
        _ => vec![said],
    };
    for title in titles {
        let asks = place(plan, root, of, &title);
        let with = if fault.is_none() { String::new() } else { format!(" with fault {}", fault.name) };
        let title = format!("{scenario} by {machine}{with}: {title}");
        root.report(Problem::at(&asks, title).expected("a scenario, a machine and keys that fit together"));
    }
}

fn told(record: &diagnostics::ProblemRecord) -> String {
    let place = match (&record.file, record.line) {
        (file, Some(line)) => format!("{file}:{line}: "),
        (file, None) => format!("{file}: "),
    };
    place + &record.title
}

/// Where the plan asks for what `said` refuses: a key that it names, the fault, or the scenario.
fn place(plan: &Plan, root: &Reader, of: Combination, said: &str) -> diagnostics::Place {
    let short = |key: &str| key.strip_prefix("scenario.").unwrap_or(key).to_owned();
    let names = |key: &&KeyDraw| said.contains(&short(&key.key));
    let of_fault = || root.tables("fault").into_iter().nth(of.fault);
    if let Some(key) = plan.faults[of.fault].keys.iter().find(names)
        && let Some(table) = of_fault()
    {
        return drawn_at(&table, &key.key).unwrap_or(table.table_place().clone());
    }
    if let Some(key) = plan.keys.iter().find(names)
        && let Some(place) = drawn_at(&root.table_or_empty("draw"), &key.key)
    {
        return place;
    }
    if plan.set.iter().any(|(key, _)| said.contains(&short(key))) {
        return root.place("set");
    }
    if plan.faults[of.fault].overlay.as_ref().is_some_and(|overlay| said.contains(overlay.as_str()))
        && let Some(table) = of_fault()
    {
        return table.place("overlay");
    }
    let names_machine = said.contains(plan.machines[of.machine].as_str());
    root.place(if names_machine { "machines" } else { "scenarios" })
}

fn drawn_at(table: &Reader, key: &str) -> Option<diagnostics::Place> {
    let tables = ["number", "whole", "one_of"].into_iter().filter_map(|name| table.optional_table(name));
    tables.filter(|of| of.has(key)).map(|of| of.place(key)).next()
}
