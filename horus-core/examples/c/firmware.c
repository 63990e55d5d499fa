/* A firmware's mapping loop in C. Build the library, then link this with it:
 *
 *     cargo rustc -p horus-core --release --features panic-handler --crate-type staticlib \
 *         --target thumbv7em-none-eabihf
 */
#include "horus.h"

#define BEAMS 360

/* The firmware's own: what the lidar measured, where odometry says the robot is, and what to do if
 * the map cannot be kept. */
static int lidar_revolution(float *to);
static horus_pose2d odometry(void);
static void stop_the_robot(const char *why);

/* 10 m x 10 m at 5 cm, a one-byte field, costs read through the map: 94 KB of .bss. */
static HORUS_MEMORY(map_memory, HORUS_COST_MAP_BYTES(200, 200, 1, 0));
static HORUS_MEMORY(lidar_memory, HORUS_SCAN_WORKSPACE_BYTES(BEAMS, 0));
static float ranges[BEAMS];

int main(void)
{
    horus_cost_map_config config = { .grid = { 200, 200, 0.05f, { -5.0f, -5.0f, 0.0f } },
                                     .params = horus_cost_params_nav2(), .field_bytes = 1 };
    horus_scan_workspace_config beams = { .beams = BEAMS };
    horus_laser_scan scan = { ranges, BEAMS, 0.0f, 0.01745f, 0.1f, 8.0f };
    horus_scan_model model = horus_scan_model_set();
    horus_cost_map *map;
    horus_scan_workspace *lidar;
    horus_status s; /* HORUS_STATUS_OK is 0 */

    if ((s = horus_cost_map_init_1(map_memory, sizeof map_memory, &config, &map)) ||
        (s = horus_scan_workspace_init(lidar_memory, sizeof lidar_memory, &beams, &lidar)))
        stop_the_robot(horus_status_text(s));
    while (!s && lidar_revolution(ranges)) {
        horus_pose2d robot = odometry();
        uint8_t ahead;
        if ((s = horus_cost_map_recenter(map, robot, NULL)) ||
            (s = horus_cost_map_integrate_scan(map, &scan, robot, model, lidar, NULL)) ||
            (s = horus_cost_map_update_within(map, 20000, NULL)) ||
            (s = horus_cost_map_cost(map, robot.x + 0.3f, robot.y, &ahead)))
            stop_the_robot(horus_status_text(s));
        else if (ahead >= 253)
            stop_the_robot("obstacle ahead");
    }
    return s;
}

/* Stand-ins for a board's drivers: three revolutions towards a wall 1 m ahead. */
static int tick;

static int lidar_revolution(float *to)
{
    for (int i = 0; i < BEAMS; i++)
        to[i] = 1.0f - 0.25f * (float)tick;
    return tick++ < 3;
}

static horus_pose2d odometry(void)
{
    horus_pose2d pose = { 0.25f * (float)(tick - 1), 0.0f, 0.0f };
    return pose;
}

static void stop_the_robot(const char *why)
{
    (void)why;
}
