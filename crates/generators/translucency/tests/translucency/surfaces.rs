//! Whole sub-areas of triangles: every sampling point against the plane of the nearest of them.

use raster::{Coverage, DistancePlane, Filter, Pattern, Point, Sampling, Screen, Triangle};
use translucency::{Capacity, Feature, Losses, Stack};

use super::{Random, assert_colour, separate};

struct Face {
    triangle: Triangle,
    plane: DistancePlane,
    feature: Feature,
}

fn faces(random: &mut Random, count: u32, opaque: bool) -> Vec<Face> {
    let mut face = |id| {
        let corners = [0; 3].map(|_| [28.0 * random.unit() - 4.0, 28.0 * random.unit() - 4.0]);
        let triangle = Triangle::new(corners.map(|corner| Point::snap(corner).unwrap()))?;
        let slope = [0; 2].map(|_| 0.001 * (random.unit() - 0.5));
        let plane = DistancePlane { slope, origin: 0.02 + 0.1 * random.unit() };
        let translucency = if opaque { 0.0 } else { random.unit() };
        let feature = Feature::surface(id, 0, random.colour(), translucency).unwrap();
        Some(Face { triangle, plane, feature })
    };
    (0..count).filter_map(&mut face).collect()
}

/// Draws all sub-areas, and hands over the stack of each with the columns and rows of its pixels.
fn draw(
    sampling: &Sampling,
    capacity: Capacity,
    faces: &[Face],
    mut seen: impl FnMut(&Stack, usize, [u32; 2]),
) {
    let screen = Screen::new([21, 18], 8).unwrap();
    let mut stack = Stack::new(sampling.clone(), capacity, [0.1; 3]).unwrap();
    let mut coverage = Coverage::default();
    for area in (0..screen.sub_areas()).map(|number| screen.sub_area(number)) {
        stack.start(&area);
        for face in faces {
            coverage.find(&face.triangle, &area, sampling);
            stack.add(face.feature, &face.plane, coverage.pixels());
        }
        for row in area.rows() {
            for column in area.columns() {
                let pixel = 8 * (row - area.rows().start) + column - area.columns().start;
                seen(&stack, pixel as usize, [column, row]);
            }
        }
    }
}

/// Bits of all pixels, from a second look at the coverage, far from the stack.
fn covering<'a>(
    faces: &'a [Face],
    sampling: &'a Sampling,
    pixel: [u32; 2],
    point: usize,
) -> impl Iterator<Item = &'a Face> {
    let screen = Screen::new([21, 18], 1).unwrap();
    let area = screen.sub_area((pixel[1] * 21 + pixel[0]) as usize);
    let mut coverage = Coverage::default();
    faces.iter().filter(move |face| {
        coverage.find(&face.triangle, &area, sampling);
        coverage.mask(0) >> point & 1 == 1
    })
}

#[test]
fn the_nearest_opaque_face_is_seen_at_every_sampling_point() {
    let mut random = Random(5);
    for sampling in Pattern::ALL
        .map(Sampling::new)
        .into_iter()
        .chain(Sampling::turned(Pattern::Four))
        .chain(Sampling::turned(Pattern::Sixteen))
    {
        let faces = faces(&mut random, 12, true);
        draw(&sampling, separate(2, 1), &faces, |stack, pixel, on_screen| {
            for (i, place) in sampling.places(on_screen.map(|at| at as i32)).enumerate() {
                let covering = covering(&faces, &sampling, on_screen, i);
                let nearest = covering.max_by(|a, b| a.plane.at(place).total_cmp(&b.plane.at(place)));
                let sample = pixel * stack.samples() + i;
                let found = stack.surface_at(sample).map(|(feature, q)| (feature.id(), q));
                assert_eq!(found, nearest.map(|face| (face.feature.id(), face.plane.at(place))));
                let colour = nearest.map_or([0.1; 3], |face| face.feature.own_light());
                assert_eq!(stack.colour_at(sample), colour);
            }
            let points = 0..stack.samples();
            let all = points.filter_map(|i| stack.surface_at(pixel * stack.samples() + i));
            let nearest = all.map(|(_, q)| q).max_by(f64::total_cmp);
            assert_eq!(stack.surface(pixel).map(|(_, q)| q), nearest);
        });
    }
}

