#pragma once

#include <memory>

namespace drape {

class ContactBatches;

/// Memory of solves by vector, for `resolve_contacts`. A copy begins with none.
class SolverMemory {
public:
    SolverMemory();
    SolverMemory(const SolverMemory& other);
    SolverMemory(SolverMemory&&) noexcept;
    SolverMemory& operator=(const SolverMemory& other);
    SolverMemory& operator=(SolverMemory&&) noexcept;
    ~SolverMemory();

    /// Room for as many contacts without allocating.
    void reserve(std::size_t contacts);

    [[nodiscard]] ContactBatches& batches() { return *batches_; }

private:
    std::unique_ptr<ContactBatches> batches_;
};

}  // namespace drape
