//! The program made ready for a stage.

use generator::{
    Fact, FrameCounts, FrameError, Label, Omission, PlaneKind, Planes, PrepareError, Session, Stage, Weight,
    check_free_eye, face_lists_beside,
};
use glam::DVec3;
use panel_program::{Lie, Picture, Posts, Program, ProgramError, Settings, View};
use photo_camera::{Axes, Ellipsoid};
use photo_drape::Ground;
use photograph::{Photograph, Placement};
use scenario::{Curvature, Pose};
use scene_sampler::Camera;
use signal::{Probe, Wire};

use super::explained::explained;
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::prepared::{refused, spacing};
use crate::signals::{self, Sample};

/// What its pictures hold.
pub(crate) const PLANES: [PlaneKind; 3] = [PlaneKind::Intensity, PlaneKind::Label, PlaneKind::Distance];

/// Advice where the listing has no room.
const LIMITS: &str = "take fewer posts and a smaller raster, or lift it with --set panels.limits=false";

/// The program over the ground of one stage.
pub(crate) struct ProgramSession {
    stage: Stage,
    program: Program,
    /// Whether each panel touches a void of its own posts, or of the bank.
    touch_voids: Vec<bool>,
}

impl ProgramSession {
    /// Lays the first photograph of `stage` over the posts that `run` asks for.
    ///
    /// # Errors
    /// If there is no photograph, or the program refuses it or the posts.
    pub fn new(stage: Stage, run: &Parameters) -> Result<Self, PrepareError> {
        let photograph = stage.landscape.photographs().first();
        let none = || refused(&"ground without photographs", "name one: [[photograph]]");
        let photograph = photograph.ok_or_else(none)?;
        let (posts, lie) = posts(&stage, run, photograph)?;
        let settings = Settings {
            restrictions: run.program.restrictions,
            fill: run.program.way(),
            outside: run.outside,
            marks_voids: run.program.marks_voids,
            blends_borders: run.program.blends_borders,
        };
        let program = Program::new(&posts, lie, photograph, settings);
        let program = program.map_err(|error| refused(&error, remedy(&error)))?;
        let of_bank = |post: &usize| {
            let place = posts.places[*post];
            lie == Lie::Plane && stage.landscape.is_void(place.x, place.y)
        };
        let panels = program.panels().iter();
        let touch_voids = panels.map(|panel| panel.touches_void || panel.posts.iter().any(of_bank)).collect();
        Ok(Self { stage, program, touch_voids })
    }

    /// What it is made ready for.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// The picture of a frame.
    ///
    /// # Errors
    /// If the pose cannot be drawn, or the listing has no room for the screen.
    pub fn picture(&self, frame: u64, pose: &Pose) -> Result<Picture, FrameError> {
        self.check(frame, pose)?;
        self.program.draw(&self.view(pose)).map_err(|error| cannot_draw(frame, &error))
    }

    /// What a pixel of a picture shows.
    fn sample(&self, picture: &Picture, pixel: usize) -> Sample {
        let number = picture.panel[pixel];
        let Some(panel) = self.program.panels().get(number as usize) else { return Sample::NONE };
        Sample {
            panel: Some(number),
            depth: f64::from(picture.distance[pixel]),
            grey: panel.grey.light,
            source: Some(panel.grey.source),
            writes: f64::from(picture.writes[pixel]),
            touches_void: panel.touches_void,
        }
    }

    /// What is seen where a picture shows the panel of a number.
    fn label(&self, panel: u32) -> Label {
        match self.touch_voids.get(panel as usize) {
            None => Label::Sky,
            Some(true) => Label::Void,
            Some(false) => Label::Terrain,
        }
    }

    fn view(&self, pose: &Pose) -> View {
        let view = &self.stage.view;
        let camera = Camera::new(pose, view);
        let [north, east, up] = DVec3::AXES.map(|axis| camera.direction(axis));
        let row = |of: fn(DVec3) -> f64, scale: f64| DVec3::new(of(north), of(east), of(up)) / scale;
        View {
            eye: camera.eye,
            axes: [row(|axis| axis.x, 1.0), row(|axis| axis.y, camera.squeeze()), row(|axis| axis.z, 1.0)],
            half_field: [view.field.tan_half_width, view.field.tan_half_height],
            size: [view.columns, view.lines],
        }
    }
}