#[test]
fn a_pixel_is_the_weighted_sum_of_its_sampling_points() {
    let mut random = Random(6);
    let (sampling, mixed) = (Sampling::new(Pattern::Eight), faces(&mut random, 10, true));
    let mixed: Vec<Face> = mixed.into_iter().chain(faces(&mut random, 10, false)).collect();
    let [weights, tent] = [Filter::Box, Filter::Tent].map(|filter| filter.weights(Pattern::Eight));
    draw(&sampling, Capacity::UNLIMITED, &mixed, |stack, pixel, _| {
        for weights in [weights.of([0, 0]), tent.of([0, 0]), tent.of([-1, 1])] {
            let colours = (0..8).map(|i| stack.colour_at(8 * pixel + i));
            let sum = colours.zip(weights).fold([0.0; 3], |sum, (colour, weight)| {
                [0, 1, 2].map(|channel| sum[channel] + weight * colour[channel])
            });
            assert_colour(stack.colour(pixel, weights), sum, 1e-15);
        }
    });
}

/// Composes back to front from the coverage of single pixels.
#[test]
fn translucent_faces_are_composed_at_every_sampling_point() {
    let mut random = Random(7);
    for pattern in [Pattern::One, Pattern::Four, Pattern::Lattice32] {
        let (sampling, faces) = (Sampling::new(pattern), faces(&mut random, 16, false));
        draw(&sampling, Capacity::UNLIMITED, &faces, |stack, pixel, on_screen| {
            for (i, place) in sampling.places(on_screen.map(|at| at as i32)).enumerate() {
                let mut order: Vec<&Face> = covering(&faces, &sampling, on_screen, i).collect();
                order.sort_by(|a, b| a.plane.at(place).total_cmp(&b.plane.at(place)));
                let colour = order.iter().fold([0.1; 3], |behind: [f64; 3], face| {
                    let own = face.feature.own_light();
                    [0, 1, 2].map(|channel| own[channel] + face.feature.translucency() * behind[channel])
                });
                assert_colour(stack.colour_at(pixel * stack.samples() + i), colour, 1e-14);
            }
        });
    }
}

#[test]
fn what_has_no_distance_is_not_stored_and_what_is_fixed_to_the_eye_is_nearest() {
    let screen = Screen::new([8, 8], 8).unwrap();
    let mut stack = Stack::new(Sampling::new(Pattern::Four), separate(1, 0), [0.0; 3]).unwrap();
    stack.start(&screen.sub_area(0));
    let at = |origin| DistancePlane { slope: [0.0; 2], origin };
    let opaque = |id, priority| Feature::surface(id, priority, [0.5; 3], 0.0).unwrap();
    let sheet = |id| Feature::surface(id, 0, [0.5; 3], 0.5).unwrap();
    for origin in [f64::NAN, f64::NEG_INFINITY] {
        stack.add(opaque(1, 0), &at(origin), [(0, 15)]);
        stack.add(sheet(2), &at(origin), [(0, 15)]);
        assert_eq!((stack.layers(0).count(), stack.loss_at(0)), (0, None));
    }
    stack.add(opaque(3, 0), &at(f64::INFINITY), [(0, 15)]);
    stack.add(opaque(4, 2), &at(f64::INFINITY), [(0, 3)]);
    stack.add(opaque(5, 0), &at(1e300), [(0, 15)]);
    let seen = [0, 1, 2, 3].map(|sample| stack.surface_at(sample).map(|(feature, _)| feature.id()));
    assert_eq!(seen, [Some(4), Some(4), Some(3), Some(3)]);
}

