//! Does an engine move in a browser, and does it say only what is proved?

use std::fs;
use std::path::Path;

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::page::Language;
use crankstar::proof::Quantity;
use crankstar::report::Weighing;
use crankstar::report::moving::{MOVING_SCRIPT, MOVING_STYLE, Scene, moving_fragment, open_scenes, scene};
use crankstar::verdict::Judgement;

const V20: &str = include_str!("v20.toml");
const DELTA: &str = include_str!("delta.toml");
const UNEQUAL_RODS: &str = "title = 'Four, two kinds of rod, one axis offset'\n[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\n\
                            rod_ratio = [0.25, 0.3, 0.3, 0.25]\noffset_ratio = [0.1, 0.1, 0.1, 0.1]\n";
const CORRECTED: &str = "title = 'Five, corrected knuckle pins'\n[radial]\ncylinders = 5\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 2\n\
                         knuckle_ratio = 0.2\nknuckle_angle = [-70, 70, 146, 214]\n";
const HOSTILE: &str = "title = '</script><script>alert(1)</script><!-- <img src=x onerror=alert(2)> & \"q\"'\n[inline]\nthrows = [0, 180]\n";
const MEMBER: &str = "title = 'V-twin at 60°'\n[values]\nphi = 60\n[vee]\nbank_angle = 'phi'\nthrows = [0]\n";

fn judged(engine: &Engine) -> Judgement {
    Judgement::new(engine, engine.orders(), &Quantity::PLANAR).expect("orders")
}

fn scenes(name: &str, text: &str) -> Vec<Scene> {
    match file::parse_layout(name, text).expect("it reads") {
        Layout::Open(family) => open_scenes(&family, family.orders()),
        Layout::Known(engine, None) => vec![scene(&engine, &judged(&engine), None, Weighing::usual())],
        Layout::Known(engine, Some(family)) => {
            let open = family::classify(&family, engine.orders()).expect("orders");
            vec![scene(&engine, &judged(&engine), Some((&family, &open)), Weighing::usual())]
        }
    }
}

fn all() -> Vec<(String, Vec<Scene>)> {
    let catalogue = ["I4", "I6", "V8-crossplane", "radial-9", "radial-9-master", "radial-18", "boxer-6"].map(|name| {
        let engine = file::find(name).expect("an engine").engine().expect("it reads");
        (name.to_owned(), vec![scene(&engine, &judged(&engine), None, Weighing::usual())])
    });
    let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/families");
    let families = ["v-twin", "v6-shared-pins", "v6-split-pins", "w-three-banks", "i3-spacing"].map(|name| {
        let text = fs::read_to_string(stored.join(name).join("layout.toml")).expect("a layout file");
        (name.to_owned(), scenes(name, &text))
    });
    let written = [
        ("v20", V20),
        ("delta", DELTA),
        ("unequal-rods", UNEQUAL_RODS),
        ("corrected", CORRECTED),
        ("hostile", HOSTILE),
        ("member", MEMBER),
    ];
    let written = written.map(|(name, text)| (name.to_owned(), scenes(name, text)));
    catalogue.into_iter().chain(families).chain(written).collect()
}

#[test]
#[ignore = "needs node with playwright-core, and Chromium"]
fn engines_move_in_a_browser_and_say_what_is_proved() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-moving");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let mut names = Vec::new();
    for (name, scenes) in all() {
        assert!(!scenes.is_empty(), "{name} has no scene");
        let fragments =
            scenes.iter().enumerate().map(|(index, scene)| moving_fragment(scene, &format!("m{index}"), Language::En));
        let page = include_str!("moving.html").replace("STYLE", MOVING_STYLE).replace("SCRIPT", MOVING_SCRIPT);
        let page = page.replace("BODY", &fragments.collect::<String>());
        fs::write(folder.join(format!("{name}.html")), page).expect("a page");
        names.push(name);
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pages/moving.cjs");
    let list = serde_json::to_string(&names).expect("JSON");
    println!("{}", super::run(&folder, "node", &[script], &list));
}
