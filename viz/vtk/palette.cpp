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
            return {0xD9, 0x7F, 0x0C};
        case Role::output:
            return {0x2F, 0x7F, 0xC0};
        case Role::before:
            return {0x6A, 0x51, 0xA3};
        case Role::body:
            return {0xA9, 0xB0, 0xB7};
        case Role::link:
            return {0x8C, 0x94, 0x9C};
        case Role::sight_line:
            return {0x62, 0x6A, 0x74};
        case Role::instrument:
            return {0x6B, 0x74, 0x7D};
        case Role::vector:
            return {0xA6, 0x3C, 0x78};
        case Role::moment:
            return {0x7A, 0x68, 0x00};
        case Role::not_met:
            return {0xD9, 0x60, 0x1A};
        case Role::text:
            return {0x16, 0x19, 0x1D};
        case Role::quiet_text:
            return {0x4C, 0x54, 0x5D};
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
            return {0xF0, 0xA2, 0x3C};
        case Role::output:
            return {0x4B, 0x9B, 0xDD};
        case Role::before:
            return {0xB3, 0xA2, 0xE0};
        case Role::body:
            return {0x7E, 0x87, 0x90};
        case Role::link:
            return {0x8F, 0x99, 0xA3};
        case Role::sight_line:
            return {0x98, 0xA0, 0xAA};
        case Role::instrument:
            return {0x9A, 0xA4, 0xAE};
        case Role::vector:
            return {0xE0, 0x8B, 0xB9};
        case Role::moment:
            return {0xD9, 0xC6, 0x5A};
        case Role::not_met:
            return {0xF0, 0x82, 0x3A};
        case Role::text:
            return {0xEC, 0xEE, 0xF0};
        case Role::quiet_text:
            return {0xB3, 0xBA, 0xC2};
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

Colour colour_of(Material material, ScenePalette palette) {
    const bool dark_theme = palette == ScenePalette::dark;
    switch (material) {
        case Material::robot:
            return dark_theme ? Colour{0xC9, 0xCD, 0xD2} : Colour{0xE4, 0xE6, 0xE9};
        case Material::joint:
            return {0x5B, 0x63, 0x6C};
        case Material::instrument:
            return {0xD6, 0xDA, 0xDE};
        case Material::dark:
            return {0x3D, 0x43, 0x4A};
        case Material::leg:
        case Material::support:
            return {0x8A, 0x92, 0x9B};
        case Material::plate:
            return dark_theme ? Colour{0x80, 0x87, 0x8F} : Colour{0xB4, 0xBA, 0xC1};
        case Material::part:
            return {0xC3, 0xCC, 0xD4};
        case Material::nest:
            return dark_theme ? Colour{0xD9, 0xDD, 0xE1} : Colour{0x2B, 0x30, 0x36};
        case Material::lens:
            return {0x2F, 0x6F, 0xA8};
    }
    return {};
}

Colour ground_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xF7, 0xF8, 0xF9} : Colour{0x1B, 0x1E, 0x22};
}

Colour floor_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xEE, 0xF0, 0xF2} : Colour{0x24, 0x28, 0x2D};
}

Colour grid_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xD9, 0xDD, 0xE0} : Colour{0x3C, 0x42, 0x48};
}

Colour selection_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0xD8, 0x1B, 0x60} : Colour{0xFF, 0x6F, 0xA8};
}

Colour inside_colour(ScenePalette palette) {
    return palette == ScenePalette::light ? Colour{0x8E, 0x97, 0xA1} : Colour{0x5F, 0x68, 0x72};
}

}  // namespace covaria::detail
