//! Scenes whose answer is known in closed form, one folder each; the schema is in `README.md`.

mod formula;
mod ground;
mod reading;
mod schema;

use std::fs;
use std::path::PathBuf;

use exact::Exact;
use generator::Generator;
use lunoid_tests::{Drawn, Scene};
use machine::HybridMachine;
use scenario::Scalar;

use crate::schema::{Cartridge, Model, SceneFile};

const CARTRIDGES: [&str; 6] =
    ["flat-plane", "fold-table", "lunoid-horizon", "one-coefficient", "ridge-hides-valley", "tilted-plane"];

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cartridges")
}

fn read(name: &str) -> Cartridge {
    let path = folder().join(name).join("cartridge.toml");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    Cartridge::parse(&text).unwrap_or_else(|error| panic!("{name}/cartridge.toml: {error}"))
}

fn draw(model: Model, scene: &Scene) -> Drawn {
    let (generator, scalar): (&dyn Generator, _) = match model {
        Model::MachineF64 => (&HybridMachine, Scalar::F64),
        Model::MachineF32 => (&HybridMachine, Scalar::F32),
        Model::Exact => (&Exact, Scalar::F64),
    };
    let scene = Scene { scalar, ..scene.clone() };
    scene.draw(generator, 0, &["*"]).expect("a scene that can be drawn")
}

/// What is wrong with a run of `scene` on `model`, if the answers of `meant` are right.
fn faults(cartridge: &Cartridge, meant: &SceneFile, run: &SceneFile, model: Model) -> Vec<String> {
    let mut faults = Vec::new();
    for (meant, run) in meant.variants().iter().zip(run.variants()) {
        let drawn = draw(model, &run.scene());
        for expect in cartridge.expect.iter().filter(|expect| expect.models.contains(&model)) {
            faults.extend(
                reading::fault(expect, meant, &drawn).map(|fault| format!("{}: {fault}", meant.what())),
            );
        }
    }
    faults
}

/// Right on every model that an answer holds for, and wrong under every overlay that must show.
fn check(name: &str) {
    let cartridge = read(name);
    for model in Model::ALL {
        if cartridge.expect.iter().any(|expect| expect.models.contains(&model)) {
            let faults = faults(&cartridge, &cartridge.scene, &cartridge.scene, model);
            assert!(faults.is_empty(), "{name} on {model:?}:\n{}", faults.join("\n"));
        }
    }
    for overlay in &cartridge.must_fail {
        let run = overlay.over(&cartridge).unwrap_or_else(|error| panic!("{name}, overlay: {error}"));
        for &model in &overlay.models {
            let faults = faults(&cartridge, &cartridge.scene, &run, model);
            assert!(!faults.is_empty(), "{name} does not notice on {model:?}: {}", overlay.because);
        }
    }
}

#[test]
fn flat_plane() {
    check("flat-plane");
}

#[test]
fn fold_table() {
    check("fold-table");
}

#[test]
fn lunoid_horizon() {
    check("lunoid-horizon");
}

#[test]
fn one_coefficient() {
    check("one-coefficient");
}

#[test]
fn ridge_hides_valley() {
    check("ridge-hides-valley");
}

#[test]
fn tilted_plane() {
    check("tilted-plane");
}

#[test]
fn every_folder_is_run() {
    let entries = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap());
    let folders = entries.filter(|entry| entry.path().is_dir());
    let mut names: Vec<_> = folders.map(|entry| entry.file_name().into_string().unwrap()).collect();
    names.sort();
    assert_eq!(names, CARTRIDGES);
}

#[test]
fn every_cartridge_must_fail_on_something() {
    for name in CARTRIDGES {
        assert!(!read(name).must_fail.is_empty(), "{name}");
    }
}

#[test]
fn unknown_keys_and_formats_are_refused() {
    let text = fs::read_to_string(folder().join("flat-plane/cartridge.toml")).unwrap();
    let refused = |from: &str, to: &str| Cartridge::parse(&text.replacen(from, to, 1)).unwrap_err();
    assert!(refused("format = 1", "format = 2").contains("format"));
    assert!(refused("albedo =", "albido =").contains("albido"));
    assert!(refused("title =", "titel =").contains("titel"));
}
