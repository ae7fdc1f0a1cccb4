//! Ladders of a small scene: what is exact has no error, what converges has its order, and a kept picture is taken again.

use exact::Columns;
use hardware_model::{Economy, HardwareModel};
use landscape::Attitude;
use quantities::radians;
use scenario::Scenario;
use study::ladder::{Extent, Ladder, LadderOutcome, ladders};
use study::{Configure, Effort, ExactPictures, Rehearsed, Subject, climb, parameter_ladder};

/// Smooth ground, no craters: between samples a profile is a parabola.
const SMOOTH: &str = r#"
format = 1
title = "Smooth"
shows = "Nothing but a test."
machine = "ideal"
frames = 4

[landscape]
albedo = 1.0

[landscape.generated]
seed = 11
extent_m = [4000, 4000]
region_size_m = 100

[landscape.generated.undulation]
rms_height_m = 12
hurst = 0.9
longest_m = 2500
shortest_m = 700
waves = 60

[sun]
azimuth_deg = 100
elevation_deg = 25

[path]
keyframes = [{ t_s = 0, x_m = 2000, y_m = 2000 }, { t_s = 5, x_m = 2008, y_m = 2005 }]

[raster]
sweeps = 48
samples_per_sweep = 500
lines = 40

[run]
scalar = "f64"
"#;

fn subject() -> Subject {
    subject_of(SMOOTH)
}

fn subject_of(text: &str) -> Subject {
    let scenario =
        Scenario::parse("smooth.toml", text).unwrap_or_else(|list| panic!("{}", list.render(false)));
    let model = HardwareModel::ideal();
    let settings = front_door::settings(&scenario, &model).unwrap();
    let stage = front_door::build(&scenario, settings).unwrap();
    Subject::new(scenario, model, stage, &[1]).unwrap()
}

fn climbed(subject: &Subject, ladder: &Ladder) -> LadderOutcome {
    let mut exact = ExactPictures::new("test", &subject.scenario, &subject.stage.stage(), None).unwrap();
    let columns = Columns::new(subject.stage.stage());
    let mut study = Rehearsed { subject, exact: &mut exact, columns: &columns };
    climb(&mut study, ladder, Effort { repetitions: 1 }, &mut |_| ()).unwrap()
}

fn ladder(subject: &Subject, name: &str) -> Ladder {
    let models = [HardwareModel::ideal()];
    let mut all = ladders(subject, &models, Extent::Quick).into_iter();
    all.find(|ladder| ladder.name == name).unwrap()
}

#[test]
fn samples_converge_as_theory_says() {
    let subject = subject();
    let outcome = climbed(&subject, &ladder(&subject, "samples"));
    assert!(outcome.rungs.iter().all(|rung| rung.refused.is_none()), "{outcome:#?}");
    for order in &outcome.orders {
        assert!(order.agrees(0.2), "{order:?}");
    }
    // At the samples themselves the ideal machine is the ground, in f64 to rounding.
    for rung in &outcome.rungs {
        assert!(rung.error("height rms").unwrap() < 1e-9, "{rung:?}");
        assert!(rung.error("slope max").unwrap() < 1e-9, "{rung:?}");
        assert!(rung.error("reflectivity max").unwrap() < 1e-9, "{rung:?}");
    }
    let picture: Vec<f64> = outcome.rungs.iter().map(|rung| rung.error("picture rmse").unwrap()).collect();
    assert!(picture[0] > picture[4] && picture[4] < 0.02, "{picture:?}");
}

#[test]
fn single_precision_is_told_from_double() {
    let subject = subject();
    let outcome = climbed(&subject, &ladder(&subject, "scalar"));
    let [single, double] = [0, 1].map(|rung: usize| outcome.rungs[rung].error("height rms").unwrap());
    assert!(single > 1e-8 && single < 1e-3, "{single}");
    assert!(double < 1e-3 * single, "{double} {single}");
}

