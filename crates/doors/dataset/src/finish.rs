//! The files beside the samples: manifest, licence, plan, loaders, contact sheet, card, record. All are functions of the record's head and
//! the rows, so that a joined data set has the bytes of one that was made at once.

use picture::{AnyPicture, ColourPicture, GreyPicture, SOFTWARE, contact_sheet};
use replay::{TRUTH_ERROR, TruthItem};
use run_record::{FileRecord, hash};
use serde_json::{Value, json};

use crate::DatasetError;
use crate::arrays::{CHANGED, PICTURE, SPLIT, read_picture};
use crate::card::card;
use crate::folder::{CARD, DataFolder, LICENCE, LOADERS, MANIFEST, PLAN, RECORD, SHEET};
use crate::plan::Plan;
use crate::record::{MadeFrom, PlanRecord, Record, SCHEMA};
use crate::row::Row;
use crate::run::expect_shape;

/// Most samples on the contact sheet.
const SHEET_SAMPLES: usize = 24;
/// Samples in a row of it.
const SHEET_COLUMNS: usize = 6;
/// Columns of one of its pictures at most.
const CELL_COLUMNS: usize = 240;

/// Texts that a data set takes over: the plan and the licence.
pub(crate) struct Texts {
    pub plan: Vec<u8>,
    pub licence: Vec<u8>,
}

impl Texts {
    /// The texts of `plan`. Without a file of its own the licence is named, and where its text is found.
    pub fn of(plan: &Plan) -> Result<Self, DatasetError> {
        let licence = match &plan.licence_file {
            Some(name) => files::read_all(plan.file(name), limits::Limit::TextBytes)?,
            None => {
                let Plan { title, licence, .. } = plan;
                format!("SPDX-License-Identifier: {licence}\n\nThe samples of the data set \"{title}\" are under this licence. Its text is the one that SPDX\nlists under this name. Elevations, shapes and pictures that the scenarios read keep their own licences.\n")
                    .into_bytes()
            }
        };
        Ok(Self { plan: plan.text.clone(), licence })
    }
}

impl Record {
    /// A record without arrays and outputs, which [`finish`] adds.
    pub(crate) fn of(samples: [u64; 2], of: u64, made_from: MadeFrom, plan: PlanRecord) -> Self {
        Self { schema: SCHEMA.into(), samples, of, made_from, plan, arrays: Vec::new(), outputs: Vec::new() }
    }
}

/// Writes everything beside the samples, whose `rows` ascend. The record comes last.
pub(crate) fn finish(
    folder: &DataFolder,
    mut record: Record,
    rows: &[Row],
    texts: &Texts,
) -> Result<(), DatasetError> {
    rows.iter().try_for_each(|row| expect_shape(rows.first(), row))?;
    let line = |row: &Row| serde_json::to_string(row).expect("rows are plain values") + "\n";
    let manifest: String = rows.iter().map(line).collect();
    record.arrays = arrays(folder, rows)?;
    let mut files: Vec<(&str, Vec<u8>)> = vec![
        (MANIFEST, manifest.into_bytes()),
        (PLAN, texts.plan.clone()),
        (LICENCE, texts.licence.clone()),
        (SHEET, sheet(folder, rows)?),
        (CARD, card(&record, rows).into_bytes()),
    ];
    files.extend(LOADERS.map(|(name, text)| (name, text.as_bytes().to_vec())));
    for (name, bytes) in files {
        folder.write(name, &bytes)?;
        record.outputs.push(FileRecord { file: name.into(), blake3: hash(&bytes) });
    }
    folder.write(RECORD, record.text().as_bytes())
}

/// Every array of the samples, with its meaning.
fn arrays(folder: &DataFolder, rows: &[Row]) -> Result<Vec<Value>, DatasetError> {
    let Some(first) = rows.first() else { return Ok(Vec::new()) };
    let names = crate::arrays::names(&folder.join(&first.file.file))?;
    let [lines, columns] = [first.shape[0] as u32, first.shape[1] as u32];
    let code = |meaning: &str, shape: &[usize]| json!({ "meaning": meaning, "unit": "1", "dtype": "|u1", "shape": shape });
    let about = |name: &String| {
        let mut about = match name.as_str() {
            PICTURE => code("codes of the picture, 0..=255, as the machine shows it", &first.shape),
            SPLIT => code(
                "whose ground is seen: 0 none, 1 the split of the sample, 2 another split",
                &first.shape[..2],
            ),
            CHANGED => code(
                "1 where the picture differs from that of the healthy machine, else 0",
                &first.shape[..2],
            ),
            truth => TruthItem::ALL
                .into_iter()
                .find(|item| item.name() == truth)
                .map_or(Value::Null, |item| item.description(lines, columns)),
        };
        about["name"] = name.as_str().into();
        if TruthItem::ALL.iter().any(|item| item.name() == name) {
            about["error"] = TRUTH_ERROR.into();
        }
        about
    };
    Ok(names.iter().map(about).collect())
}

/// Some samples, evenly spread from the first to the last.
fn sheet(folder: &DataFolder, rows: &[Row]) -> Result<Vec<u8>, DatasetError> {
    let count = rows.len().min(SHEET_SAMPLES);
    let spread = |index: usize| index * (rows.len() - 1) / (count - 1).max(1);
    let read = |index: usize| read_picture(&folder.join(&rows[spread(index)].file.file));
    let chosen = (0..count).map(read).collect::<Result<Vec<AnyPicture>, _>>()?;
    let cell = chosen.first().map_or(1, AnyPicture::columns).min(CELL_COLUMNS);
    let greys: Option<Vec<&GreyPicture>> = chosen.iter().map(AnyPicture::grey).collect();
    let sheet: AnyPicture = match greys {
        Some(greys) => contact_sheet(&greys, SHEET_COLUMNS, cell)?.into(),
        None => {
            let colours: Vec<ColourPicture> = chosen.iter().map(AnyPicture::to_colour).collect();
            contact_sheet(&colours.iter().collect::<Vec<_>>(), SHEET_COLUMNS, cell)?.into()
        }
    };
    Ok(sheet.encode_png(&[SOFTWARE])?)
}
