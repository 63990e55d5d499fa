//! Distance maps against looking from every cell at every other.

use horus_core::distance::{
    DistanceBuffers, DistanceCell, DistanceMap, DistanceOptions, EnvelopeVertex, MAX_SIDE, UnknownAs,
};
use horus_core::grid::{DenseGrid2, GridView, HorusValues};
use horus_core::prelude::*;
use horus_host::reference::{signed_squared_distances, squared_distances};
use proptest::prelude::*;

/// A map with its buffers, each as long as it must be and no longer.
struct Owned<D> {
    cells: Vec<D>,
    vertices: Vec<EnvelopeVertex>,
}

impl<D: DistanceCell> Owned<D> {
    fn new(cells: usize, columns: u32) -> Self {
        let vertices = columns as usize * if D::SIGNED { 2 } else { 1 };
        Self {
            cells: vec![D::default(); cells],
            vertices: vec![EnvelopeVertex::EMPTY; vertices],
        }
    }

    fn map(&mut self) -> DistanceMap<'_, D> {
        DistanceMap::new_in(DistanceBuffers {
            cells: &mut self.cells,
            vertices: &mut self.vertices,
        })
    }
}

fn signed<D: DistanceCell>(cell: &D) -> i64 {
    let squared = i64::from(cell.squared());
    if cell.is_obstacle() { -squared } else { squared }
}

#[derive(Clone, Debug)]
struct Case {
    width: u32,
    values: Vec<i8>,
    options: DistanceOptions,
}

impl Case {
    fn grid(&self) -> GridView<'_, HorusValues> {
        let height = self.values.len() as u32 / self.width;
        GridView::new(
            &self.values,
            self.width,
            height,
            0.05,
            Pose2D::default(),
            HorusValues,
        )
        .unwrap()
    }

    fn expected(&self, signed: bool, max: u32) -> Vec<i64> {
        let obstacle = |v: &i8| *v >= 50 || (*v < 0 && self.options.unknown == UnknownAs::Obstacle);
        let mask: Vec<bool> = self.values.iter().map(obstacle).collect();
        let cap = self.options.max_squared.unwrap_or(max).min(max);
        if signed {
            return signed_squared_distances(&mask, self.width as usize, cap);
        }
        let squared = squared_distances(&mask, self.width as usize, cap).into_iter();
        squared.map(i64::from).collect()
    }

    /// Whole map, window, and in parts: everything equals brute force.
    fn check<D: DistanceCell>(&self, window: CellRect, step: u32) {
        let grid = self.grid();
        let expected = self.expected(D::SIGNED, D::MAX_SQUARED);
        let mut owned = Owned::<D>::new(self.values.len(), self.width);
        let mut map = owned.map();
        map.compute(&grid, self.options).unwrap();
        assert_eq!(map.squared().iter().map(signed).collect::<Vec<_>>(), expected);
        let metres = map.metres().zip(&expected);
        for (metres, squared) in metres {
            let exact = 0.05 * (squared.unsigned_abs() as f64).sqrt() * squared.signum() as f64;
            assert!(
                (f64::from(metres) - exact).abs() <= 1e-6 * exact.abs(),
                "{metres} {exact}"
            );
        }
        self.check_nearest(&map);

        let region = DistanceMap::<D>::region(&grid, window, self.options).unwrap();
        let mut owned = Owned::<D>::new((region.width() * region.height()) as usize, region.width());
        let mut map = owned.map();
        map.begin_window(&grid, window, self.options).unwrap();
        let mut left = 2 * region.height();
        while left > 0 {
            assert!(map.squared().is_empty() || window.width() * window.height() == 0 || map.advance(0) == 0);
            let now = map.advance(step);
            assert!(now == 0 || now + step <= left, "{now} rows left of {left}");
            left = now;
        }
        for gy in 0..=grid.height() {
            for gx in 0..=self.width {
                let found = map.squared_at(gx, gy).map(|d| signed(&d));
                let inside = window.contains(gx, gy);
                assert_eq!(
                    found,
                    inside.then(|| expected[(gy * self.width + gx) as usize]),
                    "{gx} {gy}"
                );
            }
        }
        self.check_nearest(&map);
    }

    /// The nearest obstacle is one, lies at that distance, and has the lowest index of those that do.
    fn check_nearest<D: DistanceCell>(&self, map: &DistanceMap<'_, D>) {
        let grid = self.grid();
        let unsigned = self.expected(false, D::MAX_SQUARED);
        let obstacles: Vec<usize> = (0..self.values.len())
            .filter(|i| {
                self.values[*i] >= 50 || (self.values[*i] < 0 && self.options.unknown == UnknownAs::Obstacle)
            })
            .collect();
        for (i, squared) in unsigned.iter().enumerate() {
            let (gx, gy) = (i as u32 % self.width, i as u32 / self.width);
            let at = |o: usize| {
                let (x, y) = (o as i64 % i64::from(self.width), o as i64 / i64::from(self.width));
                (x - i64::from(gx)).pow(2) + (y - i64::from(gy)).pow(2)
            };
            let nearest = obstacles.iter().find(|o| at(**o) == *squared);
            let nearest = nearest.map(|o| (*o as u32 % self.width, *o as u32 / self.width));
            let expected = map.squared_at(gx, gy).and(nearest);
            assert_eq!(map.nearest_obstacle(&grid, gx, gy), expected, "{gx} {gy}");
        }
    }
}

