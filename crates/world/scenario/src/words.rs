//! Keys that scenarios and hardware models share, read the same way in both.

use diagnostics::{Field, Placed, Problem, Reader};
use quantities::Rate;

use crate::{
    BodyShading, BodyVisibility, Curvature, FeatureLight, Occlusion, PixelRule, Projection, RangeLaw,
    RangeProgramme, ShadowedBodies, TextureInShadow,
};

/// The name of a model: it is looked up, and is never a path.
pub fn model_name<'a>(table: &Reader<'a>, key: &str) -> Field<'a, String> {
    let is_name = |name: &String| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
    table.string(key).must("a name of letters, digits and dashes", is_name)
}

/// Reads the key `projection`: the projection law.
pub fn projection<'a>(table: &Reader<'a>) -> Field<'a, Projection> {
    use Projection::{AsReported, Corrected, Exact};
    table.one_of("projection", &[("as-reported", AsReported), ("corrected", Corrected), ("exact", Exact)])
}

/// The shape of the lunoid.
pub fn curvature<'a>(table: &Reader<'a>) -> Field<'a, Curvature> {
    use Curvature::{Exact, None, Parabolic};
    table.one_of("curvature", &[("none", None), ("parabolic", Parabolic), ("exact", Exact)])
}

/// The finding of hidden ground.
pub fn occlusion<'a>(table: &Reader<'a>) -> Field<'a, Occlusion> {
    table.one_of("occlusion", &[("derivative", Occlusion::Derivative), ("peak-hold", Occlusion::PeakHold)])
}

/// From a line to a pixel.
pub fn pixel_rule<'a>(table: &Reader<'a>) -> Field<'a, PixelRule> {
    table.one_of("pixel_rule", &[("line-mean", PixelRule::LineMean), ("centre", PixelRule::Centre)])
}

/// What the light of features is worked out from; models and scenarios have their own `key` for it.
pub fn feature_light<'a>(table: &Reader<'a>, key: &str) -> Field<'a, FeatureLight> {
    table.one_of(key, &[("as-reported", FeatureLight::AsReported), ("combined", FeatureLight::Combined)])
}

/// When bodies are seen; models and scenarios have their own `key` for it.
pub fn body_visibility<'a>(table: &Reader<'a>, key: &str) -> Field<'a, BodyVisibility> {
    table.one_of(key, &[("as-reported", BodyVisibility::AsReported), ("depth", BodyVisibility::Depth)])
}

/// Bodies in remote shadow.
pub fn shadowed_bodies<'a>(table: &Reader<'a>) -> Field<'a, ShadowedBodies> {
    table.one_of("shadowed_bodies", &[("vanish", ShadowedBodies::Vanish), ("dark", ShadowedBodies::Dark)])
}

/// Light over the faces of bodies; models and scenarios have their own `key` for it.
pub fn body_shading<'a>(table: &Reader<'a>, key: &str) -> Field<'a, BodyShading> {
    table.one_of(key, &[("flat", BodyShading::Flat), ("smooth", BodyShading::Smooth)])
}

/// Texture in remote shadow.
pub fn texture_in_shadow<'a>(table: &Reader<'a>) -> Field<'a, TextureInShadow> {
    table.one_of("texture_in_shadow", &[("on", TextureInShadow::On), ("off", TextureInShadow::Off)])
}

/// A rate in units of `unit` hertz: a whole number, or a fraction in quotes such as `"30000/1001"`, so that every
/// clock is an exact fraction. A float such as 29.97 is refused: it is nobody's rate.
pub fn rate<'a>(table: &Reader<'a>, key: &str, unit: u64) -> Field<'a, Rate> {
    const RULE: &str = "above 0 and at most 1000000, or a fraction in quotes such as \"30000/1001\"";
    if is_quoted(table, key) {
        let text = table.string(key).must(RULE, move |text| fraction(text, unit).is_some());
        return text.map(move |text| fraction(&text, unit).expect("the rule has seen to it"));
    }
    let whole = move |number: u64| exact_rate(number, 1, unit);
    let number = table.u64(key).must(RULE, move |&number| whole(number).is_some());
    number.map(move |number| whole(number).expect("the rule has seen to it"))
}

