//! The ground of a bank.

use crate::canvas::{Area, Canvas};
use crate::colour::{FAINT, mix, of_height};
use crate::frame::{BAR_ROOM, BELOW, Frame, Header, LEFT, colour_bar, map_frame, map_size};
use crate::ground::GroundMap;
use crate::{Drawing, PlotError};
use landscape::{Level, Sun};
use quantities::degrees;

/// Least and most pixels of a panel.
pub(crate) const PANEL: [u32; 2] = [120, 8000];

/// How a bank is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct BankLook {
    /// What the ground is.
    pub title: String,
    /// Lines below the title; sun, regions and contours are added.
    pub facts: Vec<String>,
    /// The longer side of the map, 120 to 8000 pixels.
    pub longest: u32,
    /// Lines of equal height.
    pub contours: bool,
    /// Borders of regions, where they are 8 pixels apart or more.
    pub regions: bool,
}

impl BankLook {
    /// A map of 800 pixels with contours and without regions.
    pub fn titled(title: impl Into<String>) -> Self {
        Self { title: title.into(), facts: vec![], longest: 800, contours: true, regions: false }
    }
}

/// The map of a level: shaded as under `sun` (Lambert's law, no cast shadows), coloured by height, north up.
///
/// # Errors
/// If the map is too small or too large.
pub fn bank_picture(level: &Level, sun: Sun, look: &BankLook) -> Result<Drawing, PlotError> {
    check_panel(look.longest)?;
    let [south, west, north, east] = level.extent();
    let (width, height) = map_size([north - south, east - west], look.longest);
    let paper = (LEFT + width + BAR_ROOM).max(560.0);
    let ground = GroundMap::sample(level, Area { left: 0.0, top: 0.0, width, height }, sun);
    let header = Header::new(&look.title, &facts(level, sun, look, &ground), paper - LEFT - 16.0);
    let area = Area { left: LEFT, top: header.height(), width, height };
    let mut canvas = Canvas::new(paper as u32, (area.bottom() + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    ground.draw(&mut canvas, area, look.contours);
    let (frame, unit) = map_frame(area, level.extent());
    if look.regions {
        draw_regions(&mut canvas, &frame, level);
    }
    frame.axes(&mut canvas, Some(&format!("east ({unit})")), &format!("north ({unit})"));
    colour_bar(&mut canvas, area, ground.ruler(), "height (m)", of_height);
    Ok(canvas.finish())
}

pub(crate) fn check_panel(pixels: u32) -> Result<(), PlotError> {
    let [least, most] = PANEL;
    if (least..=most).contains(&pixels) {
        Ok(())
    } else {
        Err(PlotError::PanelSize { found: pixels, least, most })
    }
}

/// Azimuth and elevation of the sun, for people.
pub(crate) fn sun_text(sun: Sun) -> String {
    format!("sun at azimuth {:.0}°, elevation {:.1}°", degrees(sun.azimuth), degrees(sun.elevation))
}

fn facts(level: &Level, sun: Sun, look: &BankLook, ground: &GroundMap) -> Vec<String> {
    let [rows, columns] = level.corners();
    let regions = format!("{} × {} regions of {} m", rows - 1, columns - 1, level.region_size());
    let contours = format!(", contours every {} m", ground.contour_interval());
    let own = format!("{regions}, {}{}", sun_text(sun), if look.contours { &contours } else { "" });
    look.facts.iter().cloned().chain([own]).collect()
}

fn draw_regions(canvas: &mut Canvas, frame: &Frame, level: &Level) {
    let pitch = [0, 1].map(|axis| {
        let side = if axis == 0 { frame.area.height } else { frame.area.width };
        side / (level.corners()[axis] - 1) as f32
    });
    if pitch[0].min(pitch[1]) < 8.0 {
        return;
    }
    let Area { left, top, width, height } = frame.area;
    let colour = mix(FAINT, [120, 120, 120], 0.2);
    for m in 1..level.corners()[0] - 1 {
        let line = Area { left, top: (top + m as f32 * pitch[0]).floor(), width, height: 1.0 };
        canvas.fill(line, colour);
    }
    for n in 1..level.corners()[1] - 1 {
        canvas.fill(Area { left: (left + n as f32 * pitch[1]).floor(), top, width: 1.0, height }, colour);
    }
}
