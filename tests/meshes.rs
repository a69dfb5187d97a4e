//! What users of meshes rely on: solids are closed, cuts lose nothing, outlines are right.

#[path = "common/polygons.rs"]
mod polygons;

use bosquet::geometry::*;
use glam::{DAffine3, DVec2, DVec3};
use polygons::{area, convex, polygon};
use proptest::prelude::*;

fn ground(p: DVec2, height: f64) -> DVec3 {
    DVec3::new(p.x, height, -p.y)
}

#[track_caller]
fn close(a: f64, b: f64, slack: f64) {
    assert!((a - b).abs() <= slack, "{a} is not {b}");
}

#[track_caller]
fn assert_solid(mesh: &Mesh) {
    mesh.sanity_check().unwrap();
    assert!(mesh.is_closed(), "open: {mesh:?}");
    assert!(mesh.volume() > 0.0);
}

/// A direction in space, often along an axis.
fn direction() -> impl Strategy<Value = DVec3> {
    let any = (-1.0..1.0f64, -1.0..1.0f64, 0.1..1.0f64).prop_map(|v| DVec3::from(v).normalize());
    prop_oneof![Just(DVec3::X), Just(DVec3::Y), Just(DVec3::NEG_Z), any]
}

proptest! {
    #[test]
    fn prisms_are_solid(area in area(), base in -5.0..5.0f64, top in -5.0..5.0f64) {
        let prism = Mesh::prism(&area, base, top, ground);
        assert_solid(&prism);
        close(prism.volume(), area.area() * (top - base).abs(), 1e-5);
        let sides = area.perimeter() * (top - base).abs();
        close(prism.area(), 2.0 * area.area() + sides, 1e-5);
        close(prism.footprint().area(), area.area(), 1e-4 + 1e-5 * area.perimeter());
        let euler = |holes: usize| 2 - 2 * holes as i64;
        let (v, e, f) = (prism.positions.len(), prism.edges().len(), prism.face_count());
        // Faces with holes are no disks: each hole of a face takes one off.
        let holes = area.polygons()[0].holes().count();
        prop_assert_eq!(v as i64 - e as i64 + f as i64 - 2 * holes as i64, euler(holes));
    }

    #[test]
    fn cuts_lose_no_volume(polygon in polygon(), normal in direction(), parts in 1usize..6) {
        let prism = Mesh::prism(&polygon.into(), 0.0, 6.0, ground);
        let along = prism.positions.iter().map(|p| p.dot(normal));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s), h.max(s)));
        let cuts: Vec<f64> = (0..=parts).map(|i| low + (high - low) * i as f64 / parts as f64).collect();
        let all = prism.bands(normal, &cuts);
        close(all.iter().map(Mesh::volume).sum(), prism.volume(), 1e-5);
        for (part, cut) in all.iter().zip(cuts.windows(2)) {
            assert_solid(part);
            close(part.volume(), prism.cut(normal, cut[0], cut[1]).volume(), 1e-5);
            prop_assert!(part.positions.iter().all(|p| (cut[0] - 1e-6..=cut[1] + 1e-6).contains(&p.dot(normal))));
        }
    }

    #[test]
    fn cuts_of_cuts_stay_solid(polygon in polygon(), a in direction(), b in direction()) {
        let prism = Mesh::prism(&polygon.into(), -3.0, 3.0, ground);
        let half = prism.cut(a, 0.0, f64::INFINITY);
        if !half.faces.is_empty() {
            assert_solid(&half);
            let halves = half.bands(b, &[f64::NEG_INFINITY, 0.1, f64::INFINITY]);
            close(halves.iter().map(Mesh::volume).sum(), half.volume(), 1e-5);
            halves.iter().filter(|h| !h.faces.is_empty()).for_each(assert_solid);
        }
    }

    #[test]
    fn lattices_cut_along_their_lines_stay_solid(rings in prop::collection::vec(
        prop::collection::vec((-6i32..6, -6i32..6).prop_map(|(x, y)| DVec2::new(x as f64, y as f64)), 3..14), 1..4)) {
        let area = repair(&rings).0;
        let prism = Mesh::prism(&area, 0.0, 2.0, ground);
        let parts = prism.bands(DVec3::X, &(-6..=6).map(f64::from).collect::<Vec<_>>());
        close(parts.iter().map(Mesh::volume).sum(), prism.volume(), 1e-3);
        for part in parts.iter().filter(|p| !p.faces.is_empty()) {
            part.sanity_check().unwrap();
            prop_assert!(part.is_closed());
        }
    }

    #[test]
    fn triangles_have_the_area_of_their_faces(polygon in polygon()) {
        let prism = Mesh::prism(&polygon.into(), 0.0, 2.0, ground);
        let triangles = prism.triangulated();
        triangles.sanity_check().unwrap();
        close(triangles.area(), prism.area(), 1e-6);
        close(triangles.volume(), prism.volume(), 1e-5);
    }

    #[test]
    fn mirrored_meshes_still_look_outwards(polygon in convex()) {
        let prism = Mesh::prism(&polygon.into(), 0.0, 2.0, ground);
        let mirrored = prism.transformed(&DAffine3::from_scale(DVec3::new(-1.0, 2.0, 1.0)));
        assert_solid(&mirrored);
        close(mirrored.volume(), prism.volume() * 2.0, 1e-6);
    }
}

