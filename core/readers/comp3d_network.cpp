#include "core/readers/comp3d_network.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/project/csv_reader.h"
#include "core/readers/comp3d_axes.h"
#include "core/readers/comp3d_readings.h"
#include "core/readers/comp3d_subframes.h"
#include "core/readers/covariance.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr double exact_coordinate =
    1e-7;  ///< u of one coordinate that is fixed beside another that is not, m
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
constexpr std::size_t most_correlated = 600;

std::string parameter(const std::string& point, std::size_t axis) {
    return point + "_" + axis_names[axis];
}

}  // namespace

Comp3dNetwork::Comp3dNetwork(const Comp3dSurvey& survey, const Comp3dSettings& settings,
                             Comp3dSurveyReader& files, Proposals& proposals)
    : survey_(survey), settings_(settings), files_(files), proposals_(proposals) {
    for (const Comp3dPoint& point : survey.points)
        if (const auto [known, added] = points_.try_emplace(point.name, &point); !added)
            files_.leave_out(point.at, tell<"point %1 again: it is as in line %2">(in_quotes(point.name),
                                                                                   known->second->at.line));
}

Comp3dNetwork::Knowledge Comp3dNetwork::knowledge(const Comp3dPoint& point, std::size_t axis) const {
    if (!point.code.has(axis)) return Knowledge::none;
    if (!point.code.constrains(axis) || settings_.has_internal_constraints) return Knowledge::unknown;
    const double sigma = point.sigma[axis].value_or(0.0);
    return sigma > 0.0 ? Knowledge::stated : sigma < 0.0 ? Knowledge::unknown : Knowledge::fixed;
}

Result<void> Comp3dNetwork::take_covariance(const std::string& text, const std::string& file) {
    const auto in_file = [&](Error error) {
        error.file = file;
        return fail(std::move(error));
    };
    const auto table = read_csv(text);
    if (!table) return in_file(table.error());
    std::set<std::string> stated;
    for (const auto& [name, point] : points_)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (knowledge(*point, axis) == Knowledge::stated) stated.insert(parameter(name, axis));
    std::vector<std::string> names;
    std::vector<std::size_t> places;
    for (std::size_t i = 1; !table->rows.empty() && i < table->rows[0].cells.size(); ++i)
        if (stated.erase(table->rows[0].cells[i]) > 0) {
            names.push_back(table->rows[0].cells[i]);
            places.push_back(i);
        }
    const std::size_t n = names.size();
    if (n > most_correlated) {
        files_.leave_out({file, 0}, tell<"a covariance matrix of more than %1 coordinates">(most_correlated));
        return {};
    }
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd covariance(size, size);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const auto* row = places[i] < table->rows.size() ? &table->rows[places[i]] : nullptr;
            const auto value = row && places[j] < row->cells.size() && row->cells[0] == names[i]
                                   ? csv_number(row->cells[places[j]], false)
                                   : std::nullopt;
            if (!value)
                return in_file(refused_at(row ? row->line : 1,
                                          tell<"the covariance of %1 and %2 is missing, or no number">(
                                              names[i], names[j]))
                                   .value());
            covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = *value;
        }
    const auto taken = covaria::take_covariance(covariance);
    if (!taken) return in_file(taken.error());
    for (std::size_t i = 0; i < n; ++i) sigmas_[names[i]] = taken->u[static_cast<Eigen::Index>(i)];
    for (const StatedCorrelation& c : taken->correlations)
        correlations_.push_back({names[c.first], names[c.second], c.coefficient});
    proposals_.found.push_back(
        tell<"%1: the covariance of %2 constrained coordinates, in place of their standard deviations">(file,
                                                                                                        n));
    return {};
}

void Comp3dNetwork::add_reading_of(const Comp3dPoint& point, std::size_t axis, double u) {
    NetworkReading reading{.kind = axis_names[axis], .from = point.name};
    if (sigmas_.contains(parameter(point.name, axis))) reading.label = parameter(point.name, axis);
    reading.value = point.p[axis];
    reading.u = u;
    entry_.readings.push_back(std::move(reading));
}

