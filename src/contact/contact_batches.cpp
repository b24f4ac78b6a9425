#include "contact_batches.h"

#include <algorithm>

#include "drape/contact/solver_memory.h"
#include "kernels/batch_sweeps.h"

namespace drape {

void ContactBatches::reserve(std::size_t contacts) {
    const std::size_t batches = contacts / 4;  // most are full, or nearly
    batches_.reserve(batches);
    given_.reserve(batches);
    fresh_.reserve(batches);
    motion_.reserve(2 * batches);
    moved_.reserve(contacts);
    known_.reserve(contacts);
}

void ContactBatches::clear() {
    forget_particles();
    batches_.clear();
    given_.clear();
    fresh_.clear();
    motion_.assign(1, {});
    cloths_.clear();
    moved_.clear();
    of_last_cloth_ = 0;
}

void ContactBatches::begin_cloth(Points& motion) {
    forget_particles();
    cloths_.push_back(&motion);
    const auto particles = static_cast<std::size_t>(motion.rows());
    if (known_.size() < particles) known_.resize(particles);
    of_last_cloth_ = moved_.size();
    first_open_.fill(batches_.size());
}

/// For the next cloth has others of these numbers.
void ContactBatches::forget_particles() {
    for (std::size_t m = of_last_cloth_; m < moved_.size(); ++m) {
        known_[static_cast<std::size_t>(moved_[m].particle)] = {};
    }
}

/// The first that has room, and nothing that the contact depends on in it or after it.
std::size_t ContactBatches::batch_for(const ContactPlane& contact) {
    const auto count = static_cast<std::size_t>(contact.particle_count);
    std::size_t& open = first_open_[count - 1];
    const auto has_room = [&](std::size_t batch) {
        return batches_[batch].particle_count == count && batches_[batch].contact_count < ContactBatch::size;
    };
    while (open < batches_.size() && !has_room(open)) ++open;
    std::size_t batch = open;
    for (const PushedParticle& p : contact.pushed()) {
        batch = std::max(batch, known_[static_cast<std::size_t>(p.particle)].later);
    }
    while (batch < batches_.size() && !has_room(batch)) ++batch;
    if (batch < batches_.size()) return batch;
    ContactBatch& added = batches_.emplace_back();
    added.particle_count = count;
    added.in_a_row.fill(true);
    for (ContactBatch::Particles& particles : added.particles) {
        for (std::size_t lane = 0; lane < ContactBatch::size; ++lane) {
            particles.slots[lane] = static_cast<ContactBatch::Slot>(lane);
        }
    }
    given_.emplace_back();
    fresh_.emplace_back();
    return batch;
}

/// Particles that are new in a batch come side by side, so that they need no gathering.
std::size_t ContactBatches::slot_for(std::size_t batch, std::size_t k, std::size_t lane, int particle) {
    Known& known = known_[static_cast<std::size_t>(particle)];
    known.later = batch + 1;
    if (known.slot > 0) {
        batches_[batch].in_a_row[k] = false;
        return known.slot;
    }
    std::size_t& block = fresh_[batch][k];
    if (block == 0) {
        block = motion_.size();
        motion_.emplace_back();
    }
    known.slot = block * motion_[block].numbers.size() + lane;
    moved_.push_back({static_cast<int>(cloths_.size()) - 1, particle, known.slot});
    const auto at = cloths_.back()->row(particle);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        motion_[block].numbers[axis * ContactBatch::size + lane] = at[static_cast<Eigen::Index>(axis)];
    }
    return known.slot;
}

ContactBatches::Lane ContactBatches::add(const ContactPlane& contact, ContactPush& given) {
    const std::size_t number = batch_for(contact);
    ContactBatch& batch = batches_[number];
    const std::size_t lane = batch.contact_count++;
    given_[number][lane] = &given;
    std::size_t k = 0;
    for (const PushedParticle& p : contact.pushed()) {
        ContactBatch::Particles& particles = batch.particles[k];
        particles.slots[lane] = static_cast<ContactBatch::Slot>(slot_for(number, k, lane, p.particle));
        particles.weight[lane] = p.weight;
        particles.share[lane] = p.share;
        ++k;
    }
    return {batch, lane};
}

int ContactBatches::solve(Real tolerance, int most_sweeps, Real& square) {
    int sweeps = 0;
    do {
        square = kernels::sweep_batches(batches_, motion_.front().numbers.data());
        ++sweeps;
    } while (square > tolerance * tolerance && sweeps < most_sweeps);
    return sweeps;
}

void ContactBatches::give_back() {
    for (const Moved& moved : moved_) {
        const Real* const at = motion_.front().numbers.data() + moved.slot;
        cloths_[static_cast<std::size_t>(moved.cloth)]->row(moved.particle)
            << at[0], at[ContactBatch::size], at[2 * ContactBatch::size];
    }
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const ContactBatch& batch = batches_[b];
        for (std::size_t lane = 0; lane < batch.contact_count; ++lane) {
            ContactPush& given = *given_[b][lane];
            given.normal = batch.push[lane];
            given.friction = Vec3(batch.friction[0][lane], batch.friction[1][lane], batch.friction[2][lane]);
        }
    }
}

SolverMemory::SolverMemory() : batches_(std::make_unique<ContactBatches>()) {}
SolverMemory::SolverMemory(const SolverMemory& /*other*/) : SolverMemory() {}
SolverMemory::SolverMemory(SolverMemory&&) noexcept = default;
SolverMemory& SolverMemory::operator=(const SolverMemory& /*other*/) { return *this; }
SolverMemory& SolverMemory::operator=(SolverMemory&&) noexcept = default;
SolverMemory::~SolverMemory() = default;

void SolverMemory::reserve(std::size_t contacts) { batches_->reserve(contacts); }

}  // namespace drape
