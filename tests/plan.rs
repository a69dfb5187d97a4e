//! Plans: true to scale, well-formed, the same every time, and never a panic.

#[path = "common/sample_scene.rs"]
mod sample_scene;

use bosquet::export::plan::{PlanOptions, Resolution, draw, png, svg};
use bosquet::geometry::Bounds;
use glam::DVec2;

/// Writes pictures for people to look at: `PLAN_GALLERY=folder cargo test --test plan -- --ignored`.
#[test]
#[ignore = "for the eye"]
fn gallery() {
    let folder = std::env::var("PLAN_GALLERY").expect("a folder in PLAN_GALLERY");
    let scene = sample_scene::formal_garden();
    let part =
        |x: f64, y: f64, width: f64, depth: f64| Some(Bounds::of([DVec2::new(x, y), DVec2::new(x + width, y + depth)]));
    let whole = PlanOptions { subtitle: Some("Planting plan".into()), ..PlanOptions::default() };
    let views = [
        ("whole", whole.clone()),
        ("park", PlanOptions { scale: Some(5000.0), ..whole.clone() }),
        ("part", PlanOptions { scale: Some(1000.0), rotation: 12.0, ..whole.clone() }),
        (
            "detail",
            PlanOptions { scale: Some(250.0), codes: true, extent: part(-40.0, -60.0, 75.0, 60.0), ..whole.clone() },
        ),
        ("parterre", PlanOptions { scale: Some(250.0), extent: part(45.0, -10.0, 100.0, 70.0), ..whole.clone() }),
        ("garden", PlanOptions { scale: Some(100.0), codes: true, extent: part(-40.0, -60.0, 30.0, 24.0), ..whole }),
    ];
    for (name, options) in views {
        let start = std::time::Instant::now();
        let drawing = draw(&scene, &options);
        let text = svg(&drawing);
        let drawn = start.elapsed();
        let bytes = png(&drawing, Resolution::Drawn).expect("a picture");
        println!(
            "{name}: svg {} kB in {drawn:?}, png {} kB in {:?}",
            text.len() / 1024,
            bytes.len() / 1024,
            start.elapsed()
        );
        std::fs::write(format!("{folder}/{name}.svg"), text).expect("written");
        std::fs::write(format!("{folder}/{name}.png"), bytes).expect("written");
    }
}
