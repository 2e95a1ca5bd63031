// OptiTrack Motive, exported tracking data (CSV): the mean pose of a static take with its covariance.
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/math/rotation.h"
#include "core/project/csv_reader.h"
#include "core/readers/covariance.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

namespace {

using Pose6 = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t most_bodies = 20, most_motive_columns = 20'000;

/// A rigid body of the take: the columns of its figures, and its measured poses.
struct RigidBody {
    std::string name;
    std::array<std::size_t, 4> rotation{};  ///< columns of x, y, z, w; 0: none
    std::array<std::size_t, 3> position{};
    std::vector<Pose6> poses = {};  ///< poses: x, y, z in the file's unit, angles about x, y, z in rad
    std::size_t occluded = 0;
};

struct MotiveHeads {
    std::vector<std::string> type, name, id, group, axis;
};

std::string head(const std::vector<std::string>& row, std::size_t column) {
    return column < row.size() ? row[column] : std::string();
}

class MotiveReader {
public:
    explicit MotiveReader(const ReadChoice& choice) : choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
    }

    Result<Proposals> read(const std::string& text) {
        Result<void> done;
        const auto scanned = scan_csv(text, ',', [&](CsvRow&& row) {
            done = take(row);
            return done.has_value();
        });
        if (!scanned) return fail(scanned.error());
        if (!done) return fail(done.error());
        if (!started_)
            return refused_at(1, tell<"the file has no line 'Frame,Time (Seconds),...' with data below">());
        for (RigidBody& body : bodies_)
            if (done = propose(body); !done) return fail(done.error());
        return std::move(proposals_);
    }

private:
    Result<void> take(const CsvRow& row) {
        if (row.cells.size() > most_motive_columns)
            return refused_at(row.line, tell<"more than %1 columns are not read">(most_motive_columns));
        if (started_) return take_frame(row);
        const std::string first = head(row.cells, 0), second = head(row.cells, 1);
        if (first == "Format Version") return take_settings(row);
        if (settings_.empty())
            return refused_at(row.line, 1, tell<"the file must begin with 'Format Version,'">());
        if (first == "Frame") return begin_frames(row);
        if (second == "Type") heads_.type = row.cells;
        if (second == "Name") heads_.name = row.cells;
        if (second == "ID") heads_.id = row.cells;
        if (second.empty()) heads_.group = row.cells;
        return {};
    }

    Result<void> take_settings(const CsvRow& row) {
        for (std::size_t i = 0; i + 1 < row.cells.size(); i += 2) settings_[row.cells[i]] = row.cells[i + 1];
        const std::string rotation = settings_["Rotation Type"];
        if (rotation != "Quaternion")
            return refused_at(row.line,
                              tell<"rotations of type %1 are not read: export the take with quaternions">(
                                  in_quotes(plain_name(rotation))));
        static const std::map<std::string, const char*> units{
            {"Meters", "m"}, {"Centimeters", "cm"}, {"Millimeters", "mm"}, {"Inches", "in"}};
        const auto unit = units.find(settings_["Length Units"]);
        if (unit != units.end())
            unit_ = Unit::of(unit->second);
        else if (choice_.length_unit)
            unit_ = *choice_.length_unit;
        else
            return fail(ErrorCode::usage, tell<"the file does not state its unit of lengths; state it">());
        proposals_.found.push_back(tell<"take %1, lengths in %2, coordinate space %3">(
            in_quotes(plain_name(settings_["Take Name"])), unit_.display(),
            in_quotes(plain_name(settings_["Coordinate Space"]))));
        return {};
    }

    Result<void> begin_frames(const CsvRow& row) {
        heads_.axis = row.cells;
        started_ = true;
        std::map<std::string, std::size_t> by_id;
        std::size_t others = 0;
        for (std::size_t i = 2; i < row.cells.size(); ++i) {
            if (head(heads_.type, i) != "Rigid Body") {
                others += !head(heads_.type, i).empty();
                continue;
            }
            const std::string key = head(heads_.id, i) + "\n" + head(heads_.name, i);
            const auto [at, added] = by_id.try_emplace(key, bodies_.size());
            if (added) bodies_.push_back({plain_name(head(heads_.name, i)), {}, {}});
            place(bodies_[at->second], i);
        }
        if (others > 0) proposals_.leave_out(row.line, tell<"%1 columns of markers">(others));
        if (bodies_.size() > most_bodies)
            return refused_at(row.line, tell<"more than %1 rigid bodies are not read">(most_bodies));
        for (const RigidBody& body : bodies_)
            for (const std::size_t column :
                 {body.rotation[0], body.rotation[1], body.rotation[2], body.rotation[3], body.position[0],
                  body.position[1], body.position[2]})
                if (column == 0)
                    return refused_at(row.line, tell<"rigid body %1: columns of its rotation (X, Y, Z, W) or "
                                                     "position (X, Y, Z) are missing">(in_quotes(body.name)));
        if (bodies_.empty()) return refused_at(row.line, tell<"the take has no rigid body">());
        return {};
    }

    void place(RigidBody& body, std::size_t column) const {
        const std::string group = head(heads_.group, column), axis = head(heads_.axis, column);
        const std::size_t index = std::string("XYZW").find(axis);
        if (axis.size() != 1 || index > 3) return;
        if (group == "Rotation") body.rotation[index] = column;
        if (group == "Position" && index < 3) body.position[index] = column;
    }

