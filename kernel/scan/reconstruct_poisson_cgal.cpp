/* Poisson reconstruction in space by CGAL: the implicit function on a refined Delaunay tetrahedrisation. */
#define CGAL_EIGEN3_ENABLED 1
#include "scan/reconstruct_poisson_cgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/Random.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/guard.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Poisson = CGAL::Poisson_reconstruction_function<Kernel>;

constexpr int steps = 8;      // to either side of a place, in search of a crossing
constexpr int halvings = 24;  // of a step

// CGAL's own level is that of all points, those that only close the volume too
double median_over(const Poisson &function, const std::vector<Oriented> &cloud, int count) {
    std::vector<double> value;
    for (int k = 0; k < count; k++) value.push_back(function(cloud[static_cast<std::size_t>(k)].first));
    std::nth_element(value.begin(), value.begin() + count / 2, value.end());
    return value[static_cast<std::size_t>(count / 2)];
}

// the function less its level along one line: negative inside
struct Line {
    const Poisson &function;
    double level;
    wcut_vec3 from, direction;

    double operator()(double t) const {
        return function(Kernel::Point_3(from.x + t * direction.x, from.y + t * direction.y, from.z + t * direction.z)) -
               level;
    }

    double crossing_between(double low, double high) const {
        for (int k = 0; k < halvings; k++) {
            const double middle = (low + high) / 2;
            ((*this)(middle) < 0 ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    // outwards if the place is inside, inwards if it is outside: the first crossing from inside to outside
    bool find(double reach, double *along) const {
        const double sign = (*this)(0) < 0 ? 1 : -1;
        for (int k = 1; k <= steps; k++) {
            const double near = sign * reach * (k - 1) / steps, far = sign * reach * k / steps;
            if (((*this)(far) < 0) == (sign > 0)) continue;
            *along = sign > 0 ? crossing_between(near, far) : crossing_between(far, near);
            return true;
        }
        return false;
    }
};

}  // namespace

extern "C" wcut_status wcut_poisson_cross(int count, int scanned, const wcut_vec3 *point, const wcut_vec3 *normal,
                                          uint64_t seed, int lines, const wcut_vec3 *from, const wcut_vec3 *direction,
                                          double reach, double *along, unsigned char *crossed) {
    return wirecut::guard([&] {
        // it draws from this one, which is seeded by the clock
        CGAL::get_default_random() = CGAL::Random(static_cast<unsigned int>(seed ^ (seed >> 32)));
        std::vector<Oriented> cloud;
        for (int k = 0; k < count; k++)
            cloud.emplace_back(Kernel::Point_3(point[k].x, point[k].y, point[k].z),
                               Kernel::Vector_3(normal[k].x, normal[k].y, normal[k].z));
        Poisson function(cloud.begin(), cloud.end(), CGAL::First_of_pair_property_map<Oriented>(),
                         CGAL::Second_of_pair_property_map<Oriented>());
        if (!function.compute_implicit_function()) return WCUT_NOT_CONVERGED;
        const double level = median_over(function, cloud, scanned);
        for (int k = 0; k < lines; k++)
            crossed[k] = Line{function, level, from[k], direction[k]}.find(reach, &along[k]);
        return WCUT_OK;
    });
}
