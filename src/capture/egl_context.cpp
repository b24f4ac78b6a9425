#define EGL_NO_X11  // whose macros have the names of others
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <sstream>
#include <string>

#include "drape/base/input_error.h"
#include "gl_context.h"

namespace drape {

namespace {

// What EGL's last call found wrong, after what it was to do.
RunError egl_failure(const std::string& what) {
    std::ostringstream code;
    code << std::hex << eglGetError();
    return RunError("EGL " + what + " (EGL error 0x" + code.str() + ")");
}

// With its contexts
void end_display(EGLDisplay display) {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
}

}  // namespace

GlContext make_egl_context() {
    constexpr std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) throw egl_failure("has no surfaceless platform");
    if (!eglInitialize(display, nullptr, nullptr)) throw egl_failure("cannot be initialised");
    const GlContext made{{display, end_display}, eglGetProcAddress};
    if (!eglBindAPI(EGL_OPENGL_API)) throw egl_failure("has no OpenGL");
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context == EGL_NO_CONTEXT) throw egl_failure("has no OpenGL 3.3 core context");
    const EGLBoolean current = eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    if (!current) throw egl_failure("cannot make its OpenGL context current");
    return made;
}

}  // namespace drape
