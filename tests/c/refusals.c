/* Every wrong input that the library can see has its status; nothing is written then. */
#include <math.h>
#include <string.h>

#include "check.h"

enum { SIDE = 20 };

static HORUS_MEMORY(memory, HORUS_COST_MAP_BYTES(SIDE, SIDE, 1, 0));
static HORUS_MEMORY(copy, HORUS_COST_MAP_BYTES(SIDE, SIDE, 1, 0));
static HORUS_MEMORY(grid_memory, HORUS_GRID_BYTES(SIDE, SIDE));
static HORUS_MEMORY(lidar_memory, HORUS_SCAN_WORKSPACE_BYTES(8, 0));

static horus_cost_map_config map_config(void)
{
    horus_cost_map_config config = {
        { SIDE, SIDE, 0.05f, { 0.0f, 0.0f, 0.0f } }, horus_cost_params_default(), 1, 0,
    };
    return config;
}

/* An address that is not aligned, made without a pointer of a wrong type. */
static void *odd(void *pointer)
{
    return (char *)pointer + 1;
}

static void wrong_memory(void)
{
    horus_cost_map_config config = map_config();
    horus_cost_map *map = NULL;
    size_t bytes = 0;
    TRY(horus_cost_map_bytes(&config, &bytes));
    CHECK(bytes <= sizeof memory && bytes % HORUS_ALIGN == 0);
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_cost_map_init(NULL, sizeof memory, &config, &map));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_cost_map_init(memory, sizeof memory, NULL, &map));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_cost_map_init(memory, sizeof memory, &config, NULL));
    EXPECT(HORUS_STATUS_MISALIGNED, horus_cost_map_init(odd(memory), sizeof memory - 1, &config, &map));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_cost_map_init(memory, bytes - 1, &config, &map));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_cost_map_init(memory, 0, &config, &map));
    EXPECT(HORUS_STATUS_OVERLAP,
           horus_cost_map_init(memory, sizeof memory, &config, (horus_cost_map **)(void *)memory));
    CHECK(map == NULL);
    TRY(horus_cost_map_init(memory, bytes, &config, &map));
    CHECK((void *)map == (void *)memory);
}

static void wrong_configuration(void)
{
    horus_cost_map_config config = map_config();
    horus_cost_map *map = NULL;
    size_t bytes = 7;
#define REFUSED(status, member, value)                                                             \
    config = map_config();                                                                         \
    config.member = (value);                                                                       \
    EXPECT(status, horus_cost_map_bytes(&config, &bytes));                                         \
    EXPECT(status, horus_cost_map_init(memory, sizeof memory, &config, &map))
    REFUSED(HORUS_STATUS_INVALID_CHOICE, field_bytes, 3);
    REFUSED(HORUS_STATUS_INVALID_CHOICE, params.decay, 2);
    REFUSED(HORUS_STATUS_INVALID_CHOICE, params.decay, -1);
    REFUSED(HORUS_STATUS_INVALID_RESOLUTION, grid.resolution, 0.0f);
    REFUSED(HORUS_STATUS_INVALID_RESOLUTION, grid.resolution, NAN);
    REFUSED(HORUS_STATUS_NON_FINITE_POSE, grid.origin.theta, INFINITY);
    REFUSED(HORUS_STATUS_SIZE_OVERFLOW, grid.width, UINT32_MAX);
    REFUSED(HORUS_STATUS_INVALID_INFLATION_RADIUS, params.inflation_radius, -1.0f);
    REFUSED(HORUS_STATUS_INVALID_COST_SCALING_FACTOR, params.cost_scaling_factor, NAN);
    REFUSED(HORUS_STATUS_INVALID_LETHAL_COST, params.lethal_cost, 255);
    REFUSED(HORUS_STATUS_INVALID_LETHAL_THRESHOLD, params.lethal_threshold, 0);
    REFUSED(HORUS_STATUS_INVALID_INSCRIBED_RADIUS, params.inscribed_radius, INFINITY);
    CHECK(bytes == 7 && map == NULL);

    /* What only init can see: nothing is left in the memory. */
    config = map_config();
    config.params.inflation_radius = 5.0f;
    config.params.cost_scaling_factor = 1.0f;
    EXPECT(HORUS_STATUS_RADIUS_TOO_LARGE, horus_cost_map_init(memory, sizeof memory, &config, &map));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_cost_map_compute((horus_cost_map *)(void *)memory));
}

