//! Passes a smooth closed curve through points, and writes it as an SVG path.

use gusset::curve::{Options, Outlines, PointStatus, Points, fit};
use gusset::{Job, Result};

fn main() -> Result<()> {
    // ! [outline]
    let points: Vec<[f64; 2]> = (0..12)
        .map(|k| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 12.0).sin_cos();
            [60.0 * cos, 40.0 * sin]
        })
        .collect();
    let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed: true, constraints: &[] };
    let job = Job::default();
    let fitted = fit(&outlines, &Options::default(), &job)?;
    // ! [outline]

    // ! [path]
    // Each point has a status; the curve passes all that are not `Missed`.
    assert!(fitted.statuses().iter().all(|status| *status == PointStatus::Ok));
    let path = fitted.curve(0).to_svg_path(&job)?;
    println!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-70 -50 140 100"><path d="{path}"/></svg>"#);
    // ! [path]
    assert!(path.starts_with('M') && path.ends_with('Z'), "{path}");
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
