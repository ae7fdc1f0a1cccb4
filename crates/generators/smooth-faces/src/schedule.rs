//! When the real-time computer has each list's sequence, sun vector, body or normals ready: a function of the frame alone.

use std::num::NonZeroU16;

use generator::Stage;
use scenario::{Carrier, FaceList};

use crate::hardware::{Hardware, Kind, RealTime};
use crate::parameters::Parameters;

/// What a piece of work is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A list of faces, by its number among those that are drawn.
    List(usize),
    /// A group of objects with a sun of its own, by its place.
    Group(usize),
    /// An object that moves, by its number.
    Object(u32),
}

/// Frames in which a piece of work is new.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum When {
    /// It is new in every frame.
    Always,
    /// It is new in frame 0, in frame `first`, and every `every` frames from there on.
    Every {
        /// The first frame after frame 0 in which it is new, 1 or more.
        first: u64,
        /// Frames from one time to the next, 1 or more.
        every: u64,
    },
    /// It is as in frame 0.
    Never,
}

impl When {
    /// The frame whose state shows in `frame`: the last in which it was new.
    pub fn shown(self, frame: u64) -> u64 {
        match self {
            Self::Always => frame,
            Self::Every { first, every } if frame >= first => frame - (frame - first) % every,
            Self::Every { .. } | Self::Never => 0,
        }
    }

    /// The first frame from `frame` on in which it is new; `None` if there is none.
    pub fn next(self, frame: u64) -> Option<u64> {
        match self {
            Self::Always => Some(frame),
            _ if frame == 0 => Some(0),
            Self::Every { first, .. } if frame <= first => Some(first),
            Self::Every { first, every } => Some(first + (frame - first).div_ceil(every) * every),
            Self::Never => None,
        }
    }
}

/// Work of one kind for one list, group or object.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// Kind of the work.
    pub kind: Kind,
    /// What it is done for.
    pub target: Target,
    /// Name of that in records.
    pub name: String,
    /// Pieces of it in a frame, 1 or more.
    pub pieces: u64,
    /// Time that it takes (ns).
    pub ns: u64,
    /// When it is new.
    pub when: When,
    /// When it is ready in the spare time of the frame before the one in which it is new (ns).
    pub ready_ns: u64,
}

impl Item {
    fn new(kind: Kind, target: Target, name: &str, pieces: u64, piece_ns: u64) -> Self {
        let (name, ns) = (name.to_owned(), pieces * piece_ns);
        Self { kind, target, name, pieces, ns, when: When::Always, ready_ns: 0 }
    }

    /// Its name in records: `normals.sea`.
    pub fn part(&self) -> String {
        format!("{}.{}", self.kind.word(), self.name)
    }
}

/// All work of the real-time computer in the order in which it takes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    items: Vec<Item>,
    /// When sequence, sun vector, body and normals of each list are new.
    lists: Vec<[When; 4]>,
    /// Channels that get the words.
    channels: u32,
}

impl Schedule {
    /// The work for a stage of which `lists` are drawn.
    pub fn new(stage: &Stage, lists: &[&FaceList], run: &Parameters, hardware: &Hardware) -> Self {
        let mut items: Vec<Item> =
            Kind::ALL.into_iter().flat_map(|kind| of_kind(kind, stage, lists, run, &hardware.rt)).collect();
        plan(&mut items, hardware.rt.spare_ns);
        stop_sun(&mut items, hardware.rt.dead_sun);
        let mut of_lists = vec![[When::Always; 4]; lists.len()];
        for item in &items {
            if let Target::List(list) = item.target {
                of_lists[list][item.kind as usize] = item.when;
            }
        }
        Self { items, lists: of_lists, channels: run.channels }
    }

    /// All work in its order.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Frames whose sequence, sun vector, body and normals of a list show in `frame`.
    pub fn of_list(&self, list: usize, frame: u64) -> [u64; 4] {
        self.lists[list].map(|when| when.shown(frame))
    }

    /// The frame whose state of a group's sun or of an object shows in `frame`.
    pub fn shown(&self, target: Target, frame: u64) -> u64 {
        let item = self.items.iter().find(|item| item.target == target);
        item.map_or(frame, |item| item.when.shown(frame))
    }

    /// Words that go to the image processors of all channels in a frame.
    pub fn words(&self) -> u64 {
        let of_one: u64 = self.items.iter().map(|item| item.pieces * item.kind.words()).sum();
        of_one * u64::from(self.channels)
    }

