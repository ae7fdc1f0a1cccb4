//! What an elevation file holds.

use std::path::Path;

use quantities::degrees;
use serde_json::json;
use survey::{Elevation, Frame, Method, ReadOptions, SurveyError};
use text::shortened;

use crate::{Held, InfoError};

pub fn elevation(path: &Path) -> Result<Held, InfoError> {
    let (elevation, is_placed) = read_elevation(path)?;
    let Elevation { lines, columns, affine, frame, title, notes, .. } = &elevation;
    let (unit, scale, places): (&str, f64, usize) = match frame {
        Frame::Plane(_) => ("m", 1.0, 3),
        Frame::Geographic { .. } => ("deg", degrees(1.0), 6),
    };
    let extent = elevation.extent().map(|edge| edge * scale);
    let spacing = affine.step.map(|step| step.abs() * scale);
    let (range, voids, projection) = (elevation.range(), elevation.voids(), projection(*frame));
    let document = json!({
        "schema": "lunoid.info.elevation/1",
        "file": path.display().to_string(),
        "title": title,
        "lines": lines,
        "columns": columns,
        "unit": unit,
        "extent": is_placed.then_some(extent),
        "spacing": is_placed.then_some(spacing),
        "projection": projection,
        "heights_m": range,
        "voids": voids,
        "notes": notes,
    });
    let heights = range.map_or("no heights".into(), |[low, high]| format!("{low:.2} to {high:.2} m"));
    let place = if is_placed {
        let [south, west, north, east] = extent.map(|edge| shortened(edge, places));
        let [along, across] = spacing.map(|step| shortened(step, places));
        format!(
            "south {south}, west {west}, north {north}, east {east} {unit}\n  spacing {along} {unit} to the north, \
             {across} {unit} to the east; {projection}"
        )
    } else {
        "does not say where it lies or how far its samples are apart".into()
    };
    let mut text = format!(
        "{}: {title}\n  {lines} lines of {columns} samples, {heights}, {voids} void\n  {place}\n",
        path.display(),
    );
    text.extend(notes.iter().map(|note| format!("  note: {note}\n")));
    Ok(Held { document, text })
}

/// An elevation file, and whether it says where it lies: that does not matter to someone who only looks.
fn read_elevation(path: &Path) -> Result<(Elevation, bool), InfoError> {
    let anywhere = ReadOptions { spacing: Some([1.0; 2]), ..ReadOptions::default() };
    match survey::read(path, &ReadOptions::default()) {
        Ok(placed) => Ok((placed, true)),
        Err(SurveyError::UnknownFormat { found, .. }) => {
            Err(InfoError::UnknownStart { file: path.to_owned(), found: found.to_string() })
        }
        Err(refused) => match survey::read(path, &anywhere) {
            // It says where it lies; something else is wrong.
            Err(SurveyError::Option { .. }) => Err(refused.into()),
            read => Ok((read?, false)),
        },
    }
}

fn projection(frame: Frame) -> String {
    let (method, radius) = match frame {
        Frame::Plane(None) => return "projection unknown".into(),
        Frame::Geographic { radius } => ("latitude and longitude".to_owned(), radius),
        Frame::Plane(Some(projection)) => {
            let latitude = |angle: f64| text::latitude(degrees(angle), 6);
            let method = match projection.method {
                Method::Equirectangular { parallel } => {
                    format!("equirectangular, true along {}", latitude(parallel))
                }
                Method::PolarStereographic { .. } => "polar stereographic".into(),
                Method::Orthographic => "orthographic".into(),
            };
            let centre = latitude(projection.latitude);
            let longitude = text::longitude(degrees(projection.longitude), 6);
            (format!("{method}, centre {centre}, {longitude}"), projection.radius)
        }
    };
    format!("{method}, on a sphere of {} m", shortened(radius, 3))
}
