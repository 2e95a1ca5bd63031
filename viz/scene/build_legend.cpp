// Legend of a scene: a line for each sort of mark that is seen in it.
#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/name.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "viz/scene/build_parts.h"

namespace covaria::detail {
namespace {

constexpr double smallest_seen = 0.003;   // part of the scene's size: two or three pixels of a picture of all
constexpr double instrument_hides = 0.2;  // part of its size
constexpr double seen_trials = 0.01;      // part of a cloud
const Phrase distributions_of{"distributions of %1"};

/// The bodies that hide smaller uncertainties: the balls of points, and the instruments.
class Covers {
public:
    explicit Covers(const Scene& scene) : least_(smallest_seen * scene.size) {
        for (const ScenePoint& point : scene.points) radii_[point.item.id] = point.radius;
        for (const SceneVector& vector : scene.vectors) radii_[vector.item.id] = vector.radius;
        for (const SceneBody& body : scene.bodies)
            if (body.outline.empty()) glyphs_.push_back({body.item.position, instrument_hides * body.size});
    }

    bool shows(const SceneEllipsoid& ellipsoid) const {
        return ellipsoid.axes.col(0).norm() > radius_at(ellipsoid.item);
    }
    bool shows(const SceneCloud& cloud) const {
        const Eigen::Map<const Eigen::Matrix3Xf> offsets(cloud.offsets.data(), 3,
                                                         static_cast<Eigen::Index>(cloud.size()));
        const auto radius = static_cast<float>(radius_at(cloud.item));
        const auto beyond = (offsets.colwise().squaredNorm().array() > radius * radius).count();
        return static_cast<double>(beyond) > seen_trials * static_cast<double>(cloud.size());
    }

private:
    struct Glyph {
        Eigen::Vector3d at;
        double radius;
    };
    double radius_at(const SceneItem& item) const {
        const auto ball = radii_.find(item.id);
        double radius = std::max(least_, ball == radii_.end() ? 0.0 : ball->second);
        for (const Glyph& glyph : glyphs_)
            if ((glyph.at - item.position).norm() < glyph.radius) radius = std::max(radius, glyph.radius);
        return radius;
    }

    double least_;
    std::unordered_map<std::string, double> radii_;
    std::vector<Glyph> glyphs_;
};

class Legend {
public:
    explicit Legend(SceneBuild& build)
        : scene_(build.scene), in_(build.options.language), covers_(build.scene) {}

    /// Ellipsoids and clouds of one role; where neither is seen, a line that says so.
    void add_uncertainties(Role role, const std::vector<SceneEllipsoid>& ellipsoids, const Message& name) {
        const auto is_role = [role](const auto& item) { return item.role == role; };
        const auto is_seen = [&](const auto& item) { return is_role(item) && covers_.shows(item); };
        const auto cloud = std::ranges::find_if(scene_.clouds, is_role);
        const bool cloud_is_seen = std::ranges::any_of(scene_.clouds, is_seen);
        const bool ellipsoid_is_seen = std::ranges::any_of(ellipsoids, is_seen);
        if (ellipsoid_is_seen) add(LegendMark::ellipsoid, role, name);
        if (cloud_is_seen)
            add(LegendMark::cloud, role, tell<"%1 trials">(count_text(cloud->size(), in_.numbers())));
        const bool is_drawn = cloud != scene_.clouds.end() || std::ranges::any_of(ellipsoids, is_role);
        if (is_drawn && !ellipsoid_is_seen && !cloud_is_seen)
            add(LegendMark::none, role, tell<"%1: uncertainty too small to be seen">(name));
    }

    void add_histograms() {
        if (scene_.wall_histograms.empty()) return;
        const SceneItem* item = find_item(scene_, scene_.wall_histograms.front().cloud);
        const Text of = item ? running_text(in_.say(said_name(item->name))) : Text();
        scene_.legend.push_back({LegendMark::histogram, scene_.wall_histograms.front().role,
                                 in_.say_text(distributions_of, {of})});
    }

    void add_verdicts() {
        if (!scene_.not_met.empty()) add(LegendMark::diamond, Role::not_met, tell<"not met">());
    }

    void add_sight_lines() {
        if (std::ranges::any_of(scene_.links,
                                [](const SceneLink& link) { return link.kind == LinkKind::sight_line; }))
            add(LegendMark::line, Role::sight_line, tell<"sight">());
        if (std::ranges::any_of(scene_.links, &SceneLink::is_doubtful))
            add(LegendMark::line, Role::not_met, tell<"sight with an outlier">());
    }

    void add_vectors() {
        for (const auto& [kind, role, words] :
             {std::tuple{VectorKind::force, Role::vector, tell<"force, own scale">()},
              {VectorKind::moment, Role::moment, tell<"moment, own scale">()}})
            if (std::ranges::any_of(scene_.vectors,
                                    [kind = kind](const SceneVector& v) { return v.kind == kind; }))
                add(LegendMark::arrow, role, words);
    }

private:
    void add(LegendMark mark, Role role, const Message& words) {
        scene_.legend.push_back({mark, role, in_.say(words)});
    }

    Scene& scene_;
    const DocumentLanguage& in_;
    Covers covers_;
};

}  // namespace

void add_legend(SceneBuild& build) {
    const Scene& scene = build.scene;
    Legend legend(build);
    for (const auto& [role, name] : {std::pair{Role::output, tell<"out">()}, {Role::input, tell<"in">()}})
        legend.add_uncertainties(role, scene.ellipsoids, name);
    legend.add_uncertainties(Role::before, scene.ellipsoids_before, tell<"before">());
    legend.add_histograms();
    legend.add_verdicts();
    legend.add_sight_lines();
    legend.add_vectors();
}

}  // namespace covaria::detail
