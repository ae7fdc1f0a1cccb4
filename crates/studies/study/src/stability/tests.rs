//! The singles of the matrix.

use hardware_model::{HardwareModel, ModelSource};
use scenario::{Scalar, Scenario};

use super::frames::{Drawer, Judge, share_allowed};
use super::{BASE, Cell, Choice, FitOutcome, StabilityScene, matrix, survey_fits};
use crate::Subject;
use crate::ladder::Extent;

fn model(name: &str) -> HardwareModel {
    HardwareModel::load(&ModelSource::BuiltIn(name.into()), &[], &[]).unwrap().model
}

fn scene() -> StabilityScene {
    let (scenario, ideal) = (Scenario::parse("small", BASE).unwrap(), model("ideal"));
    let stage = front_door::build(&scenario, front_door::settings(&scenario, &ideal).unwrap()).unwrap();
    StabilityScene::of(&Subject::new(scenario, ideal, stage, &[0]).unwrap())
}

fn run(choice: &Choice) -> Vec<Cell> {
    matrix(&scene(), [&model("ideal"), &model("pra-nominal")], choice, &mut |_| {})
}

fn singles() -> Choice {
    Choice { extent: Extent::Quick, rows: Vec::new(), pairs: false, mixtures: 0, seed: 1 }
}

fn assert_sound(cells: &[Cell]) {
    let broken: Vec<String> = cells
        .iter()
        .filter(|cell| cell.fault.is_some())
        .map(|c| {
            format!(
                "{}: {}, {}: {:?} ({:?} of {:?}), {:?}",
                c.row, c.case, c.method, c.fault, c.error, c.allowed, c.action
            )
        })
        .collect();
    assert!(broken.is_empty(), "{} of {} cells:\n{}", broken.len(), cells.len(), broken.join("\n"));
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn every_single_extreme_holds() {
    let cells = run(&singles());
    assert!(cells.iter().filter(|cell| cell.own).count() > 300, "{}", cells.len());
    assert_sound(&cells);
}

#[test]
fn explicit_steps_break_where_they_must() {
    let cells = run(&Choice { rows: vec!["time constant".into()], ..singles() });
    let of = |case: &str, method: &str| {
        cells.iter().find(|cell| cell.case == case && cell.method == method).unwrap()
    };
    assert!(!of("lag of 0.1 samples", "Runge-Kutta").bounded);
    assert!(of("lag of 10 samples", "Runge-Kutta").bounded);
    assert!(of("lag of 1e-6 samples", "backward Euler").bounded);
}

/// An allowance in which a wrong sign could hide would prove nothing.
#[test]
fn real_parts_are_allowed_little_unless_ramps_run_away() {
    let (mut scene, parts) = (scene(), model("pra-nominal"));
    let allowed = |scene: &StabilityScene| {
        let drawer = Drawer { name: "parts", model: &parts, scalar: Scalar::F32, judge: Judge::Share };
        share_allowed(scene, &drawer)
    };
    let usual = allowed(&scene);
    assert!((0.05..0.08).contains(&usual), "{usual}");
    // Seventeen regions from the first sample to the second.
    (scene.samples, scene.sweeps) = (2, 2);
    assert_eq!(allowed(&scene), 1.0);
}

#[test]
fn what_must_be_refused_is_a_matter_of_the_whole_scene() {
    let mut scene = scene();
    let pitched = |scene: &mut StabilityScene, degrees: f64, tan_half_height: f64| {
        (scene.attitude.pitch, scene.field.tan_half_height) = (quantities::radians(degrees), tan_half_height);
        scene.nears_the_zenith()
    };
    assert!(!pitched(&mut scene, -66.0, 1e-3) && pitched(&mut scene, -66.0, 0.26));
    assert!(!pitched(&mut scene, 30.0, 1.0) && pitched(&mut scene, 64.0, 1.0));
}

#[test]
fn mixtures_are_named_by_their_seed() {
    let choice = Choice { rows: vec!["none".into()], mixtures: 4, ..singles() };
    let names = |choice: &Choice| run(choice).into_iter().map(|cell| cell.case).collect::<Vec<_>>();
    let first = names(&choice);
    assert_eq!(first, names(&choice));
    assert_ne!(first, names(&Choice { seed: 2, ..choice }));
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn fits_are_determined() {
    for fit in survey_fits() {
        let FitOutcome { region, holes, growth, .. } = &fit;
        assert!(fit.refused.is_some() || *growth < 3.0, "{region} samples, {holes} holes: {fit:?}");
    }
}
