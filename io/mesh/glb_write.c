/* Triangles to binary glTF through assimp, in memory, then to disk by our own writer (assimp says success on a full
   disk). */
#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/mesh/colour.h"
#include "io/mesh/mesh_write.h"

/* a scene is a web of pointers: all of its parts in one place that is freed as one */
typedef struct glb_scene {
    struct aiScene scene;
    struct aiNode root, child;
    struct aiNode *children[1];
    struct aiMesh mesh;
    struct aiMesh *meshes[1];
    unsigned mesh_index[1];
    struct aiMaterial material;
    struct aiMaterial *materials[1];
    struct aiMaterialProperty property[3];
    struct aiMaterialProperty *properties[3];
    float metallic, roughness;
    int32_t two_sided;
    unsigned *corner;
} glb_scene;

/* one mesh in 32-bit offsets, and what assimp spends on it while it joins vertices */
enum { TRIANGLES_MAX = 30000000 };

static void name(struct aiString *to, const char *text) {
    to->length = (ai_uint32)snprintf(to->data, sizeof to->data, "%s", text);
}

static double linear_of_srgb(double byte) {
    double s = byte / 255;
    return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4);
}

/* glTF's vertex colours are linear */
static void fill_colours(struct aiColor4D *colour, int count, const double *scalar) {
    double min, greatest, rgb[3];
    wcut_range(count, scalar, &min, &greatest);
    for (int i = 0; i < count; i++) {
        wcut_colour(wcut_colour_parameter(scalar[i], min, greatest), rgb);
        colour[i] = (struct aiColor4D){(float)linear_of_srgb(rgb[0]), (float)linear_of_srgb(rgb[1]),
                                       (float)linear_of_srgb(rgb[2]), 1};
    }
}

static struct aiVector3D *copy_vectors(const wcut_vec3 *from, int count) {
    struct aiVector3D *to = wcut_alloc((size_t)count, sizeof *to);
    for (int i = 0; to && i < count; i++)
        to[i] = (struct aiVector3D){(float)from[i].x, (float)from[i].y, (float)from[i].z};
    return to;
}

static bool fill_faces(glb_scene *glb, const wcut_mesh *mesh) {
    size_t count = (size_t)mesh->triangle_count;
    glb->corner = wcut_alloc(3 * count, sizeof *glb->corner);
    glb->mesh.mFaces = wcut_alloc(count, sizeof *glb->mesh.mFaces);
    if (!glb->corner || !glb->mesh.mFaces) return false;
    for (size_t k = 0; k < 3 * count; k++) glb->corner[k] = (unsigned)mesh->triangle[k];
    for (size_t t = 0; t < count; t++) glb->mesh.mFaces[t] = (struct aiFace){3, glb->corner + 3 * t};
    glb->mesh.mNumFaces = (unsigned)count;
    return true;
}

static bool fill_mesh(glb_scene *glb, const wcut_mesh *mesh) {
    struct aiMesh *to = &glb->mesh;
    name(&to->mName, "surface");
    to->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    to->mNumVertices = (unsigned)mesh->vertex_count;
    to->mVertices = copy_vectors(mesh->vertex, mesh->vertex_count);
    if (!to->mVertices || !fill_faces(glb, mesh)) return false;
    if (mesh->normal) to->mNormals = copy_vectors(mesh->normal, mesh->vertex_count);
    if (mesh->normal && !to->mNormals) return false;
    if (!mesh->scalar) return true;
    to->mColors[0] = wcut_alloc((size_t)mesh->vertex_count, sizeof *to->mColors[0]);
    if (!to->mColors[0]) return false;
    fill_colours(to->mColors[0], mesh->vertex_count, mesh->scalar);
    return true;
}

static void fill_property(glb_scene *glb, int k, const char *key, enum aiPropertyTypeInfo type, void *data) {
    struct aiMaterialProperty *property = &glb->property[k];
    name(&property->mKey, key);
    property->mType = type;
    property->mDataLength = 4;
    property->mData = data;
    glb->properties[k] = property;
}

