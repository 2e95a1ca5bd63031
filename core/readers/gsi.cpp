// Leica GSI files: coordinates become points, rounds of readings a station and its targets.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/gsi_network.h"
#include "core/readers/gsi_set_ups.h"
#include "core/readers/listed_points.h"
#include "core/readers/rounds.h"
#include "core/setup/message_text.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

constexpr const char* instrument_kind = "spherical-instrument";
constexpr const char* network_model = "points-from-sensors";
constexpr std::size_t most_set_ups = 20;
constexpr double half_turn = std::numbers::pi;
/// The standard deviations from which on readings are no repetitions: 3.4' and 0.1 m.
constexpr double largest_angle = 1e-3, largest_distance = 0.1;

Eigen::Vector3d point_of(const GsiSetUp& set_up, const MeanReading& mean) {
    const double across = mean.distance * std::sin(mean.zenith);
    return Eigen::Vector3d(
        set_up.position[0] + across * std::sin(mean.azimuth),
        set_up.position[1] + across * std::cos(mean.azimuth),
        set_up.position[2] + set_up.instrument_height + mean.distance * std::cos(mean.zenith));
}

class GsiProposals {
public:
    explicit GsiProposals(const ReadChoice& choice) : choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
        if (proposals_.title.empty()) proposals_.title = "GSI";
        source_ = "Leica GSI, " + plain_name(choice.file_name);
        if (choice.length_unit)
            proposals_.leave_out(0, tell<"the stated unit of lengths: words of GSI state theirs">());
    }

    Result<Proposals> make(const std::vector<GsiBlock>& blocks) {
        const GsiContent content = gsi_content(blocks);
        take_words(blocks);
        for (const GsiPoint& point : content.points)
            list_.points.push_back({.line = point.line, .name = point.name, .p = point.p});
        if (const GsiTies ties(content); ties.are_any())
            propose_network(content, ties);
        else
            propose_apart(content);
        if (proposals_.assets.empty() && proposals_.analyses.empty())
            return fail(ErrorCode::bad_input,
                        tell<"the file has neither coordinates nor readings with a distance">());
        return std::move(proposals_);
    }

