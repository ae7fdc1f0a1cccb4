//! What is lit and how: `[shadows]`, `[photometry]`, `[texture]`, `[[silhouette]]`.

use diagnostics::Reader;
use landscape::{Layer, MOST_GAIN, Photometry, Silhouette, Source};
use quantities::radians;

use super::all;
use crate::{ShadowFineness, TextureWish};

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
    let crater_gain = table.f64_array::<3>("crater_gain").between(0.0, MOST_GAIN).default([1.0; 3]);
    let layers = table.tables("layer");
    let count = layers.len();
    let layers = all(layers.iter().map(layer));
    if !(1..=MAX_LAYERS).contains(&count) {
        let title = format!("a texture of {count} layers");
        table.report(table.problem("layer", title).expected(format!("1 to {MAX_LAYERS} tables `layer`")));
        return None;
    }
    Some(TextureWish { source: source?, seed: seed?, layers: layers?, crater_gain: crater_gain? })
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
