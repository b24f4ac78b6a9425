#include <GL/glew.h>
#include <dlfcn.h>

#include <array>
#include <string>

#include "drape/base/input_error.h"
#include "gl_context.h"

namespace drape {

namespace {

constexpr int format = 0x22, depth_bits = 0x30, profile = 0x33, core_profile = 0x34, major = 0x36, minor = 0x37;

template <class Function>
Function* find(void* library, const char* name) {
    void* const found = dlsym(library, name);
    if (found == nullptr) throw RunError(std::string("OSMesa has no ") + name);
    return reinterpret_cast<Function*>(found);
}

}  // namespace

GlContext make_osmesa_context() {
    // Opened at run time, for Debian 13 is the last to have it; it stays open: its driver has threads of its own
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW);
    if (library == nullptr) {
        throw RunError(std::string("OSMesa cannot be opened (Debian package libosmesa6, up to Debian 13): ") +
                       dlerror());
    }
    // What is called of it, as in its GL/osmesa.h
    auto* const create = find<void*(const int*, void*)>(library, "OSMesaCreateContextAttribs");
    auto* const make_current = find<GLboolean(void*, void*, GLenum, GLsizei, GLsizei)>(library, "OSMesaMakeCurrent");
    auto* const function = find<GlContext::Function(const char*)>(library, "OSMesaGetProcAddress");
    auto* const destroy = find<void(void*)>(library, "OSMesaDestroyContext");

    constexpr std::array<int, 11> wanted{format, GL_RGBA, profile, core_profile, major, 3, minor, 3, depth_bits, 0, 0};
    void* const made = create(wanted.data(), nullptr);
    if (made == nullptr) throw RunError("OSMesa has no OpenGL 3.3 core context");
    const GlContext context{{made, destroy}, function};
    static std::array<unsigned char, 4> pixel;  // OSMesa wants a buffer, though nothing is drawn there
    if (!make_current(made, pixel.data(), GL_UNSIGNED_BYTE, 1, 1)) {
        throw RunError("OSMesa's OpenGL context cannot be made current");
    }
    return context;
}

}  // namespace drape
