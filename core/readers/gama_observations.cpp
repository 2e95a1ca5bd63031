#include "core/readers/gama_observations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/in_quotes.h"
#include "core/readers/covariance.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using pugi::xml_node;

struct GamaKind {
    /// The attribute `deviation` of <points-observations> is empty where there is none.
    const char *element, *title, *deviation;
    bool angle;
    const char* reading;  ///< kind of reading of the network; empty for a vector
};
constexpr std::array<GamaKind, 8> gama_kinds{
    {{"direction", "direction", "direction-stdev", true, "direction"},
     {"angle", "angle", "angle-stdev", true, "angle"},
     {"z-angle", "zenith angle", "zenith-angle-stdev", true, "zenith-angle"},
     {"azimuth", "azimuth", "azimuth-stdev", true, "azimuth"},
     {"distance", "horizontal distance", "distance-stdev", false, "horizontal-distance"},
     {"s-distance", "slope distance", "distance-stdev", false, "slope-distance"},
     {"dh", "height difference", "", false, "height-difference"},
     {"vec", "vector", "", false, ""}}};

const GamaKind* gama_kind_of(std::string_view element) {
    const auto found = std::find_if(gama_kinds.begin(), gama_kinds.end(),
                                    [&](const GamaKind& kind) { return kind.element == element; });
    return found == gama_kinds.end() ? nullptr : &*found;
}

std::string text_of(const xml_node& node, const char* attribute) {
    return plain_line(node.attribute(attribute).value());
}

/// The degrees of an angle in degrees, minutes and seconds, "12-34-56.7" or "-0-00-01"; empty where the text
/// is none.
std::optional<double> sexagesimal_degrees(std::string text) {
    const bool minus = text.starts_with('-');
    if (minus) text.erase(0, 1);
    std::replace(text.begin(), text.end(), '-', ' ');
    std::istringstream words(text);
    std::array<double, 3> parts{};
    std::string word;
    for (double& part : parts) {
        if (!(words >> word)) return std::nullopt;
        const auto number = number_in_text(word);
        if (!number || *number < 0.0) return std::nullopt;
        part = *number;
    }
    if (words >> word) return std::nullopt;
    const double degrees = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
    return minus ? -degrees : degrees;
}

/// The parts of a + b D^c, D in km, that are stated; empty where there are more than `most` of them.
std::optional<std::array<double, 3>> parts_of(const std::string& text, std::size_t most) {
    std::istringstream words(text);
    std::array<double, 3> parts{0.0, 0.0, 1.0};
    std::string word;
    for (std::size_t i = 0; words >> word; ++i) {
        const auto number = number_in_text(word);
        if (!number || i >= most) return std::nullopt;
        parts[i] = *number;
    }
    return parts;
}

}  // namespace

Result<Eigen::MatrixXd> gama_band(const XmlText& xml, const xml_node& node, std::size_t count,
                                  const std::string& what) {
    const auto n = static_cast<Eigen::Index>(count);
    const auto dim = number_in_text(node.attribute("dim").value()),
               band = number_in_text(node.attribute("band").value());
    if (!dim || !band || *dim != static_cast<double>(n) || !(*band >= 0.0) || !(*band < *dim))
        return xml.refused(node, tell<"its dim must be the %1 %2, its band less than that">(n, what));
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
    std::istringstream words(node.child_value());
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i; j < std::min<Eigen::Index>(n, i + static_cast<Eigen::Index>(*band) + 1);
             ++j) {
            std::string word;
            words >> word;
            const auto value = number_in_text(word);
            if (!value)
                return xml.refused(
                    node, tell<"element %1, %2: %3 is no number">(i + 1, j + 1, in_quotes(plain_name(word))));
            covariance(i, j) = covariance(j, i) = *value;
        }
    return covariance;
}

