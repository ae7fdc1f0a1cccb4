//! What a user may ask for: names, and the arrays that they become.

use std::fmt;
use std::str::FromStr;

use files::{Npy, NpyData, NpyError};
use generator::{Label, PlaneKind, Planes, Shade};
use serde_json::{Value, json};

/// Share by which a number may be off that is stored as f32, with the error of the root along the ray (docs/truth-format.md).
const F32_SHARE: f64 = 6e-8;

/// One kind of ground truth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum TruthItem {
    /// Ground range of the pixel's point (m).
    Range,
    /// Height above the tangent plane (m).
    Height,
    /// Unit normal: north, east, up.
    Normal,
    /// Linear reflectivity before remote shadow.
    Reflectivity,
    /// How it is lit.
    Shadow,
    /// Kind of thing that the pixel sees.
    Label,
    /// Where the eye is and how it looks; files of its own.
    Pose,
    /// Distance along the ray (m).
    Distance,
}

impl TruthItem {
    /// All, in the order of the files.
    pub const ALL: [Self; 8] = [
        Self::Range,
        Self::Height,
        Self::Normal,
        Self::Reflectivity,
        Self::Shadow,
        Self::Label,
        Self::Pose,
        Self::Distance,
    ];

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Range => "range",
            Self::Height => "height",
            Self::Normal => "normal",
            Self::Reflectivity => "reflectivity",
            Self::Shadow => "shadow",
            Self::Label => "label",
            Self::Pose => "pose",
            Self::Distance => "distance",
        }
    }

    /// Planes that it is made of, in the order of its last dimension; none for the pose.
    pub fn kinds(self) -> &'static [PlaneKind] {
        match self {
            Self::Range => &[PlaneKind::Range],
            Self::Height => &[PlaneKind::Height],
            Self::Normal => &[PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp],
            Self::Reflectivity => &[PlaneKind::Reflectivity],
            Self::Shadow => &[PlaneKind::Shadow],
            Self::Label => &[PlaneKind::Label],
            Self::Pose => &[],
            Self::Distance => &[PlaneKind::Distance],
        }
    }

    fn is_code(self) -> bool {
        matches!(self, Self::Shadow | Self::Label)
    }

    /// Largest error of a value as a share of it: that of a number that is stored as f32; 0 for codes.
    pub fn bound(self) -> f64 {
        if self.is_code() || self.kinds().is_empty() { 0.0 } else { F32_SHARE }
    }

    /// Words of its codes, in their order; none for numbers.
    pub fn words(self) -> Vec<&'static str> {
        match self {
            Self::Shadow => Shade::ALL.iter().map(|shade| shade.name()).collect(),
            Self::Label => Label::ALL.iter().map(|label| label.name()).collect(),
            _ => Vec::new(),
        }
    }

    /// Its array of a frame: (lines, columns), or (lines, columns, 3) for a vector.
    ///
    /// # Errors
    /// If the planes are not those of its [`kinds`](Self::kinds).
    pub fn array(self, planes: &Planes) -> Result<Npy, NpyError> {
        let found: Vec<&[f32]> = self.kinds().iter().filter_map(|kind| planes.get(*kind)).collect();
        let mut shape = vec![planes.lines(), planes.columns()];
        let data: NpyData = match (found.as_slice(), self.is_code()) {
            ([codes], true) => codes.iter().map(|code| *code as u8).collect::<Vec<_>>().into(),
            ([values], false) => values.to_vec().into(),
            (parts, _) => {
                shape.push(parts.len());
                let pixels = 0..planes.lines() * planes.columns();
                pixels.flat_map(|at| parts.iter().map(move |part| part[at])).collect::<Vec<_>>().into()
            }
        };
        Npy::new(shape, data)
    }

    /// What the record says of it, on a raster of `lines` and `columns`.
    pub fn description(self, lines: u32, columns: u32) -> Value {
        let Some(first) = self.kinds().first() else { return self.pose_description() };
        let mut shape = vec![lines, columns];
        shape.extend((self.kinds().len() > 1).then_some(self.kinds().len() as u32));
        let sky: Value = match *first {
            PlaneKind::Range | PlaneKind::Distance => "inf".into(),
            _ if self.kinds().len() > 1 => json!([0.0, 0.0, 0.0]),
            _ if self.is_code() => 0.into(),
            kind => f64::from(kind.sky()).into(),
        };
        let mut about = json!({
            "name": self.name(),
            "meaning": self.meaning(),
            "unit": first.unit(),
            "dtype": if self.is_code() { "|u1" } else { "<f4" },
            "shape": shape,
            "sky": sky,
        });
        if let Some(codes) = self.codes() {
            about["codes"] = codes;
        }
        about
    }

    fn pose_description(self) -> Value {
        json!({ "name": self.name(), "meaning": self.meaning(), "files": ["poses.csv", "poses.json"] })
    }

    fn codes(self) -> Option<Value> {
        let table = |codes: Vec<(u8, &str)>| {
            codes.iter().map(|(code, word)| json!({ "code": code, "meaning": word })).collect()
        };
        match self {
            Self::Shadow => {
                Some(table(Shade::ALL.iter().map(|shade| (shade.code(), shade.name())).collect()))
            }
            Self::Label => Some(table(Label::ALL.iter().map(|label| (label.code(), label.name())).collect())),
            _ => None,
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::Range => {
                "horizontal distance from the point below the eye to the point below what is seen, along the lunoid"
            }
            Self::Height => {
                "height of what is seen above the lunoid, as the landscape has it: the drop of the lunoid below the \
                 tangent plane at the eye is not taken off"
            }
            Self::Normal => "outward unit normal of what is seen: north, east, up",
            Self::Reflectivity => {
                "share of the sunlight sent to the eye by law of reflection and albedo, 0 where the face is turned \
                 from the sun; remote shadow, texture, white point and gamma are not in it"
            }
            Self::Shadow => "how what is seen is lit",
            Self::Label => "what is seen",
            Self::Distance => {
                "distance from the eye along the ray to what is seen; the ray is straight in the axes of the tangent plane, \
                 below which what is seen stands by the drop of the lunoid"
            }
            Self::Pose => "time, eye, attitude, rotation, sun of every frame",
        }
    }
}

