//! Who says it? A source, with the place and its words; nobody in particular; or the file itself.

use crate::file::LayoutError;
use crate::file::written::{Text, place as place_of};
use crate::text::Untrusted;

/// Where a claim comes from. Only what is quoted counts as a claim of its source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Provenance {
    /// A source says it.
    Quoted(Quote),
    /// It is often said, and no source was found for it.
    Folklore,
    /// The file's own: computed beside what others say, and claimed by none of them.
    Own,
}

/// Where a source says it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quote {
    /// The source.
    pub source: Untrusted,
    /// Section, page, equation or figure.
    pub place: Untrusted,
    /// A few of its words, as they are there.
    pub words: Untrusted,
}

impl Provenance {
    /// Whether it is claimed by somebody, so that it counts among the claims that hold or do not.
    pub fn is_claimed(&self) -> bool {
        match self {
            Provenance::Quoted(_) | Provenance::Folklore => true,
            Provenance::Own => false,
        }
    }
}

/// The keys of a row or of the statement around it.
#[derive(Clone, Copy, Default)]
pub(super) struct Keys<'a> {
    pub kind: Option<&'a Text>,
    pub source: Option<&'a Text>,
    pub place: Option<&'a Text>,
    pub words: Option<&'a Text>,
}

impl<'a> Keys<'a> {
    /// Kind, source, place and words.
    pub fn of(keys: [&'a Option<Text>; 4]) -> Self {
        let [kind, source, place, words] = keys.map(Option::as_ref);
        Keys { kind, source, place, words }
    }

    /// These keys, and where one is missing that of what stands around; a row that is nobody's takes only the source.
    pub fn within(self, around: Keys<'a>) -> Self {
        let source = self.source.or(around.source);
        match self.kind.map(|kind| kind.get_ref().0.as_str()) {
            Some("folklore" | "own") => Keys { source, ..self },
            _ => Keys {
                kind: self.kind.or(around.kind),
                source,
                place: self.place.or(around.place),
                words: self.words.or(around.words),
            },
        }
    }

    /// What the keys say.
    ///
    /// # Errors
    /// A kind that is none, or keys that do not go together.
    pub fn provenance(self) -> Result<Provenance, LayoutError> {
        let wrong = |text: &Text, message: &str, right: &str| Err(LayoutError::new(message, right, place_of(text)));
        let kind = self.kind.map(|kind| (kind, kind.get_ref().0.as_str()));
        match (kind, self.place, self.words) {
            (None | Some((_, "quoted")), Some(place), Some(words)) => {
                let Some(source) = self.source else {
                    return wrong(place, "a place in no source", "name the `source` of the statement or of the file");
                };
                let text = |text: &Text| text.get_ref().untrusted();
                Ok(Provenance::Quoted(Quote { source: text(source), place: text(place), words: text(words) }))
            }
            (Some((_, "folklore")), None, None) => Ok(Provenance::Folklore),
            (None | Some((_, "own")), None, None) => Ok(Provenance::Own),
            (Some((kind, "quoted")), ..) => {
                wrong(kind, "what is quoted has a place and words", "add `place = \"section 4.1\"` and `words`")
            }
            (None, Some(text), None) | (None, None, Some(text)) => wrong(
                text,
                "what is quoted has a place and words",
                "give both `place`, such as section 4.1, and `words`, a few of the source's",
            ),
            (Some((kind, "folklore" | "own")), ..) => {
                wrong(kind, "only what is quoted has a place and words", "leave them out, or write kind = \"quoted\"")
            }
            (Some((kind, _)), ..) => wrong(kind, "this is not a kind of claim", "quoted, folklore or own"),
        }
    }
}
