use super::read_xyz;
use crate::test_measures::{mesh_from_faces, mutate, mutations, write_to_bytes};
use crate::{Document, Format, Positions, ReadOptions, WriteOptions};
use proptest::prelude::*;

fn read(text: impl AsRef<[u8]>) -> Document {
    read_xyz(text.as_ref(), &ReadOptions::default()).expect("a table that is accepted")
}

fn message(text: &str) -> String {
    read_xyz(text.as_bytes(), &ReadOptions::default()).expect_err("a table that is refused").to_string()
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| note.text.as_str()).collect()
}

fn points(document: &Document) -> Vec<[f64; 3]> {
    document.points.positions.iter().collect()
}

/// Lengths of curves, negative if they are closed.
fn curves(document: &Document) -> Vec<i64> {
    let curves = &document.curves;
    let length = |curve: usize| i64::from(curves.offsets[curve + 1] - curves.offsets[curve]);
    (0..curves.closed.len()).map(|curve| if curves.closed[curve] { -length(curve) } else { length(curve) }).collect()
}

fn write(document: &Document, format: Format) -> (String, Vec<String>) {
    let (bytes, losses) = write_to_bytes(document, format, &WriteOptions::default()).expect("a table");
    (String::from_utf8(bytes).expect("text"), losses)
}

#[test]
fn tables_are_read_in_many_spellings() {
    let wanted = [[1.5, 2.0, -3.25], [4.0, 5e-1, 6.0], [7.0, 8.0, 9.0]];
    for text in [
        "1.5 2 -3.25\n4 5e-1 6\n7 8 9\n",
        "  1.5\t2 -3.25 \r\n4 5e-1 6\r\n7 8 9",
        "x,y,z\n1.5,2,-3.25\n4,5e-1,6\n7,8,9\n",
        "1.5, 2, -3.25,\n4, 5e-1, 6,\n7, 8, 9,\n",
        "\u{feff}X;Y;Z\n1,5;2;-3,25\n4;5e-1;6\n7;8;9\n",
        "1,5\t2\t-3,25\n4\t0,5\t6\n7\t8\t9\n",
        "1,5 2,0 -3,25\n4 0,5 6\n7 8 9\n",
        "# x y z\n1.5 2 -3.25 # first\n// note\n4 5e-1 6\n% note\n7 8 9\n",
        "z,name,x,y\n-3.25,a,1.5,2\n6,b,4,.5\n9,c,7,8\n",
        "\"x_m\",\"y_m\",\"z_m\"\n\"1.5\",\"2\",\"-3.25\"\n\"4\",\"0.5\",\"6\"\n7,8,9\n",
        "3\n1.5 2 -3.25\n4 .5 6\n7 8 9\n",
        "A title of words, and 1 number\nx y z\n1.5 2 -3.25\n4 .5 6\n7 8 9\n",
        "point,x,y,z\n0,1.5,2,-3.25\n1,4,.5,6\n2,7,8,9\n",
    ] {
        let document = read(text);
        assert_eq!(points(&document), wanted, "{text}");
        assert_eq!(curves(&document), [3], "{text}");
    }
    let utf16: Vec<u8> =
        "\u{feff}x\ty\tz\n1,5\t2\t-3,25\n4\t0,5\t6\n7\t8\t9\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
    assert_eq!(points(&read(utf16)), wanted);
}

#[test]
fn two_columns_have_a_plane() {
    assert_eq!(points(&read(" CLARK Y AIRFOIL\n1.0 0.1\n0.5 0.2\n")), [[1.0, 0.1, 0.0], [0.5, 0.2, 0.0]]);
    assert_eq!(points(&read("x,z\n1,2\n3,4\n")), [[1.0, 0.0, 2.0], [3.0, 0.0, 4.0]]);
    assert_eq!(points(&read("lat,lon\n1,2\n3,4\n")), [[2.0, 1.0, 0.0], [4.0, 3.0, 0.0]]);
}