private:
    void take_words(const std::vector<GsiBlock>& blocks) {
        std::map<int, std::pair<int, int>> others;  // first line and number of each other word
        for (const GsiBlock& block : blocks)
            for (const int index : block.others)
                ++others.try_emplace(index, std::pair{block.line, 0}).first->second.second;
        for (const auto& [index, lines] : others)
            proposals_.leave_out(lines.first, tell<"words %1 (%2)">(index, lines.second));
    }

    /// One network of the set-ups that are tied, then the points and the set-ups that are not in it.
    void propose_network(const GsiContent& content, const GsiTies& ties) {
        GsiNetwork network(content, ties, proposals_);
        network.propose(proposals_.title, source_);
        std::erase_if(list_.points, [&](const ListedPoint& point) { return network.holds(point.name); });
        GsiContent apart{.points = {}};
        for (std::size_t i = 0; i < content.set_ups.size(); ++i)
            if (!ties.is_tied(i)) apart.set_ups.push_back(content.set_ups[i]);
        propose_apart(apart);
    }

    /// Set-ups that no common points tie, each by itself.
    void propose_apart(const GsiContent& content) {
        std::size_t heights = 0;
        for (const GsiSetUp& set_up : content.set_ups)
            for (const GsiSight& sight : set_up.sights) {
                heights += sight.is_whole() && sight.target_height != 0.0;
                if (!sight.is_whole())
                    proposals_.leave_out(
                        sight.line,
                        tell<"the reading of %1: angles and a distance are needed">(in_quotes(sight.point)));
            }
        if (heights > 0)
            proposals_.found.push_back(
                tell<"%1 readings of reflectors above their points: the targets are the reflectors">(
                    heights));
        if (!list_.points.empty()) propose_list();
        for (const GsiSetUp& set_up : content.set_ups) propose_set_up(set_up);
    }

    void propose_list() {
        has_list_ = true;
        list_.title = proposals_.title;
        list_.unit = Unit::of("m");
        list_.source = source_;
        proposals_.found.push_back(tell<"coordinates E, N, H become x, y, z">());
        // The list is accepted, since it has points, which is all that it must have.
        static_cast<void>(propose_points(std::move(list_), proposals_));
    }

    void propose_set_up(const GsiSetUp& set_up) {
        const std::vector<PolarReading> readings = set_up.readings();
        if (readings.empty()) return;
        if (++number_ > most_set_ups)
            return proposals_.leave_out(
                readings.front().line,
                tell<"%1: more than %2 set-ups; divide the file">(in_quotes(set_up.title()), most_set_ups));
        const Rounds rounds = rounds_of(readings);
        if (!set_up.located)
            proposals_.found.push_back(
                tell<"%1: its coordinates are not in the file: 0, 0, 0">(in_quotes(set_up.title())));
        if (are_rounds(rounds)) return propose_rounds(set_up, rounds);
        if (has_list_)
            return proposals_.leave_out(
                readings.front().line,
                tell<"%1: readings of points that have coordinates">(in_quotes(set_up.title())));
        propose_readings_as_points(set_up);
    }

    /// Whether the readings are rounds: repeated readings of targets that are near to each other.
    static bool are_rounds(const Rounds& rounds) {
        const auto is_small = [](const PooledFigure& figure, double most) {
            return figure.degrees_of_freedom > 0 && figure.s > 0.0 && figure.s < most;
        };
        return is_small(rounds.azimuth, largest_angle) && is_small(rounds.zenith, largest_angle) &&
               is_small(rounds.distance, largest_distance);
    }

    void propose_readings_as_points(const GsiSetUp& set_up) {
        proposals_.found.push_back(tell<"%1: readings do not repeat, or are too far apart for it, and say "
                                        "nothing of their uncertainty: points">(in_quotes(set_up.title())));
        PointList points{
            .title = proposals_.title + ", " + set_up.title(), .unit = Unit::of("m"), .source = source_};
        for (const PolarReading& reading : set_up.readings()) {
            const MeanReading one = rounds_of({reading}).means.front();
            const Eigen::Vector3d p = point_of(set_up, one);
            points.points.push_back({.line = reading.line, .name = reading.point, .p = {p[0], p[1], p[2]}});
        }
        static_cast<void>(propose_points(std::move(points), proposals_));
    }

    void propose_rounds(const GsiSetUp& set_up, const Rounds& rounds) {
        const std::string id =
            id_of(set_up.title(), "station") + (number_ > 1 ? "-" + std::to_string(number_) : "");
        const double root = std::sqrt(static_cast<double>(rounds.fewest_rounds));
        const double arcsec = Unit::of("arcsec").to_si(1.0);
        const double u_azimuth = rounds.azimuth.s / root / arcsec, u_zenith = rounds.zenith.s / root / arcsec;
        const double u_distance = rounds.distance.s / root * 1e3;
        const auto nu = [](const auto& spread) {
            return " (nu = " + std::to_string(spread.degrees_of_freedom) + ")";
        };
        const std::string words = std::to_string(rounds.means.size()) + " targets, at least " +
                                  std::to_string(rounds.fewest_rounds) + " rounds" +
                                  (rounds.two_faces ? " in two faces" : "") + "; Type A of a mean: Hz " +
                                  format_short(u_azimuth, 2) + "\"" + nu(rounds.azimuth) + ", V " +
                                  format_short(u_zenith, 2) + "\"" + nu(rounds.zenith) + ", distance " +
                                  format_short(u_distance, 2) + " mm" + nu(rounds.distance) +
                                  "; collimation " + format_short(rounds.collimation / arcsec, 2) +
                                  "\", index " + format_short(rounds.index / arcsec, 2) + "\"";
        proposals_.found.push_back(in_quotes(set_up.title()) + ": " + words);
        AssetEntry instrument{.id = id, .kind = instrument_kind, .name = set_up.title()};
        instrument.notes =
            "From " + source_ + ". " + words +
            ". The zero of the circle is taken as +y (north): turn the station if it was not oriented. "
            "Scale, zero offset and the distance's part in proportion are not in the file.";
        PoseValue pose;
        pose.length_unit = Unit::of("m");
        for (std::size_t i = 0; i < 3; ++i) pose.position[i] = set_up.position[i];
        pose.position[2] += set_up.instrument_height;
        instrument.setup.values["station"] = pose;
        instrument.setup.values["kind"] = std::string("total-station");
        instrument.setup.values["distance_constant"] = Quantity{u_distance, Unit::of("mm")};
        instrument.setup.values["angle_azimuth"] = Quantity{u_azimuth, Unit::of("arcsec")};
        instrument.setup.values["angle_elevation"] = Quantity{u_zenith, Unit::of("arcsec")};
        instrument.setup.values["meaning"] = std::string("standard");
        proposals_.assets.push_back(std::move(instrument));
        propose_targets(set_up, rounds, id);
    }

    void propose_targets(const GsiSetUp& set_up, const Rounds& rounds, const std::string& id) {
        TableRows sensors(table_of(network_model, "sensors")), targets(table_of(network_model, "targets")),
            readings(table_of(network_model, "readings"));
        for (const char* axis : {"x", "y", "z"}) targets.set_unit(axis, Unit::of("m"));
        readings.set_unit("distance", Unit::of("m"));
        sensors.add({{"sensor", id}});
        for (const MeanReading& mean : rounds.means) {
            const Eigen::Vector3d p = point_of(set_up, mean);
            targets.add({{"name", mean.point}, {"x", p[0]}, {"y", p[1]}, {"z", p[2]}});
            // The reading Hz is clockwise from +y, the azimuth anticlockwise from +x.
            readings.add({{"target", mean.point},
                          {"sensor", id},
                          {"distance", mean.distance},
                          {"azimuth", std::remainder(0.5 * half_turn - mean.azimuth, 2.0 * half_turn)},
                          {"elevation", 0.5 * half_turn - mean.zenith}});
        }
        AnalysisEntry analysis{
            .id = "targets-" + id, .model = network_model, .name = "Targets from " + set_up.title()};
        analysis.notes = "From " + source_ + ": means of all rounds.";
        analysis.setup.values["sensors"] = sensors.table();
        analysis.setup.values["targets"] = targets.table();
        analysis.setup.values["evaluation"] = std::string("a-posteriori");
        analysis.setup.values["readings"] = readings.table();
        proposals_.analyses.push_back(std::move(analysis));
    }

    const ReadChoice& choice_;
    Proposals proposals_;
    std::string source_;
    PointList list_;
    std::size_t number_ = 0;
    bool has_list_ = false;
};

Recognition recognise_gsi(std::string_view beginning, const std::string&) {
    return is_gsi(beginning) ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_gsi_file(const std::string& text, const ReadChoice& choice) {
    const auto blocks = read_gsi(text);
    if (!blocks) return fail(blocks.error());
    return GsiProposals(choice).make(*blocks);
}

}  // namespace

Reader gsi_reader() {
    return {.name = "gsi",
            .title = "Leica GSI-8 and GSI-16",
            .pattern = "*.gsi",
            .takes =
                "readings of set-ups that see common points -> a network that is adjusted; rounds of one "
                "set-up -> an instrument with Type A figures and its targets; coordinates -> an artefact",
            .recognise = recognise_gsi,
            .read = read_gsi_file};
}

}  // namespace covaria
