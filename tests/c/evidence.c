/* The drives of tests/src/c_evidence.rs through the C interface: prints the same lines. All input comes from
 * integers and single multiplications. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "hash.h"

enum { SIDE = 56, BEAMS = 120, TICKS = 12 };

static HORUS_MEMORY(memory, HORUS_LOCAL_MAPPING_BYTES(SIDE, SIDE, BEAMS, SIDE, SIDE));
static float angles[BEAMS], ranges[BEAMS];

static void measure(int32_t tick)
{
    for (int32_t i = 0; i < BEAMS; i++) {
        int32_t kind = (7 * i + 3 * tick) % 61;
        ranges[i] = kind == 0   ? NAN
                    : kind == 1 ? INFINITY
                    : kind == 2 ? metres(10)
                                : metres(700 + (29 * i + 13 * tick) % 900);
    }
}

static void hash_maps(const horus_local_mapping *mapping, uint32_t *hash)
{
    for (uint32_t gy = 0; gy < SIDE; gy++)
        for (uint32_t gx = 0; gx < SIDE; gx++) {
            horus_evidence_cell cell;
            bool occupied;
            float distance;
            int32_t scan_class;
            TRY(horus_local_mapping_evidence(mapping, gx, gy, &cell));
            TRY(horus_local_mapping_is_occupied(mapping, gx, gy, &occupied));
            TRY(horus_local_mapping_distance(mapping, gx, gy, &distance));
            hash_word(hash, (uint32_t)cell.free << 16 | cell.occupied);
            hash_byte(hash, occupied);
            hash_float(hash, distance);
            /* The lidar's lattice has as many rows and columns. */
            TRY(horus_local_mapping_scan_class(mapping, gx, gy, &scan_class, NULL));
            hash_byte(hash, (uint8_t)scan_class);
        }
}

static void drive(const char *name, int32_t fusion)
{
    horus_local_mapping_config config = horus_local_mapping_config_default();
    horus_inpaint body = { HORUS_INPAINT_FRAME_ROBOT, metres(-200), metres(250),
                           metres(-200),              metres(200),  { 1.0f, 0.0f } };
    horus_local_mapping *mapping;
    uint32_t hash = HASH;
    size_t bytes;

    config.lattice = horus_lattice_around(SIDE, SIDE, 0.05f);
    config.fusion = fusion;
    config.beams = BEAMS;
    config.sensors[0] = horus_sensor_config_default(SIDE, SIDE, 0.05f);
    config.sensors[0].mount.x = metres(100);
    config.sensors[0].mount.y = metres(-50);
    config.sensors[0].mount.theta = metres(300);
    config.sensor_count = 1;
    config.inpaints[0] = body;
    config.inpaint_count = 1;
    TRY(horus_local_mapping_bytes(&config, &bytes));
    CHECK(bytes <= sizeof memory);
    TRY(horus_local_mapping_init(memory, sizeof memory, &config, &mapping));
    for (int32_t i = 0; i < BEAMS; i++)
        angles[i] = metres(52 * i - 3100);
    for (int32_t tick = 0; tick < TICKS; tick++) {
        horus_flatscan scan = { angles, ranges, NULL, BEAMS, 0, metres(50), metres(3000) };
        horus_pose2d robot = { metres(37 * tick), metres(21 * tick), metres(110 * tick) };
        horus_tick_report report;

        measure(tick);
        TRY(horus_local_mapping_tick(mapping, &scan, robot, &report));
        hash_word(&hash, (uint32_t)report.shift.dx);
        hash_word(&hash, (uint32_t)report.shift.dy);
        hash_word(&hash, report.conflicts);
        hash_float(&hash, report.conflict_mass);
        hash_maps(mapping, &hash);
    }
    printf("%s | tick %d | all | %08lx\n", name, TICKS - 1, (unsigned long)hash);
}

void evidence(void)
{
    drive("c: evidence, pcr6", HORUS_FUSION_OPERATOR_PCR6);
    drive("c: evidence, dempster_shafer", HORUS_FUSION_OPERATOR_DEMPSTER_SHAFER);
}
