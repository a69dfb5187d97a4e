//! What users of the geometry room rely on, as properties of random concave polygons with holes.

#[path = "common/polygons.rs"]
mod polygons;

use bosquet::geometry::*;
use glam::DVec2;
use polygons::{area, convex, polygon};
use proptest::prelude::*;
use std::hint::black_box;

/// Every ring simple and rightly turned, holes inside: the repaired area is the area.
fn assert_sound(area: &Area) {
    for part in area.polygons() {
        part.sanity_check().unwrap();
        let rings: Vec<Vec<DVec2>> = part.rings().map(<[DVec2]>::to_vec).collect();
        let (repaired, _) = repair(&rings);
        close(repaired.area(), part.area(), 1e-4 + 1e-5 * part.perimeter());
    }
}

#[track_caller]
fn close(a: f64, b: f64, slack: f64) {
    assert!((a - b).abs() <= slack, "{a} is not {b}");
}

/// A unit vector, now and then along an axis.
fn direction() -> impl Strategy<Value = DVec2> {
    let any = (0.0..360.0f64).prop_map(|a| DVec2::new(libm::cos(a.to_radians()), libm::sin(a.to_radians())));
    prop_oneof![1 => Just(DVec2::X), 1 => Just(DVec2::Y), 1 => Just(DVec2::NEG_X), 3 => any]
}

/// What wild rings on a lattice mean: collinear edges, parts that touch in points, holes that touch the rim.
fn lattice() -> impl Strategy<Value = Area> {
    let point = (-6i32..6, -6i32..6).prop_map(|(x, y)| DVec2::new(x as f64, y as f64));
    prop::collection::vec(prop::collection::vec(point, 3..14), 1..4).prop_map(|rings| repair(&rings).0)
}

/// Any number a file can hold, now and then an ordinary one.
fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -10.0..10.0f64, Just(0.0), Just(1e300), Just(-1e-300), Just(f64::NAN)]
}

/// A grid of points over the bounds of an area.
fn samples(area: &Area, count: usize) -> Vec<DVec2> {
    let (bounds, step) = (area.bounds(), 1.0 / count as f64);
    let at = |i: usize, j: usize| bounds.min + bounds.size() * step * DVec2::new(i as f64 + 0.5, j as f64 + 0.5);
    (0..count).flat_map(|i| (0..count).map(move |j| (i, j))).map(|(i, j)| at(i, j)).collect()
}

