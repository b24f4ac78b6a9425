#include "drape/contact/solver_memory.h"

#include "contact_rows.h"

namespace drape {

SolverMemory::SolverMemory() : rows_(std::make_unique<ContactRows>()) {}
SolverMemory::SolverMemory(const SolverMemory& /*other*/) : SolverMemory() {}
SolverMemory::SolverMemory(SolverMemory&&) noexcept = default;
SolverMemory& SolverMemory::operator=(const SolverMemory& /*other*/) { return *this; }
SolverMemory& SolverMemory::operator=(SolverMemory&&) noexcept = default;
SolverMemory::~SolverMemory() = default;

std::size_t SolverMemory::bytes_of_contact() { return sizeof(ContactRow) + 3 * sizeof(std::size_t); }

void SolverMemory::reserve(std::size_t contacts) { rows_->reserve(contacts); }

}  // namespace drape
