#include "core/readers/gama_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

bool contains_any(const std::string& text, const char* letters) {
    return text.find_first_of(letters) != std::string::npos;
}

/// The role that the two attributes of a point give it; capital letters stand for points of the datum.
std::string role_of(const std::string& fix, const std::string& adj, const char* small, const char* capital) {
    if (contains_any(fix, small) || contains_any(fix, capital)) return "fixed";
    if (contains_any(adj, capital)) return "datum";
    return contains_any(adj, small) ? "unknown" : "none";
}

bool of_plane(const std::string& kind) {
    return kind != "height-difference" && kind != "dz" && kind != "z";
}
bool of_height(const std::string& kind) {
    return kind == "height-difference" || kind == "dz" || kind == "z" || kind == "slope-distance" ||
           kind == "zenith-angle";
}

/// The limit of gross errors, m. Gama weighs the absolute terms of angles before it tests them, so they may
/// miss by more in that ratio.
double gross_limit(const GamaParameters& parameters, double least_u_of_angle) {
    const double weight = 1e4 * least_u_of_angle / parameters.sigma;
    return 1e-3 * parameters.tolerance * (std::isfinite(weight) ? std::max(1.0, weight) : 1.0);
}

/// Takes over the parameters, so that observations which Gama leaves out are left out here too;
/// `least_u_of_angle` is in gon.
void take_over(const GamaParameters& parameters, double least_u_of_angle, NetworkEntry& entry,
               Proposals& proposals) {
    const double limit = gross_limit(parameters, least_u_of_angle);
    entry.gross_limit = limit;
    entry.leaves_undetermined = true;
    proposals.found.push_back(
        tell<"observations that miss what the others agree on by more than %1 m, and points that nothing "
             "tells, are left out, as Gama does">(Message::number(format_short(limit, 6))));
    if (parameters.a_posteriori)
        proposals.found.push_back(
            tell<"the file asks for standard deviations a posteriori: for these choose uncertainties as "
                 "seen, one factor s_0">());
}

/// The observations with the faces of directions. A file does not say the face; the first direction of a
/// sight in its cluster is in that of the sight's first zenith angle there, the second in that of the second.
std::vector<GamaObserved> with_faces(std::vector<GamaObserved> observed, Proposals& proposals) {
    constexpr double half_turn = 200.0;  // gon
    using Sight = std::array<std::string, 3>;
    std::map<Sight, std::vector<bool>> faces;
    for (const GamaObserved& o : observed)
        if (o.kind == "zenith-angle") faces[{o.from, o.to, o.round}].push_back(o.value > half_turn);
    std::map<Sight, std::size_t> counts;
    std::size_t found = 0;
    for (GamaObserved& o : observed) {
        if (o.kind != "direction") continue;
        const Sight sight{o.from, o.to, o.round};
        const std::size_t k = counts[sight]++;
        const auto of = faces.find(sight);
        o.face_two = of != faces.end() && k < of->second.size() && of->second[k];
        found += o.face_two;
    }
    if (found > 0)
        proposals.found.push_back(
            tell<"%1 directions are of face two, as the zenith angles of their sights say">(found));
    return observed;
}

}  // namespace

void GamaNetwork::take_axes(const pugi::xml_node& network) {
    if (const std::string axes = plain_name(network.attribute("axes-xy").value()); axes.size() == 2)
        axes_ = axes;
    const bool axes_turn_left = axes_ == "en" || axes_ == "nw" || axes_ == "se" || axes_ == "ws",
               angles_turn_left = plain_name(network.attribute("angles").value()) == "right-handed";
    clockwise_ = axes_turn_left != angles_turn_left;
}

GamaParameters gama_parameters(const XmlText& xml, const pugi::xml_node& node) {
    GamaParameters found;
    const auto text = [&](const char* attribute) { return plain_line(node.attribute(attribute).value()); };
    const auto number = [&](const char* attribute, double otherwise) {
        const auto value = number_in_text(text(attribute));
        return value && *value > 0.0 && std::isfinite(*value) ? *value : otherwise;
    };
    found.sigma = number("sigma-apr", found.sigma);
    found.tolerance = number("tol-abs", found.tolerance);
    found.a_posteriori = text("sigma-act") != "apriori";
    for (const char* attribute : {"latitude", "ellipsoid"})
        if (!text(attribute).empty())
            found.named.emplace_back(
                xml.line(node), tell<"%1: readings are not reduced to an ellipsoid">(std::string(attribute)));
    if (text("update-constrained-coordinates") == "yes")
        found.named.emplace_back(xml.line(node),
                                 tell<"update-constrained-coordinates: the datum keeps the coordinates of "
                                      "the file">());
    return found;
}

void GamaNetwork::take_point(const pugi::xml_node& node, const std::array<std::optional<double>, 3>& p,
                             bool observed) {
    const std::string id = plain_name(node.attribute("id").value()), fix = node.attribute("fix").value(),
                      adj = node.attribute("adj").value();
    const auto [known, added] = index_.try_emplace(id, points_.size());
    if (added) points_.push_back({.name = id});
    GamaPoint& point = points_[known->second];
    const std::string plane = role_of(fix, adj, "xy", "XY"), height = role_of(fix, adj, "z", "Z");
    if (plane != "none") point.plane = plane;
    if (height != "none") point.height = height;
    for (std::size_t i = 0; i < 3 && !observed; ++i)
        if (p[i]) point.p[i] = p[i];
}

