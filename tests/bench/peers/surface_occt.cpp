// The surface jobs as Open CASCADE does them, on the same sheet: one line each for bench_table.sh.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cstring>
#include <vector>

#include <wirecut/surface.h>

#include "common.h"

namespace {

// nodes along u, stations along v
TColgp_Array2OfPnt grid(int stations, int nodes) {
    double *x = sheet_nodes(stations, nodes);
    TColgp_Array2OfPnt p(1, nodes, 1, stations);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            const double *q = x + 3 * (static_cast<size_t>(j) * static_cast<size_t>(nodes) + static_cast<size_t>(i));
            p.SetValue(i + 1, j + 1, gp_Pnt(q[0], q[1], q[2]));
        }
    free(x);
    return p;
}

void skin(int stations, int nodes, const char *job) {
    const TColgp_Array2OfPnt p = grid(stations, nodes);
    double seconds;
    TIMED(2, seconds, {
        GeomAPI_PointsToBSplineSurface maker;
        maker.Interpolate(p);
        if (!maker.IsDone()) exit(EXIT_FAILURE);
    });
    say(job, "OCCT", seconds, "GeomAPI_PointsToBSplineSurface::Interpolate");
}

void thru_sections(int stations, int nodes, const char *job) {
    const TColgp_Array2OfPnt p = grid(stations, nodes);
    const double start = cpu_now();
    BRepOffsetAPI_ThruSections maker(Standard_False, Standard_False, 1e-6);
    for (int j = 1; j <= stations; j++) {
        Handle(TColgp_HArray1OfPnt) row = new TColgp_HArray1OfPnt(1, nodes);
        for (int i = 1; i <= nodes; i++) row->SetValue(i, p.Value(i, j));
        // one knot vector for all: with chord lengths of their own the sections' knots multiply to tens of GB
        Handle(TColStd_HArray1OfReal) parameter = new TColStd_HArray1OfReal(1, nodes);
        for (int i = 1; i <= nodes; i++) parameter->SetValue(i, (i - 1.0) / (nodes - 1));
        GeomAPI_Interpolate curve(row, parameter, Standard_False, 1e-9);
        curve.Perform();
        maker.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge()).Wire());
    }
    maker.Build();
    const double seconds = cpu_now() - start;
    int degree = 0, poles = 0;
    for (TopExp_Explorer e(maker.Shape(), TopAbs_FACE); e.More(); e.Next()) {
        Handle(Geom_BSplineSurface) s =
            Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(e.Current())));
        if (s.IsNull()) continue;
        degree = s->VDegree();
        poles += s->NbUPoles() * s->NbVPoles();
    }
    char note[120];
    snprintf(note, sizeof note, "ThruSections, degree %d across, %d poles", degree, poles);
    say(job, "ThruSections", seconds, note);
}

// exactly the loft of this library, so that points and distances can be compared
Handle(Geom_BSplineSurface) same_surface(int stations, int nodes) {
    double *x = sheet_nodes(stations, nodes);
    wcut_surface *w;
    if (wcut_surface_loft(stations, nodes, reinterpret_cast<const wcut_vec3 *>(x), 1e-6, &w, nullptr, nullptr) !=
        WCUT_OK)
        exit(EXIT_FAILURE);
    TColgp_Array2OfPnt poles(1, w->count_u, 1, w->count_v);
    for (int j = 0; j < w->count_v; j++)
        for (int i = 0; i < w->count_u; i++) {
            const wcut_vec3 c =
                w->control[static_cast<size_t>(j) * static_cast<size_t>(w->count_u) + static_cast<size_t>(i)];
            poles.SetValue(i + 1, j + 1, gp_Pnt(c.x, c.y, c.z));
        }
    const auto distinct = [](const double *knots, int count, TColStd_Array1OfReal &k, TColStd_Array1OfInteger &m) {
        for (int i = 0; i < count - 2; i++) {
            k.SetValue(i + 1, knots[i + 3]);
            m.SetValue(i + 1, i == 0 || i == count - 3 ? 4 : 1);
        }
    };
    TColStd_Array1OfReal ku(1, w->count_u - 2), kv(1, w->count_v - 2);
    TColStd_Array1OfInteger mu(1, w->count_u - 2), mv(1, w->count_v - 2);
    distinct(w->knots_u, w->count_u, ku, mu);
    distinct(w->knots_v, w->count_v, kv, mv);
    Handle(Geom_BSplineSurface) s = new Geom_BSplineSurface(poles, ku, kv, mu, mv, 3, 3);
    wcut_surface_destroy(w);
    free(x);
    return s;
}

