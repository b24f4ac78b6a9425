#pragma once

#include <memory>
#include <utility>

namespace drape {

/// Owns an object of a class with a `clone` function; a copy owns a copy of it.
template <class T>
class Copied {
public:
    Copied() = default;
    Copied(std::unique_ptr<T> object) : object_(std::move(object)) {}  // NOLINT(google-explicit-constructor)
    Copied(const Copied& other) : object_(other.object_ ? other.object_->clone() : nullptr) {}
    Copied(Copied&&) noexcept = default;
    Copied& operator=(Copied other) noexcept {
        object_ = std::move(other.object_);
        return *this;
    }
    ~Copied() = default;

    T& operator*() const { return *object_; }
    T* operator->() const { return object_.get(); }

private:
    std::unique_ptr<T> object_;
};

/// A container, or a shared pointer, that copies of its owner begin without: what it holds is made again where it is
/// needed.
template <class Container>
class ScratchOnCopy : public Container {
public:
    using Container::operator=;

    ScratchOnCopy() = default;
    ScratchOnCopy(const ScratchOnCopy& /*other*/) : Container() {}
    ScratchOnCopy(ScratchOnCopy&&) noexcept = default;
    ScratchOnCopy& operator=(const ScratchOnCopy& /*other*/) {
        static_cast<Container&>(*this) = Container();
        return *this;
    }
    ScratchOnCopy& operator=(ScratchOnCopy&&) noexcept = default;
    ~ScratchOnCopy() = default;
};

}  // namespace drape