static void wrong_handles(horus_cost_map *map, horus_grid *grid, horus_scan_workspace *lidar)
{
    horus_pose2d home = { 0.0f, 0.0f, 0.0f };
    horus_laser_scan scan = { NULL, 0, 0.0f, 0.1f, 0.1f, 5.0f };
    const horus_grid *inside;
    uint64_t zeros[8] = { 0 };
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_cost_map_compute(NULL));
    EXPECT(HORUS_STATUS_MISALIGNED, horus_cost_map_compute((horus_cost_map *)odd(map)));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_cost_map_compute((horus_cost_map *)(void *)zeros));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_cost_map_compute((horus_cost_map *)(void *)grid));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_grid_clear((horus_grid *)(void *)lidar));
    EXPECT(HORUS_STATUS_INVALID_HANDLE,
           horus_grid_integrate_scan(grid, &scan, home, horus_scan_model_set(),
                                     (horus_scan_workspace *)(void *)grid_memory, NULL));
    /* A copy of an object is none. */
    memcpy(copy, memory, sizeof copy);
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_cost_map_compute((horus_cost_map *)(void *)copy));
    /* The grid inside a map is for reading. */
    TRY(horus_cost_map_grid(map, &inside));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_grid_clear((horus_grid *)(void *)memory));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_grid_timestamp((horus_grid *)(void *)lidar, zeros));
}

static void wrong_arrays(horus_cost_map *map, horus_grid *grid)
{
    static int8_t values[SIDE * SIDE];
    static float floats[16];
    horus_pose2d home = { 0.0f, 0.0f, 0.0f };
    horus_footprint_cost under;
    const uint8_t *costs = NULL;
    const int8_t *data;
    size_t count;
    uint8_t row[SIDE], cost = 9;
    EXPECT(HORUS_STATUS_LENGTH_MISMATCH, horus_cost_map_load(map, values, sizeof values - 1));
    EXPECT(HORUS_STATUS_LENGTH_MISMATCH, horus_grid_load(grid, NULL, 0));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_grid_load(grid, NULL, sizeof values));
    EXPECT(HORUS_STATUS_LENGTH_MISMATCH, horus_grid_load(grid, values, SIZE_MAX));
    EXPECT(HORUS_STATUS_SIZE_OVERFLOW,
           horus_cost_map_footprint_cost(map, home, (horus_point *)(void *)floats, SIZE_MAX / 2, &under));
    EXPECT(HORUS_STATUS_MISALIGNED,
           horus_cost_map_footprint_cost(map, home, (horus_point *)odd(floats), 3, &under));
    EXPECT(HORUS_STATUS_INVALID_POLYGON, horus_cost_map_footprint_cost(map, home, NULL, 0, &under));
    EXPECT(HORUS_STATUS_OVERLAP,
           horus_cost_map_footprint_cost(map, home, (horus_point *)(void *)floats, 3,
                                         (horus_footprint_cost *)(void *)floats));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_cost_map_row(map, 0, row, SIDE - 1));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_cost_map_row(map, 0, NULL, SIDE));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_cost_map_row(map, SIDE, row, sizeof row));
    EXPECT(HORUS_STATUS_OVERLAP, horus_cost_map_row(map, 0, (uint8_t *)memory + 256, SIDE));
    EXPECT(HORUS_STATUS_NOT_KEPT, horus_cost_map_costs(map, &costs, &count));
    EXPECT(HORUS_STATUS_OVERLAP, horus_grid_data(grid, (const int8_t **)(void *)&count, &count));
    TRY(horus_grid_data(grid, &data, &count));
    EXPECT(HORUS_STATUS_OVERLAP, horus_grid_load(grid, data, count));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_cost_map_cost_at(map, SIDE, 0, &cost));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_cost_map_cost(map, NAN, 0.0f, &cost));
    EXPECT(HORUS_STATUS_OVERLAP, horus_cost_map_cost(map, 0.0f, 0.0f, (uint8_t *)map));
    CHECK(cost == 9 && costs == NULL);
}

