//! Named planes: what a frame is made of.

use scenario::FaceKind;

use crate::Fact;

/// What a plane holds, one f32 a pixel. All but [`Intensity`](Self::Intensity) and colour are taken at the pixel's
/// centre; no value is NaN.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneKind {
    /// Linear reflectivity under the pixel rule, 0 = black sky or shadow. Sky is 0. Where colour is drawn it is the
    /// luminance of red, green and blue, by [`quantities::luminance`]: 0.2126 R + 0.7152 G + 0.0722 B (Rec. 709).
    Intensity,
    /// Ground range from the nadir point of the eye (m); infinity where there is sky.
    Range,
    /// Height above the tangent plane of the problem area (m), curvature not taken off; 0 where there is sky.
    Height,
    /// North component of the outward unit normal of what is seen; 0 where there is sky.
    NormalNorth,
    /// East component of the same.
    NormalEast,
    /// Upward component of the same.
    NormalUp,
    /// Linear reflectivity before remote shadow, with local shadow; 0 where there is sky.
    Reflectivity,
    /// Code of a [`Shade`]; 0 where there is sky.
    Shadow,
    /// Code of a [`Label`].
    Label,
    /// Linear red under the pixel rule, Rec. 709 primaries, in the unit of [`Intensity`](Self::Intensity). Sky is 0.
    Red,
    /// Linear green, the same.
    Green,
    /// Linear blue, the same.
    Blue,
    /// Distance from the eye along the ray to what is seen (m); infinity where there is sky. The ray is straight in the
    /// axes of the tangent plane, and what is seen stands below that plane by the drop of the lunoid:
    /// `sqrt(range^2 + (eye - height + drop(range))^2)`, which is range over the cosine of the ray's elevation.
    Distance,
    /// What the generator lost at a pixel to limits of memory and time: bits of [`Loss`], 0 for nothing.
    Overload,
}

impl PlaneKind {
    /// All kinds of what a pixel shows, beginning with the intensity. What was lost, [`Overload`](Self::Overload), is apart.
    pub const ALL: [Self; 13] = [
        Self::Intensity,
        Self::Range,
        Self::Height,
        Self::NormalNorth,
        Self::NormalEast,
        Self::NormalUp,
        Self::Reflectivity,
        Self::Shadow,
        Self::Label,
        Self::Red,
        Self::Green,
        Self::Blue,
        Self::Distance,
    ];

    /// The planes of a picture in colour, in the order of its codes.
    pub const COLOUR: [Self; 3] = [Self::Red, Self::Green, Self::Blue];

    /// Returns the name of the plane in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Intensity => "intensity",
            Self::Range => "range",
            Self::Height => "height",
            Self::NormalNorth => "normal_north",
            Self::NormalEast => "normal_east",
            Self::NormalUp => "normal_up",
            Self::Reflectivity => "reflectivity",
            Self::Shadow => "shadow",
            Self::Label => "label",
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
            Self::Distance => "distance",
            Self::Overload => "overload",
        }
    }

    /// Unit of its values in files; 1 for plain numbers and codes.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Range | Self::Height | Self::Distance => "m",
            _ => "1",
        }
    }

    /// One of its values in words, with its unit; codes by their names.
    fn in_words(self, value: f32) -> String {
        if self == Self::Overload {
            return Loss::words(value as u8);
        }
        let name = match self {
            Self::Shadow => Shade::of_code(value as u8).map(Shade::name),
            Self::Label => Label::of_code(value as u8).map(Label::name),
            Self::Range | Self::Distance if value.is_infinite() => Some("none"),
            _ => None,
        };
        match (name, self.unit()) {
            (Some(name), _) => name.to_owned(),
            (None, "1") => format!("{value:.5}"),
            (None, unit) => format!("{value:.3} {unit}"),
        }
    }

    /// Its value where there is sky.
    pub fn sky(self) -> f32 {
        if matches!(self, Self::Range | Self::Distance) { f32::INFINITY } else { 0.0 }
    }
}

macro_rules! codes {
    ($(#[$about:meta])* $name:ident { $($(#[$doc:meta])* $variant:ident = $word:literal,)* }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$doc])* $variant,)*
        }

        impl $name {
            /// All, in the order of their codes.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Number in planes and files, counted from 0.
            pub fn code(self) -> u8 {
                self as u8
            }

            /// Returns the word for the code in files.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $word),* }
            }

            /// What a code stands for.
            pub fn of_code(code: u8) -> Option<Self> {
                Self::ALL.get(usize::from(code)).copied()
            }
        }
    };
}

