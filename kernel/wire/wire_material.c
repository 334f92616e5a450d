/* What heating wires are made of: stiffness, thermal expansion and strength by the name of the alloy. Figures of the
   makers' data sheets (Kanthal A and Nikrothal 80 in Kanthal, Heating Alloys for Electric Household Appliances, 2003); expansion and strength of other sources differ by 10 %. */
#include <ctype.h>
#include <stdbool.h>
#include <stddef.h>
#include <wirecut/job_rig.h>

/* the more special name first */
static const wcut_wire_material material[] = {
    {"kanthal", 220e3, 12e-6, 725, 34, 900, 0.70},    {"fecral", 220e3, 12e-6, 725, 34, 900, 0.70},
    {"nikrothal", 220e3, 15e-6, 810, 100, 900, 0.88}, {"nichrome", 220e3, 15e-6, 810, 100, 900, 0.88},
    {"nicr", 220e3, 15e-6, 810, 100, 900, 0.88},
};

/* whether a text begins with a word in small letters */
static bool is_alloy_prefix(const char *text, const char *word) {
    while (*word && tolower((unsigned char)*text) == *word) text++, word++;
    return !*word;
}

const wcut_wire_material *wcut_wire_material_view(const char *name) {
    for (const char *at = name; at && *at; at++)
        for (size_t k = 0; k < sizeof material / sizeof *material; k++)
            if (is_alloy_prefix(at, material[k].name)) return &material[k];
    return NULL;
}
