/* What we read of another program's curves, against the ends and lengths that it says they have:
   read_curves EXPECTED.txt FILE... */
#include <math.h>
#include <stdio.h>
#include <wirecut/wirecut.h>

static double distance(wcut_vec3 a, const double *b) { return hypot(hypot(a.x - b[0], a.y - b[1]), a.z - b[2]); }

static double length_of(const wcut_curve *c, double first, double last) {
    double length;
    return wcut_curve_length(c, first, last, &length) == WCUT_OK ? length : NAN;
}

/* whether a curve of the set has these ends, in either order, and this length */
static int is_there(const wcut_curve_set *set, const double *given) {
    for (int k = 0; k < set->count; k++) {
        double first, last;
        wcut_vec3 a, b;
        wcut_curve_domain(set->curve[k], &first, &last);
        if (wcut_curve_eval(set->curve[k], first, 0, &a) != WCUT_OK ||
            wcut_curve_eval(set->curve[k], last, 0, &b) != WCUT_OK)
            continue;
        const int same = distance(a, given) < 1e-6 && distance(b, given + 3) < 1e-6;
        const int turned = distance(b, given) < 1e-6 && distance(a, given + 3) < 1e-6;
        if ((same || turned) && fabs(length_of(set->curve[k], first, last) / given[6] - 1) < 1e-6) return 1;
    }
    return 0;
}

int main(int argc, char **argv) {
    int missing = 0;
    if (argc < 3) return 2;
    for (int k = 2; k < argc; k++) {
        wcut_curve_set *set = NULL;
        wcut_error error;
        if (wcut_curve_set_read(argv[k], NULL, &set, &error) != WCUT_OK) {
            fprintf(stderr, "%s\n", error.text);
            return 1;
        }
        printf("%s: %d curves, %d left out: %s\n", argv[k], set->count, set->left_out, set->why);
        FILE *file = fopen(argv[1], "r");
        double g[7];
        int n = 0;
        for (; file && fscanf(file, "%lf %lf %lf %lf %lf %lf %lf", g, g + 1, g + 2, g + 3, g + 4, g + 5, g + 6) == 7;
             n++) {
            const int there = is_there(set, g);
            printf("  curve %d: %s\n", n, there ? "read" : "not read");
            missing += !there;
        }
        if (!file || n == 0) return 1;
        fclose(file);
        wcut_curve_set_destroy(set);
    }
    return missing ? 1 : 0;
}
