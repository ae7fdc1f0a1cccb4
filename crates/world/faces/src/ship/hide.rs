//! Four ways to hide the hull below the water, and two wrong orders.

use glam::DVec3;
use quantities::{radians, sin_cos};

use super::Ship;
use super::hull::{Depth, HULL, INTERVALS, mirrored};
use super::pieces::Pieces;
use crate::error::{FaceError, within};
use crate::group::Group;
use crate::priority::Order;
use crate::sequence::{Drive, Mode, Sequence};

/// Name of the signal that drives wedges: pitch of the ship, bow upwards (degrees).
pub const PITCH: &str = "pitch";

/// How the hull below the water is hidden.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hiding {
    /// The hull ends at the waterline (reported, recommended).
    Waterline,
    /// A box of the sea's colour around the hull, `gap` m away, open at the top (reported).
    Box {
        /// Distance from the hull's rectangle (m), above 0.
        gap: f64,
        /// Linear red, green, blue of the sea.
        sea: [f64; 3],
    },
    /// Wedges between hull and sea, chosen by pitch (reported for simple trials).
    Wedges(Wedges),
    /// The whole hull, ordered by depth: no error (chosen).
    Exact,
    /// Wrong order: the sea before the ship, so the ship shows above the horizon only (reported).
    SeaFirst,
    /// Wrong model: the whole hull before the sea, so the ship floats on the water (reported).
    DeepHull,
}

/// Wedges by steps of pitch (index law chosen).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wedges {
    /// Step of pitch (degrees), above 0.
    pub step_deg: f64,
    /// Number of the largest wedge.
    pub count: usize,
}

impl Wedges {
    /// Ten wedges for every half degree.
    pub const USUAL: Self = Self { step_deg: 0.5, count: 10 };

    /// Number of the wedge at a pitch (degrees): `ceil(pitch / step)`, from 0 (none) to the largest.
    pub fn index(&self, pitch_deg: f64) -> usize {
        ((pitch_deg / self.step_deg).ceil().max(0.0) as usize).min(self.count)
    }

    /// Members from the largest wedge to none, so that a drive rounds up; wedge `k` has `faces(k)`.
    fn turns(&self, faces: impl Fn(usize) -> Vec<usize>) -> Result<Sequence<Vec<usize>>, FaceError> {
        let members = (0..=self.count).rev().map(|k| Some(faces(k))).collect();
        let low = self.count as f64 * self.step_deg;
        let drive = Drive { signal: PITCH.into(), low, step: -self.step_deg };
        Sequence::new(members, 1, 0, Mode::Driven(drive))
    }
}

/// Lists of a ship and how they are ordered against the sea.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// The ship; it pitches and rolls.
    pub ship: Group,
    /// The box around it, which follows place and heading only.
    pub surround: Option<Group>,
    /// Priority of the sea's list.
    pub sea: i32,
    /// How lists are ordered.
    pub order: Order,
}

impl Ship {
    /// Lists `list` and, where there is one, `list-box`, with priorities from `first`.
    ///
    /// # Errors
    /// If a figure of the hiding is out of range.
    pub fn arranged(&self, list: &str, hiding: Hiding, first: i32) -> Result<Arrangement, FaceError> {
        let ship = |depth, priority| -> Result<Group, FaceError> {
            Ok(Group::new(list, self.pieces(depth).mesh(list)?, priority))
        };
        let plain = |ship, sea, order| Arrangement { ship, surround: None, sea, order };
        Ok(match hiding {
            Hiding::Waterline => plain(ship(Depth::Waterline, first)?, first + 1, Order::Lists),
            Hiding::DeepHull => plain(ship(Depth::Keel, first)?, first + 1, Order::Lists),
            Hiding::SeaFirst => plain(ship(Depth::Waterline, first + 1)?, first, Order::Lists),
            Hiding::Exact => plain(ship(Depth::Keel, first)?, first + 1, Order::Depth),
            Hiding::Wedges(wedges) => plain(self.wedged(list, wedges, first)?, first + 1, Order::Lists),
            Hiding::Box { gap, sea } => Arrangement {
                surround: Some(self.surround(&format!("{list}-box"), gap, sea, first)?),
                ..plain(ship(Depth::Keel, first + 1)?, first + 2, Order::Lists)
            },
        })
    }

