#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "drape/sim/simulation.h"

namespace drape {

/// A run as it is between two steps, in a text file: a line `drape-snapshot 1 8`, of its version and the bytes of a
/// real number, `scene NAME`, `changes N` and as many lines `set name=value` of settings that are not as in that scene,
/// `settings HASH` of all of them and of the files that they name, and then all that the next step depends on, see
/// `Simulation::exchange`. A run that goes on from there makes the same bits as one that was not stopped. Pairs of
/// cloth are searched again, so that their counts differ for a while, and a search that gives up may do so a step
/// earlier; and a limited search of a hierarchy that is not rebuilt in each step may find other nodes. The file
/// names scenes, meshes and start files, and does not hold them.
///
/// @throws RunError if the file cannot be written, if the run has diverged, or if its settings cannot be made from its
/// scene again: the scene's file has changed, or moving pins have ended
void write_snapshot(const std::string& file, Simulation& simulation);

/// The same to a stream.
void write_snapshot(std::ostream& out, Simulation& simulation);

/// @throws InputError as `file:line: ...`, also where the scene has changed since
Simulation read_snapshot(const std::string& file);

/// The same from a stream; `file` names it in messages.
Simulation read_snapshot(std::istream& in, const std::string& file);

/// The scene and the settings of a snapshot.
struct SnapshotHead {
    std::string scene;
    Settings settings;
};

/// Looks at no more than these. @throws InputError as `read_snapshot`
SnapshotHead read_snapshot_head(const std::string& file);

}  // namespace drape
