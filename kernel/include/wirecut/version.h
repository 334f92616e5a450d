/* wirecut/version.h - the version of the library. */
#ifndef WCUT_VERSION_H
#define WCUT_VERSION_H

#include <wirecut/export.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WCUT_VERSION "0.1.0"

/** The version of the library that is running, "major.minor.patch". */
WCUT_API const char *wcut_version_text(void);

#ifdef __cplusplus
}
#endif

#endif
