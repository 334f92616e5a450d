/* STEP files (ISO 10303-21, application protocols 214 and 242): a product for each shape, in millimetres. */
#include <math.h>
#include <stdlib.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/shape_check.h"
#include "io/cad/step_shape.h"

/* what all shapes refer to */
typedef struct shared {
    wcut_id application, design, mechanical; /* contexts */
    wcut_id space, plane;                    /* representation contexts in three and two dimensions */
    wcut_id origin;
} shared;

static void put_step_header(wcut_text *text, const char *name, wcut_step_schema schema) {
    static const char *const identifier[] = {
        "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }",
        "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }",
    };
    wcut_part21 p = {text, 0};
    wcut_text_print(text, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('lengths in mm'),'2;1');\nFILE_NAME(");
    wcut_p21_string(&p, name);
    wcut_text_print(text, ",'',(''),(''),'wirecut %s','wirecut %s','');\nFILE_SCHEMA(('%s'));\nENDSEC;\nDATA;\n",
                    WCUT_VERSION, WCUT_VERSION, identifier[schema]);
}

static shared put_shared(wcut_part21 *p, wcut_step_schema schema) {
    static const char *const about[] = {"core data for automotive mechanical design processes",
                                        "managed model based 3d engineering"};
    static const char *const protocol[] = {"'automotive_design',2000",
                                           "'ap242_managed_model_based_3d_engineering',2014"};

    /* the application protocol and its two contexts */
    shared s;
    s.application = wcut_p21_put(p, "APPLICATION_CONTEXT('%s')", about[schema]);
    wcut_p21_put(p, "APPLICATION_PROTOCOL_DEFINITION('international standard',%s,#%ld)", protocol[schema],
                 s.application);
    s.mechanical = wcut_p21_put(p, "PRODUCT_CONTEXT('',#%ld,'mechanical')", s.application);
    s.design = wcut_p21_put(p, "PRODUCT_DEFINITION_CONTEXT('part definition',#%ld,'design')", s.application);

    /* millimetres, radians and the accuracy of a length */
    const wcut_id length = wcut_p21_put(p, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const wcut_id angle = wcut_p21_put(p, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const wcut_id solid = wcut_p21_put(p, "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const wcut_id fuzz = wcut_p21_put(
        p, "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),#%ld,'distance_accuracy_value','')", length);

    /* a context of space and one of a parameter plane */
    s.space = wcut_p21_put(p,
                           "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#%ld))\n"
                           "GLOBAL_UNIT_ASSIGNED_CONTEXT((#%ld,#%ld,#%ld))REPRESENTATION_CONTEXT('','3D'))",
                           fuzz, length, angle, solid);
    s.plane = wcut_p21_put(p,
                           "(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()"
                           "REPRESENTATION_CONTEXT('','2D'))");

    /* the origin of the block's frame */
    const wcut_id at = wcut_p21_point(p, (wcut_vec3){0, 0, 0}), axis = wcut_p21_direction(p, (wcut_vec3){0, 0, 1});
    const wcut_id ref = wcut_p21_direction(p, (wcut_vec3){1, 0, 0});
    s.origin = wcut_p21_put(p, "AXIS2_PLACEMENT_3D('',#%ld,#%ld,#%ld)", at, axis, ref);

    return s;
}

/* the shape's geometry and the kind of representation that may hold it; 0: no memory */
static wcut_id put_geometry(wcut_part21 *p, const wcut_shape *shape, const shared *s, const char **kind) {
    if (shape->solid) {
        *kind = "ADVANCED_BREP_SHAPE_REPRESENTATION";
        return wcut_step_solid(p, shape, s->plane, s->space);
    }
    if (shape->curve) {
        *kind = "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION";
        const wcut_id curve = wcut_step_curve(p, shape->name, shape->curve);
        return wcut_p21_put(p, "GEOMETRIC_CURVE_SET('',(#%ld))", curve);
    }
    if (wcut_step_has_border(shape->surface)) {
        *kind = "MANIFOLD_SURFACE_SHAPE_REPRESENTATION";
        return wcut_step_shell(p, shape->name, shape->surface, s->plane);
    }
    *kind = "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION";
    const wcut_id surface = wcut_step_surface(p, shape->name, shape->surface);
    return wcut_p21_put(p, "GEOMETRIC_SET('',(#%ld))", surface);
}

/* a product in the file, as an assembly refers to it */
typedef struct step_part {
    wcut_id definition, representation;
} step_part;

/* the product that a representation is the shape of */
static wcut_id put_product(wcut_part21 *p, const char *name, const shared *s, wcut_id representation) {
    const wcut_id product = wcut_p21_begin(p);
    wcut_text_print(p->text, "PRODUCT(");
    wcut_p21_string(p, name);
    wcut_text_print(p->text, ",");
    wcut_p21_string(p, name);
    wcut_text_print(p->text, ",'',(#%ld));\n", s->mechanical);
    const wcut_id version = wcut_p21_put(p, "PRODUCT_DEFINITION_FORMATION('','',#%ld)", product);
    const wcut_id definition = wcut_p21_put(p, "PRODUCT_DEFINITION('design','',#%ld,#%ld)", version, s->design);
    const wcut_id property = wcut_p21_put(p, "PRODUCT_DEFINITION_SHAPE('','',#%ld)", definition);
    wcut_p21_put(p, "SHAPE_DEFINITION_REPRESENTATION(#%ld,#%ld)", property, representation);
    wcut_p21_put(p, "PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#%ld))", product);
    return definition;
}

/* a product and its shape; false: no memory */
static bool put_step_shape(wcut_part21 *p, const wcut_shape *shape, const shared *s, step_part *part) {
    const char *kind = "";
    const wcut_id geometry = put_geometry(p, shape, s, &kind);
    if (geometry == 0) return false;
    part->representation = wcut_p21_put(p, "%s('',(#%ld,#%ld),#%ld)", kind, s->origin, geometry, s->space);
    part->definition = put_product(p, shape->name, s, part->representation);
    return true;
}

/* what a file holds */
typedef struct shapes {
    int count;
    const wcut_shape *shape; /* count */
    wcut_step_schema schema;
} shapes;

static bool put_shapes(wcut_text *text, const void *context) {
    const shapes *whole = context;
    wcut_part21 p = {text, 0};
    put_step_header(text, whole->shape[0].name, whole->schema);
    const shared s = put_shared(&p, whole->schema);
    bool done = true;
    step_part unused;
    for (int k = 0; done && k < whole->count; k++) done = put_step_shape(&p, &whole->shape[k], &s, &unused);
    wcut_text_print(text, "ENDSEC;\nEND-ISO-10303-21;\n");
    return done;
}

wcut_status wcut_step_write(int count, const wcut_shape *shape, wcut_step_schema schema, const char *path,
                            wcut_error *error) {
    const shapes whole = {count, shape, schema};
    wcut_status status = wcut_shapes_check(count, shape, path, error);
    if (status == WCUT_OK && (unsigned)schema >= WCUT_STEP_SCHEMA_COUNT)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "found an unknown STEP schema, expected AP214 or AP242");
    return status == WCUT_OK ? wcut_text_write_file(path, put_shapes, &whole, error) : status;
}

/* ---- assemblies ---- */

typedef struct assembly {
    const char *name;
    shapes parts;
    int places;
    const wcut_step_place *place; /* places */
} assembly;

/* An occurrence of a part: a usage, and the transformation that carries the part's origin to its place (part 44). */
static void put_occurrence(wcut_part21 *p, const wcut_step_place *place, int number, const step_part *part,
                           const step_part *whole, wcut_id from, wcut_id to) {
    const wcut_id usage = wcut_p21_begin(p);
    wcut_text_print(p->text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE('%d',", number + 1);
    wcut_p21_string(p, place->name);
    wcut_text_print(p->text, ",'',#%ld,#%ld,$);\n", whole->definition, part->definition);
    const wcut_id property = wcut_p21_put(p, "PRODUCT_DEFINITION_SHAPE('','',#%ld)", usage);
    const wcut_id carry = wcut_p21_put(p, "ITEM_DEFINED_TRANSFORMATION('','',#%ld,#%ld)", from, to);
    const wcut_id relation = wcut_p21_put(p,
                                          "(REPRESENTATION_RELATIONSHIP('','',#%ld,#%ld)\n"
                                          "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#%ld)\n"
                                          "SHAPE_REPRESENTATION_RELATIONSHIP())",
                                          part->representation, whole->representation, carry);
    wcut_p21_put(p, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#%ld,#%ld)", relation, property);
}

static bool put_assembly(wcut_text *text, const void *context) {
    const assembly *a = context;
    wcut_part21 p = {text, 0};
    put_step_header(text, a->name, a->parts.schema);
    const shared s = put_shared(&p, a->parts.schema);
    step_part *part = wcut_alloc((size_t)a->parts.count, sizeof *part), whole;
    wcut_id *axis = wcut_alloc((size_t)a->places, sizeof *axis);
    bool done = part && axis;

    /* the parts, then the places of all occurrences */
    for (int k = 0; done && k < a->parts.count; k++) done = put_step_shape(&p, &a->parts.shape[k], &s, &part[k]);
    for (int k = 0; done && k < a->places; k++) {
        const wcut_id at = wcut_p21_point(&p, a->place[k].origin);
        const wcut_id z = wcut_p21_direction(&p, a->place[k].z), x = wcut_p21_direction(&p, a->place[k].x);
        axis[k] = wcut_p21_put(&p, "AXIS2_PLACEMENT_3D('',#%ld,#%ld,#%ld)", at, z, x);
    }

    /* the assembly has them all, and uses each part where one says */
    if (done) {
        whole.representation = wcut_p21_begin(&p);
        wcut_text_print(text, "SHAPE_REPRESENTATION('',(#%ld", s.origin);
        for (int k = 0; k < a->places; k++) wcut_text_print(text, "%s#%ld", k % 10 ? "," : ",\n", axis[k]);
        wcut_text_print(text, "),#%ld);\n", s.space);
        whole.definition = put_product(&p, a->name, &s, whole.representation);
        for (int k = 0; k < a->places; k++)
            put_occurrence(&p, &a->place[k], k, &part[a->place[k].shape], &whole, s.origin, axis[k]);
    }
    wcut_text_print(text, "ENDSEC;\nEND-ISO-10303-21;\n");
    wcut_free(part);
    wcut_free(axis);
    return done;
}

/* axes of length 1 and perpendicular, a finite origin, a shape that is there */
static bool is_place_fine(const wcut_step_place *place, int count) {
    const wcut_vec3 x = place->x, z = place->z, o = place->origin;
    const double dot = x.x * z.x + x.y * z.y + x.z * z.z, size = fabs(o.x) + fabs(o.y) + fabs(o.z);
    return place->name && place->shape >= 0 && place->shape < count && size <= 1e12 &&
           fabs(x.x * x.x + x.y * x.y + x.z * x.z - 1) <= 1e-9 && fabs(z.x * z.x + z.y * z.y + z.z * z.z - 1) <= 1e-9 &&
           fabs(dot) <= 1e-9;
}

wcut_status wcut_step_write_assembly(const char *name, int count, const wcut_shape *shape, int places,
                                     const wcut_step_place *place, const char *path, wcut_error *error) {
    wcut_status status = wcut_shapes_check(count, shape, path, error);
    if (status != WCUT_OK) return status;
    if (!name || places < 1 || !place)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "assembly: expected a name and at least one place");
    for (int k = 0; k < places; k++)
        if (!is_place_fine(&place[k], count))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "assembly: place %d: expected a name, a shape of 0 to %d, a finite origin, and two "
                             "perpendicular axes of length 1",
                             k, count - 1);
    const assembly whole = {name, {count, shape, WCUT_STEP_SCHEMA_AP214}, places, place};
    return wcut_text_write_file(path, put_assembly, &whole, error);
}
