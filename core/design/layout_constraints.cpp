#include "core/design/layout_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace covaria::detail {

namespace {

struct Item {
    std::string name;
    Eigen::Vector3d p_W;
};

constexpr double same_place = 1e-9;

std::vector<Item> instruments_of(const Layout& layout) {
    std::vector<Item> items;
    const auto add = [&](const std::string& name, const Eigen::Vector3d& p_W) {
        const bool known = std::any_of(items.begin(), items.end(), [&](const Item& item) {
            return item.name == name && (item.p_W - p_W).norm() <= same_place;
        });
        if (!known) items.push_back({name, p_W});
    };
    for (const LayoutBody& body : layout.bodies)
        if (body.kind == BodyKind::instrument) add(body.name, body.X_WB.translation());
    for (const LayoutPoint& point : layout.points)
        if (point.kind == PointKind::station) add(point.name, point.p_W);
    return items;
}

bool has_sight_lines(const Layout& layout) {
    return std::any_of(layout.links.begin(), layout.links.end(),
                       [](const LayoutLink& link) { return link.kind == LinkKind::sight_line; });
}

struct Box {
    explicit Box(const DesignBox& box) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low(static_cast<Eigen::Index>(axis)) = box.unit.to_si(box.from[axis]);
            high(static_cast<Eigen::Index>(axis)) = box.unit.to_si(box.to[axis]);
        }
    }
    /// Distance to the nearest face from inside; 0 outside.
    double depth(const Eigen::Vector3d& p) const {
        return std::max(0.0, std::min((p - low).minCoeff(), (high - p).minCoeff()));
    }
    /// Length of the segment's part inside (Liang and Barsky's clipping).
    double length_inside(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
        const Eigen::Vector3d d = to - from;
        double first = 0.0, last = 1.0;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            if (d(axis) == 0.0) {
                if (from(axis) <= low(axis) || from(axis) >= high(axis)) return 0.0;
                continue;
            }
            double enter = (low(axis) - from(axis)) / d(axis), leave = (high(axis) - from(axis)) / d(axis);
            if (enter > leave) std::swap(enter, leave);
            first = std::max(first, enter);
            last = std::min(last, leave);
        }
        return std::max(0.0, last - first) * d.norm();
    }
    double size() const { return (high - low).norm(); }

    Eigen::Vector3d low, high;
};

class LayoutJudge {
public:
    LayoutJudge(const Layout& layout, const Design& design)
        : layout_(layout), design_(design), instruments_(instruments_of(layout)) {}

    LayoutVerdict judge() {
        if (design_.least_distance) judge_distances(design_.least_distance->si());
        for (const DesignBox& box : design_.keep_out) judge_keep_out(box);
        for (const DesignBox& box : design_.hidden_by) judge_sights(box);
        return std::move(verdict_);
    }

private:
    /// `why` is said where it is the first.
    template <class Why>
    void violated(double by, Why&& why) {
        if (!(by > 0.0)) return;
        verdict_.violation += by;
        if (verdict_.reason.empty()) verdict_.reason = why();
    }

    void judge_distances(double least) {
        for (std::size_t i = 0; i < instruments_.size(); ++i) {
            const Item& item = instruments_[i];
            const auto judge = [&](const std::string& first, const std::string& second,
                                   const Eigen::Vector3d& p_W) {
                violated(1.0 - (p_W - item.p_W).norm() / least,
                         [&] { return tell<"%1 and %2 are closer than the least distance">(first, second); });
            };
            for (std::size_t j = 0; j < i; ++j) judge(instruments_[j].name, item.name, instruments_[j].p_W);
            for (const LayoutPoint& point : layout_.points)
                if (point.kind != PointKind::station) judge(item.name, point.name, point.p_W);
        }
    }

    void judge_keep_out(const DesignBox& given) {
        const Box box(given);
        for (const Item& item : instruments_)
            violated(box.depth(item.p_W) / box.size(), [&] {
                return given.name.empty() ? tell<"%1 stands in a box">(item.name)
                                          : tell<"%1 stands in the box '%2'">(item.name, given.name);
            });
    }

    void judge_sights(const DesignBox& given) {
        const Box box(given);
        for (const LayoutLink& link : layout_.links)
            if (link.kind == LinkKind::sight_line)
                violated(box.length_inside(link.from_W, link.to_W) / box.size(), [&] {
                    return given.name.empty()
                               ? tell<"the line of sight %1 passes a box">(link.name)
                               : tell<"the line of sight %1 passes the box '%2'">(link.name, given.name);
                });
    }

    const Layout& layout_;
    const Design& design_;
    std::vector<Item> instruments_;
    LayoutVerdict verdict_;
};

}  // namespace

LayoutVerdict judge_layout(const Layout& layout, const Design& design) {
    return LayoutJudge(layout, design).judge();
}

Message why_not_judged(const Layout& layout, const Design& design) {
    if ((design.least_distance || !design.keep_out.empty()) && instruments_of(layout).empty())
        return tell<
            "the model shows no instruments: a least distance and boxes to keep out of mean nothing to "
            "it">();
    if (!design.hidden_by.empty() && !has_sight_lines(layout))
        return tell<"the model shows no lines of sight, so that no box can hide them">();
    return {};
}

}  // namespace covaria::detail
