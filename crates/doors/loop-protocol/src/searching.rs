//! The requests `trigger`, `effect` and `timing`.

use drive::{DeadlineCount, DriveError, FrameTiming, TriggerPlace, TriggerWishes, Triggered};
use serde_json::{Map, Value, json};

use crate::keys::Keys;
use crate::poses::Which;
use crate::session::Reply;
use crate::{Home, Session};

impl<H: Home> Session<H> {
    pub(crate) fn trigger(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let which = Which::of(&keys);
        let wishes = TriggerWishes {
            on: keys.needed_text("on").unwrap_or_default(),
            sweeps: keys.sweeps("sweeps"),
            samples: keys.samples("samples"),
            after: keys.optional("after", "a number", Value::as_f64),
            limit: keys.count("limit").unwrap_or(1),
        };
        keys.finish()?;
        let Triggered { frame, places, sweeps } = which.at(self.held()?)?.trigger(&wishes)?;
        let places: Vec<Value> = places.iter().map(place_json).collect();
        Ok(json!({ "frame": frame, "places": places, "sweeps": sweeps }).into())
    }

    pub(crate) fn effect(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let which = Which::of(&keys);
        let late = keys.needed_text("late").unwrap_or_default();
        keys.finish()?;
        let effect = which.at(self.held()?)?.late_effect(&late)?;
        Ok(json!({ "text": effect.text, "document": effect.document }).into())
    }

    pub(crate) fn timing(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let which = Which::of(&keys);
        keys.finish()?;
        let FrameTiming { frame, folds, late_words, missed, deadlines } = which.at(self.held()?)?.timing()?;
        let deadlines: Vec<Value> = deadlines.iter().map(deadline_json).collect();
        let ok = json!({ "frame": frame, "folds": folds, "late_words": late_words, "missed": missed, "deadlines": deadlines });
        Ok(ok.into())
    }
}

fn deadline_json(deadline: &DeadlineCount) -> Value {
    let DeadlineCount { name, count, missed, least_slack_us } = deadline;
    json!({ "name": name, "count": count, "missed": missed, "least_slack_us": least_slack_us })
}

/// A place, with the words that `lunoid trigger --json` has for it.
fn place_json(place: &TriggerPlace) -> Value {
    let TriggerPlace { sweep, hit, instant_us, pixel, is_blanked } = place;
    let values: Map<String, Value> =
        hit.readings.iter().map(|reading| (reading.signal.name.to_owned(), reading.value.into())).collect();
    json!({ "sweep": sweep, "sample": hit.sample, "instant": hit.time, "instant_us": instant_us, "range_m": hit.range,
            "values": values, "pixel": pixel, "is_blanked": is_blanked })
}
