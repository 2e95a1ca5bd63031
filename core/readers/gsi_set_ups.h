// What a GSI file holds, by set-ups of the instrument.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/readers/gsi_text.h"
#include "core/readers/rounds.h"

namespace covaria {

/// A sight as it was read; heights are those above the ground points.
struct GsiSight {
    int line = 0;
    std::string point;
    std::optional<double> azimuth, zenith, distance;
    double target_height = 0.0, instrument_height = 0.0;
    bool is_face_two() const;
    bool is_whole() const { return azimuth && zenith && distance; }
};

/// Readings while the instrument stood at one place.
struct GsiSetUp {
    std::string station = {};  ///< name of its point; empty where the file gives none
    int line = 0;
    std::array<double, 3> position{};  ///< position of the ground point as the instrument was told, m
    double instrument_height = 0.0;
    bool located = false;
    std::vector<GsiSight> sights = {};
    /// Sights with both angles and a distance.
    std::vector<PolarReading> readings() const;
    /// "station S1"
    std::string title() const { return station.empty() ? "station" : "station " + station; }
};

struct GsiPoint {
    int line = 0;
    std::string name;
    std::array<double, 3> p{};
    bool is_of_sight = false;  ///< whether the instrument computed it from the sight beside it
};

struct GsiContent {
    std::vector<GsiSetUp> set_ups = {};
    std::vector<GsiPoint> points = {};
};

/// The set-ups of blocks. A set-up begins with a block of station coordinates or of an instrument height
/// without a reading; where every sight repeats the coordinates of its station, with others than before.
GsiContent gsi_content(const std::vector<GsiBlock>& blocks);

}  // namespace covaria
