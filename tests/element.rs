//! The element repository: what its users rely on.

use bosquet::element::{Catalogue, Kind, NotFound, PlantSymbol, Texture};
use bosquet::world::MemoryWorld;
use proptest::prelude::*;

fn extended(text: &str) -> (Catalogue, Vec<bosquet::diag::Diagnostic>) {
    Catalogue::built_in().extended("site/plants.toml", text.as_bytes(), &MemoryWorld::default())
}

#[test]
fn the_papers_birch_is_found_by_every_name() {
    let catalogue = Catalogue::built_in();
    for name in ["birch", "Birch", "BETULA PENDULA", "betula-pendula", "silver_birch", "bouleau"] {
        let found = catalogue.find(name, "adult").expect(name);
        assert_eq!((&*found.entry.id, &*found.variant.name), ("betula-pendula", "adult"));
        assert_eq!((&*found.entry.code, found.entry.symbol), ("BET", PlantSymbol::Feathery));
    }
    assert_eq!(&*catalogue.find("Tilia x europaea", "").expect("a lime").variant.name, "adult");
    assert_eq!(&*catalogue.find("horse_chestnut", "").expect("a chestnut").entry.code, "AES");
}

#[test]
fn slips_of_the_pen_get_a_suggestion() {
    let catalogue = Catalogue::built_in();
    let missing = catalogue.find("brich", "adult").expect_err("no such plant");
    assert_eq!(missing.suggestion(), Some("birch"));
    assert_eq!(missing.to_string(), "the catalogue has no element `brich`");
    let missing = catalogue.find("birch", "adutl").expect_err("no such type");
    assert_eq!(missing.suggestion(), Some("adult"));
    assert_eq!(missing.to_string(), "`birch` has no type `adutl`: it has `young`, `medium`, `adult`");
    assert!(matches!(catalogue.find("", ""), Err(NotFound::Element { .. })));
}

#[test]
fn built_in_plants_are_plausible() {
    for entry in Catalogue::built_in().entries().filter(|entry| entry.kind.is_plant()) {
        let ages = ["young", "medium", "adult"].map(|name| entry.variants.iter().find(|v| &*v.name == name));
        for pair in ages.iter().flatten().collect::<Vec<_>>().windows(2) {
            let (a, b) = (pair[0].plant.expect("figures"), pair[1].plant.expect("figures"));
            assert!(a.age < b.age && a.height < b.height && a.crown_radius < b.crown_radius, "{}", entry.id);
            assert!(a.trunk_diameter <= b.trunk_diameter && a.spacing_radius < b.spacing_radius, "{}", entry.id);
        }
        for variant in &entry.variants {
            let figures = variant.plant.expect("figures");
            assert_eq!(variant.size, [2.0 * figures.crown_radius, figures.height, 2.0 * figures.crown_radius]);
            assert!(figures.trunk_diameter < figures.crown_radius, "{} {}", entry.id, variant.name);
            // Stems in the open are 20 to 80 times as high as thick, saplings up to 100 times.
            assert!(entry.kind != Kind::Tree || figures.height / figures.trunk_diameter < 100.0, "{}", entry.id);
        }
        assert!(!entry.species.is_empty() && !entry.common_name.is_empty());
    }
}

#[test]
fn codes_and_names_lead_to_one_element() {
    let catalogue = Catalogue::built_in();
    let mut codes: Vec<&str> = catalogue.entries().map(|entry| &*entry.code).collect();
    let count = codes.len();
    codes.sort_unstable();
    codes.dedup();
    assert_eq!(codes.len(), count, "two elements share a code");
    for entry in catalogue.entries() {
        for variant in &entry.variants {
            assert_eq!(catalogue.find(&entry.id, &variant.name).expect(&entry.id).entry.id, entry.id);
        }
        for name in entry.all_names().filter(|name| !name.is_empty() && **name != entry.category) {
            assert_eq!(catalogue.find(name, "").expect(name).entry.id, entry.id, "`{name}` is ambiguous");
        }
    }
}

#[test]
fn the_catalogue_has_what_a_formal_garden_needs() {
    let catalogue = Catalogue::built_in();
    for name in ["bench", "statue", "vase", "fountain", "lamp", "urn", "treillage", "obelisk", "pedestal", "planter"] {
        assert!(catalogue.find(name, "").is_ok(), "{name}");
    }
    for name in ["boulder", "jet", "cube", "sphere", "cylinder", "cone", "quad", "disk"] {
        let found = catalogue.find(name, "").expect(name);
        assert!(found.entry.form.footprint(found.variant.size[0], found.variant.size[2]).is_some());
    }
    for (word, texture) in [("gravel", Texture::Stipple), ("water", Texture::Ripples), ("palissade", Texture::Foliage)]
    {
        assert_eq!(catalogue.cover(word).expect(word).material.texture, texture);
    }
    for word in ["lawn", "meadow", "sand", "paving", "terrace", "path", "bed", "hedge", "wall", "building", "roof"] {
        assert_eq!(&*catalogue.cover(word).expect(word).material.name, word);
    }
    assert_eq!(&*catalogue.cover("Broderie").expect("a synonym").material.name, "embroidery");
    assert_eq!(catalogue.nearest_cover("gravle"), Some("gravel"));
}

