// GNU Gama: networks (.gkf), their points and observations with their covariance; adjusted networks (.xml),
// their coordinates with their covariance.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/readers/covariance.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/gama_network.h"
#include "core/readers/gama_observations.h"
#include "core/readers/listed_points.h"
#include "core/readers/xml_text.h"

namespace covaria {

namespace {

constexpr std::array<const char*, 3> axis_attributes{"x", "y", "z"};

/// Clusters of observed coordinates none of whose points is observed twice.
struct Determination {
    int line = 0;
    std::map<std::string, std::size_t> observed = {};  ///< points of the list, by name
};

Message axes_words(const pugi::xml_node& network) {
    std::string axes = plain_name(network.attribute("axes-xy").value());
    if (axes.empty()) axes = "ne";
    // Of the eight orientations four are right-handed with z upwards.
    const bool right = axes == "en" || axes == "nw" || axes == "se" || axes == "ws";
    return tell<"coordinates in metres, axes-xy = %1%2">(
        axes, (right ? Message() : tell<": a left-handed frame; x and y are taken as they stand">()));
}

class GamaReader {
public:
    GamaReader(const XmlText& xml, const ReadChoice& choice)
        : xml_(xml), choice_(choice), network_(xml, proposals_) {
        list_.title = without_ending(choice.file_name);
        if (list_.title.empty()) list_.title = "Network";
        list_.unit = Unit::of("m");
        list_.source = "GNU Gama, " + plain_name(choice.file_name);
    }

    Result<Proposals> read() {
        const pugi::xml_node root = xml_.root(), network = child_called(root, "network");
        if (local_name(root) != "gama-local" || !network)
            return xml_.refused(root,
                                tell<"no network of GNU Gama: <gama-local> with a <network> is expected">());
        proposals_.title = list_.title;
        if (choice_.length_unit)
            proposals_.leave_out(0, tell<"the stated unit of lengths: coordinates of Gama are in metres">());
        proposals_.found.push_back(axes_words(network));
        network_.take_axes(network);
        const pugi::xml_node data = child_called(network, "points-observations");
        network_.take_parameters(gama_parameters(xml_, child_called(network, "parameters")));
        GamaObservations observations(xml_, data, network_.parameters().sigma, proposals_);
        for (const pugi::xml_node& node : data.children())
            if (auto done = GamaObservations::is_cluster(local_name(node)) ? observations.read(node)
                                                                           : read_part(node);
                !done)
                return fail(done.error());
        for (const auto& [name, lines] : others_)
            proposals_.leave_out(lines.first, tell<"%1 <%2> with observations">(lines.second, name));
        const std::string source = list_.source, title = list_.title;
        if (network_.propose(observations.observed(), observations.observed_correlations(), title, source))
            return std::move(proposals_);
        if (const pugi::xml_node parameters = child_called(network, "parameters"))
            proposals_.leave_out(xml_.line(parameters), tell<"<parameters>">());
        for (const auto& [line, words] : unplaced_coordinates_) proposals_.leave_out(line, words);
        if (unplaced_ > 0) proposals_.leave_out(unplaced_line_, tell<"%1 points without x and y">(unplaced_));
        if (planar_ > 0) proposals_.found.push_back(tell<"%1 points have no z: it is taken as 0">(planar_));
        if (list_.points.empty())
            return xml_.refused(data ? data : network,
                                tell<"the network has no points with coordinates x and y">());
        if (approximate_ > 0)
            proposals_.found.push_back(
                tell<"%1 points are to be adjusted: their coordinates are approximate ones">(approximate_));
        tell_determinations_apart();
        auto proposed = propose_points(std::move(list_), proposals_);
        if (!proposed) return fail(proposed.error());
        observations.propose(title, source);
        return std::move(proposals_);
    }

private:
    Result<void> read_part(const pugi::xml_node& node) {
        const std::string_view name = local_name(node);
        if (name == "point") return read_point(node);
        if (name == "coordinates") return read_coordinates(node);
        if (node.type() == pugi::node_element) {
            auto& lines = others_.try_emplace(plain_name(std::string(name)), std::pair{xml_.line(node), 0})
                              .first->second;
            ++lines.second;
        }
        return {};
    }

