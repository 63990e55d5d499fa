/* Hashes and made-up numbers, the same as in tests/src. */
#ifndef HASH_H
#define HASH_H

#include <stdint.h>
#include <string.h>

/* FNV-1a, 32 bits. */
static const uint32_t HASH = 0x811c9dc5u;

static inline void hash_byte(uint32_t *hash, uint8_t byte)
{
    *hash = (*hash ^ byte) * 0x01000193u;
}

static inline void hash_word(uint32_t *hash, uint32_t word)
{
    for (int i = 0; i < 4; i++)
        hash_byte(hash, (uint8_t)(word >> (8 * i)));
}

static inline void hash_float(uint32_t *hash, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    hash_word(hash, bits);
}

static inline uint32_t next(uint32_t *noise)
{
    *noise ^= *noise << 13;
    *noise ^= *noise >> 17;
    *noise ^= *noise << 5;
    return *noise >> 8;
}

static inline float metres(int32_t mm)
{
    return (float)mm * 0.001f;
}

#endif
