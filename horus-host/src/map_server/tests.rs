//! Reading and saving against files that the tests make, and against wrong ones.

use std::fs;
use std::path::{Path, PathBuf};

use super::{ImageFormat, MapFile, MapFileError, MapMode, MapYaml, save};

/// A directory that is gone after the test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("horus-map-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn write(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, bytes).unwrap();
        path
    }

    /// A map of the given image, with lines in front of the usual ones.
    fn map(&self, keys: &str, image: &[u8]) -> Result<MapFile, MapFileError> {
        self.write("image", image);
        let text = format!(
            "{keys}\nimage: image\nresolution: 0.5\norigin: [1, 2.5, 0]\nfree_thresh: 0.25\noccupied_thresh: 0.65\n"
        );
        load(&self.write("map.yaml", text.as_bytes()))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn load(path: &Path) -> Result<MapFile, MapFileError> {
    MapFile::load(path, &mut |_, _| {})
}

fn cells(keys: &str, image: &[u8]) -> Vec<i8> {
    let scratch = Scratch::new(&format!("cells-{:x}", keys.len() * 1000 + image.len()));
    scratch.map(keys, image).unwrap().cells
}

#[test]
fn the_top_row_of_the_image_is_the_highest_y() {
    let image = b"P2 # a comment\n2 3 255\n0 255  254 205\n 0 0";
    assert_eq!(cells("negate: 0", image), [100, 100, 0, 0, 100, 0].map(|v| v));
    let image = b"P5\n# made by hand\n2 2\n255\n\x00\xff\xff\x00";
    assert_eq!(cells("negate: false", image), [0, 100, 100, 0]);
    assert_eq!(cells("negate: true", image), [100, 0, 0, 100]);
}

#[test]
fn modes_turn_shades_into_values() {
    // 205 is 0.196 in nav2's default, which is free up to 0.25; 128 lies between the thresholds.
    let image = b"P5 5 1 255\n\x00\x80\xcd\xff\x64";
    assert_eq!(cells("mode: Trinary\nnegate: 0", image), [100, -1, 0, 0, -1]);
    assert_eq!(cells("mode: SCALE\nnegate: 0", image), [100, 62, 0, 0, 89]);
    assert_eq!(cells("mode: raw\nnegate: 0", image), [0, -1, -1, -1, 100]);
}

#[test]
fn deep_and_shallow_pgm_images_are_scaled_to_eight_bits() {
    assert_eq!(
        cells("mode: raw\nnegate: 0", b"P5 2 1 65535\n\x00\x00\x40\x00"),
        [0, 64]
    );
    assert_eq!(cells("mode: raw\nnegate: 0", b"P2 3 1 15\n0 3 15"), [0, 51, -1]);
}

/// A PNG of the given colour type, from rows of samples.
fn png(color: ::png::ColorType, width: u32, samples: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let height = samples.len() / color.samples() / width as usize;
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height as u32);
    encoder.set_color(color);
    encoder.write_header().unwrap().write_image_data(samples).unwrap();
    bytes
}

#[test]
fn transparent_pixels_are_unknown_except_in_raw_mode() {
    use ::png::ColorType::{GrayscaleAlpha, Rgb, Rgba};
    let image = png(GrayscaleAlpha, 3, &[0, 255, 0, 254, 255, 0]);
    assert_eq!(cells("negate: 0", &image), [100, -1, -1]);
    assert_eq!(cells("mode: scale\nnegate: 0", &image), [100, -1, -1]);
    assert_eq!(cells("mode: raw\nnegate: 0", &image), [0, 0, -1]);
    let image = png(Rgba, 2, &[0, 0, 0, 255, 0, 0, 0, 0]);
    assert_eq!(cells("negate: 0", &image), [100, -1]);
    // Luma of green is 182, of red 54, of blue 18.
    let image = png(Rgb, 3, &[0, 255, 0, 255, 0, 0, 0, 0, 255]);
    assert_eq!(cells("mode: raw\nnegate: 0", &image), [-1, 54, 18]);
}