fn case(largest: u32) -> impl Strategy<Value = Case> {
    let density = prop_oneof![Just(0.0), 0.001f64..0.02, 0.02f64..0.5, Just(0.97)];
    let cap = prop_oneof![
        Just(None),
        (0u32..30).prop_map(Some),
        (0u32..4000).prop_map(Some),
        any::<u32>().prop_map(Some)
    ];
    let unknown = prop_oneof![Just(UnknownAs::Clear), Just(UnknownAs::Obstacle)];
    let size = (1..=largest, 1..=largest);
    (size, density, cap, unknown).prop_flat_map(|((width, height), density, max_squared, unknown)| {
        let value = prop_oneof![
            (density * 1e4) as u32 + 1 => Just(100i8),
            ((1.0 - density) * 1e4) as u32 => Just(0i8),
            (density * 3e3) as u32 => Just(-1i8),
        ];
        let values = prop::collection::vec(value, (width * height) as usize);
        values.prop_map(move |values| Case {
            width,
            values,
            options: DistanceOptions { max_squared, unknown },
        })
    })
}

fn window_of(case: &Case, corners: [u32; 4]) -> CellRect {
    let height = case.values.len() as u32 / case.width;
    let [a, b, c, d] = corners;
    let (a, b, c, d) = (
        a % (case.width + 1),
        b % (case.width + 1),
        c % (height + 1),
        d % (height + 1),
    );
    CellRect {
        x0: a.min(b),
        x1: a.max(b),
        y0: c.min(d),
        y1: c.max(d),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, ..ProptestConfig::default() })]

    #[test]
    fn small_maps(case in case(24), corners in any::<[u32; 4]>(), step in 1u32..7) {
        let window = window_of(&case, corners);
        case.check::<u16>(window, step);
        case.check::<i16>(window, step);
        case.check::<u32>(window, step);
        case.check::<i32>(window, step);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn maps_of_64_cells(case in case(64), corners in any::<[u32; 4]>()) {
        let window = window_of(&case, corners);
        case.check::<u16>(window, 1000);
        case.check::<i32>(window, 1);
    }

    /// Maps on which both kernels are at work, looked at in some places.
    #[test]
    fn large_maps(
        (width, height) in (150u32..700, 150u32..700),
        obstacles in prop::collection::vec(any::<(u32, u32)>(), 1..400),
        seen in prop::collection::vec(any::<(u32, u32)>(), 300),
    ) {
        let obstacles: Vec<_> = obstacles.iter().map(|(x, y)| (x % width, y % height)).collect();
        let mut values = vec![0; (width * height) as usize];
        obstacles.iter().for_each(|(x, y)| values[(y * width + x) as usize] = 100);
        let case = Case { width, values, options: DistanceOptions::default() };
        let mut far = Owned::<u32>::new(case.values.len(), width);
        let mut far = far.map();
        far.compute(&case.grid(), case.options).unwrap();
        let mut near = Owned::<u16>::new(case.values.len(), width);
        let mut near = near.map();
        near.compute(&case.grid(), case.options).unwrap();
        for (x, y) in seen {
            let (x, y) = (x % width, y % height);
            let squared = obstacles.iter().map(|(ox, oy)| ox.abs_diff(x).pow(2) + oy.abs_diff(y).pow(2));
            let squared = squared.min().unwrap();
            assert_eq!(far.squared_at(x, y), Some(squared));
            assert_eq!(near.squared_at(x, y), Some(squared.min(u16::MAX.into()) as u16));
        }
    }
}

