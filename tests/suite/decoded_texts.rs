//! Is a text read as it was meant, in the encodings that editors, spreadsheets and instruments write?

use crankstar::text::decoded;
use proptest::prelude::*;

fn little(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_le_bytes).collect()
}

fn big(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_be_bytes).collect()
}

const TABLE: &str = "Winkel [°];Druck [bar]\r\n-360,0;1,05\r\n";

#[test]
fn every_encoding_of_a_table_is_the_same_text() {
    let latin: Vec<u8> = TABLE.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect();
    let marked = |mark: &[u8], text: Vec<u8>| [mark, &text].concat();
    for bytes in [
        TABLE.as_bytes().to_vec(),
        marked(b"\xef\xbb\xbf", TABLE.as_bytes().to_vec()),
        latin,
        marked(b"\xff\xfe", little(TABLE)),
        marked(b"\xfe\xff", big(TABLE)),
        little(TABLE),
        big(TABLE),
    ] {
        assert_eq!(decoded(&bytes), TABLE);
    }
}

#[test]
fn windows_1252_has_its_own_signs_where_latin_1_has_controls() {
    assert_eq!(decoded(b"\x80 \x85 \x93crank\x94 \x96360\xb0 \x9f \xff"), "€ … “crank” –360° Ÿ ÿ");
}

#[test]
fn halves_of_utf_16_are_told_and_lose_nothing_else() {
    assert_eq!(decoded(b"\xff\xfea\0\x00\xd8b\0c"), "a\u{fffd}b\u{fffd}");
    assert_eq!(decoded(b""), "");
    assert_eq!(decoded(b"\xff\xfe"), "");
}

proptest! {
    #[test]
    fn a_text_survives_utf_8_and_marked_utf_16(text in "\\PC*") {
        let marked = format!("\u{feff}{text}");
        prop_assert_eq!(&decoded(marked.as_bytes()), &text);
        prop_assert_eq!(&decoded(&little(&marked)), &text);
        prop_assert_eq!(&decoded(&big(&marked)), &text);
    }

    #[test]
    fn any_bytes_are_read(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
        prop_assert!(decoded(&bytes).chars().count() <= bytes.len());
    }
}
