//! Which minimal vanishing stars are there, how do they look, and in which engines do they occur?

use std::collections::{BTreeMap, BTreeSet};

use super::drawn;
use crate::engine::Engine;
use crate::exact::{MOST_VECTORS, MinimalStar, StarClass, minimal_stars, taken_apart};
use crate::order::Masses;
use crate::page::{Block, Document, Picture, Table, Text, phrase};
use crate::proof::{Certificate, Quantity};
use crate::report::argument::listed_polygons;
use crate::report::engine_page::symbol;
use crate::report::texts::star_atlas as text;
use crate::text::Untrusted;
use crate::verdict::{self, Verdict};

/// The orders at which engines are looked at.
const ORDERS: [u32; 4] = [1, 2, 4, 6];

/// An engine of the atlas of stars.
pub struct StarredEngine {
    /// What it is called.
    pub name: String,
    /// The engine.
    pub engine: Engine,
}

/// The minimal vanishing stars, with the engines in which they occur.
pub struct StarAtlas {
    stars: Vec<MinimalStar>,
    /// By star: engines with the sums in which it occurs.
    occurring: BTreeMap<usize, Vec<(String, Vec<String>)>>,
    engines: usize,
    /// How many sums were taken apart, and how many were not.
    sums: [usize; 2],
}

impl StarAtlas {
    /// Looks for the stars in engines.
    pub fn new(engines: &[StarredEngine]) -> Self {
        let stars = minimal_stars(MOST_VECTORS);
        let mut atlas = StarAtlas { stars, occurring: BTreeMap::new(), engines: engines.len(), sums: [0, 0] };
        for StarredEngine { name, engine } in engines {
            for (star, sums) in atlas.of_engine(engine) {
                atlas.occurring.entry(star).or_default().push((name.clone(), sums));
            }
        }
        atlas
    }

    /// The sums of an engine in which each star occurs.
    fn of_engine(&mut self, engine: &Engine) -> BTreeMap<usize, Vec<String>> {
        let mut sums: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        let judged = verdict::classify(engine, &ORDERS, Masses::Reciprocating, &Quantity::PLANAR).unwrap_or_default();
        let parts = judged.iter().flat_map(|order| &order.parts).filter(|part| part.exists);
        let verdicts = parts.flat_map(|part| [part.force.verdicts(), part.moment.verdicts()]).flatten();
        // Zero, and with vectors when like directions are added.
        let has_vectors = |verdict: &&Verdict| !verdict.sum.positive().collected().is_empty();
        for verdict in verdicts.filter(|verdict| verdict.vanishes()).filter(has_vectors) {
            let Some(parts) = taken_apart(&verdict.sum, &self.stars) else {
                self.sums[1] += 1;
                continue;
            };
            self.sums[0] += 1;
            let stars: BTreeSet<usize> = parts.into_iter().map(|part| part.star).collect();
            stars.into_iter().for_each(|star| {
                let named = sums.entry(star).or_default();
                let symbol = symbol(verdict);
                if !named.contains(&symbol) {
                    named.push(symbol);
                }
            });
        }
        sums
    }

    /// The classes with the places of their stars, by number of vectors.
    fn classes(&self) -> Vec<(&StarClass, Vec<usize>)> {
        let mut classes: Vec<(&StarClass, Vec<usize>)> = Vec::new();
        for (place, star) in self.stars.iter().enumerate() {
            match classes.last_mut() {
                Some((class, places)) if **class == star.class => places.push(place),
                _ => classes.push((&star.class, vec![place])),
            }
        }
        classes
    }

    /// The engines of a class, each with its sums.
    fn engines_of(&self, places: &[usize]) -> Vec<&(String, Vec<String>)> {
        places.iter().filter_map(|place| self.occurring.get(place)).flatten().collect()
    }

    fn answer_box(&self) -> Vec<Text> {
        let classes = self.classes();
        let occurring = classes.iter().filter(|(_, places)| !self.engines_of(places).is_empty());
        let occurring: Vec<Text> = occurring.map(|(class, _)| Text::formula(class.to_string())).collect();
        let [apart, left] = self.sums;
        vec![
            text::classes(self.stars.len(), MOST_VECTORS, classes.len()),
            match left {
                0 => text::made_of(apart, self.engines, Text::joined(occurring, ", ")),
                left => text::made_of_but(apart + left, self.engines, left, Text::joined(occurring, ", ")),
            },
        ]
    }

