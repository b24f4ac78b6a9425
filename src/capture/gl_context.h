#pragma once

#include <functional>
#include <memory>

#include "drape/base/enum_names.h"

namespace drape {

/// Who draws without a display: whichever can be made, Mesa's off-screen library, or EGL without a surface.
enum class ContextKind { Auto, Osmesa, Egl };

/// An OpenGL 3.3 core context without a display, current from construction to destruction.
class GlContext {
public:
    using Function = void (*)();

    GlContext() = default;
    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// The context's own function of a name; null if it has none.
    [[nodiscard]] virtual Function function(const char* name) const = 0;
};

/// Makes a context. @throws RunError that says why there is none
using MakeContext = std::function<std::unique_ptr<GlContext>()>;

/// Mesa's off-screen library, which is opened at run time: Mesa has left it out since its version 25.1.
/// @throws RunError if there is no such context, with the package where the library is not installed
std::unique_ptr<GlContext> make_osmesa_context();

/// EGL on Mesa's surfaceless platform.
/// @throws RunError if there is no such context
std::unique_ptr<GlContext> make_egl_context();

/// The context of a kind; for `Auto` that of EGL only where OSMesa's cannot be made.
/// @throws RunError that says why, of both where both were tried
std::unique_ptr<GlContext> make_context(ContextKind kind, const MakeContext& osmesa, const MakeContext& egl);

/// An OpenGL 3.3 core context without a display, current from construction to destruction, with GLEW initialised.
/// Pictures go into framebuffer objects; there is no default framebuffer to speak of. There may be one at a time.
class OffscreenContext {
public:
    /// @throws RunError if the system has no such context
    explicit OffscreenContext(ContextKind kind = ContextKind::Auto);

private:
    std::unique_ptr<GlContext> context_;
};

/// Leads every function of OpenGL that Drape calls to a context, which is current: those of OpenGL 1.1, which GLEW
/// takes from the library that it was built for, and all others, for which it asks GLX. There is one context at a time.
/// @throws RunError if the context does not have one of them
void load_gl_functions(const GlContext& context);

}  // namespace drape
