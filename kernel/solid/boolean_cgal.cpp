/* CGAL's corefinement booleans and its search for self-intersections, arrays in and out. */
#include "solid/boolean.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <climits>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "base/guard.hpp"
extern "C" {
#include "base/alloc.h"
}

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tags = Mesh::Property_map<Mesh::Face_index, unsigned char>;
namespace PMP = CGAL::Polygon_mesh_processing;

/* false where an edge would have more than two triangles, or two that run along it the same way */
bool boolean_load(const wcut_mesh &from, const unsigned char *tag, Mesh &mesh, Tags &tags) {
    tags = mesh.add_property_map<Mesh::Face_index, unsigned char>("f:tag", 0).first;
    mesh.reserve(from.vertex_count, 3 * from.triangle_count / 2, from.triangle_count);
    for (int k = 0; k < from.vertex_count; k++)
        mesh.add_vertex(Kernel::Point_3(from.vertex[k].x, from.vertex[k].y, from.vertex[k].z));
    for (int t = 0; t < from.triangle_count; t++) {
        const int *c = from.triangle + 3 * static_cast<std::ptrdiff_t>(t);
        const auto face = mesh.add_face(Mesh::Vertex_index(c[0]), Mesh::Vertex_index(c[1]), Mesh::Vertex_index(c[2]));
        if (face == Mesh::null_face()) return false;
        if (tag) tags[face] = tag[t];
    }
    return true;
}

wcut_status boolean_store(Mesh &from, const Tags &tags, wcut_mesh **result, unsigned char **tag) {
    /* compact the mesh, so that indices are consecutive */
    from.collect_garbage();
    const std::size_t vertices = from.number_of_vertices(), triangles = from.number_of_faces();
    if (vertices > INT_MAX || triangles > INT_MAX / 3) return WCUT_NO_MEMORY;

    /* arrays of our own */
    unsigned char *t = static_cast<unsigned char *>(wcut_alloc(triangles, sizeof *t));
    if (!t) return WCUT_NO_MEMORY;
    wcut_mesh *m = nullptr;
    const wcut_status status = wcut_mesh_create(static_cast<int>(vertices), static_cast<int>(triangles), 0, &m);
    if (status != WCUT_OK) {
        wcut_free(t);
        return status;
    }

    /* vertices, then triangles with their tags */
    for (const auto v : from.vertices()) {
        const auto &p = from.point(v);
        m->vertex[static_cast<std::size_t>(v)] = {p.x(), p.y(), p.z()};
    }
    int *to = m->triangle;
    for (const auto f : from.faces()) {
        for (const auto v : CGAL::vertices_around_face(from.halfedge(f), from)) *to++ = static_cast<int>(v);
        t[static_cast<std::size_t>(f)] = tags[f];
    }
    *result = m;
    *tag = t;

    return WCUT_OK;
}

/* carries the tag of a triangle over to its pieces, and from the inputs to the result */
struct Carry : PMP::Corefinement::Default_visitor<Mesh> {
    std::map<const Mesh *, Tags> *tags;
    unsigned char split = 0;

    explicit Carry(std::map<const Mesh *, Tags> *t) : tags(t) {}
    void before_subface_creations(Mesh::Face_index face, const Mesh &mesh) { split = tags->at(&mesh)[face]; }
    void after_subface_created(Mesh::Face_index face, const Mesh &mesh) { tags->at(&mesh)[face] = split; }
    void after_face_copy(Mesh::Face_index from, const Mesh &source, Mesh::Face_index to, const Mesh &target) {
        tags->at(&target)[to] = tags->at(&source)[from];
    }
};

}  // namespace

extern "C" wcut_status wcut_boolean_intersect(const wcut_mesh *a, const unsigned char *tag_a, const wcut_mesh *b,
                                              const unsigned char *tag_b, wcut_mesh **result, unsigned char **tag,
                                              wcut_error *error) {
    return wirecut::guard(error, [&] {
        Mesh x, y, both;
        std::map<const Mesh *, Tags> tags;
        if (!boolean_load(*a, tag_a, x, tags[&x]) || !boolean_load(*b, tag_b, y, tags[&y])) return WCUT_DEGENERATE;
        tags[&both] = both.add_property_map<Mesh::Face_index, unsigned char>("f:tag", 0).first;
        try {
            if (!PMP::corefine_and_compute_intersection(
                    x, y, both, CGAL::parameters::visitor(Carry(&tags)).throw_on_self_intersection(true)))
                return WCUT_DEGENERATE;
        } catch (const PMP::Corefinement::Self_intersection_exception &) {
            return WCUT_DEGENERATE;
        }
        return boolean_store(both, tags[&both], result, tag);
    });
}

extern "C" wcut_status wcut_self_intersections(const wcut_mesh *mesh, int *pairs, wcut_vec3 *place, wcut_error *error) {
    return wirecut::guard(error, [&] {
        Mesh x;
        Tags tags;
        if (!boolean_load(*mesh, nullptr, x, tags)) return WCUT_DEGENERATE;
        std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
        PMP::self_intersections(x, std::back_inserter(found));
        if (!found.empty()) {
            const auto &p = x.point(x.target(x.halfedge(found.front().first)));
            *place = {p.x(), p.y(), p.z()};
        }
        *pairs = found.size() > INT_MAX ? INT_MAX : static_cast<int>(found.size());
        return WCUT_OK;
    });
}
