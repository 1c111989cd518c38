//! How does a scene read in another language? All its finished words as the list of the language has them.

use super::scene::{Mark, MovingQuantity, MovingSense, Ray, Scene, Words, Zeros};
use crate::page::Language;

impl Scene {
    /// The scene in a language; names that a person gave stay.
    pub(super) fn spoken(&self, language: Language) -> Scene {
        let mut scene = self.clone();
        if language == Language::En {
            return scene;
        }
        let quantities = scene.orders.iter_mut().flat_map(|order| [&mut order.force, &mut order.moment]);
        quantities.for_each(|quantity| quantity.speak(language));
        if let Some(angle) = &mut scene.angle {
            angle.name = language.fixed(angle.name);
            angle.start.speak(language);
        }
        scene.words.speak(language);
        scene
    }
}

fn label(text: &mut String, language: Language) {
    *text = language.label(text).into_owned();
}

impl MovingQuantity {
    fn speak(&mut self, language: Language) {
        label(&mut self.words, language);
        self.most.iter_mut().for_each(|most| label(most, language));
        self.senses.iter_mut().for_each(|sense| sense.speak(language));
        self.marks.iter_mut().for_each(|mark| mark.speak(language));
    }
}

impl MovingSense {
    fn speak(&mut self, language: Language) {
        label(&mut self.words, language);
        self.rays.iter_mut().for_each(|ray: &mut Ray| label(&mut ray.label, language));
        self.zeros.iter_mut().for_each(|zeros: &mut Zeros| label(&mut zeros.words, language));
    }
}

impl Mark {
    fn speak(&mut self, language: Language) {
        label(&mut self.text, language);
        self.of.iter_mut().for_each(|of| *of = language.fixed(of));
    }
}

impl Words {
    fn speak(&mut self, language: Language) {
        let Words { senses, force, moment, order, zero, near, not_zero, undecided, at, largest, play, pause } = self;
        let [direct, reverse] = senses;
        for words in [direct, reverse, force, moment, order, zero, near, not_zero, undecided, at, largest, play, pause]
        {
            *words = language.fixed(words);
        }
    }
}
