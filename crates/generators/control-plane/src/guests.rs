//! What a scene may have for other generators, and no block of the report draws: listed by name, so that no picture is wrong
//! in silence.

use generator::{Omission, Weight};
use landscape::Landscape;
use scenario::{BodyShading, Effects, Scenery};

const POLYHEDRA: &str = "polyhedron-generator";

/// What of a scene the machine draws otherwise, or not at all.
pub fn guest_omissions(landscape: &Landscape, scenery: &Scenery, shading: BodyShading) -> Vec<Omission> {
    let has_map = landscape.albedo_map().is_some();
    let still = || scenery.standing().iter().map(|standing| &standing.body);
    let is_colourful = still().any(|body| body.solid.is_colourful());
    let is_smooth = shading == BodyShading::Flat && still().any(|body| body.solid.is_smooth());
    let rows = [
        (
            scenery.all_effects().iter().any(|carried| has_surfaces(&carried.effects)),
            "mixing-unit",
            "sheets, overlays and discs of the sky (`[[sheet]]`, `[[overlay]]`, `[earth]`, `sun.disc`)",
            "the report has nothing translucent and no discs of the sky; --machine exact draws them",
        ),
        (
            has_map,
            "terrain-generator",
            "the map of albedo (`landscape.albedo_map`)",
            "a terrain generator has one albedo for all ground, `landscape.albedo`; --machine exact draws the map",
        ),
        (
            scenery.has_moving_objects(),
            POLYHEDRA,
            "objects that move (`moves` of an [[object]]); they are not drawn, and cast no shadow",
            "bodies of the report stand still between events; --machine exact draws them",
        ),
        (
            scenery.has_open_surfaces(),
            POLYHEDRA,
            "open surfaces (`open` of an [[object]]); they are not drawn, and cast no shadow",
            "line generators draw closed convex polyhedra; --machine exact draws them",
        ),
        (
            is_smooth,
            POLYHEDRA,
            "normals at corners; every face has one light",
            "a face of the report has one reflectivity; polyhedron_generator.shading = \"smooth\" and --machine exact draw smooth light",
        ),
        (
            is_colourful,
            POLYHEDRA,
            "colour of objects (`colour` of an [[object]], or of its file); their luminance is drawn",
            "the video is one signal; --machine exact draws red, green and blue",
        ),
        (
            scenery.has_suns_of_groups(),
            POLYHEDRA,
            "suns of groups (`sun` of a [[group]]); the scene's sun lights all, and all cast shadow",
            "the report has one sun; --machine exact draws them",
        ),
        (
            still().any(|body| body.priority != 0),
            POLYHEDRA,
            "priorities of objects (`priority` of an [[object]])",
            "the third video switch takes what is nearer; --machine exact has them where things coincide",
        ),
    ];
    let there = rows.into_iter().filter(|(is_there, ..)| *is_there);
    there.map(|(_, block, what, why)| omission(block, what, why)).collect()
}

/// Whether there is more than light points, which the third video switch and a second beam draw.
fn has_surfaces(Effects { sheets, overlays, discs, .. }: &Effects) -> bool {
    !(sheets.is_empty() && overlays.is_empty() && discs.is_empty())
}

