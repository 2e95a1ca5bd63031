// Supports, bars, arcs, flange and tool of "TCP from ballbars" in the robot's frame; tables about the plan.
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/ballbar/setup.h"
#include "core/quantity/distribution.h"

namespace covaria::tcp {

namespace {

class LayoutBuilder {
public:
    explicit LayoutBuilder(const TcpSetup& setup) : setup_(setup), X_RB_(setup.ballbars->placement()) {}

    Layout build() {
        add_supports();
        if (setup_.finds_tool()) {
            add_flange();
            add_bars(setup_.points.front(), "TCP");
        }
        for (std::size_t i = 0; i < setup_.points.size(); ++i) add_point(i);
        for (const Sequence& sequence : setup_.sequences) add_arc(sequence);
        return std::move(layout_);
    }

private:
    void add_supports() {
        LayoutBody plate{.name = setup_.ballbars.name, .kind = BodyKind::plate};
        for (std::size_t k = 0; k < setup_.supports.size(); ++k) {
            const Eigen::Vector3d p_R = X_RB_ * setup_.supports[k];
            layout_.points.push_back(
                {.name = own_name<"support %1">(k + 1), .kind = PointKind::support, .p_W = p_R});
            if (k < 3) plate.outline_W.push_back(p_R);
        }
        layout_.bodies.push_back(std::move(plate));
        layout_.frames.push_back(
            {.name = own_name<"ballbars">(),
             .X_WF = X_RB_,
             .source = {.path = "/placement", .draggable = true, .asset = setup_.ballbars.id}});
    }

    LayoutSource flange_source() const {
        return setup_.task == Task::plan ? LayoutSource{tcp_fields().place(&StatedTcp::flange), true}
                                         : LayoutSource{};
    }

    void add_flange() {
        const Eigen::Isometry3d X_RF = X_RB_ * setup_.X_BF;
        const std::size_t centre = OutputPlaces(setup_).centre;
        layout_.frames.push_back({.name = own_name<"flange">(), .X_WF = X_RF, .source = flange_source()});
        layout_.points.push_back({.name = own_name<"centre of the flange">(),
                                  .kind = PointKind::flange,
                                  .p_W = X_RF.translation(),
                                  .source = flange_source(),
                                  .outputs = {{centre, centre + 1, centre + 2}},
                                  .R_WQ = X_RB_.linear()});
        Eigen::Isometry3d X_RT = X_RF;
        X_RT.translation() = X_RF * setup_.tool_F;
        layout_.frames.push_back({.name = own_name<"tool">(), .X_WF = X_RT});
        layout_.points.push_back({.name = "TCP",
                                  .kind = PointKind::tool,
                                  .p_W = X_RT.translation(),
                                  .outputs = {{0, 1, 2}},
                                  .R_WQ = X_RF.linear()});
        layout_.links.push_back({.name = own_name<"tool">(),
                                 .kind = LinkKind::robot_link,
                                 .from_W = X_RF.translation(),
                                 .to_W = X_RT.translation()});
    }

    void add_bars(const Point& point, const std::string& group) {
        for (std::size_t k = 0; k < setup_.supports.size(); ++k)
            layout_.links.push_back({.name = "bar " + std::to_string(k + 1) + " – " + point.name,
                                     .kind = LinkKind::bar,
                                     .from_W = X_RB_ * setup_.supports[k],
                                     .to_W = X_RB_ * point.p_B,
                                     .group = group});
    }

    void add_point(std::size_t i) {
        const Point& point = setup_.points[i];
        const std::size_t out = OutputPlaces(setup_).points + 3 * i;
        LayoutPoint ball{.name = point.name, .kind = PointKind::ball, .p_W = X_RB_ * point.p_B};
        ball.outputs = {{out, out + 1, out + 2}};
        ball.R_WQ = X_RB_.linear();
        ball.source = {point.source, setup_.task == Task::points, X_RB_};
        layout_.points.push_back(std::move(ball));
        add_bars(point, point.name);
    }

    // Adds the planned arc, in steps of a few degrees.
    void add_arc(const Sequence& sequence) {
        const Eigen::Isometry3d X_RF = X_RB_ * setup_.X_BF;
        const double first = setup_.points[sequence.first].angle;
        const double last = setup_.points[sequence.first + sequence.count - 1].angle;
        constexpr int pieces = 40;
        Eigen::Vector3d from = Eigen::Vector3d::Zero();
        for (int k = 0; k <= pieces; ++k) {
            const Eigen::AngleAxisd turn(first + (last - first) * k / pieces,
                                         Eigen::Vector3d::Unit(sequence.axis));
            const Eigen::Vector3d to = X_RF * (turn * setup_.tool_F);
            if (k > 0)
                layout_.links.push_back({.name = std::string("arc about ") + axis_letters[sequence.axis],
                                         .kind = LinkKind::edge,
                                         .from_W = from,
                                         .to_W = to});
            from = to;
        }
    }

    const TcpSetup& setup_;
    Eigen::Isometry3d X_RB_;
    Layout layout_;
};

}  // namespace

Layout tcp_layout(const TcpSetup& setup) {
    return LayoutBuilder(setup).build();
}

std::vector<Table> tcp_evaluation(const TcpSetup& setup) {
    const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    if (!setup.finds_tool()) return {};
    Table table{"rotations", "Rotations of the flange"};
    table.add("about");
    table.add("points");
    table.add("from").in(deg).figure(5);
    table.add("to").in(deg).figure(5);
    table.add("radius of the circle").in(mm).figure(5);
    table.add("least height above the supports").in(mm).figure(5);
    table.add("greatest height").in(mm).figure(5);
    for (const Sequence& s : setup.sequences) {
        double least = infinity, most = -infinity;
        for (std::size_t i = s.first; i < s.first + s.count; ++i) {
            least = std::min(least, setup.points[i].p_B.z());
            most = std::max(most, setup.points[i].p_B.z());
        }
        table.row({std::string(1, axis_letters[s.axis]), static_cast<double>(s.count),
                   setup.points[s.first].angle, setup.points[s.first + s.count - 1].angle, s.radius, least,
                   most});
    }
    return {table};
}

}  // namespace covaria::tcp
