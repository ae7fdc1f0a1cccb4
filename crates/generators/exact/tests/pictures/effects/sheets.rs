//! Sheets and overlays in whole pictures.

use super::*;

/// The ray of a pixel meets level ground at 2 m over its tangent: before 20 m the curtain is hidden.
#[test]
fn ground_cuts_a_sheet_where_depth_says() {
    let (found, bare) =
        (seen(Effects { sheets: vec![curtain(0.25)], ..Effects::default() }), seen(Effects::default()));
    let field = usual().raster.field;
    let row = |index: usize| (index / 60) as f64;
    let mut counts = [0; 3];
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        let [low, high] = [0.0, 1.0].map(|down| field.tan_half_height * ((row(index) + down) / 20.0 - 1.0));
        let [top, foot] = [-1.0 / 20.0, 2.0 / 20.0];
        let shown = ((high.min(foot) - low.max(top)) / (high - low)).max(0.0);
        let opaque = value(&bare, PlaneKind::Intensity, index);
        let light = value(&found, PlaneKind::Intensity, index);
        let is_across = (5..55).contains(&(index % 60));
        counts[usize::from(shown > 0.0) + usize::from(shown >= 1.0)] += usize::from(is_across);
        if is_across {
            let expected = shown * 0.75 + (1.0 - 0.75 * shown) * opaque;
            assert!((light - expected).abs() < 0.01, "{index}: {light}, not {expected}");
            let is_full = shown <= 0.0 || shown >= 1.0;
            assert!(!is_full || (light - expected).abs() < 2e-7, "{index}: {light}, not {expected}");
        }
    }
    assert!(counts.iter().all(|&count| count > 40), "{counts:?}");
}

#[test]
fn an_overlay_lies_over_everything_by_its_area() {
    // From the middle of pixel 10 to three quarters of pixel 20, and from line 5 to a quarter of line 9.
    let [left, right] = [10.5, 20.75].map(|x| x / 30.0 - 1.0);
    let [top, bottom] = [5.0, 9.25].map(|y| y / 20.0 - 1.0);
    let corners = vec![[left, top], [right, top], [right, bottom], [left, bottom]];
    let overlay = Overlay { id: 0, corners, colour: [0.5; 3], share: 0.0, priority: 0 };
    let clear = Overlay { share: 0.75, ..overlay.clone() };
    let bright = LightPoint { intensity: 1.0, ..lamp([51.0, 99.7, 2.2]) };
    let found = seen(Effects { overlays: vec![overlay], ..lights(vec![bright]) });
    for (index, share) in [(5 * 60 + 10, 0.5), (6 * 60 + 15, 1.0), (7 * 60 + 20, 0.75), (9 * 60 + 15, 0.25)] {
        let bare = value(&seen(lights(vec![bright])), PlaneKind::Intensity, index);
        let expected = share * 0.5 + (1.0 - share) * bare;
        assert!((value(&found, PlaneKind::Intensity, index) - expected).abs() < 0.02, "{index}");
    }
    assert_eq!(value(&found, PlaneKind::Label, 6 * 60 + 15), f64::from(Label::EyeFixed.code()));
    let alone = seen(Effects { overlays: vec![clear], ..Effects::default() });
    for (index, share) in [(5 * 60 + 10, 0.5), (6 * 60 + 15, 1.0), (7 * 60 + 20, 0.75), (9 * 60 + 15, 0.25)] {
        let bare = value(&seen(Effects::default()), PlaneKind::Intensity, index);
        let expected = share * 0.25 * 0.5 + (1.0 - 0.25 * share) * bare;
        assert!((value(&alone, PlaneKind::Intensity, index) - expected).abs() < 1e-7, "{index}");
        assert_eq!(value(&alone, PlaneKind::Label, index), 0.0);
    }
}
