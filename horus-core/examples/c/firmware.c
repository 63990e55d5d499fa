/* A firmware's mapping loop in C. Build the library, then link this with it:
 *
 *     cargo rustc -p horus-core --release --features panic-handler --crate-type staticlib \
 *         --target thumbv7em-none-eabihf
 */
#include "horus.h"

#define BEAMS 360

/* The firmware's own: what the lidar measured, where odometry says the robot is, and what to do if
 * the map cannot be kept. */
static int lidar_revolution(float *ranges);
static horus_pose2d odometry(void);
static void stop_the_robot(const char *why);

/* 10 m x 10 m at 5 cm, a one-byte field, costs read through the map: 98 KB of .bss. */
static HORUS_MEMORY(map_memory, HORUS_COST_MAP_BYTES(200, 200, 1, 0));
static HORUS_MEMORY(lidar_memory, HORUS_SCAN_WORKSPACE_BYTES(BEAMS, 0));

static horus_status run(void)
{
    horus_scan_workspace_config beams = { BEAMS, 0 };
    horus_cost_map_config config = {
        { 200, 200, 0.05f, { -5.0f, -5.0f, 0.0f } }, horus_cost_params_nav2(), 1, 0,
    };
    static float ranges[BEAMS];
    horus_laser_scan scan = { ranges, BEAMS, 0.0f, 0.01745f, 0.1f, 8.0f };
    horus_scan_workspace *lidar;
    horus_cost_map *map;

    horus_status status = horus_cost_map_init_1(map_memory, sizeof map_memory, &config, &map);
    if (status == HORUS_STATUS_OK)
        status = horus_scan_workspace_init(lidar_memory, sizeof lidar_memory, &beams, &lidar);
    while (status == HORUS_STATUS_OK && lidar_revolution(ranges)) {
        horus_pose2d robot = odometry();
        uint8_t ahead;
        status = horus_cost_map_recenter(map, robot, NULL);
        if (status == HORUS_STATUS_OK)
            status = horus_cost_map_integrate_scan(map, &scan, robot, horus_scan_model_set(), lidar, NULL);
        if (status == HORUS_STATUS_OK)
            status = horus_cost_map_update_within(map, 20000, NULL);
        if (status == HORUS_STATUS_OK)
            status = horus_cost_map_cost(map, robot.x + 0.3f, robot.y, &ahead);
        if (status == HORUS_STATUS_OK && ahead >= 253)
            stop_the_robot("obstacle ahead");
    }
    return status;
}

int main(void)
{
    stop_the_robot(horus_status_text(run()));
    return 0;
}

/* Stand-ins for a board's drivers: three revolutions towards a wall 1 m ahead. */
static int tick;

static int lidar_revolution(float *ranges)
{
    for (int i = 0; i < BEAMS; i++)
        ranges[i] = 1.0f - 0.25f * (float)tick;
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
