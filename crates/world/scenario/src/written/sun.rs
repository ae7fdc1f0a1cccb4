//! `[sun]`: angles, a date, or the place that has the sun overhead.

use diagnostics::{Placed, Problem, Reader};
use ephemeris::{Instant, MOON_RADIUS, Place};
use landscape::Sun;
use limits::Limit;
use quantities::radians;

use super::all;
use crate::{Drift, SubSolarPoint, SunDate, Sunlight};

/// A date as the help of messages has it.
const EXAMPLE: &str = "`at = \"1972-12-11T22:00:00Z\"`";

/// Time from one sun of a date to the next (s) unless the scenario says: the sun goes less than 0.01 degrees meanwhile.
const DATE_STEP: f64 = 60.0;

/// Key of the place that has the sun overhead.
const SUB_SOLAR: &str = "sub_solar_deg";

/// Angles at the start and where the sun goes from there, a date, or a sub-solar point. Ground that `is_generated` lies nowhere on
/// the Moon.
pub(super) fn sun(table: &Reader, is_generated: bool) -> Option<Sunlight> {
    if table.has("at") {
        dated(table, is_generated).map(Sunlight::Dated)
    } else if table.has(SUB_SOLAR) {
        under(table, is_generated).map(Sunlight::SubSolar)
    } else {
        angles(table)
    }
}

fn dated(table: &Reader, is_generated: bool) -> Option<SunDate> {
    let at = instant(table);
    let place = ground_place(table, "at", is_generated);
    let step = table.f64("step_s").above(0.0).at_most(1e6).unit("s").default(DATE_STEP);
    let alone = alone(table, "at", &[SUB_SOLAR, "azimuth_deg", "elevation_deg", "drift"], "the date");
    let date = SunDate { at: at?, place: place?, step: step? };
    alone.then_some(date)
}

/// The sun of `sun.sub_solar_deg`, which stands still.
fn under(table: &Reader, is_generated: bool) -> Option<SubSolarPoint> {
    let expected = "latitude -90 to 90 and longitude -360 to 360, in degrees";
    let is_place = |[latitude, longitude]: &[f64; 2]| latitude.abs() <= 90.0 && longitude.abs() <= 360.0;
    let point = table.f64_array::<2>(SUB_SOLAR).unit("degrees").must(expected, is_place).required();
    let place = ground_place(table, SUB_SOLAR, is_generated);
    let others = ["azimuth_deg", "elevation_deg", "drift", "step_s"];
    let alone = alone(table, SUB_SOLAR, &others, "the sub-solar point");
    let point = SubSolarPoint { point: point?.map(radians), place: place? };
    alone.then_some(point)
}

/// `sun.place`, which the sun of `key` is seen from; `Some(None)` where the bank's own place is meant.
fn ground_place(table: &Reader, key: &str, is_generated: bool) -> Option<Option<Place>> {
    let place = match table.optional_table("place") {
        Some(place) => place_of(&place).map(Some),
        None => (!table.has("place")).then_some(None),
    };
    if !is_generated || table.has("place") {
        return place;
    }
    let title = format!(
        "`{}` without `{}`: generated ground lies nowhere on the Moon",
        table.path(key),
        table.path("place")
    );
    let problem = table.problem(key, title).expected("a place on the Moon");
    table.report(problem.help(
        "add `place = { longitude_deg = 30.77, latitude_deg = 20.19 }`, or use a bank of surveyed ground",
    ));
    None
}

/// Whether none of `others` stands beside `key`, by which `what` says where the sun stands. Each that does is refused.
fn alone(table: &Reader, key: &str, others: &[&str], what: &str) -> bool {
    let beside: Vec<&&str> = others.iter().filter(|key| table.has(key)).collect();
    for other in &beside {
        let title =
            format!("`{}` beside `{}`: {what} says where the sun stands", table.path(other), table.path(key));
        let expected = "angles, a date or a sub-solar point, and one of them alone";
        table.report(table.problem(other, title).expected(expected));
    }
    // What is beside the key is known, and has been refused.
    for other in others {
        match *other {
            "drift" => table.tables("drift").iter().for_each(Reader::ignore_rest),
            other => table.know(other),
        }
    }
    beside.is_empty()
}

fn instant(table: &Reader) -> Option<Instant> {
    let text = table.string("at").help(format!("write {EXAMPLE}")).placed().required()?;
    let read = text.value.parse::<Instant>();
    let refuse = |error: ephemeris::InstantError| {
        table.report(
            Problem::of(&text, format!("`{}` = {:?}: {error}", text.key, text.value)).found(&text.value),
        );
    };
    read.map_err(refuse).ok()
}

fn place_of(table: &Reader) -> Option<Place> {
    let longitude = table.f64("longitude_deg").between(-360.0, 360.0).unit("degrees").map(radians).required();
    let latitude = table.f64("latitude_deg").between(-90.0, 90.0).unit("degrees").map(radians).required();
    Some(Place { longitude: longitude?, latitude: latitude?, radius: MOON_RADIUS })
}

fn angles(table: &Reader) -> Option<Sunlight> {
    // Asked for, so that a message about an unknown key names it.
    table.string("at").optional();
    table.know(SUB_SOLAR);
    let lone_place = table.has("place");
    if let Some(place) = table.optional_table("place").filter(|_| lone_place) {
        place.ignore_rest();
        let keys = ["place", "at", SUB_SOLAR].map(|key| table.path(key));
        let title = format!("`{}` without `{}` or `{}`", keys[0], keys[1], keys[2]);
        let problem = table.problem("place", title);
        table.report(
            problem
                .expected("a date or a sub-solar point, which the place belongs to")
                .help(format!("add {EXAMPLE}, or take the place out")),
        );
    }
    let first = first(table);
    let stations = table.tables("drift");
    let step = table.f64("step_s").above(0.0).at_most(1e6).unit("s").placed();
    if !table.has("drift") {
        let first = refuse_lone_step(table, step.optional()).and(first)?;
        return (!lone_place).then_some(Sunlight::Angles { first, drift: None });
    }
    let step = step.help("the sun, its light and its shadows are renewed every step").required();
    let stations = ascending(table, all(stations.iter().map(station)));
    let drift = Drift { stations: stations?, step: step.as_ref()?.value };
    check_steps(table, &drift, &step?)?;
    let first = first?;
    (!lone_place).then_some(Sunlight::Angles { first, drift: Some(drift) })
}

/// The sun at the start; one message where nothing says where it stands.
fn first(table: &Reader) -> Option<Sun> {
    let keys = ["azimuth_deg", "elevation_deg"];
    if keys.iter().any(|key| table.has(key)) {
        return direction(table);
    }
    // Known, so that a message about an unknown key names them.
    keys.iter().for_each(|key| table.know(key));
    let [azimuth, elevation] = keys.map(|key| table.path(key));
    let [at, sub_solar] = ["at", SUB_SOLAR].map(|key| table.path(key));
    let title = format!("missing keys `{azimuth}` and `{elevation}`, or `{at}`, or `{sub_solar}`");
    let problem = table.problem("at", title).expected("angles, a date or a sub-solar point");
    table.report(problem.help(format!("a date is written {EXAMPLE}")));
    None
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
