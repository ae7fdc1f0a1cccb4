//! Folders: interrupted, damaged, foreign, of another plan, and their hashes.

use std::fs;

use dataset::{DataFolder, JOURNAL, MANIFEST, Outcome, RECORD, Record};
use run_record::hash;

use crate::scene::{PLAN, Scene, control, files, program, rows};

#[test]
fn an_interrupted_data_set_goes_on_to_the_same_bytes() {
    let scene = Scene::new(PLAN);
    let whole = files(&scene.make_all("whole"));
    let outcome = scene.make_until("parts", 0..9, 2).unwrap();
    let Outcome::Interrupted { done, of: 9 } = outcome else { panic!("{outcome:?}") };
    assert!((2..9).contains(&done) && scene.path("parts").join(JOURNAL).is_file());
    assert!(!scene.path("parts").join(RECORD).exists());
    // Half a line, as a kill leaves it.
    let journal = scene.path("parts").join(JOURNAL);
    let text = fs::read(&journal).unwrap();
    fs::write(&journal, &text[..text.len() - 5]).unwrap();
    assert_eq!(scene.make("parts", 0..9).unwrap(), Outcome::Finished { made: 9 - (done - 1) });
    assert!(files(&scene.path("parts")) == whole);
}

#[test]
fn threads_change_no_byte() {
    let scene = Scene::new(PLAN);
    let whole = files(&scene.make_all("whole"));
    let plan = scene.plan();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let folder = DataFolder::claim(&scene.path("one")).unwrap();
    let job = dataset::Job { plan: &plan, program: program(), samples: 0..9 };
    control(u64::MAX, |control| {
        dataset::run(&job, &folder, &replay::Control { pool: &pool, ..*control }).map(drop).unwrap();
    });
    drop(folder);
    assert!(files(&scene.path("one")) == whole);
}

#[test]
fn a_finished_data_set_is_kept_and_a_damaged_sample_made_again() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("out");
    let whole = files(&folder);
    assert_eq!(scene.make("out", 0..9).unwrap(), Outcome::Finished { made: 0 });
    assert!(files(&folder) == whole);
    let row = &rows(&folder)[3];
    let path = folder.join(&row.file.file);
    let mut bytes = fs::read(&path).unwrap();
    bytes[1000] ^= 1;
    fs::write(&path, bytes).unwrap();
    fs::remove_file(folder.join(&rows(&folder)[5].file.file)).unwrap();
    assert_eq!(scene.make("out", 0..9).unwrap(), Outcome::Finished { made: 2 });
    assert!(files(&folder) == whole);
}

#[test]
fn a_data_set_without_its_manifest_is_made_again_and_joined_by_nobody() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("out");
    let whole = files(&folder);
    fs::remove_file(folder.join(MANIFEST)).unwrap();
    let joined = DataFolder::claim(&scene.path("joined")).unwrap();
    let refused = control(u64::MAX, |control| {
        dataset::join(std::slice::from_ref(&folder), &joined, control).unwrap_err()
    });
    let told = refused.to_string();
    assert!(told.contains("manifest.jsonl: this file is gone; make the data set again"), "{told}");
    assert_eq!(scene.make("out", 0..9).unwrap(), Outcome::Finished { made: 9 });
    assert!(files(&folder) == whole);
}

#[test]
fn a_data_set_without_its_record_is_no_foreign_folder() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("out");
    fs::remove_file(folder.join(RECORD)).unwrap();
    let told = DataFolder::claim(&folder).unwrap_err().to_string();
    assert!(
        told.contains("dataset.json: this file is gone, and `") && told.contains("remove the folder"),
        "{told}"
    );
    fs::write(folder.join("notes.txt"), "mine").unwrap();
    for name in [MANIFEST, "README.md", "LICENSE.txt", "plan.toml", "contact-sheet.png"] {
        fs::remove_file(folder.join(name)).unwrap();
    }
    for (loader, _) in dataset::LOADERS {
        fs::remove_file(folder.join(loader)).unwrap();
    }
    let told = DataFolder::claim(&folder).unwrap_err().to_string();
    assert!(told.contains("holds `notes.txt`, which is no file of a data set"), "{told}");
}

#[test]
fn every_file_is_as_it_is_listed() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("out");
    let record = Record::read(&folder).unwrap().unwrap();
    let all = files(&folder);
    let listed = record.outputs.iter().map(|file| (&file.file, &file.blake3));
    let rows = rows(&folder);
    let listed: Vec<_> = listed.chain(rows.iter().map(|row| (&row.file.file, &row.file.blake3))).collect();
    for (name, blake3) in &listed {
        assert_eq!(**blake3, hash(&all[*name]), "{name}");
    }
    // All files but the record itself.
    assert_eq!(listed.len() + 1, all.len(), "{:?}", all.keys());
    assert!(rows.iter().all(|row| row.file.file.starts_with(row.split.name())));
    let names: Vec<&str> = record.arrays.iter().filter_map(|array| array["name"].as_str()).collect();
    assert_eq!(names, ["picture", "split", "changed", "range", "label"]);
    let card = String::from_utf8_lossy(&all["README.md"]).into_owned();
    for word in ["# Tiny", "CC0-1.0", "## How it was made", "## Limits", "tear", "late_words", "block"] {
        assert!(card.contains(word), "{word}:\n{card}");
    }
}

#[test]
fn folders_of_somebody_else_are_refused() {
    let scene = Scene::new(PLAN);
    fs::create_dir(scene.path("mine")).unwrap();
    fs::write(scene.path("mine").join("thesis.txt"), "mine").unwrap();
    let said = scene.make("mine", 0..9).expect_err("foreign").to_string();
    assert!(
        said.contains("thesis.txt") && fs::read(scene.path("mine").join("thesis.txt")).unwrap() == b"mine"
    );
    scene.make_all("out");
    let other = scene.make("out", 0..3).expect_err("a part").to_string();
    assert!(other.contains("another data set") && other.contains("samples"), "{other}");
    let text = PLAN.replace("seed = 7", "seed = 8");
    fs::write(scene.path("plan.toml"), text).unwrap();
    let other = scene.make("out", 0..9).expect_err("another plan").to_string();
    assert!(other.contains("plan.blake3 (other content)"), "{other}");
}

#[test]
fn a_record_that_was_changed_is_refused() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("out");
    let path = folder.join(RECORD);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"of\": 9", "\"of\": 8")).unwrap();
    assert!(scene.make("out", 0..9).expect_err("changed").to_string().contains("sealed"));
    fs::write(&path, text).unwrap();
    let manifest = folder.join("manifest.jsonl");
    let lines = fs::read_to_string(&manifest).unwrap();
    fs::write(&manifest, lines.replace("train", "tests")).unwrap();
    assert!(scene.make("out", 0..9).expect_err("changed").to_string().contains("manifest.jsonl"));
}

#[test]
fn samples_that_are_not_there_are_refused() {
    let scene = Scene::new(PLAN);
    for samples in [3..3, 0..10, 9..12] {
        let said = scene.make("out", samples).expect_err("none").to_string();
        assert!(said.contains("samples 0..9"), "{said}");
    }
    assert!(!scene.path("out").exists(), "nothing is left");
}
