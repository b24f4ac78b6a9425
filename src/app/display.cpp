#include "display.h"

#include "drape/base/assert.h"
#include "drape/base/numbers.h"

#include <GL/glew.h>
#include <GL/glx.h>
#include <X11/XKBlib.h>
#include <X11/Xlib.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace drape {

std::shared_ptr<void> open_display() {
    return {XOpenDisplay(nullptr), [](Display* display) {
                if (display != nullptr) XCloseDisplay(display);
            }};
}

double display_rate() {
    constexpr double usual = 60;
    using RateOf = Bool (*)(Display*, GLXDrawable, std::int32_t*, std::int32_t*);
    const auto name = reinterpret_cast<const GLubyte*>("glXGetMscRateOML");
    const auto rate_of = reinterpret_cast<RateOf>(glXGetProcAddress(name));
    Display* display = glXGetCurrentDisplay();
    std::int32_t numerator = 0, denominator = 0;
    if (rate_of == nullptr || display == nullptr) return usual;
    if (rate_of(display, glXGetCurrentDrawable(), &numerator, &denominator) == 0) return usual;
    const double rate = denominator > 0 ? double(numerator) / denominator : 0;
    return rate >= 24 && rate <= 500 ? rate : usual;
}

double display_scale() {
    constexpr double usual = 96, most = 4;
    const std::shared_ptr<void> display = open_display();
    const char* const text = display ? XGetDefault(static_cast<Display*>(display.get()), "Xft", "dpi") : nullptr;
    const double scale = text == nullptr ? 1 : parse_real(trimmed(text)).value_or(usual) / usual;
    return scale >= 1 ? std::min(scale, most) : 1;
}

void wait_for_refresh() {
    Display* display = glXGetCurrentDisplay();
    if (display == nullptr) return;
    const char* const known = glXQueryExtensionsString(display, DefaultScreen(display));
    const bool can = std::string(known == nullptr ? "" : known).find("GLX_EXT_swap_control") != std::string::npos;
    using SetInterval = void (*)(Display*, GLXDrawable, int);
    const auto name = reinterpret_cast<const GLubyte*>("glXSwapIntervalEXT");
    const auto set = can ? reinterpret_cast<SetInterval>(glXGetProcAddress(name)) : nullptr;
    if (set != nullptr) set(display, glXGetCurrentDrawable(), 1);
}

bool window_has_keyboard() {
    Display* display = glXGetCurrentDisplay();
    if (display == nullptr) return false;
    ::Window focus = 0;
    int revert = 0;
    XGetInputFocus(display, &focus, &revert);
    return focus == PointerRoot || focus == glXGetCurrentDrawable();
}

void click_beside_menus() {
    Display* display = glXGetCurrentDisplay();
    DRAPE_ASSERT(display != nullptr);
    constexpr int beside = -10000;  // pixel
    XEvent event{};
    event.xbutton.type = ButtonPress;
    event.xbutton.display = display;
    event.xbutton.window = glXGetCurrentDrawable();
    event.xbutton.root = DefaultRootWindow(display);
    event.xbutton.x = event.xbutton.y = event.xbutton.x_root = event.xbutton.y_root = beside;
    event.xbutton.button = Button1;
    event.xbutton.same_screen = True;
    XSendEvent(display, event.xbutton.window, False, NoEventMask, &event);
}

bool make_repeats_detectable() {
    Display* display = glXGetCurrentDisplay();
    DRAPE_ASSERT(display != nullptr);
    Bool supported = False;
    XkbSetDetectableAutoRepeat(display, True, &supported);
    return supported == True;
}

}  // namespace drape
