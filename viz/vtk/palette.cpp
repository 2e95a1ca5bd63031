// Colours of the roles.
#include "viz/vtk/palette.h"

#include <algorithm>
#include <cmath>

namespace covaria::detail {
namespace {

Colour light(Role role) {
    switch (role) {
        case Role::axis_x:
            return {0xD5, 0x5E, 0x00};
        case Role::axis_y:
            return {0x00, 0x9E, 0x73};
        case Role::axis_z:
            return {0x00, 0x72, 0xB2};
        case Role::point:
            return {0x4A, 0x50, 0x57};
        case Role::input:
            return {0xE6, 0x8A, 0x00};
        case Role::output:
            return {0x00, 0x72, 0xB2};
        case Role::before:
            return {0x6A, 0x51, 0xA3};
        case Role::body:
            return {0xA9, 0xB0, 0xB7};
        case Role::link:
            return {0x8C, 0x94, 0x9C};
        case Role::sight_line:
            return {0xA6, 0x5C, 0x86};
        case Role::instrument:
            return {0x6B, 0x74, 0x7D};
        case Role::vector:
            return {0xA6, 0x3C, 0x78};
        case Role::moment:
            return {0x7A, 0x68, 0x00};
        case Role::not_met:
            return {0xD9, 0x60, 0x1A};
        case Role::text:
            return {0x20, 0x24, 0x28};
        case Role::quiet_text:
            return {0x66, 0x6D, 0x74};
    }
    return {};
}

Colour dark(Role role) {
    switch (role) {
        case Role::axis_x:
            return {0xF0, 0x82, 0x3A};
        case Role::axis_y:
            return {0x2B, 0xC4, 0x97};
        case Role::axis_z:
            return {0x56, 0xB4, 0xE9};
        case Role::point:
            return {0xC3, 0xCA, 0xD1};
        case Role::input:
            return {0xF5, 0xB0, 0x41};
        case Role::output:
            return {0x56, 0xB4, 0xE9};
        case Role::before:
            return {0xB3, 0xA2, 0xE0};
        case Role::body:
            return {0x7E, 0x87, 0x90};
        case Role::link:
            return {0x8F, 0x99, 0xA3};
        case Role::sight_line:
            return {0xD8, 0x8F, 0xB8};
        case Role::instrument:
            return {0x9A, 0xA4, 0xAE};
        case Role::vector:
            return {0xE0, 0x8B, 0xB9};
        case Role::moment:
            return {0xD9, 0xC6, 0x5A};
        case Role::not_met:
            return {0xF0, 0x82, 0x3A};
        case Role::text:
            return {0xE9, 0xEC, 0xEF};
        case Role::quiet_text:
            return {0xA4, 0xAC, 0xB4};
    }
    return {};
}

}  // namespace

Colour colour_of(Role role, ScenePalette palette) {
    return palette == ScenePalette::light ? light(role) : dark(role);
}

Colour colour_of(MeshColour colour, ScenePalette palette) {
    switch (colour) {
        case MeshColour::grey:
            return colour_of(Role::body, palette);
        case MeshColour::blue:
            return colour_of(Role::axis_z, palette);
        case MeshColour::green:
            return colour_of(Role::axis_y, palette);
        case MeshColour::orange:
            return colour_of(Role::input, palette);
        case MeshColour::red:
            return colour_of(Role::axis_x, palette);
    }
    return {};
}

Colour magnitude_colour(double t) {
    static constexpr std::array<Colour, 9> points = {{{0x44, 0x01, 0x54},
                                                      {0x47, 0x2D, 0x7B},
                                                      {0x3B, 0x52, 0x8B},
                                                      {0x2C, 0x72, 0x8E},
                                                      {0x21, 0x91, 0x8C},
                                                      {0x28, 0xAE, 0x80},
                                                      {0x5E, 0xC9, 0x62},
                                                      {0xAD, 0xDC, 0x30},
                                                      {0xFD, 0xE7, 0x25}}};
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(points.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double part = place - static_cast<double>(first);
    const auto mix = [part](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + part * (b - a)));
    };
    const Colour &a = points[first], &b = points[first + 1];
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Colour ground_top(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xFD, 0xFD, 0xFC} : Colour{0x25, 0x29, 0x2D};
}

Colour ground_bottom(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xF2, 0xF3, 0xF4} : Colour{0x1A, 0x1D, 0x20};
}

Colour grid_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xD9, 0xDD, 0xE0} : Colour{0x3C, 0x42, 0x48};
}

Colour selection_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xD8, 0x1B, 0x60} : Colour{0xFF, 0x6F, 0xA8};
}

}  // namespace covaria::detail
