//! One sample: its scenario opened, its pose found, its picture, truth and labels made.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use drive::{Drive, EyePose, Place, TruthPlane};
use files::Npy;
use run_record::FileRecord;
use serde_json::Value;

use crate::arrays::{CHANGED, PICTURE, SPLIT, codes, of_picture, of_plane};
use crate::check::stem;
use crate::looks::{Looked, Refusal, at_pose, labels, ranges, reason};
use crate::plan::{Plan, Wanted};
use crate::row::{GroundSeen, Row};
use crate::{DatasetError, folder};

/// Poses that are drawn at most for a sample (chosen): a plan that takes one pose of a thousand finds none in 5 samples of 100 000.
pub const MOST_ATTEMPTS: u32 = 10_000;

/// A sample with its arrays; the hash of its file is not known yet.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// Its line of the manifest.
    pub row: Row,
    /// Its arrays by name, the picture first.
    pub arrays: Vec<(&'static str, Npy)>,
}

/// Makes samples of a plan, on any number of threads.
pub struct Maker<'a> {
    plan: &'a Plan,
    /// The first drive of each scenario, whose ground the others share where it is theirs.
    first: Vec<OnceLock<Arc<Drive>>>,
}

/// A pose that was taken, and what is seen there.
struct Found {
    place: Place,
    pose: EyePose,
    looked: Looked,
    refused: BTreeMap<String, u32>,
}

impl<'a> Maker<'a> {
    /// Nothing is opened yet.
    pub fn new(plan: &'a Plan) -> Self {
        Self { plan, first: plan.scenarios.iter().map(|_| OnceLock::new()).collect() }
    }

    /// Makes sample `sample`, which is a function of the plan and this number alone.
    ///
    /// # Errors
    /// If its scenario cannot be opened, no pose is found, or its truth cannot be drawn.
    pub fn make(&self, sample: u64) -> Result<Made, DatasetError> {
        let (plan, wanted) = (self.plan, self.plan.wanted(sample));
        let drive = self.drive(&wanted, false)?;
        let found = self.find(&wanted, &drive)?;
        let (ground, own) = self.ground(&wanted, &found.looked);
        let picture = &found.looked.seen.picture;
        let shape = vec![picture.lines(), picture.columns()];
        let changed = self.changed(&wanted, &found)?;
        let row = self.row(&wanted, &drive, &found, ground, changed.as_deref());
        let failed = |error: files::NpyError| of_sample(sample, error);
        let mut arrays = vec![(PICTURE, of_picture(picture).map_err(failed)?)];
        arrays.push((SPLIT, Npy::new(shape.clone(), own).map_err(failed)?));
        if let Some(changed) = changed {
            arrays.push((CHANGED, Npy::new(shape, changed).map_err(failed)?));
        }
        let is_asked = |plane: &TruthPlane| {
            plan.truth.as_ref().is_some_and(|items| items.iter().any(|item| item.name() == plane.name))
        };
        for plane in found.looked.truth.planes.into_iter().filter(is_asked) {
            arrays.push((plane.name, of_plane(plane).map_err(failed)?));
        }
        Ok(Made { row, arrays })
    }

    /// The scenario as the sample has it, upon the ground that stands already where it can be.
    fn drive(&self, wanted: &Wanted, healthy: bool) -> Result<Arc<Drive>, DatasetError> {
        let drawn = if healthy { &wanted.drawn[..wanted.healthy] } else { &wanted.drawn };
        let (plan, first) = (self.plan, &self.first[wanted.of.scenario]);
        let path = plan.file(&plan.scenarios[wanted.of.scenario]);
        let wishes = plan.wishes(wanted.of, drawn, healthy);
        let drive = Drive::open_upon(first.get().map(|drive| &**drive), &path, &wishes, 1);
        let drive = Arc::new(drive.map_err(|error| of_sample(wanted.sample, error))?);
        first.get_or_init(|| Arc::clone(&drive));
        Ok(drive)
    }

    /// The first attempt whose ground, pose and picture are taken.
    fn find(&self, wanted: &Wanted, drive: &Arc<Drive>) -> Result<Found, DatasetError> {
        let mut refused = BTreeMap::new();
        let mut last = String::new();
        for attempt in 0..MOST_ATTEMPTS {
            let place = self.plan.place(wanted.sample, attempt);
            match self.attempt(wanted, drive, &place) {
                Ok((pose, looked)) => return Ok(Found { place, pose, looked, refused }),
                Err((reason, said)) => {
                    last = said;
                    *refused.entry(reason.to_owned()).or_default() += 1;
                }
            }
        }
        let reasons: Vec<String> =
            refused.iter().map(|(reason, count)| format!("{reason} {count}")).collect();
        Err(DatasetError::NoPose {
            sample: wanted.sample,
            attempts: MOST_ATTEMPTS,
            reasons: reasons.join(", "),
            last,
        })
    }

