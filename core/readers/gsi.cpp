// Leica GSI files: coordinates become points, rounds of readings a station and its targets.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/gsi_text.h"
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

/// Readings while the instrument stood at one place.
struct SetUp {
    std::string station = {};
    std::array<double, 3> position{};  ///< position of the ground point, m
    double instrument_height = 0.0;
    bool located = false;
    std::vector<PolarReading> readings = {};
};

Eigen::Vector3d point_of(const SetUp& set_up, const MeanReading& mean) {
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
        for (const GsiBlock& block : blocks) add(block);
        for (const auto& [index, lines] : others_)
            proposals_.leave_out(lines.first, tell<"words %1 (%2)">(index, lines.second));
        if (heights_ > 0)
            proposals_.found.push_back(
                tell<"%1 readings of reflectors above their points: the targets are the reflectors">(
                    heights_));
        if (!list_.points.empty()) propose_list();
        for (const SetUp& set_up : set_ups_) propose_set_up(set_up);
        if (proposals_.assets.empty())
            return fail(ErrorCode::bad_input,
                        tell<"the file has neither coordinates nor readings with a distance">());
        return std::move(proposals_);
    }

private:
    void add(const GsiBlock& block) {
        for (const int index : block.others) {
            auto& lines = others_.try_emplace(index, std::pair{block.line, 0}).first->second;
            ++lines.second;
        }
        if (block.station[0] && block.station[1]) return begin_set_up(block);
        if (block.target[0] && block.target[1] && block.target[2])
            list_.points.push_back({.line = block.line,
                                    .name = block.point,
                                    .p = {*block.target[0], *block.target[1], *block.target[2]}});
        if (!block.azimuth && !block.zenith && !block.distance) return;
        if (!block.azimuth || !block.zenith || !block.distance)
            return proposals_.leave_out(
                block.line,
                tell<"the reading of %1: angles and a distance are needed">(in_quotes(block.point)));
        if (set_ups_.empty()) set_ups_.push_back({.station = "station", .readings = {}});
        if (block.target_height && *block.target_height != 0.0) ++heights_;
        SetUp& set_up = set_ups_.back();
        if (set_up.readings.empty() && block.instrument_height && set_up.instrument_height == 0.0)
            set_up.instrument_height = *block.instrument_height;
        set_up.readings.push_back({block.line, block.point, *block.azimuth, *block.zenith, *block.distance});
    }

    void begin_set_up(const GsiBlock& block) {
        SetUp set_up{.station = block.point.empty() ? "station" : "station " + block.point, .readings = {}};
        for (std::size_t i = 0; i < 3; ++i) set_up.position[i] = block.station[i].value_or(0.0);
        set_up.instrument_height = block.instrument_height.value_or(0.0);
        set_up.located = true;
        set_ups_.push_back(std::move(set_up));
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

    void propose_set_up(const SetUp& set_up) {
        if (set_up.readings.empty()) return;
        if (++number_ > most_set_ups)
            return proposals_.leave_out(
                set_up.readings.front().line,
                tell<"%1: more than %2 set-ups; divide the file">(in_quotes(set_up.station), most_set_ups));
        const Rounds rounds = rounds_of(set_up.readings);
        if (!set_up.located)
            proposals_.found.push_back(
                tell<"%1: its coordinates are not in the file: 0, 0, 0">(in_quotes(set_up.station)));
        if (are_rounds(rounds)) return propose_rounds(set_up, rounds);
        if (has_list_)
            return proposals_.leave_out(
                set_up.readings.front().line,
                tell<"%1: readings of points that have coordinates">(in_quotes(set_up.station)));
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

    void propose_readings_as_points(const SetUp& set_up) {
        proposals_.found.push_back(tell<"%1: readings do not repeat, or are too far apart for it, and say "
                                        "nothing of their uncertainty: points">(in_quotes(set_up.station)));
        PointList points{
            .title = proposals_.title + ", " + set_up.station, .unit = Unit::of("m"), .source = source_};
        for (const PolarReading& reading : set_up.readings) {
            const MeanReading one = rounds_of({reading}).means.front();
            const Eigen::Vector3d p = point_of(set_up, one);
            points.points.push_back({.line = reading.line, .name = reading.point, .p = {p[0], p[1], p[2]}});
        }
        static_cast<void>(propose_points(std::move(points), proposals_));
    }

    void propose_rounds(const SetUp& set_up, const Rounds& rounds) {
        const std::string id =
            id_of(set_up.station, "station") + (number_ > 1 ? "-" + std::to_string(number_) : "");
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
        proposals_.found.push_back(in_quotes(set_up.station) + ": " + words);
        AssetEntry instrument{.id = id, .kind = instrument_kind, .name = set_up.station};
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
        propose_network(set_up, rounds, id);
    }

    void propose_network(const SetUp& set_up, const Rounds& rounds, const std::string& id) {
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
            .id = "targets-" + id, .model = network_model, .name = "Targets from " + set_up.station};
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
    std::vector<SetUp> set_ups_;
    std::map<int, std::pair<int, int>> others_;  ///< first line and number of each other word
    std::size_t heights_ = 0, number_ = 0;
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
                "coordinates -> an artefact; rounds of readings -> an instrument with Type A figures and its "
                "targets",
            .recognise = recognise_gsi,
            .read = read_gsi_file};
}

}  // namespace covaria