proptest! {
    #[test]
    fn bands_sum_to_the_whole(area in area(), normal in direction(), parts in 1usize..12) {
        let along = area.edges().map(|(a, _)| a.dot(normal));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s), h.max(s)));
        let cuts: Vec<f64> = (0..=parts).map(|i| low + (high - low) * i as f64 / parts as f64).collect();
        let all = bands(&area, normal, &cuts);
        close(all.iter().map(Area::area).sum(), area.area(), 1e-6);
        for (part, cut) in all.iter().zip(cuts.windows(2)) {
            assert_sound(part);
            close(part.area(), band(&area, normal, cut[0], cut[1]).area(), 1e-6);
            prop_assert!(part.edges().all(|(a, _)| (cut[0] - 1e-8..=cut[1] + 1e-8).contains(&a.dot(normal))));
        }
    }

    #[test]
    fn bands_of_a_lattice_along_its_lines_are_sound(area in lattice(), flip in any::<bool>()) {
        let normal = if flip { DVec2::X } else { DVec2::NEG_Y };
        let cuts: Vec<f64> = (-6..=6).map(f64::from).collect();
        let all = bands(&area, normal, &cuts);
        close(all.iter().map(Area::area).sum(), area.area(), 1e-4);
        for (part, cut) in all.iter().zip(cuts.windows(2)) {
            assert_sound(part);
            for p in samples(part, 8) {
                if part.distance_to_edges(p) > 1e-4 {
                    let inside = area.contains(p) && (cut[0]..=cut[1]).contains(&p.dot(normal));
                    prop_assert_eq!(part.contains(p), inside);
                }
            }
        }
    }

    #[test]
    fn lattices_shrink_and_fall_apart_soundly(area in lattice(), distance in 0.05..1.0f64) {
        let inner = inset(&area, distance);
        assert_sound(&inner);
        for (a, _) in inner.edges() {
            let owner = area.polygons().iter().find(|p| p.contains(a));
            prop_assert!(owner.is_some_and(|p| p.distance_to_edges(a) >= distance - 1e-4));
        }
        for part in area.polygons() {
            let result = setback(part, |edge| if edge % 4 == 1 { 0.0 } else { distance });
            let sum: f64 = result.strips.iter().map(|s| s.area.area()).sum();
            close(sum + result.remainder.area(), part.area(), 1e-3);
        }
    }

    #[test]
    fn convex_bands_agree_with_the_general_ones(polygon in convex(), normal in direction()) {
        let whole = Area::from(polygon.clone());
        let cuts: Vec<f64> = (-9..=9).map(|i| i as f64 * 6.7).collect();
        for (part, cut) in bands(&whole, normal, &cuts).iter().zip(cuts.windows(2)) {
            close(part.area(), band(&whole, normal, cut[0], cut[1]).area(), 1e-9);
        }
        close(bands(&whole, normal, &cuts).iter().map(Area::area).sum(), polygon.area(), 1e-9);
    }

    #[test]
    fn insets_keep_their_distance(area in area(), distance in 0.05..4.0f64) {
        let inner = inset(&area, distance);
        assert_sound(&inner);
        for (a, b) in inner.edges() {
            for p in [a, a.lerp(b, 0.5)] {
                prop_assert!(area.contains(p));
                prop_assert!(area.distance_to_edges(p) >= distance - 1e-4, "{}", area.distance_to_edges(p));
            }
        }
        for p in samples(&area, 12) {
            if area.contains(p) && area.distance_to_edges(p) > 6.0 * distance {
                prop_assert!(inner.contains(p));
            }
        }
    }

    #[test]
    fn buffers_are_all_points_within_the_distance(area in area(), distance in 0.1..4.0f64) {
        let (outer, inner) = (buffered(&area, distance), buffered(&area, -distance));
        for p in samples(&outer, 16) {
            let (inside, gap) = (area.contains(p), area.distance_to_edges(p));
            if (gap - distance).abs() > 0.01 {
                prop_assert_eq!(outer.contains(p), inside || gap < distance);
                prop_assert_eq!(inner.contains(p), inside && gap > distance);
            }
        }
    }

    #[test]
    fn convex_insets_agree_with_the_general_ones(polygon in convex(), distance in 0.05..12.0f64) {
        let exact = inset(&polygon.clone().into(), distance);
        assert_sound(&exact);
        // Convex polygons shrink without arcs, so the engine's round offset must give the same.
        let rounded = buffered(&polygon.clone().into(), -distance);
        close(exact.area(), rounded.area(), 1e-4 + 1e-5 * polygon.perimeter());
    }

    #[test]
    fn setbacks_share_out_the_whole(polygon in polygon(), widths in prop::collection::vec(0.0..3.0f64, 8)) {
        let width = |edge: usize| if edge.is_multiple_of(3) { 0.0 } else { widths[edge % 8] };
        let result = setback(&polygon, width);
        let whole = polygon.area();
        let slack = 1e-3 + 1e-4 * polygon.perimeter();
        let sum: f64 = result.strips.iter().map(|s| s.area.area()).sum();
        close(sum + result.remainder.area(), whole, slack);
        let all: Vec<&Area> = result.strips.iter().map(|s| &s.area).chain([&result.remainder]).collect();
        close(union_all(all).area(), whole, slack);
        for strip in &result.strips {
            assert_sound(&strip.area);
            let (a, b) = polygon.edges().nth(strip.edge).unwrap();
            let normal = (b - a).perp().normalize();
            prop_assert!(strip.area.edges().all(|(p, _)| (p - a).dot(normal) <= width(strip.edge) + 1e-4));
        }
    }

    #[test]
    fn convex_setbacks_agree_with_the_inset(polygon in convex(), width in 0.1..4.0f64) {
        let result = setback(&polygon, |_| width);
        close(result.remainder.area(), inset(&polygon.clone().into(), width).area(), 1e-6);
        let sum: f64 = result.strips.iter().map(|s| s.area.area()).sum();
        close(sum + result.remainder.area(), polygon.area(), 1e-6);
        for strip in &result.strips {
            for (p, _) in strip.area.edges() {
                let (a, b) = polygon.edges().nth(strip.edge).unwrap();
                let gap = (b - a).perp().normalize().dot(p - a);
                prop_assert!(gap <= polygon.distance_to_edges(p) + 1e-6);
            }
        }
    }

    #[test]
    fn booleans_obey_inclusion_and_exclusion(a in polygon(), b in polygon(), x in -30.0..30.0f64, y in -30.0..30.0f64) {
        let (a, b) = (Area::from(a), Area::from(b.translated(DVec2::new(x, y))));
        let (all, both, rest) = (union(&a, &b), intersection(&a, &b), difference(&a, &b));
        let slack = 1e-4 + 1e-5 * (a.perimeter() + b.perimeter());
        close(all.area() + both.area(), a.area() + b.area(), slack);
        close(rest.area() + both.area(), a.area(), slack);
        close(overlap_area(&a, &b), both.area(), slack);
        prop_assert_eq!(overlaps(&a, &b, 1e-2), overlap_area(&a, &b) > 1e-2);
        [&all, &both, &rest].into_iter().for_each(assert_sound);
        for p in samples(&a, 10) {
            if a.distance_to_edges(p).min(b.distance_to_edges(p)) > 1e-5 {
                prop_assert_eq!(both.contains(p), a.contains(p) && b.contains(p));
                prop_assert_eq!(rest.contains(p), a.contains(p) && !b.contains(p));
                prop_assert_eq!(all.contains(p), a.contains(p) || b.contains(p));
            }
        }
    }

    #[test]
    fn triangles_cover_the_polygon(polygon in polygon()) {
        let triangles = Area::from(polygon.clone()).triangles();
        let area = |t: &[DVec2; 3]| (t[1] - t[0]).perp_dot(t[2] - t[0]) * 0.5;
        prop_assert!(triangles.iter().all(|t| area(t) >= 0.0));
        close(triangles.iter().map(area).sum(), polygon.area(), 1e-7);
    }

    #[test]
    fn contains_agrees_with_the_winding_number(polygon in polygon()) {
        for p in samples(&polygon.clone().into(), 12) {
            let turn = |(a, b): (DVec2, DVec2)| libm::atan2((a - p).perp_dot(b - p), (a - p).dot(b - p));
            let winding = polygon.edges().map(turn).sum::<f64>() / std::f64::consts::TAU;
            prop_assert_eq!(polygon.contains(p), winding > 0.5);
        }
        prop_assert!(polygon.edges().all(|(a, b)| polygon.contains(a) && polygon.contains(a.lerp(b, 0.3))));
    }

    #[test]
    fn inner_points_are_inside(area in area()) {
        let p = area.interior_point().unwrap();
        prop_assert!(area.contains(p) && area.distance_to_edges(p) > 0.0);
        let deepest = samples(&area, 20).into_iter().filter(|q| area.contains(*q)).map(|q| area.distance_to_edges(q));
        let slack = 0.011 * area.bounds().size().max_element();
        prop_assert!(deepest.fold(0.0, f64::max) <= area.distance_to_edges(p) + slack);
    }

    #[test]
    fn the_oriented_box_fits_tightly(polygon in polygon()) {
        let tight = polygon.oriented_box().unwrap();
        let size = polygon.bounds().size();
        prop_assert!(tight.area() <= size.x * size.y + 1e-9);
        let frame = Polygon::new(&tight.corners(), &[]).unwrap();
        close(frame.area(), tight.area(), 1e-6);
        prop_assert!(polygon.points().iter().all(|p| frame.contains(*p) || frame.distance_to_edges(*p) < 1e-6));
    }

    #[test]
    fn sound_rings_need_no_repair(polygon in polygon()) {
        let rings: Vec<Vec<DVec2>> = polygon.rings().map(<[DVec2]>::to_vec).collect();
        prop_assert_eq!(repair(&rings), (Area::from(polygon), false));
    }

    #[test]
    fn repair_makes_anything_sound(rings in prop::collection::vec(
        prop::collection::vec((-9i32..9, -9i32..9).prop_map(|(x, y)| DVec2::new(x as f64, y as f64)), 0..12), 0..4)) {
        let (area, _) = repair(&rings);
        assert_sound(&area);
        prop_assert!(area.is_empty() || area.polygons().iter().all(|p| p.contains(p.interior_point())));
    }

    #[test]
    fn relaxed_points_stay_inside_and_spread(area in area(), count in 1usize..40, seed in 0u64..99) {
        let mut random = bosquet::seed::Seed(seed).random();
        let bounds = area.bounds();
        let mut points = Vec::new();
        while points.len() < count {
            let p = bounds.min + bounds.size() * DVec2::new(random.unit(), random.unit());
            if area.contains(p) { points.push(p) }
        }
        let nearest = |ps: &[DVec2]| {
            let pairs = (0..ps.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            pairs.map(|(i, j)| ps[i].distance(ps[j])).fold(f64::INFINITY, f64::min)
        };
        let spread = relax(&points, &area, 8);
        prop_assert_eq!(spread.len(), count);
        prop_assert!(spread.iter().all(|p| area.contains(*p)));
        if count > 8 { prop_assert!(nearest(&spread) > nearest(&points)); }
    }

    #[test]
    fn nothing_panics_whatever_the_numbers(
        rings in prop::collection::vec(prop::collection::vec((wild(), wild()), 0..9), 0..3), x in wild(), y in wild()) {
        let rings: Vec<Vec<DVec2>> = rings.iter().map(|r| r.iter().copied().map(DVec2::from).collect()).collect();
        let area = repair(&rings).0;
        let trusting = rings.first().and_then(|r| Polygon::new(r, &rings[1..])).map(Area::from);
        for area in [Some(area), trusting].into_iter().flatten() {
            for p in area.polygons() {
                black_box((p.centroid(), p.interior_point(), p.is_rectangle(y), p.oriented_box(), p.hull()));
                setback(p, |i| if i % 2 == 0 { x } else { y });
            }
            black_box((inset(&area, x), offset(&area, y), buffered(&area, x), area.triangles()));
            bands(&area, DVec2::new(x, y).normalize_or_zero(), &[y, x, 5.0]);
            band(&area, DVec2::X, x, y);
            relax(&rings.concat(), &area, 2);
            let prism = Mesh::prism(&area, x, y, |p, h| p.extend(h));
            black_box((prism.cut(glam::DVec3::Z, x, y), prism.footprint(), prism.triangles()));
        }
        let all = rings.concat();
        stroke(&all, x);
        if let Some(path) = Path::new(&all) { black_box((path.at(x), path.piece(x, y), path.resampled(y.abs().max(1e-3)))); }
        PointGrid::new(&all, x).within(DVec2::new(x, y), y).count();
        BoxGrid::new(&all.windows(2).map(|w| Bounds { min: w[0], max: w[1] }).collect::<Vec<_>>())
            .touching(Bounds { min: DVec2::splat(x), max: DVec2::splat(y) }).count();
    }

    #[test]
    fn grids_find_what_a_full_search_finds(points in prop::collection::vec((-50.0..50.0f64, -5.0..5.0f64), 0..60),
            centre in (-60.0..60.0f64, -8.0..8.0f64), radius in 0.0..20.0f64) {
        let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
        let centre = DVec2::from(centre);
        let mut found: Vec<usize> = PointGrid::new(&points, 3.0).within(centre, radius).collect();
        found.sort();
        let full: Vec<usize> = (0..points.len()).filter(|i| points[*i].distance(centre) <= radius).collect();
        prop_assert_eq!(found, full);
        let boxes: Vec<Bounds> = points.iter().map(|p| Bounds { min: *p, max: *p + p.abs() * 0.4 }).collect();
        let query = Bounds { min: centre, max: centre + radius };
        let mut found: Vec<usize> = BoxGrid::new(&boxes).touching(query).collect();
        found.sort();
        let full: Vec<usize> = (0..boxes.len()).filter(|i| boxes[*i].touches(query)).collect();
        prop_assert_eq!(found, full);
    }

    #[test]
    fn strokes_are_as_wide_as_asked(points in prop::collection::vec((-30.0..30.0f64, -30.0..30.0f64), 2..7), width in 0.2..4.0f64) {
        let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
        let (area, path) = (stroke(&points, width), Path::new(&points).unwrap());
        assert_sound(&area);
        for p in samples(&area, 16) {
            let (along, foot) = path.nearest(p);
            let inner = along > 1e-6 && along < path.length() - 1e-6;
            if inner && foot.distance(p) < width * 0.5 - 1e-3 { prop_assert!(area.contains(p)); }
        }
    }
}

