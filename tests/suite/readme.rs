//! Is the README short, do its commands run, and do its ways to get the program lead to what a release has?

use std::fs;
use std::path::Path;

use crate::support::program::{program, scratch};

fn text(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What stands between single backticks.
fn spans(page: &str) -> Vec<String> {
    let mut is_block = false;
    let lines = page.lines().filter(|line| {
        let is_fence = line.starts_with("```");
        is_block ^= is_fence;
        !is_block && !is_fence
    });
    lines.flat_map(|line| line.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

#[test]
fn the_readme_is_read_in_three_minutes() {
    let words = text("README.md").split_whitespace().count();
    assert!(words <= 700, "{words} words");
}

#[test]
fn the_engine_of_the_readme_is_its_file() {
    let engine = format!("```toml\n{}```\n", text("examples/four.toml"));
    assert!(text("README.md").contains(&engine), "examples/four.toml has\n{engine}");
}

#[test]
fn the_commands_of_the_readme_run() {
    let folder = scratch("readme");
    fs::create_dir(folder.join("examples")).expect("a folder");
    fs::write(folder.join("examples/four.toml"), text("examples/four.toml")).expect("a file");
    let mut run = 0;
    let spans = spans(&text("README.md"));
    assert!(spans.iter().any(|span| span == "cargo test"), "who has a clone finds its tests");
    for span in spans {
        let ways = ["crankstar ", "cargo run -- ", "uvx crankstar ", "docker run --rm crankstar "];
        let Some(arguments) = ways.iter().find_map(|way| span.strip_prefix(way)) else { continue };
        let out = program().args(arguments.split(' ')).current_dir(&folder).output().expect("the program starts");
        assert!(out.status.success(), "{span}: {}", String::from_utf8_lossy(&out.stderr));
        run += 1;
    }
    assert!(run >= 6, "only {run} commands");
}

/// `cargo binstall` looks for the archives that `.ci/archive` makes, in the release that the workflow drafts.
#[test]
fn the_ways_to_get_the_program_name_what_a_release_has() {
    let (manifest, archive, workflow) =
        (text("Cargo.toml"), text(".ci/archive"), text(".github/workflows/release.yml"));
    let line = |key: &str| {
        let found = manifest.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
        found.unwrap_or_else(|| panic!("no {key}")).trim_matches('"').to_owned()
    };
    assert_eq!(
        line("pkg-url"),
        "{ repo }/releases/download/v{ version }/crankstar-{ version }-{ target }{ archive-suffix }"
    );
    assert_eq!(line("bin-dir"), "crankstar-{ version }-{ target }/crankstar{ binary-ext }");
    assert!(
        archive.contains("name=\"crankstar-$version-$target\"") && workflow.contains("gh release create \"v$VERSION\"")
    );
    assert!(archive.contains("$built/$name.zip") && archive.contains("dist/$name.tar.gz"));
    // Each target of the workflow has the format of its archive.
    let windows =
        manifest.split("[package.metadata.binstall.overrides.x86_64-pc-windows-msvc]\n").nth(1).expect("Windows");
    assert!(windows.starts_with("pkg-fmt = \"zip\"") && line("pkg-fmt") == "tgz");
    assert!(archive.contains("Containerfile") && text("Containerfile").contains("COPY crankstar /crankstar"));
    assert!(text("pyproject.toml").contains("name = \"crankstar\"\n"));
    assert!(workflow.contains("web/build \"dist/crankstar-$VERSION.html\""));
}

/// Nothing resolves the links of the Python package's page.
#[test]
fn the_page_of_the_python_package_has_no_link_that_a_registry_breaks() {
    let page = text("python/README.md");
    let links: Vec<&str> = page.split("](").skip(1).filter(|rest| !rest.starts_with("http")).collect();
    assert!(links.is_empty(), "{links:?}");
}
