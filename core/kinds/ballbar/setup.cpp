// Reads the set-up of "TCP from ballbars".
#include "core/kinds/ballbar/setup.h"
#include "core/kinds/ballbar/ballbar.h"
#include "core/quantity/distribution.h"

#include <cctype>
#include <cmath>
#include <set>

namespace covaria::tcp {

namespace {

Eigen::Vector3d axis_of(int axis) {
    return Eigen::Vector3d::Unit(axis);
}

class SetupReading {
public:
    SetupReading(const SetupReader& setup, const AssetLibrary& assets, Problems& problems)
        : setup_(setup), assets_(assets), problems_(problems) {}

    std::optional<TcpSetup> read() {
        const std::string task = setup_.text("evaluation");
        tcp_.task = task == "points" ? Task::points : task == "measured" ? Task::measured : Task::plan;
        read_assets();
        if (problems_.has_errors()) return {};
        tcp_.supports = support_positions(tcp_.ballbars());
        if (tcp_.task == Task::points)
            read_points();
        else if (tcp_.task == Task::measured)
            read_measured();
        else
            read_plan();
        if (tcp_.points.size() > most_points)
            problems_.error("/" + table(),
                            "a procedure has at most " + std::to_string(most_points) + " points");
        if (tcp_.finds_tool()) read_fit();
        if (problems_.has_errors()) return {};
        if (tcp_.task == Task::measured) fit_measured_points(tcp_, problems_);
        finish();
        return std::move(tcp_);
    }

private:
    std::string table() const {
        return tcp_.task == Task::points     ? "points"
               : tcp_.task == Task::measured ? "measured_points"
                                             : "sequences";
    }
    std::string row_path(std::size_t row) const { return "/" + table() + "/rows/" + std::to_string(row); }

    void read_assets() {
        const auto take = [&](const char* key, std::shared_ptr<const Asset>& asset, std::string& id,
                              std::string& name) {
            id = setup_.text(key);
            const AssetLibrary::Entry* entry = assets_.find(id);
            if (!entry || !entry->asset) return;
            asset = entry->asset;
            name = entry->name.empty() ? id : entry->name;
        };
        take("ballbars", tcp_.instrument, tcp_.instrument_id, tcp_.instrument_name);
        if (!tcp_.instrument || !offers<BallbarSource>(tcp_.instrument))
            problems_.error("/ballbars", "'" + tcp_.instrument_id + "' is no set of ballbars");
        if (!setup_.has("robot")) return;
        take("robot", tcp_.robot, tcp_.robot_id, tcp_.robot_name);
        if (!tcp_.robot || !tcp_.repeatability())
            problems_.error("/robot", "'" + tcp_.robot_id + "' has no repeatability");
        else
            tcp_.turns = tcp_.repeatability()->orientation().has_value();
    }

    void read_points() {
        std::set<std::string> names;
        for (std::size_t row = 0; row < setup_.rows("points"); ++row) {
            Point point;
            point.name = setup_.cell_text("points", row, "name");
            point.label = "p" + std::to_string(row + 1);
            point.source = row_path(row);
            point.p_B = setup_.cell_vector("points", row, "x");
            if (!names.insert(point.name).second)
                problems_.error(point.source, "two points are called " + point.name);
            tcp_.points.push_back(std::move(point));
        }
    }

    void read_plan() {
        tcp_.X_BF = tcp_.ballbars().placement().inverse() * setup_.pose("flange");
        tcp_.tool_F = {setup_.number("tool_x"), setup_.number("tool_y"), setup_.number("tool_z")};
        for (std::size_t row = 0; row < setup_.rows("sequences"); ++row) {
            const double start = setup_.cell_number("sequences", row, "start"),
                         span = setup_.cell_number("sequences", row, "span");
            const auto count =
                static_cast<std::size_t>(std::lround(setup_.cell_number("sequences", row, "points")));
            begin_sequence(axis_in("sequences", row), row);
            for (std::size_t i = 0; i < count; ++i) {
                const double angle = start + span * static_cast<double>(i) / static_cast<double>(count - 1);
                const int axis = tcp_.sequences.back().axis;
                const Eigen::Vector3d turned = Eigen::AngleAxisd(angle, axis_of(axis)) * tcp_.tool_F;
                add_to_sequence(angle, tcp_.X_BF * turned, row_path(row));
            }
        }
    }

    void read_measured() {
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t row = 0; row < setup_.rows("measured_points"); ++row) {
                if (axis_in("measured_points", row) != axis) continue;
                if (!tcp_.measures(axis)) begin_sequence(axis, row);
                add_to_sequence(setup_.cell_number("measured_points", row, "angle"),
                                setup_.cell_vector("measured_points", row, "x"), row_path(row));
            }
    }