static void wrong_scans(horus_grid *grid, horus_scan_workspace *lidar)
{
    static float ranges[9];
    horus_pose2d home = { 0.0f, 0.0f, 0.0f }, nowhere = { NAN, 0.0f, 0.0f }, far = { 1e30f, 0.0f, 0.0f };
    horus_scan_model model = horus_scan_model_set();
    horus_laser_scan scan = { ranges, 9, 0.0f, 0.1f, 0.1f, 5.0f };
#define SCAN(pose) horus_grid_integrate_scan(grid, &scan, pose, model, lidar, NULL)
    EXPECT(HORUS_STATUS_WORKSPACE_TOO_SMALL, SCAN(home));
    scan.count = 8;
    TRY(SCAN(home));
    EXPECT(HORUS_STATUS_NON_FINITE_POSE, SCAN(nowhere));
    model.kind = 2;
    EXPECT(HORUS_STATUS_INVALID_CHOICE, SCAN(home));
    model = horus_scan_model_accumulate();
    EXPECT(HORUS_STATUS_WORKSPACE_TOO_SMALL, SCAN(home));
    model.miss = 1;
    EXPECT(HORUS_STATUS_INVALID_MODEL, SCAN(home));
    scan.angle_increment = INFINITY;
    EXPECT(HORUS_STATUS_INVALID_SCAN, SCAN(home));
    scan.ranges = (const float *)odd(ranges);
    EXPECT(HORUS_STATUS_MISALIGNED, SCAN(home));
    scan.ranges = NULL;
    EXPECT(HORUS_STATUS_NULL_POINTER, SCAN(home));
    scan.ranges = (const float *)(const void *)lidar_memory;
    EXPECT(HORUS_STATUS_OVERLAP, SCAN(home));
    EXPECT(HORUS_STATUS_NON_FINITE_POSE, horus_grid_recenter(grid, nowhere, NULL));
    EXPECT(HORUS_STATUS_OFFSET_OUT_OF_RANGE, horus_grid_recenter(grid, far, NULL));
}

static void texts(horus_grid *grid)
{
    char name[33] = "?";
    uint64_t time = 0;
    TRY(horus_grid_set_header(grid, "map", 3, 5000000000u));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_grid_frame_id(grid, name, 3));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_grid_frame_id(grid, NULL, 4));
    CHECK(name[0] == '?');
    TRY(horus_grid_frame_id(grid, name, 4));
    CHECK(strcmp(name, "map") == 0);
    EXPECT(HORUS_STATUS_INVALID_TEXT, horus_grid_set_header(grid, "\xff", 1, 0));
    EXPECT(HORUS_STATUS_NULL_POINTER, horus_grid_set_metadata(grid, NULL, 1));
    TRY(horus_grid_timestamp(grid, &time));
    CHECK(time == 5000000000u);
    CHECK(strcmp(horus_status_text(-1), "not a status") == 0);
}

/* The macros give at least what the functions ask for, and little more. */
static void sizes(void)
{
    static const uint32_t sides[] = { 0, 1, 7, 31, 32, 33, 64, 200, 1000 };
    enum { COUNT = sizeof sides / sizeof sides[0], SLACK = 128 };
    for (int i = 0; i < COUNT * COUNT * 4; i++) {
        uint32_t width = sides[i % COUNT], height = sides[i / COUNT % COUNT], cells = width * height;
        horus_cost_map_config map = map_config();
        horus_scan_workspace_config lidar = { width, cells };
        size_t bytes;
        map.grid.width = width;
        map.grid.height = height;
        map.field_bytes = (uint8_t)(1 + i / (COUNT * COUNT) % 2);
        map.keep_costs = (uint8_t)(i / (COUNT * COUNT) / 2);
#define ENOUGH(macro) CHECK(bytes <= (macro) && (macro) <= bytes + SLACK)
        TRY(horus_cost_map_bytes(&map, &bytes));
        ENOUGH(HORUS_COST_MAP_BYTES(width, height, map.field_bytes, map.keep_costs));
        TRY(horus_grid_bytes(&map.grid, &bytes));
        ENOUGH(HORUS_GRID_BYTES(width, height));
        TRY(horus_scan_workspace_bytes(&lidar, &bytes));
        ENOUGH(HORUS_SCAN_WORKSPACE_BYTES(width, cells));
    }
}

void refusals(void)
{
    horus_cost_map_config config = map_config();
    horus_scan_workspace_config beams = { 8, 0 };
    horus_cost_map *map;
    horus_grid *grid;
    horus_scan_workspace *lidar;
    wrong_memory();
    wrong_configuration();
    TRY(horus_cost_map_init(memory, sizeof memory, &config, &map));
    TRY(horus_grid_init(grid_memory, sizeof grid_memory, &config.grid, &grid));
    TRY(horus_scan_workspace_init(lidar_memory, sizeof lidar_memory, &beams, &lidar));
    wrong_handles(map, grid, lidar);
    wrong_arrays(map, grid);
    wrong_scans(grid, lidar);
    texts(grid);
    sizes();
}
