/* wirecut/mould_file.h - the figures and the parts of a divided block out (libwirecut-io). */
#ifndef WCUT_MOULD_FILE_H
#define WCUT_MOULD_FILE_H

#include <wirecut/exchange.h>
#include <wirecut/export.h>
#include <wirecut/mould.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * `mould.json`, "wirecut-mould/1" (FORMATS.md, Mould).
 *
 * @param[in]  mould from wcut_mould_create
 * @param[in]  name  of the job, UTF-8
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mould_write(const wcut_mould *mould, const char *name, const char *path, wcut_error *error);

/**
 * The text of `mould.json`: the caller's, to free(); ends with a line feed.
 *
 * @param[in]  mould from wcut_mould_create
 * @param[in]  name  of the job, UTF-8
 * @param[out] text  the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mould_print(const wcut_mould *mould, const char *name, char **text);

/** What a mould consists of; a sum of them names several. */
typedef enum wcut_mould_part {
    WCUT_MOULD_PART_LOWER = 1,
    WCUT_MOULD_PART_UPPER = 2,
    WCUT_MOULD_PART_FRAME = 4,
    WCUT_MOULD_PART_CASTING = 8 /**< what is between the halves, of a thickness asked for */
} wcut_mould_part;

/**
 * Parts of a mould as objects of a 3MF, "NAME lower" and so on, each with a material that says what it is, a colour, and
 * the cut face in another.
 *
 * @param[in]  mould     from wcut_mould_create
 * @param[in]  name      UTF-8
 * @param[in]  parts     sum of wcut_mould_part
 * @param[in]  for_print 0: assembled, as in the block; 1: beside each other on z = 0, the upper half turned over by half
 *                       a turn about x, so that every half lies on its outer face
 * @param[in]  path      the target, replaced whole or left as it was
 * @param[out] error     may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (a part that the mould has not, too), WCUT_NO_MEMORY,
 *         WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_mould_write_3mf(const wcut_mould *mould, const char *name, unsigned parts, int for_print,
                                          const char *path, wcut_error *error);

/**
 * A part of a mould as STEP: a solid in the colours of the 3MF, its faces named by what they are.
 *
 * @param[in]  mould  from wcut_mould_create
 * @param[in]  name   UTF-8; the solid is "NAME lower" and so on
 * @param[in]  part   a half with exact faces, or the frame
 * @param[in]  schema of the file
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (a part without exact faces, too), WCUT_NO_MEMORY,
 *         WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_mould_write_step(const wcut_mould *mould, const char *name, wcut_mould_part part,
                                           wcut_step_schema schema, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
