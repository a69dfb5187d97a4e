//! The medial axis: in the middle, connected, a loop for each hole, and where it is known, as it is known.

use bosquet::geometry::{Area, Branch, MedialAxis, Polygon, Pruning, difference};
use bosquet::seed::{Random, Seed};
use glam::DVec2;

/// No branch pruned, every corner reached.
const WHOLE: Pruning = Pruning { branch: 0.0, corner: 180.0 };

fn ring(centre: DVec2, count: usize, random: &mut Random, [low, high]: [f64; 2]) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / count as f64;
    (0..count).map(|i| centre + DVec2::from_angle(step * i as f64) * random.uniform(low, high)).collect()
}

/// A star with star-shaped holes at places that keep clear of each other.
fn star(random: &mut Random) -> Area {
    let size = random.uniform(20.0, 200.0);
    let count = 8 + random.below(40) as usize;
    let outer = ring(DVec2::ZERO, count, random, [0.5 * size, size]);
    let places = random.below(4) as usize;
    let holes: Vec<_> = (0..places)
        .map(|i| {
            let centre = DVec2::from_angle(i as f64 * 1.6) * size * 0.25;
            ring(centre, 5 + i, random, [0.03 * size, 0.08 * size])
        })
        .collect();
    Polygon::new(&outer, &holes).expect("a star").into()
}

/// A lot minus a house and its garage, turned.
fn lot(random: &mut Random) -> Area {
    let size = DVec2::new(random.uniform(15.0, 60.0), random.uniform(15.0, 60.0));
    let house = random.uniform(0.1, 0.3) * size;
    let corner = house + DVec2::new(random.uniform(0.2, 0.4), random.uniform(0.2, 0.4)) * size;
    let part = |a, b| Area::from(Polygon::rectangle(a, b).expect("an extent"));
    let drive = part(DVec2::new(house.x * 0.5, -1.0), house + 0.1);
    let built = part(house, corner);
    let rest = difference(&difference(&part(DVec2::ZERO, size), &built), &drive);
    rest.transformed(&glam::DAffine2::from_angle(random.uniform(0.0, 3.0)))
}

/// A strip along a curve with round holes.
fn strip(random: &mut Random) -> Area {
    let (bend, width) = (random.uniform(20.0, 80.0), random.uniform(2.0, 8.0));
    let at = |i: usize, r: f64| DVec2::from_angle(i as f64 * 0.05) * (bend + r) + DVec2::X * (i % 3) as f64 * 0.01;
    let mut outer: Vec<_> = (0..40).map(|i| at(i, width)).collect();
    outer.extend((0..40).rev().map(|i| at(i, -width)));
    let holes: Vec<_> = (0..random.below(3) as usize)
        .map(|i| Polygon::regular(at(8 + 10 * i, 0.0), 0.4 * width, 12).expect("a disk").outer().to_vec())
        .collect();
    Polygon::new(&outer, &holes).expect("a strip").into()
}

/// A triangle as thin as a hair's breadth to a hand's.
fn sliver(random: &mut Random) -> Area {
    let tip = DVec2::new(random.uniform(10.0, 80.0), random.uniform(-5.0, 5.0));
    let thin = random.uniform(0.001, 0.1);
    Polygon::new(&[DVec2::ZERO, tip, tip * 0.5 + DVec2::Y * thin], &[]).into_iter().collect()
}

/// The same with its vertices on half metres: what comes from drawings.
fn snapped(area: &Area) -> Area {
    area.polygons()
        .iter()
        .flat_map(|p| {
            let rings: Vec<Vec<DVec2>> =
                p.rings().map(|r| r.iter().map(|q| (*q * 2.0).round() * 0.5).collect()).collect();
            bosquet::geometry::repair(&rings).0.polygons().to_vec()
        })
        .collect()
}

