/* The page's big arrays: little-endian numbers as base64, each held once. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/report/report_page.h"

void wcut_base64_print(size_t size, const void *data, char *text) {
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const uint8_t *byte = data;
    for (; size >= 3; size -= 3, byte += 3) {
        const uint32_t bits = (uint32_t)byte[0] << 16 | (uint32_t)byte[1] << 8 | byte[2];
        for (int k = 18; k >= 0; k -= 6) *text++ = digit[bits >> k & 63];
    }
    if (size == 0) return;
    const uint32_t bits = (uint32_t)byte[0] << 16 | (size > 1 ? (uint32_t)byte[1] << 8 : 0);
    *text++ = digit[bits >> 18 & 63];
    *text++ = digit[bits >> 12 & 63];
    *text++ = size > 1 ? digit[bits >> 6 & 63] : '=';
    *text = '=';
}

/* the number's bytes, lowest first, on any machine */
static void store(uint64_t bits, int size, uint8_t *to) {
    for (int i = 0; i < size; i++) to[i] = (uint8_t)(bits >> (8 * i));
}

static void store_float(double value, uint8_t *to) {
    const float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    store(bits, 4, to);
}

static void store_double(double value, uint8_t *to) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    store(bits, 8, to);
}

/* a place for size bytes; NULL without memory */
static uint8_t *add_pool(wcut_report_pool *pool, const void *key, size_t size) {
    if (pool->count == pool->room) {
        const int room = pool->room ? 2 * pool->room : 32;
        wcut_report_array *array = wcut_alloc((size_t)room, sizeof *array);
        if (!array) return NULL;
        if (pool->count) memcpy(array, pool->array, (size_t)pool->count * sizeof *array);
        free(pool->array);
        pool->array = array;
        pool->room = room;
    }
    uint8_t *data = wcut_alloc(size, 1);
    if (!data) return NULL;
    pool->array[pool->count++] = (wcut_report_array){.key = key, .size = size, .data = data};
    pool->size += (size + 2) / 3 * 4;
    return data;
}

int wcut_report_pool_add_doubles(wcut_report_pool *pool, int count, const int *index, const double *value) {
    const size_t size = 8 * (size_t)count;
    for (int k = 0; !index && k < pool->count; k++)
        if (pool->array[k].key == value && pool->array[k].size == size) return k;
    uint8_t *data = add_pool(pool, index ? NULL : value, size);
    if (!data) return -1;
    for (int i = 0; i < count; i++) store_double(value[index ? index[i] : i], data + 8 * (size_t)i);
    return pool->count - 1;
}

int wcut_report_pool_add_floats(wcut_report_pool *pool, int count, const int *index, const double *value) {
    uint8_t *data = add_pool(pool, NULL, 4 * (size_t)count);
    if (!data) return -1;
    for (int i = 0; i < count; i++) store_float(value[index ? index[i] : i], data + 4 * (size_t)i);
    return pool->count - 1;
}

int wcut_report_pool_add_points(wcut_report_pool *pool, int count, const int *index, const wcut_vec3 *point) {
    uint8_t *data = add_pool(pool, NULL, 12 * (size_t)count);
    if (!data) return -1;
    for (int i = 0; i < count; i++) {
        const wcut_vec3 p = point[index ? index[i] : i];
        uint8_t *to = data + 12 * (size_t)i;
        store_float(p.x, to);
        store_float(p.y, to + 4);
        store_float(p.z, to + 8);
    }
    return pool->count - 1;
}

int wcut_report_pool_add_ints(wcut_report_pool *pool, int count, const int *value) {
    uint8_t *data = add_pool(pool, NULL, 4 * (size_t)count);
    if (!data) return -1;
    for (int i = 0; i < count; i++) store((uint32_t)value[i], 4, data + 4 * (size_t)i);
    return pool->count - 1;
}

void wcut_report_pool_clear(wcut_report_pool *pool) {
    for (int k = 0; k < pool->count; k++) free(pool->array[k].data);
    free(pool->array);
    *pool = (wcut_report_pool){0};
}
