//! One suite for everything that is an `OccupancyGrid2d`: all its answers follow from size, place and values.

use horus_core::grid::{
    DenseGrid2, Frame, GridView, HorusValues, LinearGrid2, Local, LocalMapValues, OccupancyGrid2d,
    RegularGrid, TrinaryValues, ValueTraits,
};
use horus_core::nalgebra::{Point2, Vector2};
use horus_core::prelude::*;
use horus_host::reference;
use proptest::prelude::*;

/// What a cell is, whatever value says so.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Free,
    Occupied,
    Unknown,
    Other,
}

/// A grid's description.
#[derive(Clone, Debug)]
struct Picture {
    width: u32,
    resolution: f32,
    origin: Pose2D,
    kinds: Vec<Kind>,
}

impl Picture {
    fn height(&self) -> u32 {
        self.kinds.len() as u32 / self.width
    }

    fn kind(&self, x: i64, y: i64) -> Option<Kind> {
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height())).contains(&y);
        inside.then(|| self.kinds[(y * i64::from(self.width) + x) as usize])
    }

    fn values<T>(&self, value: impl Fn(Kind) -> T) -> Vec<T> {
        self.kinds.iter().map(|kind| value(*kind)).collect()
    }
}

fn kind_of<G: OccupancyGrid2d>(grid: &G, value: G::Data) -> Kind {
    let values = grid.value_traits();
    match (
        values.is_free(value),
        values.is_occupied(value),
        values.is_unknown(value),
    ) {
        (true, false, false) => Kind::Free,
        (false, true, false) => Kind::Occupied,
        (false, false, true) => Kind::Unknown,
        (false, false, false) => Kind::Other,
        overlap => panic!("{overlap:?}"),
    }
}

/// Holds a grid against its description, by every method of the traits.
fn conforms<G: OccupancyGrid2d>(grid: &G, picture: &Picture) {
    let (width, height) = (picture.width, picture.height());
    assert_eq!((grid.width(), grid.height()), (width, height));
    assert_eq!(grid.size(), picture.kinds.len());
    assert_eq!(grid.resolution(), picture.resolution);
    for y in -2..i64::from(height) + 2 {
        for x in -2..i64::from(width) + 2 {
            cell_conforms(grid, picture, (x as i32, y as i32));
        }
    }
    for cell in [(i32::MIN, 0), (0, i32::MIN), (i32::MAX, i32::MAX), (-1, i32::MAX)] {
        assert!(
            !grid.contains(cell) && !grid.free_at(cell) && grid.data_at(cell).is_none(),
            "{cell:?}"
        );
        assert!(grid.neighborhood4(cell).next().is_none(), "{cell:?}");
    }
    for index in [grid.size(), grid.size() + 1, usize::MAX] {
        assert!(!grid.contains(index) && !grid.free_at(index) && grid.data_at(index).is_none());
        assert!(grid.coordinates_at(index, Frame::Global).is_none());
        assert!(grid.neighborhood4(index).next().is_none());
    }
    let which = |kind: Kind| picture.values(|k| k == kind);
    assert!(grid.obstacle_data().eq(which(Kind::Occupied)));
    assert_eq!(grid.obstacle_data().len(), grid.size());
    assert!(grid.unknown_mask().eq(which(Kind::Unknown)));
    let free = (0..grid.size()).filter(|i| picture.kinds[*i] == Kind::Free);
    assert!(grid.free_cells().eq(free));
    let by_index = grid.coordinates_for(grid.free_cells(), Frame::Global);
    let cells = grid
        .free_cells()
        .map(|i| Vector2::new((i as u32 % width) as i32, (i as u32 / width) as i32));
    assert!(by_index.eq(grid.coordinates_for(cells, Frame::Global)));
    for nowhere in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 3e38] {
        assert_eq!(grid.cell_near((nowhere, 0.0)), None);
        assert!(!grid.free_near((0.0, nowhere)) && grid.data_near((0.0, nowhere)).is_none());
    }
}

