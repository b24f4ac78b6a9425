#include <GL/glew.h>

#include <string>
#include <string_view>

#include "drape/base/input_error.h"
#include "drape/render/renderer.h"
#include "gl_context.h"

// The functions of OpenGL 1.1 that Drape calls: result, name, parameters, arguments
#define DRAPE_GL_FUNCTIONS(DO)                                                                                      \
    DO(void, glBindTexture, (GLenum target, GLuint texture), (target, texture))                                     \
    DO(void, glBlendFunc, (GLenum source, GLenum destination), (source, destination))                               \
    DO(void, glClear, (GLbitfield mask), (mask))                                                                    \
    DO(void, glDeleteTextures, (GLsizei n, const GLuint* textures), (n, textures))                                  \
    DO(void, glDepthFunc, (GLenum function), (function))                                                            \
    DO(void, glDisable, (GLenum what), (what))                                                                      \
    DO(void, glDrawBuffer, (GLenum buffer), (buffer))                                                               \
    DO(void, glEnable, (GLenum what), (what))                                                                       \
    DO(void, glGenTextures, (GLsizei n, GLuint * textures), (n, textures))                                          \
    DO(void, glGetIntegerv, (GLenum name, GLint * values), (name, values))                                          \
    DO(void, glLineWidth, (GLfloat width), (width))                                                                 \
    DO(void, glPixelStorei, (GLenum name, GLint value), (name, value))                                              \
    DO(void, glPolygonMode, (GLenum face, GLenum mode), (face, mode))                                               \
    DO(void, glReadBuffer, (GLenum buffer), (buffer))                                                               \
    DO(void, glReadPixels, (GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, void* pixels),      \
       (x, y, w, h, format, type, pixels))                                                                          \
    DO(void, glScissor, (GLint x, GLint y, GLsizei w, GLsizei h), (x, y, w, h))                                     \
    DO(void, glTexImage2D,                                                                                          \
       (GLenum target, GLint level, GLint internal, GLsizei w, GLsizei h, GLint border, GLenum format, GLenum type, \
        const void* pixels),                                                                                        \
       (target, level, internal, w, h, border, format, type, pixels))                                               \
    DO(void, glTexParameteri, (GLenum target, GLenum name, GLint value), (target, name, value))                     \
    DO(void, glViewport, (GLint x, GLint y, GLsizei w, GLsizei h), (x, y, w, h))

namespace {

// Like OpenGL's context itself, this belongs to the whole program.
decltype(drape::GlContext::function) asked_function = nullptr;

#define DRAPE_GL_POINTER(result, name, parameters, arguments) decltype(&name) found_##name = nullptr;
DRAPE_GL_FUNCTIONS(DRAPE_GL_POINTER)

template <class Function>
void find_function(Function& found, const char* name) {
    found = reinterpret_cast<Function>(asked_function(name));
    if (found == nullptr) throw drape::RunError(std::string("the OpenGL context has no ") + name);
}

}  // namespace

extern "C" {

#define DRAPE_GL_FUNCTION(result, name, parameters, arguments) \
    result name parameters { return found_##name arguments; }
DRAPE_GL_FUNCTIONS(DRAPE_GL_FUNCTION)

// Debian's GLEW asks GLX for every function beyond OpenGL 1.1. There is no GLX here.
using GlFunction = void (*)();
GlFunction glXGetProcAddressARB(const GLubyte* name);
GlFunction glXGetProcAddressARB(const GLubyte* name) {
    const char* text = reinterpret_cast<const char*>(name);
    return std::string_view(text).starts_with("glX") ? nullptr : asked_function(text);
}
}

namespace drape {

void load_gl_functions(const GlContext& context) {
    asked_function = context.function;
#define DRAPE_GL_FIND(result, name, parameters, arguments) find_function(found_##name, #name);
    DRAPE_GL_FUNCTIONS(DRAPE_GL_FIND)
    start_glew();
}

namespace {

GlContext context_of(ContextKind kind) {
    if (kind == ContextKind::Egl) return make_egl_context();
    try {
        return make_osmesa_context();
    } catch (const RunError& osmesa) {
        if (kind == ContextKind::Osmesa) throw;
        try {
            return make_egl_context();
        } catch (const RunError& egl) {
            throw RunError(std::string("no picture can be drawn without a display: ") + osmesa.what() + "; " +
                           egl.what());
        }
    }
}

}  // namespace

GlContext make_context(ContextKind kind) {
    GlContext context = context_of(kind);
    load_gl_functions(context);
    return context;
}

}  // namespace drape
