#include "drape/base/snapshot_text.h"

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"

namespace drape {

void SnapshotText::begin(std::string_view name) {
    name_ = name;
    if (!reads()) {
        *out_ << name;
        return;
    }
    constexpr std::size_t longest = 1 << 24;  // a list of pins may be long
    ++number_;
    const LineEnd how = read_line(*in_, line_, longest);
    rest_ = line_;
    if (how != LineEnd::Whole || word() != name) refuse("a line '" + name_ + " ...' here");
}

void SnapshotText::end() {
    if (!reads()) {
        *out_ << '\n';
    } else if (!rest_.empty()) {
        refuse("no more values");
    }
}

void SnapshotText::text(std::string_view name, std::string& value) {
    begin(name);
    if (reads()) {
        value = std::exchange(rest_, {});
    } else {
        if (value.find_first_of("\r\n") != std::string::npos) refuse("a text of one line");
        *out_ << ' ' << value;
    }
    end();
}

void SnapshotText::points(std::string_view name, Points& x) {
    for (Eigen::Index p = 0; p < x.rows(); ++p) line(name, x(p, 0), x(p, 1), x(p, 2));
}

void SnapshotText::exchange(Eigen::Quaternion<Real>& turn) {
    for (Real& number : turn.coeffs()) exchange(number);
    if (!has_length_one(turn.coeffs())) refuse("a turn of four numbers of length 1");
}

/// The next word of the line that is read.
std::string_view SnapshotText::word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
}

void SnapshotText::write(double value) { *out_ << ' ' << real_text(value); }

double SnapshotText::number() {
    const std::string_view text = word();
    const auto number = parse_real(text);
    if (!number) refuse("another number instead of '" + shortened(text) + "'");
    return *number;
}

void SnapshotText::check_range(double number, double low, double high) const {
    if (number >= low && number <= high) return;
    refuse((low == high ? real_text(low) : "numbers from " + real_text(low) + " to " + real_text(high)) + ", not " +
           real_text(number));
}

void SnapshotText::refuse(const std::string& allowed) const {
    const std::string why = name_ + ": allowed " + allowed;
    if (!reads()) throw RunError("no snapshot: " + why);
    throw InputError(file_ + ":" + std::to_string(number_) + ": " + why);
}

}  // namespace drape
