//! The opaque picture in one column of pixels, with or without the lists of faces.

use super::matter::Back;
use super::screen::Screen;
use super::stack::Surface;
use crate::ground::Scratch;
use crate::scene::{Meeting, Scene};
use crate::seen::Seen;
use crate::standing::Stand;

/// How many places are remembered: the corners of a pixel, two of which are the next one's.
const REMEMBERED: usize = 4;

/// The opaque picture, asked for at any place of a column of pixels.
pub struct Opaque<'a> {
    scene: &'a Scene<'a>,
    screen: Screen,
    bodies: Vec<&'a Stand<'a>>,
    with_faces: bool,
    scratch: Scratch,
    rays: u64,
    recent: [([f64; 2], Back); REMEMBERED],
    next: usize,
}

impl<'a> Opaque<'a> {
    /// That of a column, counted from the left.
    pub fn new(scene: &'a Scene<'a>, screen: &Screen, column: usize) -> Self {
        let ends = [column, column + 1].map(|at| screen.on_plane([at as f64, 0.0])[0]);
        Self {
            scene,
            screen: *screen,
            bodies: scene.standing().between(ends),
            with_faces: true,
            scratch: Scratch::default(),
            rays: 0,
            recent: [([f64::NAN; 2], Back { depth: 0.0, is_open: false }); REMEMBERED],
            next: 0,
        }
    }

    /// The same without the lists of faces.
    pub fn beside_faces(scene: &'a Scene<'a>, screen: &Screen, column: usize) -> Self {
        Self { with_faces: false, ..Self::new(scene, screen, column) }
    }

    /// Number of rays so far.
    pub fn rays(&self) -> u64 {
        self.rays
    }

    /// What is seen at a place in pixels.
    pub fn seen(&mut self, at: [f64; 2]) -> Seen {
        let (meeting, _) = self.meet(at);
        self.scene.seen(&meeting, &mut self.scratch)
    }

    fn meet(&mut self, at: [f64; 2]) -> (Meeting, Back) {
        self.rays += 1;
        let place = self.screen.on_plane(at);
        let meeting = self.scene.meet(place, &self.bodies, self.scene.near(), &mut self.scratch);
        let meeting = if self.with_faces { self.scene.with_faces_met(meeting, place) } else { meeting };
        let back = Back { depth: self.scene.depth(&meeting, place), is_open: self.scene.is_open(&meeting) };
        (meeting, back)
    }
}

impl Surface for Opaque<'_> {
    fn back(&mut self, at: [f64; 2]) -> Back {
        if let Some((_, back)) = self.recent.iter().find(|(known, _)| *known == at) {
            return *back;
        }
        let (_, back) = self.meet(at);
        self.recent[self.next] = (at, back);
        self.next = (self.next + 1) % REMEMBERED;
        back
    }

    fn lit(&mut self, at: [f64; 2]) -> (Back, [f64; 3]) {
        let (meeting, back) = self.meet(at);
        (back, self.scene.seen(&meeting, &mut self.scratch).light)
    }
}
