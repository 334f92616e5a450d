/* Meshes that assimp reads, in a process of its own: it crashes on broken files, and asks for files beside them. */
#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <wirecut/cloud_file.h>
#include "base/fail.h"
#include "io/file/child.h"
#include "io/mesh/mesh_formats.h"

enum { DEPTH_MAX = 200, ENOUGH = 64, MESSAGE_HEAD = 2 * sizeof(int32_t) };
enum { DONE, NOTHING_READ, TOO_DEEP, TOO_MANY, NOT_SENT };
static const uint32_t LAST_WORD = 0x57435554; /* behind the last triangle: nothing is missing */

/* ---- in the child: one file in memory, and no other ---- */

typedef struct request {
    const char *bytes;
    size_t size, at;
    const char *ending;
    int max;          /* triangles, or vertices where these are all that is wanted */
    bool as_vertices; /* each place once, no triangles */
} request;

static size_t read_some(struct aiFile *file, char *to, size_t size, size_t count) {
    request *r = (request *)file->UserData;
    if (size == 0) return 0;
    const size_t left = (r->size - r->at) / size, n = count < left ? count : left;
    memcpy(to, r->bytes + r->at, n * size);
    r->at += n * size;
    return n;
}

static size_t write_none(struct aiFile *file, const char *from, size_t size, size_t count) {
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t tell_offset(struct aiFile *file) { return ((request *)file->UserData)->at; }

static size_t tell_size(struct aiFile *file) { return ((request *)file->UserData)->size; }

static enum aiReturn seek(struct aiFile *file, size_t offset, enum aiOrigin origin) {
    request *r = (request *)file->UserData;
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? r->at : r->size;
    if (offset > r->size - from) return aiReturn_FAILURE;
    r->at = from + offset;
    return aiReturn_SUCCESS;
}

static void flush_nothing(struct aiFile *file) { (void)file; }

static void file_name(const request *r, char name[ENOUGH]) { snprintf(name, ENOUGH, "mesh%s", r->ending); }

static struct aiFile *open_one(struct aiFileIO *io, const char *path, const char *mode) {
    request *r = (request *)io->UserData;
    char name[ENOUGH];
    file_name(r, name);
    if (strcmp(path, name) != 0 || mode[0] != 'r') return NULL;
    struct aiFile *file = calloc(1, sizeof *file);
    if (!file) return NULL;
    r->at = 0;
    *file = (struct aiFile){read_some, write_none, tell_offset, tell_size, seek, flush_nothing, (char *)r};
    return file;
}

static void close_one(struct aiFileIO *io, struct aiFile *file) {
    (void)io;
    free(file);
}

/* ---- in the child: the scene's triangles, each node's meshes where the node puts them ---- */

typedef struct message {
    int fd, depth, vertices, triangles, max;
    bool as_vertices;
    int base; /* of the indices of the mesh being sent */
} message;

static void multiply(const struct aiMatrix4x4 *local, const double above[12], double product[12]) {
    const double m[16] = {local->a1, local->a2, local->a3, local->a4, local->b1, local->b2, local->b3, local->b4,
                          local->c1, local->c2, local->c3, local->c4, 0,         0,         0,         1};
    for (size_t i = 0; i < 12; i += 4)
        for (size_t j = 0; j < 4; j++)
            product[i + j] =
                above[i] * m[j] + above[i + 1] * m[4 + j] + above[i + 2] * m[8 + j] + (j == 3 ? above[i + 3] : 0);
}

static bool is_mirrored(const double m[12]) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]) <
           0;
}

static bool send_vertices(const struct aiMesh *mesh, const double m[12], int fd) {
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D v = mesh->mVertices[i];
        double p[3];
        for (size_t k = 0; k < 3; k++) p[k] = m[4 * k] * v.x + m[4 * k + 1] * v.y + m[4 * k + 2] * v.z + m[4 * k + 3];
        if (!wcut_child_write(fd, p, sizeof p)) return false;
    }
    return true;
}

/* points and lines bound nothing */
static bool send_triangles(const struct aiMesh *mesh, bool mirrored, const message *t) {
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        if (mesh->mFaces[f].mNumIndices != 3) continue;
        const unsigned *v = mesh->mFaces[f].mIndices;
        const int32_t corner[3] = {t->base + (int)v[0], t->base + (int)v[mirrored ? 2 : 1],
                                   t->base + (int)v[mirrored ? 1 : 2]};
        if (!wcut_child_write(t->fd, corner, sizeof corner)) return false;
    }
    return true;
}

