// Open CASCADE reads the STEP file that bench_exchange leaves, and writes its surface again: one line each for
// bench_table.sh.  exchange_occt FOLDER
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <string>

#include "common.h"

namespace {

int run(const std::string &folder) {
    STEPControl_Reader reader;
    double seconds;
    TIMED(1, seconds, {
        if (reader.ReadFile((folder + "/bench.step").c_str()) != IFSelect_RetDone) return 1;
        if (reader.TransferRoots() < 1) return 1;
    });
    const TopoDS_Shape shape = reader.OneShape();
    say("step_read", "OCCT", seconds, "bench.step");
    TIMED(2, seconds, {
        STEPControl_Writer writer;
        if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) return 1;
        if (writer.Write((folder + "/occt.step").c_str()) != IFSelect_RetDone) return 1;
    });
    say("step", "OCCT", seconds, "the surface that it read from bench.step");
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
