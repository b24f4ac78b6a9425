#include "drape/base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

namespace drape {

void keep_standard_streams_apart() {
    // The lowest free number is given out first
    for (int opened = 0; opened >= 0 && opened <= STDERR_FILENO;) {
        opened = open("/dev/null", O_RDONLY);
        if (opened > STDERR_FILENO) close(opened);
    }
}

}  // namespace drape
