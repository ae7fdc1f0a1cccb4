//! Faults are refused at their place.

use super::*;

#[test]
fn bad_tables_are_refused_at_their_place() {
    let with = |base: &str, keys: &str| format!("{base}{keys}\n");
    let without = |base: &str, line: &str| base.replacen(line, "", 1);
    let twins = format!("{LAMP}{}", LAMP.replace("100", "101"));
    let moves = "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }] }";
    for (tables, line, expected) in [
        (LAMP.replace("'a'", "'a b'"), 1, "letters, digits and dashes"),
        (without(LAMP, "id = 'a'\n"), 0, "missing key `light[0].id`"),
        (without(LAMP, "y_m = 50\n"), 0, "missing key `light[0].y_m`"),
        (without(LAMP, "diameter_m = 0.4\n"), 0, "missing key `light[0].diameter_m`"),
        (LAMP.replace("0.4", "0"), 4, "above 0"),
        (LAMP.replace("0.4", "10001"), 4, "at most 10000"),
        (LAMP.replace("0.4", "nan"), 4, "not nan"),
        (LAMP.replace("100", "inf"), 2, "not inf"),
        (twins, 6, "two lights, sheets or overlays are called \"a\""),
        (format!("{LAMP}{SHEET}"), 6, "two lights, sheets or overlays are called \"a\""),
        (format!("{LAMP}{OVERLAY}"), 6, "two lights, sheets or overlays are called \"a\""),
        (with(LAMP, "above_m = -1"), 5, "from 0 to 1000000"),
        (with(LAMP, "intensity = -1"), 5, "from 0 to 1000"),
        (with(LAMP, "colour = [1, 1]"), 5, "an array of 3 numbers"),
        (with(LAMP, "colour = [1, 1, 1.5]"), 5, "from 0 to 1"),
        (with(LAMP, "priority = 101"), 5, "from -100 to 100"),
        (with(LAMP, "calligraphic = 1"), 5, "true or false"),
        (with(LAMP, "beam = { power = 2 }"), 5, "missing key `light[0].beam.half_angle_deg`"),
        (with(LAMP, "beam = { half_angle_deg = 0 }"), 5, "above 0"),
        (with(LAMP, "beam = { half_angle_deg = 90.5 }"), 5, "at most 90"),
        (with(LAMP, "beam = { half_angle_deg = 9, power = -1 }"), 5, "from 0 to 10000"),
        (with(LAMP, "beam = { half_angle_deg = 9, pitch_deg = 91 }"), 5, "from -90 to 90"),
        (with(LAMP, "beam = 4"), 5, "must be a table"),
        (with(LAMP, "flash = { duty = 0.5 }"), 5, "missing key `light[0].flash.period_s`"),
        (with(LAMP, "flash = { period_s = 1, duty = 1.5 }"), 5, "from 0 to 1"),
        (with(LAMP, "flash = { period_s = 1, phase = 1 }"), 5, "below 1"),
        (with(LAMP, "from_s = 5\nuntil_s = 5"), 6, "is not after the time from which on it is there"),
        (with(LAMP, "count = 5"), 5, "`light[0].count` without `light[0].to`"),
        (with(LAMP, "to = { x_m = 1, y_m = 2 }"), 5, "`light[0].to` without `light[0].count`"),
        (with(LAMP, "to = { x_m = 1, y_m = 2 }\ncount = 1"), 6, "from 2 to 100000"),
        (with(LAMP, "to = { x_m = 1 }\ncount = 3"), 5, "missing key `light[0].to.y_m`"),
        (with(LAMP, &format!("to = {{ x_m = 1, y_m = 2 }}\ncount = 3\n{moves}")), 7, "which stands still"),
        (with(LAMP, "moves = {}"), 5, "says nothing"),
        (with(LAMP, "on = 'cart'"), 1, "is in more than one place"),
        (with(LAMP, "magnitude = 3"), 1, "is in more than one place"),
        ("[[light]]\nid = 'a'\ndiameter_m = 1\n".into(), 1, "is nowhere"),
        (with(STAR, "diameter_m = 1"), 5, "of a star, which is infinitely far"),
        (with(STAR, "beam = { half_angle_deg = 9 }"), 5, "of a star, which is infinitely far"),
        (with(STAR, moves), 5, "of a star, which is infinitely far"),
        (with(STAR, "count = 9"), 5, "of a star, which is infinitely far"),
        (without(STAR, "magnitude = 1.5\n"), 0, "missing key `light[0].magnitude`"),
        (STAR.replace("1.5", "51"), 4, "from -50 to 50"),
        (STAR.replace("30", "91"), 3, "from -90 to 90"),
        (CARRIED.replace("on = 'cart'", "on = 'car'"), 8, "one of \"cart\""),
        (without(CARRIED, "at_m = [2, 1, 3]\n"), 6, "missing key `light[0].at_m`"),
        (with(CARRIED, moves), 11, "of a lamp on an object"),
        (with(CARRIED, "count = 9"), 11, "of a lamp on an object"),
        (CARRIED[CARRIED.find("[[light]]").unwrap()..].into(), 2, "without an object that it could name"),
        (without(SHEET, "tau = 0.7\n"), 0, "missing key `sheet[0].tau` or `sheet[0].kappa_1_m`"),
        (with(SHEET, "kappa_1_m = 0.1\nthickness_m = 1"), 4, "both say how much light goes through"),
        (with(SHEET, "thickness_m = 1"), 4, "beside `tau`"),
        (SHEET.replace("tau = 0.7", "kappa_1_m = 1"), 0, "missing key `sheet[0].thickness_m`"),
        (SHEET.replace("tau = 0.7", "kappa_1_m = -1\nthickness_m = 1"), 3, "from 0 to 1000000"),
        (SHEET.replace("tau = 0.7", "tau = 1.1"), 3, "from 0 to 1"),
        (SHEET.replace("[100, 50, 0], ", "[110, 50, 0], "), 2, "beside the plane"),
        (SHEET.replace("[100, 50, 9], [100, 0, 9]", "[100, 0, 9], [100, 50, 9]"), 2, "it has no area"),
        (SHEET.replace("[100, 50, 0]", "[100, 0, 0]"), 2, "corners 0 and 1 are in one place"),
        (SHEET.replace(", [100, 50, 9], [100, 0, 9]", ""), 2, "3 to 16 of them"),
        (SHEET.replace(", [100, 50, 9], [100, 0, 9]", ", [100, 99, 0]"), 2, "on one line"),
        (SHEET.replace("[100, 50, 9]", "[100, 50]"), 2, "triples"),
        (SHEET.replace("[100, 50, 9]", "[100, 50, nan]"), 2, "not nan"),
        (SHEET.replace("[100, 50, 9]", "[100, 50, 2e7]"), 2, "from -1e7 to 1e7 m"),
        (with(SHEET, "height = 'air'"), 4, "one of \"foot\""),
        (with(SHEET, &format!("height = 'foot'\n{moves}")), 4, "beside `moves`"),
        (with(SHEET, "moves = { spin_deg_s = 3 }"), 4, "without `keyframes`"),
        (OVERLAY.replace("[1, 1]", "[1, 5]"), 2, "from -4 to 4"),
        (OVERLAY.replace("[1, 1]", "[1, 1], [0.5, 0]"), 2, "on the outer side"),
        (OVERLAY.replace(", [1, 1]", ""), 2, "3 to 16 of them"),
        (with(OVERLAY, "tau = -0.5"), 3, "from 0 to 1"),
        ("[stars]\n".into(), 0, "missing key `stars.file` or `stars.seed`"),
        ("[stars]\nseed = 1\n".into(), 0, "missing key `stars.count`"),
        ("[stars]\ncount = 1\n".into(), 0, "missing key `stars.seed`"),
        (SEEDED.replace("50", "20001"), 2, "from 1 to 20000"),
        (with(SEEDED, "faintest = -2"), 3, "not above the brightest"),
        (with(SEEDED, "turn_deg = [1, 2]"), 3, "an array of 3 numbers"),
        (with(SEEDED, "turn_deg = [1, 2, inf]"), 3, "not inf"),
        (without(EARTH, "azimuth_deg = 200\n"), 0, "missing key `earth.azimuth_deg`"),
        (with(EARTH, "diameter_deg = 0"), 3, "above 0"),
        (with(EARTH, "albedo = [1, 1, 2]"), 3, "from 0 to 1"),
        ("disc = 'yes'\n".into(), 0, "true or false"),
    ] {
        let found = faults(&tables);
        assert_eq!(found.len(), 1, "{tables}: {found:?}");
        assert!(
            found[0].0 == Some(MORE + line) && found[0].1.contains(expected),
            "{tables}: {expected}: {found:?}"
        );
    }
}