#[test]
fn polylines_are_separated() {
    let rows = ["0 0", "1 0", "1 1", "0 0", "5 5", "6 5"];
    for separator in ["\n", "\n\n", "> -Z1\n", "nan nan\n", "\nsecond part\n"] {
        let text = format!("{}\n{separator}{}\n", rows[..4].join("\n"), rows[4..].join("\n"));
        let document = read(&text);
        assert_eq!(curves(&document), [-3, 2], "{text}");
        assert_eq!(document.points.positions.len(), 6);
    }
    for text in [
        "path,x,y\n0,0,0\n0,1,0\n0,1,1\n0,0,0\n1,5,5\n1,6,5\n",
        "country,path,x,y\nItaly,0,0,0\nItaly,0,1,0\nItaly,0,1,1\nItaly,0,0,0\nMalta,0,5,5\nMalta,0,6,5\n",
        "x,y\n0,0\n1,0\n1,1\n0,0\n,\n5,5\n6,5\n",
        "x,y\n0,0\n1,0\n1,1\n0,0\nx,y\n5,5\n6,5\n",
    ] {
        assert_eq!(curves(&read(text)), [-3, 2], "{text}");
    }
    // Blank lines everywhere are only spacing; a block of one point among others is the tip of something.
    assert_eq!(curves(&read("0 0\n\n1 1\n\n2 2\n")), [3]);
    assert_eq!(curves(&read("0 0\n1 1\n\n2 2\n")), [2, 1]);
    assert_eq!(curves(&read("\n\n0 0\n1 1\n\n\n")), [2]);
}

#[test]
fn colours_and_normals_are_recognised() {
    let document = read("0 0 0 255 0 0\n1 1 1 0 0 51\n");
    assert_eq!(document.points.colours, [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.2, 1.0]]);
    let document = read("0 0 0 0.6 0 0.8\n1 1 1 0 0 1\n");
    assert_eq!(document.points.normals, [[f64::from(0.6_f32), 0.0, f64::from(0.8_f32)], [0.0, 0.0, 1.0]]);
    assert!(document.points.colours.is_empty());
    let document = read("0 0 0 17 0 0 51\n1 1 1 18 0 0 255\n");
    assert_eq!(document.points.colours[0], [0.0, 0.0, 0.2, 1.0]);
    let document = read("0 0 0 255 0 0 0 0 1\n1 1 1 0 0 255 0 1 0\n");
    assert_eq!((document.points.colours.len(), document.points.normals[1]), (2, [0.0, 1.0, 0.0]));
    let document = read("0 0 0 5.5 7 8\n1 1 1 0 0 255\n");
    assert!(document.points.colours.is_empty() && document.points.normals.is_empty());
    assert_eq!(notes(&document), ["3 columns beside coordinates, colours and normals left out"]);
    let document = read("x,y,z,nx,ny,nz,red,green,blue,alpha\n0,0,0,0,0,2,0.5,0,0,.25\n1,1,1,0,0,1,0,0,1,1\n");
    assert_eq!(document.points.colours[0], [0.5, 0.0, 0.0, 0.25]);
    assert_eq!(document.points.normals[0], [0.0, 0.0, 2.0]);
}

#[test]
fn incomplete_rows_are_left_out() {
    let document =
        read("station,line,x_m,y_half_m,z_m\n0,0,0,,0\n0,1,.5,1,0\n0,2,1,2,0\n1,0,1,2,3\n1,1,2,3,\n1,2,4,5,6\n");
    assert_eq!(curves(&document), [2, 2]);
    assert_eq!(notes(&document), ["2 rows lack a coordinate, left out"]);
}