#[test]
fn a_difference_of_law_is_a_number_of_its_own() {
    let subject = subject();
    let outcome = climbed(&subject, &ladder(&subject, "projection"));
    let [reported, exact] = [0, 2].map(|rung: usize| &outcome.rungs[rung]);
    let law = "picture rmse, law of the base";
    assert!(reported.error(law).unwrap() > 2.0 * reported.error("picture rmse").unwrap(), "{reported:?}");
    assert_eq!(exact.error(law), None, "the base's own law");
    assert_eq!([reported.changes, exact.changes], [1, 0], "changes of the base");
}

#[test]
fn kept_pictures_are_taken_again_and_damaged_ones_drawn_again() {
    let subject = subject();
    let folder = tempfile::tempdir().unwrap();
    let (frame, pose) = subject.frames[0];
    let drawn = || {
        let kept = Some(folder.path().join("exact"));
        let mut exact = ExactPictures::new("test", &subject.scenario, &subject.stage.stage(), kept).unwrap();
        exact.picture(&subject.stage.stage(), (frame, &pose), [48, 40]).unwrap()
    };
    let first = drawn();
    let files = || std::fs::read_dir(folder.path().join("exact")).unwrap().map(|entry| entry.unwrap().path());
    assert_eq!(files().count(), 1);
    assert_eq!(drawn(), first);
    let file = files().next().unwrap();
    let mut bytes = std::fs::read(&file).unwrap();
    // Another value at the end: what is kept is what is taken.
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    std::fs::write(&file, &bytes).unwrap();
    assert_ne!(drawn(), first);
    std::fs::write(&file, b"no array").unwrap();
    assert_eq!(drawn(), first);
}

