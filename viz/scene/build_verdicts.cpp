// Marks at what does not meet its requirement.
#include <algorithm>
#include <set>
#include <string>

#include "core/propagation/requirements.h"
#include "viz/scene/build_parts.h"

namespace covaria::detail {
namespace {

/// Output quantities that do not meet theirs: at the points whose coordinates they are; others (the angles of
/// a pose) at all points of their group.
class NotMet {
public:
    explicit NotMet(const SceneBuild& build) : result_(*build.source.result) {
        std::set<std::size_t> coordinates;
        for (const LayoutPoint& point : build.source.layout->points)
            if (point.outputs) coordinates.insert(point.outputs->begin(), point.outputs->end());
        for (const VectorTip& tip : build.tips)
            if (tip.point.outputs) coordinates.insert(tip.point.outputs->begin(), tip.point.outputs->end());
        for (const RequirementResult& verdict : build.options.verdicts) {
            if (is_met(verdict) || verdict.output >= result_.outputs.size()) continue;
            if (coordinates.contains(verdict.output))
                outputs_.insert(verdict.output);
            else
                groups_.insert(group_of(verdict.output));
        }
    }

    bool has(const LayoutPoint& point) const {
        return point.outputs && std::ranges::any_of(*point.outputs, [this](std::size_t output) {
                   return outputs_.contains(output) || groups_.contains(group_of(output));
               });
    }

private:
    const std::string& group_of(std::size_t output) const { return result_.outputs[output].quantity.group; }

    const UncertaintyResult& result_;
    std::set<std::size_t> outputs_;
    std::set<std::string> groups_;
};

}  // namespace

void add_verdicts(SceneBuild& build) {
    if (!build.source.result || build.options.verdicts.empty()) return;
    const NotMet not_met(build);
    Scene& scene = build.scene;
    std::size_t next = 0;
    for (const LayoutPoint& point : build.source.layout->points) {
        if (!build.shows(point.group) || next >= scene.points.size()) continue;
        const ScenePoint& drawn = scene.points[next++];
        if (not_met.has(point))
            scene.not_met.push_back({drawn.item.id, Layer::points, drawn.item.position, drawn.radius});
    }
    for (const VectorTip& tip : build.tips)
        if (not_met.has(tip.point))
            scene.not_met.push_back({tip.item.id, Layer::vectors, tip.item.position, 0.0});
}

}  // namespace covaria::detail
