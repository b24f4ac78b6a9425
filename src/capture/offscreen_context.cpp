#include "offscreen_context.h"

#include "gl_functions.h"

namespace drape {

OffscreenContext::OffscreenContext(ContextKind kind)
    : context_(make_context(kind, make_osmesa_context, make_egl_context)) {
    load_gl_functions(*context_);
}

}  // namespace drape
