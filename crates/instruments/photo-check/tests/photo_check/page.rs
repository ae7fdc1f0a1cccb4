//! The page: one file, both pictures, the figures.

use landscape::Sun;
use photo_camera::voids::Fill;
use photo_camera::{ControlPoint, check_by};
use photo_check::{Control, Overlay, Relief, Report, page};
use photograph::Photograph;

use crate::{elevation, from_above, ground};

/// A report on four control points that are all off by (3, -4) pixels.
fn report(photo: &Photograph, at_most: Option<f64>) -> (Report, Overlay) {
    let ground = ground(&elevation([15, 15], |north, east| 0.01 * north * east), photo);
    let sun = Sun { azimuth: 1.0, elevation: 0.5 };
    let controls: Vec<Control> = ground
        .points()
        .step_by(70)
        .enumerate()
        .map(|(at, ground)| {
            let [i, j] = photo.pixel(ground).expect("in front");
            Control { name: format!("<{at}>"), point: ControlPoint { ground, pixel: [i + 3.0, j - 4.0] } }
        })
        .collect();
    let points: Vec<_> = controls.iter().map(|control| control.point).collect();
    let residuals = check_by(|point| photo.pixel(point), &points).expect("points");
    let overlay = Overlay::new(&ground, photo, &Relief::new(&ground, &sun), None);
    let report = Report {
        files: ["a<b>.png".into(), "ground.asc".into()],
        coverage: photo.coverage(ground.points()).expect("inside"),
        ground_sample: Some([2.0, 2.0]),
        sample_unit: photo.placement().unit(),
        sun: (sun, "as given"),
        found: None,
        fill: Fill::Harmonic,
        voids: Report::voids_of(&ground.filling),
        hidden: overlay.hidden(),
        likeness: overlay.likeness(),
        residuals: Some((controls, residuals)),
        at_most,
        notes: vec!["a note".into()],
    };
    (report, overlay)
}

#[test]
fn the_page_is_one_file_with_both_pictures() {
    let (report, overlay) = report(&from_above(), None);
    let page = page(&overlay, &report).expect("a page");
    assert_eq!(page.matches("src=\"data:image/png;base64,iVBORw0KGgo").count(), 2);
    assert!(!page.contains("http://") && !page.contains("https://") && page.contains("default-src 'none'"));
    // Names of files are text, not markup.
    assert!(page.contains("a&lt;b&gt;.png over ground.asc") && !page.contains("<b>"));
    assert!(page.contains("best shift of 3.000, -4.000"), "{page}");
}

#[test]
fn the_threshold_decides_and_both_forms_say_so() {
    let photo = from_above();
    for (at_most, passes) in [(None, true), (Some(5.001), true), (Some(4.999), false)] {
        let (report, _) = report(&photo, at_most);
        assert_eq!(report.passes(), passes);
        let document = report.json();
        assert_eq!(document["passes"], passes);
        let points = &document["control_points"];
        assert!((points["root_mean_square_px"].as_f64().expect("a number") - 5.0).abs() < 1e-9);
        assert!(points["root_mean_square_after_shift_px"].as_f64().expect("a number") < 1e-9);
        let text = report.text();
        assert_eq!(text.contains("fails: root mean square 5.000 pixels, at most 4.999"), !passes, "{text}");
        assert!(
            text.contains("ground sample: 2 x 2 m at")
                && text.contains("note: a note")
                && text.contains("posts: 210 in the photograph, 15 beside it"),
            "{text}"
        );
    }
}
