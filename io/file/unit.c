/* Units of length: their names as files and people write them, and how many millimetres they are. */
#include "io/file/unit.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

double wcut_unit_length(wcut_length_unit unit) {
    static const double millimetres[WCUT_LENGTH_UNIT_COUNT] = {1, 10, 1000, 25.4, 304.8, 100, 1e-3};
    return millimetres[unit];
}

double wcut_unit_find(const char *name, size_t length) {
    static const struct {
        const char *name;
        double millimetres;
    } known[] = {{"mm", 1},
                 {"millimeter", 1},
                 {"millimetre", 1},
                 {"millimeters", 1},
                 {"millimetres", 1},
                 {"cm", 10},
                 {"centimeter", 10},
                 {"centimetre", 10},
                 {"centimeters", 10},
                 {"centimetres", 10},
                 {"dm", 100},
                 {"decimeter", 100},
                 {"decimetre", 100},
                 {"decimeters", 100},
                 {"decimetres", 100},
                 {"m", 1000},
                 {"meter", 1000},
                 {"metre", 1000},
                 {"meters", 1000},
                 {"metres", 1000},
                 {"km", 1e6},
                 {"kilometer", 1e6},
                 {"kilometre", 1e6},
                 {"kilometers", 1e6},
                 {"kilometres", 1e6},
                 {"um", 1e-3},
                 {"\xc2\xb5m", 1e-3},
                 {"\xce\xbcm", 1e-3},
                 {"micron", 1e-3},
                 {"microns", 1e-3},
                 {"micrometer", 1e-3},
                 {"micrometre", 1e-3},
                 {"micrometers", 1e-3},
                 {"micrometres", 1e-3},
                 {"nm", 1e-6},
                 {"in", 25.4},
                 {"inch", 25.4},
                 {"inches", 25.4},
                 {"zoll", 25.4},
                 {"ft", 304.8},
                 {"foot", 304.8},
                 {"feet", 304.8},
                 {"yd", 914.4},
                 {"yard", 914.4},
                 {"yards", 914.4},
                 {"mil", 0.0254},
                 {"mils", 0.0254},
                 {"thou", 0.0254}};

    /* a name is known as a whole, upper and lower case alike */
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strlen(known[k].name) == length && strncasecmp(known[k].name, name, length) == 0)
            return known[k].millimetres;

    return 0;
}

static bool is_letter(char c) { return isalpha((unsigned char)c) || (unsigned char)c >= 0x80; }

double wcut_unit_stated(const char *text, size_t length) {
    bool asked = false;

    /* letters make words, all else separates them */
    for (size_t k = 0; k < length;) {
        if (!is_letter(text[k])) {
            k++;
            continue;
        }
        size_t end = k;
        while (end < length && is_letter(text[end])) end++;

        /* the word that says unit, then the next word if it is one */
        const double millimetres = asked ? wcut_unit_find(text + k, end - k) : 0;
        if (millimetres > 0) return millimetres;
        asked = (end - k == 4 && strncasecmp(text + k, "unit", 4) == 0) ||
                (end - k == 5 && strncasecmp(text + k, "units", 5) == 0) ||
                (asked && end - k <= 6 && strncasecmp(text + k, "length", end - k) == 0);
        k = end;
    }

    return 0;
}
