#include <GL/glew.h>
#include <dlfcn.h>

#include <array>
#include <string>

#include "drape/base/input_error.h"
#include "gl_context.h"

namespace drape {

namespace {

// The library is opened at run time, for Debian 13 is the last to have it. What is called of it, as in its GL/osmesa.h:
struct Library {
    void* (*create)(const int* attributes, void* shared);
    GLboolean (*make_current)(void* context, void* buffer, GLenum type, GLsizei width, GLsizei height);
    GlContext::Function (*function)(const char* name);
    void (*destroy)(void* context);
};

constexpr int format = 0x22, depth_bits = 0x30, profile = 0x33, core_profile = 0x34, major = 0x36, minor = 0x37;

template <class Function>
void find(void* library, Function& found, const char* name) {
    found = reinterpret_cast<Function>(dlsym(library, name));
    if (found == nullptr) throw RunError(std::string("OSMesa has no ") + name);
}

Library open_library() {
    void* const opened = dlopen("libOSMesa.so.8", RTLD_NOW);
    if (opened == nullptr) {
        throw RunError(std::string("OSMesa cannot be opened (Debian package libosmesa6, up to Debian 13): ") +
                       dlerror());
    }
    Library library{};
    find(opened, library.create, "OSMesaCreateContextAttribs");
    find(opened, library.make_current, "OSMesaMakeCurrent");
    find(opened, library.function, "OSMesaGetProcAddress");
    find(opened, library.destroy, "OSMesaDestroyContext");
    return library;  // which stays open: its driver has threads of its own
}

}  // namespace

GlContext make_osmesa_context() {
    constexpr std::array<int, 11> wanted{format, GL_RGBA, profile, core_profile, major, 3, minor, 3, depth_bits, 0, 0};
    const Library library = open_library();
    void* const made = library.create(wanted.data(), nullptr);
    if (made == nullptr) throw RunError("OSMesa has no OpenGL 3.3 core context");
    const GlContext context{{made, library.destroy}, library.function};
    static std::array<unsigned char, 4> pixel;  // OSMesa wants a buffer, though nothing is drawn there
    if (!library.make_current(made, pixel.data(), GL_UNSIGNED_BYTE, 1, 1)) {
        throw RunError("OSMesa's OpenGL context cannot be made current");
    }
    return context;
}

}  // namespace drape
