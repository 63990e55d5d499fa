use core::ptr;

use super::*;

fn config(width: u32, height: u32, cell_bytes: u8, is_signed: u8) -> horus_distance_map_config {
    horus_distance_map_config {
        width,
        height,
        cell_bytes,
        is_signed,
    }
}

const ALL: horus_distance_options = horus_distance_options {
    max_squared: u32::MAX,
    unknown_is_obstacle: 0,
};

/// A grid of 6 x 5 free cells with an obstacle at (4, 3).
fn grid() -> (Memory, *mut horus_grid) {
    let (memory, grid) = Memory::grid(&grid_config(6, 5));
    let mut values = [0i8; 30];
    values[3 * 6 + 4] = 100;
    // SAFETY: the handle is live, the pointer is good.
    let status = unsafe { horus_grid_load(grid, values.as_ptr(), values.len()) };
    assert_eq!(status, Status::Ok);
    (memory, grid)
}

#[test]
fn distances_live_in_the_callers_memory() {
    let (_memory, grid) = grid();
    for (cell_bytes, is_signed) in [(2, 0), (2, 1), (4, 0), (4, 1)] {
        let config = config(6, 5, cell_bytes, is_signed);
        let (mut bytes, mut map) = (0, ptr::null_mut());
        // SAFETY: the pointers are good.
        let status = unsafe { horus_distance_map_bytes(&config, &mut bytes) };
        assert_eq!(status, Status::Ok);
        let memory = Memory::new(bytes);
        // SAFETY: the handles are live once made, the pointers are good.
        unsafe {
            let status = horus_distance_map_init(memory.pointer(), bytes, &config, &mut map);
            assert_eq!(status, Status::Ok);
            let (mut squared, mut metres) = (0, 0.0);
            assert_eq!(
                horus_distance_map_squared(map, 0, 0, &mut squared),
                Status::Outside
            );
            assert_eq!(
                horus_distance_map_compute(map, grid, ptr::null(), ALL),
                Status::Ok
            );
            assert_eq!(horus_distance_map_squared(map, 0, 0, &mut squared), Status::Ok);
            assert_eq!(squared, 25);
            assert_eq!(horus_distance_map_squared(map, 4, 3, &mut squared), Status::Ok);
            assert_eq!(squared, -i64::from(is_signed));
            assert_eq!(horus_distance_map_metres(map, 4, 1, &mut metres), Status::Ok);
            assert_eq!(metres, 0.2);
            let (mut data, mut count) = (ptr::null(), 0);
            assert_eq!(horus_distance_map_data(map, &mut data, &mut count), Status::Ok);
            assert_eq!(count, 30);
            let last = data.cast::<u8>().add(30 * usize::from(cell_bytes) - 1).read();
            assert_eq!(last, 0, "the highest byte of a small number");

            let window = CellRect {
                x0: 1,
                y0: 1,
                x1: 4,
                y1: 4,
            };
            let mut left = 0;
            assert_eq!(horus_distance_map_begin(map, grid, &window, ALL), Status::Ok);
            assert_eq!(horus_distance_map_data(map, &mut data, &mut count), Status::Ok);
            assert_eq!(count, 0, "not before the end");
            assert_eq!(horus_distance_map_advance(map, 100, &mut left), Status::Ok);
            assert_eq!(left, 0);
            let mut nearest = horus_cell::default();
            assert_eq!(
                horus_distance_map_nearest(map, grid, 1, 1, &mut nearest),
                Status::Ok
            );
            assert_eq!(nearest, horus_cell { gx: 4, gy: 3 });
            assert_eq!(
                horus_distance_map_nearest(map, grid, 5, 1, &mut nearest),
                Status::Outside
            );
        }
    }
}

#[test]
fn rays_write_what_they_are_given_room_for() {
    let (_memory, grid) = grid();
    let mut ray = horus_ray {
        pose: Pose2D::new(0.05, 0.35, 0.0),
        bearing: 0.0,
        range: 2.0,
        rule: horus_walk_rule::Standard as i32,
    };
    let (mut hit, mut metres) = (false, 0.0);
    let (mut cells, mut count) = ([horus_cell::default(); 6], 0);
    // SAFETY: the handle is live, the pointers are good.
    unsafe {
        assert_eq!(horus_grid_cast(grid, &ray, &mut hit, &mut metres), Status::Ok);
        assert!(hit && metres == 0.4, "{metres}");
        let status = horus_grid_trace(grid, &ray, cells.as_mut_ptr(), 5, &mut count);
        assert_eq!((status, count), (Status::BufferTooSmall, 0));
        let status = horus_grid_trace(grid, &ray, cells.as_mut_ptr(), 6, &mut count);
        assert_eq!((status, count), (Status::Ok, 6));
        assert_eq!(cells[5], horus_cell { gx: 5, gy: 3 });
        let own = ptr::from_mut(&mut ray).cast::<horus_cell>();
        assert_eq!(horus_grid_trace(grid, &ray, own, 1, &mut count), Status::Overlap);
        ray.rule = 3;
        assert_eq!(
            horus_grid_cast(grid, &ray, &mut hit, &mut metres),
            Status::InvalidChoice
        );
    }
}