    /// The classes, a row each.
    fn table(&self) -> Table {
        let mut table = Table::new(["Vectors", "Class", "Stars", "Fewest polygons", "Engines in which they occur"]);
        for (class, places) in self.classes() {
            let fewest: BTreeSet<usize> = places.iter().filter_map(|place| self.fewest(*place)).collect();
            let numbers = fewest.iter().map(|number| Text::from(*number));
            let engines: BTreeSet<&String> = self.engines_of(&places).into_iter().map(|(name, _)| name).collect();
            table.push(vec![
                class.vectors().into(),
                Text::formula(class.to_string()),
                places.len().into(),
                Text::joined(numbers, ", "),
                engines.len().into(),
            ]);
        }
        table
    }

    fn fewest(&self, place: usize) -> Option<usize> {
        self.stars[place].sum().fewest_polygons()
    }

    /// `7.3`: the third star of seven vectors.
    fn label(&self, place: usize) -> String {
        let vectors = |star: &MinimalStar| star.class.vectors();
        let of = vectors(&self.stars[place]);
        let first = self.stars.iter().position(|star| vectors(star) == of).unwrap_or(place);
        format!("{of}.{}", place - first + 1)
    }

    /// Drawings, polygons and engines of a class.
    fn class(&self, class: &StarClass, places: &[usize]) -> Vec<Block> {
        let name = format!("minimal-{}", self.label(places[0]).replace('.', "-"));
        let labelled: Vec<(String, &MinimalStar)> =
            places.iter().map(|place| (self.label(*place), &self.stars[*place])).collect();
        let (formula, vectors) = (Text::formula(class.to_string()), class.vectors());
        let caption = match places.len() {
            1 => text::one_star(formula, vectors),
            several => text::several_stars(formula, vectors, several),
        };
        let picture = Picture::new(name, caption, drawn::stars(&labelled));
        let mut blocks = vec![Block::Pictures(vec![picture])];
        blocks.push(Block::folded(
            phrase!("Vectors and polygons of {}", Text::formula(class.to_string())),
            vec![self.polygons(places).into()],
        ));
        let engines = self.engines_of(places);
        if !engines.is_empty() {
            blocks.push(Block::folded(
                phrase!("Engines in which {} occurs", Text::formula(class.to_string())),
                vec![occurrences(&engines).into()],
            ));
        }
        blocks
    }

    /// The vectors of each star, and the polygons that prove it.
    fn polygons(&self, places: &[usize]) -> Table {
        let mut table = Table::new(["Star", "Vectors, in turns", "Polygons: sides; turn of a corner; weight"]);
        for place in places {
            let sum = self.stars[*place].sum();
            let angles = self.stars[*place].angles();
            let angles: Vec<String> = angles.iter().map(|angle| angle.turns().to_string()).collect();
            let Certificate::Polygons { polygons } = sum.certificate() else { continue };
            table.push(vec![self.label(*place).into(), angles.join(", ").into(), listed_polygons(&polygons).into()]);
        }
        table
    }
}

fn occurrences(engines: &[&(String, Vec<String>)]) -> Table {
    let mut by_name: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (name, sums) in engines {
        by_name.entry(name).or_default().extend(sums.iter().map(String::as_str));
    }
    let mut table = Table::new(["Engine", "Sums"]);
    for (name, sums) in by_name {
        table.push(vec![(&Untrusted::new(name.to_owned())).into(), Text::formula(sums.join(",\\; "))]);
    }
    table
}

/// The short answer: the classes.
pub fn star_atlas_answer(atlas: &StarAtlas) -> Document {
    let mut answer = Document::new("stars", text::title());
    answer.push(Block::List(atlas.answer_box()));
    answer.push(atlas.table());
    answer
}

/// The atlas, each star drawn.
pub fn star_atlas_page(atlas: &StarAtlas) -> Document {
    let (mut stars, mut vectors) = (Vec::new(), 0);
    for (class, places) in atlas.classes() {
        if class.vectors() != vectors {
            vectors = class.vectors();
            stars.push(Block::Heading(1, phrase!("{} vectors", vectors)));
        }
        stars.extend(atlas.class(class, &places));
    }
    let page = text::Page {
        title: text::title(),
        answer: Block::Answer(atlas.answer_box()).into(),
        classes: atlas.table().into(),
        stars: stars.into(),
    };
    Document { name: "README", has_contents: true, ..page.document() }
}
