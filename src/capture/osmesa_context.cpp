#include "drape/base/input_error.h"
#include "gl_context.h"

#ifdef DRAPE_OSMESA

#include <GL/glew.h>
// OSMesa's header expects a macro that GLEW's takes back.
#ifndef GLAPI
#define GLAPI extern
#endif
#include <GL/osmesa.h>

#include <array>

namespace drape {

namespace {

class Osmesa : public GlContext {
public:
    Osmesa() {
        const std::array<int, 11> wanted{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         OSMESA_DEPTH_BITS,
                                         0,
                                         0};
        context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
        if (!context_) throw RunError("OSMesa has no OpenGL 3.3 core context");
        if (!OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            OSMesaDestroyContext(context_);
            throw RunError("OSMesa's OpenGL context cannot be made current");
        }
    }

    ~Osmesa() override { OSMesaDestroyContext(context_); }
    Osmesa(const Osmesa&) = delete;
    Osmesa& operator=(const Osmesa&) = delete;

    [[nodiscard]] Function function(const char* name) const override { return OSMesaGetProcAddress(name); }

private:
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> pixel_{};  ///< OSMesa wants a buffer, though nothing is drawn there
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<Osmesa>(); }

}  // namespace drape

#else

namespace drape {

std::unique_ptr<GlContext> make_osmesa_context() { throw RunError("this build has no OSMesa"); }

}  // namespace drape

#endif