    /// The coordinates, 0 to 2 for x to z, that the element has.
    Result<std::array<std::optional<double>, 3>> coordinates_of(const pugi::xml_node& node) const {
        std::array<std::optional<double>, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const pugi::xml_attribute attribute = node.attribute(axis_attributes[i]);
            if (!attribute) continue;
            std::istringstream words(attribute.value());
            std::string word;
            words >> word;
            p[i] = number_in_text(word);
            if (!p[i] || words >> word)
                return xml_.refused(node,
                                    tell<"%1 = %2 is no number">(std::string(axis_attributes[i]),
                                                                 in_quotes(plain_name(attribute.value()))));
        }
        return p;
    }

    Result<void> read_point(const pugi::xml_node& node) {
        const auto p = coordinates_of(node);
        if (!p) return fail(p.error());
        network_.take_point(node, *p, false);
        if (!(*p)[0] || !(*p)[1]) {
            if (unplaced_++ == 0) unplaced_line_ = xml_.line(node);
            return {};
        }
        planar_ += !(*p)[2];
        const std::string id = plain_name(node.attribute("id").value());
        if (list_.points.size() == most_listed_points)
            return xml_.refused(node, tell<"too many points: divide the file">());
        const ListedPoint point{
            .line = xml_.line(node), .name = id, .p = {*(*p)[0], *(*p)[1], (*p)[2].value_or(0.0)}};
        if (const auto [known, added] = index_.try_emplace(id, list_.points.size()); !added) {
            const ListedPoint& first = list_.points[known->second];
            if (first.p != point.p)
                proposals_.leave_out(point.line,
                                     tell<"point %1 with other coordinates: those of line %2 are taken">(
                                         in_quotes(id), first.line));
            return {};
        }
        if (node.attribute("adj") && !node.attribute("fix")) ++approximate_;
        list_.points.push_back(point);
        return {};
    }

    /// The first determination in which none of the cluster's points was observed yet.
    Determination& determination_of(const pugi::xml_node& cluster) {
        const auto has_one_of = [&](const Determination& d) {
            for (const pugi::xml_node& point : cluster.children())
                if (d.observed.contains(plain_name(point.attribute("id").value()))) return true;
            return false;
        };
        auto free = std::find_if_not(determinations_.begin(), determinations_.end(), has_one_of);
        if (free == determinations_.end()) free = determinations_.insert(free, Determination());
        if (free->line == 0) free->line = xml_.line(cluster);
        return *free;
    }

    /// The point of the list for an observed one; in a determination after the first it is one of its own,
    /// which begins as the network has it.
    std::size_t place_in(Determination& determination, const std::string& id, int line) {
        if (const auto own = determination.observed.find(id); own != determination.observed.end())
            return own->second;
        const auto [known, added] = index_.try_emplace(id, list_.points.size());
        std::size_t place = known->second;
        if (added) {
            list_.points.push_back({.line = line, .name = id, .p = {}});
        } else if (&determination != &determinations_.front()) {
            ListedPoint own = begun_.contains(id) ? begun_[id] : list_.points[place];
            place = list_.points.size();
            list_.points.push_back(std::move(own));
        }
        begun_.try_emplace(id, list_.points[place]);
        return determination.observed[id] = place;
    }

    /// Gives each determination an artefact of its own, with the points that nobody observed: two
    /// determinations of one point are two results, of which people keep both or choose one.
    void tell_determinations_apart() {
        if (determinations_.size() < 2) return;
        std::string lines;
        std::set<std::size_t> observed;
        for (const Determination& d : determinations_) {
            lines += (lines.empty() ? "" : ", ") + std::to_string(d.line);
            for (const auto& [id, place] : d.observed) observed.insert(place);
        }
        const std::size_t points = list_.points.size();
        for (std::size_t k = 0; k < determinations_.size(); ++k) {
            const std::string group = list_.title + ", determination " + std::to_string(k + 1);
            for (const auto& [id, place] : determinations_[k].observed) list_.points[place].group = group;
            for (std::size_t i = 0; i < points; ++i) {
                if (observed.contains(i) || determinations_[k].observed.contains(list_.points[i].name))
                    continue;
                if (k > 0) list_.points.push_back(list_.points[i]);
                (k > 0 ? list_.points.back() : list_.points[i]).group = group;
            }
        }
        proposals_.found.push_back(tell<"%1 determinations of the same points (<coordinates> of lines %2): "
                                        "each is an artefact of its "
                                        "own; keep all of them, or delete those that you do not want">(
            determinations_.size(), lines));
    }

