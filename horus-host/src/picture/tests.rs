use std::path::Path;

use super::{Cells, Picture, PictureError, Rgb, ascii_window, cost_png, occupancy_png, palette};

const WHITE: Rgb = Rgb([255; 3]);
const BLACK: Rgb = Rgb([0; 3]);

/// The picture as characters, the top row first.
fn draw(picture: &Picture, key: &[(Rgb, char)]) -> Vec<String> {
    let symbol = |pixel: &Rgb| {
        let known = key.iter().find(|(colour, _)| colour == pixel);
        known.map_or('?', |&(_, symbol)| symbol)
    };
    let rows = picture.image().rows();
    rows.map(|row| row.iter().map(symbol).collect()).collect()
}

#[test]
fn row_zero_is_at_the_bottom_and_cells_become_squares() {
    let values = [0, 100, -1, 0, 0, 0];
    let cells = Cells::new(3, 2, &values).unwrap();
    let key = [(WHITE, '.'), (BLACK, '#'), (palette::UNKNOWN, '~')];
    let once = Picture::paint(cells, 1, palette::occupancy).unwrap();
    assert_eq!(draw(&once, &key), ["...", ".#~"]);
    let twice = Picture::paint(cells, 2, palette::occupancy).unwrap();
    assert_eq!(draw(&twice, &key), ["......", "......", "..##~~", "..##~~"]);
}

#[test]
fn occupancy_colours() {
    assert_eq!(palette::occupancy(0), WHITE);
    assert_eq!(palette::occupancy(50), Rgb([128; 3]));
    assert_eq!(palette::occupancy(100), BLACK);
    assert_eq!(palette::occupancy(-1), Rgb([0x70, 0x89, 0x86]));
    assert_eq!(palette::occupancy(101), Rgb([0, 255, 0]));
    assert_eq!(palette::occupancy(-2), Rgb([255, 255, 0]));
    assert_eq!(palette::occupancy(-128), Rgb([255, 0, 0]));
}

#[test]
fn cost_colours_for_both_meanings_of_lethal() {
    assert_eq!(palette::cost(0, 254), WHITE);
    assert_eq!(palette::cost(1, 254), Rgb([0, 0, 255]));
    assert_eq!(palette::cost(252, 254), Rgb([255, 0, 0]));
    assert_eq!(palette::cost(253, 254), palette::INSCRIBED);
    assert_eq!(palette::cost(254, 254), palette::LETHAL);
    assert_eq!(palette::cost(253, 253), palette::LETHAL);
    assert_eq!(palette::cost(252, 253), Rgb([255, 0, 0]));
    assert_eq!(palette::cost(100, 100), palette::LETHAL);
    assert_eq!(palette::cost(255, 254), palette::UNKNOWN);
}

#[test]
fn differences_have_a_sign() {
    let (first, second) = ([5_u8, 7, 9], [5_u8, 9, 7]);
    let first = Cells::new(3, 1, &first).unwrap();
    let second = Cells::new(3, 1, &second).unwrap();
    let picture = Picture::paint_difference(first, second, 1).unwrap();
    let key = [
        (palette::EQUAL, '='),
        (palette::difference(std::cmp::Ordering::Less), '<'),
        (palette::difference(std::cmp::Ordering::Greater), '>'),
    ];
    assert_eq!(draw(&picture, &key), ["=<>"]);
}

#[test]
fn bad_shapes_and_scales_are_refused() {
    assert!(matches!(
        Cells::<u8>::new(0, 5, &[]),
        Err(PictureError::Empty { .. })
    ));
    assert!(matches!(
        Cells::new(2, 2, &[1_u8; 3]),
        Err(PictureError::WrongLength { length: 3, .. })
    ));
    assert!(matches!(
        Cells::new(u32::MAX, u32::MAX, &[1_u8]),
        Err(PictureError::WrongLength { .. })
    ));
    let values = [0_i8; 4];
    let square = Cells::new(2, 2, &values).unwrap();
    for scale in [0, 1 << 14, u32::MAX] {
        assert!(matches!(
            Picture::paint(square, scale, palette::occupancy),
            Err(PictureError::BadScale { .. })
        ));
    }
    let line = Cells::new(4, 1, &values).unwrap();
    let error = Picture::paint_difference(square, line, 1).unwrap_err();
    assert_eq!(error.to_string(), "grids of 2x2 and 4x1 cells cannot be compared");
}

#[test]
fn files_are_written_and_failures_name_the_path() {
    let folder = std::env::temp_dir().join(format!("horus-picture-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let values = [0, 100, -1, 50];
    let cells = Cells::new(2, 2, &values).unwrap();
    let file = folder.join("map.png");
    occupancy_png(&file, cells, 3).unwrap();
    let source = std::io::BufReader::new(std::fs::File::open(&file).unwrap());
    let mut reader = png::Decoder::new(source).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.width, info.height), (6, 6));
    let painted = Picture::paint(cells, 3, palette::occupancy).unwrap();
    assert_eq!(bytes, painted.image().to_bytes());
    std::fs::remove_dir_all(&folder).unwrap();

    let missing = Path::new("/no/such/folder/cost.png");
    let costs = Cells::new(1, 1, &[7_u8]).unwrap();
    let error = cost_png(missing, costs, 254, 1).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("cannot write the picture /no/such/folder/cost.png: ")
    );
}

#[test]
fn marks_are_drawn_in_cell_coordinates_and_clipped() {
    let red = Rgb([255, 0, 0]);
    let key = [(WHITE, '.'), (red, 'x')];
    let values = [0; 25];
    let cells = Cells::new(5, 5, &values).unwrap();
    let blank = Picture::paint(cells, 1, palette::occupancy).unwrap();

    let mut picture = blank.clone();
    picture.mark_point(0.5, 0.5, 1, red);
    picture.mark_point(4.5, 3.5, 0, red);
    assert_eq!(
        draw(&picture, &key),
        [".....", "....x", ".....", "xx...", "xx..."]
    );

    let mut picture = blank.clone();
    picture.mark_robot(1.5, 2.5, 0.0, 1.0, red);
    assert_eq!(
        draw(&picture, &key),
        [".....", ".x...", "xxxx.", ".x...", "....."]
    );

    let mut picture = blank.clone();
    for at in [-7.0, 1e30, f64::NAN, f64::INFINITY] {
        picture.mark_point(at, 2.5, 1, red);
        picture.mark_point(2.5, at, 1, red);
        picture.mark_robot(at, 2.5, 0.0, 1.0, red);
        picture.mark_robot(2.5, 2.5, 0.0, -1.0, red);
    }
    assert_eq!(draw(&picture, &key), draw(&blank, &key));
    picture.mark_robot(2.5, 2.5, 0.0, 1e30, red);
    assert_eq!(draw(&picture, &key), ["xxxxx"; 5]);
}

#[test]
fn ascii_windows_are_cut_at_the_border() {
    let corner = ascii_window(4, 3, (3, 0), 1, |gx, gy| {
        char::from_digit(gx + gy, 10).unwrap_or('?')
    });
    assert_eq!(corner, "1  3 4\n0  2[3]\ngx 2..=3\n");
    let all = ascii_window(2, 2, (0, 1), u32::MAX, |_, _| '.');
    assert_eq!(all, "1 [.].\n0  . .\ngx 0..=1\n");
    for center in [(9, 0), (0, 9), (u32::MAX, u32::MAX)] {
        assert_eq!(ascii_window(4, 3, center, 2, |_, _| '.'), "");
    }
    assert_eq!(ascii_window(0, 0, (0, 0), 2, |_, _| '.'), "");
}