    /// Channels whose words fit the spare time of a frame with all else that is done once; 0 if none does, `None` without words.
    pub fn most_channels(&self, rt: &RealTime) -> Option<u64> {
        let of_one: u64 = self.items.iter().map(|item| item.pieces * rt.words_ns(item.kind)).sum();
        let once = self.asked_ns() - u64::from(self.channels) * of_one;
        rt.spare_ns.saturating_sub(once).checked_div(of_one)
    }

    /// Time of all work of a frame (ns).
    pub fn asked_ns(&self) -> u64 {
        self.items.iter().map(|item| item.ns).sum()
    }

    /// Work that is not new in `frame`.
    pub fn late(&self, frame: u64) -> u64 {
        self.items.iter().filter(|item| item.when.shown(frame) != frame).count() as u64
    }
}

/// Work of a kind, list after list.
fn of_kind(kind: Kind, stage: &Stage, lists: &[&FaceList], run: &Parameters, rt: &RealTime) -> Vec<Item> {
    let piece_ns = rt.piece_ns(kind, run.channels);
    let of_list = |(number, list): (usize, &&FaceList)| {
        let pieces = pieces(kind, list, run);
        (pieces > 0).then(|| Item::new(kind, Target::List(number), &list.group.name, pieces, piece_ns))
    };
    let mut items: Vec<Item> = lists.iter().enumerate().filter_map(of_list).collect();
    match kind {
        Kind::Sun => {
            let suns = stage.scenery.groups().iter().enumerate().filter(|(_, group)| group.sun.is_some());
            items.extend(
                suns.map(|(place, group)| Item::new(kind, Target::Group(place), &group.name, 1, piece_ns)),
            );
        }
        Kind::Body => {
            let guests = stage.scenery.all_guests().iter().filter(|guest| guest.moves());
            let mut objects: Vec<u32> = guests.map(|guest| guest.object).collect();
            objects.sort_unstable();
            objects.dedup();
            let item = |object: u32| {
                Item::new(kind, Target::Object(object), &format!("object-{}", object + 1), 1, piece_ns)
            };
            items.extend(objects.into_iter().map(item));
        }
        Kind::Sequence | Kind::Normal => {}
    }
    items
}

/// Pieces of a kind that a list asks for in a frame.
fn pieces(kind: Kind, list: &FaceList, run: &Parameters) -> u64 {
    let is_renumbered = run.animate == faces::Animate::Normals && list.sea.is_some();
    match kind {
        Kind::Sequence => list.group.sequences().len() as u64,
        Kind::Sun => u64::from(!is_renumbered && matches!(list.group.sun, faces::SunProgramme::Turning(_))),
        Kind::Body => u64::from(matches!(list.carrier, Carrier::Ship(_) | Carrier::Object(..))),
        Kind::Normal => list.sea.as_ref().filter(|_| is_renumbered).map_or(0, |sea| sea.board.vertices()),
    }
}

/// Work fits a frame's spare time in its order as far as it goes. What is left is done in what is left of each frame, again in its
/// order, and begins anew in the frame after its last piece.
fn plan(items: &mut [Item], spare: u64) {
    let mut used = 0;
    let fitting = items.iter().take_while(|item| {
        used += item.ns;
        used <= spare
    });
    let (in_time, late) = items.split_at_mut(fitting.count());
    let mut used = 0;
    for item in in_time {
        used += item.ns;
        item.ready_ns = used;
    }
    let left = spare - used;
    if left == 0 {
        late.iter_mut().for_each(|item| item.when = When::Never);
        return;
    }
    let every = late.iter().map(|item| item.ns).sum::<u64>().div_ceil(left);
    let mut done = 0;
    for item in late {
        done += item.ns;
        let first = done.div_ceil(left);
        item.when = When::Every { first, every };
        item.ready_ns = used + done - (first - 1) * left;
    }
}

/// Holds the sun vector of that number, from 1, as it is in frame 0.
fn stop_sun(items: &mut [Item], number: u32) {
    let mut suns = items.iter_mut().filter(|item| item.kind == Kind::Sun);
    if let Some(item) = (number as usize).checked_sub(1).and_then(|place| suns.nth(place)) {
        item.when = When::Never;
    }
}

/// Place of a body's group among the groups.
pub fn group_target(group: Option<NonZeroU16>) -> Option<Target> {
    Some(Target::Group(usize::from(group?.get()) - 1))
}
