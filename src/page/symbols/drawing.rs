//! How are symbols renamed in a drawing?

use super::{Symbols, Word};
use crate::page::block::Picture;
use crate::page::figure::Figure;
use crate::page::markup::{self, marks};

impl Symbols {
    /// A picture whose labels have the names of the reader; its caption is a text as others.
    pub(in crate::page) fn in_picture(&self, picture: &Picture) -> Picture {
        let mut picture = picture.clone();
        if !self.is_empty() {
            self.in_figure(&mut picture.figure);
        }
        picture
    }

    fn in_figure(&self, figure: &mut Figure) {
        for (text, prose) in figure.texts_mut() {
            if let Some(prose) = prose {
                *prose = match prose {
                    Some(prose) => Some(self.in_prose(prose)),
                    None => self.prose_of(text),
                };
            }
            *text = self.in_plain_words(text);
        }
    }

    /// A label with the new names as formulas, for fonts that lack their letters; none where none is in it.
    fn prose_of(&self, text: &str) -> Option<String> {
        let words = self.in_parts(text);
        let is_renamed = words.iter().any(|word| matches!(word, Word::Renamed { .. }));
        // A label with the signs of prose is not made prose.
        let is_plain = !text.contains(['$', '*', '{']);
        (is_renamed && is_plain).then(|| words.iter().map(as_prose).collect())
    }

    /// Prose with formulas.
    fn in_prose(&self, prose: &str) -> String {
        let set = |mark| match mark {
            markup::Mark::Words(words) => self.in_parts(words).iter().map(as_prose).collect(),
            markup::Mark::Formula(tex) => format!("${}$", self.in_tex(tex)),
            markup::Mark::Bold => "**".to_owned(),
            markup::Mark::Place(_) => "{}".to_owned(),
        };
        marks(prose).into_iter().map(set).collect()
    }
}

fn as_prose(word: &Word) -> String {
    match word {
        Word::Plain(words) => (*words).to_owned(),
        Word::Renamed { tex, .. } => format!("${tex}$"),
    }
}
