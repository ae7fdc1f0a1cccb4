//! Stars of a file and of a seed.

use super::*;

#[test]
fn a_catalogue_is_read_and_listed_among_the_files() {
    let rows = format!("{HEADER}0,90,-1.5,\n90,0,2,1.5\n");
    let (scenario, scenery) =
        dated("1972-12-11T22:00:00Z", &rows, &format!("{CATALOGUE}calligraphic = true\n"), 0.0);
    assert!(scenario.files().iter().any(|file| file.ends_with("stars.csv")));
    let lights = scenery.effects(0.0).lights;
    assert_eq!(lights.len(), 2);
    assert!(lights.iter().all(|light| light.calligraphic));
    // A white star, and an orange one.
    assert!(lights[0].colour == [1.0; 3] && lights[1].colour[0] == 1.0 && lights[1].colour[2] < 0.6);
    // The Moon's pole is 1.5 degrees from that of the ecliptic, 24 degrees from the Earth's at most.
    let elevation = degrees(libm::asin(directions(&scenery.effects(0.0))[0].z));
    assert!((elevation - 20.19).abs() < 25.1, "{elevation}");
}

#[test]
fn every_broken_row_of_a_catalogue_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("stars.csv");
    let list = |text: &str| {
        fs::write(&file, text).unwrap();
        let path = folder.path().join("s.toml");
        fs::write(&path, format!("{GOOD}{CATALOGUE}")).unwrap();
        match Scenario::read(&path) {
            Ok(_) => Vec::new(),
            Err(list) => {
                list.iter().map(|problem| (problem.record().line, problem.title.clone())).collect::<Vec<_>>()
            }
        }
    };
    assert_eq!(list(&format!("{HEADER}0,90,-1.5,\n")), []);
    let found = list(&format!("{HEADER}0,91,1,\n1,2,3,4\nnan,0,0,\n5,6,inf,\n5,6,,\n5,6,7,9\n"));
    let expected =
        [(2, "declination_deg"), (4, "right_ascension_deg"), (5, "magnitude"), (6, "magnitude"), (7, "b_v")];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for ((line, column), found) in expected.into_iter().zip(&found) {
        assert!(found.0 == Some(line) && found.1.contains(column), "{line} {column}: {found:?}");
    }
    let found = list("right_ascension_deg,declination_deg\n1,2\n");
    assert!(found.len() == 1 && found[0].1.contains("magnitude"), "{found:?}");
    let found = list(&format!("{HEADER}{}", "1,2,3,\n".repeat(20_001)));
    assert!(found.len() == 1 && found[0].1.contains("more than 20000 stars; --raise stars=N"), "{found:?}");
    assert_eq!(found[0].0, Some(20_002));
    fs::remove_file(&file).unwrap();
    let found = Scenario::read(folder.path().join("s.toml")).unwrap_err();
    assert!(found.to_string().contains("stars.csv"), "{found}");
}

#[test]
fn five_thousand_stars_stand_over_the_ground() {
    let effects = made(&SEEDED.replace("50", "5000")).effects(0.0);
    let above = directions(&effects).iter().filter(|direction| direction.z > 0.0).count();
    // Half of them, within four deviations of 35.
    assert!((above as i64 - 2500).abs() < 142, "{above}");
    let magnitude = |light: &LightPoint| match light.source {
        LightSource::Star { magnitude, .. } => magnitude,
        LightSource::Lamp { .. } => panic!("a lamp"),
    };
    let brighter =
        |limit: f64| effects.lights.iter().filter(|light| magnitude(light) - 1.46 < limit).count() as f64;
    // Ten times as many for two magnitudes.
    let ratio = brighter(5.5) / brighter(3.5);
    assert!((8.0..12.5).contains(&ratio), "{ratio}");
}
