//! Sheets and overlays in their places.

use super::*;

#[test]
fn sheets_stand_on_what_their_height_says() {
    let corners = |tables: &str, time: f64| made(tables).effects(time).sheets[0].corners.clone();
    let slanted = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[100, 7, 0], [200, 7, 0], [200, 7, 9]]",
    );
    let ups = |height: &str| {
        let found = corners(&format!("{slanted}height = '{height}'\n"), 0.0);
        found.iter().map(|corner| (1e6 * corner.z).round() / 1e6).collect::<Vec<_>>()
    };
    assert_eq!(ups("foot"), [10.0, 10.0, 19.0]);
    assert_eq!(ups("ground"), [10.0, 20.0, 29.0]);
    assert_eq!(ups("datum"), [0.0, 0.0, 9.0]);
    // Beside the ground there is a datum, and no ground.
    let far = SHEET.replace("100", "-100");
    assert_eq!(corners(&format!("{far}height = 'datum'\n"), 0.0)[0], DVec3::new(-100.0, 0.0, 0.0));
    let moves = "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50, heading_deg = 90 }, \
        { t_s = 2, x_m = 200, y_m = 50 }] }\n";
    let moving = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[3, 0, 0], [3, 1, 0], [3, 1, 2]]",
    );
    let found = corners(&format!("{moving}{moves}"), 0.0);
    assert!(found[1].distance(DVec3::new(99.0, 53.0, 10.0)) < 1e-9, "{found:?}");
    let found = corners(&format!("{moving}{moves}"), 2.0);
    assert!(found[1].distance(DVec3::new(203.0, 51.0, 20.0)) < 1e-9, "{found:?}");
}

#[test]
fn what_has_no_ground_is_named() {
    let refused = |tables: &str| match placed(&parsed(tables)) {
        Ok(_) => panic!("{tables}"),
        Err(SceneryProblems(problems)) => problems,
    };
    let string = format!("{LAMP}count = 5\nto = {{ x_m = 800, y_m = 50 }}\n");
    let problems = refused(&format!("{string}{}", SHEET.replace("'a'", "'b'").replace("100", "700")));
    let named = |problem: &SceneryProblem| match problem {
        SceneryProblem::EffectOutside { what, id, x, .. } => (*what, id.clone(), *x),
        other => panic!("{other}"),
    };
    let found: Vec<_> = problems.iter().map(named).collect();
    assert_eq!(
        found,
        [("light", "a".into(), 625.0), ("light", "a".into(), 800.0), ("sheet", "b".into(), 700.0)]
    );
    assert!(problems[0].to_string().contains("light \"a\" at t = 0 s: x = 625.00 m"), "{}", problems[0]);
    let stray =
        "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }, { t_s = 7, x_m = 100, y_m = -1 }] }\n";
    for (base, what) in [(LAMP, "light"), (SHEET, "sheet")] {
        let problems = refused(&format!("{base}{stray}"));
        assert!(problems[0].to_string().contains(&format!("{what} \"a\" at t = 7 s")), "{}", problems[0]);
    }
    // Corners that follow a slope in two ways are not flat.
    let bent = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[100, 0, 0], [200, 0, 0], [200, 50, 3], [100, 50, 0]]",
    );
    let problems = refused(&format!("{bent}height = 'ground'\n"));
    let text = problems[0].to_string();
    assert!(problems.len() == 1 && text.contains("sheet \"a\" on its ground: corner 0 is"), "{text}");
    // An object without ground is one problem, with a lamp on it or without.
    assert_eq!(refused(&CARRIED.replace("x_m = 300", "x_m = 3000")).len(), 1);
}

#[test]
fn overlays_and_sheets_keep_their_numbers() {
    let other = |table: &str, id: &str| table.replace("'a'", &format!("'{id}'"));
    let tables = [other(SHEET, "a"), other(SHEET, "b"), other(OVERLAY, "c"), other(OVERLAY, "d")].concat();
    let effects = made(&tables.replacen("tau = 0.7", "tau = 0.7\nfrom_s = 1", 1)).effects(0.0);
    assert_eq!(effects.sheets.iter().map(|sheet| sheet.id).collect::<Vec<_>>(), [1]);
    assert_eq!(effects.overlays.iter().map(|overlay| overlay.id).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(effects.overlays[0].corners, [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]]);
}