/* dull and seen from both sides: glTF's default is polished metal, black without surroundings */
static void fill_material(glb_scene *glb) {
    glb->metallic = 0;
    glb->roughness = 0.8F;
    glb->two_sided = 1;
    fill_property(glb, 0, "$mat.metallicFactor", aiPTI_Float, &glb->metallic);
    fill_property(glb, 1, "$mat.roughnessFactor", aiPTI_Float, &glb->roughness);
    fill_property(glb, 2, "$mat.twosided", aiPTI_Integer, &glb->two_sided);
    glb->material = (struct aiMaterial){glb->properties, 3, 3};
}

static bool fill_scene(glb_scene *glb, const wcut_mesh *mesh) {
    if (!fill_mesh(glb, mesh)) return false;
    fill_material(glb);
    name(&glb->root.mName, "wirecut_mm_to_m");
    /* millimetres to metres, and our z to glTF's y: (x, y, z) -> (x, z, -y) / 1000 */
    const float s = 0.001F;
    glb->root.mTransformation = (struct aiMatrix4x4){s, 0, 0, 0, 0, 0, s, 0, 0, -s, 0, 0, 0, 0, 0, 1};
    glb->root.mNumChildren = 1;
    glb->root.mChildren = glb->children;
    glb->children[0] = &glb->child;
    name(&glb->child.mName, "surface");
    glb->child.mTransformation = (struct aiMatrix4x4){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    glb->child.mParent = &glb->root;
    glb->child.mNumMeshes = 1;
    glb->child.mMeshes = glb->mesh_index;
    glb->meshes[0] = &glb->mesh;
    glb->materials[0] = &glb->material;
    glb->scene.mFlags = AI_SCENE_FLAGS_NON_VERBOSE_FORMAT; /* vertices are shared */
    glb->scene.mRootNode = &glb->root;
    glb->scene.mNumMeshes = 1;
    glb->scene.mMeshes = glb->meshes;
    glb->scene.mNumMaterials = 1;
    glb->scene.mMaterials = glb->materials;
    return true;
}

static void free_scene(glb_scene *glb) {
    if (!glb) return;
    free(glb->mesh.mVertices);
    free(glb->mesh.mNormals);
    free(glb->mesh.mColors[0]);
    free(glb->mesh.mFaces);
    free(glb->corner);
    free(glb);
}

static wcut_status write_blob(const struct aiExportDataBlob *blob, const char *path, wcut_error *error) {
    char label[WCUT_QUOTE_SIZE], cause[WCUT_QUOTE_SIZE];
    if (!blob || blob->size < 12 || memcmp(blob->data, "glTF", 4) != 0)
        return wcut_fail(error, WCUT_NOT_WRITTEN, "%s: not written: assimp made no glTF of it: %s",
                         wcut_quote(label, path, WCUT_LABEL_MAX, 1),
                         wcut_quote(cause, aiGetErrorString(), WCUT_FOUND_MAX, 0));
    return wcut_file_write_whole(path, blob->data, blob->size, error);
}

wcut_status wcut_mesh_write_glb(const wcut_mesh *mesh, const char *path, wcut_error *error) {
    char label[WCUT_QUOTE_SIZE];
    wcut_status status = wcut_mesh_check(mesh, path, error);
    if (status != WCUT_OK) return status;
    if (mesh->triangle_count > TRIANGLES_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %d triangles, expected at most %d in a GLB",
                         wcut_quote(label, path, WCUT_LABEL_MAX, 1), mesh->triangle_count, TRIANGLES_MAX);
    glb_scene *glb = wcut_alloc(1, sizeof *glb);
    if (!glb || !fill_scene(glb, mesh)) {
        free_scene(glb);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    const struct aiExportDataBlob *blob = aiExportSceneToBlob(&glb->scene, "glb2", 0);
    free_scene(glb);
    status = write_blob(blob, path, error);
    if (blob) aiReleaseExportBlob(blob);
    return status;
}
