//! What other generators get: heights for a bank, and a list of craters.

use survey::{SurveyOptions, survey};
use terrain_builder::{LandscapeFile, NoNearest};

use crate::{FEATURES, HEAD, built, file_of, near};

#[test]
fn heights_and_nearest_craters_together_are_the_ground() {
    let straight = FEATURES[0].replace("= 8.0", "= 90.0");
    let ground = built(&format!("{HEAD}{straight}{}", FEATURES[2]));
    let export = ground.exported();
    let is_border = |(_, reason): &(String, NoNearest)| *reason == NoNearest::Border;
    assert!(export.kept.iter().all(is_border) && export.craters.len() > 20, "{}", export.craters.len());
    let [corner, _] = ground.description().grid.extent();
    let bound: f64 = export.craters.iter().map(|nearest| nearest.largest_difference).sum();
    for line in (0..export.elevation.lines).step_by(3) {
        for column in (0..export.elevation.columns).step_by(3) {
            let place = export.elevation.place(line, column);
            let in_bank = [place[0] - corner[0], place[1] - corner[1]];
            let added = export.craters.iter().map(|nearest| {
                let centre = nearest.crater.centre();
                let way = [in_bank[0] - centre[0], in_bank[1] - centre[1]];
                nearest.crater.profile((way[0] * way[0] + way[1] * way[1]).sqrt())[0]
            });
            let sum = export.elevation.height(line, column).unwrap() + added.sum::<f64>();
            near(sum, ground.height(place), bound);
            near(sum, ground.height(place), 4.0 * export.largest_difference());
        }
    }
}

#[test]
fn a_crater_that_the_machine_cannot_draw_stays_in_the_heights_and_is_named() {
    let ground = built(&file_of(&[0, 1]));
    let export = ground.exported();
    assert!(export.kept.contains(&("north-crater".into(), NoNearest::Oblique)));
    assert_eq!((export.craters.len(), export.largest_difference()), (0, 0.0));
    for (line, column) in [(0, 0), (20, 31), (60, 40)] {
        let place = export.elevation.place(line, column);
        assert_eq!(export.elevation.height(line, column), Some(ground.height(place)));
    }
}

#[test]
fn the_list_of_craters_is_read_back_to_the_bit() {
    let export = built(&file_of(&[2])).exported();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("craters.csv");
    std::fs::write(&path, export.crater_list()).unwrap();
    let read = features::list::read(&path).unwrap();
    assert_eq!(read.len(), export.craters.len());
    for (read, nearest) in read.iter().zip(&export.craters) {
        assert_eq!(read, nearest.crater);
    }
}

#[test]
fn a_bank_is_fitted_and_lies_where_the_landscape_does() {
    let ground = built(&file_of(&[1]));
    let export = ground.exported();
    let found = survey(&export.elevation, &SurveyOptions::new(200.0), &mut |_| {}).unwrap();
    assert!(found.report.levels[0].rms < 3.0, "{}", found.report.levels[0].rms);
}

#[test]
fn a_file_is_edited_and_undone_on_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.toml");
    std::fs::write(&path, file_of(&[0])).unwrap();
    let file = LandscapeFile::new(&path);
    let text = || std::fs::read_to_string(&path).unwrap();
    file.add(FEATURES[1]).unwrap();
    file.remove("north-crater").unwrap();
    assert!(text().contains("hill") && !text().contains("north-crater"));
    assert_eq!(file.journal().unwrap().edits().len(), 2);
    assert_eq!(file.undo().unwrap(), "remove north-crater");
    assert_eq!(file.undo().unwrap(), "add");
    assert_eq!(text(), file_of(&[0]));
    assert!(file.undo().expect_err("nothing left").to_string().contains("nothing to undo"));
}

#[test]
fn edits_at_one_time_follow_one_another() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.toml");
    std::fs::write(&path, file_of(&[0])).unwrap();
    let boulder = |number: usize| {
        let place = "longitude_deg = 3.05\nlatitude_deg = 26.03\nradius_m = 8.0\nshape = \"cube\"\n";
        format!("[[feature]]\nid = \"b{number}\"\nkind = \"boulder\"\n{place}")
    };
    std::thread::scope(|scope| {
        for number in 0..6 {
            let (path, block) = (&path, boulder(number));
            scope.spawn(move || LandscapeFile::new(path).add(&block).unwrap());
        }
    });
    let text = std::fs::read_to_string(&path).unwrap();
    assert!((0..6).all(|number| text.contains(&format!("id = \"b{number}\""))), "{text}");
    assert_eq!(LandscapeFile::new(&path).journal().unwrap().edits().len(), 6);
    assert!(!folder.path().join(files::LOCK).exists());
}

#[test]
fn an_edit_that_makes_no_landscape_leaves_the_file_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.toml");
    std::fs::write(&path, file_of(&[0])).unwrap();
    let file = LandscapeFile::new(&path);
    let wrong = FEATURES[1].replace("iterations = 3", "iterations = 0");
    let told = file.add(&wrong).expect_err("refused").to_string();
    assert!(told.contains("`feature[1].iterations` is 0"), "{told}");
    assert!(
        file.remove("nothing").expect_err("refused").to_string().contains("expected one of north-crater")
    );
    assert_eq!(std::fs::read_to_string(&path).unwrap(), file_of(&[0]));
    assert!(!file.journal_path().exists());
    let missing = LandscapeFile::new(folder.path().join("none.toml"));
    assert!(missing.add(FEATURES[1]).expect_err("refused").to_string().contains("none.toml"));
}
