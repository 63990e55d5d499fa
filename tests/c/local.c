/* The local map's drives of tests/src/c_local.rs through the C interface, and its refusals. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "hash.h"

enum { WIDTH = 90, HEIGHT = 70, CELLS = WIDTH * HEIGHT, BEAMS = 120, TICKS = 32, LIDARS = 2 };

static HORUS_MEMORY(memory, HORUS_LOCAL_MAP_BYTES(WIDTH, HEIGHT, LIDARS, BEAMS, 1));

static horus_pose2d pose(float x, float y, float theta)
{
    horus_pose2d made = { x, y, theta };
    return made;
}

static horus_pose2d pose_at(int32_t tick)
{
    int32_t jump = tick == 20 ? 30000 : 0; /* out of the window and back */
    return pose(metres(37 * tick - 300 + jump), metres(21 * tick - 300), metres(110 * tick));
}

static void measure(uint32_t *noise, int32_t tick, float *ranges)
{
    for (int32_t i = 0; i < BEAMS; i++) {
        uint32_t n = next(noise);
        switch (n % 61) {
        case 0: ranges[i] = NAN; break;
        case 1: ranges[i] = -INFINITY; break;
        case 2: ranges[i] = INFINITY; break;
        case 3: ranges[i] = metres(10); break;
        case 4: ranges[i] = metres(-200); break;
        default: ranges[i] = metres(700 + (29 * i + 13 * tick) % 1900 + (int32_t)(n % 40)); break;
        }
    }
}

static horus_local_map_config local_config(int32_t footprint, float radius)
{
    horus_local_map_config config = horus_local_map_config_default();
    config.width = WIDTH;
    config.height = HEIGHT;
    config.resolution = 0.05f;
    config.footprint = footprint;
    config.radius = radius;
    config.lidars = LIDARS;
    config.beams = BEAMS;
    config.has_odometry = 1;
    config.publishes = 1;
    config.include_transformation = 1;
    strcpy((char *)config.name, "map");
    strcpy((char *)config.odometry, "odom");
    strcpy((char *)config.lidar_names[0], "front");
    strcpy((char *)config.lidar_names[1], "rear");
    return config;
}

static void hash_calls(uint32_t *calls, const horus_local_map *map, const horus_local_update *update)
{
    horus_pose2d transformation;
    horus_map_info info;
    hash_word(calls, (uint32_t)update->shift.dx);
    hash_word(calls, (uint32_t)update->shift.dy);
    hash_word(calls, update->missing_odometries);
    hash_word(calls, update->lidars);
    hash_word(calls, update->missing_lidars);
    hash_word(calls, update->empty_lidars);
    hash_word(calls, 0); /* no lidar's numbers are refused later than when they are written */
    hash_word(calls, update->marks);
    hash_word(calls, update->ignored);
    TRY(horus_local_map_transformation(map, &transformation));
    hash_float(calls, transformation.x);
    hash_float(calls, transformation.y);
    hash_float(calls, transformation.theta);
    TRY(horus_local_map_info(map, &info));
    hash_float(calls, info.origin.x);
    hash_float(calls, info.origin.y);
}

