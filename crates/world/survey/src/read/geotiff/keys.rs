//! Geo keys of a TIFF, and what becomes of each (OGC GeoTIFF 1.1, Annexes of keys).

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::SurveyError;
use crate::read::refusal::field;
use crate::read::unit::{angle_of_code, length_of_code};
use crate::read::words::Fate::{Harmless, Only, Used};
use crate::read::words::{Decider, Met, Vocabulary, numbered};

/// Text for keys that are names.
const NAME: &str = "a name for people";
/// Text for figures of projections that are not known here.
const OTHER: &str = "figure of a projection that is not known here, whose metres are taken as they are";
/// Text for codes of the body.
const BODY: &str = "a code below 32767 is of the Earth: its radius is taken, with a note";

/// All geo keys that are known.
pub const KEYS: Vocabulary = Vocabulary {
    kind: "geo key",
    prefix: "key:",
    words: &[
        numbered(
            1024,
            "GTModelTypeGeoKey",
            Used("1 projected, 2 latitude and longitude; others are refused"),
        ),
        numbered(1025, "GTRasterTypeGeoKey", Used("1 the place is that of a corner, 2 of a centre")),
        numbered(1026, "GTCitationGeoKey", Harmless(NAME)),
        numbered(2048, "GeodeticCRSGeoKey", Used(BODY)),
        numbered(2049, "GeodeticCitationGeoKey", Harmless(NAME)),
        numbered(2050, "GeodeticDatumGeoKey", Used(BODY)),
        numbered(
            2051,
            "PrimeMeridianGeoKey",
            Used("Greenwich (8901), or the one of key 2061; others are refused"),
        ),
        numbered(2052, "GeogLinearUnitsGeoKey", Used("unit of the axes; metres without it")),
        numbered(2053, "GeogLinearUnitSizeGeoKey", Used("metres of a unit of the axes that has no code")),
        numbered(2054, "GeogAngularUnitsGeoKey", Used("unit of angles; degrees without it")),
        numbered(2055, "GeogAngularUnitSizeGeoKey", Used("radians of a unit of angles that has no code")),
        numbered(2056, "EllipsoidGeoKey", Used(BODY)),
        numbered(2057, "EllipsoidSemiMajorAxisGeoKey", Used("radius of the sphere")),
        numbered(2058, "EllipsoidSemiMinorAxisGeoKey", Used("a note if it is another than key 2057")),
        numbered(2059, "EllipsoidInvFlatteningGeoKey", Used("a note if it says that the body is flattened")),
        numbered(2060, "GeogAzimuthUnitsGeoKey", Harmless("unit of azimuths, of which none is used")),
        numbered(
            2061,
            "PrimeMeridianLongitudeGeoKey",
            Used("longitude of the prime meridian, which is added"),
        ),
        numbered(2062, "GeogTOWGS84GeoKey", Harmless("a shift between data of the Earth")),
        numbered(3072, "ProjectedCRSGeoKey", Used("a code below 32767 is of the Earth: with a note")),
        numbered(3073, "ProjectedCitationGeoKey", Harmless(NAME)),
        numbered(
            3074,
            "ProjectionGeoKey",
            Harmless("code of a projection; its figures are read where they stand"),
        ),
        numbered(
            3075,
            "ProjMethodGeoKey",
            Used("15 and 14 at a pole, 17 and 21 are known; others have a note"),
        ),
        numbered(3076, "ProjLinearUnitsGeoKey", Used("unit of the map")),
        numbered(3077, "ProjLinearUnitSizeGeoKey", Used("metres of a unit of the map that has no code")),
        numbered(3078, "ProjStdParallel1GeoKey", Used("parallel that is true to scale")),
        numbered(3079, "ProjStdParallel2GeoKey", Used("0 or key 3078 in a projection that is known here")),
        numbered(3080, "ProjNatOriginLongGeoKey", Used("longitude of the origin")),
        numbered(3081, "ProjNatOriginLatGeoKey", Used("latitude of the origin")),
        numbered(3082, "ProjFalseEastingGeoKey", Used("easting of the origin")),
        numbered(3083, "ProjFalseNorthingGeoKey", Used("northing of the origin")),
        numbered(3084, "ProjFalseOriginLongGeoKey", Used("longitude of the origin")),
        numbered(3085, "ProjFalseOriginLatGeoKey", Used("latitude of the origin")),
        numbered(3086, "ProjFalseOriginEastingGeoKey", Used("easting of the origin")),
        numbered(3087, "ProjFalseOriginNorthingGeoKey", Used("northing of the origin")),
        numbered(3088, "ProjCenterLongGeoKey", Used("longitude of the origin")),
        numbered(3089, "ProjCenterLatGeoKey", Used("latitude of the origin")),
        numbered(3090, "ProjCenterEastingGeoKey", Used("easting of the origin")),
        numbered(3091, "ProjCenterNorthingGeoKey", Used("northing of the origin")),
        numbered(
            3092,
            "ProjScaleAtNatOriginGeoKey",
            Used("scale at a pole; 1 in other projections known here"),
        ),
        numbered(3093, "ProjScaleAtCenterGeoKey", Used("as key 3092")),
        numbered(3094, "ProjAzimuthAngleGeoKey", Harmless(OTHER)),
        numbered(3095, "ProjStraightVertPoleLongGeoKey", Used("longitude of the origin")),
        numbered(3096, "ProjRectifiedGridAngleGeoKey", Only(&["0"], "a turned grid")),
        numbered(
            4096,
            "VerticalGeoKey",
            Used("system of the heights: its unit, upwards; unknown codes are refused"),
        ),
        numbered(4097, "VerticalCitationGeoKey", Harmless(NAME)),
        numbered(
            4098,
            "VerticalDatumGeoKey",
            Harmless("from where heights count; a bank counts from there too"),
        ),
        numbered(4099, "VerticalUnitsGeoKey", Used("unit of the heights; metres without it, with a note")),
        numbered(5120, "CoordinateEpochGeoKey", Harmless("a time")),
    ],
};

