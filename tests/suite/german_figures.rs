//! Does any text of a drawing lie on another, or leave the page, where German words are longer than English ones?

use crankstar::file;
use crankstar::page::{Document, Language, Picture};

use crate::studies::catalogue;
use crate::support::figure_texts::FigureTexts;
use crate::support::german::{pages_of_folders, pages_of_the_catalogue};
use crate::views::unreadable_texts;

/// Views and plots are looked at as their own tests do, stars as theirs.
fn is_view_or_plot(name: &str) -> bool {
    let plots = ["end-view", "side-view", "force-", "moment-", "torque", "bearing-", "amplitudes"];
    name != "torque-stars" && plots.iter().any(|plot| name.starts_with(plot))
}

/// How many pictures these pages have, and what is wrong with their texts in German.
fn looked_at(name: &str, pages: &[Document]) -> (usize, Vec<String>) {
    let pictures: Vec<_> = pages.iter().flat_map(Document::pictures).collect();
    let wrong = |picture: &&Picture| {
        let figure = Language::De.picture(picture).figure;
        let wrong = match is_view_or_plot(&picture.name) {
            true => unreadable_texts(&figure),
            false => figure
                .overlaps()
                .iter()
                .map(|pair| format!("{pair:?}"))
                .chain(figure.leaving().into_iter().map(str::to_owned))
                .collect(),
        };
        (!wrong.is_empty()).then(|| format!("{} of {name}: {wrong:?}", picture.name))
    };
    (pictures.len(), pictures.iter().filter_map(wrong).collect())
}

#[test]
fn no_german_text_of_the_catalogue_lies_on_another_or_leaves_the_page() {
    let engines = file::catalogue().expect("the catalogue reads");
    let catalogue = looked_at("the catalogue", &[catalogue::page(&engines)]);
    let each = pages_of_the_catalogue().iter().map(|(name, pages)| looked_at(name, pages));
    let (drawn, wrong): (Vec<usize>, Vec<Vec<String>>) = each.chain([catalogue]).unzip();
    assert!(drawn.iter().sum::<usize>() > 150, "{drawn:?}");
    assert!(wrong.concat().is_empty(), "{:#?}", wrong.concat());
}

#[test]
fn no_german_text_of_a_layout_file_lies_on_another_or_leaves_the_page() {
    for (folder, pages) in pages_of_folders() {
        let (drawn, wrong) = looked_at(folder, pages);
        assert!(drawn > 3, "{drawn} drawings of {folder}");
        assert!(wrong.is_empty(), "{wrong:#?}");
    }
}
