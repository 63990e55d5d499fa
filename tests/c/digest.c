/* The drive of tests/src/c_drive.rs through the C interface: prints the same lines, on the host and
 * on a Cortex-M4F. All input comes from integers and single multiplications. */
#include <math.h>

#include "check.h"
#include "hash.h"

enum { WIDTH = 120, HEIGHT = 80, CELLS = WIDTH * HEIGHT, BEAMS = 120, TICKS = 32 };

/* One drive after the other in the same memory. */
static HORUS_MEMORY(map_memory, HORUS_COST_MAP_BYTES(WIDTH, HEIGHT, 2, 1));
static HORUS_MEMORY(lidar_memory, HORUS_SCAN_WORKSPACE_BYTES(BEAMS, CELLS));

typedef struct {
    const char *name;
    horus_cost_params params;
    horus_scan_model model;
    uint8_t field_bytes;
    uint8_t keep_costs;
    int32_t budget; /* above the smallest; -1: unlimited */
} scenario;

static void hash_rect(uint32_t *hash, horus_cell_rect rect)
{
    hash_word(hash, rect.x0);
    hash_word(hash, rect.y0);
    hash_word(hash, rect.x1);
    hash_word(hash, rect.y1);
}

static horus_pose2d pose_at(int32_t tick)
{
    int32_t jump = tick == 20 ? 30000 : 0; /* out of the window and back */
    horus_pose2d pose;
    pose.x = metres(37 * tick - 300 + jump);
    pose.y = metres(21 * tick - 300);
    pose.theta = metres(110 * tick);
    return pose;
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
        default: ranges[i] = metres(900 + (29 * i + 13 * tick) % 1700 + (int32_t)(n % 40)); break;
        }
    }
}

static void step(horus_cost_map *map, horus_scan_workspace *lidar, const scenario *s, int32_t tick,
                 uint32_t *noise, uint32_t *calls)
{
    static float ranges[BEAMS];
    horus_pose2d pose = pose_at(tick);
    horus_shift shift;
    horus_scan_report report;
    horus_cell_rect changed;
    horus_laser_scan scan = { ranges, BEAMS, -3.0f, 0.05f, 0.1f, 4.0f };

    measure(noise, tick, ranges);
    TRY(horus_cost_map_recenter(map, pose, &shift));
    hash_word(calls, (uint32_t)shift.dx);
    hash_word(calls, (uint32_t)shift.dy);
    TRY(horus_cost_map_integrate_scan(map, &scan, pose, s->model, lidar, &report));
    hash_rect(calls, report.changed);
    hash_word(calls, report.hits);
    hash_word(calls, report.misses);
    hash_word(calls, report.ignored);
    for (int i = 0; i < 20; i++) {
        uint32_t gx = next(noise) % (WIDTH + 4);
        uint32_t gy = next(noise) % (HEIGHT + 4);
        int32_t value = (int32_t)(next(noise) % 140) - 20;
        horus_status status = horus_cost_map_set_occupancy(map, gx, gy, (int8_t)value);
        CHECK(status == HORUS_STATUS_OK || status == HORUS_STATUS_OUTSIDE);
        hash_byte(calls, status == HORUS_STATUS_OK);
    }
    if (tick == 16) {
        horus_cost_params params = s->params;
        params.inflation_radius = 0.4f;
        TRY(horus_cost_map_set_params(map, &params));
    }
    if (s->budget < 0) {
        TRY(horus_cost_map_update(map, &changed));
    } else {
        uint32_t smallest, left;
        horus_cost_update update;
        TRY(horus_cost_map_min_budget(map, &smallest));
        EXPECT(HORUS_STATUS_BUDGET_TOO_SMALL, horus_cost_map_update_within(map, smallest - 1, &update));
        TRY(horus_cost_map_update_within(map, smallest + (uint32_t)s->budget, &update));
        TRY(horus_cost_map_calls_left(map, &left));
        hash_word(calls, update.pending);
        hash_word(calls, left);
        changed = update.changed;
    }
    /* Without kept costs the rectangle may hold more than changed, and how much more is the kernel's. */
    if (s->keep_costs)
        hash_rect(calls, changed);
}

static void hash_reads(uint32_t *hash, const horus_cost_map *map, int32_t tick)
{
    static const horus_point outline[] = {
        { 0.4f, 0.3f }, { -0.4f, 0.3f }, { -0.4f, -0.3f }, { 0.4f, -0.3f }, { 0.6f, 0.0f },
    };
    horus_pose2d pose = pose_at(tick);
    horus_footprint_cost under;
    const horus_grid *grid;

    TRY(horus_cost_map_grid(map, &grid));
    for (int32_t i = -8; i < 8; i++) {
        float x = pose.x + metres(470 * i), y = pose.y;
        uint8_t cost;
        bool is_free, is_occupied;
        horus_cell cell;
        horus_status status = horus_cost_map_cost(map, x, y, &cost);
        CHECK(status == HORUS_STATUS_OK || status == HORUS_STATUS_OUTSIDE);
        hash_word(hash, status == HORUS_STATUS_OK ? cost : 256);
        TRY(horus_grid_is_free(grid, x, y, &is_free));
        TRY(horus_grid_is_occupied(grid, x, y, &is_occupied));
        hash_byte(hash, is_free);
        hash_byte(hash, is_occupied);
        if (horus_grid_world_to_grid(grid, x, y, &cell) == HORUS_STATUS_OK) {
            horus_point centre;
            TRY(horus_grid_grid_to_world(grid, cell.gx, cell.gy, &centre));
            hash_word(hash, cell.gx);
            hash_word(hash, cell.gy);
            hash_float(hash, centre.x);
            hash_float(hash, centre.y);
        }
    }
    TRY(horus_cost_map_footprint_cost(map, pose, outline, sizeof outline / sizeof outline[0], &under));
    hash_word(hash, (uint32_t)under.cost);
    hash_byte(hash, under.touches_unknown);
    hash_byte(hash, under.leaves_map);
}