Result<void> GamaObservations::read(const xml_node& cluster) {
    const std::string station = text_of(cluster, "from");
    const std::size_t first = quantities_.size(), first_observed = observed_.size(), beyond = beyond_;
    cluster_ = cluster;
    ++clusters_;
    for (const xml_node& node : cluster.children()) {
        const std::string_view name = local_name(node);
        if (node.type() != pugi::node_element || name == "cov-mat") continue;
        if (!gama_kind_of(name)) {
            proposals_.leave_out(xml_.line(node), "<" + plain_name(std::string(name)) + ">");
            continue;
        }
        auto done = name == "vec" ? read_vector(node) : read_observation(node, station);
        if (!done) return done;
    }
    const xml_node matrix = child_called(cluster, "cov-mat");
    if (!matrix) return {};
    if (auto done = take_observed_matrix(matrix, first_observed); !done) return done;
    if (beyond_ == beyond) return take_matrix(matrix, first);
    proposals_.leave_out(xml_.line(matrix), tell<"a covariance matrix of observations that are left out">());
    return {};
}

Result<void> GamaObservations::read_observation(const xml_node& node, const std::string& station) {
    const GamaKind& kind = *gama_kind_of(local_name(node));
    const std::string own = text_of(node, "from"), to = text_of(node, "to"), bs = text_of(node, "bs"),
                      fs = text_of(node, "fs");
    std::string name = std::string(kind.title) + " " + (own.empty() ? station : own) + " - ";
    name += bs.empty() ? to : bs + " - " + fs;
    return add(node, name, "val", kind.element);
}

Result<void> GamaObservations::read_vector(const xml_node& node) {
    for (const char* axis : {"dx", "dy", "dz"})
        if (auto done =
                add(node, std::string(axis) + " " + text_of(node, "from") + " - " + text_of(node, "to"), axis,
                    "vec");
            !done)
            return done;
    return {};
}

/// The standard deviation in the unit of the file; empty where none is stated.
Result<std::optional<double>> GamaObservations::deviation(const xml_node& node, const char* kind,
                                                          double value) const {
    const GamaKind& of = *gama_kind_of(kind);
    const std::string own = text_of(node, "stdev"),
                      common = *of.deviation ? text_of(defaults_, of.deviation) : std::string();
    const std::string& text = own.empty() ? common : own;
    if (text.empty() && std::string_view(kind) == "dh")
        if (const auto km = number_in_text(text_of(node, "dist")); km && *km > 0.0 && std::isfinite(*km))
            return std::optional<double>(of_one_km_ * std::sqrt(*km));
    if (text.empty()) return std::optional<double>();
    const auto stated = parts_of(text, of.angle || !own.empty() ? 1 : 3);
    if (!stated) return xml_.refused(node, tell<"the standard deviation %1 is no number">(in_quotes(text)));
    const std::array<double, 3>& parts = *stated;
    const double u = parts[0] + parts[1] * std::pow(std::abs(value) / 1000.0, parts[2]);
    if (!(u >= 0.0) || !std::isfinite(u))
        return xml_.refused(node, tell<"the standard deviation %1 must not be negative">(in_quotes(text)));
    return std::optional<double>(u);
}

Result<void> GamaObservations::add(const xml_node& node, const std::string& name, const char* value,
                                   const char* kind) {
    const bool angle = gama_kind_of(kind)->angle;
    const std::string text = text_of(node, value);
    auto number = number_in_text(text);
    const auto degrees = angle && !number ? sexagesimal_degrees(text) : std::nullopt;
    if (!number) number = degrees;
    if (!number) return xml_.refused(node, tell<"%1 = %2 is no number">(std::string(value), in_quotes(text)));
    const auto u = deviation(node, kind, *number);
    if (!u) return fail(u.error());
    if (auto done = observe(node, value, kind, *number, degrees.has_value(), *u); !done) return done;
    if (quantities_.size() == most_stated_quantities) {
        ++beyond_;
        return {};
    }
    StatedQuantity q{.symbol = "o_" + std::to_string(quantities_.size() + 1), .name = plain_name(name)};
    q.value = *number;
    q.unit = Unit::of(degrees ? "deg" : (angle ? "gon" : "m"));
    per_unit_.push_back(degrees ? 3600.0 : (angle ? 1e4 : 1e3));
    if (*u) {
        q.statement = "standard";
        q.a = **u / per_unit_.back();
    }
    q.source = "line " + std::to_string(xml_.line(node));
    for (const auto& [attribute, words] : {std::pair("from_dh", "instrument"), std::pair("to_dh", "target"),
                                           std::pair("bs_dh", "backsight"), std::pair("fs_dh", "foresight")})
        if (const std::string height = text_of(node, attribute); !height.empty())
            q.source += std::string(", ") + words + " " + plain_name(height) + " m above its point";
    quantities_.push_back(std::move(q));
    return {};
}

