//! The head of the page: what was run.

use maud::{Markup, html};

use crate::cells::{grouped, shortened};
use crate::run::Run;

/// Title, what it shows, and the facts.
pub(crate) fn masthead(run: &Run) -> Markup {
    let number = run.fingerprint.get(..12).unwrap_or(&run.fingerprint);
    html! {
        header.masthead {
            div.running {
                span.house { "lunoid" }
                span { "Report of a run" }
                span.number title="first digits of the fingerprint of the run" { "No. " (number) }
                button #theme.needs-script type="button" aria-pressed="false" { "Dark" }
            }
            h1 { (run.scenario.title) }
            p.abstract { (run.scenario.shows) }
            dl.facts { @for (name, value) in facts(run) { div { dt { (name) } dd { (value) } } } }
            @if !run.limits.is_empty() { (limits(run)) }
        }
    }
}

fn facts(run: &Run) -> Vec<(&'static str, String)> {
    let view = &run.view;
    let (first, last) = (run.frames[0].frame, run.frames[run.frames.len() - 1].frame);
    let seconds = run.frames.len() as f64 / run.picture_rate() * run.showings() as f64;
    let file = run.scenario.file.as_ref().map_or("none".into(), |file| file.file.clone());
    let machine = match run.has_sweeps() {
        true => run.model.name.clone(),
        false => format!("{}, without a machine", run.generator),
    };
    let [width, height] = view.field_of_view_deg.map(|angle| shortened(angle, 1));
    let regions = run.ground.levels.iter().map(|level| {
        let [north, east] = level.corners.map(|count| grouped(count as u64));
        format!("{north} × {east} corners every {} m", shortened(level.region_size_m, 2))
    });
    let ground = format!("{}: {}", run.ground.source, regions.collect::<Vec<_>>().join("; "));
    let [azimuth, elevation] = [run.sun.azimuth_deg, run.sun.elevation_deg].map(|angle| shortened(angle, 1));
    let raster = run.machine.as_ref().map(|machine| {
        let [sweeps, samples] = machine.raster.counts().map(grouped);
        ("Raster", format!("{sweeps} sweeps of {samples} samples"))
    });
    let date = run.sky.as_ref().map(|sky| ("Date", sky.at.clone()));
    let facts = [
        ("Scenario", file),
        ("Machine", machine),
        ("Frames", format!("{first} to {last}, {} s", shortened(seconds, 2))),
        (
            "Picture",
            format!("{} × {}, {} bits, {width}° × {height}°", view.columns, view.lines, run.pictures.depth),
        ),
        ("Update", view.update.clone()),
        ("Ground", ground),
        ("Sun", format!("azimuth {azimuth}°, elevation {elevation}°")),
    ];
    facts.into_iter().chain(date).chain(raster).collect()
}

/// Where the vehicle does more than it can.
fn limits(run: &Run) -> Markup {
    html! {
        ul.limits aria-label="Beyond the vehicle" {
            @for limit in &run.limits {
                li {
                    "Beyond the vehicle: " (limit.limit) " of " (shortened(limit.found, 2)) " " (limit.unit) ", allowed "
                    (shortened(limit.allowed, 2)) " " (limit.unit) ", frames " (limit.frames[0]) " to "
                    (limit.frames[1].saturating_sub(1)) "."
                }
            }
        }
    }
}
