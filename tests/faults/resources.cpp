// What a program needs and does not get: memory and threads; and a locale with a decimal comma.

#include "drape/integrate/integrator.h"
#include "faults/fault.h"
#include "support/process.h"

namespace drape::faults {
namespace {

/// The least address space [KiB] with which a program gets as far as its own `main`.
int least_memory(const Trial& trial, const std::string& program) {
    int size = 4096;
    while (size < 4'000'000 &&
           trial.run("ulimit -v " + std::to_string(size) + "; exec " + program + " --version").code != 0) {
        size += size / 8;
    }
    return size + size / 8;
}

}  // namespace

void withhold_memory(Trial& trial, int count) {
    const int least = least_memory(trial, "$LAB");
    const auto methods = names_of<IntegratorKind>();
    for (int k = 0; k < count; ++k) {
        const int size = least + static_cast<int>(trial.random() * trial.random() * 800'000);
        const std::string method = methods[static_cast<std::size_t>(k) % methods.size()];
        const int side = 20 + static_cast<int>(trial.random() * 180);
        const std::string command = "$LAB simulate drop --set solver.integrator=" + method +
                                    " cloth.particles=" + std::to_string(side) + "," + std::to_string(side) +
                                    " threads=" + std::to_string(1 + k % 4) + " dt=1e-4 --time 2e-4";
        const Outcome outcome = trial.run("ulimit -v " + std::to_string(size) + "; exec " + command);
        trial.check(ended_cleanly(outcome), std::to_string(size) + " KiB of memory: " + command, outcome);
    }
    // Pictures, about the size from which they are drawn
    const int least_of_capture = least_memory(trial, "$CAPTURE");
    for (int k = 0; k < count; ++k) {
        const int size = least_of_capture + static_cast<int>(trial.random() * 800'000);
        const std::string command = "$CAPTURE drop --frames 1 --size 64x36 --overlay --out frames --again" +
                                    std::string(k % 2 == 0 ? "" : " --context egl");
        const Outcome outcome = trial.run("ulimit -v " + std::to_string(size) + "; exec " + command);
        trial.check(ended_cleanly(outcome), std::to_string(size) + " KiB of memory: " + command, outcome);
    }
}

void withhold_threads(Trial& trial, int count) {
    const std::string command = "$LAB simulate drop --time 0.01 --hash --set threads=4";
    const std::string hash = trial.run(command).out;
    const int least = least_memory(trial, "$LAB");
    for (int k = 0; k < count; ++k) {
        // Each thread wants the address space of a stack
        const int size = least + 4096 + static_cast<int>(trial.random() * 40'000);
        const Outcome outcome = trial.run("ulimit -v " + std::to_string(size) + "; exec " + command);
        trial.check(ended_cleanly(outcome), "no room for threads: " + std::to_string(size) + " KiB", outcome);
        if (outcome.code == 0) trial.check(outcome.out == hash, "the same bits with fewer threads", outcome);
    }
    if (trial.run("test $(id -u) -eq 0 && setpriv --reuid=65534 --clear-groups $LAB --version").code != 0) {
        return trial.skip("a limit of processes: needs root, to be another user who may run the program");
    }
    const Outcome outcome =
        trial.run("exec setpriv --reuid=65534 --clear-groups bash -c 'ulimit -u 1; exec " + command + "'");
    trial.check(outcome.code == 0 && outcome.out == hash, "no process more: the same bits with fewer threads", outcome);
}

void change_locale(Trial& trial, int /*count*/) {
    if (trial.run("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8").code > 1 ||
        trial.run("LOCPATH=$PWD LC_ALL=de_DE.UTF-8 bash -c 'printf %.1f 1,5'").out != "1,5") {
        return trial.skip("a decimal comma: needs localedef and the package locales");
    }
    const std::string locale = "LOCPATH=$PWD LC_ALL=de_DE.UTF-8 ";
    for (const std::string command :
         {"$LAB simulate drop --time 0.5e-2,0.01 --state s.csv --hash", "$LAB list settings",
          "$LAB simulate curtain --set wind.velocity=0.5,1.5,2 --time 0.01 --hash",
          "$CAPTURE drop --frames 2 --fps 59.94 --size 64x36 --state s.csv --hash"}) {
        const Outcome plain = trial.run("LC_ALL=C " + command);
        const std::string state = trial.text("s.csv");
        trial.remove("s.csv");
        const Outcome comma = trial.run(locale + command);
        trial.check(plain.code == 0 && comma.code == 0 && plain.out == comma.out && state == trial.text("s.csv"),
                    "with a decimal comma: " + command, comma);
        trial.remove("s.csv");
    }
}

}  // namespace drape::faults
