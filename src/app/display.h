#pragma once

#include <memory>

namespace drape {

/// A connection to the X display, to find out whether there is one; null: none. It has to stay open until the window
/// has its own: a server that sees its only client go away may restart and refuse the next one meanwhile.
std::shared_ptr<void> open_display();

/// Pictures a second that the display of the current window shows; 60 where the driver does not tell.
double display_rate();

/// How many pixels the display has for one of a usual display, as its user has set it for text (`Xft.dpi` in its
/// resources over 96), from 1 to 4.
double display_scale();

/// Has each picture of the current window shown with the display's next refresh, where the driver can.
void wait_for_refresh();

/// Whether the keyboard belongs to the current window, or to whatever is under the pointer.
bool window_has_keyboard();

/// Makes the X server send a held key's repeats without releases between them, which under load look like real ones.
/// @pre a window is open
/// @return whether it can
bool make_repeats_detectable();

/// Closes menus that are open in the window whose context is current: GLUT has no other way than a click beside them.
void click_beside_menus();

}  // namespace drape
