#include "drape/sim/start_state.h"

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr std::size_t longest_row = 4096;
constexpr double largest = 1e12;      // of any number [m, m/s]
constexpr double longest_time = 1e9;  // s
constexpr std::string_view one_cloth = "t,particle,x,y,z,vx,vy,vz", several = "t,cloth,particle,x,y,z,vx,vy,vz";

/// Reads row by row, in the order in which they are written.
class Reader {
public:
    Reader(std::istream& in, std::string file, std::span<const Grid> grids)
        : in_(in), file_(std::move(file)), grids_(grids) {}

    StartState read() {
        std::string line;
        const std::string header(grids_.size() > 1 ? several : one_cloth);
        if (read_line(in_, line, longest_row) != LineEnd::Whole || line != header) fail("expected '" + header + "'");
        for (const Grid& grid : grids_) {
            found_.states.push_back({Points(grid.particles(), 3), Points(grid.particles(), 3)});
        }
        while (next_line(line)) take(line);
        if (line_ == 1 || cloth_ != 0 || particle_ != 0) {
            fail("ends before the last particle of cloth " + std::to_string(cloth_));
        }
        return std::move(found_);
    }

private:
    bool next_line(std::string& line) {
        const LineEnd end = read_line(in_, line, longest_row);
        if (end == LineEnd::None) return false;
        ++line_;
        if (end == LineEnd::CutOff) fail("cut off: expected an end of line");
        if (end == LineEnd::TooLong) fail("longer than " + std::to_string(longest_row) + " bytes");
        return true;
    }

    void take(const std::string& line) {
        const bool many = grids_.size() > 1;
        const auto row = parse_reals(line);
        if (!row || row->size() != (many ? 9u : 8u)) fail("expected " + std::string(many ? several : one_cloth));
        const std::size_t first = many ? 3 : 2;
        if ((many && (*row)[1] != static_cast<double>(cloth_)) || (*row)[first - 1] != particle_) {
            fail("expected particle " + std::to_string(particle_) + " of cloth " + std::to_string(cloth_));
        }
        take_time((*row)[0]);
        ClothState& state = found_.states[cloth_];
        for (std::size_t k = 0; k < 6; ++k) {
            const double value = (*row)[first + k];
            if (!(value >= -largest && value <= largest)) fail("allowed numbers of size at most " + real_text(largest));
            (k < 3 ? state.x : state.v)(particle_, static_cast<int>(k % 3)) = static_cast<Real>(value);
        }
        if (++particle_ < grids_[cloth_].particles()) return;
        particle_ = 0;
        cloth_ = (cloth_ + 1) % grids_.size();
    }

    /// All rows of a moment have its time, and no moment is before the last.
    void take_time(double t) {
        const std::string allowed = "t = " + real_text(t) + ": allowed ";
        if (!(t >= 0 && t <= longest_time)) fail(allowed + "0 <= t <= " + real_text(longest_time));
        const bool first = cloth_ == 0 && particle_ == 0;
        if (!first && t != found_.time) fail(allowed + real_text(found_.time) + ", the time of the rows before");
        if (t < found_.time) fail(allowed + "t >= " + real_text(found_.time) + ", the time of the moment before");
        found_.time = t;
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(file_ + ":" + std::to_string(line_) + ": " + message);
    }

    std::istream& in_;
    std::string file_;
    std::span<const Grid> grids_;
    StartState found_;
    int line_ = 1;
    std::size_t cloth_ = 0;  ///< that the next row is of
    int particle_ = 0;       ///< likewise
};

}  // namespace

std::optional<StartState> find_start(const Settings& settings) {
    if (settings.start.empty()) return std::nullopt;
    std::vector<Grid> grids;
    for (const ClothParameters& cloth : settings.cloths) grids.push_back(cloth.particles);
    InputFile in(settings.start);
    return read_start(in, settings.start, grids);
}

StartState read_start(std::istream& in, const std::string& file, std::span<const Grid> grids) {
    return Reader(in, file, grids).read();
}

}  // namespace drape