const EXAMPLES: &str = include_str!("../../../../../docs/scenario-format.md");

/// Numbers of an example from its first light on: where each begins, and its length.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let is_part = |c: char| c.is_ascii_digit() || ".-".contains(c);
    let begins = |at: &usize| {
        let before = text[..*at].chars().next_back().unwrap_or(' ');
        text[*at..].starts_with(is_part) && "[ ".contains(before)
    };
    let from = text.find("[[light]]").unwrap();
    let starts = (from..text.len()).filter(begins);
    starts.map(|at| (at, text[at..].find(|c: char| !is_part(c)).unwrap_or(0))).collect()
}

#[test]
fn no_number_may_be_nan_or_infinite() {
    let start = EXAMPLES.find("format = 1\ntitle = \"Lights\"").unwrap();
    let example = &EXAMPLES[start..start + EXAMPLES[start..].find("```").unwrap()];
    assert!(Scenario::parse("t.toml", example).is_ok());
    let numbers = numbers(example);
    assert!(numbers.len() > 100, "{}", numbers.len());
    for (at, length) in numbers {
        for word in ["nan", "inf", "-inf"] {
            let text = [&example[..at], word, &example[at + length..]].concat();
            let line = text[..at].lines().count();
            let list = Scenario::parse("t.toml", &text).expect_err(word);
            assert!(list.iter().any(|problem| problem.record().line == Some(line)), "line {line}: {list}");
        }
    }
}