/// All that is to be said about one cell, inside or outside.
fn cell_conforms<G: OccupancyGrid2d>(grid: &G, picture: &Picture, (x, y): (i32, i32)) {
    let cell = Vector2::new(x, y);
    let around = |dx: i32, dy: i32| picture.kind((x + dx).into(), (y + dy).into());
    let kind = around(0, 0);
    assert_eq!(grid.contains(cell), kind.is_some(), "{cell:?}");
    assert_eq!(grid.data_at((x, y)).map(|v| kind_of(grid, v)), kind, "{cell:?}");
    assert_eq!(grid.free_at(cell), kind == Some(Kind::Free), "{cell:?}");
    let sides = [(1, 0), (0, 1), (-1, 0), (0, -1)];
    let neighbours = sides
        .into_iter()
        .filter(|(dx, dy)| kind.and(around(*dx, *dy)).is_some());
    let neighbours: Vec<_> = neighbours.map(|(dx, dy)| Vector2::new(x + dx, y + dy)).collect();
    assert!(
        grid.neighborhood4(cell).eq(neighbours.iter().copied()),
        "{cell:?}"
    );

    // A cell's centre lies in it, in either frame and as any kind of point.
    let local = grid.coordinates_at(cell, Local).expect("any cell has a centre");
    assert_eq!(grid.coordinates_at((x, y), Frame::Local), Some(local));
    let global = grid
        .coordinates_at(cell, Frame::Global)
        .expect("any cell has a centre");
    assert_eq!(
        global,
        grid.origin() * Point2::from(local) - Point2::origin(),
        "global = origin * local"
    );
    assert_eq!(grid.cell_near(local), Some(cell));
    assert_eq!(grid.cell_near(Point2::from(local)), Some(cell));
    assert_eq!(grid.cell_near(grid.local_from_global(global)), Some(cell));
    assert_eq!(grid.free_near((local.x, local.y)), grid.free_at(cell));

    let index = grid.index_at((x, y));
    assert_eq!(index.is_some(), kind.is_some(), "{cell:?}");
    let Some(i) = index else { return };
    assert_eq!(i, y as usize * picture.width as usize + x as usize);
    assert_eq!(grid.index_at(i), Some(i));
    assert_eq!(grid.coordinates_at(i, Frame::Global), Some(global));
    assert_eq!(grid.data_at(i).map(|v| kind_of(grid, v)), kind);
    assert_eq!(grid.free_at(i), grid.free_at(cell));
    let indices = neighbours
        .iter()
        .map(|c| grid.index_at(*c).expect("a neighbour lies inside"));
    assert!(grid.neighborhood4(i).eq(indices));
    let edge = kind == Some(Kind::Occupied) && neighbours.iter().any(|c| grid.free_at(*c));
    assert_eq!(grid.obstacle_edge_mask().nth(i), Some(edge));
}

fn picture() -> impl Strategy<Value = Picture> {
    let kind = prop_oneof![
        Just(Kind::Free),
        Just(Kind::Occupied),
        Just(Kind::Unknown),
        Just(Kind::Other)
    ];
    let place = (-20.0f32..20.0, -20.0f32..20.0, -4.0f32..4.0).prop_map(|(x, y, a)| Pose2D::new(x, y, a));
    let size = (1u32..9, 0u32..9);
    (size, 0.02f32..0.6, place).prop_flat_map(move |((width, height), resolution, origin)| {
        let kinds = prop::collection::vec(kind.clone(), (width * height) as usize);
        kinds.prop_map(move |kinds| Picture {
            width,
            resolution,
            origin,
            kinds,
        })
    })
}

/// Values of an `OccupancyGrid`, where nothing is of no meaning.
fn horus(kind: Kind) -> i8 {
    match kind {
        Kind::Free => 49,
        Kind::Occupied | Kind::Other => 50,
        Kind::Unknown => -1,
    }
}

fn trinary(kind: Kind) -> i8 {
    match kind {
        Kind::Free => 0,
        Kind::Occupied => 100,
        Kind::Unknown => -1,
        Kind::Other => 50,
    }
}

fn local_map(kind: Kind) -> u8 {
    match kind {
        Kind::Free => 255,
        Kind::Occupied => 0,
        Kind::Unknown => 128,
        Kind::Other => 254,
    }
}

