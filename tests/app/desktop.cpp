#include "app/desktop.h"

#include <gtest/gtest.h>

// After the others: X11 defines None and Bool
#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace drape::test {

namespace fs = std::filesystem;

Desktop::Desktop(fs::path folder) : folder_(std::move(folder)) {
    // The server finds a free display by itself and tells its number, so that test runs do not collide. It repeats no
    // key: on a slow machine a key is down for long.
    fs::create_directories(folder_ / "server");
    server_ = std::make_unique<Process>(std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0",
                                                                 "1280x1024x24", "-nolisten", "tcp", "-noreset", "-r"},
                                        std::map<std::string, std::string>{}, folder_ / "server");
    eventually([&] { return server_->standard_output().ends_with('\n'); });
    const std::string number = server_->standard_output();
    if (!number.empty()) display_ = ":" + number.substr(0, number.size() - 1);
}

std::string Desktop::act(const std::vector<std::string>& words) {
    const fs::path folder = folder_ / "xdotool";
    fs::create_directories(folder);
    std::vector<std::string> all{"xdotool"};
    all.insert(all.end(), words.begin(), words.end());
    Process tool(all, {{"DISPLAY", display_}}, folder);
    tool.wait(60);
    std::string text = tool.standard_output();
    if (text.ends_with('\n')) text.pop_back();
    return text;
}

std::string Desktop::find_window() {
    std::string window;
    eventually([&] {
        window = act({"search", "--onlyvisible", "--name", "^Drape"});
        return !window.empty();
    });
    if (window.empty()) return window;
    act({"windowmove", "--sync", window, "0", "0"});
    move_to(20, 20);
    act({"windowfocus", window});
    return window;
}

Image Desktop::picture_of(const std::string& window) const {
    Display* const connection = XOpenDisplay(display_.c_str());
    if (connection == nullptr) return {};
    const ::Window id = std::stoul(window);
    XWindowAttributes attributes{};
    XGetWindowAttributes(connection, id, &attributes);
    const int width = attributes.width, height = attributes.height;
    XImage* const pixels = XGetImage(connection, id, 0, 0, static_cast<unsigned>(width), static_cast<unsigned>(height),
                                     AllPlanes, ZPixmap);
    if (pixels == nullptr) {
        XCloseDisplay(connection);
        return {};
    }
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const unsigned long pixel = XGetPixel(pixels, x, y);
            for (const int shift : {16, 8, 0}) image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 255));
        }
    }
    XDestroyImage(pixels);
    XCloseDisplay(connection);
    return image;
}

void Desktop::drag(const std::vector<std::string>& keys, int button, Place from, Place to) {
    for (const std::string& key : keys) act({"keydown", key});
    move_to(from.x, from.y);
    act({"mousedown", std::to_string(button)});
    constexpr int moves = 5;
    for (int m = 1; m <= moves; ++m) {
        move_to(from.x + (to.x - from.x) * m / moves, from.y + (to.y - from.y) * m / moves);
    }
    act({"mouseup", std::to_string(button)});
    for (const std::string& key : keys) act({"keyup", key});
}

void Desktop::hold(const std::string& name, const std::string& window, int repeats) {
    Display* display = XOpenDisplay(display_.c_str());
    XAutoRepeatOn(display);
    XkbSetAutoRepeatRate(display, XkbUseCoreKbd, 100, 20);  // ms
    XSelectInput(display, std::stoul(window), KeyPressMask);
    XSync(display, False);
    act({"keydown", name});
    int presses = 0;
    const bool seen = eventually([&] {
        XEvent event;
        while (XCheckTypedEvent(display, KeyPress, &event) != 0) ++presses;
        return presses > repeats;
    });
    EXPECT_TRUE(seen) << "the server does not repeat keys";
    act({"keyup", name});
    XAutoRepeatOff(display);
    XCloseDisplay(display);
}

int Desktop::visible_windows() const {
    Display* display = XOpenDisplay(display_.c_str());
    Window root = 0, parent = 0, *windows = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &windows, &count);
    int visible = 0;
    for (unsigned w = 0; w < count; ++w) {
        XWindowAttributes attributes{};
        XGetWindowAttributes(display, windows[w], &attributes);
        visible += attributes.map_state == IsViewable ? 1 : 0;
    }
    if (windows != nullptr) XFree(windows);
    XCloseDisplay(display);
    return visible;
}

void Desktop::open_menu(int x, int y) {
    const int before = visible_windows();
    move_to(x, y);
    click(3);
    EXPECT_TRUE(eventually([&] { return visible_windows() > before; })) << "no menu";
}

void Desktop::choose_in_menu(int x, int y, int entry) {
    constexpr int row = 25;  // height of an entry in freeglut's menu
    const int before = visible_windows();
    open_menu(x, y);
    move_to(x + 20, y + row * entry - row / 2);
    click(1);
    EXPECT_TRUE(eventually([&] { return visible_windows() == before; })) << "the menu stays";
}

void Desktop::set_resources(const std::string& text) {
    Display* display = XOpenDisplay(display_.c_str());
    ASSERT_NE(display, nullptr);
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XCloseDisplay(display);
}

void Desktop::take_keyboard_away() {
    Display* display = XOpenDisplay(display_.c_str());
    XSetInputFocus(display, None, RevertToNone, CurrentTime);
    XCloseDisplay(display);
}

void Desktop::ask_to_close(const std::string& window) {
    Display* display = XOpenDisplay(display_.c_str());
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = std::stoul(window);
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
    XSendEvent(display, event.xclient.window, False, NoEventMask, &event);
    XCloseDisplay(display);
}

}  // namespace drape::test