#[test]
fn a_fault_of_an_object_says_nothing_about_its_lamp() {
    let found = faults(&CARRIED.replace("x_m = 300", "x_m = 'x'"));
    assert!(found.len() == 1 && found[0].1.contains("object[0].x_m"), "{found:?}");
}

#[test]
fn too_many_lamps_are_refused() {
    let string = |id: &str| {
        let lamp = LAMP.replace("'a'", &format!("'{id}'"));
        format!("{lamp}count = 60000\nto = {{ x_m = 200, y_m = 50 }}\n")
    };
    let found = faults(&format!("{}{}", string("a"), string("b")));
    assert!(found.len() == 1 && found[0].1.contains("have 120000 lamps"), "{found:?}");
    assert_eq!(found[0].0, Some(MORE + 7));
}

#[test]
fn too_many_overlays_are_told_once() {
    let twins = format!("{LAMP}{}", LAMP.replace("100", "101"));
    let overlays: String =
        (0..10_001).map(|number| OVERLAY.replace("'a'", &format!("'o{number}'"))).collect();
    let found = faults(&format!("{overlays}{twins}"));
    assert!(found.len() == 2 && found.iter().any(|fault| fault.1.contains("10001 overlays")), "{found:?}");
    // The second of the two lamps is named, whatever else there is.
    let line = MORE + 3 * 10_001 + 6;
    assert!(
        found.iter().any(|fault| fault.0 == Some(line) && fault.1.contains("are called \"a\"")),
        "{found:?}"
    );
}
