//! What a TIFF says about the meaning of its stored numbers: unit, scale, offset, voids.

use std::path::Path;

use tiff::tags::Tag;

use super::file::{Tiff, text};
use super::items::Items;
use super::keys::{self, Keys};
use super::tags;
use crate::error::SurveyError;
use crate::read::options::ReadOptions;
use crate::read::refusal::field;
use crate::read::samples::Said;
use crate::read::unit::{length, length_of_code};

const VERTICAL_SYSTEM: u16 = 4096;
const VERTICAL_UNIT: u16 = 4099;

/// Where the numbers of a band are described.
pub struct Source<'a> {
    /// Path of the file.
    pub path: &'a Path,
    /// Items of GDAL's metadata.
    pub items: &'a Items,
    /// Geo keys of the file.
    pub keys: &'a Keys,
    /// The band, from 0, and how many there are.
    pub band: [usize; 2],
    /// What the user says instead.
    pub options: &'a ReadOptions,
}

/// Metres of a unit of height in systems that EPSG has a code for, heights upwards; `None` for others, and for depths.
fn vertical_system(code: u16) -> Option<f64> {
    Some(match code {
        3855 | 4979 | 5030 | 5701 | 5703 | 5709 | 5711 | 5714 | 5720 | 5773 | 5783 | 5798 | 7837 => 1.0,
        8228 => 0.3048,
        5702 | 6360 => length_of_code(9003)?,
        _ => return None,
    })
}

impl Source<'_> {
    /// What the file says about the band.
    pub fn said(&self, tiff: &mut Tiff, notes: &mut Vec<String>) -> Result<Said, SurveyError> {
        let (metres, unknown_unit) = self.unit(notes);
        let of_item = |name: &str, option: Option<f64>, advice: &str| match self.items.get(name, self.band[0])
        {
            Some(text) if option.is_none() => self.number(&format!("item {name}"), text, advice).map(Some),
            _ => Ok(None),
        };
        let scale = of_item("SCALE", self.options.scale, "give --scale METRES")?.unwrap_or(1.0);
        let offset = of_item("OFFSET", self.options.offset, "give --offset METRES")?.unwrap_or(0.0);
        Ok(Said {
            voids: self.voids(tiff)?,
            stated: self.stated(tiff)?,
            scale: scale * metres,
            offset: offset * metres,
            unknown_unit,
            ..Said::default()
        })
    }

    /// Metres of the unit of the heights; 1 for one that is not known, which comes with its place.
    fn unit(&self, notes: &mut Vec<String>) -> (f64, Option<[String; 2]>) {
        let mut said: Vec<([String; 2], Option<f64>)> = Vec::new();
        if let Some(name) = self.items.get("UNITTYPE", self.band[0]).filter(|name| !name.is_empty()) {
            said.push((["item UNITTYPE".into(), name.into()], length(name)));
        }
        let codes = [(VERTICAL_UNIT, length_of_code as fn(u16) -> _), (VERTICAL_SYSTEM, vertical_system)];
        for (key, known) in codes {
            // A code without figures of its own says nothing of a system, and names no unit.
            let code =
                self.keys.get(key).filter(|code| *code != 0.0 && (key, *code) != (VERTICAL_SYSTEM, 32767.0));
            if let Some(code) = code {
                said.push(([keys::place(key), code.to_string()], known(code as u16)));
            }
        }
        let metres = said.iter().find_map(|(_, metres)| *metres).unwrap_or(1.0);
        let differs = |found: &f64| (found / metres - 1.0).abs() > 1e-9;
        let wrong = said.iter().find(|(_, found)| found.is_none_or(|found| differs(&found)));
        if said.is_empty() && self.options.scale.is_none() {
            notes.push("the file does not name the unit of its heights: metres are assumed".into());
        }
        match wrong {
            Some((place, _)) => (1.0, Some(place.clone())),
            None => (metres, None),
        }
    }

    fn number(&self, place: &str, found: &str, advice: &str) -> Result<f64, SurveyError> {
        let number = found.trim().parse::<f64>();
        number.map_err(|_| field(self.path, place, format!("{found:?}"), "a number", advice))
    }

    /// Marks of voids; none if the user gives some.
    fn voids(&self, tiff: &mut Tiff) -> Result<Vec<[f64; 2]>, SurveyError> {
        if !self.options.no_data.is_empty() {
            return Ok(Vec::new());
        }
        let place = tags::place(42113);
        let failed = |source| SurveyError::Tiff { path: self.path.into(), place: place.clone(), source };
        let advice = "give --no-data VALUE";
        let mut voids = Vec::new();
        if let Some(void) =
            text(tiff, Tag::GdalNodata).map_err(failed)?.filter(|void| !void.trim().is_empty())
        {
            voids.push(self.number(&place, &void, advice)?);
        }
        let [band, bands] = self.band;
        for item in self.items.voids(band) {
            let numbers: Vec<&str> = item.text.split([' ', ',']).filter(|text| !text.is_empty()).collect();
            let number = match numbers.as_slice() {
                [one] => one,
                each if each.len() == bands => each[band],
                _ => item.text.as_str(),
            };
            voids.push(self.number(&format!("item {}", item.name), number, advice)?);
        }
        Ok(voids.into_iter().map(|void| [void; 2]).collect())
    }

    /// Least and greatest stored number, as the file states them.
    fn stated(&self, tiff: &mut Tiff) -> Result<[f64; 2], SurveyError> {
        let mut end = |tags: [Tag; 2], usual: f64| {
            for tag in tags {
                let failed = |source| SurveyError::Tiff {
                    path: self.path.into(),
                    place: tags::place(tag.to_u16()),
                    source,
                };
                let value = tiff.find_tag(tag).map_err(failed)?;
                let numbers = value.and_then(tags::numbers);
                let of_band = |numbers: Vec<f64>| numbers.get(self.band[0]).or(numbers.first()).copied();
                if let Some(number) = numbers.and_then(of_band) {
                    return Ok::<_, SurveyError>(number);
                }
            }
            Ok(usual)
        };
        let low = end([Tag::SMinSampleValue, Tag::MinSampleValue], f64::NEG_INFINITY)?;
        let high = end([Tag::SMaxSampleValue, Tag::MaxSampleValue], f64::INFINITY)?;
        // Old programs leave the tags at 0, or at what does not fit into them.
        Ok(if low < high { [low, high] } else { Said::default().stated })
    }
}
