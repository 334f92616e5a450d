/* Faces of a CAD file by name, by number, several at once. */
#include "io/scan/face_choice.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

int wcut_face_choose(const wcut_trimmed_set *set, const char *choice, int *face) {
    face[0] = 0;
    if (!choice) return set->count == 1;

    /* a whole text that is a name comes before its commas */
    face[0] = wcut_trimmed_set_find(set, choice, strlen(choice));
    if (face[0] >= 0) return 1;
    if (strcmp(choice, "all") == 0) {
        for (int k = 0; k < set->count; k++) face[k] = k;
        return set->count;
    }

    /* a list, each once */
    int count = 0;
    for (const char *at = choice; count < set->count; count++) {
        const size_t length = strcspn(at, ",");
        const int found = wcut_trimmed_set_find(set, at, length);
        bool again = false;
        for (int k = 0; k < count; k++) again = again || face[k] == found;
        if (found < 0 || again) return 0;
        face[count] = found;
        if (!at[length]) return count + 1;
        at += length + 1;
    }
    return 0;
}

void wcut_face_list(const wcut_trimmed_set *set, char *text, size_t size) {
    size_t used = 0;
    text[0] = '\0';
    for (int k = 0; k < set->count && used + 40 < size; k++) {
        const int n = snprintf(text + used, size - used, "%s%d%s%.24s", k ? ", " : "", k + 1,
                               set->name[k][0] ? " " : "", set->name[k]);
        used += n > 0 ? (size_t)n : 0;
    }
    if (used + 40 >= size && used + 6 < size) snprintf(text + used, size - used, ", ...");
}
