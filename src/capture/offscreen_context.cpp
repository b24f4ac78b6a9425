#include "offscreen_context.h"

#include <GL/glew.h>
// OSMesa's header expects a macro that GLEW's takes back.
#ifndef GLAPI
#define GLAPI extern
#endif
#include <GL/osmesa.h>

#include <array>
#include <string>

#include "drape/base/input_error.h"

// Debian's GLEW asks GLX for every function beyond OpenGL 1.1; here the answer is OSMesa's.
extern "C" {
using GlFunction = void (*)();
GlFunction glXGetProcAddressARB(const GLubyte* name);
GlFunction glXGetProcAddressARB(const GLubyte* name) {
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}
}

namespace drape {

struct OffscreenContext::Mesa {
    OSMesaContext context = nullptr;
    std::array<unsigned char, 4> pixel{};  ///< OSMesa wants a buffer, though nothing is drawn there
};

OffscreenContext::OffscreenContext() : mesa_(std::make_unique<Mesa>()) {
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
    mesa_->context = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (!mesa_->context) throw RunError("OSMesa has no OpenGL 3.3 core context");
    if (!OSMesaMakeCurrent(mesa_->context, mesa_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1)) {
        OSMesaDestroyContext(mesa_->context);
        throw RunError("OSMesa's OpenGL context cannot be made current");
    }

    // Without a display GLEW misses GLX, after it has filled in all functions
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    if (status != GLEW_OK && status != GLEW_ERROR_GLX_VERSION_11_ONLY && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        OSMesaDestroyContext(mesa_->context);
        throw RunError("OpenGL's functions were not found: " +
                       std::string(reinterpret_cast<const char*>(glewGetErrorString(status))));
    }
}

OffscreenContext::~OffscreenContext() { OSMesaDestroyContext(mesa_->context); }

}  // namespace drape
