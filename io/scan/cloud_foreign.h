/* Meshes that assimp reads as clouds. */
#ifndef WCUT_IO_SCAN_CLOUD_FOREIGN_H
#define WCUT_IO_SCAN_CLOUD_FOREIGN_H

/* the ending that chooses assimp's importer, by a file's first bytes (a string) or by its name's; NULL: none of its */
const char *wcut_cloud_foreign_ending(const char *begin, const char *name);

#endif
