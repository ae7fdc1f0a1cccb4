//! What the script of the page works with, as one JSON document.

use serde_json::{Value, json};

use crate::film::Film;
use crate::run::Run;
use crate::strip::Small;
use crate::viewer::{SPEEDS, USUAL_SPEED};
use crate::{Beside, SweepWaves};

/// Returns the document that the script of the page reads.
pub(crate) fn data(run: &Run, beside: &Beside, strip: &[Small], film: &Film) -> Value {
    let first = run.first_picture();
    let scopes: Vec<Value> = beside.scopes.iter().map(|plot| json!([plot.frame, plot.sweep])).collect();
    let timed =
        beside.timing.as_ref().map(|timing| timing.frames.iter().zip(&timing.late).collect::<Vec<_>>());
    json!({
        "first": first,
        "end": first + run.pictures(),
        "showings": run.showings(),
        "rate": run.picture_rate(),
        "columns": run.view.columns,
        "lines": run.view.lines,
        "speeds": SPEEDS,
        "speed": USUAL_SPEED,
        "poses": run.poses.iter().map(|pose| pose.map(rounded)).collect::<Vec<_>>(),
        "strip": strip.iter().map(|small| small.picture).collect::<Vec<_>>(),
        "film": film.pictures,
        "sight": beside.sight,
        "scopes": scopes,
        "waves": embedded(&beside.waves),
        "late": timed.unwrap_or_default(),
        "stage": shell_words(&beside.stage),
        "pictures": run.picture_words(),
    })
}

/// Most values of waveforms that are part of the page: some 30 MB.
const MOST_VALUES: usize = 3_000_000;

/// The first of `waves` for which there is room.
pub(crate) fn embedded(waves: &[SweepWaves]) -> &[SweepWaves] {
    let mut room = MOST_VALUES;
    let fits = |of: &SweepWaves| match room.checked_sub(of.size()) {
        Some(left) => {
            room = left;
            true
        }
        None => false,
    };
    let count = waves.iter().map(fits).take_while(|fits| *fits).count();
    &waves[..count]
}

/// To four places: tenths of a millimetre, and less than an arc second. A person reads no more.
fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// The document inside a script element: nothing in it can end the element.
pub(crate) fn in_script(document: &Value) -> String {
    let document = document.to_string();
    text::visible_json(&document).replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

/// Words as a shell takes them.
pub(crate) fn shell_words(words: &[String]) -> String {
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
}

fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=+@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.into(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::{in_script, shell_words};

    #[test]
    fn a_script_element_cannot_be_ended() {
        let document = json!({ "a": "</script><!--&\u{2028}" });
        let text = in_script(&document);
        assert!(!text.contains(['<', '>', '&']), "{text}");
        assert_eq!(serde_json::from_str::<Value>(&text).expect("JSON"), document);
    }

    #[test]
    fn words_of_a_shell() {
        let words = ["scenarios/a.toml", "--set", "raster.sweeps=5", "it's; rm *", ""].map(str::to_owned);
        assert_eq!(shell_words(&words), "scenarios/a.toml --set raster.sweeps=5 'it'\\''s; rm *' ''");
    }
}