/// A list of kinds of ground truth, without repetition, in the order of `TruthItem::ALL`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TruthItems(Vec<TruthItem>);

impl TruthItems {
    /// These kinds, each once, in the order of `TruthItem::ALL`.
    pub fn of(items: impl IntoIterator<Item = TruthItem>) -> Self {
        let mut items: Vec<TruthItem> = items.into_iter().collect();
        items.sort_unstable();
        items.dedup();
        Self(items)
    }

    /// What is asked for.
    pub fn iter(&self) -> impl Iterator<Item = TruthItem> + '_ {
        self.0.iter().copied()
    }

    /// Those that are arrays.
    pub(super) fn arrays(&self) -> impl Iterator<Item = TruthItem> + '_ {
        self.iter().filter(|item| !item.kinds().is_empty())
    }

    /// Whether the poses are asked for.
    pub(super) fn has_pose(&self) -> bool {
        self.0.contains(&TruthItem::Pose)
    }
}

impl fmt::Display for TruthItems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(TruthItem::name).collect();
        f.write_str(&names.join(","))
    }
}

/// A list with a name that there is not.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no ground truth is called `{found}`; expected `all` or some of {}, joined by commas", all_names())]
pub struct UnknownTruth {
    /// Name that was given.
    pub found: String,
}

fn all_names() -> String {
    TruthItem::ALL.map(TruthItem::name).join(", ")
}

impl FromStr for TruthItems {
    type Err = UnknownTruth;

    fn from_str(text: &str) -> Result<Self, UnknownTruth> {
        let mut items = Vec::new();
        for word in text.split(',').map(str::trim) {
            match TruthItem::ALL.into_iter().find(|item| item.name() == word) {
                Some(item) => items.push(item),
                None if word == "all" => items.extend(TruthItem::ALL),
                None => return Err(UnknownTruth { found: word.into() }),
            }
        }
        Ok(Self::of(items))
    }
}

#[cfg(test)]
mod tests {
    use generator::{PlaneKind, Planes};

    use super::{TruthItem, TruthItems};

    #[test]
    fn lists_are_sorted_and_unknown_names_told() {
        let list = |text: &str| text.parse::<TruthItems>();
        assert_eq!(list("pose, range,range").unwrap().to_string(), "range,pose");
        let all = TruthItem::ALL.map(TruthItem::name).join(",");
        assert_eq!(list("all").unwrap().to_string(), all);
        for wrong in ["", "range,", "depth", "Range", "range;pose"] {
            let error = list(wrong).unwrap_err().to_string();
            assert!(
                error.contains("range, height, normal, reflectivity, shadow, label, pose, distance"),
                "{error}"
            );
        }
    }

    #[test]
    fn vectors_have_their_parts_last() {
        let item = TruthItem::Normal;
        let mut planes = Planes::new(2, 1, item.kinds());
        for (part, kind) in
            [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp].iter().enumerate()
        {
            let values = [part as f32, part as f32 + 10.0];
            planes.get_mut(*kind).unwrap().copy_from_slice(&values);
        }
        let array = item.array(&planes).unwrap();
        assert_eq!(array.shape(), [1, 2, 3]);
        assert_eq!(array.data().to_f64(), [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
    }

    #[test]
    fn every_array_is_described_as_it_is() {
        for item in TruthItem::ALL.into_iter().filter(|item| *item != TruthItem::Pose) {
            let array = item.array(&Planes::new(3, 2, item.kinds())).unwrap();
            let about = item.description(2, 3);
            assert_eq!(serde_json::json!(array.shape()), about["shape"], "{about}");
            let bytes = if about["dtype"] == "|u1" { 1 } else { 4 };
            let mut file = Vec::new();
            array.write(&mut file).unwrap();
            assert_eq!(file.len() % 64, array.data().len() * bytes % 64, "{about}");
        }
    }
}