/// Sheets over the whole screen, of planes that cross one another here and there, as two triangles each.
fn sheets(random: &mut Random, count: u32) -> Vec<Face> {
    let corners = [[-8.0, -8.0], [29.0, -8.0], [29.0, 26.0], [-8.0, 26.0]];
    let half = |[a, b, c]: [usize; 3]| {
        Triangle::new([a, b, c].map(|corner| Point::snap(corners[corner]).unwrap())).unwrap()
    };
    let mut sheet = |number: u32| {
        let slope = [0; 2].map(|_| 0.0004 * (random.unit() - 0.5));
        let plane = DistancePlane { slope, origin: 0.03 + 0.01 * f64::from(number) };
        let feature = Feature::surface(100 + number, 0, random.colour(), random.unit()).unwrap();
        [[0, 1, 2], [0, 2, 3]].map(|corners| Face { triangle: half(corners), plane, feature })
    };
    (0..count).flat_map(&mut sheet).collect()
}

/// What all pixels show and all sub-areas lose, and that both are what sampling points say one by one.
fn shown(
    sampling: &Sampling,
    capacity: Capacity,
    faces: &[Face],
    weights: &[f64],
) -> (Vec<[f64; 3]>, Vec<Losses>) {
    let (mut colours, mut losses) = (Vec::new(), Vec::new());
    draw(sampling, capacity, faces, |stack, pixel, _| {
        let samples = pixel * stack.samples()..(pixel + 1) * stack.samples();
        let of_points = samples.clone().zip(weights).fold([0.0; 3], |sum, (sample, weight)| {
            let colour = stack.colour_at(sample);
            [0, 1, 2].map(|channel| sum[channel] + weight * colour[channel])
        });
        let colour = stack.colour(pixel, weights);
        if stack.is_layered(pixel) {
            assert_eq!(colour, of_points, "to the bit");
        }
        colours.push(colour);
        losses.push(stack.losses());
    });
    (colours, losses)
}

/// Most features of such a sub-area lie behind all that its stacks keep and have lost, and are passed over.
#[test]
fn sheets_over_whole_sub_areas_are_the_same_in_any_order() {
    let mut random = Random(7);
    let sampling = Sampling::new(Pattern::Four);
    let weights = Filter::Box.weights(Pattern::Four);
    for capacity in [separate(2, 1), separate(0, 0), Capacity::Shared(Some(3))] {
        let mut all = sheets(&mut random, 9);
        all.extend(faces(&mut random, 6, true));
        all.extend(faces(&mut random, 3, false));
        let near_last = shown(&sampling, capacity, &all, weights.of([0, 0]));
        assert!(near_last.1.iter().any(|losses| losses.translucent > 0 && losses.bound[0] > 0.0));
        for _ in 0..8 {
            for last in (1..all.len()).rev() {
                all.swap(last, (random.unit() * (last + 1) as f64) as usize);
            }
            assert!(shown(&sampling, capacity, &all, weights.of([0, 0])) == near_last, "{capacity:?}");
        }
        all.sort_by(|a, b| b.plane.origin.total_cmp(&a.plane.origin));
        assert!(shown(&sampling, capacity, &all, weights.of([0, 0])) == near_last, "near first");
    }
}

/// Losses of a sub-area are those of its sampling points, one by one.
#[test]
fn losses_are_those_of_the_sampling_points() {
    let mut random = Random(8);
    let sampling = Sampling::new(Pattern::Four);
    let mut all = sheets(&mut random, 6);
    all.extend(faces(&mut random, 5, true));
    let (mut lost, mut largest) = (0, 0.0f64);
    let mut of_area = Losses::default();
    draw(&sampling, separate(2, 1), &all, |stack, pixel, _| {
        if pixel == 0 {
            assert_eq!((of_area.translucent, of_area.bound[0]), (lost, largest));
            (lost, largest, of_area) = (0, 0.0, stack.losses());
        }
        for loss in (4 * pixel..4 * pixel + 4).filter_map(|sample| stack.loss_at(sample)) {
            lost += u64::from(loss.nearest[0].is_some());
            largest = largest.max(loss.bound[0]);
        }
    });
    assert_eq!((of_area.translucent, of_area.bound[0]), (lost, largest));
    assert!(lost > 0 && largest > 0.0);
}