#[test]
fn seven_adult_birches_are_seven_different_birches() {
    let birch = Catalogue::built_in().find("birch", "adult").expect("a birch");
    let all: Vec<_> = (0..7).map(|i| birch.entry.appearance(birch.variant, i)).collect();
    for (i, a) in all.iter().enumerate() {
        assert!((0.9..=1.1).contains(&a.height) && (0.9..=1.1).contains(&a.crown) && !a.wrapped);
        for b in &all[..i] {
            let apart = (a.height - b.height).abs().max((a.crown - b.crown).abs()).max((a.aspect - b.aspect).abs());
            assert!(apart > 0.03 && a.seed != b.seed, "{a:?} {b:?}");
        }
    }
    let beyond = birch.entry.appearance(birch.variant, 9);
    assert!(beyond.wrapped && beyond.index == 2 && beyond.seed == all[2].seed);
    let bench = Catalogue::built_in().find("bench", "").expect("a bench");
    assert_eq!(bench.entry.appearance(bench.variant, 0).height, 1.0);
}

#[test]
fn users_add_and_change_elements() {
    let (catalogue, found) = extended(
        r##"
        [plant.betula-pendula]
        code = "SBI"
        symbol = "broadleaf"
        types.adult = { height = 24 }
        types.ancient = { age = 100, height = 25, crown_diameter = 12 }

        [plant.quercus-ilex]
        category = "oak"
        species = "Quercus ilex"
        growth.rate = { slow = [1, 2] }
        types.evergreen = { age = 60, height = 15, crown_radius = 6 }

        [object.bench-louis]
        category = "bench"
        types.louis = { size = [2.2, 1.0, 0.7] }

        [cover.gravel]
        fill = "#eee"

        [cover.crushed_tile]
        "##,
    );
    assert_eq!(found, []);
    let birch = catalogue.find("birch", "adult").expect("a birch");
    let figures = birch.variant.plant.expect("figures");
    assert_eq!((figures.height, figures.crown_radius, &*birch.entry.code), (24.0, 4.2, "SBI"));
    assert_eq!(birch.variant.symbol, PlantSymbol::Broadleaf);
    let ancient = catalogue.find("birch", "ancient").expect("a type").variant.plant.expect("figures");
    assert_eq!((ancient.crown_radius, ancient.spacing_radius), (6.0, 6.0));
    assert_eq!(&*catalogue.find("oak", "evergreen").expect("an oak").entry.species, "Quercus ilex");
    assert_eq!(&*catalogue.find("oak", "adult").expect("an oak").entry.species, "Quercus robur");
    assert!(catalogue.by_id("quercus-ilex").expect("an oak").growth.contains_key("rate"));
    assert_eq!(catalogue.find("bench", "louis").expect("a bench").variant.size, [2.2, 1.0, 0.7]);
    assert_eq!(&*catalogue.cover("gravel").expect("gravel").material.label, "Gravel");
    assert_eq!(&*catalogue.cover("crushed tile").expect("a cover").material.label, "Crushed tile");
    assert_eq!(Catalogue::built_in().find("birch", "adult").expect("a birch").variant.size[1], 20.0);
}

#[test]
fn every_mistake_is_named_with_its_place() {
    let (catalogue, found) = extended(
        "[plant.acacia]\nkind = \"tee\"\ncolour = \"#fff\"\ncolor = \"green\"\ntypes.adult = { hieght = 3 }\n\
         [object.crate]\ntypes.big = { size = [1, -2, 3] }\n[plants.x]\n[plant.bench]\n",
    );
    let say = |d: &bosquet::diag::Diagnostic| format!("{:?} {} {}", d.place, d.message, d.hints.join(" "));
    let all = found.iter().map(say).collect::<Vec<_>>().join("\n");
    for expected in [
        "site/plants.toml:2:8",
        "plant `acacia`: `kind` must be one of `tree`, `shrub`",
        "did you mean `tree`?",
        "there is no key `colour` here did you mean `color`?",
        "`color` must be a colour like `#9bb86b`, not `\"green\"`",
        "plant `acacia`, type `adult`: it needs a `height` and a `crown_radius`",
        "there is no key `hieght` here did you mean `height`?",
        "object `crate`, type `big`: `size` must be three lengths",
        "there is no key `plants` here did you mean `plant`?",
        "`bench` is an object already",
    ] {
        assert!(all.contains(expected), "missing: {expected}\n{all}");
    }
    assert!(catalogue.by_id("acacia").is_none() && catalogue.by_id("crate").is_none());
}

