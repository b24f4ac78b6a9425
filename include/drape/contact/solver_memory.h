#pragma once

#include <cstddef>
#include <memory>

namespace drape {

struct ContactRows;

/// What `resolve_contacts` fills in each call, kept so that it allocates nothing. A copy
/// begins with none, and what is assigned to keeps its own.
class SolverMemory {
public:
    SolverMemory();
    SolverMemory(const SolverMemory& other);
    SolverMemory(SolverMemory&&) noexcept;
    SolverMemory& operator=(const SolverMemory& other);
    SolverMemory& operator=(SolverMemory&&) noexcept;
    ~SolverMemory();

    /// Room for as many contacts of as many cloths without allocating, but for no more than a hundred thousand
    /// contacts: a scene with more of them at a time makes more room once.
    void reserve(std::size_t contacts, std::size_t cloths);

    /// What that room takes [bytes].
    [[nodiscard]] static std::size_t bytes_for(std::size_t contacts);

    [[nodiscard]] ContactRows& rows() { return *rows_; }

private:
    std::unique_ptr<ContactRows> rows_;
};

}  // namespace drape
