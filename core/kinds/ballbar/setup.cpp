// The set-up of "TCP from ballbars" and what follows from its fields.
#include "core/kinds/ballbar/setup.h"
#include "core/quantity/distribution.h"

#include <cmath>
#include <set>

namespace covaria::tcp {

namespace {

Eigen::Vector3d axis_of(int axis) {
    return Eigen::Vector3d::Unit(axis);
}

class SetupReading {
public:
    SetupReading(StatedTcp stated, Problems& problems) : problems_(problems), tcp_(std::move(stated)) {}

    std::optional<TcpSetup> read() {
        if (tcp_.robot) tcp_.turns = tcp_.robot->orientation().has_value();
        tcp_.supports = support_positions(*tcp_.ballbars);
        if (tcp_.has_lengths())
            take_lengths(tcp_, problems_);
        else if (tcp_.task == Task::points)
            take_places();
        else if (tcp_.task == Task::measured)
            take_measured();
        else
            take_plan();
        if (tcp_.points.size() > most_points)
            problems_.error(table(), tell<"a procedure has at most %1 points">(most_points));
        if (tcp_.finds_tool()) choose_axes();
        if (problems_.has_errors()) return {};
        if (tcp_.task == Task::measured) fit_measured_points(tcp_, problems_);
        finish();
        return std::move(tcp_);
    }

private:
    std::string table() const {
        return tcp_.has_lengths()            ? tcp_fields().place(&StatedTcp::lengths)
               : tcp_.task == Task::points   ? tcp_fields().place(&StatedTcp::places)
               : tcp_.task == Task::measured ? tcp_fields().place(&StatedTcp::measured)
                                             : tcp_fields().place(&StatedTcp::rotations);
    }
    std::string row_path(std::size_t row) const { return table() + "/rows/" + std::to_string(row); }

    void take_places() {
        std::set<std::string> names;
        for (std::size_t row = 0; row < tcp_.places.size(); ++row) {
            Point point;
            point.name = tcp_.places[row].name;
            point.label = "p" + std::to_string(row + 1);
            point.source = row_path(row);
            point.p_B = tcp_.places[row].p_B;
            if (!names.insert(point.name).second)
                problems_.error(point.source, tell<"two points are called %1">(point.name));
            tcp_.points.push_back(std::move(point));
        }
    }

    void take_plan() {
        tcp_.X_BF = tcp_.ballbars->placement().inverse() * tcp_.flange;
        tcp_.tool_F = {tcp_.tool_x, tcp_.tool_y, tcp_.tool_z};
        for (std::size_t row = 0; row < tcp_.rotations.size(); ++row) {
            const StatedTcp::Rotation& rotation = tcp_.rotations[row];
            begin_sequence(rotation.axis, row);
            for (int i = 0; i < rotation.points; ++i) {
                const double angle = rotation.start + rotation.span * static_cast<double>(i) /
                                                          static_cast<double>(rotation.points - 1);
                const Eigen::Vector3d turned = Eigen::AngleAxisd(angle, axis_of(rotation.axis)) * tcp_.tool_F;
                add_to_sequence(angle, tcp_.X_BF * turned, row_path(row));
            }
        }
    }

    void take_measured() {
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t row = 0; row < tcp_.measured.size(); ++row) {
                const StatedTcp::Measured& point = tcp_.measured[row];
                if (point.axis != axis) continue;
                if (!tcp_.measures(axis)) begin_sequence(axis, row);
                add_to_sequence(point.angle, point.p_B, row_path(row));
            }
    }

    void begin_sequence(int axis, std::size_t row) {
        if (tcp_.measures(axis))
            problems_.error(row_path(row),
                            tell<"the flange turns about %1 in two rotations; put their points into one">(
                                axis_letters[axis]));
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

    void choose_axes() {
        if (tcp_.sequences.size() < 2)
            return problems_.error(
                table(), tell<"one rotation traces one circle, which leaves the centre of the flange and its "
                              "axes undetermined: add a rotation about another axis">());
        tcp_.first_axis = tcp_.frame.first;
        if (tcp_.first_axis < 0) tcp_.first_axis = tcp_.sequences[0].axis;
        if (!tcp_.measures(tcp_.first_axis))
            return problems_.error(
                tcp_fields().place(&StatedTcp::frame),
                tell<
                    "no rotation measures axis %1: choose another way to make the axes, or add the rotation">(
                    axis_letters[tcp_.first_axis]));
        tcp_.second_axis = tcp_.frame.second;
        const bool usable = tcp_.second_axis >= 0 && tcp_.measures(tcp_.second_axis);
        for (const Sequence& s : tcp_.sequences)
            if (!usable && s.axis != tcp_.first_axis) tcp_.second_axis = s.axis;
    }

    void finish() {
        for (Point& point : tcp_.points) weigh(tcp_, point);
        for (Sequence& sequence : tcp_.sequences) describe(sequence);
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

    Problems& problems_;
    TcpSetup tcp_;
};

}  // namespace

void weigh(const TcpSetup& setup, Point& point) {
    constexpr double least_share = 1e-4;
    std::array<double, most_supports> u{};
    double largest = 0.0;
    for (std::size_t j = 0; j < setup.supports.size(); ++j) {
        point.length[j] = (point.p_B - setup.supports[j]).norm();
        u[j] = setup.ballbars->reading(j, point.length[j]).distribution.standard_uncertainty();
        largest = std::max(largest, u[j]);
    }
    for (std::size_t j = 0; j < setup.supports.size(); ++j)
        point.weights[j] = largest > 0.0 ? std::pow(largest / std::max(u[j], least_share * largest), 2) : 1.0;
}

bool TcpSetup::measures(int axis) const {
    for (const Sequence& sequence : sequences)
        if (sequence.axis == axis) return true;
    return false;
}

std::optional<TcpSetup> read_tcp_setup(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems) {
    StatedTcp stated = tcp_fields().read(setup, assets, problems);
    if (problems.has_errors()) return {};
    return SetupReading(std::move(stated), problems).read();
}

}  // namespace covaria::tcp