fn is_quoted(table: &Reader, key: &str) -> bool {
    let place = table.place(key);
    let text = place.source.text.get(place.span.clone()).unwrap_or_default();
    table.has(key) && text.starts_with(['"', '\''])
}

fn fraction(text: &str, unit: u64) -> Option<Rate> {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    exact_rate(numerator.trim().parse().ok()?, denominator.trim().parse().ok()?, unit)
}

/// Beyond a million of its unit a rate would overflow the products of a timebase.
fn exact_rate(numerator: u64, denominator: u64, unit: u64) -> Option<Rate> {
    let is_small = numerator / 1_000_000 <= denominator && denominator <= 1_000_000;
    let rate = Rate::new(numerator.checked_mul(unit)?, denominator)?;
    is_small.then_some(rate)
}

/// A ground-range programme; every key of the table belongs to it. `switch_m` and `fine_share` are needed by
/// `two-rate` only, but may stand beside any, so that a model can be changed by one word.
pub fn range(table: &Reader) -> Option<RangeProgramme> {
    let word = table
        .one_of(
            "programme",
            &[
                ("constant-rate", Programme::ConstantRate),
                ("two-rate", Programme::TwoRate),
                ("constant-elevation", Programme::ConstantElevation),
                ("geometric", Programme::Geometric),
            ],
        )
        .required();
    let start = table.f64("start_m").at_least(NEAREST).unit("m").placed().required();
    let end = table.f64("end_m").above(0.0).at_most(1e6).unit("m").placed().required();
    let two_rate = two_rate(table, word == Some(Programme::TwoRate), end.as_ref());
    let (start, end) = (start?, end?);
    check_ascending(table, &start, &end);
    let law = match word? {
        Programme::ConstantRate => RangeLaw::ConstantRate,
        Programme::TwoRate => two_rate?,
        Programme::ConstantElevation => RangeLaw::ConstantElevation,
        Programme::Geometric => RangeLaw::Geometric,
    };
    Some(RangeProgramme { law, start: start.value, end: end.value })
}

#[derive(Clone, Copy, PartialEq)]
enum Programme {
    ConstantRate,
    TwoRate,
    ConstantElevation,
    Geometric,
}

fn two_rate(table: &Reader, is_needed: bool, end: Option<&Placed<f64>>) -> Option<RangeLaw> {
    let switch = table.f64("switch_m").at_least(NEAREST).unit("m").placed();
    let share = table.f64("fine_share").above(0.0).below(1.0);
    if !is_needed {
        switch.optional();
        share.optional();
        return None;
    }
    let (switch, fine_share) = (switch.required(), share.required());
    let switch = switch?;
    if let Some(end) = end {
        check_ascending(table, &switch, end);
    }
    Some(RangeLaw::TwoRate { switch: switch.value, fine_share: fine_share? })
}

/// Nearest range of a sample (m): its inverse stays finite in f32.
const NEAREST: f64 = 1e-3;
/// Least ratio of two ends: a thousand samples between them stay apart.
const LEAST_RATIO: f64 = 1.0 + 1e-6;

fn check_ascending(table: &Reader, low: &Placed<f64>, high: &Placed<f64>) {
    if low.value * LEAST_RATIO >= high.value {
        let title =
            format!("`{}` = {} must be more than `{}` = {}", high.key, high.value, low.key, low.value);
        table.report(Problem::of(high, title).expected(format!("more than {} m", low.value)));
    }
}

/// Refresh must be a whole multiple of update, where both are known.
pub fn check_refresh(table: &Reader, update: Option<Rate>, refresh: Option<Rate>) {
    let (Some(update), Some(refresh)) = (update, refresh) else { return };
    if refresh.whole_ratio(update).is_none() {
        let title = format!(
            "`{}` is {refresh}, which is no whole multiple of the update rate of {update}",
            table.path("refresh_hz")
        );
        let expected = format!("a whole multiple of {update}");
        table.report(table.problem("refresh_hz", title).found(refresh.to_string()).expected(expected));
    }
}
