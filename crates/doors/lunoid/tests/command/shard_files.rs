//! The files of `docs/shards/` run as they stand.

use std::fs;
use std::path::Path;
use std::process::Command;

use assert_cmd::cargo::cargo_bin;

use crate::scene::Scene;

/// A file of `docs/shards/`, run by a shell in the folder of `scene`.
fn run(scene: &Scene, file: &str, arguments: &[&str], variables: &[(&str, &str)]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/shards").join(file);
    let mut command = Command::new("sh");
    command.arg(path).args(arguments).current_dir(scene.path()).env("LUNOID", cargo_bin("lunoid"));
    for name in ["LUNOID_SHARDS", "LUNOID_THREADS", "JOB_COMPLETION_INDEX"] {
        command.env_remove(name);
    }
    let output = command.envs(variables.iter().copied()).output().expect("a shell");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{file}: {said}");
}

/// The joined run is that of one machine.
fn expect_whole(scene: &Scene, shards: usize) {
    scene.expect(0, &["replay", "tiny.toml", "--out", "whole"]);
    for name in ["run.json", "index.html", "page.json", "poses.csv", "contact-sheet.png"] {
        let [whole, joined] =
            ["whole", "runs/tiny"].map(|folder| fs::read(scene.join(folder).join(name)).unwrap());
        assert!(whole == joined, "{name} differs");
    }
    assert_eq!(scene.list("runs").len(), shards + 1);
}

/// The script of a task, in the environment that Slurm gives to it.
#[test]
fn the_files_of_slurm_draw_and_join() {
    let scene = Scene::new();
    for task in ["1", "2", "3"] {
        let variables = [
            ("SLURM_ARRAY_TASK_ID", task),
            ("SLURM_ARRAY_TASK_MIN", "1"),
            ("SLURM_ARRAY_TASK_MAX", "3"),
            ("SLURM_ARRAY_TASK_COUNT", "3"),
            ("SLURM_CPUS_PER_TASK", "1"),
        ];
        run(&scene, "slurm.sh", &["tiny.toml"], &variables);
    }
    // A task that is run again alone.
    let again = [
        ("SLURM_ARRAY_TASK_ID", "2"),
        ("SLURM_ARRAY_TASK_MIN", "2"),
        ("SLURM_ARRAY_TASK_MAX", "2"),
        ("SLURM_ARRAY_TASK_COUNT", "1"),
        ("LUNOID_SHARDS", "3"),
    ];
    run(&scene, "slurm.sh", &["tiny.toml"], &again);
    run(&scene, "slurm-merge.sh", &["tiny.toml", "3"], &[]);
    expect_whole(&scene, 3);
}

/// A real array, on whatever nodes the Slurm of this machine has.
#[test]
fn a_slurm_array_draws_and_joins() {
    let nodes = Command::new("sinfo").args(["--noheader", "--states=idle,mixed", "--format=%n"]).output();
    if !nodes.is_ok_and(|output| output.status.success() && !output.stdout.is_empty()) {
        eprintln!(
            "SKIPPED: no node of a Slurm is idle here, so docs/shards/slurm.sh was run by a shell alone"
        );
        return;
    }
    let scene = Scene::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/shards");
    let submit = |options: &[&str], file: &str, arguments: &[&str]| {
        let mut command = Command::new("sbatch");
        command.arg("--wait").args(options).arg(folder.join(file)).args(arguments);
        let output = command.current_dir(scene.path()).env("LUNOID", cargo_bin("lunoid")).output().unwrap();
        assert!(output.status.success(), "{file}: {}", String::from_utf8_lossy(&output.stderr));
    };
    submit(&["--array=1-3"], "slurm.sh", &["tiny.toml"]);
    submit(&[], "slurm-merge.sh", &["tiny.toml", "3"]);
    expect_whole(&scene, 3);
}

#[test]
fn the_file_of_gnu_parallel_draws_and_joins() {
    let version = Command::new("parallel").arg("--version").output();
    let is_gnu =
        version.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).starts_with("GNU parallel"));
    if !is_gnu {
        eprintln!("SKIPPED: GNU parallel is not installed, so docs/shards/parallel.sh was not run");
        return;
    }
    let scene = Scene::new();
    run(&scene, "parallel.sh", &["tiny.toml", "4", "2"], &[]);
    expect_whole(&scene, 4);
}