    int axis_in(const char* table, std::size_t row) const {
        return setup_.cell_text(table, row, "axis")[0] - 'x';
    }

    void begin_sequence(int axis, std::size_t row) {
        if (tcp_.measures(axis))
            problems_.error(row_path(row), std::string("the flange turns about ") + axis_letters[axis] +
                                               " in two rotations; put their points into one");
        Sequence sequence;
        sequence.axis = axis;
        sequence.first = tcp_.points.size();
        sequence.source = row_path(row);
        tcp_.sequences.push_back(std::move(sequence));
    }

    void add_to_sequence(double angle, const Eigen::Vector3d& p_B, const std::string& source) {
        Sequence& sequence = tcp_.sequences.back();
        const std::string letter(1, axis_letters[sequence.axis]);
        const std::string number = std::to_string(++sequence.count);
        Point point;
        point.name = letter + " " + number;
        point.label = letter + number;
        point.source = source;
        point.p_B = p_B;
        point.angle = angle;
        point.cosine = std::cos(angle);
        point.sine = std::sin(angle);
        sequence.sum_cosine += point.cosine;
        sequence.sum_sine += point.sine;
        tcp_.points.push_back(std::move(point));
    }

    void read_fit() {
        const std::string frame = setup_.text("frame");
        for (const FrameRule& rule : frame_rules)
            if (frame == rule.key) tcp_.frame = rule;
        tcp_.geometric_sphere = setup_.text("sphere") == "geometric";
        if (tcp_.sequences.size() < 2)
            return problems_.error(
                "/" + table(),
                "one rotation traces one circle, which leaves the centre of the flange and its "
                "axes undetermined: add a rotation about another axis");
        tcp_.first_axis = tcp_.frame.first;
        if (tcp_.first_axis < 0) tcp_.first_axis = tcp_.sequences[0].axis;
        if (!tcp_.measures(tcp_.first_axis))
            return problems_.error("/frame",
                                   std::string("no rotation measures axis ") + axis_letters[tcp_.first_axis] +
                                       ": choose another way to make the axes, or add the rotation");
        tcp_.second_axis = tcp_.frame.second;
        const bool usable = tcp_.second_axis >= 0 && tcp_.measures(tcp_.second_axis);
        for (const Sequence& s : tcp_.sequences)
            if (!usable && s.axis != tcp_.first_axis) tcp_.second_axis = s.axis;
    }

    void finish() {
        for (Point& point : tcp_.points) weigh(point);
        for (Sequence& sequence : tcp_.sequences) describe(sequence);
    }

    // 1/u² of each length as it is read at this point; no uncertainty at all counts as the limit of a small
    // one.
    void weigh(Point& point) const {
        constexpr double least_share = 1e-4;
        std::array<double, most_supports> u{};
        double largest = 0.0;
        for (std::size_t j = 0; j < tcp_.supports.size(); ++j) {
            point.length[j] = (point.p_B - tcp_.supports[j]).norm();
            u[j] = tcp_.ballbars().reading(j, point.length[j]).distribution.standard_uncertainty();
            largest = std::max(largest, u[j]);
        }
        for (std::size_t j = 0; j < tcp_.supports.size(); ++j)
            point.weights[j] =
                largest > 0.0 ? std::pow(largest / std::max(u[j], least_share * largest), 2) : 1.0;
    }

    // Radius and span of the arc, and how small rotations of the flange move its points.
    void describe(Sequence& sequence) {
        const Eigen::Vector3d across = tcp_.tool_F - tcp_.tool_F[sequence.axis] * axis_of(sequence.axis);
        sequence.radius = across.norm();
        double least = infinity, most = -infinity;
        for (std::size_t i = sequence.first; i < sequence.first + sequence.count; ++i) {
            Point& point = tcp_.points[i];
            least = std::min(least, point.angle);
            most = std::max(most, point.angle);
            const Eigen::Matrix3d turned =
                tcp_.X_BF.linear() *
                Eigen::AngleAxisd(point.angle, axis_of(sequence.axis)).toRotationMatrix();
            for (int c = 0; c < 3; ++c) point.lever.col(c) = turned * axis_of(c).cross(tcp_.tool_F);
        }
        sequence.span = most - least;
    }

    const SetupReader& setup_;
    const AssetLibrary& assets_;
    Problems& problems_;
    TcpSetup tcp_;
};

}  // namespace

bool TcpSetup::measures(int axis) const {
    for (const Sequence& sequence : sequences)
        if (sequence.axis == axis) return true;
    return false;
}

std::optional<TcpSetup> read_tcp_setup(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems) {
    return SetupReading(setup, assets, problems).read();
}

}  // namespace covaria::tcp