#[test]
fn a_bow_tie_becomes_two_triangles() {
    let tie = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from).to_vec();
    let (area, changed) = repair(&[tie]);
    assert!(changed);
    assert_eq!(area.polygons().len(), 2);
    close(area.area(), 2.0, 1e-5);
}

#[test]
fn spikes_and_strange_numbers_are_faults_but_closing_points_are_not() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from).to_vec();
    let with = |at: usize, extra: &[(f64, f64)]| {
        let mut ring = square.clone();
        ring.splice(at..at, extra.iter().copied().map(DVec2::from));
        repair(&[ring])
    };
    assert!(!with(4, &[(0.0, 0.0)]).1);
    assert!(!with(1, &[(0.0, 0.0)]).1);
    let (area, changed) = with(3, &[(9.0, 4.0)]);
    assert!(changed && (area.area() - 16.0).abs() < 1e-5);
    let (area, changed) = with(2, &[(f64::NAN, 4.0)]);
    assert!(changed && (area.area() - 16.0).abs() < 1e-5);
}

#[test]
fn a_strip_through_a_u_falls_into_two_parts() {
    let u = [(0., 0.), (3., 0.), (3., 2.), (2., 2.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from);
    let area = Area::from(Polygon::new(&u, &[]).unwrap());
    let above = band(&area, DVec2::Y, 1.0, f64::INFINITY);
    assert_eq!(above.polygons().len(), 2);
    close(above.area(), 2.0, 1e-12);
    close(band(&area, DVec2::Y, f64::NEG_INFINITY, 1.0).area(), 3.0, 1e-12);
}

#[test]
fn the_yard_of_the_textbook() {
    // 40 m by 25 m, inset by 1.5 m: 37 m by 22 m; the hole grows by as much.
    let hole = vec![(10.0, 10.0), (20.0, 10.0), (20.0, 15.0), (10.0, 15.0)].into_iter().map(DVec2::from).collect();
    let outer = [(0.0, 0.0), (40.0, 0.0), (40.0, 25.0), (0.0, 25.0)].map(DVec2::from);
    let yard = Area::from(Polygon::new(&outer, &[hole]).unwrap());
    close(inset(&yard, 1.5).area(), 37.0 * 22.0 - 13.0 * 8.0, 1e-4);
    close(offset(&yard, 1.5).area(), 43.0 * 28.0 - 7.0 * 2.0, 1e-4);
}

#[test]
fn a_front_yard_deeper_than_its_sides() {
    let lot = Polygon::rectangle(DVec2::ZERO, DVec2::new(20.0, 30.0)).unwrap();
    let depths = [6.0, 3.0, 0.0, 3.0];
    let result = setback(&lot, |i| depths[i]);
    close(result.remainder.area(), 14.0 * 24.0, 1e-9);
    assert_eq!(result.strips.iter().map(|s| s.edge).collect::<Vec<_>>(), [0, 1, 3]);
    close(result.strips[0].area.area(), (20.0 + 14.0) * 0.5 * 6.0, 1e-9);
    close(result.strips[1].area.area(), (30.0 + 24.0) * 0.5 * 3.0, 1e-9);
}

#[test]
fn edges_that_go_straight_on_end_their_strips_square() {
    let lot = [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)].map(DVec2::from);
    let result = setback(&Polygon::new(&lot, &[]).unwrap(), |i| [2.0, 4.0, 0.0, 0.0, 0.0][i]);
    close(result.strips[0].area.area(), 20.0, 1e-3);
    close(result.strips[1].area.area(), 40.0, 1e-3);
}

