//! What is lit and how: `[sun]`, `[shadows]`, `[photometry]`, `[texture]`, `[[silhouette]]`.

use diagnostics::{Placed, Problem, Reader};
use landscape::{Layer, Photometry, Silhouette, Source, Sun};
use limits::Limit;
use quantities::radians;

use super::all;
use crate::{Drift, ShadowFineness, TextureWish};

/// The sun at the start, and where it goes from there.
pub(super) fn sun(table: &Reader) -> Option<(Sun, Option<Drift>)> {
    let first = direction(table);
    let stations = table.tables("drift");
    let step = table.f64("step_s").above(0.0).at_most(1e6).unit("s").placed();
    if !table.has("drift") {
        return refuse_lone_step(table, step.optional()).and(first).map(|sun| (sun, None));
    }
    let step = step.help("the sun, its light and its shadows are renewed every step").required();
    let stations = ascending(table, all(stations.iter().map(station)));
    let drift = Drift { stations: stations?, step: step.as_ref()?.value };
    check_steps(table, &drift, &step?)?;
    Some((first?, Some(drift)))
}

fn direction(table: &Reader) -> Option<Sun> {
    let azimuth = table.f64("azimuth_deg").between(-360.0, 360.0).unit("degrees").required();
    let elevation = table.f64("elevation_deg").above(0.0).at_most(90.0).unit("degrees").required();
    Some(Sun { azimuth: radians(azimuth?), elevation: radians(elevation?) })
}

fn station(table: &Reader) -> Option<Placed<(f64, Sun)>> {
    let time = table.f64("t_s").above(0.0).at_most(1e6).unit("s").placed().required();
    let sun = direction(table);
    let Placed { value: time, place, key } = time?;
    Some(Placed { value: (time, sun?), place, key })
}

fn ascending(table: &Reader, stations: Option<Vec<Placed<(f64, Sun)>>>) -> Option<Vec<(f64, Sun)>> {
    let stations = stations?;
    let falls = |pair: &&[Placed<(f64, Sun)>]| pair[1].value.0 <= pair[0].value.0;
    let falling: Vec<_> = stations.windows(2).filter(falls).collect();
    for pair in &falling {
        let (before, time) = (pair[0].value.0, pair[1].value.0);
        let title = format!("t = {time} s after t = {before} s: times must ascend");
        table.report(Problem::of(&pair[1], title).expected(format!("more than {before}")));
    }
    falling.is_empty().then(|| stations.into_iter().map(|station| station.value).collect())
}

fn refuse_lone_step(table: &Reader, step: Option<Placed<f64>>) -> Option<()> {
    let Some(step) = step else { return (!table.has("step_s")).then_some(()) };
    let title = format!("`{}` without `{}`", step.key, table.path("drift"));
    table.report(Problem::of(&step, title).expected("a `drift` beside it, or neither of the two"));
    None
}

fn check_steps(table: &Reader, drift: &Drift, step: &Placed<f64>) -> Option<()> {
    let steps = drift.steps();
    if Limit::SunSteps.allows(steps as u64) {
        return Some(());
    }
    let title = format!("{steps} steps of {} s: the sun can take {}", step.value, Limit::SunSteps.value());
    table.report(Problem::of(step, title).expected("a longer step").help(Limit::SunSteps.to_string()));
    None
}

/// Remote shadow; nothing where the table is missing or says that it is not drawn.
pub(super) fn shadows(table: &Reader) -> Option<Option<ShadowFineness>> {
    let usual = ShadowFineness::default();
    let enabled = table.bool("enabled").default(true);
    let finest = table.f64("finest_m").between(0.01, 1000.0).unit("m").default(usual.finest);
    let angle = table.f64("angle_mrad").between(0.0, 100.0).unit("mrad").map(|angle| 1e-3 * angle);
    let angle = angle.default(usual.angle);
    let reach = table.f64("reach_m").above(0.0).at_most(1e6).unit("m").optional();
    let fineness = ShadowFineness { finest: finest?, angle: angle?, reach };
    Some(enabled?.then_some(fineness))
}

/// The law of reflection; `strength` and `exponent` are needed by `specular` only, but may stand beside any.
pub(super) fn photometry(table: &Reader) -> Option<Photometry> {
    #[derive(Clone, Copy, PartialEq)]
    enum Law {
        Plain(Photometry),
        Specular,
    }
    let words = [
        ("lambert", Law::Plain(Photometry::Lambert)),
        ("lommel-seeliger", Law::Plain(Photometry::LommelSeeliger)),
        ("lunar-lambert", Law::Plain(Photometry::LunarLambert)),
        ("specular", Law::Specular),
    ];
    let law = table.one_of("law", &words).required();
    let strength = table.f64("strength").between(0.0, 100.0);
    let exponent = table.u32("exponent").between(1, 128);
    if law == Some(Law::Specular) {
        let (strength, exponent) = (strength.required(), exponent.required());
        return Some(Photometry::Specular { strength: strength?, exponent: exponent? });
    }
    strength.optional();
    exponent.optional();
    match law? {
        Law::Plain(photometry) => Some(photometry),
        Law::Specular => None,
    }
}

pub(super) fn texture(table: &Reader) -> Option<TextureWish> {
    let source =
        table.one_of("source", &[("pattern", Source::Pattern), ("random", Source::Random)]).required();
    let seed = table.u64("seed").default(0);
    let layers = table.tables("layer");
    let count = layers.len();
    let layers = all(layers.iter().map(layer));
    if !(1..=MAX_LAYERS).contains(&count) {
        let title = format!("a texture of {count} layers");
        table.report(table.problem("layer", title).expected(format!("1 to {MAX_LAYERS} tables `layer`")));
        return None;
    }
    Some(TextureWish { source: source?, seed: seed?, layers: layers? })
}

/// As many as a texture takes.
const MAX_LAYERS: usize = 8;

fn layer(table: &Reader) -> Option<Layer> {
    let cell = table.f64("cell_m").between(0.001, 1e6).unit("m").required();
    let amplitude = table.f64("amplitude").between(0.0, 1.0).required();
    let range = table.f64("range_m").above(0.0).at_most(1e6).unit("m").required();
    Some(Layer { cell: cell?, amplitude: amplitude?, range: range? })
}

pub(super) fn silhouette(table: &Reader) -> Option<Silhouette> {
    let reflectivity = table.f64("reflectivity").between(0.0, 1.0).required();
    let is_point = |pairs: &Vec<[f64; 2]>| {
        pairs.iter().all(|[azimuth, elevation]| azimuth.abs() <= 720.0 && elevation.abs() <= 60.0)
    };
    let rule = "each of azimuth (-720 to 720) and elevation (-60 to 60), degrees";
    let outline = table.f64_pairs("outline_deg").must(rule, is_point).required();
    let point = |[azimuth, elevation]: [f64; 2]| [radians(azimuth), libm::tan(radians(elevation))];
    let outline = outline?.into_iter().map(point).collect();
    let report = |error: landscape::SilhouetteError| {
        let title = format!("this outline is none: {error}");
        table.report(table.problem("outline_deg", title));
    };
    Silhouette::new(outline, reflectivity?).map_err(report).ok()
}