/// The same ground on positions of LUNSIM's recorder, from 400 m above and looking down.
fn lunsim(restrictions: bool) -> LadderOutcome {
    let row = registry::find("lunsim").unwrap();
    let text = SMOOTH.replace("\"ideal\"", "\"lunsim\"").replace("lines = 40", "columns = 256\nlines = 256");
    // Rough enough that 256 codes do not hide the grid.
    let text = text
        .replace("region_size_m = 100", "region_size_m = 25")
        .replace("2500", "600")
        .replace("700", "150");
    let law = "[laws]\npixel_rule = \"centre\"";
    let mut subject = subject_of(&format!("{text}\n{law}\n"));
    let (_, pose) = &mut subject.frames[0];
    pose.eye[2] += 400.0;
    pose.attitude = Attitude { roll: 0.0, pitch: radians(-50.0), heading: 0.0 };
    let mut exact = ExactPictures::new("test", &subject.scenario, &subject.stage.stage(), None).unwrap();
    let restrictions = restrictions.to_string();
    let configure = |sets: &[(&str, &str)]| {
        let sets: Vec<_> =
            [("lunsim.restrictions", restrictions.as_str())].iter().chain(sets).copied().collect();
        registry::configure_with(row, &sets).map_err(|error| error.to_string())
    };
    let own = (&row.ladders[0], &configure as &Configure<'_>);
    parameter_ladder(own, &subject, &mut exact, Effort { repetitions: 1 }, Extent::Quick).unwrap()
}

#[test]
fn a_finer_grid_of_lunsim_is_nearer_to_exact() {
    let ladder = lunsim(false);
    let means: Vec<f64> = ladder.rungs.iter().map(|rung| rung.error("picture mean").unwrap()).collect();
    assert!(means.len() == 4 && means.windows(2).all(|pair| pair[1] < 0.7 * pair[0]), "{means:?}");
    let work: Vec<u64> = ladder.rungs.iter().map(|rung| rung.work).collect();
    assert_eq!(work, [64, 128, 256, 512].map(|points: u64| points * points));
    assert!(ladder.rungs.iter().all(|rung| rung.time_s.is_some_and(|times| times[0] > 0.0)));
}

#[test]
fn what_lunsim_cannot_do_is_told_rung_by_rung() {
    let ladder = lunsim(true);
    let told =
        |rung: &study::ladder::RungOutcome| rung.refused.as_ref().is_some_and(|why| why.contains("relief"));
    assert!(ladder.rungs.iter().all(told), "{ladder:?}");
}

/// Three panes over a picture of small facets, drawn by sampling points.
const PANES: &str = "
[[overlay]]
id = 'first'
corners = [[-2, -2], [2, -2], [2, 2], [-2, 2]]
colour = [0.9, 0.1, 0.1]
tau = 0.8
priority = 3
[[overlay]]
id = 'second'
corners = [[-2, -2], [2, -2], [0.3, 2], [-2, 2]]
colour = [0.1, 0.9, 0.1]
tau = 0.7
priority = 2
[[overlay]]
id = 'third'
corners = [[-0.3, -2], [2, -2], [2, 2], [-2, 2]]
colour = [0.1, 0.1, 0.9]
tau = 0.6
priority = 1
";

/// The ladder of this name of the generator of sampling points, under the panes.
fn of_sampling_points(name: &str) -> LadderOutcome {
    let row = registry::find("sampled").unwrap();
    let subject = subject_of(&(SMOOTH.replace("\"ideal\"", "\"sampled\"") + PANES));
    let mut exact = ExactPictures::new("test", &subject.scenario, &subject.stage.stage(), None).unwrap();
    let configure =
        |sets: &[(&str, &str)]| registry::configure_with(row, sets).map_err(|error| error.to_string());
    let ladder = row.ladders.iter().find(|ladder| ladder.name == name).unwrap();
    let own = (ladder, &configure as &Configure<'_>);
    parameter_ladder(own, &subject, &mut exact, Effort { repetitions: 1 }, Extent::Whole).unwrap()
}

fn means(ladder: &LadderOutcome) -> Vec<f64> {
    ladder.rungs.iter().map(|rung| rung.error("picture mean").unwrap()).collect()
}

#[test]
fn more_sampling_points_are_nearer_to_the_areas_of_the_faces() {
    let ladder = of_sampling_points("sampling");
    let means = means(&ladder);
    assert!(means.len() == 5 && means.windows(2).all(|pair| pair[1] < 0.95 * pair[0]), "{means:?}");
    assert!(means[4] < 0.15 * means[0] && ladder.against == "its own faces by area", "{means:?}");
}

#[test]
fn a_stack_that_keeps_all_panes_loses_nothing() {
    let means = means(&of_sampling_points("stack"));
    assert!(means[0] > means[1] && means[1] > means[2] && means[2] > 0.0, "{means:?}");
    assert_eq!(means[3..], [0.0, 0.0], "four and eight places for three panes");
}

/// Rungs of quality change the economy alone, and the others at normal quality what they name.
#[test]
fn rungs_of_quality_change_what_they_name() {
    let text = SMOOTH.to_owned() + "\n[shadows]\nfinest_m = 0.5\nangle_mrad = 2\n";
    let subject = subject_of(&text);
    let of = |name: &str| -> Vec<_> {
        let rungs = ladder(&subject, name).rungs;
        rungs.iter().map(|rung| subject.changed(&rung.changes).unwrap().settings).collect()
    };
    for name in ["normal-sweeps", "normal-shadows"] {
        assert!(of(name).iter().all(|settings| settings.economy == Economy::Normal), "{name}");
    }
    let economies: Vec<_> = of("quality").iter().map(|settings| settings.economy).collect();
    let instants = [1, 2, 3, 4].map(Economy::Instants);
    assert_eq!(economies, [&instants[..], &[Economy::Normal, Economy::Bounded]].concat());
    assert!(
        of("quality").iter().all(|settings| settings.raster.samples == subject.stage.settings.raster.samples)
    );
    let sweeps: Vec<u32> = of("normal-sweeps").iter().map(|settings| settings.raster.sweeps).collect();
    assert_eq!(sweeps, [12, 24, 48]);
    let finest = of("normal-shadows").into_iter().map(|settings| settings.shadows.unwrap().finest);
    assert_eq!(finest.collect::<Vec<_>>(), [4.0, 2.0, 1.0, 0.5]);
}
