//! A hardware model, its budget and what is found against it, as documents.

use hardware_model::{Budget, BudgetLine, Finding, Grade, GroundScale, LoadedModel, PartCounts};
use serde_json::{Map, Value, json};
use text::table;

/// Whether a machine with these findings can be built.
pub fn can_be_built(found: &[Finding]) -> bool {
    found.iter().all(|finding| finding.grade != Grade::Refuse)
}

/// A row a finding: grade, keys, message.
pub fn findings_text(found: &[Finding]) -> String {
    table(&found.iter().map(finding_row).collect::<Vec<_>>())
}

fn finding_row(finding: &Finding) -> Vec<String> {
    let grade = match finding.grade {
        Grade::Refuse => "refused".into(),
        Grade::Warn(artefact) => format!("warning {}", artefact.unwrap_or_default()).trim_end().to_owned(),
    };
    vec![grade, finding.keys.join(", "), finding.message.clone()]
}

/// What was found against a model over `ground`, as a document of schema `lunoid.model.check/1`.
pub fn findings_document(loaded: &LoadedModel, ground: GroundScale, found: &[Finding]) -> Value {
    let rows = found.iter().map(|finding| {
        let (grade, artefact) = match finding.grade {
            Grade::Refuse => ("refuse", None),
            Grade::Warn(artefact) => ("warn", artefact),
        };
        json!({ "grade": grade, "artefact": artefact, "keys": finding.keys, "message": finding.message })
    });
    json!({
        "schema": "lunoid.model.check/1",
        "name": loaded.model.name,
        "region_size_m": ground.region_size,
        "range_m": ground.range,
        "ok": can_be_built(found),
        "remarks": loaded.remarks,
        "findings": rows.collect::<Vec<_>>(),
    })
}

/// A model as a document of schema `lunoid.model/1`.
pub fn model_document(loaded: &LoadedModel) -> Value {
    let values = loaded
        .values
        .iter()
        .map(|value| json!({ "key": value.key, "value": value.value, "origin": value.origin }));
    json!({
        "schema": "lunoid.model/1",
        "name": loaded.model.name,
        "files": loaded.files.iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
        "values": values.collect::<Vec<_>>(),
    })
}

/// The same with part counts and timing budget, where they are asked for.
pub fn model_document_with(
    loaded: &LoadedModel,
    parts: Option<&PartCounts>,
    budget: Option<&Budget>,
) -> Value {
    let mut document = model_document(loaded);
    if let Some(parts) = parts {
        let counts = parts.rows().into_iter().map(|(name, count)| (name.to_owned(), json!(count)));
        document["parts"] = Value::Object(counts.collect());
    }
    if let Some(budget) = budget {
        let lines = budget.lines().into_iter();
        let figures: Map<String, Value> =
            lines.map(|BudgetLine { key, value, .. }| (key.to_owned(), json!(value))).collect();
        document["budget"] = Value::Object(figures);
    }
    document
}
