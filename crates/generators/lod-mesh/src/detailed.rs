//! What a session tells of its levels of detail besides pictures.

use std::collections::BTreeSet;

use generator::{Detailed, DrawnGround, DrawnPosts, FrameCounts, FrameError, Planes, Session as _};
use glam::DVec3;
use lod_tiles::{Edges, Stitch, TilePieces};
use rayon::prelude::*;
use scenario::Pose;
use scene_sampler::{Camera, Shown};

use crate::ground;
use crate::loss::loss;
use crate::session::Session;

impl Detailed for Session {
    fn held_frame(
        &self,
        frame: u64,
        pose: &Pose,
        levels: &Pose,
        planes: &mut Planes,
    ) -> Result<FrameCounts, FrameError> {
        let gathered = self.gather_held(frame, pose, levels)?;
        Ok(self.draw(&Shown::own(frame, pose), &gathered, planes)?.0)
    }

    fn level_changes(&self, frame: u64, pose: &Pose, levels: [&Pose; 2]) -> Result<u64, FrameError> {
        self.check(frame, pose)?;
        levels.into_iter().try_for_each(|pose| self.check(frame, pose))?;
        let prepared = &self.prepared;
        let [from, to] = levels.map(|pose| ground::state(prepared, DVec3::from_array(pose.eye)));
        let tiles = ground::in_view(prepared, &Camera::new(pose, &prepared.stage.view));
        let numbers: BTreeSet<usize> =
            tiles.into_iter().map(|tile| prepared.posts.terrain.number(tile)).collect();
        Ok(to.changes(&from).filter(|(number, ..)| numbers.contains(number)).count() as u64)
    }

    fn drawn_ground(&self, frame: u64, pose: &Pose) -> Result<DrawnGround, FrameError> {
        self.check(frame, pose)?;
        let camera = Camera::new(pose, &self.prepared.stage.view);
        let state = ground::state(&self.prepared, camera.eye);
        let surface = ground::surface(&self.prepared, &state);
        let tiles = ground::in_view(&self.prepared, &camera);
        let pieces: Vec<TilePieces> = tiles.iter().map(|tile| surface.pieces(*tile)).collect();
        Ok(DrawnGround {
            tiles: tiles.len() as u64,
            vertices: pieces.iter().map(|pieces| pieces.still + pieces.morphing).sum(),
            triangles: pieces.iter().map(|pieces| pieces.inner + pieces.border).sum(),
            loss: loss(&self.prepared, &surface, &camera, tiles),
        })
    }

    fn drawn_posts(&self, frame: u64, pose: &Pose) -> Result<DrawnPosts, FrameError> {
        self.check(frame, pose)?;
        let (edges, stitch) = (self.prepared.run.edges, self.prepared.run.stitch);
        // Tiles that leave out vertices of their edges have other triangles there; others have holes.
        if edges != Edges::Shared || stitch != Stitch::CoarseSide {
            let reason = "its ground is no surface over one grid of posts: expected lod.edges = \"shared\" and lod.stitch = \"coarse-side\"";
            return Err(FrameError::Refused { frame, reason: reason.into() });
        }
        let state = ground::state(&self.prepared, DVec3::from_array(pose.eye));
        let surface = ground::surface(&self.prepared, &state);
        let [east, north] = self.prepared.posts.terrain.posts_along().map(<[f64]>::to_vec);
        let row = |north: &f64| east.iter().map(|east| surface.under([*east, *north])).collect::<Vec<_>>();
        let heights = north.par_iter().flat_map_iter(row).collect();
        Ok(DrawnPosts { north, east, heights })
    }
}
