#include "core/readers/gsi_set_ups.h"

#include <numbers>

namespace covaria {

namespace {

bool has_reading(const GsiBlock& block) {
    return block.azimuth || block.zenith || block.distance;
}

bool has_station(const GsiBlock& block) {
    return block.station[0] && block.station[1];
}

std::array<double, 3> station_of(const GsiBlock& block) {
    return {block.station[0].value_or(0.0), block.station[1].value_or(0.0), block.station[2].value_or(0.0)};
}

GsiSetUp set_up_of(const GsiBlock& block) {
    GsiSetUp set_up{.station = has_reading(block) ? std::string() : block.point, .line = block.line};
    if (has_station(block)) {
        set_up.position = station_of(block);
        set_up.located = true;
    }
    set_up.instrument_height = block.instrument_height.value_or(0.0);
    return set_up;
}

bool begins_set_up(const GsiBlock& block, const std::vector<GsiSetUp>& before) {
    if (!has_reading(block)) return has_station(block) || (block.instrument_height && !block.target[0]);
    return has_station(block) && (before.empty() || before.back().position != station_of(block));
}

}  // namespace

bool GsiSight::is_face_two() const {
    return zenith && *zenith > std::numbers::pi;
}

std::vector<PolarReading> GsiSetUp::readings() const {
    std::vector<PolarReading> whole;
    for (const GsiSight& s : sights)
        if (s.is_whole()) whole.push_back({s.line, s.point, *s.azimuth, *s.zenith, *s.distance});
    return whole;
}

GsiContent gsi_content(const std::vector<GsiBlock>& blocks) {
    GsiContent content;
    for (const GsiBlock& block : blocks) {
        if (begins_set_up(block, content.set_ups)) content.set_ups.push_back(set_up_of(block));
        if (block.target[0] && block.target[1] && block.target[2])
            content.points.push_back({block.line,
                                      block.point,
                                      {*block.target[0], *block.target[1], *block.target[2]},
                                      has_reading(block)});
        if (!has_reading(block)) continue;
        if (content.set_ups.empty()) content.set_ups.push_back({.line = block.line});
        GsiSetUp& set_up = content.set_ups.back();
        if (set_up.sights.empty() && block.instrument_height && set_up.instrument_height == 0.0)
            set_up.instrument_height = *block.instrument_height;
        set_up.sights.push_back({block.line, block.point, block.azimuth, block.zenith, block.distance,
                                 block.target_height.value_or(0.0),
                                 block.instrument_height.value_or(set_up.instrument_height)});
    }
    return content;
}

}  // namespace covaria
