/* Poisson reconstruction in space by CGAL: implicit function on a refined Delaunay tetrahedrisation, meshed. */
#define CGAL_EIGEN3_ENABLED 1
#include "scan/reconstruct_poisson_cgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/guard.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Poisson = CGAL::Poisson_reconstruction_function<Kernel>;
using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation>;

// the function less its median over the scan: CGAL's own level is that of all points, those that close the body too
struct Leveled {
    using FT = Kernel::FT;
    using Point = Kernel::Point_3;
    const Poisson *function;
    double level;
    double operator()(const Kernel::Point_3 &p) const { return (*function)(p)-level; }
};
using Surface = CGAL::Implicit_surface_3<Kernel, Leveled>;

constexpr double angle_least = 20;   // [deg] of a triangle: what the mesher is known to end with
constexpr double sphere_factor = 5;  // the mesher's start: a sphere that holds everything
constexpr double root_error = 1e-3;  // [1] of `distance`: of a point on the surface

// facets point to the cell that is outside
void facet_corners(const Complex &, const Complex::Facet &facet, Triangulation::Vertex_handle corner[3]) {
    for (int a = 0; a < 3; a++) corner[a] = facet.first->vertex(Triangulation::vertex_triple_index(facet.second, a));
}

double median_over(const Poisson &function, const std::vector<Oriented> &cloud, std::size_t count) {
    std::vector<double> value;
    value.reserve(count);
    for (std::size_t k = 0; k < count; k++) value.push_back(function(cloud[k].first));
    std::nth_element(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(count / 2), value.end());
    return value[count / 2];
}

wcut_status to_mesh(const Complex &complex, const Leveled &inside, wcut_mesh **mesh) {
    std::unordered_map<const void *, int> place;
    std::vector<wcut_vec3> vertex;
    std::vector<int> triangle;
    for (auto facet = complex.facets_begin(); facet != complex.facets_end(); ++facet) {
        Triangulation::Vertex_handle corner[3];
        facet_corners(complex, *facet, corner);
        // the function grows outwards: turn what looks inwards
        const auto a = corner[0]->point(), b = corner[1]->point(), c = corner[2]->point();
        const auto normal = CGAL::cross_product(b - a, c - a);
        const auto middle = CGAL::centroid(a, b, c);
        const double size = std::sqrt(normal.squared_length());
        if (!(size > 0)) continue;
        const auto step = normal * (0.5 * std::sqrt(size) / size);
        const bool outwards = inside(middle + step) > inside(middle - step);
        for (int k = 0; k < 3; k++) {
            const auto &v = corner[outwards ? k : 2 - k];
            const auto found = place.emplace(&*v, static_cast<int>(vertex.size()));
            if (found.second) vertex.push_back({v->point().x(), v->point().y(), v->point().z()});
            triangle.push_back(found.first->second);
        }
    }
    if (vertex.size() > INT_MAX / 8 || triangle.size() > INT_MAX / 8) return WCUT_NO_MEMORY;
    const wcut_status status = wcut_mesh_create(static_cast<int>(vertex.size()), static_cast<int>(triangle.size() / 3),
                                                WCUT_MESH_NORMAL | WCUT_MESH_UV | WCUT_MESH_SCALAR, mesh);
    if (status != WCUT_OK) return status;
    std::copy(vertex.begin(), vertex.end(), (*mesh)->vertex);
    std::copy(triangle.begin(), triangle.end(), (*mesh)->triangle);
    return WCUT_OK;
}

}  // namespace

extern "C" wcut_status wcut_poisson_cgal(int count, int scanned, const wcut_vec3 *point, const wcut_vec3 *normal,
                                         double size, double distance, uint64_t seed, wcut_mesh **mesh) {
    return wirecut::guard([&] {
        // both the implicit function and the mesher draw from it; by default it is seeded by the clock
        CGAL::get_default_random() = CGAL::Random(static_cast<unsigned int>(seed ^ (seed >> 32)));
        std::vector<Oriented> cloud;
        cloud.reserve(static_cast<std::size_t>(count));
        for (int k = 0; k < count; k++)
            cloud.emplace_back(Kernel::Point_3(point[k].x, point[k].y, point[k].z),
                               Kernel::Vector_3(normal[k].x, normal[k].y, normal[k].z));
        Poisson function(cloud.begin(), cloud.end(), CGAL::First_of_pair_property_map<Oriented>(),
                         CGAL::Second_of_pair_property_map<Oriented>());
        if (!function.compute_implicit_function()) return WCUT_NOT_CONVERGED;
        const double radius = sphere_factor * std::sqrt(function.bounding_sphere().squared_radius());
        const Kernel::Sphere_3 sphere(function.get_inner_point(), radius * radius);
        const Leveled leveled{&function, median_over(function, cloud, static_cast<std::size_t>(scanned))};
        const Surface surface(leveled, sphere, root_error * distance / radius);
        Triangulation triangulation;
        Complex complex(triangulation);
        const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(angle_least, size, distance);
        CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_with_boundary_tag());
        if (triangulation.number_of_vertices() == 0) return WCUT_NOT_CONVERGED;
        return to_mesh(complex, leveled, mesh);
    });
}