Result<void> GamaObservations::observe(const xml_node& node, const char* value, const char* kind,
                                       double number, bool degrees, const std::optional<double>& u) {
    const GamaKind& of = *gama_kind_of(kind);
    const auto name = [&](const char* attribute) {
        const std::string own = text_of(node, attribute);
        return plain_name(own.empty() ? text_of(cluster_, attribute) : own);
    };
    const auto height = [&](const char* attribute) {
        const std::string text = name(attribute);
        return text.empty() ? std::optional(0.0) : number_in_text(text);
    };
    GamaObserved one{.kind = *of.reading ? of.reading : value, .line = xml_.line(node), .is_angle = of.angle};
    one.from = name("from");
    one.to = name(of.reading == std::string_view("angle") ? "bs" : "to");
    one.second = of.reading == std::string_view("angle") ? name("fs") : one.to;
    if (clusters_ > 1) one.round = std::to_string(clusters_);
    const auto from_dh = height("from_dh"), to_dh = height("to_dh");
    if (!from_dh || !to_dh) return xml_.refused(node, tell<"its heights above the points are no numbers">());
    one.height_from = *from_dh;
    one.height_to = *to_dh;
    const double gon_per_degree = 400.0 / 360.0;
    one.value = degrees ? number * gon_per_degree : number;
    if (u) one.u = degrees ? *u / 3600.0 * gon_per_degree : *u * (of.angle ? 1e-4 : 1e-3);
    observed_.push_back(std::move(one));
    return {};
}

Result<void> GamaObservations::take_observed_matrix(const xml_node& matrix, std::size_t first) {
    const std::size_t n = observed_.size() - first;
    const auto covariance = gama_band(xml_, matrix, n, "observations");
    if (!covariance) return fail(covariance.error());
    const auto taken = take_covariance(*covariance);
    if (!taken) return xml_.refused(matrix, taken.error().message);
    for (std::size_t i = 0; i < n; ++i)
        observed_[first + i].u =
            taken->u[static_cast<Eigen::Index>(i)] * (observed_[first + i].is_angle ? 1e-4 : 1e-3);
    for (const StatedCorrelation& c : taken->correlations)
        observed_correlations_.push_back({first + c.first, first + c.second, c.coefficient});
    return {};
}

Result<void> GamaObservations::take_matrix(const xml_node& matrix, std::size_t first) {
    const std::size_t n = quantities_.size() - first;
    const auto covariance = gama_band(xml_, matrix, n, "observations");
    if (!covariance) return fail(covariance.error());
    const auto taken = take_covariance(*covariance);
    if (!taken) return xml_.refused(matrix, taken.error().message);
    for (std::size_t i = 0; i < n; ++i) {
        quantities_[first + i].statement = "standard";
        quantities_[first + i].a = taken->u[static_cast<Eigen::Index>(i)] / per_unit_[first + i];
    }
    for (const StatedCorrelation& c : taken->correlations)
        correlations_.push_back({first + c.first, first + c.second, c.coefficient});
    return {};
}

void GamaObservations::propose(const std::string& title, const std::string& source) {
    if (quantities_.empty()) return;
    const auto without = std::count_if(quantities_.begin(), quantities_.end(),
                                       [](const StatedQuantity& q) { return q.statement.empty(); });
    proposals_.found.push_back(
        tell<
            "%1 observations%2%3; each is its own result: write the equations of what you measure with them">(
            quantities_.size(),
            without > 0 ? tell<", %1 of them without a standard deviation">(without) : Message(),
            correlations_.empty() ? Message() : tell<", %1 correlations">(correlations_.size())));
    if (beyond_ > 0)
        proposals_.leave_out(0, tell<"%1 observations: more than %2">(beyond_, most_stated_quantities));
    proposals_.analyses.push_back(
        analysis_of("observations", "Observations of " + title,
                    "From " + source + ". Standard deviations as stated for the adjustment.", quantities_,
                    correlations_));
}

}  // namespace covaria
