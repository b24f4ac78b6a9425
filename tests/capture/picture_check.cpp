#include "picture_check.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "expected_picture.h"

namespace drape::test {

namespace {

// The cloth is red in front and teal behind; everything else is nearly grey
bool is_red(const std::uint8_t* p) { return p[0] > 1.45 * p[1] && p[0] > 1.45 * p[2]; }
bool is_teal(const std::uint8_t* p) { return p[2] > 1.25 * p[0] && p[1] > 1.15 * p[0]; }

double brightness(const Image& image, double x, double y) {
    const int left = std::clamp(static_cast<int>(std::floor(x - 0.5)), 0, image.width - 2);
    const int top = std::clamp(static_cast<int>(std::floor(y - 0.5)), 0, image.height - 2);
    const double u = x - 0.5 - left, v = y - 0.5 - top;
    const auto value = [&](int i, int j) {
        const std::uint8_t* p = image.pixel(i, j);
        return 0.3 * p[0] + 0.6 * p[1] + 0.1 * p[2];
    };
    return (1 - v) * ((1 - u) * value(left, top) + u * value(left + 1, top)) +
           v * ((1 - u) * value(left, top + 1) + u * value(left + 1, top + 1));
}

void check_cloth(const Image& image, const ExpectedPicture& expected, std::vector<std::string>& all) {
    int sure = 0, wrong = 0, front = 0, red = 0, back = 0, teal = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* pixel = image.pixel(x, y);
            const bool cloth = is_red(pixel) || is_teal(pixel);
            if (expected.surely(Seen::Front, x, y, 1))
                ++front, red += is_red(pixel);
            else if (expected.surely(Seen::Back, x, y, 1))
                ++back, teal += is_teal(pixel);
            else if (!expected.surely(Seen::Nothing, x, y, 1) && !expected.surely(Seen::Ball, x, y, 1))
                continue;
            ++sure;
            const bool wanted = expected.at(x, y) == Seen::Front || expected.at(x, y) == Seen::Back;
            wrong += cloth != wanted;
        }
    }
    const int covered = expected.count(Seen::Front) + expected.count(Seen::Back);
    if (covered < sure / 100) all.push_back("cloth: hardly in the picture");
    if (wrong > covered / 200)
        all.push_back("cloth: " + std::to_string(wrong) + " pixels of " + std::to_string(covered));
    if (front > 200 && red < 0.98 * front)
        all.push_back("front: red in " + std::to_string(red) + " of " + std::to_string(front));
    if (back > 200 && teal < 0.95 * back)
        all.push_back("back: teal in " + std::to_string(teal) + " of " + std::to_string(back));
}

// How far the ball's outline in the picture lies from where it must be [pixel]; shading near the edge may pull it by
// one
void check_ball(const Image& image, const ExpectedPicture& expected, const FrameView& truth, std::size_t ball,
                std::vector<std::string>& all) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
    int edges = 0;
    for (const auto& point : expected.ball_outline(truth, ball)) {
        // The place where the brightness changes, weighted by how much it does
        double weight = 0, moment = 0;
        for (double away = -8; away <= 8; away += 0.25) {
            const auto sample = [&](double at) {
                return brightness(image, point.x + at * point.out_x, point.y + at * point.out_y);
            };
            const double change = std::max(std::abs(sample(away + 0.5) - sample(away - 0.5)) - 1.5, 0.0);
            weight += change;
            moment += change * away;
        }
        if (weight < 40) continue;
        ++edges;
        const Eigen::Vector2d out(point.out_x, point.out_y);
        normal += out * out.transpose();
        right_side += out * (moment / weight);
    }
    if (edges < 20 || normal.determinant() < 50) {
        all.push_back("ball: too little of its outline in the picture to tell");
        return;
    }
    const double moved = (normal.inverse() * right_side).norm();
    if (moved > 1.25) all.push_back("ball: its outline is " + std::to_string(moved) + " pixels off");
}

void check_light(const Image& image, const ExpectedPicture& expected, const FrameView& truth,
                 std::vector<std::string>& all) {
    double lit = 0, dark = 0;
    int lit_pixels = 0, dark_pixels = 0, bright = 0;
    for (int y = 4; y < image.height; y += 12) {
        for (int x = 4; x < image.width; x += 12) {
            const auto ground = expected.ground_at(truth, x, y);
            const double value = brightness(image, x + 0.5, y + 0.5);
            if (ground == ExpectedPicture::Ground::Lit) lit += value, ++lit_pixels, bright += value > 150;
            if (ground == ExpectedPicture::Ground::Shadowed) dark += value, ++dark_pixels;
        }
    }
    if (lit_pixels < 20 || dark_pixels < 5) {
        all.push_back("shadow: too little of it in the picture to tell");
        return;
    }
    if (bright < 0.9 * lit_pixels)
        all.push_back("light: falls on " + std::to_string(bright) + " of " + std::to_string(lit_pixels));
    const double ratio = lit / lit_pixels / (dark / dark_pixels);
    if (ratio < 1.25)
        all.push_back("shadow: ground in the light is only " + std::to_string(ratio) + " times as bright");
}

}  // namespace

std::vector<std::string> complaints(const Image& image, const FrameView& truth) {
    const ExpectedPicture expected(truth, image.width, image.height);
    std::vector<std::string> all;
    check_cloth(image, expected, all);
    for (std::size_t ball = 0; ball < truth.balls.size(); ++ball) check_ball(image, expected, truth, ball, all);
    check_light(image, expected, truth, all);
    return all;
}

}  // namespace drape::test