#[test]
fn a_grid_may_change_after_begin() {
    let mut case = Case {
        width: 9,
        values: vec![0; 81],
        options: DistanceOptions::default(),
    };
    case.values[40] = 100;
    let expected = case.expected(false, u16::MAX.into());
    let mut owned = Owned::<u16>::new(81, 9);
    let mut map = owned.map();
    map.begin(&case.grid(), case.options).unwrap();
    case.values.fill(100);
    assert_eq!(map.advance(3), 14);
    assert_eq!((map.squared_at(0, 0), map.metres_at(0, 0)), (None, None));
    assert_eq!(map.advance(14), 0);
    assert!(map.squared().iter().map(signed).eq(expected));
}

#[test]
fn refusals_leave_the_map_as_it_was() {
    let case = Case {
        width: 5,
        values: vec![100; 20],
        options: DistanceOptions::default(),
    };
    let mut owned = Owned::<i16>::new(20, 5);
    let mut map = owned.map();
    map.compute(&case.grid(), case.options).unwrap();
    let before = map.squared().to_vec();
    let window = |x0, y0, x1, y1| CellRect { x0, y0, x1, y1 };
    for outside in [
        window(0, 0, 6, 4),
        window(0, 0, 5, 5),
        window(3, 0, 2, 4),
        window(0, 4, 5, 3),
    ] {
        assert_eq!(
            map.compute_window(&case.grid(), outside, case.options),
            Err(Error::WindowOutside)
        );
    }
    let larger = Case {
        width: 6,
        values: vec![0; 24],
        ..case.clone()
    };
    let refused = map.compute(&larger.grid(), case.options);
    assert!(
        matches!(
            refused,
            Err(Error::BufferTooSmall {
                needed: 24,
                given: 20,
                ..
            })
        ),
        "{refused:?}"
    );
    let wider = Case {
        width: 10,
        values: vec![0; 20],
        ..case.clone()
    };
    let refused = map.compute(&wider.grid(), case.options);
    assert!(
        matches!(
            refused,
            Err(Error::BufferTooSmall {
                needed: 20,
                given: 10,
                ..
            })
        ),
        "{refused:?}"
    );
    let long = Case {
        width: MAX_SIDE + 1,
        values: vec![0; MAX_SIDE as usize + 1],
        ..case.clone()
    };
    assert_eq!(map.compute(&long.grid(), case.options), Err(Error::SizeOverflow));
    assert_eq!(map.squared(), before);
}

#[test]
fn the_longest_line() {
    let width = MAX_SIDE;
    let mut values = vec![0; width as usize];
    values[0] = 100;
    let case = Case {
        width,
        values,
        options: DistanceOptions::default(),
    };
    let mut owned = Owned::<i32>::new(width as usize, width);
    let mut map = owned.map();
    map.compute(&case.grid(), case.options).unwrap();
    assert!(
        (0..width)
            .all(|x| map.squared_at(x, 0).map(i64::from)
                == Some(if x == 0 { -1 } else { i64::from(x).pow(2) }))
    );
    assert_eq!(map.nearest_obstacle(&case.grid(), width - 1, 0), Some((0, 0)));
    let mut owned = Owned::<u16>::new(width as usize, width);
    let mut map = owned.map();
    map.compute(&case.grid(), case.options).unwrap();
    assert!((0..width).all(|x| map.squared_at(x, 0) == Some(x.pow(2).min(65_535) as u16)));
}

#[test]
fn caps_in_metres() {
    let cap = |metres, resolution| {
        DistanceOptions::default()
            .with_max_distance(metres, resolution)
            .max_squared
    };
    assert_eq!(cap(1.0, 0.5), Some(4));
    assert_eq!(cap(1.1, 0.5), Some(5));
    assert_eq!(cap(0.0, 0.5), Some(0));
    for none in [
        cap(1.0, 0.0),
        cap(f32::NAN, 0.05),
        cap(f32::INFINITY, 0.05),
        cap(1e30, 0.05),
    ] {
        assert_eq!(none, None);
    }
}