/// The posts of a run, and how they lie on a body.
fn posts(stage: &Stage, run: &Parameters, photograph: &Photograph) -> Result<(Posts, Lie), PrepareError> {
    if let Some(table) = &run.program.posts {
        // The posts stand on the body of the photograph.
        let body = match photograph.placement() {
            Placement::Camera { axes: Axes::Body(body), .. } => *body,
            _ => Ellipsoid::CLARKE_1866,
        };
        return Ok((table.posts(body), table.lie(body)));
    }
    let landscape = &stage.landscape;
    let ground = Ground::new(landscape, landscape.level().extent(), spacing(stage, run));
    let ground = ground.map_err(|error| refused(&error, "ask for another panels.spacing_m"))?;
    let [rows, columns] = ground.size();
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column]));
    Ok((Posts { size: [rows, columns], places: all.map(|post| ground.post(post)).collect() }, Lie::Plane))
}

/// A refusal of the program as that of a frame.
fn cannot_draw(frame: u64, error: &ProgramError) -> FrameError {
    FrameError::Refused { frame, reason: format!("{NAME} cannot draw it: {error}; {}", remedy(error)) }
}

/// What helps against a refusal.
fn remedy(error: &ProgramError) -> &'static str {
    match error {
        ProgramError::Limit { .. } | ProgramError::BesideFrame { .. } => LIMITS,
        ProgramError::Axes { .. } => "give its camera file those axes",
        ProgramError::WrittenFill => "leave panels.fill out, or set panels.both_ends = false",
        ProgramError::Void(_) => "give posts with heights",
    }
}

impl Session for ProgramSession {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let picture = self.picture(frame, pose)?;
        let view = &self.stage.view;
        signals::record((frame, view), true, probe, |[column, line]| {
            self.sample(&picture, line * view.columns as usize + column)
        });
        for (kind, values) in
            [(PlaneKind::Intensity, &picture.light), (PlaneKind::Distance, &picture.distance)]
        {
            if let Some(plane) = planes.get_mut(kind) {
                plane.copy_from_slice(values);
            }
        }
        if let Some(labels) = planes.get_mut(PlaneKind::Label) {
            let label = |panel: &u32| self.label(*panel);
            let all = picture.panel.iter().map(|panel| f32::from(label(panel).code()));
            labels.iter_mut().zip(all).for_each(|(plane, label)| *plane = label);
        }
        let counts = picture.counts;
        Ok(FrameCounts::of([
            ("panels", counts.panels()),
            ("triangles", counts.filled),
            ("discarded_panels", counts.discarded),
            ("lost_panels", counts.lost),
        ]))
    }

    fn wires(&self) -> Vec<Wire> {
        signals::wires(&self.stage.view, true)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let scenery = &self.stage.scenery;
        let mut omissions = scene_sampler::omissions(&self.stage, NAME);
        omissions.extend(face_lists_beside(scenery, NAME));
        let has_bodies = !scenery.standing().is_empty() || !scenery.all_guests().is_empty();
        let lacks = [
            (has_bodies, "rocks and man-made things"),
            (!scenery.all_effects().is_empty(), "lights, sheets and discs of the sky"),
            (self.stage.landscape.photographs().len() > 1, "all photographs but the first"),
            (self.stage.view.laws.curvature != Curvature::None, "curvature of the ground between posts"),
        ];
        let omission = |what: &str| Omission {
            block: NAME,
            what: what.to_owned(),
            why: "the program of the thesis draws panels of one photograph".to_owned(),
            weight: Weight::NotModelled,
        };
        omissions.extend(lacks.iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what)));
        omissions
    }

    /// Panel, posts, grey, depth and writes of a pixel; then the panels that lost to it.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        self.check(frame, pose)?;
        let looks = self.program.looks(&self.view(pose), pixel);
        let looks = looks.map_err(|error| cannot_draw(frame, &error))?;
        Ok(explained(&self.program, &looks))
    }
}