    /// The ship above the water with wedges below the fore half.
    fn wedged(&self, list: &str, wedges: Wedges, priority: i32) -> Result<Group, FaceError> {
        within("step of wedges (deg)", wedges.step_deg, wedges.step_deg > 0.0, "above 0")?;
        let most = (1..=100).contains(&wedges.count);
        within("number of wedges", wedges.count as f64, most, "from 1 to 100")?;
        let mut pieces = self.pieces(Depth::Waterline);
        let own = pieces.faces.len();
        for k in 1..=wedges.count {
            let height = bow_gap(self.length, radians(k as f64 * wedges.step_deg));
            self.wedge(height, &mut pieces);
        }
        let each = (pieces.faces.len() - own) / wedges.count;
        let faces = |k: usize| match k.checked_sub(1) {
            Some(before) => (own + before * each..own + (before + 1) * each).collect(),
            None => Vec::new(),
        };
        let turns = wedges.turns(faces)?;
        Group::new(list, pieces.mesh(list)?, priority).with_sequences(vec![turns])
    }

    /// Upright faces below the waterline, from nothing amidships to `height` m at the bow.
    fn wedge(&self, height: f64, pieces: &mut Pieces) {
        let middle = INTERVALS / 2;
        for side in [DVec3::Y, -DVec3::Y] {
            for station in middle..INTERVALS {
                let mut outline = Vec::new();
                for at in [station, station + 1] {
                    let edge = self.waterline(at);
                    let edge = if side.y > 0.0 { edge } else { mirrored(edge) };
                    let low = DVec3::new(edge.x, edge.y, -height * edge.x / (self.length / 2.0));
                    outline.extend(if at == station { [low, edge] } else { [edge, low] });
                }
                // Amidships the wedge begins with nothing.
                outline.dedup();
                pieces.flat(&outline, side, HULL);
            }
        }
    }

    /// Four walls and a bottom of the sea's colour around the hull, seen from outside.
    fn surround(&self, list: &str, gap: f64, sea: [f64; 3], priority: i32) -> Result<Group, FaceError> {
        within("gap of the box (m)", gap, gap > 0.0, "above 0")?;
        let [x, y] = [self.length / 2.0 + gap, self.beam / 2.0 + gap];
        let low = -self.draught - gap;
        let rim = [[-x, -y], [x, -y], [x, y], [-x, y]];
        let place = |k: usize, up: f64| DVec3::new(rim[k % 4][0], rim[k % 4][1], up);
        let mut pieces = Pieces::default();
        for (k, outwards) in [-DVec3::Y, DVec3::X, DVec3::Y, -DVec3::X].into_iter().enumerate() {
            pieces.flat(&[place(k, 0.0), place(k + 1, 0.0), place(k + 1, low), place(k, low)], outwards, sea);
        }
        pieces.flat(&[0, 1, 2, 3].map(|k| place(k, low)), -DVec3::Z, sea);
        Ok(Group::new(list, pieces.mesh(list)?, priority))
    }
}

/// Height (m) of the bow's waterline above the sea, for a hull of `length` m at `pitch` (radians): `(length / 2) sin(pitch)`.
pub fn bow_gap(length: f64, pitch: f64) -> f64 {
    length / 2.0 * sin_cos(pitch).0
}

/// Hull (m) that shows below the water inside a box `gap` m away, seen at `elevation` above the sea (radians): `gap tan(elevation)`.
pub fn box_error(gap: f64, elevation: f64) -> f64 {
    gap * libm::tan(elevation)
}