    fn attempt(
        &self,
        wanted: &Wanted,
        drive: &Arc<Drive>,
        place: &Place,
    ) -> Result<(EyePose, Looked), Refusal> {
        let (splits, seed, at) = (&self.plan.splits, self.plan.seed, place.at_m);
        let found = splits.of_place(seed, at);
        if found != wanted.split {
            return Err(("split", format!("{at:?} m is ground of {}", found.name())));
        }
        if !splits.is_clear(seed, at, wanted.split) {
            return Err(("reach", format!("ground of another split is nearer to {at:?} m than the reach")));
        }
        let pose = drive.place(wanted.frame, place).map_err(|why| reason(&why))?;
        let looked = at_pose(drive, wanted.frame, &pose, |view| Looked::from(view, self.plan.truth.as_ref()));
        Ok((pose, looked.map_err(|error| ("drawing", error.to_string()))?))
    }

    /// Whose ground the picture shows: 0 for none, 1 for that of the sample's split, 2 for that of another.
    fn ground(&self, wanted: &Wanted, looked: &Looked) -> (GroundSeen, Vec<u8>) {
        let mut ground = GroundSeen::default();
        let whose = |(place, range): (&Option<[f64; 2]>, &f32)| {
            let Some(place) = place else { return 0 };
            if self.plan.splits.of_place(self.plan.seed, *place) == wanted.split {
                ground.own += 1;
                return 1;
            }
            ground.other += 1;
            let nearest = ground.nearest_other_m.unwrap_or(f64::INFINITY);
            ground.nearest_other_m = Some(nearest.min(f64::from(*range)));
            2
        };
        let codes = looked.places.iter().zip(ranges(&looked.truth)).map(whose).collect();
        (ground, codes)
    }

    /// 1 where the picture differs from that of the healthy machine at the same place, 0 elsewhere.
    fn changed(&self, wanted: &Wanted, found: &Found) -> Result<Option<Vec<u8>>, DatasetError> {
        if !self.plan.compare {
            return Ok(None);
        }
        let picture = &found.looked.seen.picture;
        if self.plan.faults[wanted.of.fault].is_none() {
            return Ok(Some(vec![0; picture.lines() * picture.columns()]));
        }
        let drive = self.drive(wanted, true)?;
        let pose = drive.place(wanted.frame, &found.place);
        let pose = pose.map_err(|why| of_sample(wanted.sample, reason(&why).1))?;
        let healthy = at_pose(&drive, wanted.frame, &pose, |view| view.draw());
        let healthy = healthy.map_err(|error| of_sample(wanted.sample, error))?;
        let channels = if picture.is_colour() { 3 } else { 1 };
        let (found, healthy) = (codes(picture), codes(&healthy.picture));
        let pairs = found.chunks(channels).zip(healthy.chunks(channels));
        Ok(Some(pairs.map(|(found, healthy)| u8::from(found != healthy)).collect()))
    }

    fn row(
        &self,
        wanted: &Wanted,
        drive: &Drive,
        found: &Found,
        ground: GroundSeen,
        changed: Option<&[u8]>,
    ) -> Row {
        let (plan, seen) = (self.plan, &found.looked.seen);
        let codes = codes(&seen.picture);
        let sum: u64 = codes.iter().map(|code| u64::from(*code)).sum();
        let mut shape = vec![seen.picture.lines(), seen.picture.columns()];
        shape.extend(seen.picture.is_colour().then_some(3));
        let count = |name: &String| Some((name.clone(), seen.counts.get(name)?));
        let file =
            FileRecord { file: folder::sample_name(wanted.split, wanted.sample), blake3: String::new() };
        Row {
            sample: wanted.sample,
            split: wanted.split,
            file,
            pixels_blake3: seen.hash(),
            shape,
            scenario: stem(&plan.scenarios[wanted.of.scenario]).unwrap_or_default().to_owned(),
            machine: plan.machines[wanted.of.machine].clone(),
            fault: plan.faults[wanted.of.fault].name.clone(),
            drawn: wanted.drawn.iter().map(|(key, value)| (key.clone(), json_of(value))).collect(),
            frame: wanted.frame,
            pose: found.pose.into(),
            sun_deg: found.looked.sun_deg,
            tan_half_field: drive.raster().tan_half_field,
            mean_code: sum as f64 / codes.len().max(1) as f64,
            refused: found.refused.clone(),
            ground,
            labels: labels(&found.looked.truth),
            counts: plan.counters.iter().filter_map(count).collect(),
            changed: changed.map(|changed| changed.iter().map(|code| u64::from(*code)).sum()),
        }
    }
}

fn of_sample(sample: u64, error: impl std::fmt::Display) -> DatasetError {
    DatasetError::Sample { sample, said: error.to_string() }
}

/// A value of TOML as one of JSON: what is no number or truth value is a text.
fn json_of(value: &str) -> Value {
    serde_json::from_str(value).unwrap_or_else(|_| Value::String(value.trim_matches('"').to_owned()))
}
