//! Who takes part? One name a line, each with a name of files that is its own and leads nowhere else.

use std::collections::BTreeSet;

use crate::text::Untrusted;

/// A student of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// The name, as it is in the list but for spaces.
    pub name: Untrusted,
    /// What the files of the student are called: small letters, digits and hyphens, of no other student.
    pub file: String,
    /// Whether somebody of the same name stands before in the list.
    pub is_namesake: bool,
}

/// Longer names than this are refused.
const LONGEST: usize = 200;
/// Names of files are no longer, but for a number behind them.
const LONGEST_FILE: usize = 60;
/// More students than this are no class.
const MOST: usize = 10_000;

/// What some systems take for a device.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// Reads a list of students: a name a line, empty lines omitted.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::classroom::students;
/// let list = students("Ada Lovelace\n\n../../etc/passwd\r\nJosé Müller\nada  lovelace\n").unwrap();
/// let files: Vec<&str> = list.iter().map(|student| student.file.as_str()).collect();
/// assert_eq!(files, ["ada-lovelace", "etc-passwd", "jose-mueller", "ada-lovelace-2"]);
/// ```
///
/// # Errors
/// What is wrong with the list, in one line, with the number of the line.
pub fn students(list: &str) -> Result<Vec<Student>, String> {
    let mut students: Vec<Student> = Vec::new();
    let (mut names, mut files) = (BTreeSet::new(), BTreeSet::new());
    for (number, line) in list.trim_start_matches('\u{feff}').lines().enumerate() {
        let name = line.split_whitespace().collect::<Vec<_>>().join(" ");
        if name.is_empty() {
            continue;
        }
        if name.chars().count() > LONGEST {
            return Err(format!("line {} has more than {LONGEST} signs; one name a line is expected", number + 1));
        }
        if students.len() == MOST {
            return Err(format!("more than {MOST} names; split the list"));
        }
        let plain = file_name(&name);
        let numbered = (2..).map(|number| format!("{plain}-{number}"));
        let file = [plain.clone()].into_iter().chain(numbered).find(|file| !files.contains(file));
        let file = file.unwrap_or(plain);
        files.insert(file.clone());
        let is_namesake = !names.insert(name.clone());
        students.push(Student { name: Untrusted::new(name), file, is_namesake });
    }
    if students.is_empty() { Err("the list is empty; one name a line is expected".to_owned()) } else { Ok(students) }
}

/// What files of a student may be called.
pub(super) const FILE_NAMES: &str = "small letters, digits and hyphens, as `exercise` writes them";

/// Whether files of a student may be called so: it leads into no other folder, and is no device.
pub(super) fn is_file_name(name: &str) -> bool {
    let is_plain =
        |part: &str| !part.is_empty() && part.bytes().all(|sign| sign.is_ascii_lowercase() || sign.is_ascii_digit());
    // A number behind a long name makes it longer.
    let is_long = (LONGEST_FILE + 1..LONGEST_FILE + 10).contains(&name.len());
    name.split('-').all(is_plain) && (is_long || file_name(name) == name)
}

/// Small letters and digits of ASCII with hyphens between, never empty, and no device.
fn file_name(name: &str) -> String {
    let mut file = String::new();
    for letter in name.chars().flat_map(char::to_lowercase) {
        match latin(letter) {
            Some(letters) => file.push_str(letters),
            None if letter.is_ascii_alphanumeric() => file.push(letter),
            None if file.ends_with('-') || file.is_empty() => {}
            None => file.push('-'),
        }
    }
    file.truncate(LONGEST_FILE);
    let file = file.trim_end_matches('-');
    let is_port = |name: &str| ["com", "lpt"].iter().any(|port| name.strip_prefix(port).is_some_and(|n| n.len() == 1));
    match file {
        "" => "student".to_owned(),
        device if DEVICES.contains(&device) || is_port(device) => format!("student-{device}"),
        file => file.to_owned(),
    }
}

/// How letters of Latin alphabets are written with those of ASCII.
fn latin(letter: char) -> Option<&'static str> {
    Some(match letter {
        'ä' | 'æ' => "ae",
        'ö' | 'œ' => "oe",
        'ü' => "ue",
        'ß' => "ss",
        'à' | 'á' | 'â' | 'ã' | 'ă' | 'ą' => "a",
        'å' => "aa",
        'ç' | 'ć' | 'č' => "c",
        'đ' | 'ď' | 'ð' => "d",
        'è' | 'é' | 'ê' | 'ë' | 'ę' | 'ě' => "e",
        'ğ' => "g",
        'ì' | 'í' | 'î' | 'ï' | 'ı' => "i",
        'ł' => "l",
        'ñ' | 'ń' | 'ň' => "n",
        'ò' | 'ó' | 'ô' | 'õ' | 'ő' => "o",
        'ø' => "oe",
        'ř' => "r",
        'ś' | 'š' | 'ş' | 'ș' => "s",
        'ť' | 'ţ' | 'ț' => "t",
        'ù' | 'ú' | 'û' | 'ű' | 'ů' => "u",
        'ý' | 'ÿ' => "y",
        'ź' | 'ż' | 'ž' => "z",
        'þ' => "th",
        // What only stands over the letter before it.
        '\u{300}'..='\u{36f}' => "",
        _ => return None,
    })
}
