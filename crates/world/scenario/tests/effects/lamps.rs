//! Lamps on their ground and on what carries them.

use super::*;

#[test]
fn light_points_count_through_the_mission() {
    let names = |table: &str, id: &str| table.replace("id = 'a'", &format!("id = '{id}'"));
    let string = format!("{LAMP}count = 3\nto = {{ x_m = 200, y_m = 90, above_m = 4 }}\n");
    let scenery = made(&format!("{}{}{}{SEEDED}", names(STAR, "s"), names(&string, "t"), names(LAMP, "u")));
    let effects = scenery.effects(0.0);
    assert_eq!(effects.lights.iter().map(|light| light.id).collect::<Vec<_>>(), (0..55).collect::<Vec<_>>());
    // A string stands on the heights of its ground.
    assert_eq!(
        lamps(&effects),
        [
            (1, [100.0, 50.0, 10.0]),
            (2, [150.0, 70.0, 17.0]),
            (3, [200.0, 90.0, 24.0]),
            (4, [100.0, 50.0, 10.0])
        ]
    );
    let LightSource::Star { direction, magnitude } = effects.lights[0].source else { panic!("a star") };
    assert!(
        (direction - DVec3::new(0.0, 0.75_f64.sqrt(), 0.5)).length() < 1e-12
            && (magnitude - 2.96).abs() < 1e-12
    );
    assert!(effects.lights[5..].iter().all(|light| matches!(light.source, LightSource::Star { .. })));
}

#[test]
fn a_string_follows_uneven_ground() {
    // Heights along a line over waves, from the ground itself.
    let waves = "[landscape.generated.undulation]\nrms_height_m = 2\nhurst = 0.8\nlongest_m = 300\nshortest_m = 120\n";
    let string = format!("{LAMP}above_m = 1\ncount = 20\nto = {{ x_m = 500, y_m = 400, above_m = 1 }}\n");
    let scenario = parsed(&format!("{waves}{string}"));
    let GroundSource::Generated(relief) = &scenario.ground else { panic!("generated") };
    let ground = Landscape::new(Bank::new("t", vec![relief.build().unwrap()], None).unwrap(), 1.0);
    let effects = Scenery::of(&scenario, &ground, rate()).unwrap().effects(0.0);
    let found = lamps(&effects);
    assert_eq!(found.len(), 20);
    for (_, [x, y, up]) in found {
        assert!((up - 1.0 - ground.height(x, y).unwrap()).abs() < 1e-6, "{x} {y} {up}");
    }
}

/// From y = 330 to y = 380 along x = 300, turning from east to south.
const CART: &str = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\nheading_deg = 90\n\
    [object.moves]\nkeyframes = [{ t_s = 2, x_m = 300, y_m = 330 }, { t_s = 4, x_m = 300, y_m = 380, heading_deg = 180 }]\n\
    [[light]]\nid = 'a'\non = 'cart'\nat_m = [2, 1, 3]\ndiameter_m = 0.4\nbeam = { half_angle_deg = 30 }\n";

#[test]
fn a_lamp_follows_the_object_that_carries_it() {
    let scenery = made(CART);
    for (time, foot, heading) in [
        (0.0, [300.0, 330.0, 30.0], 90.0),
        (3.0, [300.0, 355.0, 30.0], 135.0),
        (9.0, [300.0, 380.0, 30.0], 180.0),
    ] {
        let attitude = Attitude { heading: radians(heading), ..Attitude::default() };
        let turn = Stance { at: [0.0; 2], attitude }.to_ground();
        let [light] = scenery.effects(time).lights[..] else { panic!("one light") };
        let LightSource::Lamp { at, diameter } = light.source else { panic!("a lamp") };
        let expected = DVec3::from_array(foot) + turn * DVec3::new(2.0, 1.0, 3.0);
        assert!(at.distance(expected) < 1e-9 && diameter == 0.4, "{time}: {at} {expected}");
        assert!((light.lobe.unwrap().axis - turn * DVec3::X).length() < 1e-12, "{time}");
        // It stands as far from the object's parts as it is written.
        let body = scenery.guests(time).next().unwrap();
        assert!(((at - body.foot).length() - 14_f64.sqrt()).abs() < 1e-9);
    }
    let gone = made(&format!("{CART}[[event]]\nt_s = 3\naction = 'delete'\nobject = 'cart'\n"));
    assert!(!gone.effects(2.9).lights.is_empty() && gone.effects(3.0).lights.is_empty());
}

#[test]
fn a_lamp_comes_jumps_and_goes_with_its_object() {
    let events = "[[event]]\nt_s = 2\naction = 'add'\nobject = 'cart'\n\
        [[event]]\nt_s = 4\naction = 'move'\nobject = 'cart'\nx_m = 200\ny_m = 100\nheading_deg = 0\n\
        [[event]]\nt_s = 6\naction = 'delete'\nobject = 'cart'\n";
    let absent = CARRIED.replace("heading_deg = 90\n", "heading_deg = 90\npresent = false\nscale = 3\n");
    let scenery = made(&format!("{absent}until_s = 5.5\n{events}"));
    let at = |time: f64| lamps(&scenery.effects(time));
    assert_eq!((at(1.9), at(5.5)), (vec![], vec![]));
    // Facing east: forward is east, starboard is south. The ground is at 30 m, and at 20 m.
    assert_eq!((at(2.0), at(3.9)), (vec![(0, [299.0, 332.0, 33.0])], vec![(0, [299.0, 332.0, 33.0])]));
    assert_eq!(at(4.0), [(0, [202.0, 101.0, 23.0])]);
}

#[test]
fn a_lamp_of_its_own_moves_turns_and_flashes() {
    let moves = "above_m = 2\nmoves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }, \
        { t_s = 2, x_m = 200, y_m = 50, above_m = 5 }] }\n";
    let scenery = made(&format!("{LAMP}{moves}flash = {{ period_s = 0.4, duty = 0.75 }}\n"));
    assert_eq!(lamps(&scenery.effects(0.0)), [(0, [100.0, 50.0, 12.0])]);
    assert_eq!(lamps(&scenery.effects(1.0)), [(0, [150.0, 50.0, 19.5])]);
    assert!(scenery.effects(0.35).lights.is_empty());
    // A spin alone turns the beam of a lamp that stays.
    let turning = made(&format!("{LAMP}beam = {{ half_angle_deg = 9 }}\nmoves = {{ spin_deg_s = 90 }}\n"));
    for (time, axis) in [(0.0, DVec3::X), (1.0, DVec3::Y), (2.0, -DVec3::X)] {
        let effects = turning.effects(time);
        assert!((effects.lights[0].lobe.unwrap().axis - axis).length() < 1e-12, "{time}");
        assert_eq!(lamps(&effects), [(0, [100.0, 50.0, 10.0])]);
    }
}
