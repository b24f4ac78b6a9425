#pragma once

namespace drape {

/// Whether there is an X display to open a window on.
bool display_present();

/// Pictures a second that the display of the current window shows; 60 where the driver does not tell.
double display_rate();

/// Whether the keyboard belongs to the current window, or to whatever is under the pointer.
bool window_has_keyboard();

}  // namespace drape
