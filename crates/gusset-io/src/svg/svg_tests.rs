use super::read_svg;
use crate::test_measures::{mutate, mutations, polygon_area, write_to_bytes};
use crate::{Document, Format, Positions, ReadOptions, WriteOptions};
use proptest::prelude::*;
use std::f64::consts::PI;

fn read(text: impl AsRef<[u8]>) -> Document {
    read_svg(text.as_ref(), &ReadOptions::default()).expect("a drawing that is accepted")
}

fn drawing(content: &str) -> Document {
    read(format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>{content}</svg>"))
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| note.text.as_str()).collect()
}

/// Points of a curve in the coordinates of SVG, and whether it is closed.
fn outline(document: &Document, curve: usize) -> (Vec<[f64; 2]>, bool) {
    let curves = &document.curves;
    let range = curves.offsets[curve] as usize..curves.offsets[curve + 1] as usize;
    let points = range.map(|point| curves.positions.get(point)).map(|[x, y, _]| [x, 0.0 - y]).collect();
    (points, curves.closed[curve])
}

fn only(content: &str) -> (Vec<[f64; 2]>, bool) {
    let document = drawing(content);
    assert_eq!(document.curves.closed.len(), 1, "{content}");
    outline(&document, 0)
}

#[test]
fn straight_shapes_are_exact() {
    let square = vec![[1.0, 2.0], [4.0, 2.0], [4.0, 6.0], [1.0, 6.0]];
    for content in [
        "<path d='M1 2L4 2L4 6L1 6Z'/>",
        "<path d='m1,2h3v4h-3z'/>",
        "<path d='M1 2 4 2 4 6 1 6 1 2'/>",
        "<path d='M 1e0 2 H 4 V 6 H 1 V 2 Z'/>",
        "<path d='m1 2 3 0 0 4-3 0z'/>",
        "<polygon points='1,2 4,2 4,6 1,6'/>",
        "<polyline points='1 2 4 2 4 6 1 6 1 2'/>",
        "<rect x='1' y='2' width='3' height='4'/>",
        "<rect x='1' y='2%' width='3%' height='4'/>",
        "<g transform='translate(1 2)'><rect width='3' height='4'/></g>",
        "<rect transform='translate(1,2)scale(3 4)' width='1' height='1'/>",
        "<rect transform='matrix(3 0 0 4 1 2)' width='1' height='1'/>",
        "<defs><rect id='a' width='3' height='4'/></defs><use href='#a' x='1' y='2'/>",
        "<svg x='1' y='2' width='3' height='4' viewBox='5 5 6 8'><rect x='5' y='5' width='6' height='8'/></svg>",
        "<symbol id='a'><rect width='3' height='4'/></symbol><use xlink:href='#a' transform='translate(1 2)'/>",
        "<rect id='a' display='none'/><g style='fill:red; display : none'><path d='M0 0h1'/></g><rect x='1' y='2' width='3' height='4'/>",
    ] {
        assert_eq!(only(content), (square.clone(), true), "{content}");
    }
    assert_eq!(only("<line x1='1' y1='2' x2='3'/>"), (vec![[1.0, 2.0], [3.0, 0.0]], false));
    assert_eq!(only("<path d='M1-2.5.5.25'/>").0, [[1.0, -2.5], [0.5, 0.25]]);
    assert_eq!(only("<line x2='1in' y2='25.4mm'/>").0, [[0.0, 0.0], [96.0, 96.0]]);
    assert_eq!(only("<line transform='rotate(90 1 1)' x2='2'/>").0, [[2.0, 0.0], [2.0, 2.0]]);
    let document = drawing("<path d='M0 0h1v1zM5 5h1z l0 9'/>");
    assert_eq!(document.curves.closed, [true, false, false]);
    assert_eq!(outline(&document, 2).0, [[5.0, 5.0], [5.0, 14.0]]);
}

#[test]
fn curves_keep_their_area() {
    let ellipse = 6.0 * PI;
    for (content, wanted) in [
        ("<circle cx='5' cy='5' r='2'/>", 4.0 * PI),
        ("<ellipse cx='5' cy='5' rx='3' ry='2'/>", ellipse),
        ("<path d='M2 5a3 2 0 1 0 6 0a3 2 0 10-6 0z'/>", ellipse),
        ("<path d='M8 5A3,2,0,0,1,2,5 3 2 0 01 8 5'/>", ellipse),
        ("<path transform='rotate(30) skewX(20)' d='M8 5A3 2 40 1 1 7 6'/>", f64::NAN),
        ("<circle transform='matrix(3 1 0 2 7 7)' r='1'/>", ellipse),
        ("<rect width='10' height='8' rx='2'/>", 80.0 - (16.0 - 4.0 * PI)),
        ("<rect width='10' height='8' rx='9' ry='9'/>", 20.0 * PI),
        // Radii that are too small are enlarged.
        ("<path d='M0 0A1 1 0 0 0 6 0Z'/>", 4.5 * PI),
        // Under a parabola: two thirds of the box; under the cubic: 3/4 of a box of height 1 x 4.
        ("<path d='M0 0Q3 4 6 0Z'/>", 8.0),
        ("<path d='M0 0q3 4 6 0t6 0Z'/>", 0.0),
        ("<path d='M0 0C0 4 6 4 6 0Z'/>", 14.4),
        ("<path d='M0 0c0 4 6 4 6 0s6-4 6 0Z'/>", 0.0),
    ] {
        let (points, is_closed) = only(content);
        let area = polygon_area(&points).abs();
        let tolerance = 1e-4 * (1.0 + wanted.abs());
        assert!(wanted.is_nan() || (is_closed && (area - wanted).abs() < tolerance), "{content}: {area} {wanted}");
        assert!(points.len() < 2000, "{}", points.len());
    }
}

