#pragma once

#include <concepts>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "drape/base/enum_names.h"
#include "drape/base/real.h"

namespace drape {

/// A number with the range in which it is accepted.
template <class T>
struct Within {
    T& value;
    double low, high;
};

template <class T>
Within<T> within(T& value, double low, double high) {
    return {value, low, high};
}

/// A number that may be infinite, or none.
struct Unbounded {
    double& value;
};

/// The text of a snapshot, a line for each thing: its name, then its values. It is written or read by the same calls in
/// the same order, so that a class lists what it goes on from once, in a function `exchange`. Numbers read back as the
/// same bits. What is read is refused where it is not what is expected: a real number has to be of size 1e12 at most, a
/// whole one from 0 to 1e9 or, of 64 bits, 1e15, unless a range is given. So is what is written, which could not be
/// read.
class SnapshotText {
public:
    /// Writes.
    explicit SnapshotText(std::ostream& out) : out_(&out) {}

    /// Reads.
    /// @param file names it in messages
    SnapshotText(std::istream& in, std::string file) : in_(&in), file_(std::move(file)) {}

    [[nodiscard]] bool reads() const { return in_ != nullptr; }

    /// One line.
    /// @throws InputError as `file:line: name: allowed ...` if it is not what is expected, RunError when written
    template <class... Values>
    void line(std::string_view name, Values&&... values) {
        begin(name);
        (exchange(values), ...);
        end();
    }

    /// A line with a text, which may be empty.
    void text(std::string_view name, std::string& value);

    /// A line for each row, each with the same name.
    /// @param x has its size already, n x 3
    void points(std::string_view name, Points& x);

    /// How many entries there are, then what `exchange_entry` makes of each.
    template <class T, class Exchange>
    void entries(std::string_view name, std::vector<T>& entries, double max_count, Exchange exchange_entry) {
        auto count = static_cast<std::int64_t>(entries.size());
        line(name, within(count, 0, max_count));
        if (reads()) entries.clear();
        for (std::int64_t k = 0; k < count; ++k) {
            if (reads()) entries.emplace_back();
            exchange_entry(entries[static_cast<std::size_t>(k)]);
        }
    }

    /// Refuses the line just read or written.
    /// @throws InputError as `file:line: name: allowed ...`, RunError when written
    [[noreturn]] void refuse(const std::string& allowed) const;

private:
    void begin(std::string_view name);
    void end();
    [[nodiscard]] std::string_view word();
    [[nodiscard]] double number();
    void check_range(double number, double low, double high) const;
    void write(double value);

    void exchange(Unbounded unbounded) {
        if (!reads()) return write(unbounded.value);
        unbounded.value = number();
    }
    template <class T>
    void exchange(Within<T> bounded) {
        const double value = reads() ? number() : static_cast<double>(bounded.value);
        check_range(value, bounded.low, bounded.high);
        if (!reads()) return write(value);
        bounded.value = static_cast<T>(value);
        if (std::integral<T> && static_cast<double>(bounded.value) != value) refuse("whole numbers");
    }
    template <class T>
    requires std::is_arithmetic_v<T>
    void exchange(T& value) {
        if (std::same_as<T, bool>) return exchange(Within<T>{value, 0, 1});
        if (std::integral<T>) return exchange(Within<T>{value, 0, sizeof(T) < 8 ? 1e9 : 1e15});
        exchange(Within<T>{value, -1e12, 1e12});
    }
    template <Enumeration Enum>
    void exchange(Enum& value) {
        auto number = static_cast<int>(value);
        exchange(Within<int>{number, 0, static_cast<double>(enum_count<Enum> - 1)});
        value = static_cast<Enum>(number);
    }
    void exchange(Vec3& vector) {
        for (Real& number : vector) exchange(number);
    }
    void exchange(Eigen::Quaternion<Real>& turn);

    std::ostream* out_ = nullptr;
    std::istream* in_ = nullptr;
    std::string file_, line_, name_;
    std::string_view rest_;  ///< of the line
    int number_ = 0;         ///< of the line
};

}  // namespace drape