#[test]
fn broken_text_keeps_the_rest() {
    let (catalogue, found) = extended("[cover.moss]\nlabel = \"Moss\"\nfill = \n[cover.fern]\nlabel = \"Fern\"\n");
    assert!(found[0].message.len() > 3 && format!("{:?}", found[0].place).contains("plants.toml:3"), "{found:?}");
    assert!(catalogue.cover("fern").is_some());
    let (_, found) = Catalogue::built_in().extended("a.toml", b"\xff\xfe", &MemoryWorld::default());
    assert!(found[0].message.contains("not UTF-8"));
}

/// A glTF with one box of 1 × 2 × 3, scaled twice and turned a quarter about y.
const BOX: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"scale":[2,2,2],"rotation":[0,0.7071067811865476,0,0.7071067811865476],"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,2,3]}]}"#;

#[test]
fn models_give_their_size() {
    let world = MemoryWorld::default()
        .with("site/models/box.gltf", BOX)
        .with("site/stone.obj", "mtllib none.mtl\nv -1 0 -1\nv 1 0 -1\nv 0 0.5 1\nf 1 2 3\n");
    let text = "[object.box]\ntypes.a = { model = \"models/box.gltf\" }\n\
                [object.stone]\nmodel = \"stone.obj\"\ntypes.b = {}\n\
                [object.lost]\ntypes.c = { model = \"lost.glb\" }\n\
                [plant.own]\ntypes.adult = { model = \"stone.obj\" }\n";
    let (catalogue, found) = Catalogue::built_in().extended("site/a.toml", text.as_bytes(), &world);
    let size = catalogue.by_id("box").expect("a box").usual().size;
    assert!((size[0] - 6.0).abs() < 1e-6 && (size[1] - 4.0).abs() < 1e-6 && (size[2] - 2.0).abs() < 1e-6, "{size:?}");
    let stone = catalogue.by_id("stone").expect("a stone").usual();
    assert_eq!((stone.size, &*stone.model), ([2.0, 0.5, 2.0], "site/stone.obj"));
    let own = catalogue.find("own", "").expect("a plant").variant.plant.expect("figures");
    assert_eq!((own.height, own.crown_radius), (0.5, 1.0));
    assert!(found.iter().any(|d| d.message.contains("there is no file `site/lost.glb`")), "{found:#?}");
}

/// The same as a binary file.
fn binary() -> Vec<u8> {
    let json = format!("{BOX:<width$}", width = BOX.len().next_multiple_of(4));
    let words = [0x4654_6c67_u32, 2, json.len() as u32 + 20, json.len() as u32, 0x4e4f_534a];
    words.iter().flat_map(|word| word.to_le_bytes()).chain(json.bytes()).collect()
}

#[test]
fn binary_models_are_read_and_broken_ones_refused() {
    let read = |bytes: &[u8]| {
        let world = MemoryWorld::default().with("m.glb", bytes);
        Catalogue::built_in().extended("a.toml", b"[object.m]\ntypes.a = { model = \"m.glb\" }", &world)
    };
    let whole = binary();
    let (catalogue, found) = read(&whole);
    assert!(found.is_empty() && (catalogue.by_id("m").expect("m").usual().size[0] - 6.0).abs() < 1e-6, "{found:?}");
    for at in 0..whole.len().min(60) {
        for byte in [0, 1, 0x7f, 0xff] {
            let mut broken = whole.clone();
            broken[at] = byte;
            read(&broken);
        }
        assert!(!read(&whole[..at]).1.is_empty());
    }
}

proptest! {
    #[test]
    fn no_text_and_no_model_panics(text in "\\PC{0,200}", cut in 0usize..400, byte in any::<u8>()) {
        extended(&text);
        extended(&format!("[plant.x]\ntypes.adult = {text}"));
        let mut model = BOX.as_bytes().to_vec();
        let at = cut.min(model.len() - 1);
        model[at] = byte;
        let files = [("m.gltf", &model[..]), ("m.glb", &model[..]), ("n.gltf", &model[..at]), ("m.obj", text.as_bytes())];
        for (name, bytes) in files {
            let world = MemoryWorld::default().with(name, bytes);
            let text = format!("[object.m]\ntypes.a = {{ model = \"{name}\" }}");
            Catalogue::built_in().extended("a.toml", text.as_bytes(), &world);
        }
    }
}