/// The number of independent loops, and whether each part's axis is in one piece.
fn form(axis: &MedialAxis) -> (usize, bool) {
    let mut names: Vec<u32> = axis.branches().iter().flat_map(|b| b.nodes).collect();
    names.sort_unstable();
    names.dedup();
    let mut root: Vec<usize> = (0..names.len()).collect();
    let mut pieces = names.len();
    let mut parts: Vec<u32> = axis.branches().iter().map(|b| b.part).collect();
    parts.sort_unstable();
    parts.dedup();
    for branch in axis.branches() {
        let [a, b] = branch.nodes.map(|n| root[names.binary_search(&n).expect("a node")]);
        pieces -= usize::from(a != b);
        root.iter_mut().filter(|r| **r == a).for_each(|r| *r = b);
    }
    let edges = axis.branches().iter().filter(|b| b.points.len() > 1).count();
    (edges + pieces - names.len(), pieces == parts.len())
}

/// Everything that holds of every axis.
fn sound(area: &Area, axis: &MedialAxis, exact: bool) -> Result<(), String> {
    for branch in axis.branches() {
        let part = &area.polygons()[branch.part as usize];
        for (point, clearance) in branch.points.iter().zip(&branch.clearances) {
            let distance = part.distance_to_edges(*point);
            if !(part.contains(*point) || distance < 0.002) || (distance - clearance).abs() > 0.002 {
                return Err(format!("{point}: {clearance} m, and the rim is {distance} m away"));
            }
        }
    }
    let holes: usize = area.polygons().iter().map(|p| p.holes().count()).sum();
    let (loops, connected) = form(axis);
    if !connected || (exact && loops != holes) {
        return Err(format!("{loops} loops around {holes} holes, in one piece: {connected}"));
    }
    Ok(())
}

#[test]
fn every_axis_is_inside_connected_and_as_far_from_the_rim_as_it_says() {
    let makers: [fn(&mut Random) -> Area; 4] = [star, lot, strip, sliver];
    for index in 0..1200 {
        let area = makers[index % 4](&mut Seed(7).child(index as u64).random());
        for pruning in [WHOLE, Pruning::default()] {
            let axis = MedialAxis::new(&area, pruning);
            if let Err(what) = sound(&area, &axis, index % 4 != 3) {
                panic!("polygon {index}, {pruning:?}: {what}\n{area:?}");
            }
            let parts = area.polygons().iter().filter(|p| p.area() > 0.1 * p.perimeter()).count();
            assert!(axis.branches().len() >= parts, "{index}: every part has an axis");
        }
    }
}

#[test]
fn outlines_on_half_metres_have_their_axes() {
    let makers: [fn(&mut Random) -> Area; 3] = [star, lot, strip];
    for index in 0..600 {
        let area = snapped(&makers[index % 3](&mut Seed(8).child(index as u64).random()));
        let axis = MedialAxis::new(&area, Pruning::default());
        // Rounding makes holes touch the rim, so that they are no longer gone round.
        if let Err(what) = sound(&area, &axis, false) {
            panic!("polygon {index}: {what}\n{area:?}");
        }
    }
}

fn rectangle(w: f64, h: f64) -> Polygon {
    Polygon::rectangle(DVec2::ZERO, DVec2::new(w, h)).expect("an extent")
}

fn only(axis: &MedialAxis) -> &Branch {
    assert_eq!(axis.branches().len(), 1, "{axis:?}");
    &axis.branches()[0]
}

fn near(a: DVec2, b: DVec2) -> bool {
    a.distance(b) < 0.002
}

#[test]
fn a_rectangle_has_its_middle_line() {
    let axis = MedialAxis::new(&rectangle(20.0, 6.0).into(), Pruning::default());
    let branch = only(&axis);
    let mut ends = [branch.points[0], branch.points[branch.points.len() - 1]];
    ends.sort_by(|a, b| a.x.total_cmp(&b.x));
    assert!(near(ends[0], DVec2::new(3.0, 3.0)) && near(ends[1], DVec2::new(17.0, 3.0)), "{branch:?}");
    // With its four diagonals, each 3 √2 long.
    let whole = MedialAxis::new(&rectangle(20.0, 6.0).into(), WHOLE);
    assert_eq!(whole.branches().len(), 5);
    assert!((whole.length() - (14.0 + 4.0 * 3.0 * 2f64.sqrt())).abs() < 0.005, "{}", whole.length());
}

