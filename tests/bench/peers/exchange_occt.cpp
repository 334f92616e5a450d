// Open CASCADE reads the STEP file that bench_exchange leaves, and writes its surface again; CPU seconds of each:
// exchange_occt FOLDER
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <cstdio>
#include <ctime>
#include <string>

namespace {

double cpu_now() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

int run(const std::string &folder) {
    STEPControl_Reader reader;
    double start = cpu_now();
    if (reader.ReadFile((folder + "/bench.step").c_str()) != IFSelect_RetDone || reader.TransferRoots() < 1) return 1;
    std::fprintf(stderr, "Open CASCADE read bench.step in %.3f s\n", cpu_now() - start);
    const TopoDS_Shape shape = reader.OneShape();
    start = cpu_now();
    STEPControl_Writer writer;
    if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) return 1;
    if (writer.Write((folder + "/occt.step").c_str()) != IFSelect_RetDone) return 1;
    std::fprintf(stderr, "Open CASCADE wrote the same surface in %.3f s\n", cpu_now() - start);
    return 0;
}

}  // namespace

int main(int argc, char **argv) {
    try {
        return run(argc > 1 ? argv[1] : ".");
    } catch (const Standard_Failure &failure) {
        std::fprintf(stderr, "exchange_occt: %s\n", failure.GetMessageString());
        return 1;
    }
}
