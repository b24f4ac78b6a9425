#include "gl_context.h"

#include <string>

#include "drape/base/input_error.h"

namespace drape {

std::unique_ptr<GlContext> make_context(ContextKind kind, const MakeContext& osmesa, const MakeContext& egl) {
    if (kind == ContextKind::Egl) return egl();
    if (kind == ContextKind::Osmesa) return osmesa();
    std::string why;
    try {
        return osmesa();
    } catch (const RunError& error) {
        why = error.what();
    }
    try {
        return egl();
    } catch (const RunError& error) {
        throw RunError("no picture can be drawn without a display: " + why + "; " + error.what());
    }
}

}  // namespace drape