#[test]
fn rounded_corners_end_no_branch() {
    let rounded = bosquet::geometry::buffered(&rectangle(20.0, 2.0).into(), 2.0);
    let branch = only(&MedialAxis::new(&rounded, Pruning::default())).clone();
    assert!((18.0..=20.5).contains(&branch.length()), "{}", branch.length());
    assert!(branch.points.iter().all(|p| (p.y - 1.0).abs() < 0.02), "{branch:?}");
}

#[test]
fn the_legs_of_an_l_meet() {
    let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 4.0), (4.0, 4.0), (4.0, 20.0), (0.0, 20.0)];
    let points: Vec<DVec2> = corners.map(DVec2::from).to_vec();
    let axis = MedialAxis::new(&Polygon::new(&points, &[]).expect("an L").into(), Pruning::default());
    let branch = only(&axis);
    let path = bosquet::geometry::Path::new(&branch.points).expect("a line");
    assert!(path.distance_to(DVec2::new(18.0, 2.0)) < 0.002 && path.distance_to(DVec2::new(2.0, 18.0)) < 0.002);
    // Where the two parabolas meet, on the diagonal: as far from the inner corner as from both walls.
    let bend = 4.0 * (2.0 - 2f64.sqrt());
    assert!(path.distance_to(DVec2::splat(bend)) < 0.003, "{branch:?}");
}

#[test]
fn a_triangle_has_its_incentre_and_a_gore_its_middle() {
    // Legs 3 and 4: the inscribed circle has radius 1.
    let triangle = Polygon::new(&[DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(0.0, 3.0)], &[]).expect("a triangle");
    let axis = MedialAxis::new(&triangle.into(), Pruning::default());
    assert!(only(&axis).points.len() == 1 && near(only(&axis).points[0], DVec2::ONE), "{axis:?}");
    assert!((only(&axis).clearances[0] - 1.0).abs() < 0.002);
    let gore = [DVec2::new(0.0, -2.0), DVec2::new(60.0, 0.0), DVec2::new(0.0, 2.0)];
    let axis = MedialAxis::new(&Polygon::new(&gore, &[]).expect("a gore").into(), Pruning::default());
    assert!(only(&axis).length() > 57.0 && only(&axis).points.iter().all(|p| p.y.abs() < 0.002), "{axis:?}");
}

#[test]
fn a_ring_has_a_loop() {
    let disk = |radius| Polygon::regular(DVec2::new(5e5, 4e6), radius, 64).expect("a disk");
    let ring = Polygon::new(disk(12.0).outer(), &[disk(8.0).outer().to_vec()]).expect("a ring");
    let axis = MedialAxis::new(&ring.into(), Pruning::default());
    let branch = only(&axis);
    assert!(branch.is_closed() && branch.points[0] == branch.points[branch.points.len() - 1]);
    assert!((branch.length() / (10.0 * std::f64::consts::TAU) - 1.0).abs() < 0.005, "{}", branch.length());
}

#[test]
fn nothing_panics_whatever_the_outline() {
    assert_eq!(MedialAxis::new(&Area::empty(), WHOLE), MedialAxis::default());
    let mut random = Seed(5).random();
    for size in [1e-5, 1e-3, 1.0, 1e6, 1e12, 1e150, 1e300] {
        for count in [3, 5, 9, 30] {
            // Rings that cross themselves as they like.
            let mut point = || DVec2::new(random.uniform(-size, size), random.uniform(-size, size));
            let rings: Vec<Vec<DVec2>> = (0..3).map(|_| (0..count).map(|_| point()).collect()).collect();
            for pruning in [WHOLE, Pruning { branch: f64::NAN, corner: f64::NAN }] {
                if let Some(polygon) = Polygon::new(&rings[0], &rings[1..]) {
                    MedialAxis::new(&polygon.into(), pruning);
                }
            }
        }
    }
}
