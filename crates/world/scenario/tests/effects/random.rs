//! Random tables, good and broken.

use super::*;

/// A value of a key, good or broken.
fn value() -> impl Strategy<Value = String> {
    prop_oneof![
        (-20.0..400.0).prop_map(|number: f64| format!("{number:?}")),
        (-3i64..40).prop_map(|number| number.to_string()),
        prop_oneof![
            Just("nan"),
            Just("inf"),
            Just("-inf"),
            Just("true"),
            Just("''"),
            Just("'a'"),
            Just("'ground'"),
            Just("'cart'"),
            Just("[]"),
            Just("[1, 2, 3]"),
            Just("[0.5, 0.5, 0.5]"),
            Just("[[1, 2, 3]]"),
            Just("1e308"),
            Just("-1e308"),
            Just("[[0, 0], [1, 0], [0, 1]]"),
            Just("[[9, 9, 0], [90, 9, 0], [9, 90, 5]]"),
            Just("[[0, 0, nan]]"),
            Just("{}"),
            Just("{ x_m = 300, y_m = 300 }"),
            Just("{ half_angle_deg = 9 }"),
            Just("{ period_s = 1e-300 }"),
            Just("{ spin_deg_s = 9 }"),
            Just("{ keyframes = [{ t_s = 0, x_m = 90, y_m = 90 }] }"),
            Just("'stars.csv'"),
        ]
        .prop_map(str::to_owned),
    ]
}

/// Keys of a table with values, each key at most once.
fn table(head: &'static str, keys: &'static [&'static str]) -> impl Strategy<Value = String> {
    let lines = prop::sample::subsequence(keys, 0..=keys.len());
    lines.prop_flat_map(move |keys| {
        let count = keys.len();
        (Just(keys), prop::collection::vec(value(), count)).prop_map(move |(keys, values)| {
            let lines = keys.iter().zip(values).map(|(key, value)| format!("{key} = {value}\n"));
            format!("{head}\n{}", lines.collect::<String>())
        })
    })
}

const LIGHT_KEYS: &[&str] = &[
    "x_m",
    "y_m",
    "above_m",
    "azimuth_deg",
    "elevation_deg",
    "magnitude",
    "on",
    "at_m",
    "diameter_m",
    "intensity",
    "colour",
    "priority",
    "calligraphic",
    "beam",
    "flash",
    "from_s",
    "until_s",
    "moves",
    "count",
    "to",
];
const SHEET_KEYS: &[&str] = &[
    "corners_m",
    "height",
    "colour",
    "priority",
    "tau",
    "kappa_1_m",
    "thickness_m",
    "from_s",
    "until_s",
    "moves",
];
const OVERLAY_KEYS: &[&str] = &["corners", "colour", "priority", "tau", "from_s", "until_s"];
const STAR_KEYS: &[&str] = &["seed", "count", "brightest", "faintest", "file", "calligraphic", "turn_deg"];
const EARTH_KEYS: &[&str] = &["azimuth_deg", "elevation_deg", "diameter_deg", "albedo"];

/// Whether all numbers of effects are finite, and directions unit vectors.
fn are_sound(effects: &Effects) -> bool {
    let light = |light: &LightPoint| match light.source {
        LightSource::Lamp { at, diameter } => at.is_finite() && diameter > 0.0,
        LightSource::Star { direction, magnitude } => direction.is_normalized() && magnitude.is_finite(),
    };
    let disc = |disc: &SkyDisc| disc.direction.is_normalized() && disc.angular_diameter > 0.0;
    effects.lights.iter().all(light)
        && effects.discs.iter().all(disc)
        && effects.sheets.iter().flat_map(|sheet| &sheet.corners).all(|corner| corner.is_finite())
}

/// Whether tables are read, placed and sound at several times. Nothing panics, whatever is refused.
fn is_seen(tables: &str) -> bool {
    let Ok(scenario) = Scenario::parse("t.toml", &format!("{GOOD}{tables}")) else { return false };
    let Ok(scenery) = placed(&scenario) else { return false };
    [0.0, 0.7, 12.0].iter().all(|time| are_sound(&scenery.effects(*time)))
}

proptest! {
    #[test]
    fn random_tables_never_panic(
        light in table("[[light]]\nid = 'l'", LIGHT_KEYS),
        sheet in table("[[sheet]]\nid = 's'", SHEET_KEYS),
        overlay in table("[[overlay]]\nid = 'o'", OVERLAY_KEYS),
        stars in table("[stars]", STAR_KEYS),
        earth in table("[earth]", EARTH_KEYS),
    ) {
        for tables in [&light, &sheet, &overlay, &stars, &earth] {
            is_seen(tables);
        }
        let object = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\n";
        is_seen(&format!("{object}{light}{sheet}{overlay}{stars}{earth}"));
    }

    #[test]
    fn random_good_tables_are_placed(
        x in 1.0..300.0, y in 1.0..300.0, diameter in 1e-3..1e4, count in 2u32..40, beam in 0.1..90.0,
        corner in 0.1..50.0, kappa in 0.0..10.0, seed in 0u64..1000, elevation in -90.0..90.0,
    ) {
        let light = format!("[[light]]\nid = 'l'\nx_m = {x:?}\ny_m = {y:?}\ndiameter_m = {diameter:?}\n");
        let string = format!("count = {count}\nto = {{ x_m = {y:?}, y_m = {x:?} }}\nbeam = {{ half_angle_deg = {beam:?} }}\n");
        let sheet = format!(
            "[[sheet]]\nid = 's'\ncorners_m = [[{x:?}, {y:?}, 0], [{x:?}, {:?}, 0], [{x:?}, {y:?}, {corner:?}]]\n\
             kappa_1_m = {kappa:?}\nthickness_m = {corner:?}\n", y + corner);
        let earth = format!("[earth]\nazimuth_deg = {x:?}\nelevation_deg = {elevation:?}\n");
        let sky = format!("[stars]\nseed = {seed}\ncount = {count}\n{earth}");
        prop_assert!(is_seen(&[light, string, sheet, sky].concat()));
    }
}
