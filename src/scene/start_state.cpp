#include "drape/scene/start_state.h"

#include "drape/base/input_file.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr std::size_t longest_row = 4096;
constexpr double largest = 1e12;      // of any number [m, m/s]
constexpr double longest_time = 1e9;  // s
constexpr std::string_view comment = "# ";
constexpr std::string_view one_cloth = "t,particle,x,y,z,vx,vy,vz", several = "t,cloth,particle,x,y,z,vx,vy,vz";

/// Reads row by row, in the order in which they are written.
class Reader {
public:
    Reader(std::istream& in, std::string file, std::span<const Grid> grids, std::size_t balls)
        : lines_{in, std::move(file), longest_row}, grids_(grids), balls_(balls) {}

    StartState read() {
        const std::string header(grids_.size() > 1 ? several : one_cloth);
        if (!lines_.next() || lines_.line != header) fail("expected '" + header + "'");
        for (const Grid& grid : grids_) {
            found_.states.push_back({Points(grid.particles(), 3), Points(grid.particles(), 3)});
        }
        bool any = false;
        while (lines_.next()) {
            if (lines_.number == 2 && lines_.line == std::string(comment) + std::string(ball_columns)) {
                found_.balls.resize(balls_);
                if (balls_ == 0) fail("allowed no balls: the scene has none");
                continue;
            }
            any = true;
            ball_ < found_.balls.size() ? take_ball(lines_.line) : take(lines_.line);
        }
        if (!any || particle_ != 0 || cloth_ != 0) {
            fail("ends before the last particle of cloth " + std::to_string(cloth_));
        }
        if (ball_ < found_.balls.size()) fail("ends before ball " + std::to_string(ball_));
        return std::move(found_);
    }

private:
    void take(const std::string& line) {
        const bool many = grids_.size() > 1;
        if (line.starts_with(comment)) fail("allowed no more balls: the scene has " + std::to_string(balls_));
        const auto row = parse_reals(line);
        if (!row || row->size() != (many ? 9u : 8u)) fail("expected " + std::string(many ? several : one_cloth));
        const std::size_t first = many ? 3 : 2;
        if ((many && (*row)[1] != static_cast<double>(cloth_)) || (*row)[first - 1] != particle_) {
            fail("expected particle " + std::to_string(particle_) + " of cloth " + std::to_string(cloth_));
        }
        take_time((*row)[0]);
        ClothState& state = found_.states[cloth_];
        state.x.row(particle_) = vector_at(*row, first).transpose();
        state.v.row(particle_) = vector_at(*row, first + 3).transpose();
        if (++particle_ < grids_[cloth_].particles()) return;
        particle_ = 0;
        if (++cloth_ < grids_.size()) return;
        cloth_ = 0;
        ball_ = 0;
    }

    void take_ball(std::string_view line) {
        const auto row = line.starts_with(comment) ? parse_reals(line.substr(comment.size())) : std::nullopt;
        if (!row || row->size() != 15) fail("expected " + std::string(comment) + std::string(ball_columns));
        if ((*row)[1] != static_cast<double>(ball_)) {
            fail("expected ball " + std::to_string(ball_) + ": the scene has " + std::to_string(balls_));
        }
        if ((*row)[0] != found_.time) fail("t: allowed " + real_text(found_.time) + ", the time of the rows before");
        Ball& ball = found_.balls[ball_++];
        ball.centre = vector_at(*row, 2);
        ball.velocity = vector_at(*row, 5);
        ball.orientation.coeffs() << vector_at(*row, 8), static_cast<Real>((*row)[11]);
        ball.spin = vector_at(*row, 12);
        if (!has_length_one(ball.orientation.coeffs())) fail("turn: allowed four numbers of length 1");
    }

    Vec3 vector_at(const std::vector<double>& row, std::size_t first) const {
        Vec3 vector;
        for (std::size_t k = 0; k < 3; ++k) {
            const double value = row[first + k];
            if (!(value >= -largest && value <= largest)) fail("allowed numbers of size at most " + real_text(largest));
            vector[static_cast<Eigen::Index>(k)] = static_cast<Real>(value);
        }
        return vector;
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

    [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }

    NumberedLines lines_;
    std::span<const Grid> grids_;
    std::size_t balls_;  ///< of the scene
    StartState found_;
    std::size_t cloth_ = 0;        ///< that the next row is of
    int particle_ = 0;             ///< likewise
    std::size_t ball_ = SIZE_MAX;  ///< likewise, once the particles of a moment are read
};

}  // namespace

std::optional<StartState> find_start(const Settings& settings) {
    if (settings.start.empty()) return std::nullopt;
    std::vector<Grid> grids;
    for (const ClothParameters& cloth : settings.cloths) grids.push_back(cloth.particles);
    InputFile in(settings.start, UINTMAX_MAX, InputKind::Regular);
    return read_start(in, settings.start, grids, settings.balls.size());
}

StartState read_start(std::istream& in, const std::string& file, std::span<const Grid> grids, std::size_t balls) {
    return Reader(in, file, grids, balls).read();
}

}  // namespace drape