#[test]
fn what_is_saved_reads_back() {
    let scratch = Scratch::new("saved");
    let path = scratch.0.join("room.yaml");
    let all: Vec<i8> = (-1..=100).collect();
    let three: Vec<i8> = all
        .iter()
        .map(|value| [-1, 0, 100][(value % 3).unsigned_abs() as usize])
        .collect();
    for (mode, format, cells) in [
        (MapMode::Trinary, ImageFormat::Pgm, &three),
        (MapMode::Trinary, ImageFormat::Png, &three),
        (MapMode::Scale, ImageFormat::Png, &all),
        (MapMode::Raw, ImageFormat::Pgm, &all),
        (MapMode::Raw, ImageFormat::Png, &all),
    ] {
        for negate in [false, true] {
            let yaml = MapYaml {
                negate,
                ..MapYaml::new(0.05, [-1.5, 2.0, 0.25], mode)
            };
            save(&path, &yaml, (17, 6), cells, format).unwrap();
            let map = load(&path).unwrap();
            assert_eq!(map.cells, *cells, "{mode} {format:?} {negate}");
            assert_eq!((map.width, map.height), (17, 6));
            let image = map.yaml.image.clone();
            assert_eq!(map.yaml, MapYaml { image, ..yaml });
        }
    }
    assert_eq!(
        fs::read_dir(&scratch.0).unwrap().count(),
        3,
        "one text, two images, nothing half-written"
    );
}

#[test]
fn saved_shades_are_those_of_nav2() {
    let scratch = Scratch::new("shades");
    let yaml = MapYaml::new(0.05, [0.0; 3], MapMode::Trinary);
    let cells = [0, 100, -1, 19, 20, 64, 65, 50];
    save(&scratch.0.join("m.yaml"), &yaml, (8, 1), &cells, ImageFormat::Pgm).unwrap();
    let image = fs::read(scratch.0.join("m.pgm")).unwrap();
    assert_eq!(image, b"P5\n8 1\n255\n\xfe\x00\xcd\xfe\xcd\xcd\x00\xcd");
    let text = fs::read_to_string(scratch.0.join("m.yaml")).unwrap();
    assert!(
        text.contains("occupied_thresh: 0.65\nfree_thresh: 0.196\n"),
        "{text}"
    );
}

#[test]
fn unknown_cells_of_a_scale_map_need_a_png() {
    let scratch = Scratch::new("alpha");
    let (path, yaml) = (
        scratch.0.join("m.yaml"),
        MapYaml::new(0.05, [0.0; 3], MapMode::Scale),
    );
    let refused = save(&path, &yaml, (2, 1), &[-1, 0], ImageFormat::Pgm);
    assert!(matches!(refused, Err(MapFileError::NeedsAlpha)));
    let refused = save(&path, &yaml, (2, 2), &[-1, 0], ImageFormat::Png);
    assert!(matches!(refused, Err(MapFileError::WrongLength { .. })));
    assert_eq!(fs::read_dir(&scratch.0).unwrap().count(), 0);
}

#[test]
fn wrong_texts_are_refused_with_their_place() {
    let scratch = Scratch::new("texts");
    let good = "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nfree_thresh: 0.2\noccupied_thresh: 0.65\nnegate: 0\n";
    let changed = |from: &str, to: &str| {
        assert!(good.contains(from));
        good.replace(from, to)
    };
    scratch.write("m.pgm", b"P5 1 1 255\n\x00");
    assert!(load(&scratch.write("m.yaml", good.as_bytes())).is_ok());
    assert!(load(&scratch.write("m.yaml", format!("{good}extra: [1, {{a: b}}]\n").as_bytes())).is_ok());
    for (text, word) in [
        (String::new(), "one mapping of keys"),
        (changed("image: m.pgm\n", ""), "image: the key is missing"),
        (changed("negate: 0\n", ""), "negate: the key is missing"),
        (changed("negate: 0", "negate: 2"), "line 6: negate: "),
        (
            changed("negate: 0", "negate: maybe"),
            "line 6: negate: 0, 1, true or false",
        ),
        (changed("0.05", "0"), "line 2: resolution: a length above zero"),
        (changed("0.05", "-0.05"), "resolution"),
        (
            changed("0.05", "'0.05'"),
            "line 2: resolution: a number is expected",
        ),
        (
            changed("0.05", "[0.05]"),
            "line 2: resolution: a number is expected",
        ),
        (changed("0.05", ""), "line 2: resolution: a number is expected"),
        (changed("0.05", ".nan"), "resolution"),
        (changed("0.05", "1e-60"), "resolution"),
        (
            changed("0.05", "wide"),
            "line 2: resolution: a number is expected, not wide",
        ),
        (
            changed("[0, 0, 0]", "[0, 0]"),
            "line 3: origin: three numbers are expected, not 2",
        ),
        (changed("[0, 0, 0]", "[0, 0, .inf]"), "finite"),
        (changed("[0, 0, 0]", "[0, 0, 0"), "line"),
        (
            changed("[0, 0, 0]", "[0, 0, [0]]"),
            "line 3: origin: a list of numbers",
        ),
        (changed("[0, 0, 0]", "0"), "line 3: origin: a list of numbers"),
        (
            changed("0.65", ".nan"),
            "line 5: occupied_thresh: a finite number",
        ),
        (changed("image: m.pgm", "image: ''"), "line 1: image: a file"),
        (changed("image: m.pgm", "image: other.pgm"), "other.pgm"),
        (format!("{good}mode: binary\n"), "trinary, scale or raw"),
        (
            format!("{good}negate: 1\n"),
            "line 7: negate: the key is given twice, first in line 6",
        ),
    ] {
        let path = scratch.write("m.yaml", text.as_bytes());
        let error = load(&path).unwrap_err().to_string();
        assert!(error.contains(word), "{word}: {error}");
        assert!(error.contains(scratch.0.to_str().unwrap()), "{error}");
    }
}

