#include "gl.h"

#include <fstream>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/resources.h"

namespace drape {

namespace {

// The text of a shader file, with each line `#include "file"` replaced by that file of the same folder
std::string shader_source(const std::string& file, int depth = 0) {
    if (depth > 8) throw RunError("shaders/" + file + ": includes go too deep");
    std::ifstream in(find_resource("shaders/" + file));
    if (!in) throw RunError("cannot read shaders/" + file);
    const std::string mark = "#include \"";
    std::string text, line;
    while (std::getline(in, line)) {
        if (line.starts_with(mark)) {
            text += shader_source(line.substr(mark.size(), line.rfind('"') - mark.size()), depth + 1);
        } else {
            text += line + '\n';
        }
    }
    return text;
}

// `glGetShaderInfoLog` or `glGetProgramInfoLog`
std::string log_of(Gl& gl, GLuint object, PFNGLGETSHADERINFOLOGPROC get_log) {
    std::vector<char> log(1 << 16, '\0');
    gl(get_log, object, static_cast<GLsizei>(log.size()), nullptr, log.data());
    return log.data();
}

GLuint compile(Gl& gl, GLenum stage, const std::string& file) {
    const std::string source = shader_source(file);
    const char* text = source.c_str();
    const GLuint shader = gl(glCreateShader, stage);
    gl(glShaderSource, shader, 1, &text, nullptr);
    gl(glCompileShader, shader);
    GLint ok = GL_FALSE;
    gl(glGetShaderiv, shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        const std::string log = log_of(gl, shader, glGetShaderInfoLog);
        gl(glDeleteShader, shader);
        throw RunError("shaders/" + file + " does not compile: " + log);
    }
    return shader;
}

}  // namespace

Program::Program(Gl& gl, const std::string& vertex_name, const std::string& fragment_name) : gl_(gl) {
    const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertex_name + ".vert");
    const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_name + ".frag");
    name_ = gl(glCreateProgram);
    gl(glAttachShader, name_, vertex);
    gl(glAttachShader, name_, fragment);
    gl(glLinkProgram, name_);
    gl(glDeleteShader, vertex);
    gl(glDeleteShader, fragment);

    GLint ok = GL_FALSE;
    gl(glGetProgramiv, name_, GL_LINK_STATUS, &ok);
    if (!ok) {
        const std::string log = log_of(gl, name_, glGetProgramInfoLog);
        gl(glDeleteProgram, name_);
        throw RunError("shaders/" + fragment_name + " does not link: " + log);
    }

    // Where the shared block and the textures are
    const GLuint block = gl(glGetUniformBlockIndex, name_, "Frame");
    if (block != GL_INVALID_INDEX) gl(glUniformBlockBinding, name_, block, 0);
    gl(glUseProgram, name_);
    GLint unit = 0;
    for (const char* sampler : {"shadow_map", "atlas", "studio_picture", "shadow_depths"}) {
        const GLint location = gl(glGetUniformLocation, name_, sampler);
        if (location >= 0) gl(glUniform1i, location, unit);
        ++unit;
    }
}

}  // namespace drape
