//! The requests `frame`, `look`, `step` and `planes`, and the planes of a picture.

use diagnostics::Problem;
use drive::{Codes, Drive, DriveError, PlaneKind, Seen, Truth, TruthPlane, Viewpoint};
use serde_json::{Map, Value, json};

use crate::keys::{Keys, NAME};
use crate::poses::pose_json;
use crate::session::Reply;
use crate::{Home, Plane, Session};

/// Plane of the codes of a picture.
const PICTURE: &str = "picture";

/// Plane of the linear light.
const LIGHT: &str = "light";

/// Plane of the sweeps that complete the pixels.
const SWEEP: &str = "sweep";

impl<H: Home> Session<H> {
    pub(crate) fn frame(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let frame = keys.required("frame", "a whole number from 0", Value::as_u64);
        let wanted = Wanted::of(&keys);
        keys.finish()?;
        let drive = &self.held()?.drive;
        let at = drive.at(frame.unwrap_or_default())?;
        seen(&at, at.draw()?, &wanted)
    }

    pub(crate) fn look(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let (pose, frame) = (keys.needed_pose("pose"), keys.whole("frame"));
        let wanted = Wanted::of(&keys);
        keys.finish()?;
        let drive = &self.held()?.drive;
        let Some(pose) = pose else { return Ok(Value::Null.into()) };
        let at = pose.at(drive, frame)?;
        seen(&at, at.draw()?, &wanted)
    }

    pub(crate) fn step(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let pose = keys.needed_pose("pose");
        let wanted = Wanted::of(&keys);
        keys.finish()?;
        let held = self.held()?;
        let Some(pose) = pose else { return Ok(Value::Null.into()) };
        let drawn = held.driven.look(&pose.eye)?;
        held.log.step(&held.drive, &held.opening, drawn.hash());
        seen(&held.driven.viewpoint()?, drawn, &wanted)
    }

    pub(crate) fn planes(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        Ok(json!({ "planes": known() }).into())
    }
}

/// Planes that a request names.
struct Wanted {
    picture: bool,
    light: bool,
    sweep: bool,
    /// Names of planes of truth, joined by commas.
    truth: String,
}

impl Wanted {
    /// The planes of a request; the picture alone if it names none. Unknown names are faults of the request.
    fn of(keys: &Keys) -> Self {
        let names = if keys.has("planes") { keys.texts("planes") } else { vec![PICTURE.into()] };
        let known = known();
        for name in names.iter().filter(|name| !known.contains(&name.as_str())) {
            let problem = Problem::of_file(NAME, format!("no plane `{name}`")).key("planes").found(name);
            keys.refuse(problem.expected(format!("some of {}", known.join(", "))));
        }
        let has = |name: &str| names.iter().any(|other| other == name);
        let truth = Drive::truth_names().into_iter().filter(|name| has(name));
        let truth = truth.collect::<Vec<_>>().join(",");
        Self { picture: has(PICTURE), light: has(LIGHT), sweep: has(SWEEP), truth }
    }
}

/// Names of all planes.
fn known() -> Vec<&'static str> {
    [PICTURE, LIGHT, SWEEP].into_iter().chain(Drive::truth_names()).collect()
}

/// A picture from `at` with the planes that are wanted.
fn seen(at: &Viewpoint<'_>, seen: Seen, wanted: &Wanted) -> Result<Reply, DriveError> {
    let mut ok = Map::new();
    ok.insert("frame".into(), seen.frame.into());
    ok.insert("pose".into(), pose_json(&seen.pose));
    ok.insert("hash".into(), seen.hash().into());
    let mut planes = Vec::new();
    planes.extend(wanted.picture.then(|| picture(&seen)));
    planes.extend(wanted.light.then(|| light(&seen)));
    if wanted.sweep {
        let shape = [seen.picture.lines(), seen.picture.columns()];
        planes.push(Plane::of(SWEEP, &shape, &at.completing_sweeps()?));
    }
    if !wanted.truth.is_empty() {
        let Truth { planes: truth, error, .. } = at.truth(&wanted.truth)?;
        let rows: Vec<Value> = truth.iter().map(truth_json).collect();
        ok.insert("truth".into(), rows.into());
        ok.insert("truth_error".into(), json!(error));
        planes.extend(truth.into_iter().map(truth_plane));
    }
    Ok(Reply { ok: Value::Object(ok), planes })
}

/// The codes of the picture: lines, columns, and three behind them in colour.
fn picture(seen: &Seen) -> Plane {
    let colour = seen.picture.is_colour().then(|| seen.picture.to_colour());
    let (codes, parts) = match &colour {
        Some(colour) => (colour.codes(), Some(3)),
        None => (seen.picture.grey().map_or(&[][..], |grey| grey.codes()), None),
    };
    let shape: Vec<usize> = [seen.picture.lines(), seen.picture.columns()].into_iter().chain(parts).collect();
    let bytes: Option<Vec<u8>> = codes.iter().map(|code| u8::try_from(*code).ok()).collect();
    // A picture of 8 bits has no code above 255; another may have none either.
    match bytes.filter(|_| seen.has_bytes()) {
        Some(bytes) => Plane::of(PICTURE, &shape, &bytes),
        None => Plane::of(PICTURE, &shape, codes),
    }
}

/// The linear light: lines, columns, and red, green and blue behind them in colour.
fn light(seen: &Seen) -> Plane {
    let light = &seen.light;
    let shape = [light.lines(), light.columns()];
    match light.colour() {
        None => Plane::of(LIGHT, &shape, light.get(PlaneKind::Intensity).unwrap_or_default()),
        Some([red, green, blue]) => {
            let pixels = red.iter().zip(green).zip(blue);
            let values: Vec<f32> = pixels.flat_map(|((red, green), blue)| [*red, *green, *blue]).collect();
            Plane::of(LIGHT, &[shape[0], shape[1], 3], &values)
        }
    }
}

/// What the numbers of a plane of truth mean.
fn truth_json(plane: &TruthPlane) -> Value {
    let TruthPlane { name, unit, codes, bound, .. } = plane;
    json!({ "name": name, "unit": unit, "codes": codes, "bound": bound })
}

fn truth_plane(TruthPlane { name, shape, values, .. }: TruthPlane) -> Plane {
    match values {
        Codes::Codes(codes) => Plane::of(name, &shape, &codes),
        Codes::Numbers(numbers) => Plane::of(name, &shape, &numbers),
    }
}
