/* LZF (Lehmann 2000): literal runs of 1 to 32 bytes, and references of 3 to 264 bytes to what came before. */
#include "io/file/lzf.h"

#include <string.h>

bool wcut_lzf_read(const unsigned char *from, size_t length, unsigned char *to, size_t size) {
    const unsigned char *in = from, *in_end = from + length;
    size_t out = 0;
    while (in < in_end) {
        const size_t control = *in++;

        /* a literal run */
        if (control < 32) {
            const size_t n = control + 1;
            if ((size_t)(in_end - in) < n || size - out < n) return false;
            memcpy(to + out, in, n);
            in += n;
            out += n;
            continue;
        }

        /* a reference: its length, longer ones in a byte more, and how far back, which may overlap what is written */
        size_t n = control >> 5;
        if (n == 7) {
            if (in == in_end) return false;
            n += *in++;
        }
        if (in == in_end) return false;
        const size_t back = ((control & 31) << 8) + *in++ + 1;
        n += 2;
        if (back > out || size - out < n) return false;
        for (size_t k = 0; k < n; k++, out++) to[out] = to[out - back];
    }

    return out == size;
}
