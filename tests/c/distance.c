/* Distances and rays of tests/src/c_distance.rs through the C interface: prints the same lines. */
#include <math.h>

#include "check.h"
#include "hash.h"

enum { WIDTH = 48, HEIGHT = 32, RAYS = 48 };

static HORUS_MEMORY(grid_memory, HORUS_GRID_BYTES(WIDTH, HEIGHT));
/* One map after the other; the largest. */
static HORUS_MEMORY(map_memory, HORUS_DISTANCE_MAP_BYTES(WIDTH, HEIGHT, 4, 1));

static void line(const char *stage, uint32_t hash)
{
    printf("c: distances and rays | tick 0 | %s | %08lx\n", stage, (unsigned long)hash);
}

static void fill(horus_grid *grid)
{
    uint32_t noise = 0x12345678u;
    for (uint32_t gy = 0; gy < HEIGHT; gy++) {
        for (uint32_t gx = 0; gx < WIDTH; gx++) {
            uint32_t n = next(&noise) % 64;
            int8_t value = (int8_t)(n % 50);
            if (n < 2 && gy < 20)
                value = 100;
            else if (n >= 2 && n < 4)
                value = -1;
            TRY(horus_grid_set_occupancy(grid, gx, gy, value));
        }
    }
}

static void distances(const char *stage, const horus_grid *grid, uint8_t cell_bytes, uint8_t is_signed,
                      horus_distance_options options)
{
    static const horus_cell_rect part = { 12, 6, 39, 28 };
    horus_distance_map_config config = { WIDTH, HEIGHT, cell_bytes, is_signed };
    horus_distance_map *map;
    uint32_t hash = HASH;
    size_t bytes;

    TRY(horus_distance_map_bytes(&config, &bytes));
    CHECK(bytes <= sizeof map_memory);
    TRY(horus_distance_map_init(map_memory, bytes, &config, &map));
    for (int i = 0; i < 2; i++) {
        const void *data;
        size_t count;
        horus_cell_rect window;
        uint32_t left;

        TRY(horus_distance_map_begin(map, grid, i == 0 ? NULL : &part, options));
        do {
            TRY(horus_distance_map_data(map, &data, &count));
            CHECK(count == 0);
            TRY(horus_distance_map_advance(map, 7, &left));
        } while (left > 0);
        TRY(horus_distance_map_window(map, &window));
        TRY(horus_distance_map_data(map, &data, &count));
        CHECK(count == (size_t)(window.x1 - window.x0) * (window.y1 - window.y0));
        for (uint32_t gy = window.y0; gy < window.y1; gy++) {
            uint32_t gx;
            float metres;
            horus_cell nearest = { UINT32_MAX, 0 };
            horus_status status;
            for (gx = window.x0; gx < window.x1; gx++) {
                int64_t squared;
                TRY(horus_distance_map_squared(map, gx, gy, &squared));
                hash_word(&hash, (uint32_t)(uint64_t)squared);
                hash_word(&hash, (uint32_t)((uint64_t)squared >> 32));
            }
            gx = window.x0 + gy % (window.x1 - window.x0);
            TRY(horus_distance_map_metres(map, gx, gy, &metres));
            hash_float(&hash, metres);
            status = horus_distance_map_nearest(map, grid, gx, gy, &nearest);
            CHECK(status == HORUS_STATUS_OK || status == HORUS_STATUS_OUTSIDE);
            hash_word(&hash, nearest.gx);
            hash_word(&hash, nearest.gy);
        }
    }
    line(stage, hash);
}