/// The code of what has none: its figures stand in other keys.
const USER_DEFINED: f64 = 32767.0;

/// The number keys of a file.
#[derive(Debug, Default)]
pub struct Keys(BTreeMap<u16, f64>);

/// Name of a key for messages: `geo key 3076 (ProjLinearUnitsGeoKey)`.
pub fn place(number: u16) -> String {
    match KEYS.of_number(number) {
        Some(word) => format!("geo key {number} ({})", word.name),
        None => format!("geo key {number}"),
    }
}

impl Keys {
    /// Decides and reads the keys of a directory: a header of four words, then four words a key.
    ///
    /// # Errors
    /// If a key is refused or unknown, stands there twice, or has no value.
    pub fn of(
        path: &Path,
        directory: &[u16],
        numbers: &[f64],
        decider: &mut Decider,
    ) -> Result<Self, SurveyError> {
        let mut keys = BTreeMap::new();
        let damaged = |key: u16, found: String, expected: &str| {
            let advice = "the geo tags are damaged: write the file again with gdal_translate";
            field(path, place(key), found, expected, advice)
        };
        let entries = directory.get(4..).unwrap_or_default().chunks_exact(4);
        let [count, stated] = [entries.len(), usize::from(directory.get(3).copied().unwrap_or(0))];
        if stated > count {
            return Err(damaged(
                0,
                format!("{count} keys"),
                &format!("{stated} keys, as the directory says"),
            ));
        }
        for entry in entries.take(stated) {
            let &[key, location, length, value] = entry else { continue };
            let number = match location {
                0 => Some(f64::from(value)),
                34736 if length == 1 => {
                    let number = numbers.get(usize::from(value)).copied().filter(|v| v.is_finite());
                    let found = || format!("a reference to number {value} of {}", numbers.len());
                    Some(number.ok_or_else(|| damaged(key, found(), "a finite number that is there"))?)
                }
                34736 | 34737 => None,
                other => return Err(damaged(key, format!("a value in tag {other}"), "tag 34736 or 34737")),
            };
            let value = number.map_or("text or several numbers".into(), |number| number.to_string());
            let (place, name) = (place(key), key.to_string());
            decider.decide(Met {
                of: &KEYS,
                word: KEYS.of_number(key),
                place: &place,
                name: &name,
                value: &value,
            })?;
            if let Some(before) = number.and_then(|number| keys.insert(key, number)) {
                return Err(damaged(key, format!("{before} and {value}"), "one value"));
            }
        }
        Ok(Self(keys))
    }

    /// The number of a key, if it is there.
    pub fn get(&self, key: u16) -> Option<f64> {
        self.0.get(&key).copied()
    }