static void drive(const char *name, int32_t footprint, float radius)
{
    static float ranges[BEAMS];
    uint32_t noise = 0x2545f491u, calls = HASH;
    horus_local_map *map;
    horus_local_map_config config = local_config(footprint, radius);
    horus_lidar_scan scans[LIDARS] = {
        { ranges, BEAMS, { 0.15f, 0.0f, 0.0f }, -3.0f, 6.0f, 2.5f },
        { ranges, BEAMS, { -0.125f, 0.03f, 3.0f }, -1.0f, 2.0f, 1.75f },
    };
    TRY(horus_local_map_init(memory, sizeof memory, &config, &map));
    for (int32_t tick = 0; tick < TICKS; tick++) {
        horus_local_update update;
        for (uint32_t lidar = 0; lidar < LIDARS; lidar++) {
            measure(&noise, tick, ranges);
            /* The rear lidar is late, then says nothing now and then. */
            scans[lidar].count = tick % 7 == 5 && lidar == 1 ? 0 : BEAMS;
            if (lidar == 0 || tick >= 3)
                TRY(horus_local_map_write_scan(map, lidar, &scans[lidar]));
        }
        if (tick > 0)
            TRY(horus_local_map_write_odometry(map, pose_at(tick), pose(0.0f, 0.0f, 0.0f)));
        TRY(horus_local_map_update(map, pose(metres(10 * tick), metres(500), metres(50 * tick)), &update));
        hash_calls(&calls, map, &update);
        if (tick % 8 == 7) {
            uint32_t cells = HASH;
            horus_grid_map_view view;
            const uint8_t *data;
            size_t count;
            TRY(horus_local_map_publish(map));
            TRY(horus_local_map_read_gridmap(map, &view));
            TRY(horus_local_map_data(map, &data, &count));
            CHECK(view.width == WIDTH && view.height == HEIGHT && count == CELLS);
            CHECK(memcmp(view.data, data, count) == 0);
            for (size_t i = 0; i < CELLS; i++)
                hash_byte(&cells, view.data[i]);
            printf("%s | tick %d | calls | %08lx\n", name, (int)tick, (unsigned long)calls);
            printf("%s | tick %d | cells | %08lx\n", name, (int)tick, (unsigned long)cells);
        }
    }
}

/* What is wrong has its status, and nothing is written then. */
static void local_refusals(void)
{
    float range = 1.0f;
    uint8_t value = 7;
    size_t bytes = 7;
    horus_cell cell;
    horus_pose2d transformation;
    horus_grid_map_view view;
    horus_local_map *map = NULL;
    horus_local_map_config config = local_config(0, 0.2f);
    horus_lidar_scan scan = { &range, 1, { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f, 2.0f };

    TRY(horus_local_map_bytes(&config, &bytes));
    CHECK(bytes <= sizeof memory);
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_local_map_init(memory, bytes - 1, &config, &map));
#define REFUSED(status, member, wrong)                                                             \
    config = local_config(0, 0.2f);                                                                \
    config.member = (wrong);                                                                       \
    EXPECT(status, horus_local_map_init(memory, sizeof memory, &config, &map))
    REFUSED(HORUS_STATUS_INVALID_CHOICE, footprint, 3);
    REFUSED(HORUS_STATUS_INVALID_CHOICE, lidars, HORUS_LOCAL_MAP_LIDARS + 1);
    REFUSED(HORUS_STATUS_INVALID_RESOLUTION, resolution, 0.0f);
    REFUSED(HORUS_STATUS_SIZE_OVERFLOW, width, 0xffffffffu);
    REFUSED(HORUS_STATUS_INVALID_FOOTPRINT_RADIUS, radius, -1.0f);
    REFUSED(HORUS_STATUS_INVALID_TEXT, lidar_names[1][0], 0xff);
#undef REFUSED
    config = local_config(0, 0.2f);
    strcpy((char *)config.lidar_names[1], "front");
    EXPECT(HORUS_STATUS_DUPLICATE_NAME, horus_local_map_init(memory, sizeof memory, &config, &map));
    CHECK(map == NULL);

    config = local_config(0, 0.2f);
    config.publishes = 0;
    TRY(horus_local_map_init(memory, sizeof memory, &config, &map));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_local_map_write_scan(map, LIDARS, &scan));
    scan.max_range = INFINITY;
    EXPECT(HORUS_STATUS_INVALID_LIDAR, horus_local_map_write_scan(map, 0, &scan));
    scan.max_range = 2.0f;
    scan.mount.x = NAN;
    EXPECT(HORUS_STATUS_NON_FINITE_POSE, horus_local_map_write_scan(map, 0, &scan));
    scan.count = BEAMS + 1;
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_local_map_write_scan(map, 0, &scan));
    EXPECT(HORUS_STATUS_NON_FINITE_POSE, horus_local_map_update(map, pose(NAN, 0.0f, 0.0f), NULL));
    EXPECT(HORUS_STATUS_OFFSET_OUT_OF_RANGE, horus_local_map_recenter(map, pose(1e12f, 0.0f, 0.0f), NULL));
    EXPECT(HORUS_STATUS_NOT_FOUND, horus_local_map_transformation(map, &transformation));
    EXPECT(HORUS_STATUS_NOT_FOUND, horus_local_map_read_gridmap(map, &view));
    EXPECT(HORUS_STATUS_NOT_FOUND, horus_local_map_read_transformation(map, &transformation));
    EXPECT(HORUS_STATUS_BUFFER_TOO_SMALL, horus_local_map_publish(map));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_local_map_value(map, WIDTH, 0, &value));
    EXPECT(HORUS_STATUS_OUTSIDE, horus_local_map_cell_at(map, -1.0f, 0.0f, &cell));
    EXPECT(HORUS_STATUS_LENGTH_MISMATCH, horus_local_map_load(map, &value, 1));
    TRY(horus_local_map_value(map, 3, 4, &value));
    CHECK(value == 128);
    TRY(horus_local_map_update(map, pose(0.0f, 0.0f, 0.0f), NULL));
    TRY(horus_local_map_transformation(map, &transformation));
    TRY(horus_local_map_clear_state(map));
    TRY(horus_local_map_clear(map));
    EXPECT(HORUS_STATUS_INVALID_HANDLE, horus_grid_clear((horus_grid *)map));
}

