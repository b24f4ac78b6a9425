#include "drape/render/renderer.h"

#include <GL/glew.h>

#include <string>

#include "drape/base/input_error.h"

namespace drape {

void start_glew() {
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // GLEW asks for GLX last, when it has filled in all functions
    const bool no_glx = status == GLEW_ERROR_GLX_VERSION_11_ONLY || status == GLEW_ERROR_NO_GLX_DISPLAY;
    if (status != GLEW_OK && !no_glx) {
        throw RunError("OpenGL's functions were not found: " +
                       std::string(reinterpret_cast<const char*>(glewGetErrorString(status))));
    }
    if (!GLEW_VERSION_3_3) throw RunError("OpenGL's functions were not found: there is no OpenGL 3.3");
}

}  // namespace drape