codes! {
    /// How a place is lit.
    Shade {
        /// The place is lit, or it is sky.
        Lit = "lit or sky",
        /// Its face is turned away from the sun.
        Local = "local shadow",
        /// Something stands between it and the sun.
        Remote = "remote shadow",
    }
}

codes! {
    /// Kind of thing that is seen through a pixel.
    Label {
        /// Nothing but sky is seen.
        Sky = "sky",
        /// Terrain of the stored area.
        Terrain = "terrain",
        /// A crater of the feature list.
        Feature = "feature",
        /// A rock on the ground.
        Rock = "rock",
        /// A man-made object, or a part of one.
        Culture = "culture",
        /// A track that the vehicle has left.
        Track = "vehicle track",
        /// A far silhouette, beyond the end of the sweeps.
        Silhouette = "far silhouette",
        /// A lamp or a star, where most of the light at the pixel's centre is its own.
        Light = "light point",
        /// A translucent sheet, the same.
        Sheet = "translucent sheet",
        /// An overlay that is fixed to the eye, the same.
        EyeFixed = "fixed to the eye",
        /// Water of a sea.
        Sea = "sea",
        /// Foam and churned water, smoke, dust: an effect of faces.
        Wake = "wake or effect",
        /// A ship, or the box around it.
        Ship = "ship",
        /// Terrain for which the survey had no data: its height is filled in.
        Void = "void",
        /// Terrain that no photograph shows: its light is that of the ground around, or a light outside.
        Inferred = "inferred light",
    }
}

impl Label {
    /// The label of what a list of faces shows.
    pub fn of_faces(kind: FaceKind) -> Self {
        match kind {
            FaceKind::Sea => Self::Sea,
            FaceKind::Level | FaceKind::Wake | FaceKind::Effect => Self::Wake,
            FaceKind::Ship => Self::Ship,
        }
    }
}

codes! {
    /// What a generator lost at a place. In the plane [`PlaneKind::Overload`] each is the bit of its code.
    Loss {
        /// A list had no place for a feature.
        List = "list full",
        /// A sampling point of the pixel had no slot for a feature.
        Stack = "stack full",
        /// The sub-area was read out after its line was due.
        Late = "late",
        /// A light point stood here that had no place in a store, or for which the beam had no time.
        Light = "light lost",
    }
}

impl Loss {
    /// Its bit in the plane.
    pub fn bit(self) -> u8 {
        1 << self.code()
    }

    /// The losses of a value of the plane, in words.
    fn words(bits: u8) -> String {
        let names = Self::ALL.iter().filter(|loss| bits & loss.bit() != 0).map(|loss| loss.name());
        let names: Vec<&str> = names.collect();
        if names.is_empty() { "none".into() } else { names.join(", ") }
    }
}

/// One plane, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// Kind of values in the plane.
    pub kind: PlaneKind,
    /// `lines * columns` values.
    pub values: Vec<f32>,
}

/// The planes that a caller wants filled.
#[derive(Debug, Clone, PartialEq)]
pub struct Planes {
    columns: usize,
    lines: usize,
    planes: Vec<Plane>,
}

impl Planes {
    /// Planes of `columns` x `lines` pixels, one for each of `kinds`, all zero.
    pub fn new(columns: usize, lines: usize, kinds: &[PlaneKind]) -> Self {
        let plane = |&kind| Plane { kind, values: vec![0.0; columns * lines] };
        Self { columns, lines, planes: kinds.iter().map(plane).collect() }
    }

    /// Pixels in a row.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Returns the number of lines (rows).
    pub fn lines(&self) -> usize {
        self.lines
    }

    /// Whether there are any: whether a picture is wanted.
    pub fn any(&self) -> bool {
        !self.planes.is_empty()
    }

    /// Fills every plane with what it holds where there is sky.
    pub fn fill_sky(&mut self) {
        self.planes.iter_mut().for_each(|plane| plane.values.fill(plane.kind.sky()));
    }

    /// The values of `kind`, if it was asked for.
    pub fn get(&self, kind: PlaneKind) -> Option<&[f32]> {
        self.planes.iter().find(|plane| plane.kind == kind).map(|plane| plane.values.as_slice())
    }

    /// What each plane holds at a pixel (column and line inside the picture), in words.
    pub fn facts(&self, [column, line]: [usize; 2]) -> Vec<Fact> {
        let at = line * self.columns + column;
        let fact = |plane: &Plane| Fact::new(plane.kind.name(), plane.kind.in_words(plane.values[at]));
        self.planes.iter().map(fact).collect()
    }

