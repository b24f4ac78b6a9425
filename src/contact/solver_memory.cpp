#include "drape/contact/solver_memory.h"

#include <algorithm>

#include "contact_rows.h"

namespace drape {

namespace {

constexpr std::size_t most_reserved = 100'000;  // contacts

}  // namespace

SolverMemory::SolverMemory() : rows_(std::make_unique<ContactRows>()) {}
SolverMemory::SolverMemory(const SolverMemory& /*other*/) : SolverMemory() {}
SolverMemory::SolverMemory(SolverMemory&&) noexcept = default;
SolverMemory& SolverMemory::operator=(const SolverMemory& /*other*/) {
    if (!rows_) rows_ = std::make_unique<ContactRows>();
    return *this;
}
SolverMemory& SolverMemory::operator=(SolverMemory&&) noexcept = default;
SolverMemory::~SolverMemory() = default;

std::size_t SolverMemory::bytes_for(std::size_t contacts) {
    return std::min(contacts, most_reserved) * (sizeof(ContactRow) + 3 * sizeof(std::size_t));
}

void SolverMemory::reserve(std::size_t contacts, std::size_t cloths) {
    rows_->reserve(std::min(contacts, most_reserved), cloths);
}

}  // namespace drape