    /// Reads observed coordinates and their covariance; the points get them in place of approximate ones.
    Result<void> read_coordinates(const pugi::xml_node& node) {
        if (auto done = network_.take_coordinates(node); !done) return done;
        Determination& determination = determination_of(node);
        std::vector<std::size_t> places;  // indices 3 * point + coordinate, in the order of the matrix
        for (const pugi::xml_node& point : node.children()) {
            if (local_name(point) != "point") continue;
            const auto p = coordinates_of(point);
            if (!p) return fail(p.error());
            const std::string id = plain_name(point.attribute("id").value());
            const auto known = index_.find(id);
            const bool whole = (*p)[0] && (*p)[1];
            if (known == index_.end() && !whole) {
                unplaced_coordinates_.emplace_back(
                    xml_.line(node), tell<"<coordinates>: point %1 has no x and y">(in_quotes(id)));
                return {};
            }
            const std::size_t at = place_in(determination, id, xml_.line(point));
            for (std::size_t i = 0; i < 3; ++i)
                if ((*p)[i]) {
                    list_.points[at].p[i] = *(*p)[i];
                    places.push_back(3 * at + i);
                }
        }
        const pugi::xml_node matrix = child_called(node, "cov-mat");
        return matrix ? read_covariance(matrix, places) : Result<void>();
    }

    /// Reads a covariance matrix in mm².
    Result<void> read_covariance(const pugi::xml_node& node, const std::vector<std::size_t>& places) {
        if (places.size() > most_stated_quantities) {
            proposals_.leave_out(xml_.line(node), tell<"a covariance matrix of more than %1 coordinates">(
                                                      most_stated_quantities));
            return {};
        }
        const auto covariance = gama_band(xml_, node, places.size(), "observed coordinates");
        if (!covariance) return fail(covariance.error());
        const auto taken = take_covariance(*covariance);
        if (!taken) return xml_.refused(node, taken.error().message);
        for (std::size_t i = 0; i < places.size(); ++i)
            list_.points[places[i] / 3].u[places[i] % 3] = taken->u[static_cast<Eigen::Index>(i)] * 1e-3;
        for (const StatedCorrelation& c : taken->correlations)
            list_.correlations.push_back({places[c.first], places[c.second], c.coefficient});
        return {};
    }

    const XmlText& xml_;
    const ReadChoice& choice_;
    Proposals proposals_;
    PointList list_;
    std::map<std::string, std::size_t> index_;
    std::vector<Determination> determinations_;
    std::map<std::string, ListedPoint> begun_;           ///< observed points as they were before
    std::map<std::string, std::pair<int, int>> others_;  ///< first line and number of each other element
    GamaNetwork network_;
    /// Remarks on coordinates that a list of points cannot hold.
    std::vector<std::pair<int, Message>> unplaced_coordinates_;
    std::size_t unplaced_ = 0, planar_ = 0, approximate_ = 0;
    int unplaced_line_ = 0;
};

/// Reader of the result of gama-local: coordinates of its points, fixed and adjusted ones, in metres.
class AdjustedGamaReader {
public:
    AdjustedGamaReader(const XmlText& xml, const ReadChoice& choice) : xml_(xml) {
        list_.title = without_ending(choice.file_name);
        if (list_.title.empty()) list_.title = "Network";
        list_.unit = Unit::of("m");
        list_.source = "GNU Gama, " + plain_name(choice.file_name);
        if (choice.length_unit)
            proposals_.leave_out(0, tell<"the stated unit of lengths: coordinates of Gama are in metres">());
    }