#[test]
fn errors_name_line_and_column() {
    assert_eq!(message("x,y\n0,0\n1,one\n"), "3: point 1: column 2: \"one\" is not a number");
    assert_eq!(message("0 0 0\n1 1\n"), "2: point 1: 2 numbers; the first row has 3");
    assert_eq!(message("nothing\nhere 7\n"), "no line has at least 2 numbers and nothing else");
    let heights = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17\n";
    assert_eq!(message(heights), "17 columns without names; name x, y and z in a first line");
    assert!(message("PK\x03\x04...").contains("ZIP"));
    assert_eq!(points(&read("")), [[0.0; 3]; 0]);
    assert_eq!(points(&read("\n \n")), [[0.0; 3]; 0]);
}

#[test]
fn tables_come_back_as_they_were() {
    let texts = [
        "0.1 2 3\n4 5 6\n\n7 8 9\n0 0 0\n1 1 1\n7 8 9\n",
        "0.1 2 3 255 0 0\n4 5 6 0 51 0\n",
        "0.1 2 3 255 0 0 0 0 1\n4 5 6 0 51 0 0 1 0\n",
        "1e-7 0.30000000000000004 nan\n1e22 inf 0\n",
    ];
    for text in texts {
        let document = read(text);
        assert_eq!(write(&document, Format::Xyz), (text.to_string(), vec![]));
        let (table, losses) = write(&document, Format::Csv);
        assert_eq!(losses, [""; 0]);
        assert_eq!(write(&read(&table), Format::Xyz).0, text, "{table}");
    }
    assert_eq!(
        write(&read(texts[0]), Format::Csv).0,
        "curve,x,y,z\n0,0.1,2,3\n0,4,5,6\n1,7,8,9\n1,0,0,0\n1,1,1,1\n1,7,8,9\n"
    );
    let mut document = read(texts[1]);
    document.points.colours[0][3] = 0.25;
    assert_eq!(write(&document, Format::Xyz).1, ["the opacity of points, which XYZ files do not hold"]);
    assert_eq!(read(write(&document, Format::Csv).0).points.colours[0], [1.0, 0.0, 0.0, 0.25]);
}

#[test]
fn other_content_is_lost_or_refused() {
    let mut document = Document::from_mesh(mesh_from_faces(&[[0.0; 3]; 3], &[&[0, 1, 2]]));
    assert!(write_to_bytes(&document, Format::Csv, &WriteOptions::default()).is_err());
    document.curves = read("0 0\n1 1\n").curves;
    document.points.positions = Positions::F32(vec![[0.1, 0.2, 0.3]]);
    let losses = ["meshes, which CSV files do not hold", "points beside curves, which CSV files do not hold"];
    assert_eq!(write(&document, Format::Csv), ("x,y,z\n0,0,0\n1,1,0\n".into(), losses.map(String::from).to_vec()));
    document.curves = crate::Curves::default();
    assert_eq!(write(&document, Format::Csv).0, "x,y,z\n0.1,0.2,0.3\n");
}

proptest! {
    #[test]
    fn mutations_never_panic(kind in 0..3_usize, changes in mutations()) {
        let mut bytes = [
            &b"name;path;x;y;z;red;green;blue;alpha\na;0;1,5;2;3;0;0;255;1\na;0;4;5;6;1;1;1;1\nb;1;4;5;6;1;1;1;1\n"[..],
            b"3\n0 0 0 1 255 0 0 0 0 1\n\n1 1 1 1 0 0 255 0 1 0\n>\n1 2 3 4 5 6 7 8 9 10\n",
            b"# x,y\n1,2\n3,4\n,\n\"5\",6\nnan,nan\n1,2\n",
        ][kind].to_vec();
        mutate(&mut bytes, &changes);
        if let Ok(document) = read_xyz(&bytes, &ReadOptions::default()) {
            let count = document.points.positions.len();
            prop_assert!([0, count].contains(&document.points.colours.len()));
            prop_assert!([0, count].contains(&document.points.normals.len()));
            prop_assert_eq!(document.curves.offsets.last().copied(), Some(document.curves.positions.len() as u32));
            prop_assert_eq!(document.curves.offsets.len(), document.curves.closed.len() + 1);
            prop_assert!(document.curves.offsets.is_sorted());
        }
    }
}