    Result<void> take_frame(const CsvRow& row) {
        for (RigidBody& body : bodies_) {
            std::array<double, 7> v{};
            std::size_t empty = 0;
            for (std::size_t i = 0; i < v.size(); ++i) {
                const std::size_t column = i < 4 ? body.rotation[i] : body.position[i - 4];
                const std::string cell = head(row.cells, column);
                if (cell.empty()) {
                    ++empty;
                    continue;
                }
                const auto number = csv_number(cell, false);
                if (!number || std::abs(*number) > 1e9)
                    return refused_at(row.line, static_cast<int>(column) + 1,
                                      tell<"%1 is not a number of a pose">(in_quotes(plain_name(cell))));
                v[i] = *number;
            }
            if (empty > 0) {
                ++body.occluded;
                continue;
            }
            if (auto done = add_pose(body, v, row.line); !done) return done;
        }
        return {};
    }

    static Result<void> add_pose(RigidBody& body, const std::array<double, 7>& v, int line) {
        const Eigen::Quaterniond q(v[3], v[0], v[1], v[2]);
        if (std::abs(q.norm() - 1.0) > 0.01)
            return refused_at(line, static_cast<int>(body.rotation[0]) + 1,
                              tell<"the quaternion of %1 has not the length 1">(in_quotes(body.name)));
        const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
        if (std::abs(R(2, 0)) > std::cos(std::numbers::pi / 180.0))
            return refused_at(
                line, static_cast<int>(body.rotation[0]) + 1,
                tell<"the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn "
                     "the axes of the body in Motive by 90 degrees">(in_quotes(body.name)));
        Pose6 pose;
        pose << v[4], v[5], v[6], zyx_from_rotation<double>(R);
        for (Eigen::Index i = 3; i < 6 && !body.poses.empty(); ++i) {  // angles must not jump at 180 degrees
            const double before = body.poses.front()[i];
            pose[i] = before + std::remainder(pose[i] - before, 2.0 * std::numbers::pi);
        }
        body.poses.push_back(pose);
        return {};
    }

    Result<void> propose(const RigidBody& body) {
        const std::string name = body.name.empty() ? "Rigid body" : body.name;
        if (body.occluded > 0)
            proposals_.leave_out(
                0, tell<"%1: %2 frames in which it was not seen">(in_quotes(name), body.occluded));
        const std::size_t n = body.poses.size();
        if (n < 2)
            return refused_at(1, tell<"rigid body %1: at least two frames in which it is seen are needed">(
                                     in_quotes(name)));
        Pose6 mean = Pose6::Zero();
        for (const Pose6& pose : body.poses) mean += (pose - body.poses.front()) / static_cast<double>(n);
        mean += body.poses.front();
        Eigen::Matrix<double, 6, 6> scatter = Eigen::Matrix<double, 6, 6>::Zero();
        for (const Pose6& pose : body.poses) scatter += (pose - mean) * (pose - mean).transpose();
        const double nu = static_cast<double>(n - 1);
        const auto covariance = take_covariance(scatter / (nu * static_cast<double>(n)));
        if (!covariance) return refused_at(1, in_quotes(name) + ": " + covariance.error().message);
        static constexpr std::array<const char*, 6> symbols{"x", "y", "z", "phi_x", "phi_y", "phi_z"};
        std::vector<StatedQuantity> quantities;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto at = static_cast<Eigen::Index>(i);
            StatedQuantity q{.symbol = symbols[i], .name = name, .value = mean[at]};
            q.name +=
                i < 3 ? std::string(", ") + symbols[i] : std::string(", angle about ") + (symbols[i] + 4);
            q.unit = i < 3 ? unit_ : Unit::of("rad");
            q.statement = "standard";
            q.a = covariance->u[at];
            q.degrees_of_freedom = nu;
            q.source = "mean of " + std::to_string(n) + " frames";
            q.group = name;
            quantities.push_back(std::move(q));
        }
        proposals_.found.push_back(
            tell<"rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have "
                 "moved, and the frames are taken as independent">(in_quotes(name), n));
        AnalysisEntry analysis =
            analysis_of(id_of(name, "pose"), name,
                        "Mean of " + std::to_string(n) +
                            " frames of a static take, taken as independent observations. Angles: turned "
                            "about z, then the new y, then the new x.",
                        quantities, covariance->correlations);
        for (const AnalysisEntry& before : proposals_.analyses)
            if (before.id == analysis.id) analysis.id += "-" + std::to_string(proposals_.analyses.size() + 1);
        proposals_.analyses.push_back(std::move(analysis));
        return {};
    }

    const ReadChoice& choice_;
    Proposals proposals_;
    std::map<std::string, std::string> settings_;
    MotiveHeads heads_;
    Unit unit_ = Unit::of("m");
    std::vector<RigidBody> bodies_;
    bool started_ = false;
};

Recognition recognise_motive(std::string_view beginning, const std::string&) {
    return beginning.starts_with("Format Version,") ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_motive(const std::string& text, const ReadChoice& choice) {
    return MotiveReader(choice).read(text);
}

}  // namespace

Reader motive_reader() {
    return {.name = "motive",
            .title = "OptiTrack Motive tracking data",
            .pattern = "*.csv",
            .takes = "rigid bodies of a static take -> mean poses, Type A with their covariance",
            .recognise = recognise_motive,
            .read = read_motive};
}

}  // namespace covaria
