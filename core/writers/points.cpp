// Points with standard uncertainties in SpatialAnalyzer's ASCII format "GroupName PointName X Y Z Ux Uy Uz".
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/project/csv_reader.h"
#include "core/readers/entry_texts.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"
#include "core/writers/formats.h"

namespace covaria {

namespace {

constexpr double same_axes = 1e-9;
constexpr double same_origin = 0.01;  // in m: nominal positions may differ from estimates by less

/// The name as a cell between commas that every reader takes as a name: without separators and quotes, and
/// not beginning like a formula, a comment or a number.
std::string point_cell(const std::string& name, const std::string& otherwise) {
    std::string cell = plain_name(name);
    for (char& c : cell)
        if (c == ',' || c == ';' || c == '"') c = '_';
    if (cell.empty()) cell = otherwise;
    if (std::string_view("=+-@#/'").find(cell.front()) != std::string_view::npos) cell.insert(0, 1, '_');
    return cell;
}

/// The group as a cell that is no number: groups that are numbers would be taken for coordinates.
std::string group_cell(const std::string& name, const std::string& otherwise) {
    const std::string cell = point_cell(name, otherwise);
    return csv_number(cell, false) ? "_" + cell : cell;
}

std::string free_cell(const std::string& wanted, std::set<std::string>& taken) {
    std::string cell = wanted;
    for (int n = 2; !taken.insert(cell).second; ++n) cell = wanted + " (" + std::to_string(n) + ")";
    return cell;
}

/// A frame in which three outputs are coordinates.
struct PointFrame {
    Eigen::Matrix3d R_WQ;
    Eigen::Vector3d o_W;
    std::string group;  ///< group of the file
    std::set<std::string> names = {};

    bool is(const Eigen::Matrix3d& R, const Eigen::Vector3d& o) const {
        return (R_WQ - R).cwiseAbs().maxCoeff() <= same_axes && (o_W - o).norm() <= same_origin;
    }
};

class PointListWriter {
public:
    void add(const EvaluatedAnalysis& evaluated) {
        const PreparedAnalysis& analysis = *evaluated.analysis;
        if (!represents_measurand(*evaluated.result)) {
            said_.push_back("not written: analysis " + analysis.id + ", whose result " + does_not_represent);
            return;
        }
        std::vector<PointFrame> frames;
        std::set<std::array<std::size_t, 3>> written;
        const std::size_t before = lines_;
        for (const LayoutPoint& point : layout_of(analysis).points)
            if (point.outputs && written.insert(*point.outputs).second) add_point(evaluated, point, frames);
        if (lines_ == before) without_ += (without_.empty() ? "" : ", ") + analysis.id;
    }

    Result<WrittenFile> take() && {
        if (lines_ == 0)
            return fail(ErrorCode::bad_input, tell<"there are no points to write: no analysis has a result "
                                                   "with coordinates x, y, z of a point">());
        WrittenFile file{std::move(text_),
                         {std::to_string(lines_) + " points between commas: group, point, "
                                                   "X, Y, Z, Ux, Uy, Uz in mm; Ux, Uy, Uz are standard "
                                                   "uncertainties (1 sigma in SpatialAnalyzer)"}};
        if (!without_.empty()) file.said.push_back("without points: " + without_);
        file.said.insert(file.said.end(), said_.begin(), said_.end());
        return file;
    }

private:
    static Layout layout_of(const PreparedAnalysis& analysis) {
        std::vector<double> x;
        for (std::size_t i = 0; i < analysis.inputs.quantities.size(); ++i)
            x.push_back(estimate_of(analysis.inputs, i));
        return analysis.model->layout(x);
    }

    void add_point(const EvaluatedAnalysis& evaluated, const LayoutPoint& point,
                   std::vector<PointFrame>& frames) {
        static const Unit mm = Unit::of("mm");
        Eigen::Vector3d p, u;
        for (std::size_t i = 0; i < 3; ++i) {
            const OutputResult& output = evaluated.result->outputs.at((*point.outputs)[i]);
            if (output.quantity.unit.dimension() != mm.dimension()) return;
            p[static_cast<Eigen::Index>(i)] = output.estimate;
            u[static_cast<Eigen::Index>(i)] = output.standard_uncertainty;
        }
        const std::string name = point.group.empty() || point.group == point.name
                                     ? std::string(point.name)
                                     : point.group + " " + point.name;
        if (!p.allFinite() || !u.allFinite()) {
            said_.push_back("not written: point " + plain_name(name) + " of analysis " +
                            evaluated.analysis->id + ", whose standard uncertainty is not finite");
            return;
        }
        PointFrame& frame = frame_of(evaluated, point, name, p, frames);
        text_ += frame.group + "," +
                 free_cell(point_cell(name, "point " + std::to_string(lines_ + 1)), frame.names);
        for (const Eigen::Vector3d& v : {p, u})
            for (const double si : v) text_ += "," + format_exact(mm.interval_from_si(si));
        text_ += "\n";
        ++lines_;
    }

    /// The frame of a point: points that are expressed in another frame are a group of their own, because
    /// side by side they would mislead.
    PointFrame& frame_of(const EvaluatedAnalysis& evaluated, const LayoutPoint& point,
                         const std::string& name, const Eigen::Vector3d& p, std::vector<PointFrame>& frames) {
        const Eigen::Vector3d o = point.p_W - point.R_WQ * p;
        const auto known = std::find_if(frames.begin(), frames.end(),
                                        [&](const PointFrame& frame) { return frame.is(point.R_WQ, o); });
        if (known != frames.end()) return *known;
        const PreparedAnalysis& analysis = *evaluated.analysis;
        std::string group = group_cell(analysis.name, analysis.id);
        if (!frames.empty()) {
            group = group_cell(group + " " + name, analysis.id);
            said_.push_back("group " + group + ": in other axes than the other points of analysis " +
                            analysis.id);
        }
        frames.push_back({point.R_WQ, o, free_cell(group, groups_)});
        return frames.back();
    }

    std::string text_, without_;
    std::size_t lines_ = 0;
    std::set<std::string> groups_;
    std::vector<std::string> said_;
};

Result<WrittenFile> write_points(const WriterSource& source) {
    PointListWriter writer;
    for (const EvaluatedAnalysis& evaluated : source.analyses) writer.add(evaluated);
    return std::move(writer).take();
}

}  // namespace

Writer points_writer() {
    return {.name = "points",
            .title = "Point list with Ux Uy Uz (SpatialAnalyzer ASCII)",
            .ending = ".txt",
            .writes =
                "points of all analyses that have some, with the standard uncertainties of their "
                "coordinates, a group for each analysis",
            .write = write_points};
}

}  // namespace covaria
