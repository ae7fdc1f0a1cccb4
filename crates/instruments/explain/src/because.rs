//! The answer in words.

use quantities::fixed;

use crate::ground::GroundPoint;
use crate::late::Late;
use crate::seek::{Explanation, ReadSweep, Writer};

/// Below this a pixel counts as dark.
const DARK: f64 = 0.02;
/// From here on the error against the closed form is worth a sentence: two levels of 255.
const TELLING: f64 = 2.0 / 255.0;

/// Why the pixel is as it is: who wrote it, what made it bright or dark, what was late, how far it is from right.
pub fn because(told: &Explanation) -> Vec<String> {
    let mut reasons = vec![writer(told)];
    if let Some(ground) = told.ground.as_ref().filter(|_| told.writer == Writer::Ground) {
        reasons.push(light(ground));
        reasons.extend(driven(ground));
        reasons.extend(stale(ground));
        reasons.extend(not_there(ground));
    }
    reasons.extend(told.body.map(body));
    reasons.extend(told.lights.iter().map(|light| format!("{}: {}", light.what, light.value)));
    reasons.extend(digital(told));
    reasons.extend(reading(told));
    reasons.extend(error(told));
    reasons
}

fn writer(told: &Explanation) -> String {
    let sweep = told.place.sweep;
    match (&told.ground, told.writer) {
        (Some(ground), Writer::Ground) => format!(
            "sweep {sweep} drew it at sample {}: ground at {:.1} m, {} level, region {}, {}",
            ground.sample, ground.range_m, ground.level, ground.region[0], ground.region[1]
        ),
        (Some(ground), Writer::Body) => {
            format!("a body covers it on sweep {sweep}; behind it lies ground at {:.1} m", ground.range_m)
        }
        (None, Writer::Body) => format!("a body covers it on sweep {sweep}; behind it is sky"),
        (_, Writer::Silhouette) => {
            format!("a stored outline stands there, behind the last sample of sweep {sweep}")
        }
        _ => match told.highest {
            Some((line, range)) => format!(
                "sky: no stroke of sweep {sweep} crosses cell {}; its profile reaches up to {line:.2}, at {range:.1} m",
                told.place.cell
            ),
            None => format!("sky: sweep {sweep} wrote nothing"),
        },
    }
}

/// What made a polyhedron bright or dark.
fn body(reflectivity: f64) -> String {
    let face = if reflectivity <= DARK { "is turned from the sun or in shadow" } else { "is lit" };
    format!(
        "pg.present is on, so that VS3 shows the polyhedron, whose face {face}: pg.reflectivity {reflectivity:.3}"
    )
}

/// What made the ground bright or dark.
fn light(ground: &GroundPoint) -> String {
    let value = ground.reflectivity;
    match ground {
        _ if ground.in_shadow => {
            format!(
                "sc.gate is on: something stands between it and the sun, and mu.vs2 puts black there ({value:.3})"
            )
        }
        GroundPoint { features_shown: true, .. } if value <= DARK => {
            format!("mu.vs1 shows a crater, whose face here is turned from the sun ({value:.3})")
        }
        GroundPoint { features_shown: true, .. } => {
            format!("mu.vs1 shows a crater in the light ({value:.3})")
        }
        &GroundPoint { terrain_slopes: [north, east], terrain_reflectivity: own, .. } => {
            let slope = sides(north, east);
            let how = if own <= DARK { "is turned from the sun" } else { "is lit" };
            let mixed = if (value - own).abs() > TELLING {
                format!("; texture and fades make {value:.3} of it, mu.reflectivity")
            } else {
                String::new()
            };
            format!("tg.reflectivity: the slope ({slope}) {how} ({own:.3}){mixed}")
        }
    }
}

fn sides(north: f64, east: f64) -> String {
    format!("{} north, {} east", fixed(north, 3), fixed(east, 3))
}

/// What lies between the mixing unit and the tube.
fn driven(ground: &GroundPoint) -> Option<String> {
    let GroundPoint { reflectivity, video, .. } = ground;
    ((video - reflectivity).abs() > TELLING).then(|| {
        format!(
            "sm.video is {video:.3} where mu.reflectivity is {reflectivity:.3}: its delay line, or the blanking, is not where \
             the position is"
        )
    })
}

