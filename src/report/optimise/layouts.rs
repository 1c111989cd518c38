//! Which files are beside the page? A layout file of each best crankshaft.

use crate::numbers::float;
use crate::optimise::{Front, Optimum};
use crate::page::File;

fn file(name: String, point: &Optimum) -> File {
    File { name, text: point.engine.file().written().to_owned() }
}

/// The layout file of each point, and of those that are as heavy or as calm as one with a uniform balance factor.
pub fn optimise_layouts(front: &Front) -> Vec<File> {
    let points = front.points.iter().enumerate();
    let mut files: Vec<File> = points.map(|(index, point)| file(format!("point-{}.toml", index + 1), point)).collect();
    for uniform in &front.uniform {
        let factor = float(&uniform.factor);
        let compared = [("heavy", &uniform.best), ("calm", &uniform.lightest)];
        let named = compared.into_iter().filter_map(|(as_what, point)| Some((as_what, point.as_ref()?)));
        files.extend(named.map(|(as_what, point)| file(format!("as-{as_what}-as-{factor}.toml"), point)));
    }
    files
}
