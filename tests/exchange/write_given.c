/* Write everything that is exchanged into a folder, with the figures that a reader must find in `given.json`:
   write_given FOLDER [LOCALE] */
#include <locale.h>
#include <stdio.h>
#include <unistd.h>

#include "exchange/given_parts.h"
#include "io/file/number.h"

static wcut_error error;

static void must(wcut_status status) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "%s: %s\n", wcut_status_text(status), error.text);
    exit(1);
}

static void put_number(FILE *file, const char *before, double value) {
    char text[WCUT_NUMBER_SIZE];
    fprintf(file, "%s%.*s", before, wcut_number_print(value, text), text);
}

/* "name": {"poles": [[x,y,z], ..], "weights": [..]}, poles in our order */
static void put_poles(FILE *file, const char *name, size_t count, const wcut_vec3 *pole, const double *weight) {
    fprintf(file, " \"%s\": {\"poles\": [", name);
    for (size_t k = 0; k < count; k++) {
        put_number(file, k ? ",[" : "[", pole[k].x);
        put_number(file, ",", pole[k].y);
        put_number(file, ",", pole[k].z);
        fputs("]", file);
    }
    fputs("], \"weights\": [", file);
    for (size_t k = 0; weight && k < count; k++) put_number(file, k ? "," : "", weight[k]);
    fputs("]},\n", file);
}

static void put_surface(FILE *file, const char *name, const wcut_surface *s) {
    put_poles(file, name, (size_t)s->count_u * (size_t)s->count_v, s->control, s->weights);
}

static void put_curve(FILE *file, const char *name, const wcut_curve *c) {
    put_poles(file, name, (size_t)c->control_count, c->control, c->weights);
}

static void write_parts(FILE *file) {
    wcut_surface *loft = given_loft(41, 31), *cylinder = given_cylinder(), *patch = given_patch();
    wcut_curve *curve = given_curve(), *arc = given_arc();
    const wcut_shape shape[] = {{.name = "loft", .surface = loft},
                                {.name = "cylinder 'quoted' \xc3\xbc", .surface = cylinder},
                                {.name = "curve", .curve = curve},
                                {.name = "arc", .curve = arc}};
    must(wcut_step_write(4, shape, WCUT_STEP_SCHEMA_AP214, "parts.step", &error));
    must(wcut_step_write(4, shape, WCUT_STEP_SCHEMA_AP242, "parts-242.step", &error));
    must(wcut_iges_write(4, shape, "parts.igs", &error));
    const wcut_shape sheet = {.name = "loft", .surface = patch};
    must(wcut_step_write(1, &sheet, WCUT_STEP_SCHEMA_AP214, "patch.step", &error));
    put_surface(file, "loft", loft);
    put_surface(file, "cylinder", cylinder);
    put_curve(file, "curve", curve);
    put_curve(file, "arc", arc);
    put_surface(file, "patch", patch);
    wcut_curve_destroy(arc);
    wcut_curve_destroy(curve);
    wcut_surface_destroy(patch);
    wcut_surface_destroy(cylinder);
    wcut_surface_destroy(loft);
}

static void write_solids(FILE *file) {
    given_solid lower, upper;
    given_solid_create(&lower, 0);
    given_solid_create(&upper, 1);
    const wcut_shape both[] = {{.name = "lower", .solid = &lower.brep}, {.name = "upper", .solid = &upper.brep}};
    must(wcut_step_write(2, both, WCUT_STEP_SCHEMA_AP214, "solids.step", &error));
    must(wcut_step_write(2, both, WCUT_STEP_SCHEMA_AP242, "solids-242.step", &error));
    put_number(file, " \"volume\": {\"lower\": ", lower.volume);
    put_number(file, ", \"upper\": ", upper.volume);
    fputs("},\n", file);
    given_solid_destroy(&upper);
    given_solid_destroy(&lower);
}

/* both halves of a cut block with keys, exactly and as triangles, and the surface's colours */
static void write_mould(FILE *file) {
    static const wcut_key key[] = {{0, 60, 60, 15, 10, 12}, {0, 340, 540, 15, 10, -12}, {1, 340, 60, 15, 10, 12}};
    wcut_surface *loft = given_loft(41, 31);
    wcut_mould *mould = NULL;
    wcut_mould_options options = wcut_mould_default();
    options.key_count = 3;
    options.key = key;
    must(wcut_mould_create(loft, (wcut_vec3){400, 600, 200}, &options, &mould, &error));
    const wcut_shape both[] = {{.name = "lower", .solid = mould->lower.brep},
                               {.name = "upper", .solid = mould->upper.brep}};
    must(wcut_step_write(2, both, WCUT_STEP_SCHEMA_AP214, "mould.step", &error));
    const wcut_mesh *mesh[] = {mould->lower.mesh, mould->upper.mesh};
    const wcut_mesh_object object[] = {{.mesh = mesh[0], .name = "lower"}, {.mesh = mesh[1], .name = "upper"}};
    must(wcut_mesh_write_3mf(2, object, "mould.3mf", &error));
    for (int k = 0; k < 2; k++) {
        static const char *const target[][4] = {{"lower.stl", "lower.ply", "lower.obj", "lower.glb"},
                                                {"upper.stl", "upper.ply", "upper.obj", "upper.glb"}};
        must(wcut_mesh_write_stl(mesh[k], target[k][0], &error));
        must(wcut_mesh_write_ply(mesh[k], "value", target[k][1], &error));
        must(wcut_mesh_write_obj(mesh[k], target[k][2], &error));
        must(wcut_mesh_write_glb(mesh[k], target[k][3], &error));
        const wcut_half_report *r = k ? &mould->upper.report : &mould->lower.report;
        fprintf(file, " \"%s\": {\"triangles\": %d, \"vertices\": %d, ", object[k].name, mesh[k]->triangle_count,
                mesh[k]->vertex_count);
        put_number(file, "\"volume\": ", r->volume);
        put_number(file, ", \"area\": ", r->area);
        put_number(file, ", \"low\": [", r->box_low.x);
        put_number(file, ",", r->box_low.y);
        put_number(file, ",", r->box_low.z);
        put_number(file, "], \"high\": [", r->box_high.x);
        put_number(file, ",", r->box_high.y);
        put_number(file, ",", r->box_high.z);
        fputs("]},\n", file);
    }
    put_number(file, " \"mould\": {\"block\": ", mould->block_volume);
    double keys = 0; /* exactly, where the report's are those of the triangles */
    for (int k = 0; k < 3; k++) {
        const double r = key[k].radius, tip = key[k].tip_radius;
        keys += acos(-1) * key[k].height / 3 * (r * r + r * tip + tip * tip);
    }
    put_number(file, ", \"keys\": ", keys);
    fputs("},\n", file);
    wcut_mould_destroy(mould);
    wcut_surface_destroy(loft);
}

int main(int argc, char **argv) {
    if (argc < 2 || chdir(argv[1]) != 0) return 2;
    if (argc > 2 && !setlocale(LC_ALL, argv[2])) return 2;
    FILE *file = fopen("given.json", "w");
    if (!file) return 1;
    fputs("{\n", file);
    write_parts(file);
    write_solids(file);
    write_mould(file);
    fputs(" \"unit\": \"mm\"\n}\n", file);
    return fclose(file) == 0 ? 0 : 1;
}
