/* What the parts of the program share. */
#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>
#include <stdlib.h>

#include "horus.h"

/* Ends the program unless the call returns this status. */
#define EXPECT(expected, call)                                                                     \
    do {                                                                                           \
        horus_status got = (call);                                                                 \
        if (got != (expected)) {                                                                   \
            printf("%s:%d: %s\n  expected: %s\n  got: %s\n", __FILE__, __LINE__, #call,            \
                   horus_status_text(expected), horus_status_text(got));                           \
            exit(1);                                                                               \
        }                                                                                          \
    } while (0)

#define TRY(call) EXPECT(HORUS_STATUS_OK, call)

/* Ends the program unless the condition holds. */
#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            printf("%s:%d: %s is false\n", __FILE__, __LINE__, #condition);                        \
            exit(1);                                                                               \
        }                                                                                          \
    } while (0)

/* Every wrong input has its status, and the macros for static memory give enough. */
void refusals(void);

/* Distances and rays, their wrong input included. */
void distances_and_rays(void);

/* The drives of tests/src/c_local.rs: prints the same lines. */
void local_drives(void);

/* The drives of tests/src/c_evidence.rs. */
void evidence(void);

#endif