/* A cost map shows what the local map does. */
static void follow(void)
{
    enum { SIDE = 20 };
    static HORUS_MEMORY(cost_memory, HORUS_COST_MAP_BYTES(SIDE, SIDE, 1, 0));
    static uint8_t cells[SIDE * SIDE];
    horus_cost_map_config costs = {
        { SIDE, SIDE, 0.05f, { 0.0f, 0.0f, 0.0f } }, horus_cost_params_default(), 1, 0,
    };
    horus_local_map_config config = horus_local_map_config_default();
    horus_local_map *map;
    horus_cost_map *cost_map;
    const horus_grid *grid;
    const int8_t *values;
    size_t count;
    uint8_t cost;
    config.width = SIDE;
    config.height = SIDE;
    config.resolution = 0.05f;
    TRY(horus_local_map_init(memory, sizeof memory, &config, &map));
    TRY(horus_cost_map_init(cost_memory, sizeof cost_memory, &costs, &cost_map));
    TRY(horus_local_map_recenter(map, pose(7.0f, -3.0f, 0.0f), NULL));
    for (int i = 0; i < SIDE * SIDE; i++)
        cells[i] = (uint8_t)(i % 3 == 0 ? 255 : i % 17 == 0 ? 0 : 128);
    TRY(horus_local_map_load(map, cells, sizeof cells));
    TRY(horus_local_map_update_cost_map(map, cost_map));
    TRY(horus_cost_map_update(cost_map, NULL));
    TRY(horus_cost_map_grid(cost_map, &grid));
    TRY(horus_grid_data(grid, &values, &count));
    for (int i = 0; i < SIDE * SIDE; i++)
        CHECK(values[i] == (cells[i] == 255 ? 0 : cells[i] == 0 ? 100 : -1));
    TRY(horus_cost_map_cost(cost_map, 7.0f, -3.0f, &cost));
    costs.grid.resolution = 0.06f;
    TRY(horus_cost_map_init(cost_memory, sizeof cost_memory, &costs, &cost_map));
    EXPECT(HORUS_STATUS_GEOMETRY_MISMATCH, horus_local_map_update_cost_map(map, cost_map));
}

void local_drives(void)
{
    local_refusals();
    follow();
    drive("c: local, square", HORUS_FOOTPRINT_KIND_RECTANGULAR, 0.93f);
    drive("c: local, disc", HORUS_FOOTPRINT_KIND_CIRCULAR, 1.11f);
    drive("c: local, no footprint", HORUS_FOOTPRINT_KIND_NONE, 0.0f);
}
