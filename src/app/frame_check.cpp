#include "frame_check.h"

#include <GL/glew.h>

#include <algorithm>

#include "drape/base/input_error.h"

namespace drape {

namespace {

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* first_error) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    // OpenGL keeps a constant pointer of what it was given as one to a string that is not
    auto& error = *static_cast<std::string*>(const_cast<void*>(first_error));
    if (error.empty()) error = text;
}

bool finite(const FrameView& view) {
    const auto cloth_is = [](const ClothView& cloth) { return cloth.x.allFinite() && cloth.previous.allFinite(); };
    const auto ball_is = [](const Ball& ball) { return ball.centre.allFinite(); };
    return std::ranges::all_of(view.cloths, cloth_is) && std::ranges::all_of(view.balls, ball_is);
}

}  // namespace

void listen_for_errors(std::string& first_error) {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    if (!GLEW_KHR_debug || (flags & GL_CONTEXT_FLAG_DEBUG_BIT) == 0) {
        throw RunError("--check: this display's OpenGL does not report its errors");
    }
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, &first_error);
}

void check_frame(const std::string& gl_error, const FrameView& view, const Camera& camera) {
    if (!gl_error.empty()) throw RunError("--check: OpenGL: " + gl_error);
    if (!finite(view)) throw RunError("--check: a position is not finite");
    if (!camera.eye().allFinite() || !camera.view_matrix().allFinite()) {
        throw RunError("--check: the view is not finite");
    }
}

}  // namespace drape