#[test]
fn the_simple_solids_fill_their_box() {
    let size = DVec3::new(2.0, 3.0, 4.0);
    let volume = size.element_product();
    let pi = std::f64::consts::PI;
    let solids = [
        (Mesh::cuboid(size), 1.0, 1e-9),
        (Mesh::cylinder(size, 256), pi / 4.0, 1e-3),
        (Mesh::cone(size, 256), pi / 12.0, 1e-3),
        (Mesh::sphere(size, 256, 128), pi / 6.0, 1e-3),
    ];
    for (solid, share, slack) in solids {
        assert_solid(&solid);
        close(solid.volume() / volume, share, slack);
        let (low, high) = solid.bounds().unwrap();
        assert!(low.distance(DVec3::ZERO) < 1e-9 && high.distance(size) < 1e-9, "{low} {high}");
    }
    assert_eq!(Mesh::cuboid(DVec3::ZERO), Mesh::default());
}

#[test]
fn flat_figures_face_up() {
    let quad = Mesh::quad(DVec2::new(2.0, 3.0));
    assert_eq!(quad.face(0).normal(), DVec3::Y);
    close(quad.area(), 6.0, 1e-12);
    close(quad.footprint().area(), 6.0, 1e-5);
    assert_eq!(Mesh::disk(DVec2::ONE, 12).face(0).normal(), DVec3::Y);
    assert!(!quad.is_closed());
}

#[test]
fn a_cut_through_faces_of_an_l_keeps_it_solid() {
    let l = [(0., 0.), (4., 0.), (4., 2.), (2., 2.), (2., 4.), (0., 4.)].map(DVec2::from);
    let prism = Mesh::prism(&Polygon::new(&l, &[]).unwrap().into(), 0.0, 1.0, ground);
    // The plane x = 2 holds one of its walls.
    let parts = prism.bands(DVec3::X, &[0.0, 2.0, 4.0]);
    parts.iter().for_each(assert_solid);
    assert_eq!([8.0, 4.0], [parts[0].volume(), parts[1].volume()]);
    // The plane that holds its top leaves nothing above.
    assert_eq!(prism.cut(DVec3::Y, 1.0, 9.0), Mesh::default());
    assert_eq!(prism.cut(DVec3::Y, 0.0, 1.0), prism);
}

#[test]
fn a_frame_cut_in_two_has_two_caps_a_part() {
    let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)].map(DVec2::from).to_vec();
    let frame = Polygon::new(&square(2.0), &[square(1.0)]).unwrap();
    let prism = Mesh::prism(&frame.into(), 0.0, 1.0, ground);
    let half = prism.cut(DVec3::X, 0.0, 9.0);
    assert_solid(&half);
    let caps = half.faces().filter(|f| f.normal().distance(DVec3::NEG_X) < 1e-9 && f.first().x == 0.0);
    assert_eq!(caps.count(), 2);
    // A level cut leaves one cap with a hole.
    let slice = prism.cut(DVec3::Y, 0.25, 0.75);
    assert_solid(&slice);
    assert_eq!(slice.faces().filter(|f| f.rings().len() == 2).count(), 2);
}

#[test]
fn open_meshes_stay_open() {
    let quad = Mesh::quad(DVec2::new(4.0, 4.0));
    let part = quad.cut(DVec3::X, 1.0, 3.0);
    part.sanity_check().unwrap();
    assert_eq!(part.face_count(), 1);
    close(part.area(), 8.0, 1e-12);
}

#[test]
fn unsound_meshes_say_so() {
    let mut mesh = Mesh::quad(DVec2::ONE);
    mesh.positions[0].y = 0.5;
    assert!(mesh.sanity_check().unwrap_err().contains("out of its plane"));
    mesh.corners[0] = 9;
    assert_eq!(mesh.sanity_check(), Err("corner names vertex 9 of 4".into()));
}
