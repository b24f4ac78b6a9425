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

class Egl : public GlContext {
public:
    Egl() : display_(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
        if (display_ == EGL_NO_DISPLAY) throw egl_failure("has no surfaceless platform");
        if (!eglInitialize(display_, nullptr, nullptr)) throw egl_failure("cannot be initialised");
        try {
            make_current();
        } catch (...) {
            eglTerminate(display_);
            throw;
        }
    }

    ~Egl() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display_);  // and its context with it
    }

    [[nodiscard]] Function function(const char* name) const override { return eglGetProcAddress(name); }

private:
    void make_current() {
        constexpr std::array<EGLint, 7> wanted{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        if (!eglBindAPI(EGL_OPENGL_API)) throw egl_failure("has no OpenGL");
        const EGLContext context = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
        if (context == EGL_NO_CONTEXT) throw egl_failure("has no OpenGL 3.3 core context");
        const EGLBoolean current = eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
        if (!current) throw egl_failure("cannot make its OpenGL context current");
    }

    EGLDisplay display_;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() { return std::make_unique<Egl>(); }

}  // namespace drape