static void rays(const char *stage, const horus_grid *grid, int32_t rule)
{
    static const horus_pose2d poses[] = {
        { 2.0f, 1.5f, 0.5f }, { 4.5f, 3.0f, -2.0f }, { 0.1f, 0.1f, 0.75f }, { 9.0f, 9.0f, 0.0f },
    };
    static horus_cell cells[2 * (WIDTH + HEIGHT)];
    uint32_t hash = HASH;
    for (size_t p = 0; p < sizeof poses / sizeof poses[0]; p++) {
        for (int32_t i = 0; i < RAYS; i++) {
            horus_ray ray = { poses[p], (float)i * 0.125f, 2.5f, rule };
            bool hit;
            float metres;
            size_t count;
            TRY(horus_grid_cast(grid, &ray, &hit, &metres));
            hash_byte(&hash, hit);
            hash_float(&hash, metres);
            TRY(horus_grid_trace(grid, &ray, cells, sizeof cells / sizeof cells[0], &count));
            for (size_t c = 0; c < count; c++) {
                hash_word(&hash, cells[c].gx);
                hash_word(&hash, cells[c].gy);
            }
        }
    }
    line(stage, hash);
}

static void wrong_input(horus_grid *grid)
{
    horus_distance_map_config config = { WIDTH, HEIGHT, 3, 0 };
    horus_distance_options options = { UINT32_MAX, 0 };
    horus_cell_rect outside = { 0, 0, WIDTH + 1, 1 };
    horus_ray ray = { { 2.0f, 1.5f, 0.5f }, 0.0f, 2.5f, 3 };
    horus_distance_map *map = NULL;
    horus_cell cells[1];
    size_t bytes = 0, count = 7;
    int64_t squared;
    bool hit;
    float metres;

    EXPECT(HORUS_STATUS_INVALID_CHOICE, horus_distance_map_bytes(&config, &bytes));
    EXPECT(HORUS_STATUS_INVALID_CHOICE, horus_distance_map_init(map_memory, sizeof map_memory, &config, &map));
    config.cell_bytes = 2;
    config.height = UINT32_MAX;
    EXPECT(HORUS_STATUS_SIZE_OVERFLOW, horus_distance_map_bytes(&config, &bytes));
    config.height = HEIGHT - 1;
    TRY(horus_distance_map_bytes(&config, &bytes));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_distance_map_init(map_memory, bytes - 1, &config, &map));
    CHECK(map == NULL);
    TRY(horus_distance_map_init(map_memory, bytes, &config, &map));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_distance_map_compute(map, grid, NULL, options));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_distance_map_compute(map, grid, &outside, options));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_distance_map_compute(map, NULL, NULL, options));
    EXPECT(HORUS_STATUS_INVALID_HANDLE,
           horus_distance_map_compute((horus_distance_map *)(void *)grid, grid, NULL, options));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_distance_map_squared(map, 0, 0, &squared));
    EXPECT(HORUS_STATUS_INVALID_CHOICE, horus_grid_cast(grid, &ray, &hit, &metres));
    ray.rule = HORUS_WALK_RULE_SUPERCOVER;
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_grid_trace(grid, &ray, cells, 1, &count));
    CHECK(count == 7);
    ray.bearing = NAN;
    TRY(horus_grid_cast(grid, &ray, &hit, &metres));
    CHECK(!hit && metres == ray.range);
    TRY(horus_grid_trace(grid, &ray, NULL, 0, &count));
    CHECK(count == 0);
}

void distances_and_rays(void)
{
    horus_grid_config config = { WIDTH, HEIGHT, 0.0625f, { -0.5f, -0.25f, 0.25f } };
    horus_distance_options near = { 400, 0 }, known = { 50, 1 }, all = { UINT32_MAX, 0 }, far = { 1000, 1 };
    horus_grid *grid;

    TRY(horus_grid_init(grid_memory, sizeof grid_memory, &config, &grid));
    fill(grid);
    wrong_input(grid);
    distances("u16", grid, 2, 0, near);
    distances("i16", grid, 2, 1, known);
    distances("u32", grid, 4, 0, all);
    distances("i32", grid, 4, 1, far);
    rays("standard rays", grid, HORUS_WALK_RULE_STANDARD);
    rays("supercover rays", grid, HORUS_WALK_RULE_SUPERCOVER);
    rays("navground rays", grid, HORUS_WALK_RULE_NAVGROUND);
}