    /// The values of red, green and blue, if all were asked for.
    pub fn colour(&self) -> Option<[&[f32]; 3]> {
        let [red, green, blue] = PlaneKind::COLOUR.map(|kind| self.get(kind));
        Some([red?, green?, blue?])
    }

    /// The values of `kind` to fill, if it was asked for.
    pub fn get_mut(&mut self, kind: PlaneKind) -> Option<&mut [f32]> {
        self.planes.iter_mut().find(|plane| plane.kind == kind).map(|plane| plane.values.as_mut_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::{Label, Loss, PlaneKind, Planes, Shade};

    /// Codes are in files that others read: they never change.
    #[test]
    fn codes_of_the_format() {
        let labels: Vec<_> = Label::ALL.iter().map(|label| (label.code(), label.name())).collect();
        let words = ["sky", "terrain", "feature", "rock", "culture", "vehicle track", "far silhouette"];
        let words = words.into_iter().chain(["light point", "translucent sheet", "fixed to the eye"]);
        let words = words.chain(["sea", "wake or effect", "ship", "void", "inferred light"]);
        assert_eq!(labels, (0..).zip(words).collect::<Vec<_>>());
        assert_eq!([Shade::Lit, Shade::Local, Shade::Remote].map(Shade::code), [0, 1, 2]);
        assert!(Label::ALL.iter().all(|label| Label::of_code(label.code()) == Some(*label)));
        assert_eq!((Label::of_code(15), Shade::of_code(3)), (None, None));
    }

    #[test]
    fn no_two_planes_share_a_name() {
        let names = std::collections::BTreeSet::from(PlaneKind::ALL.map(PlaneKind::name));
        assert_eq!(names.len(), PlaneKind::ALL.len());
        assert!(PlaneKind::ALL.iter().all(|kind| !kind.sky().is_nan()));
    }

    #[test]
    fn a_pixel_in_words() {
        let kinds = [PlaneKind::Intensity, PlaneKind::Range, PlaneKind::Shadow, PlaneKind::Label];
        let mut planes = Planes::new(2, 3, &kinds);
        planes.fill_sky();
        for (kind, value) in kinds.into_iter().zip([0.25, 31.5, 2.0, 3.0]) {
            planes.get_mut(kind).unwrap()[2 * 2 + 1] = value;
        }
        let told = |pixel| {
            let facts = planes.facts(pixel).into_iter();
            facts.map(|fact| format!("{} {}", fact.what, fact.value)).collect::<Vec<_>>()
        };
        assert_eq!(
            told([1, 2]),
            ["intensity 0.25000", "range 31.500 m", "shadow remote shadow", "label rock"]
        );
        assert_eq!(told([0, 2]), ["intensity 0.00000", "range none", "shadow lit or sky", "label sky"]);
    }

    /// Older kinds keep their places: new ones are put behind them.
    #[test]
    fn planes_of_the_format() {
        let names = [
            "intensity",
            "range",
            "height",
            "normal_north",
            "normal_east",
            "normal_up",
            "reflectivity",
            "shadow",
            "label",
            "red",
            "green",
            "blue",
            "distance",
        ];
        assert_eq!(PlaneKind::ALL.map(PlaneKind::name), names);
        let places = PlaneKind::ALL.map(|kind| kind as usize);
        assert!(places.iter().enumerate().all(|(place, kind)| place == *kind));
        assert_eq!((PlaneKind::Distance.unit(), PlaneKind::Distance.sky()), ("m", f32::INFINITY));
        assert_eq!((PlaneKind::Red.unit(), PlaneKind::Red.sky()), ("1", 0.0));
    }

    #[test]
    fn losses_are_bits() {
        assert_eq!(Loss::ALL.iter().map(|loss| loss.bit()).collect::<Vec<_>>(), [1, 2, 4, 8]);
        let mut planes = Planes::new(2, 1, &[PlaneKind::Overload]);
        planes.get_mut(PlaneKind::Overload).unwrap()[1] = 5.0;
        let told = |column| planes.facts([column, 0])[0].value.clone();
        assert_eq!([told(0), told(1)], ["none", "list full, late"]);
    }

    #[test]
    fn colour_is_all_three_or_none() {
        assert!(Planes::new(1, 1, &[PlaneKind::Red, PlaneKind::Blue]).colour().is_none());
        let mut planes = Planes::new(1, 1, &PlaneKind::COLOUR);
        planes.get_mut(PlaneKind::Green).expect("asked for")[0] = 0.5;
        assert_eq!(planes.colour(), Some([&[0.0][..], &[0.5], &[0.0]]));
    }
}
