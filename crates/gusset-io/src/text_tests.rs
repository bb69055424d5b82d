//! Words and numbers in text.

use crate::text::{Scanner, TextWriter, integer, number};
use proptest::prelude::*;

fn written(write: impl Fn(&mut TextWriter<'_>) -> std::io::Result<()>) -> String {
    let mut bytes = Vec::new();
    let mut writer = TextWriter::new(&mut bytes).unwrap();
    write(&mut writer).expect("memory is written");
    writer.finish().expect("memory is written");
    String::from_utf8(bytes).expect("it is text")
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]
    #[test]
    fn numbers_read_back_bit_for_bit(double in any::<f64>(), single in any::<f32>(), whole in any::<u64>()) {
        let text = written(|out| out.double(double));
        prop_assert!(number(text.as_bytes()).is_some_and(|back| back.to_bits() == double.to_bits() || double.is_nan()));
        let text = written(|out| out.single(single));
        prop_assert!(text.parse::<f32>().is_ok_and(|back| back.to_bits() == single.to_bits() || single.is_nan()));
        prop_assert_eq!(written(|out| out.attribute(f64::from(single))), text);
        prop_assert_eq!(written(|out| out.integer(whole)), whole.to_string());
    }

    #[test]
    fn words_are_those_of_a_simple_split(text in "[ab#\n\r\t 1.\u{b}]{0,60}") {
        let mut scanner = Scanner::new(text.as_bytes(), Some(b'#'));
        for (line, number) in text.split('\n').zip(1..) {
            let line = line.split('#').next().unwrap_or_default();
            for word in line.split([' ', '\t', '\r', '\u{b}']).filter(|word| !word.is_empty()) {
                prop_assert_eq!(scanner.word(), Some(word.as_bytes()));
                prop_assert_eq!(scanner.line(), number);
            }
        }
        prop_assert_eq!(scanner.word(), None);
        prop_assert_eq!(scanner.place(), text.len());
    }
}

#[test]
fn long_texts_pass_the_buffer_in_order() {
    let long = "x".repeat(200_000);
    let text = written(|out| {
        for k in 0..40_000 {
            out.integer(k)?;
            out.bytes(b" ")?;
        }
        out.text(&long)?;
        out.integer(7)
    });
    let numbers: String = (0..40_000).map(|k| format!("{k} ")).collect();
    assert_eq!(text, format!("{numbers}{long}7"));
}

#[test]
fn integers_may_have_signs_and_ends() {
    let cases: [(&[u8], Option<i64>); 9] = [
        (b"0", Some(0)),
        (b"-12", Some(-12)),
        (b"+7", Some(7)),
        (b"999999999999999999", Some(999_999_999_999_999_999)),
        (b"1234567890123456789", None),
        (b"", None),
        (b"-", None),
        (b"1.0", None),
        (b"--1", None),
    ];
    for (word, value) in cases {
        assert_eq!(integer(word), value, "{}", String::from_utf8_lossy(word));
    }
}

#[test]
fn numbers_have_the_words_of_all_libraries() {
    for word in ["nan", "NaN", "-nan", "-nan(ind)", "1.#QNAN", "-1.#IND00"] {
        assert!(number(word.as_bytes()).is_some_and(f64::is_nan), "{word}");
    }
    assert_eq!(
        ["inf", "-Infinity", "1.#INF", "-1.#INF00"].map(|word| number(word.as_bytes())),
        [Some(f64::INFINITY), Some(f64::NEG_INFINITY), Some(f64::INFINITY), Some(f64::NEG_INFINITY)]
    );
    assert_eq!(
        ["+1", ".5", "5.", "1E3", "1e400"].map(|word| number(word.as_bytes())),
        [Some(1.0), Some(0.5), Some(5.0), Some(1000.0), Some(f64::INFINITY)]
    );
    for word in ["", "+", "-", ".", "e5", "1e", "0x10", "1,5", "+-1", "1 2", "one"] {
        assert_eq!(number(word.as_bytes()), None, "{word}");
    }
}

#[test]
fn rests_of_lines_have_no_blanks_and_comments_at_their_ends() {
    let mut scanner = Scanner::new(b"name  two words \r\n# all\nlast # why", Some(b'#'));
    assert_eq!(scanner.word(), Some(&b"name"[..]));
    assert_eq!(scanner.rest_of_line(), b"two words");
    assert!(scanner.next_line());
    assert_eq!(scanner.rest_of_line(), b"");
    assert!(scanner.next_line());
    assert_eq!((scanner.rest_of_line(), scanner.line()), (&b"last"[..], 3));
    assert!(!scanner.next_line());
}
