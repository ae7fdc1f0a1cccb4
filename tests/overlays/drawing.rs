//! The drawing: what drives each signal.

use std::collections::BTreeSet;

use signal::name_matches;

/// The family of a signal: wires of one kind have one row.
pub fn family(name: &str) -> String {
    let is_fed = |part: &str| ["x", "cx", "y", "cy"].contains(&part);
    let is_colour = |part: &str| ["yellow", "green", "black", "red"].contains(&part);
    let mut parts: Vec<String> = Vec::new();
    let is_of_sums = |name: &str| ["product", "dac", "word"].iter().any(|word| name.contains(word));
    let is_inner = is_of_sums(name) && !name.starts_with("tg.light.");
    for part in name.split('.') {
        let behind_fn = parts.last().is_some_and(|before| before == "fn");
        let kind = part.trim_end_matches(|c: char| c.is_ascii_digit());
        match part {
            // Those of the three sums are alike.
            "u" | "v" if is_inner => {}
            _ if is_colour(part) || is_fed(part) && behind_fn => parts.push("*".into()),
            _ if part.len() > kind.len() && !part.starts_with("vs") => parts.push(format!("{kind}*")),
            _ => parts.push(part.into()),
        }
    }
    parts.join(".")
}

/// Families, and what drives them: in the order of the report's overall figure.
const DRAWING: &[(&str, &[&str])] = &[
    ("sweep.polarity.x", &["sweep.fold.x"]),
    ("sweep.polarity.y", &["sweep.fold.y"]),
    ("sweep.coarse.polarity.x", &["sweep.coarse.fold.x"]),
    ("sweep.coarse.polarity.y", &["sweep.coarse.fold.y"]),
    ("tg.*.hold", &["sweep.fold.x", "sweep.fold.y"]),
    ("tg.coarse.*.hold", &["sweep.coarse.fold.x", "sweep.coarse.fold.y"]),
    ("tg.*.word*", &["tg.*.hold"]),
    ("tg.coarse.*.word*", &["tg.coarse.*.hold"]),
    ("sweep.x", &["sweep.accumulator.x"]),
    ("sweep.y", &["sweep.accumulator.y"]),
    ("sweep.coarse.x", &["sweep.coarse.accumulator.x"]),
    ("sweep.coarse.y", &["sweep.coarse.accumulator.y"]),
    ("tg.fn.*.g*", &["sweep.x", "sweep.y"]),
    ("tg.fn.*.d*", &["sweep.x", "sweep.y"]),
    ("tg.coarse.fn.*.g*", &["sweep.coarse.x", "sweep.coarse.y"]),
    ("tg.coarse.fn.*.d*", &["sweep.coarse.x", "sweep.coarse.y"]),
    ("tg.product.*", &["tg.fn.*.g*", "tg.fn.*.d*", "sweep.polarity.x", "sweep.polarity.y"]),
    (
        "tg.coarse.product.*",
        &["tg.coarse.fn.*.g*", "tg.coarse.fn.*.d*", "sweep.coarse.polarity.x", "sweep.coarse.polarity.y"],
    ),
    ("tg.*.dac*", &["tg.product.*", "tg.*.word*"]),
    ("tg.coarse.*.dac*", &["tg.coarse.product.*", "tg.coarse.*.word*"]),
    ("tg.*.height", &["tg.*.dac*"]),
    ("tg.coarse.*.height", &["tg.coarse.*.dac*"]),
    ("tg.sum.height", &["tg.*.dac*"]),
    ("tg.sum.u", &["tg.*.dac*"]),
    ("tg.sum.v", &["tg.*.dac*"]),
    ("tg.coarse.sum.height", &["tg.coarse.*.dac*"]),
    ("tg.coarse.sum.u", &["tg.coarse.*.dac*"]),
    ("tg.coarse.sum.v", &["tg.coarse.*.dac*"]),
    ("tg.height", &["tg.sum.height", "tg.coarse.sum.height"]),
    ("tg.slope.u", &["tg.sum.u", "tg.coarse.sum.u"]),
    ("tg.slope.v", &["tg.sum.v", "tg.coarse.sum.v"]),
    ("tg.light.product.n", &["tg.slope.u"]),
    ("tg.light.product.e", &["tg.slope.v"]),
    ("tg.light.square.n", &["tg.slope.u"]),
    ("tg.light.square.e", &["tg.slope.v"]),
    ("tg.light.facing", &["tg.light.product.n", "tg.light.product.e", "tg.light.product.u"]),
    ("tg.light.squares", &["tg.light.square.n", "tg.light.square.e"]),
    ("tg.light.root", &["tg.light.squares"]),
    ("tg.light.cosine", &["tg.light.facing", "tg.light.root"]),
    ("tg.reflectivity", &["tg.light.cosine"]),
    ("fg.height", &["fg.height.*"]),
    ("fg.present", &["fg.or", "fg.comparator.*"]),
    ("fg.reflectivity", &["fg.slope.u", "fg.slope.v", "fg.or", "tg.slope.u", "tg.slope.v"]),
    ("sc.gate", &["sc.or", "sc.comparator.*"]),
    ("txg.texture", &["fg.grain"]),
    ("mu.height", &["tg.height", "fg.height"]),
    ("mu.vs1", &["fg.present"]),
    ("mu.vs2", &["sc.gate"]),
    ("mu.vs1.fade", &["mu.vs1"]),
    ("mu.vs2.fade", &["mu.vs2"]),
    ("mu.reflectivity", &["tg.reflectivity", "fg.reflectivity", "mu.vs1.fade", "mu.vs2.fade", "txg.texture"]),
    ("dpp.elevation", &["mu.height", "sweep.range"]),
    ("dpp.derivative", &["dpp.elevation"]),
    ("dpp.blank", &["dpp.derivative", "dpp.elevation"]),
    ("dpp.hold", &["dpp.elevation"]),
    ("dpp.y", &["dpp.hold"]),
    ("pg.present", &["dpp.y"]),
    ("pg.reflectivity", &["dpp.y"]),
    ("sm.video", &["mu.reflectivity", "dpp.blank"]),
    ("sm.write", &["dpp.y", "sm.video", "pg.reflectivity"]),
];

/// Families that lie behind a fault at `parts`, those of the parts with them.
pub fn behind(parts: &[&str]) -> BTreeSet<String> {
    let named = |family: &str| parts.iter().any(|part| name_matches(part, family));
    let mut found: BTreeSet<String> = BTreeSet::new();
    let all = DRAWING.iter().flat_map(|(family, drivers)| drivers.iter().chain([family]));
    found.extend(all.filter(|family| named(family)).map(|family| (*family).to_owned()));
    for (family, drivers) in DRAWING {
        if drivers.iter().any(|driver| found.contains(*driver)) {
            found.insert((*family).to_owned());
        }
    }
    found
}

#[test]
fn families_of_names() {
    for (name, expected) in [
        ("tg.u.product.34", "tg.product.*"),
        ("tg.coarse.v.red.dac8", "tg.coarse.*.dac*"),
        ("tg.yellow.word0", "tg.*.word*"),
        ("tg.fn.cx.g1", "tg.fn.*.g*"),
        ("tg.sum.u", "tg.sum.u"),
        ("mu.vs1.fade", "mu.vs1.fade"),
        ("sweep.x", "sweep.x"),
        ("tg.slope.u", "tg.slope.u"),
        ("tg.red.hold", "tg.*.hold"),
        ("fg.height.17", "fg.height.*"),
        ("tg.light.product.u", "tg.light.product.u"),
    ] {
        assert_eq!(family(name), expected, "{name}");
    }
}