/// The picture that an `OccupancyGrid` shows.
fn as_horus(picture: &Picture) -> Picture {
    let kinds = picture.values(|kind| if kind == Kind::Other { Kind::Occupied } else { kind });
    Picture {
        kinds,
        ..picture.clone()
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    #[test]
    fn borrowed_grids_of_every_kind_of_value(picture in picture()) {
        let Picture { width, resolution, origin, .. } = picture;
        let height = picture.height();
        let cells = picture.values(trinary);
        let view = GridView::new(&cells, width, height, resolution, origin, TrinaryValues).unwrap();
        conforms(&view, &picture);
        let cells = picture.values(local_map);
        let view = GridView::new(&cells, width, height, resolution, origin, LocalMapValues).unwrap();
        conforms(&view, &picture);
        let cells = picture.values(horus);
        let view = GridView::new(&cells, width, height, resolution, origin, HorusValues).unwrap();
        conforms(&view, &as_horus(&picture));
    }

    #[test]
    fn occupancy_grids_over_every_storage(picture in picture()) {
        let Picture { width, resolution, origin, .. } = picture;
        let (height, values) = (picture.height(), picture.values(horus));
        let picture = as_horus(&picture);
        let mut array = [0; 81];
        let mut grid = OccupancyGrid::new_in(&mut array, width, height, resolution, origin).unwrap();
        grid.load(&values).unwrap();
        conforms(&grid, &picture);
        let mut slice = vec![0; values.len() + 3];
        let mut grid = OccupancyGrid::new_in(&mut slice[..], width, height, resolution, origin).unwrap();
        grid.load(&values).unwrap();
        conforms(&grid, &picture);
        let mut grid = OccupancyGrid::new_in(vec![0; values.len()], width, height, resolution, origin).unwrap();
        grid.load(&values).unwrap();
        conforms(&grid, &picture);
        conforms(&OccupancyGrid::view(&values, width, height, resolution, origin).unwrap(), &picture);
    }

    #[test]
    fn the_std_version(picture in picture()) {
        let Picture { width, resolution, origin, .. } = picture;
        let pose = reference::Pose2D::new(origin.x.into(), origin.y.into(), origin.theta.into());
        let mut grid = reference::OccupancyGrid::new(width, picture.height(), resolution, pose);
        grid.data = picture.values(horus);
        conforms(&grid, &as_horus(&picture));
    }

    #[test]
    fn a_window_that_has_moved(picture in picture(), dx in -40i32..40, dy in -40i32..40) {
        let Picture { width, resolution, origin, .. } = picture;
        let mut grid =
            OccupancyGrid::new_in(vec![0; picture.kinds.len()], width, picture.height(), resolution, origin).unwrap();
        let (sin, cos) = origin.theta.sin_cos();
        let along = [dx, dy].map(|cells| cells as f32 * resolution);
        let to = Pose2D::new(
            origin.x + cos * along[0] - sin * along[1],
            origin.y + sin * along[0] + cos * along[1],
            0.0,
        );
        grid.recenter(to).unwrap();
        grid.load(&picture.values(horus)).unwrap();
        conforms(&grid, &as_horus(&picture));
        if let Some((x, y)) = grid.grid_to_world(0, 0) {
            let corner = grid.coordinates_at(0, Frame::Global).unwrap();
            assert!((corner - Vector2::new(x, y)).norm() < 1e-4, "{corner} {x} {y}");
        }
    }
}

#[test]
fn a_prior_map_in_flash() {
    static FLASH: [i8; 6] = [0, 100, -1, 0, 100, 50];
    let picture = Picture {
        width: 3,
        resolution: 0.05,
        origin: Pose2D::default(),
        kinds: vec![
            Kind::Free,
            Kind::Occupied,
            Kind::Unknown,
            Kind::Free,
            Kind::Occupied,
            Kind::Other,
        ],
    };
    conforms(
        &GridView::new(&FLASH, 3, 2, 0.05, Pose2D::default(), TrinaryValues).unwrap(),
        &picture,
    );
    let too_short = GridView::new(&FLASH, 3, 3, 0.05, Pose2D::default(), TrinaryValues);
    assert!(
        matches!(
            too_short,
            Err(Error::BufferTooSmall {
                needed: 9,
                given: 6,
                ..
            })
        ),
        "{too_short:?}"
    );
}

#[test]
fn a_grid_without_cells() {
    let grid = StaticOccupancyGrid::<0>::empty();
    assert_eq!(grid.cell_near((0.0, 0.0)), None);
    assert!(!grid.contains(0_usize) && !grid.contains((0, 0)) && !grid.free_near((0.0, 0.0)));
    assert_eq!(
        grid.free_cells().count() + grid.obstacle_data().len() + grid.obstacle_edge_mask().len(),
        0
    );
    assert!(grid.coordinates_at(0_usize, Frame::Global).is_none());
}
