/* wirecut/export.h - which symbols leave the shared library. */
#ifndef WCUT_EXPORT_H
#define WCUT_EXPORT_H

#if defined(__GNUC__)
#define WCUT_API __attribute__((visibility("default")))
#else
#define WCUT_API
#endif

#endif
