#pragma once

#include <string>

#include "gl.h"

namespace drape {

/// A vertex and a fragment shader, linked. Its block `Frame` is bound to point 0; `shadow_map` reads texture unit 0,
/// `atlas` unit 1, `studio_picture` unit 2 and `shadow_depths` unit 3.
class Program {
public:
    /// @param name of `shaders/NAME.vert` and `shaders/NAME.frag`
    /// @throws RunError with the compiler's log
    Program(Gl& gl, const std::string& name) : Program(gl, name, name) {}

    /// @param vertex, fragment the names of both files
    Program(Gl& gl, const std::string& vertex, const std::string& fragment);
    ~Program() { gl_(glDeleteProgram, name_); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { gl_(glUseProgram, name_); }

private:
    Gl& gl_;
    GLuint name_;
};

}  // namespace drape