#[test]
fn y_points_up_and_units_are_read() {
    let document = read("<svg width='210mm' height='297mm' viewBox='0 0 2100 2970'><path d='M0 10h5'/></svg>");
    assert_eq!(document.curves.positions, Positions::F64(vec![[0.0, -10.0, 0.0], [5.0, -10.0, 0.0]]));
    assert!((document.metres_per_unit.expect("a unit") - 1e-4).abs() < 1e-12);
    assert_eq!(read("<svg width='2in'><path d='M0 0h5'/></svg>").metres_per_unit, Some(0.0254 / 96.0));
    assert_eq!(read("<svg width='200' viewBox='0 0 100 100'/>").metres_per_unit, None);
}

#[test]
fn what_is_left_out_is_noted() {
    let document = drawing(
        "<!-- none --><text>a</text><image/><path d='M0 0h1v1hx'/><use href='#none'/><clipPath><path d='M0 0h1'/></clipPath>\
         <style>path { fill: none }</style><path transform='turn(3)' d='M0 0h1'/><path d='h1'/>",
    );
    assert_eq!(document.curves.closed, [false, false]);
    assert_eq!(
        notes(&document),
        [
            "1 text left out",
            "1 image left out",
            "3 shapes with malformed numbers, read up to the mistake",
            "1 use of elements that the file lacks or that hold the use, left out"
        ]
    );
    for (text, wanted) in [
        ("", "1: the file has no svg element"),
        ("<html></html>", "this is a web page, not the file that it offers; download the file itself"),
        ("<svg>\n<path d='", "2: the XML is malformed"),
    ] {
        let error = read_svg(text.as_bytes(), &ReadOptions::default()).expect_err("not a drawing").to_string();
        assert!(error.starts_with(wanted), "{error}");
    }
}

#[test]
fn hostile_drawings_cost_little() {
    let start = std::time::Instant::now();
    let many = |what: &str, count: usize| what.repeat(count);
    drawing(&many("<g>", 300_000));
    drawing("<g id='a'><use href='#a'/><use href='#a'/></g>");
    let mut bomb = String::from("<defs><path id='a0' d='M0 0h1'/>");
    for level in 1..15 {
        bomb += &format!("<g id='a{level}'>{}</g>", many(&format!("<use href='#a{}'/>", level - 1), 10));
    }
    let bomb = format!("<svg>{bomb}</defs><use href='#a14'/></svg>");
    let error = read_svg(bomb.as_bytes(), &ReadOptions::default()).expect_err("too many elements").to_string();
    assert!(error.contains("16 times"), "{error}");
    // Circles whose fine polylines would exceed the limit of memory.
    let document = drawing(&many("<circle r='1e9'/>", 20_000));
    assert_eq!(document.curves.closed.len(), 20_000);
    assert!(notes(&document)[0].starts_with("curves are drawn within"), "{:?}", notes(&document));
    drawing(&format!("<path d='M0 0{}'/>", many("h1", 300_000)));
    drawing(
        "<circle r='1e308'/><path d='M1e308 1e308A1e308 1e308 0 1 1 -1e308 5c1e308 1e308 nan 3 5 5'/><path d='M1e999 0q1 1 2 2'/>",
    );
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}

#[test]
fn drawings_come_back_as_they_were() {
    let mut document = drawing("<path d='M0.1 0.2h3v5z'/><path d='M7 7L8.123456789012345 9'/>");
    document.metres_per_unit = Some(0.5e-3);
    let (bytes, losses) = write_to_bytes(&document, Format::Svg, &WriteOptions::default()).expect("a drawing");
    assert_eq!(losses, [""; 0]);
    let back = read(&bytes);
    assert_eq!(back.curves, document.curves);
    assert!((back.metres_per_unit.expect("a unit") - 0.5e-3).abs() < 1e-15);
    let points = document.curves.positions.iter().map(|[x, y, _]| [x, y, 1.0]).collect();
    document.curves.positions = Positions::F64(points);
    document.points.positions = Positions::F64(vec![[0.0; 3]]);
    let (_, losses) = write_to_bytes(&document, Format::Svg, &WriteOptions::default()).expect("a drawing");
    assert_eq!(losses, ["points, which SVG files do not hold", "z coordinates, which SVG files do not hold"]);
    document.curves = crate::Curves::default();
    assert!(write_to_bytes(&document, Format::Svg, &WriteOptions::default()).is_err());
}

proptest! {
    #[test]
    fn mutations_never_panic(changes in mutations()) {
        let mut bytes = b"<svg width='9mm' viewBox='0 0 9 9'><g transform='rotate(3 1 2)'>\
            <path id='a' d='M0 0c1 2 3 4 5 6A1 2 3 01 4 5q1 2 3 4z'/>\
            <rect width='5' height='4' rx='1'/><use href='#a' x='1'/><circle r='3'/><polygon points='1,2 3,4 5,6'/></g></svg>".to_vec();
        mutate(&mut bytes, &changes);
        if let Ok(document) = read_svg(&bytes, &ReadOptions::default()) {
            prop_assert_eq!(document.curves.offsets.last().copied(), Some(document.curves.positions.len() as u32));
            prop_assert_eq!(document.curves.offsets.len(), document.curves.closed.len() + 1);
            prop_assert!(document.curves.offsets.is_sorted());
        }
    }
}