#[test]
fn paths_know_their_way() {
    let path = Path::new(&[(0.0, 0.0), (3.0, 0.0), (3.0, 4.0)].map(DVec2::from)).unwrap();
    assert_eq!(path.length(), 7.0);
    assert_eq!(path.at(5.0), (DVec2::new(3.0, 2.0), DVec2::Y));
    assert_eq!(path.at(99.0).0, DVec2::new(3.0, 4.0));
    assert_eq!(path.piece(2.0, 5.0).unwrap().points(), [(2.0, 0.0), (3.0, 0.0), (3.0, 2.0)].map(DVec2::from));
    assert_eq!(path.resampled(3.5).len(), 3);
    assert_eq!(path.distance_to(DVec2::new(5.0, 2.0)), 2.0);
    close(stroke(path.points(), 2.0).area(), 14.0, 1e-4);
}

#[test]
fn rectangles_are_recognized() {
    let tilted = OrientedBox { centre: DVec2::ZERO, axis: DVec2::new(0.6, 0.8), size: DVec2::new(4.0, 2.0) };
    let polygon = Polygon::new(&tilted.corners(), &[]).unwrap();
    assert!(polygon.is_rectangle(0.1));
    assert!(!Polygon::regular(DVec2::ZERO, 1.0, 5).unwrap().is_rectangle(5.0));
    let again = polygon.oriented_box().unwrap();
    close(again.size.distance(tilted.size), 0.0, 1e-9);
    close(again.axis.perp_dot(tilted.axis).abs(), 0.0, 1e-9);
}

#[test]
fn few_and_equal_points_relax() {
    let area = Area::from(Polygon::rectangle(DVec2::ZERO, DVec2::new(8.0, 4.0)).unwrap());
    let one = relax(&[DVec2::new(1.0, 1.0)], &area, 1);
    close(one[0].distance(DVec2::new(4.0, 2.0)), 0.0, 1e-9);
    let twins = relax(&[DVec2::new(1.0, 1.0); 2], &area, 60);
    close(twins[0].distance(twins[1]), 4.0, 0.3);
    assert!(relax(&[], &area, 3).is_empty());
}