#[test]
fn wrong_images_are_refused() {
    let scratch = Scratch::new("images");
    let interrupted = &png(::png::ColorType::Grayscale, 40, &[7; 1600])[..60];
    for (image, word) in [
        (&b""[..], "neither"),
        (b"BM\x76\x01", "neither"),
        (b"P5", "too early"),
        (b"P5 2 2 255\n\x00\x00\x00", "too early"),
        (b"P2 2 2 255\n0 0 0", "too early"),
        (b"P2 1 1 255\nx", "a number is expected"),
        (b"P2 1 1 255\n-1", "a number is expected"),
        (b"P2 1 1 100\n101", "brighter"),
        (b"P5 1 1 0\n\x00", "1 to 65535"),
        (b"P5 1 1 65536\n\x00", "1 to 65535"),
        (b"P5 0 1 255\n", "not possible"),
        (b"P5 4097 4096 255\n", "not possible"),
        (b"P5 4294967295 4294967295 255\n", "not possible"),
        (b"P5 99999999999 1 255\n", "a number is expected"),
        (b"P5 9999999999 1 255\n", "too large"),
        (b"\x89PNG\r\n\x1a\n", ""),
        (interrupted, ""),
    ] {
        let error = scratch.map("negate: 0", image).unwrap_err().to_string();
        assert!(error.contains(word), "{word}: {error}");
        assert!(error.contains("image"), "{error}");
    }
}

#[test]
fn random_damage_is_an_error_or_a_map() {
    let scratch = Scratch::new("damage");
    let good = [
        b"P2\n# c\n3 2\n255\n0 10 255 100 7 3\n".to_vec(),
        b"P5\n3 2\n255\n\x00\x0a\xff\x64\x07\x03".to_vec(),
        png(::png::ColorType::GrayscaleAlpha, 3, &[9; 12]),
    ];
    let mut random = rand_pcg::Pcg32::new(7, 1);
    use rand_pcg::rand_core::RngCore;
    for round in 0..1500 {
        let mut image = good[round % 3].clone();
        let at = random.next_u32() as usize % image.len();
        match random.next_u32() % 3 {
            0 => image[at] ^= 1 << (random.next_u32() % 8),
            1 => image.truncate(at),
            _ => image.insert(at, random.next_u32() as u8),
        }
        if let Ok(map) = scratch.map("negate: 0", &image) {
            assert_eq!(
                map.cells.len() as u64,
                u64::from(map.width) * u64::from(map.height)
            );
        }
    }
}

/// The counts of nav2's own maps, where they are.
#[test]
fn real_maps_have_their_counts() {
    let maps = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/maps");
    if !maps.exists() {
        eprintln!("skipped: {} is absent", maps.display());
        return;
    }
    for (name, counts) in [
        ("turtlebot3_world", &[(-1, 138_683), (0, 7903), (100, 870)][..]),
        ("TenByTen", &[(-1, 2), (0, 78), (100, 20)]),
        (
            "depot_speed",
            &[(0, 123_746), (20, 4228), (25, 25_017), (50, 28_702), (100, 3735)],
        ),
    ] {
        let map = load(&maps.join(name).with_extension("yaml")).unwrap();
        let found: Vec<_> = map.counts().into_iter().collect();
        assert_eq!(found, counts, "{name}");
    }
}