Result<void> GamaNetwork::take_coordinates(const pugi::xml_node& cluster) {
    static constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    const std::size_t first = coordinates_.size();
    for (const pugi::xml_node& node : cluster.children()) {
        if (local_name(node) != "point") continue;
        take_point(node, {}, true);
        for (const char* axis : axes) {
            const auto value = number_in_text(plain_line(node.attribute(axis).value()));
            if (!value) continue;
            GamaObserved one{.kind = axis, .line = xml_.line(node), .value = *value};
            one.from = one.to = one.second = plain_name(node.attribute("id").value());
            coordinates_.push_back(std::move(one));
        }
    }
    const pugi::xml_node matrix = child_called(cluster, "cov-mat");
    if (!matrix) return {};
    const auto covariance = gama_band(xml_, matrix, coordinates_.size() - first, "observed coordinates");
    if (!covariance) return fail(covariance.error());
    for (std::size_t i = first; i < coordinates_.size(); ++i) {
        const auto a = static_cast<Eigen::Index>(i - first);
        if ((*covariance)(a, a) > 0.0) coordinates_[i].u = std::sqrt((*covariance)(a, a)) * 1e-3;
        for (std::size_t j = i + 1; j < coordinates_.size(); ++j) {
            const auto b = static_cast<Eigen::Index>(j - first);
            const double scale = std::sqrt((*covariance)(a, a) * (*covariance)(b, b));
            if (scale > 0.0 && (*covariance)(a, b) != 0.0)
                of_coordinates_.push_back({i, j, (*covariance)(a, b) / scale});
        }
    }
    return {};
}

std::optional<std::string> GamaNetwork::objection(const GamaObserved& observed) const {
    for (const std::string& name : {observed.from, observed.to, observed.second}) {
        const auto found = index_.find(name);
        if (found == index_.end()) return name;
        const GamaPoint& point = points_[found->second];
        if ((of_plane(observed.kind) && !point.has(0)) || (of_height(observed.kind) && !point.has(2)))
            return name;
    }
    return {};
}

/// The bearing of north, in the sense in which directions count.
double GamaNetwork::north() const {
    const auto along = [&](std::size_t i) { return axes_[i] == 'n' ? 1.0 : axes_[i] == 's' ? -1.0 : 0.0; };
    return clockwise_ ? std::atan2(along(0), along(1)) : std::atan2(along(1), along(0));
}

NetworkEntry GamaNetwork::entry() const {
    NetworkEntry entry;
    for (const GamaPoint& point : points_)
        entry.points.push_back(
            {.name = point.name, .p = point.p, .plane = point.plane, .height = point.height});
    for (const Row& row : rows_) {
        const GamaObserved& o = row.observed;
        const bool single = o.kind == "x" || o.kind == "y" || o.kind == "z";
        NetworkReading reading{.kind = o.kind, .from = o.from, .to = single ? std::string() : o.to};
        if (o.kind == "angle") reading.second = o.second;
        if (o.kind == "direction") reading.round = o.round;
        reading.label = row.label;
        reading.value = o.value;
        if (o.kind == "azimuth")
            reading.value = entry.angle_unit.from_si(entry.angle_unit.to_si(o.value) + north());
        reading.u = *o.u;
        reading.height_from = o.height_from;
        reading.height_to = o.height_to;
        reading.face_two = o.face_two;
        entry.readings.push_back(std::move(reading));
    }
    entry.remove_unread_points();
    entry.clockwise = clockwise_;
    return entry;
}

bool GamaNetwork::propose(const std::vector<GamaObserved>& observed,
                          const std::vector<StatedCorrelation>& correlations, const std::string& title,
                          const std::string& source) {
    std::vector<std::pair<int, Message>> left_out;
    const auto take = [&](const std::vector<GamaObserved>& all, const std::vector<StatedCorrelation>& between,
                          const std::string& prefix) {
        std::vector<std::string> labels(all.size());
        for (const StatedCorrelation& c : between)
            for (const std::size_t i : {c.first, c.second}) labels[i] = prefix + std::to_string(i + 1);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto refused = objection(all[i]);
            if (!refused && all[i].u && *all[i].u > 0.0) {
                rows_.push_back({all[i], labels[i]});
                if (all[i].is_angle) least_u_of_angle_ = std::min(least_u_of_angle_, *all[i].u);
                continue;
            }
            left_out.emplace_back(
                all[i].line,
                refused
                    ? tell<"an observation of %1, which the file neither fixes nor adjusts in what it needs">(
                          in_quotes(*refused))
                    : tell<"an observation of %1 without a standard deviation">(in_quotes(all[i].from)));
            labels[i].clear();
        }
        return labels;
    };
    const auto of_observed = take(with_faces(observed, proposals_), correlations, "o");
    if (rows_.empty()) return false;
    const auto of_coordinates = take(coordinates_, of_coordinates_, "c");
    const bool finds = std::ranges::any_of(points_, [](const GamaPoint& p) {
        return p.plane == "unknown" || p.plane == "datum" || p.height == "unknown" || p.height == "datum";
    });
    if (!finds) return false;
    for (const auto& [line, words] : left_out) proposals_.leave_out(line, words);
    for (const auto& [line, words] : parameters_.named) proposals_.leave_out(line, words);
    NetworkEntry made = entry();
    const auto add = [&](const std::vector<StatedCorrelation>& all, const std::vector<std::string>& labels) {
        for (const StatedCorrelation& c : all)
            if (!labels[c.first].empty() && !labels[c.second].empty())
                made.correlations.push_back({labels[c.first], labels[c.second], c.coefficient});
    };
    add(correlations, of_observed);
    add(of_coordinates_, of_coordinates);
    take_over(parameters_, least_u_of_angle_, made, proposals_);
    proposals_.found.push_back(tell<"a network of %1 points with %2 readings, which is adjusted">(
        made.points.size(), made.readings.size()));
    proposals_.analyses.push_back(
        made.analysis(title, "From " + source + ". Standard deviations as stated for the adjustment."));
    return true;
}

}  // namespace covaria