static int count_triangles(const struct aiMesh *mesh, message *t) {
    const int max = t->as_vertices ? t->max : INT_MAX;
    if (mesh->mNumVertices > (unsigned)(max - t->vertices)) return TOO_MANY;
    t->vertices += (int)mesh->mNumVertices;
    if (t->as_vertices) return DONE;
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        if (mesh->mFaces[f].mNumIndices != 3) continue;
        if (t->triangles == t->max) return TOO_MANY;
        t->triangles++;
    }
    return DONE;
}

enum { COUNT, SEND_VERTICES, SEND_TRIANGLES };

/* one pass over a node and those below */
static int walk_nodes(const struct aiScene *scene, const struct aiNode *node, const double above[12], int pass,
                      message *t) {
    double m[12];
    int code = DONE;
    if (t->depth == DEPTH_MAX) return TOO_DEEP;
    multiply(&node->mTransformation, above, m);
    for (unsigned k = 0; code == DONE && k < node->mNumMeshes; k++) {
        const struct aiMesh *mesh = scene->mMeshes[node->mMeshes[k]];
        if (pass == COUNT) code = count_triangles(mesh, t);
        if (pass == SEND_VERTICES) code = send_vertices(mesh, m, t->fd) ? DONE : NOT_SENT;
        if (pass == SEND_TRIANGLES) code = send_triangles(mesh, is_mirrored(m), t) ? DONE : NOT_SENT;
        if (pass == SEND_TRIANGLES) t->base += (int)mesh->mNumVertices;
    }
    t->depth++;
    for (unsigned k = 0; code == DONE && k < node->mNumChildren; k++)
        code = walk_nodes(scene, node->mChildren[k], m, pass, t);
    t->depth--;
    return code;
}