NetworkPoint Comp3dNetwork::point_of(const Comp3dPoint& point) {
    NetworkPoint made{.name = point.name, .p = {point.p[0], point.p[1], point.p[2]}};
    const auto role = [&](std::size_t first, std::size_t last) -> std::string {
        bool alike = true, correlated = false;
        for (std::size_t axis = first; axis < last; ++axis) {
            alike = alike && knowledge(point, axis) == knowledge(point, first);
            correlated = correlated || sigmas_.contains(parameter(point.name, axis));
        }
        const Knowledge of_all = knowledge(point, first);
        if (alike && of_all == Knowledge::none) return "none";
        if (alike && of_all == Knowledge::fixed) return "fixed";
        if (alike && of_all == Knowledge::unknown)
            return settings_.has_internal_constraints && !point.code.is_remote() ? "datum" : "unknown";
        for (std::size_t axis = first; axis < last; ++axis) {
            const auto found = sigmas_.find(parameter(point.name, axis));
            const double u = knowledge(point, axis) == Knowledge::fixed ? exact_coordinate
                             : found != sigmas_.end()                   ? found->second
                                                                        : point.sigma[axis].value_or(0.0);
            if (alike && !correlated)
                made.u[axis] = u;
            else if (knowledge(point, axis) != Knowledge::unknown)
                add_reading_of(point, axis, u);
        }
        return alike && !correlated ? "stated" : "unknown";
    };
    made.plane = role(0, 2);
    made.height = role(2, 3);
    return made;
}

void Comp3dNetwork::take_points() {
    std::size_t unstated = 0, off = 0;
    for (const Comp3dPoint& point : survey_.points) {
        if (points_.at(point.name) != &point) continue;
        if (point.code.is_ignored()) {
            files_.leave_out(point.at, tell<"a point that is not to be used: %1">(in_quotes(point.name)));
            continue;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!point.code.constrains(axis)) continue;
            unstated += !point.sigma[axis];
            off += point.sigma[axis] && *point.sigma[axis] < 0.0;
            if (point.sigma[axis] && *point.sigma[axis] < 0.0)
                files_.leave_out(point.at, tell<"%1: the constraint of %2, which is switched off">(
                                               in_quotes(point.name), std::string(axis_names[axis])));
        }
        deflected_ += point.is_deflected;
        entry_.points.push_back(point_of(point));
    }
    if (unstated > 0)
        proposals_.found.push_back(
            tell<"%1 coordinates are constrained without a standard deviation: they are fixed">(unstated));
}

/// Points that only readings name have no approximate coordinates, and need none.
void Comp3dNetwork::take_points_of_readings() {
    std::set<std::string> known;
    for (const auto& [name, point] : points_) known.insert(name);
    for (const NetworkPoint& point : entry_.points) known.insert(point.name);
    for (std::size_t i = 0; i < entry_.readings.size(); ++i)
        for (const std::string& name : {entry_.readings[i].from, entry_.readings[i].to})
            if (!name.empty() && known.insert(name).second) entry_.points.push_back({.name = name});
}

void Comp3dNetwork::tell_of_points() {
    if (deflected_ > 0) proposals_.leave_out(0, tell<"deflections of the vertical of %1 points">(deflected_));
    if (!settings_.projection.empty())
        proposals_.leave_out(
            0, tell<"the projection %1: its scale and the convergence of its meridians are not taken off the "
                    "readings">(in_quotes(plain_name(settings_.projection))));
    if (settings_.has_internal_constraints)
        proposals_.found.push_back(
            tell<"internal constraints: no coordinate is constrained, those that are not remote are the "
                 "datum">());
    if (const auto unread = entry_.remove_unread_points(); !unread.empty())
        proposals_.leave_out(0, tell<"%1 points that no reading names, %2 the first of them">(
                                    unread.size(), in_quotes(unread.front())));
}

bool Comp3dNetwork::propose(const std::string& title, const std::string& source) {
    take_points();
    const Comp3dGround ground(survey_, points_, settings_);
    Comp3dFlatReadings readings(ground, settings_, files_, entry_);
    Comp3dReadings(survey_, ground, settings_, files_, readings, entry_).take_all();
    Comp3dSubframes(survey_, ground, settings_, files_, readings, entry_).take_all(proposals_);
    Comp3dAxes(survey_, ground, files_, readings, entry_).take_all(proposals_);
    readings.say_what_was_done(proposals_);
    if (entry_.readings.empty()) return false;
    take_points_of_readings();
    tell_of_points();
    entry_.settle_unknowns();
    if (!entry_.adjusts_anything()) return false;
    entry_.correlations = correlations_;
    entry_.clockwise = true;
    entry_.angle_unit = settings_.angle_unit;
    entry_.leaves_undetermined = true;
    proposals_.found.push_back(
        tell<"a network of %1 points with %2 readings, which is adjusted; points that "
             "nothing tells are left out">(entry_.points.size(), entry_.readings.size()));
    proposals_.found.push_back(
        tell<"Comp3D multiplies standard deviations by its sigma 0: for these choose uncertainties as seen, "
             "one factor s_0">());
    proposals_.analyses.push_back(
        entry_.analysis(title, "From " + source + ". Standard deviations as stated for the adjustment."));
    return true;
}

}  // namespace covaria