void evaluate(const Handle(Geom_BSplineSurface) & s) {
    const int points = 1000000, side = 1000;
    std::vector<double> u(2 * points);
    uint64_t state = 1;
    for (double &share : u) share = random_share(&state);
    double seconds, sum = 0;
    gp_Pnt p;
    TIMED(2, seconds, {
        sum = 0;
        for (int k = 0; k < points; k++) {
            s->D0(u[2 * k], u[2 * k + 1], p);
            sum += p.Z();
        }
    });
    char note[80];
    snprintf(note, sizeof note, "D0, sum of z %.6f", sum);
    say("eval_random", "OCCT", seconds, note);
    TIMED(2, seconds, {
        for (int j = 0; j < side; j++)
            for (int i = 0; i < side; i++) s->D0(i / (side - 1.0), j / (side - 1.0), p);
    });
    say("eval_grid", "OCCT", seconds, "D0");
}

void project(const Handle(Geom_BSplineSurface) & s, int points, const char *job) {
    uint64_t state = 2;
    double sum = 0;
    const double start = cpu_now();
    for (int k = 0; k < points; k++) {
        double p[3];
        query_point(&state, p);
        GeomAPI_ProjectPointOnSurf foot(gp_Pnt(p[0], p[1], p[2]), s, 1e-9);
        if (k < 5 && foot.NbPoints() > 0) sum += foot.LowerDistance();
    }
    char note[80];
    snprintf(note, sizeof note, "GeomAPI_ProjectPointOnSurf; first 5: %.9f", sum);
    say(job, "OCCT", (cpu_now() - start) / points, note);
}

void tessellate(const Handle(Geom_BSplineSurface) & s, double tolerance, const char *job) {
    TopoDS_Face face = BRepBuilderAPI_MakeFace(s, 1e-6).Face();
    const double start = cpu_now();
    BRepMesh_IncrementalMesh mesher(face, tolerance, Standard_False, 20.0, Standard_False);
    const double seconds = cpu_now() - start;
    TopLoc_Location place;
    Handle(Poly_Triangulation) t = BRep_Tool::Triangulation(face, place);
    char note[80];
    snprintf(note, sizeof note, "BRepMesh, %d triangles", t.IsNull() ? 0 : t->NbTriangles());
    say(job, "OCCT", seconds, note);
}

void fit(int stations, int nodes, const char *job) {
    const TColgp_Array2OfPnt p = grid(stations, nodes);
    const double start = cpu_now();
    GeomAPI_PointsToBSplineSurface maker(p, 3, 8, GeomAbs_C2, 0.01);
    const double seconds = cpu_now() - start;
    Handle(Geom_BSplineSurface) s = maker.Surface();
    double max = 0;  // of a sample of nodes: a projection takes long
    for (int j = 1; j <= stations; j += stations / 4)
        for (int i = 1; i <= nodes; i += nodes / 4) {
            GeomAPI_ProjectPointOnSurf foot(p.Value(i, j), s, 1e-9);
            if (foot.NbPoints() > 0 && foot.LowerDistance() > max) max = foot.LowerDistance();
        }
    const int poles = s->NbUPoles() * s->NbVPoles();
    char note[120];
    snprintf(note, sizeof note, "PointsToBSplineSurface, %d poles (%.3f %%), worst of 16 nodes %.4f mm", poles,
             100.0 * poles / (stations * nodes), max);
    say(job, "OCCT", seconds, note);
}

}  // namespace

int main(int count, char **word) {
    try {
        const bool all = count > 1 && std::strcmp(word[1], "all") == 0;
        skin(500, 100, "skin_small");
        skin(2000, 200, "skin_large");
        thru_sections(2000, 200, "skin_large");
        const Handle(Geom_BSplineSurface) small = same_surface(500, 100), large = same_surface(2000, 200);
        evaluate(large);
        project(small, 10, "closest_small");
        project(large, 5, "closest_large");
        tessellate(large, 0.1, "tessellate_coarse");
        if (all) {  // minutes
            tessellate(large, 0.01, "tessellate_fine");
            fit(500, 100, "fit_small");
        }
        return EXIT_SUCCESS;
    } catch (const Standard_Failure &e) {
        fprintf(stderr, "surface_occt: %s\n", e.GetMessageString());
        return EXIT_FAILURE;
    }
}
