#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

#include <vector>

namespace drape {
namespace {

/// A small cloth, and contacts with the ground of the triangles that are asked for.
struct WarmSheet {
    static constexpr Real h = Real(1e-3), load = Real(1e-6);
    ClothModel model = make_cloth_model(parameters());
    ClothState state = make_rest_state(parameters());
    Points before = state.x;
    std::vector<Contact> contacts;
    ResponseParameters response;
    WarmStart<Contact> warm_start;

    static ClothParameters parameters() {
        ClothParameters cloth;
        cloth.particles = {4, 4};
        return cloth;
    }

    [[nodiscard]] ClothInContact in_contact() { return {model, before, state, contacts}; }

    void touch(const std::vector<int>& triangles, Real push) {
        contacts.clear();
        for (const int triangle : triangles) {
            Contact contact;
            contact.triangle = triangle;
            contact.corners = model.grid.triangle_corners(triangle);
            contact.barycentric = {Real(0.5), Real(0.25), Real(0.25)};
            contact.normal = Vec3(0, 1, 0);
            contact.inverse_mass = 1;
            contact.displacement.normal = push;
            contacts.push_back(contact);
        }
    }
};

/// The triangles of the contacts, negative where they were given nothing.
std::vector<int> told(const std::vector<int>& before, const std::vector<int>& found) {
    WarmSheet sheet;
    const std::vector<Ball> balls(1);
    const ClothInContact cloth = sheet.in_contact();
    sheet.touch(before, WarmSheet::load);
    sheet.warm_start.take(sheet.response, WarmSheet::h, Real(9.81), std::span(&cloth, 1), sheet.contacts);
    EXPECT_TRUE(sheet.contacts.empty());
    sheet.touch(found, 0);
    sheet.warm_start.carry_over(sheet.response, std::span(&cloth, 1), balls, sheet.contacts);
    std::vector<int> triangles;
    for (const Contact& contact : sheet.contacts) {
        triangles.push_back(contact.displacement.normal > 0 ? contact.triangle : -contact.triangle);
    }
    return triangles;
}

using Triangles = std::vector<int>;

TEST(WarmStart, TellsContactsThatAreFoundAgainAndInsertsThoseThatHavePartedInTheirOrder) {
    EXPECT_EQ(told({3, 6}, {3, 6}), (Triangles{3, 6}));
    EXPECT_EQ(told({1, 3, 4, 6, 9}, {2, 3, 6, 7}), (Triangles{1, -2, 3, 4, 6, -7, 9}));
    EXPECT_EQ(told({1, 2, 8, 9}, {4, 5}), (Triangles{1, 2, -4, -5, 8, 9}));
    EXPECT_EQ(told({5, 6, 7}, {}), (Triangles{5, 6, 7}));
    EXPECT_EQ(told({}, {4, 7}), (Triangles{-4, -7}));
}

}  // namespace
}  // namespace drape