static uint32_t hash_cells(const horus_cost_map *map)
{
    uint32_t hash = HASH;
    const horus_grid *grid;
    const int8_t *cells;
    size_t count;
    TRY(horus_cost_map_grid(map, &grid));
    TRY(horus_grid_data(grid, &cells, &count));
    CHECK(count == CELLS);
    for (size_t i = 0; i < count; i++)
        hash_byte(&hash, (uint8_t)cells[i]);
    return hash;
}

static uint32_t hash_costs(const horus_cost_map *map, bool kept)
{
    uint32_t hash = HASH;
    for (uint32_t gy = 0; gy < HEIGHT; gy++) {
        uint8_t row[WIDTH], cost;
        TRY(horus_cost_map_row(map, gy, row, sizeof row));
        TRY(horus_cost_map_cost_at(map, gy % WIDTH, gy, &cost));
        CHECK(cost == row[gy % WIDTH]);
        for (size_t i = 0; i < sizeof row; i++)
            hash_byte(&hash, row[i]);
    }
    if (kept) {
        const uint8_t *costs;
        size_t count;
        TRY(horus_cost_map_costs(map, &costs, &count));
        CHECK(count == CELLS);
        for (size_t i = 0; i < count; i++)
            hash_byte(&hash, costs[i]);
    }
    return hash;
}

static void finish(horus_cost_map *map, uint32_t *calls)
{
    uint32_t smallest, pending;
    TRY(horus_cost_map_min_budget(map, &smallest));
    hash_word(calls, smallest);
    TRY(horus_cost_map_pending(map, &pending));
    while (pending > 0) {
        horus_cost_update update;
        TRY(horus_cost_map_update_within(map, smallest, &update));
        pending = update.pending;
        hash_word(calls, pending);
    }
}

static void drive(const scenario *s, horus_scan_workspace *lidar)
{
    uint32_t noise = 0x2545f491u, calls = HASH;
    horus_cost_map *map;
    horus_cost_map_config config = {
        { WIDTH, HEIGHT, 0.05f, { -3.0f, -2.0f, 0.25f } }, s->params, s->field_bytes, s->keep_costs,
    };
    void *memory = map_memory;
    size_t bytes = sizeof map_memory;
#ifdef __SANITIZE_ADDRESS__
    /* Exactly as long as asked for, so that one byte too many is seen. */
    TRY(horus_cost_map_bytes(&config, &bytes));
    memory = malloc(bytes);
#endif
    TRY(horus_cost_map_init(memory, bytes, &config, &map));
    for (int32_t tick = 0; tick < TICKS; tick++) {
        step(map, lidar, s, tick, &noise, &calls);
        if (tick % 8 != 7)
            continue;
        if (tick == TICKS - 1)
            finish(map, &calls);
        hash_reads(&calls, map, tick);
        printf("%s | tick %d | calls | %08lx\n", s->name, (int)tick, (unsigned long)calls);
        printf("%s | tick %d | cells | %08lx\n", s->name, (int)tick, (unsigned long)hash_cells(map));
        printf("%s | tick %d | costs | %08lx\n", s->name, (int)tick,
               (unsigned long)hash_costs(map, s->keep_costs != 0));
    }
    if (memory != map_memory)
        free(memory);
}

int main(void)
{
    horus_scan_workspace_config config = { BEAMS, CELLS };
    horus_scan_workspace *lidar;
    scenario direct = { "c: one byte", horus_cost_params_nav2(), horus_scan_model_set(), 1, 0, -1 };
    scenario budgeted = {
        "c: one byte, kept, budgeted", horus_cost_params_horus(), horus_scan_model_accumulate(), 1, 1, 900,
    };
    scenario far = { "c: two bytes, kept", horus_cost_params_nav2(), horus_scan_model_set(), 2, 1, -1 };
    far.params.inflation_radius = 1.0f;
    far.params.cost_scaling_factor = 2.0f;

    CHECK(horus_abi_version() == HORUS_ABI_VERSION);
    refusals();
    TRY(horus_scan_workspace_init(lidar_memory, sizeof lidar_memory, &config, &lidar));
    drive(&direct, lidar);
    drive(&budgeted, lidar);
    drive(&far, lidar);
    distances_and_rays();
    local_drives();
    evidence();
    return 0;
}
