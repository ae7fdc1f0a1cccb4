//! The requests `explain`, `events`, `omissions`, `parameters` and `faults`.

use drive::{DriveError, EventWishes, Explained, FaultRow, Filter, Omission, Parameter, Weight};
use serde_json::{Map, Value, json};

use crate::keys::Keys;
use crate::poses::Which;
use crate::session::Reply;
use crate::{Home, Session};

/// Events that are listed unless a request says how many.
const MOST_EVENTS: u64 = 10_000;

impl<H: Home> Session<H> {
    pub(crate) fn explain(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let which = Which::of(&keys);
        let pixel = [keys.place("column"), keys.place("line")].map(Option::unwrap_or_default);
        keys.finish()?;
        let Explained { cause, because, text, document } = which.at(self.held()?)?.explain(pixel)?;
        Ok(json!({ "cause": cause, "because": because, "text": text, "document": document }).into())
    }

    pub(crate) fn events(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let which = Which::of(&keys);
        let filter = Filter {
            unit: keys.texts("unit"),
            event: keys.texts("event"),
            colour: keys.texts("colour"),
            level: keys.text("level"),
            from: keys.whole("from"),
            to: keys.whole("to"),
        };
        let limit = keys.count("limit").unwrap_or(MOST_EVENTS);
        let wishes = EventWishes { sweeps: keys.sweeps("sweeps"), filter, limit: Some(limit) };
        keys.finish()?;
        let events = which.at(self.held()?)?.events(&wishes)?;
        let Value::Object(mut ok) = events.document else { return Ok(Value::Null.into()) };
        ok.remove("schema");
        ok.insert("tick_us".into(), events.tick_us.into());
        ok.insert("note".into(), events.note.into());
        Ok(Value::Object(ok).into())
    }

    pub(crate) fn omissions(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows = self.held()?.drive.omissions();
        Ok(json!({ "omissions": rows.iter().map(omission_json).collect::<Vec<_>>() }).into())
    }

    pub(crate) fn parameters(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows = self.held()?.drive.parameters();
        Ok(json!({ "parameters": rows.iter().map(parameter_json).collect::<Vec<_>>() }).into())
    }

    pub(crate) fn faults(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows = self.held()?.drive.faults();
        Ok(json!({ "faults": rows.iter().map(fault_json).collect::<Vec<_>>() }).into())
    }
}

/// What was left out; levels are those of 255.
pub(crate) fn omission_json(omission: &Omission) -> Value {
    let Omission { block, what, why, weight } = omission;
    let (weight, levels) = match weight {
        Weight::Lossless => ("lossless", None),
        Weight::NotModelled => ("not modelled", None),
        Weight::Bounded(levels) => ("bounded", Some(levels)),
    };
    json!({ "block": block, "what": what, "why": why, "weight": weight, "levels": levels })
}

fn parameter_json(parameter: &Parameter) -> Value {
    let Parameter { key, value, kind, unit, low, high, words, source } = parameter;
    json!({ "key": key, "value": value, "kind": kind, "unit": unit, "low": low, "high": high, "words": words,
            "source": source })
}

fn fault_json(FaultRow { name, proves, predicts, keys }: &FaultRow) -> Value {
    let keys: Map<String, Value> = keys.iter().cloned().collect();
    json!({ "name": name, "proves": proves, "predicts": predicts, "keys": keys })
}
