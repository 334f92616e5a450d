/* LZF (Lehmann 2000), the compression of PCD files, read. */
#ifndef WCUT_IO_FILE_LZF_H
#define WCUT_IO_FILE_LZF_H

#include <stdbool.h>
#include <stddef.h>

/* the least that so many bytes can have been compressed to: a reference of three bytes stands for at most 264 */
enum { WCUT_LZF_RATIO_MAX = 88 };

/* Exactly `size` bytes from `length` compressed ones; false: they do not make as many, or refer to what is not there. */
bool wcut_lzf_read(const unsigned char *from, size_t length, unsigned char *to, size_t size);

#endif
