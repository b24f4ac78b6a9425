#pragma once

#include <memory>

#include "drape/base/enum_names.h"

namespace drape {

/// Who draws without a display: whichever can be made, Mesa's off-screen library, or EGL without a surface.
enum class ContextKind { Auto, Osmesa, Egl };

/// An OpenGL 3.3 core context without a display, current for as long as it is kept. Pictures go into framebuffer
/// objects; there is no default framebuffer to speak of. There may be one at a time.
struct GlContext {
    using Function = void (*)();

    std::shared_ptr<void> kept;
    Function (*function)(const char* name) = nullptr;  ///< its own function of a name; null if it has none
};

/// Mesa's off-screen library, which is opened at run time: Mesa has left it out since its version 25.1.
/// @throws RunError if there is no such context, with the package where the library is not installed
GlContext make_osmesa_context();

/// EGL on Mesa's surfaceless platform.
/// @throws RunError if there is no such context
GlContext make_egl_context();

/// The context of a kind, with GLEW initialised; for `Auto` that of EGL only where OSMesa's cannot be made.
/// @throws RunError that says why, of both where both were tried
GlContext make_context(ContextKind kind = ContextKind::Auto);

/// Leads every function of OpenGL that Drape calls to a context, which is current: those of OpenGL 1.1, which GLEW
/// takes from the library that it was built for, and all others, for which it asks GLX. There is one context at a time.
/// @throws RunError if the context does not have one of them
void load_gl_functions(const GlContext& context);

}  // namespace drape