fn omission(block: &'static str, what: &str, why: &str) -> Omission {
    Omission { block, what: what.into(), why: why.into(), weight: Weight::NotModelled }
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroU16;
    use std::sync::Arc;

    use super::guest_omissions;
    use generator::Weight;
    use glam::{DMat3, DVec3};
    use landscape::{AlbedoMap, Bank, Landscape, Level, Sun, Texels};
    use scenario::{
        BodyShading, Carried, Effects, Frame, Group, GroupSun, Guest, LightPoint, LightSource, Medium,
        Scenery, Sheet, Standing,
    };
    use solids::{Body, Kind, Solid};

    const SUN: Sun = Sun { azimuth: 0.0, elevation: 0.5 };

    fn ground() -> Landscape {
        let level = Level::new(10.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        Landscape::new(Bank::new("", vec![level], None).unwrap(), 0.5)
    }

    fn cube() -> Solid {
        Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).unwrap()
    }

    fn standing(solid: Solid, change: impl Fn(&mut Body)) -> Scenery {
        let turn = DMat3::IDENTITY;
        let mut body = Body::place(0, Kind::Culture, &Arc::new(solid), DVec3::ONE, &turn, 1.0);
        change(&mut body);
        let group = Group { name: "g".into(), sun: Some(GroupSun { first: SUN, rate: 0.0 }) };
        let standing = Standing { from: 0.0, until: 9.0, body };
        Scenery::still(SUN).with_bodies(vec![standing]).with_groups(vec![group])
    }

    fn guest(solid: Solid, spin: f64) -> Scenery {
        let frame = Frame { time: 0.0, foot: DVec3::ONE, attitude: Default::default() };
        let guest = Guest {
            from: 0.0,
            until: 9.0,
            object: 0,
            solid: Arc::new(solid),
            scale: 1.0,
            frames: vec![frame],
            spin,
            priority: 0,
            group: None,
        };
        Scenery::still(SUN).with_guests(vec![guest])
    }

    #[test]
    fn light_points_are_drawn_and_sheets_are_listed() {
        let star = LightSource::Star { direction: DVec3::X, magnitude: 1.0 };
        let light = LightPoint {
            id: 0,
            source: star,
            colour: [1.0; 3],
            intensity: 1.0,
            lobe: None,
            priority: 0,
            calligraphic: false,
        };
        let sheet = Sheet {
            id: 0,
            corners: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            colour: [1.0; 3],
            medium: Medium::Share(0.5),
            priority: 0,
        };
        let listed = |effects: Effects| {
            let scenery = Scenery::still(SUN).with_effects(vec![Carried::still(effects)]);
            guest_omissions(&ground(), &scenery, BodyShading::Flat)
        };
        let lights = vec![light];
        assert!(listed(Effects { lights: lights.clone(), ..Effects::default() }).is_empty());
        let [omission] = &listed(Effects { lights, sheets: vec![sheet], ..Effects::default() })[..] else {
            panic!("one omission")
        };
        assert!(omission.what.contains("[[sheet]]") && !omission.what.contains("light"), "{omission:?}");
    }

    #[test]
    fn each_is_listed_by_name_and_what_is_drawn_is_not() {
        let map = AlbedoMap::new([0.0, 0.0, 1.0, 1.0], [1, 1], Texels::Grey(vec![0.5])).unwrap();
        let places = cube().vertices().to_vec();
        let smooth = cube().with_normals(|_, corner| Some(places[corner as usize]));
        let sheet = Solid::open(places[..3].to_vec(), vec![(vec![0, 1, 2], 0.5)]).unwrap();
        let none = Scenery::still(SUN);
        let cases = [
            (ground().with_albedo_map(Some(map)), none, "landscape.albedo_map"),
            (ground(), guest(cube(), 1.0), "objects that move"),
            (ground(), guest(sheet, 0.0), "open surfaces"),
            (ground(), standing(smooth, |_| ()), "normals at corners"),
            (ground(), standing(cube().coloured([1.0, 0.0, 0.0]).unwrap(), |_| ()), "colour of objects"),
            (ground(), standing(cube(), |body| body.group = NonZeroU16::new(1)), "suns of groups"),
            (ground(), standing(cube(), |body| body.priority = 1), "priorities"),
        ];
        for (landscape, scenery, word) in cases {
            let found = guest_omissions(&landscape, &scenery, BodyShading::Flat);
            let [omission] = &found[..] else { panic!("{word}: {found:?}") };
            assert!(omission.what.contains(word) && omission.weight == Weight::NotModelled, "{omission:?}");
            assert!(omission.why.contains("--machine exact"), "{omission:?}");
        }
        assert!(guest_omissions(&ground(), &standing(cube(), |_| ()), BodyShading::Flat).is_empty());
    }

    #[test]
    fn normals_are_drawn_by_smooth_light() {
        let places = cube().vertices().to_vec();
        let smooth = cube().with_normals(|_, corner| Some(places[corner as usize]));
        assert!(guest_omissions(&ground(), &standing(smooth, |_| ()), BodyShading::Smooth).is_empty());
    }
}