static int send_scene(const struct aiScene *scene, int fd, const request *r) {
    static const double here[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    message t = {.fd = fd, .max = r->max, .as_vertices = r->as_vertices};
    const int last_pass = r->as_vertices ? SEND_VERTICES : SEND_TRIANGLES;
    int code = walk_nodes(scene, scene->mRootNode, here, COUNT, &t);
    const int32_t head[2] = {t.vertices, t.triangles};
    if (code == DONE && !wcut_child_write(fd, head, sizeof head)) code = NOT_SENT;
    for (int pass = SEND_VERTICES; code == DONE && pass <= last_pass; pass++)
        code = walk_nodes(scene, scene->mRootNode, here, pass, &t);
    if (code == DONE && !wcut_child_write(fd, &LAST_WORD, sizeof LAST_WORD)) code = NOT_SENT;
    return code;
}

/* the name's ending has one importer, so that assimp looks for no other */
static int import(int fd, void *context) {
    request *r = context;
    struct aiFileIO io = {open_one, close_one, (char *)r};
    char name[ENOUGH];
    file_name(r, name);
    const unsigned steps = r->as_vertices ? aiProcess_JoinIdenticalVertices : aiProcess_Triangulate;
    const struct aiScene *scene = aiImportFileEx(name, steps | aiProcess_ValidateDataStructure, &io);
    return scene && scene->mRootNode ? send_scene(scene, fd, r) : NOTHING_READ;
}

/* ---- in the parent: the message, believed in nothing ---- */

/* how many vertices and triangles it holds, and that it is whole */
static bool check_message(wcut_source *s, const char *data, size_t length, int32_t head[2]) {
    uint32_t last = 0;
    head[0] = head[1] = -1;
    if (length >= MESSAGE_HEAD) memcpy(head, data, MESSAGE_HEAD);
    const size_t vertices = (size_t)head[0], triangles = (size_t)head[1];
    if (head[0] < 0 || head[1] < 0 ||
        length != MESSAGE_HEAD + vertices * 3 * sizeof(double) + triangles * 3 * sizeof(int32_t) + sizeof last)
        return wcut_source_refuse(s, "found half a mesh from assimp's process, expected all of it");
    memcpy(&last, data + length - sizeof last, sizeof last);
    return last == LAST_WORD || wcut_source_refuse(s, "found no end of the mesh from assimp's process");
}

/* glTF has y upwards */
static void take_position(const char *at, bool is_gltf, double position[3]) {
    double p[3];
    memcpy(p, at, sizeof p);
    position[0] = p[0], position[1] = is_gltf ? -p[2] : p[1], position[2] = is_gltf ? p[1] : p[2];
}

static bool take_triangles(wcut_source *s, wcut_mesh_builder *g, bool is_gltf, const char *data,
                           const int32_t head[2]) {
    wcut_numbered n = {0};
    bool done = true;

    /* vertices in the order of the message; equal ones become one */
    const char *at = data + MESSAGE_HEAD;
    for (int32_t i = 0; done && i < head[0]; i++, at += 3 * sizeof(double)) {
        double position[3];
        take_position(at, is_gltf, position);
        done = wcut_numbered_add(g, &n, position);
    }

    /* triangles: every index is checked, because a file made them */
    for (int32_t t = 0; done && t < head[1]; t++, at += 3 * sizeof(int32_t)) {
        int32_t v[3];
        memcpy(v, at, sizeof v);
        for (int k = 0; done && k < 3; k++) {
            done = v[k] >= 0 && v[k] < n.count;
            if (!done) wcut_source_refuse(s, "found a corner at vertex %d, expected 0 to %d", v[k], n.count - 1);
            v[k] = done ? wcut_numbered_use(g, &n, v[k]) : 0;
            done = done && v[k] >= 0;
        }
        done = done && wcut_mesh_builder_triangle(g, v[0], v[1], v[2]);
    }

    /* the numbering is needed only while the mesh is built */
    wcut_numbered_free(&n);
    return done;
}

static bool refuse_end(wcut_source *s, wcut_child_end end, const request *r, int seconds) {
    /* how the child ended, as far as it can be told */
    switch (end.how) {
        case WCUT_CHILD_NO_MEMORY:
            return wcut_source_refuse_memory(s);
        case WCUT_CHILD_CRASHED:
            return wcut_source_refuse(s, "assimp crashed on it (signal %d), expected a sound %s file", end.code,
                                      r->ending + 1);
        case WCUT_CHILD_SLOW:
            return wcut_source_refuse(s, "assimp took more than %d s for it", seconds);
        case WCUT_CHILD_NOT_STARTED:
            wcut_fail_errno(&s->failure, WCUT_NO_MEMORY, end.code, s->label, "no process to read it in");
            return false;
        default:
            break;
    }

    /* it wrote more than the limit, or said that there is more */
    if (end.how == WCUT_CHILD_TALKATIVE || end.code == TOO_MANY)
        return wcut_source_refuse(s, "found more than %d %s, expected at most that", r->max,
                                  r->as_vertices ? "vertices" : "triangles");
    if (end.code == TOO_DEEP) return wcut_source_refuse(s, "found nodes nested more than %d deep", DEPTH_MAX);

    return wcut_source_refuse(s, "assimp reads no mesh in it, expected a sound %s file", r->ending + 1);
}

/* what is left of the source, in memory; NULL: refused */
static char *slurp(wcut_source *s, size_t *size) {
    /* the stream is read to its end, up to a limit that assimp can hold */
    const size_t max = (size_t)1 << 30;
    char *bytes = NULL;
    size_t room = 0;
    for (size_t got; (got = wcut_stream_fill(&s->stream, 1)) > 0; *size += got) {
        if (*size + got > max) {
            wcut_source_refuse(s, "found more than 1024 MB, expected at most that of this format");
            break;
        }
        if (!wcut_mesh_builder_room((void **)&bytes, &room, *size + got, 1)) {
            wcut_source_refuse_memory(s);
            break;
        }

        /* take what the stream holds, and let it read on */
        memcpy(bytes + *size, s->stream.data + s->stream.at, got);
        s->stream.at += got;
    }

    /* a read error is told before the bytes are used */
    if (s->failure.status == WCUT_OK && s->stream.code) wcut_source_refuse_end(s, "more");
    if (s->failure.status == WCUT_OK) return bytes;

    free(bytes);
    return NULL;
}

/* a file beside this one that its text names, copied; NULL: none is named */
static const char *find_neighbour(const char *bytes, size_t size, char name[ENOUGH]) {
    static const char key[] = "\"uri\"", list[] = "\"buffers\"";
    bool is_inside = false;
    for (size_t k = 0; k + sizeof list < size; k++) {
        /* of the buffers alone: pictures are not needed */
        if (memcmp(bytes + k, list, sizeof list - 1) == 0) is_inside = true;
        if (bytes[k] == ']') is_inside = false;
        if (!is_inside || memcmp(bytes + k, key, sizeof key - 1) != 0) continue;
        size_t at = k + sizeof key - 1, n = 0;
        while (at < size &&
               (bytes[at] == ' ' || bytes[at] == ':' || bytes[at] == '\n' || bytes[at] == '\r' || bytes[at] == '\t'))
            at++;
        if (at >= size || bytes[at++] != '"' || (size - at > 5 && memcmp(bytes + at, "data:", 5) == 0)) continue;
        while (at < size && bytes[at] != '"' && n < ENOUGH - 1) name[n++] = bytes[at++];
        name[n] = '\0';
        return name;
    }
    return NULL;
}

/* glTF is told by its first bytes: another format's numbers would be read as metres */
static bool check_gltf(wcut_source *s, const char *bytes, size_t size) {
    size_t at = 0;
    while (at < size && strchr(" \t\r\n\xef\xbb\xbf", bytes[at]) && bytes[at]) at++;
    if ((size >= 4 && memcmp(bytes, "glTF", 4) == 0) || (at < size && bytes[at] == '{')) return true;
    s->stream.at = s->stream.end;
    return wcut_source_refuse(s, "found neither glTF nor {, expected a glTF file");
}

/* the file's mesh as the child sends it, whole; NULL: refused */
static char *ask(wcut_source *s, request *r, size_t of_each, int seconds, int32_t head[2]) {
    size_t length = 0;

    /* the whole file, because assimp reads from memory */
    char *bytes = slurp(s, &r->size), *data = NULL;
    if (!bytes) {
        if (s->failure.status == WCUT_OK) wcut_source_refuse_end(s, "a mesh");
        return NULL;
    }
    r->bytes = bytes;

    /* a glTF file must hold all it needs */
    if (!check_gltf(s, bytes, r->size)) return free(bytes), NULL;
    char beside[ENOUGH], shown[WCUT_QUOTE_SIZE];
    if (find_neighbour(bytes, r->size, beside)) {
        wcut_source_refuse(
            s, "its data are in another file, \"%s\", expected one file: a .glb, or a .gltf that embeds them",
            wcut_quote(shown, beside, WCUT_FOUND_MAX, 0));
        return free(bytes), NULL;
    }

    /* the child has limits of time, memory and output */
    const wcut_child_limits limits = {seconds, (size_t)4 << 30, (size_t)r->max * of_each + ENOUGH};
    const wcut_child_end end = wcut_child_run(import, r, &limits, &data, &length);
    free(bytes);
    const bool done = end.how == WCUT_CHILD_DONE && end.code == DONE ? check_message(s, data, length, head)
                                                                     : refuse_end(s, end, r, seconds);
    if (done) return data;

    free(data);
    return NULL;
}

static bool is_gltf(const char *ending) { return strcmp(ending, ".glb") == 0 || strcmp(ending, ".gltf") == 0; }

bool wcut_mesh_fill_foreign(wcut_source *s, wcut_mesh_builder *g, const char *ending, int seconds) {
    request r = {.ending = ending, .max = g->max};
    int32_t head[2] = {0};
    if (is_gltf(ending)) s->scale = 1000;
    char *data = ask(s, &r, 3 * (3 * sizeof(double) + sizeof(int32_t)), seconds, head);
    const bool done = data && take_triangles(s, g, is_gltf(ending), data, head);
    free(data);
    return done;
}

bool wcut_mesh_vertices_foreign(wcut_source *s, const char *ending, int max, int seconds, double **position,
                                int *count) {
    request r = {.ending = ending, .max = max, .as_vertices = true};
    int32_t head[2] = {0};
    if (is_gltf(ending)) s->scale = 1000;
    char *data = ask(s, &r, 3 * sizeof(double), seconds, head);
    if (!data) return false;
    double *to = (void *)data; /* in place: the head is shorter than a position */
    for (int32_t i = 0; i < head[0]; i++) {
        double p[3];
        take_position(data + MESSAGE_HEAD + (size_t)i * sizeof p, is_gltf(ending), p);
        memcpy(to + 3 * (size_t)i, p, sizeof p);
    }
    *position = to, *count = head[0];
    return true;
}