fn stale(ground: &GroundPoint) -> impl Iterator<Item = String> {
    ground.colours.iter().filter(|colour| colour.stale).map(|colour| {
        let [m, n] = colour.wanted;
        match (colour.held, colour.stale_words.as_slice()) {
            (_, words) if words.len() < 9 => {
                let words: Vec<String> = words.iter().map(|[p, q]| format!("({p}, {q})")).collect();
                let (some, have) = match words.len() {
                    1 => ("word", "is of another corner"),
                    _ => ("words", "are of another corner"),
                };
                format!(
                    "tg.{}.hold: {some} {} {have} than {m}, {n}, which the region has",
                    colour.colour,
                    words.join(", ")
                )
            }
            (Some([p, q]), _) => {
                format!(
                    "tg.{}.hold is stale: it holds corner {p}, {q}; the region has {m}, {n}",
                    colour.colour
                )
            }
            (None, _) => {
                format!("tg.{}.hold is empty: the data bank has not delivered corner {m}, {n}", colour.colour)
            }
        }
    })
}

/// What the data banks have not brought yet, beside corners.
fn not_there(ground: &GroundPoint) -> impl Iterator<Item = String> {
    let craters: Vec<String> = ground.craters_not_there.iter().map(u32::to_string).collect();
    let craters = (!craters.is_empty()).then(|| {
        format!("no storage buffer has crater {} yet (deadline feature-record)", craters.join(", "))
    });
    let shadows = ground.shadows_not_there.then(|| {
        "no storage buffer has the boundaries of shadow that lie here yet (deadline shadow-record)".to_owned()
    });
    craters.into_iter().chain(shadows)
}

fn digital(told: &Explanation) -> Vec<String> {
    let mut reasons = Vec::new();
    let (sweep, drawn) = (told.place.sweep, told.place.drawn_with);
    if sweep != drawn {
        reasons.push(format!(
            "the set-up of sweep {sweep} was not ready: that of sweep {drawn} was drawn again"
        ));
    }
    for read in &told.read {
        let in_force = read.late.iter().filter(|late| late.in_force);
        reasons.extend(in_force.map(|late| {
            format!(
                "late words in force in sweep {}: {} {}, due at {} (dpu.late, cause {})",
                read.sweep,
                late.colour,
                late.register,
                late.place(),
                late.cause
            )
        }));
        reasons.extend(earlier(read));
    }
    reasons
}

/// Late words of a sweep that no register lacks any more: what they moved has gone into the hold, and into parts and tubes.
fn earlier(read: &ReadSweep) -> Option<String> {
    let mut places: Vec<String> = read.late.iter().filter(|late| !late.in_force).map(Late::place).collect();
    places.dedup();
    (!places.is_empty()).then(|| {
        format!(
            "words of sweep {} that were late before it, and are in force no more: {}; the hold, parts and tubes keep what they did",
            read.sweep,
            places.join(", ")
        )
    })
}

/// What the read beam and the tubes made of it.
fn reading(told: &Explanation) -> Option<String> {
    let difference = told.intensity - told.left;
    (difference.abs() > TELLING).then(|| {
        let from: Vec<String> = told.read.iter().map(part_of).collect();
        let tube = if told.has_tube { "; tubes add residue and noise" } else { "" };
        format!(
            "sm.write left {:.3}; the read-out shows {}: its beam lies at cell {}, and takes {}{tube}",
            told.left,
            fixed(told.intensity, 3),
            fixed(told.place.between_cells, 2),
            from.join(" and ")
        )
    })
}

/// What the read beam takes of a sweep.
fn part_of(read: &ReadSweep) -> String {
    format!("{:.0} % of sweep {} ({:.3})", 100.0 * read.weight, read.sweep, read.left)
}

fn error(told: &Explanation) -> Option<String> {
    let exact = told.exact.as_ref()?;
    let difference = told.intensity - exact.intensity;
    let place =
        exact.range_m.map_or_else(|| "sky".to_owned(), |range| format!("{} at {range:.1} m", exact.label));
    Some(if difference.abs() <= TELLING {
        format!("exact agrees: {:.3}, {place}", exact.intensity)
    } else {
        let word = if difference < 0.0 { "darker" } else { "brighter" };
        format!("exact has {:.3}, {place}: the machine is {:.3} {word}", exact.intensity, difference.abs())
    })
}