    /// The number of several keys of one meaning; `None` if none of them is there.
    ///
    /// # Errors
    /// If two of them have different numbers.
    pub fn one(&self, path: &Path, keys: &[u16]) -> Result<Option<f64>, SurveyError> {
        let mut there = keys.iter().filter_map(|&key| self.get(key).map(|number| (key, number)));
        let Some((first, number)) = there.next() else { return Ok(None) };
        match there.find(|(_, other)| *other != number) {
            None => Ok(Some(number)),
            Some((second, other)) => {
                let expected = format!("{number}, as {} has it: both have one meaning", place(first));
                let advice = "write it again with gdal_translate, with one of them";
                Err(field(path, place(second), other.to_string(), expected, advice))
            }
        }
    }

    /// The code of a key; `None` for one that is undefined or has its figures in other keys.
    pub fn code(&self, key: u16) -> Option<u16> {
        self.get(key).filter(|code| *code != 0.0 && *code != USER_DEFINED).map(|code| code as u16)
    }

    /// A unit by the code of `key`, or by the size in `size_key`; `None` if the file says neither.
    fn unit(
        &self,
        path: &Path,
        key: u16,
        size_key: Option<u16>,
        known: fn(u16) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        let unknown = |found: f64| {
            let advice = "convert the file with gdalwarp -t_srs";
            field(path, place(key), found.to_string(), "the code of a unit that is known here", advice)
        };
        if let Some(code) = self.code(key) {
            return known(code).map(Some).ok_or_else(|| unknown(f64::from(code)));
        }
        let size = size_key.and_then(|key| self.get(key));
        match (self.get(key), size) {
            (_, Some(size)) if size > 0.0 => Ok(Some(size)),
            (None | Some(0.0), None) => Ok(None),
            (found, _) => Err(unknown(found.unwrap_or(0.0))),
        }
    }

    /// Metres of the unit of the map, if the file says it.
    pub fn unit_of_map(&self, path: &Path) -> Result<Option<f64>, SurveyError> {
        self.unit(path, 3076, Some(3077), length_of_code)
    }

    /// Radians of the unit of angles; degrees if the file does not say it.
    pub fn unit_of_angles(&self, path: &Path) -> Result<f64, SurveyError> {
        Ok(self.unit(path, 2054, Some(2055), angle_of_code)?.unwrap_or(quantities::radians(1.0)))
    }

    /// Metres of the unit of the axes of the body; metres if the file does not say it.
    pub fn unit_of_axes(&self, path: &Path) -> Result<f64, SurveyError> {
        Ok(self.unit(path, 2052, Some(2053), length_of_code)?.unwrap_or(1.0))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::Keys;
    use crate::read::options::ReadOptions;
    use crate::read::words::Decider;

    fn of(entries: &[[u16; 4]], numbers: &[f64]) -> Result<Keys, String> {
        let options = ReadOptions::default();
        let directory = [&[1, 1, 0, entries.len() as u16][..], &entries.concat()].concat();
        let mut decider = Decider::new(Path::new("x.tif"), &options);
        Keys::of(Path::new("x.tif"), &directory, numbers, &mut decider).map_err(|error| error.to_string())
    }

    #[test]
    fn damaged_directories_name_the_key() {
        assert!(of(&[[3078, 34736, 1, 9]], &[1.0]).unwrap_err().contains("geo key 3078"));
        assert!(of(&[[3078, 34735, 1, 9]], &[1.0]).unwrap_err().contains("a value in tag 34735"));
        assert!(of(&[[1024, 0, 1, 1], [1024, 0, 1, 2]], &[]).unwrap_err().contains("1 and 2"));
        let options = ReadOptions::default();
        let mut decider = Decider::new(Path::new("x.tif"), &options);
        let cut = Keys::of(Path::new("x.tif"), &[1, 1, 0, 2, 1024, 0, 1, 1], &[], &mut decider);
        assert!(cut.unwrap_err().to_string().contains("2 keys, as the directory says"));
    }

    #[test]
    fn units_have_codes_or_sizes() {
        let metres = |entries: &[[u16; 4]], numbers: &[f64]| {
            of(entries, numbers).unwrap().unit_of_map(Path::new("x.tif")).map_err(|error| error.to_string())
        };
        assert_eq!(metres(&[[3076, 0, 1, 9036]], &[]), Ok(Some(1000.0)));
        assert_eq!(metres(&[[3076, 0, 1, 32767], [3077, 34736, 1, 0]], &[0.5]), Ok(Some(0.5)));
        assert_eq!(metres(&[], &[]), Ok(None));
        assert!(metres(&[[3076, 0, 1, 9300]], &[]).unwrap_err().contains("geo key 3076"));
        assert!(metres(&[[3076, 0, 1, 32767]], &[]).unwrap_err().contains("geo key 3076"));
    }
}
