//! The picture with its controls and readings, and the contact sheet.

use maud::{Markup, html};
use replay::picture_name;

use crate::cells::{placed, shortened};
use crate::film::Film;
use crate::run::Run;
use crate::strip::Small;

/// Speeds at which frames are played, in those of the mission.
pub(crate) const SPEEDS: [f64; 7] = [0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];
/// Index of the one with which a page begins.
pub(crate) const USUAL_SPEED: usize = 3;

/// Keys, and what they do.
const KEYS: [(&str, &str); 8] = [
    ("space", "play, pause"),
    ("← →", "one frame back, on; with shift ten"),
    ("home, end", "first, last frame"),
    ("+ −", "faster, slower"),
    (", .", "sweep cursor left, right; with shift ten"),
    ("enter", "look into the sweep under the cursor"),
    ("esc", "no cursor"),
    ("d", "dark, light"),
];

/// Returns the first section: the viewer of pictures.
pub(crate) fn viewer(run: &Run, film: &Film) -> Markup {
    let raster = &run.view;
    let last = run.first_picture() + run.pictures() - 1;
    let style = format!("aspect-ratio:{:.6}", run.aspect());
    let coarse = raster.columns < 480;
    html! {
        section #picture aria-labelledby="picture-title" {
            h2 #picture-title { "Picture" }
            div.viewer {
                figure.tube {
                    div #screen.screen.coarse[coarse] style=(style) tabindex="0" role="group"
                        aria-label="Picture of the run: click a column to look into its sweep" aria-describedby="keys" {
                        img #frame src=(film.first) data-picture=(run.first_picture()) width=(raster.columns) height=(raster.lines)
                            alt=(format!("Picture {}", run.first_picture()));
                        svg #cursor viewBox="-1 -1 2 2" preserveAspectRatio="none" aria-hidden="true" {
                            path #late.late d="" {}
                            g #marks {}
                            line #hover.hover x1="9" x2="9" y1="-1" y2="1" {}
                            line #chosen.chosen x1="9" x2="9" y1="-1" y2="1" {}
                        }
                    }
                    p #reduced.notice hidden {
                        "This frame is neither part of this page nor beside it. The nearest one that is stands in its place."
                    }
                    (controls(run.first_picture(), last))
                    div #look.look hidden tabindex="-1" {
                        h3 #look-title { "Sweep" }
                        p #look-text {}
                        ul #commands.commands {}
                    }
                    noscript { p.notice { "Without script the page does not play. The contact sheet below leads to frames." } }
                }
                (readings(run))
            }
            (keys())
        }
    }
}

fn controls(first: u64, last: u64) -> Markup {
    let button = |id: &str, label: &str, key: &str, sign: &str| {
        html! {
            button id=(id) type="button" aria-label=(label) title=(format!("{label} ({key})")) {
                svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true" { path d=(sign) {} }
            }
        }
    };
    html! {
        div.controls.needs-script role="group" aria-label="Play" {
            (button("first", "First frame", "home", "M2 2h2v12H2zM14 2v12L5 8z"))
            (button("back", "One frame back", "left", "M12 2v12L3 8z"))
            button #play type="button" aria-label="Play" title="Play, pause (space)" { "Play" }
            (button("on", "One frame on", "right", "M4 2v12l9-6z"))
            (button("last", "Last frame", "end", "M12 2h2v12h-2zM2 2v12l9-6z"))
            input #at type="range" min=(first) max=(last) value=(first) step="1" aria-label="Frame";
            label.speed { span { "Speed" } select #speed aria-label="Speed" {
                @for (index, speed) in SPEEDS.iter().enumerate() {
                    option value=(index) selected[index == USUAL_SPEED] { (shortened(*speed, 2)) "×" }
                }
            } }
        }
        p #said.unseen aria-live="polite" {}
    }
}

/// Beside the picture: where the eye is, what the pointer is on, what was chosen.
fn readings(run: &Run) -> Markup {
    let [time, x, y, z, heading, pitch, roll] = run.poses[0];
    let metres = |value: f64| format!("{} m", placed(value, 2));
    let degrees = |value: f64| format!("{}°", placed(value, 2));
    let rows = [
        ("north", "North", metres(x)),
        ("east", "East", metres(y)),
        ("height", "Height", metres(z)),
        ("heading", "Heading", degrees(heading)),
        ("pitch", "Pitch", degrees(pitch)),
        ("roll", "Roll", degrees(roll)),
    ];
    html! {
        aside.readings aria-label="Readings" {
            p.counter { span #number { (run.first_picture()) } small { " of " (run.first_picture()) "–"
                (run.first_picture() + run.pictures() - 1) } }
            p.time #time { (placed(time, 3)) " s" }
            dl.pose { @for (id, name, value) in rows { div { dt { (name) } dd #(id) { (value) } } } }
            div.needs-script {
                h3 { "Under the pointer" }
                dl.pose {
                    div { dt { "Column, line" } dd #place { "–" } }
                    @if run.has_sweeps() { div { dt { "Sweep" } dd #under { "–" } } }
                }
                @if run.has_sweeps() {
                    h3 { "Late sweeps" }
                    dl.pose { div { dt { "Red at the edges" } dd #late-says { "–" } } }
                }
            }
        }
    }
}

fn keys() -> Markup {
    html! {
        details #keys.keys.needs-script {
            summary { "Keys" }
            dl { @for (key, what) in KEYS { div { dt { kbd { (key) } } dd { (what) } } } }
        }
    }
}

/// Returns the second section: the contact sheet.
pub(crate) fn contact_sheet(run: &Run, strip: &[Small], film: &Film) -> Markup {
    let all = strip.len() as u64 == run.pictures();
    html! {
        section #contact-sheet aria-labelledby="sheet-title" {
            h2 #sheet-title { "Contact sheet" }
            p.lead {
                @if all { "All frames. " } @else { (strip.len()) " of " (run.pictures()) " frames, evenly spread. " }
                (film.in_words(run))
            }
            ol.sheet {
                @for small in strip {
                    li { a href=(picture_name(small.picture)) data-picture=(small.picture) {
                        img src=(small.url) width=(small.columns) height=(small.lines) loading="lazy" decoding="async"
                            style=(format!("aspect-ratio:{:.6}", run.aspect())) alt=(format!("Frame {}", small.picture));
                        span { b { (small.picture) } " " (shortened(small.picture as f64 / run.picture_rate(), 2)) " s" }
                    } }
                }
            }
        }
    }
}
