// The mesh of a solid, OBJ and STL: what is read is closed, and has a distance at every point.

#include "drape/scene/mesh_file.h"

#include <cmath>
#include <sstream>

#include "fuzz/target.h"

using namespace drape;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const char* file : {"fuzz.obj", "fuzz.stl"}) {
        std::istringstream in{std::string(fuzz::text_of(data, size))};
        TriangleMesh mesh;
        if (!fuzz::accepts([&] { mesh = read_mesh(in, file); })) continue;
        fuzz::require(mesh.triangles.size() >= 4, "a closed mesh has four triangles or more");
        const Vec3 corner = mesh.points.front();
        const auto shape = make_mesh_shape(std::move(mesh));
        for (const Vec3& p : {corner, Vec3(corner + Vec3(1, 2, 3)), Vec3(0, 0, 0)}) {
            fuzz::require(std::isfinite(shape->measure(p).distance), "a distance is a number");
        }
    }
    return 0;
}