    Result<Proposals> read() {
        const pugi::xml_node coordinates = child_called(xml_.root(), "coordinates");
        for (const char* part : {"fixed", "adjusted"})
            for (const pugi::xml_node& point : child_called(coordinates, part).children())
                if (auto done = read_point(point, *part == 'a'); !done) return fail(done.error());
        // Points without x and y are refused: planar networks have no z, but a point of a levelling has
        // nothing else.
        std::erase_if(has_, [](const auto& point) { return point.second[0] && point.second[1]; });
        if (!has_.empty() || places_.empty())
            return xml_.refused(coordinates ? coordinates : xml_.root(),
                                places_.empty()
                                    ? tell<"the file has no adjusted coordinates">()
                                    : tell<"point %1 has no x and y">(in_quotes(has_.begin()->first)));
        proposals_.title = list_.title;
        proposals_.found.push_back(tell<"adjusted coordinates in metres">());
        const pugi::xml_node matrix = child_called(coordinates, "cov-mat");
        if (!matrix) proposals_.leave_out(0, tell<"uncertainties: the file has no <cov-mat>">());
        if (matrix)
            if (auto done = read_matrix(matrix); !done) return fail(done.error());
        proposals_.leave_out(0, tell<"residuals and orientations">());
        if (auto proposed = propose_points(std::move(list_), proposals_); !proposed)
            return fail(proposed.error());
        return std::move(proposals_);
    }

private:
    Result<void> read_point(const pugi::xml_node& node, bool adjusted) {
        if (local_name(node) != "point") return {};
        const std::string id = plain_name(text_of_child(node, "id"));
        const auto [found, added] = index_.try_emplace(id, list_.points.size());
        if (added && list_.points.size() == most_listed_points)
            return xml_.refused(node, tell<"too many points: divide the file">());
        if (added) list_.points.push_back({.line = xml_.line(node), .name = id, .p = {}});
        for (const pugi::xml_node& child : node.children()) {
            const std::string_view name = local_name(child);
            const std::size_t axis = name.size() == 1 ? std::string_view("xyzXYZ").find(name) % 3 : 3;
            if (name.size() != 1 || std::string_view("xyzXYZ").find(name) == std::string_view::npos) continue;
            const auto value = number_in_text(trimmed_text(child));
            if (!value)
                return xml_.refused(child,
                                    tell<"%1 = %2 is no number">(std::string(name),
                                                                 in_quotes(plain_name(trimmed_text(child)))));
            list_.points[found->second].p[axis] = *value;
            has_[id][axis] = true;
            if (adjusted) places_.push_back(3 * found->second + axis);
        }
        return {};
    }

    /// Reads the matrix in mm², coordinates first, then orientations of the directions.
    Result<void> read_matrix(const pugi::xml_node& node) {
        const auto dim = number_in_text(text_of_child(node, "dim")),
                   band = number_in_text(text_of_child(node, "band"));
        if (!dim || !band || !(*dim >= static_cast<double>(places_.size())) || !(*dim <= 1e5) ||
            !(*band >= 0.0) || !(*band < *dim))
            return xml_.refused(
                node, tell<"its dim must be at least the %1 adjusted coordinates, its band less than it">(
                          places_.size()));
        if (places_.size() > most_stated_quantities) {
            proposals_.leave_out(xml_.line(node), tell<"a covariance matrix of more than %1 coordinates">(
                                                      most_stated_quantities));
            return {};
        }
        const auto n = static_cast<Eigen::Index>(places_.size()), width = static_cast<Eigen::Index>(*band);
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
        pugi::xml_node element = child_called(node, "flt");
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = i; j <= std::min(static_cast<Eigen::Index>(*dim) - 1, i + width); ++j) {
                const auto value = number_in_text(trimmed_text(element));
                if (!value) return xml_.refused(node, tell<"element %1, %2 is no number">(i + 1, j + 1));
                if (j < n) covariance(i, j) = covariance(j, i) = *value;
                element = element.next_sibling("flt");
            }
        const auto taken = take_covariance(covariance);
        if (!taken) return xml_.refused(node, taken.error().message);
        for (std::size_t i = 0; i < places_.size(); ++i)
            list_.points[places_[i] / 3].u[places_[i] % 3] = taken->u[static_cast<Eigen::Index>(i)] * 1e-3;
        for (const StatedCorrelation& c : taken->correlations)
            list_.correlations.push_back({places_[c.first], places_[c.second], c.coefficient});
        return {};
    }

    const XmlText& xml_;
    Proposals proposals_;
    PointList list_;
    std::map<std::string, std::size_t> index_;
    std::map<std::string, std::array<bool, 3>> has_;  ///< coordinates that each point has
    /// Indices 3 * point + coordinate of adjusted ones, in the order of the file.
    std::vector<std::size_t> places_;
};

Recognition recognise_gama(std::string_view beginning, const std::string&) {
    return beginning.find("<gama-local") != std::string_view::npos ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_gama(const std::string& text, const ReadChoice& choice) {
    const auto xml = XmlText::parse(text);
    if (!xml) return fail(xml.error());
    if (local_name(xml->root()) == "gama-local-adjustment") return AdjustedGamaReader(*xml, choice).read();
    return GamaReader(*xml, choice).read();
}

}  // namespace

Reader gama_reader() {
    return {.name = "gama",
            .title = "GNU Gama network",
            .pattern = "*.gkf *.xml",
            .takes =
                "points, observed or adjusted coordinates with their covariance -> an artefact and its "
                "correlated figures; observations with theirs -> quantities of a measurement equation",
            .recognise = recognise_gama,
            .read = read_gama};
}

}  // namespace covaria
