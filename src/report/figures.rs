//! What can be drawn by itself, and by which name is it asked for?

use crate::page::{Document, Picture};

/// A picture with the name by which a person asks for it.
#[derive(Clone, Debug)]
pub struct NamedPicture {
    /// `end-view`, `star:2`, `polar:3`.
    pub name: String,
    /// The picture.
    pub picture: Picture,
}

/// Every picture of some pages, in their order.
pub fn figures(pages: &[Document]) -> Vec<NamedPicture> {
    let named = |picture: &Picture| NamedPicture { name: asked_for(&picture.name), picture: picture.clone() };
    let mut all: Vec<NamedPicture> = Vec::new();
    for named in pages.iter().flat_map(Document::pictures).map(named) {
        // The first star of a page may stand among its proofs again, and bearings on both pages.
        if all.iter().all(|other| other.name != named.name) {
            all.push(named);
        }
    }
    all
}

/// Every picture of a sweep: `sweep:force-2`.
pub fn sweep_figures(page: Document) -> Vec<NamedPicture> {
    let of_sweep = |picture: NamedPicture| NamedPicture { name: format!("sweep:{}", picture.name), ..picture };
    figures(&[page]).into_iter().map(of_sweep).collect()
}

/// The name to ask by, of the name of a file: `star:2:pistons` of `order-2-pistons`, `polar:3` of `bearing-3-polar`.
fn asked_for(file: &str) -> String {
    if let Some(order) = file.strip_prefix("order-") {
        return format!("star:{}", order.replace("-pistons", ":pistons").replace("-class-", ":class-"));
    }
    match file.strip_prefix("bearing-") {
        Some(bearing) => match bearing.strip_suffix("-polar") {
            Some(bearing) => format!("polar:{bearing}"),
            None => format!("bearing:{bearing}"),
        },
        None => file.to_owned(),
    }
}
