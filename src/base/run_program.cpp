#include "drape/base/run_program.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>

#include "drape/base/input_error.h"

namespace drape {
namespace {

/// Opens standard input, output and error where they were closed at the start: the next files to be opened would get
/// their numbers, and whatever is printed would go into those. What is written there fails, as it did.
void keep_standard_streams_apart() {
    // The lowest free number is given out first
    for (int opened = 0; opened >= 0 && opened <= STDERR_FILENO;) {
        opened = open("/dev/null", O_RDONLY);
        if (opened > STDERR_FILENO) close(opened);
    }
}

}  // namespace

void tell(std::string_view message) { std::cerr << one_line(message) + "\n"; }

int run_program(const std::string& name, int argc, char** argv, int (*run)(int, char**)) {
    keep_standard_streams_apart();
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        const int exit_code = run(argc, argv);
        if (exit_code == Done && !std::cout.flush()) throw RunError("standard output could not be written whole");
        return exit_code;
    } catch (const InputError& error) {
        // The hint is a line of its own
        const std::string message = name + ": " + error.what();
        const std::size_t end = std::min(message.find('\n'), message.size());
        tell(message.substr(0, end));
        if (end < message.size()) tell(message.substr(end + 1));
        return BadInput;
    } catch (const std::bad_alloc&) {
        tell(name + ": out of memory");
    } catch (const std::exception& error) {
        tell(name + ": " + error.what());
    }
    return Failed;
}

}  // namespace drape
