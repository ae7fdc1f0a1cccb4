//! Folders of exports: whole, replaced whole, and never in the place of something else.

use std::fs;
use std::path::Path;

use terrain_database::Database;
use terrain_export::{FILES, Wishes, write_folder};

use crate::{USUAL, exported};

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Files of ground without textures.
fn bare_files() -> Vec<&'static str> {
    FILES.into_iter().filter(|name| *name != "albedo.png").collect()
}

#[test]
fn an_export_has_all_files_and_replaces_an_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    let (_, first) = exported(USUAL);
    write_folder(&first, &out).unwrap();
    assert_eq!(names(&out), bare_files());
    assert_eq!(names(&out.join("boulders")), ["0.obj", "1.obj"]);
    assert_eq!(Database::open(out.join("terrain.lod")).unwrap(), first.database);
    let (_, second) = exported(Wishes { step: Some(0.001), ..USUAL });
    write_folder(&second, &out).unwrap();
    assert_eq!(Database::open(out.join("terrain.lod")).unwrap(), second.database);
    assert_eq!(names(folder.path()), ["moon"], "nothing stays beside the folder");
}

#[test]
fn a_folder_of_somebody_else_stays() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.txt"), "years of work").unwrap();
    let error = write_folder(&exported(USUAL).1, folder.path()).expect_err("not ours").to_string();
    assert!(error.contains("a folder with \"thesis.txt\" in it; expected an empty folder"), "{error}");
    assert_eq!(names(folder.path()), ["thesis.txt"]);
}

/// A killed export leaves a new folder that is not whole, or the old one aside.
#[test]
fn what_a_killed_export_left_is_mended() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    let (_, export) = exported(USUAL);
    write_folder(&export, &out).unwrap();
    fs::rename(&out, folder.path().join(".moon.old")).unwrap();
    fs::create_dir(folder.path().join(".moon.new")).unwrap();
    fs::write(folder.path().join(".moon.new/terrain.lod"), "half").unwrap();
    write_folder(&export, &out).unwrap();
    assert_eq!(names(folder.path()), ["moon"]);
    assert_eq!(names(&out), bare_files());
}

/// The old folder stays where the new one cannot take its place: the old one is put back.
#[test]
fn a_failed_export_leaves_the_old_folder() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    let (_, export) = exported(USUAL);
    write_folder(&export, &out).unwrap();
    let before = fs::read(out.join("terrain.lod")).unwrap();
    // A file stands where the new folder is to be written.
    fs::write(folder.path().join(".moon.new"), "in the way").unwrap();
    let (_, other) = exported(Wishes { step: Some(1.0), ..USUAL });
    write_folder(&other, &out).expect_err("no place for the new folder");
    assert_eq!(fs::read(out.join("terrain.lod")).unwrap(), before);
}

/// Files of the names of an export are not an export.
#[test]
fn somebody_elses_files_of_our_names_stay() {
    let export = exported(USUAL).1;
    for (name, content) in [
        ("scenario.toml", "# my own scenario"),
        ("ground.bank", "my bank"),
        ("export.json", "{}"),
        ("export.json", "{\"schema\": \"other/1\"}"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(name), content).unwrap();
        let error = write_folder(&export, folder.path()).expect_err(name).to_string();
        assert!(error.contains(&format!("a folder with \"{name}\" in it")), "{error}");
        assert_eq!(fs::read_to_string(folder.path().join(name)).unwrap(), content);
    }
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    write_folder(&export, &out).unwrap();
    fs::write(out.join("boulders/mine.obj"), "v 0 0 0").unwrap();
    let error = write_folder(&export, &out).expect_err("a shape of somebody else").to_string();
    assert!(error.contains("boulders/mine.obj"), "{error}");
    assert!(out.join("boulders/mine.obj").exists());
}

#[cfg(unix)]
#[test]
fn a_link_is_not_replaced_by_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let (there, link) = (folder.path().join("there"), folder.path().join("link"));
    let export = exported(USUAL).1;
    write_folder(&export, &there).unwrap();
    std::os::unix::fs::symlink(&there, &link).unwrap();
    let error = write_folder(&export, &link).expect_err("a link").to_string();
    assert!(error.contains("a link or a file; expected a folder"), "{error}");
    assert!(link.is_symlink() && there.join("terrain.lod").exists());
}
