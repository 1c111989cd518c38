//! Which files make up a report?

use super::calculation::{self, Numbers};
use super::dialect::Dialect;
use super::open_page::OpenPage;
use super::page::{Contents, NamedFigure, Page, figures, torque_stars, torque_verdicts};
use super::remedy::remedy_figure;
use super::render;
use crate::engine::Family;
use crate::family::OpenOrder;
pub use crate::page::File;

/// A report with its diagrams: `report.md` with SVG files, or `report.tex`, which holds its own.
pub fn report(subject: Contents, dialect: Dialect) -> Vec<File> {
    let numbers = subject.numbers();
    let text = render::report(&Page::new(subject, numbers.as_ref(), dialect), dialect);
    if dialect == Dialect::Latex {
        return vec![File { name: "report.tex".into(), text }];
    }
    let mut drawn = figures(subject.engine, subject.judged);
    if let Some(Ok(remedy)) = subject.remedy() {
        let figure = remedy_figure(&remedy);
        drawn.extend(figure.map(|(name, figure)| NamedFigure {
            name: name.into(),
            caption: "Partial balance".into(),
            figure,
        }));
    }
    let torque = torque_verdicts(subject.engine, subject.judged, numbers.as_ref());
    drawn.extend((!torque.is_empty()).then(|| torque_stars(subject.engine, &torque)));
    if let Some(Ok(Numbers { loads, .. })) = &numbers {
        drawn.extend(calculation::figures(subject.engine, loads));
    }
    [File { name: "report.md".into(), text }].into_iter().chain(drawn.into_iter().map(NamedFigure::into_svg)).collect()
}

/// The report of a family: one file, without diagrams, for its angles are open.
pub fn open_report(family: &Family, orders: &[OpenOrder], dialect: Dialect) -> Vec<File> {
    let name = if dialect == Dialect::Latex { "report.tex" } else { "report.md" };
    let text = render::open_report(&OpenPage::new(family, orders, dialect), dialect);
    vec![File { name: name.into(), text }]
}
