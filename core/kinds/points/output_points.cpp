#include "core/kinds/points/output_points.h"

#include <algorithm>
#include <array>
#include <utility>

namespace covaria {

namespace {

constexpr std::array<const char*, 3> axis_symbols{"x", "y", "z"};

}  // namespace

OutputPoints::OutputPoints(std::string analysis, const std::vector<OutputQuantity>& outputs)
    : analysis_(std::move(analysis)) {
    offer(static_cast<const PointUncertaintySource&>(*this));  // its dynamic type may offer more
    const auto has = [&](const std::string& group, const char* axis) {
        return std::any_of(outputs.begin(), outputs.end(), [&](const OutputQuantity& output) {
            return output.group == group && output.symbol == axis &&
                   output.unit.dimension() == Unit::of("m").dimension();
        });
    };
    for (std::size_t j = 0; j < outputs.size(); ++j) {
        const std::string& group = outputs[j].group;
        if (j > 0 && outputs[j - 1].group == group) continue;
        if (has(group, "x") && has(group, "y") && has(group, "z")) points_.insert(group);
    }
}

std::optional<OutputReference> OutputPoints::coordinate(const std::string& point, std::size_t axis) const {
    if (!points_.contains(point)) return {};
    return OutputReference{analysis_, point, axis_symbols[axis]};
}

}  // namespace covaria
