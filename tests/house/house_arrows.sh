# The rooms include only what their arrows allow; and the check finds every kind of broken arrow when one is planted.
set -eu
check=$SOURCE_DIR/tests/house/check_arrows.sh

# plant FILE INCLUDE: a tree with this one line in this one file
plant() {
    rm -rf tree
    mkdir -p "tree/$(dirname "$1")"
    printf '/* planted */\n#include %s\n' "$2" >"tree/$1"
}
refused() {
    plant "$1" "$2"
    if sh "$check" tree >found; then
        echo "not noticed: $1 includes $2"
        exit 1
    fi
    grep -q "^$1:" found || { echo "not named: $1 includes $2"; cat found; exit 1; }
}
allowed() {
    plant "$1" "$2"
    sh "$check" tree >found || { echo "wrongly refused: $1 includes $2"; cat found; exit 1; }
}

refused kernel/base/a.c '"wire/chain.h"'
refused kernel/wire/a.h '"foam/law.h"'
refused kernel/surface/a.c '"cut/run.h"'
refused kernel/foam/a.c '"chain.h"'
refused kernel/foam/a.c '"../wire/chain.h"'
refused kernel/foam/a.c '"nowhere/chain.h"'
refused kernel/base/a.c '<jansson.h>'
refused kernel/scan/a.c '<Eigen/Dense>'
refused kernel/scan/a_eigen.cpp '<CGAL/AABB_tree.h>'
refused kernel/cut/a.cpp '<vector>'
refused kernel/cut/a.c 'MACRO'
refused kernel/cut/a.c '<wirecut/job_file.h>'
refused kernel/explain/a.h '<wirecut/report.h>'
refused kernel/elsewhere/a.c '<math.h>'
refused kernel/include/wirecut/a.h '"base/fail.h"'
refused kernel/include/wirecut/a.h '<zlib.h>'
refused io/file/a.c '"wire/chain.h"'
refused io/file/a.c '"io/process/job.h"'
refused io/robot/a.c '"io/report/page.h"'
refused io/robot/a.c '"io/nowhere/page.h"'
refused io/robot/a.c '"text.h"'
refused io/file/a.c '<CGAL/AABB_tree.h>'
refused io/robot/a.c '<jansson.h>'
refused kernel/foam/a.c '"io/file/text.h"'
refused apps/a.c '"base/alloc.h"'
refused apps/a.c '<jansson.h>'
refused samples/a.c '"base/vec3.h"'

allowed kernel/wire/a.c '"base/vec3.h"'
allowed kernel/wire/a.c '"wire/chain.h"'
allowed kernel/wire/a.c '<wirecut/job.h>'
allowed kernel/scan/a_cgal.cpp '<CGAL/AABB_tree.h>'
allowed kernel/scan/a_eigen.cpp '<Eigen/Dense>'
allowed io/file/a.c '"base/alloc.h"'
allowed io/process/a.c '"io/file/text.h"'
allowed io/report/a.c '"io/process/job.h"'
allowed io/mesh/a.c '<assimp/cexport.h>'
allowed apps/a.c '<getopt.h>'
allowed apps/a.c '"options.h"'

sh "$check" "$SOURCE_DIR"
