#include "silent_context.h"

#include <GL/glew.h>

#include <string_view>

namespace drape {

namespace {

// Stands for OpenGL's functions of any type. C++ promises nothing about a call through a pointer of another type; the
// calling conventions of Linux on x86-64 and AArch64 do: the caller removes the arguments that it has passed, and the
// 0 in the register of results is a null pointer or a 0 of any integer type.
long do_nothing() { return 0; }

const GLubyte* say_version(GLenum) { return reinterpret_cast<const GLubyte*>("3.3"); }

void tell_number(GLenum name, GLint* value) {
    constexpr GLint version = 3, samples = 4;
    *value = name == GL_MAJOR_VERSION || name == GL_MINOR_VERSION ? version : name == GL_MAX_SAMPLES ? samples : 0;
}

void say_compiled(GLuint, GLenum name, GLint* value) { *value = name == GL_INFO_LOG_LENGTH ? 0 : 1; }

GLenum say_complete(GLenum) { return GL_FRAMEBUFFER_COMPLETE; }

template <class F>
GlContext::Function as_function(F* function) {
    return reinterpret_cast<GlContext::Function>(function);
}

}  // namespace

GlContext::Function silent_function(const char* name) {
    const std::string_view wanted(name);
    if (wanted == "glGetString") return as_function(say_version);
    if (wanted == "glGetIntegerv") return as_function(tell_number);
    if (wanted == "glGetShaderiv" || wanted == "glGetProgramiv") return as_function(say_compiled);
    if (wanted == "glCheckFramebufferStatus") return as_function(say_complete);
    return as_function(do_nothing);
}

}  // namespace drape
