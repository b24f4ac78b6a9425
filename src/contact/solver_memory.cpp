#include "drape/contact/solver_memory.h"

#include "contact_rows.h"

namespace drape {

SolverMemory::SolverMemory() : batches_(std::make_unique<ContactBatches>()) {}
SolverMemory::SolverMemory(const SolverMemory& /*other*/) : SolverMemory() {}
SolverMemory::SolverMemory(SolverMemory&&) noexcept = default;
SolverMemory& SolverMemory::operator=(const SolverMemory& /*other*/) { return *this; }
SolverMemory& SolverMemory::operator=(SolverMemory&&) noexcept = default;
SolverMemory::~SolverMemory() = default;

void SolverMemory::reserve(std::size_t contacts) { batches_->rows.reserve(contacts); }

}  // namespace drape
