// Contradictions of readings before anything is adjusted: readings that were repeated, distances there and
// back, rounds of one station, loops of height differences and of coordinate differences; those of faces,
// double targets and distances have files of their own.
#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <tuple>

#include "core/kinds/network/closure_sums.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

/// The difference between the points of a reading, above which instrument and target may stand where it is
/// one of heights.
double difference_of(const AdjustedReading& r) {
    const bool of_heights = r.kind == ReadingKind::height_difference || r.kind == ReadingKind::dz;
    return of_heights ? r.value + r.height_from - r.height_to : r.value;
}

/// What readings have in common that were made again: kind, points, round, heights, face.
using SameReading =
    std::tuple<ReadingKind, std::size_t, std::size_t, std::size_t, std::size_t, double, double, bool>;

SameReading key_of(const AdjustedReading& r) {
    const bool distance = r.kind == ReadingKind::slope_distance || r.kind == ReadingKind::horizontal_distance,
               back = distance && r.from > r.to;
    return {r.kind,
            back ? r.to : r.from,
            back ? r.from : r.to,
            distance ? 0 : r.second,
            r.round,
            back ? r.height_to : r.height_from,
            back ? r.height_from : r.height_to,
            r.face_two};
}

/// The first readings of all that were made again, found by a table of twice as many places: a network has
/// hardly any other, and a tree of them would take longer than its equations.
class FirstReadings {
public:
    explicit FirstReadings(const std::vector<AdjustedReading>& readings)
        : readings_(readings), table_(std::bit_ceil(2 * readings.size() + 1), none) {}

    /// The first of those that are the same as this one.
    std::size_t first_like(std::size_t reading) {
        const SameReading key = key_of(readings_[reading]);
        std::size_t at = 0;
        const auto mix = [&at](const auto& part) {
            at = (at ^ std::hash<std::decay_t<decltype(part)>>()(part)) * 0x9E3779B97F4A7C15U;
            at ^= at >> 29U;
        };
        std::apply([&](const auto&... parts) { (mix(parts), ...); }, key);
        for (;; ++at) {
            std::size_t& known = table_[at & (table_.size() - 1)];
            if (known == none) known = reading;
            if (known == reading || key_of(readings_[known]) == key) return known;
        }
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    const std::vector<AdjustedReading>& readings_;
    std::vector<std::size_t> table_;
};

class ClosureSearch {
public:
    explicit ClosureSearch(ClosureSums& sums) : network_(sums.network), sums_(sums) {}

    void find() {
        compare_repeated();
        compare_rounds();
        for (const auto& kinds : {std::vector{ReadingKind::height_difference, ReadingKind::dz},
                                  std::vector{ReadingKind::dx}, std::vector{ReadingKind::dy}})
            close_loops(kinds);
    }

private:
    /// Compares readings that were made again, or from the other end, each with the first.
    void compare_repeated() {
        FirstReadings firsts(network_.readings);
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& r = network_.readings[i];
            const bool distance =
                r.kind == ReadingKind::slope_distance || r.kind == ReadingKind::horizontal_distance;
            const bool loop = r.kind == ReadingKind::height_difference ||
                              (r.kind >= ReadingKind::dx && r.kind <= ReadingKind::dz);
            if (!is_read(r.kind) || is_in_frame(r.kind) || loop) continue;
            const bool back = distance && r.from > r.to;
            const std::size_t first = firsts.first_like(i);
            if (first == i) continue;
            const AdjustedReading& before = network_.readings[first];
            const double d = r.value - before.value;
            const Message words = words_of(network_, r);
            sums_.add(is_of_other_face(r, d)              ? tell<"%1, again, half a turn off (say that it is "
                                                                 "of face two)">(words)
                      : back != (before.from > before.to) ? tell<"%1, there and back">(words)
                                                          : tell<"%1, again">(words),
                      {{first, -1.0}, {i, 1.0}},
                      is_of_angle(r.kind) ? std::remainder(d, 2.0 * std::numbers::pi) : d);
        }
    }

    /// Whether a direction differs from one before by half a turn, as those of the two faces do.
    static bool is_of_other_face(const AdjustedReading& r, double difference) {
        constexpr double about = 0.02;  // rad
        return r.kind == ReadingKind::direction &&
               std::abs(std::remainder(difference - std::numbers::pi, 2.0 * std::numbers::pi)) < about;
    }

    /// The directions of a round, by target and face.
    using DirectionsOfRound = std::map<std::pair<std::size_t, bool>, std::size_t>;

    /// Compares rounds of a station by the angles from the first target that two of them have in common, to
    /// each of the others.
    void compare_rounds() {
        std::map<std::size_t, std::vector<DirectionsOfRound>> stations;
        std::vector<DirectionsOfRound> rounds(network_.rounds.size());
        std::vector<int> rounds_at(network_.points.size(), 0);
        for (const Round& round : network_.rounds) ++rounds_at[round.station];
        for (std::size_t i = 0; i < network_.readings.size(); ++i)
            if (const AdjustedReading& r = network_.readings[i];
                r.kind == ReadingKind::direction && rounds_at[r.from] > 1)
                rounds[r.round].try_emplace({r.to, r.face_two}, i);
        for (std::size_t k = 0; k < rounds.size(); ++k)
            stations[network_.rounds[k].station].push_back(std::move(rounds[k]));
        for (const auto& [station, own] : stations)
            for (std::size_t k = 1; k < own.size(); ++k) compare(own[0], own[k]);
    }

    void compare(const DirectionsOfRound& a, const DirectionsOfRound& b) {
        const std::size_t none = network_.readings.size();
        std::size_t first_a = none, first_b = none;
        for (const auto& [target, i] : a) {
            const auto there = b.find(target);
            if (there == b.end()) continue;
            const std::size_t k = there->second;
            if (first_a == none) {
                first_a = i, first_b = k;
                continue;
            }
            const auto value = [&](std::size_t reading) { return network_.readings[reading].value; };
            const AdjustedReading& r = network_.readings[k];
            const std::string &station = network_.points[r.from].name,
                              &from = network_.points[network_.readings[first_a].to].name;
            sums_.add(tell<"angle at %1 from %2 to %3, in two rounds">(station, from,
                                                                       network_.points[target.first].name),
                      {{first_a, 1.0}, {i, -1.0}, {first_b, -1.0}, {k, 1.0}},
                      std::remainder(value(k) - value(first_b) - value(i) + value(first_a),
                                     2.0 * std::numbers::pi));
        }
    }

    /// Closes a loop by each reading that is not of the tree of shortest ways.
    void close_loops(const std::vector<ReadingKind>& kinds) {
        std::vector<std::vector<std::size_t>> at(network_.points.size());
        std::vector<std::size_t> readings;
        for (std::size_t i = 0; i < network_.readings.size(); ++i)
            if (const AdjustedReading& r = network_.readings[i];
                std::ranges::find(kinds, r.kind) != kinds.end()) {
                at[r.from].push_back(i);
                at[r.to].push_back(i);
                readings.push_back(i);
            }
        const std::size_t none = network_.readings.size();
        std::vector<std::size_t> way(at.size(), none), depth(at.size(), none);
        for (std::size_t root = 0; root < at.size(); ++root) {
            if (at[root].empty() || depth[root] != none) continue;
            depth[root] = 0;
            for (std::deque<std::size_t> open{root}; !open.empty(); open.pop_front())
                for (const std::size_t i : at[open.front()]) {
                    const std::size_t next = other(i, open.front());
                    if (depth[next] != none) continue;
                    depth[next] = depth[open.front()] + 1;
                    way[next] = i;
                    open.push_back(next);
                }
        }
        for (const std::size_t i : readings)
            if (way[network_.readings[i].from] != i && way[network_.readings[i].to] != i)
                close(i, way, depth);
    }

    std::size_t other(std::size_t reading, std::size_t point) const {
        const AdjustedReading& r = network_.readings[reading];
        return r.from == point ? r.to : r.from;
    }

    /// Closes the loop from the target of the reading back to its station by the tree.
    void close(std::size_t reading, const std::vector<std::size_t>& way,
               const std::vector<std::size_t>& depth) {
        const AdjustedReading& r = network_.readings[reading];
        std::vector<SignedReading> signs;
        std::vector<std::size_t> forth{r.to}, back{r.from};
        double sum = difference_of(r);
        const auto go = [&](std::vector<std::size_t>& points, double sign) {
            const std::size_t i = way[points.back()], next = other(i, points.back());
            const double s = network_.readings[i].from == points.back() ? sign : -sign;
            signs.push_back({i, s});
            sum += s * difference_of(network_.readings[i]);
            points.push_back(next);
        };
        while (forth.back() != back.back())
            depth[forth.back()] >= depth[back.back()] ? go(forth, 1.0) : go(back, -1.0);
        signs.push_back({reading, 1.0});
        std::vector<std::size_t> points{r.from};
        points.insert(points.end(), forth.begin(), forth.end());
        points.insert(points.end(), back.rbegin() + 1, back.rend());
        sums_.add(loop_words(r.kind, points), signs, sum);
    }

    Message loop_words(ReadingKind kind, const std::vector<std::size_t>& points) const {
        constexpr std::size_t most_named = 8;
        std::string names;
        for (std::size_t i = 0; i < std::min(points.size(), most_named); ++i)
            names += (i > 0 ? " – " : "") + network_.points[points[i]].name;
        if (points.size() > most_named) names += " – …";
        switch (kind) {
            case ReadingKind::dx:
                return tell<"loop of differences of x, %1">(names);
            case ReadingKind::dy:
                return tell<"loop of differences of y, %1">(names);
            default:
                return tell<"loop of height differences, %1">(names);
        }
    }

    const AdjustedNetwork& network_;
    ClosureSums& sums_;
};

/// The rows as people count them: "3, 4, 17".
std::string rows_text(const Closure& closure) {
    constexpr std::size_t most_named = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(most_named, closure.rows.size()); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(closure.rows[i] + 1);
    return closure.rows.size() > most_named ? text + ", …" : text;
}

}  // namespace

double Closure::ratio() const {
    return std::abs(misclosure) / u;
}

std::vector<Closure> closures(const AdjustedNetwork& network) {
    ClosureSums sums(network);
    ClosureSearch(sums).find();
    compare_faces(sums);
    compare_double_targets(sums);
    close_distances(sums);
    return sums.take();
}

void check_closures(const AdjustedNetwork& network, Problems& problems) {
    constexpr std::size_t most_said = 3;
    std::size_t count = 0;
    const std::vector<Closure> all = closures(network);
    if (all.empty()) return;
    const double limit = adjustment::outlier_limit(all.size());
    for (const Closure& closure : all) {
        if (!(closure.ratio() > limit)) break;
        if (++count > most_said) continue;
        problems.warning(
            closure.source,
            tell<"before the adjustment: %1 closes with %2 %3, %4 times its u (rows %5 of the readings)">(
                closure.words,
                Message::number(format_significant(closure.unit.from_si(closure.misclosure), 3)),
                closure.unit.display(), Message::number(format_significant(closure.ratio(), 2)),
                rows_text(closure)));
    }
    if (count > most_said)
        problems.warning(adjustment_fields().place(&StatedAdjustment::readings),
                         tell<"and %1 more closures are beyond %2 times their u">(
                             count - most_said, Message::number(format_short(limit, 3))));
}

Table closures_table(const std::vector<Closure>& closures) {
    Table table{"closures", known_text<"Closures before the adjustment">()};
    table.add(known_text<"Closure">());
    table.add(known_text<"misclosure">()).figure(3);
    table.add(known_text<"u of the misclosure">()).figure(2);
    table.add(known_text<"misclosure over u">()).figure(3);
    table.add(known_text<"rows of the readings">());
    table.add(known_text<"remark">());
    std::size_t beyond = 0;
    const double limit = adjustment::outlier_limit(std::max<std::size_t>(1, closures.size()));
    for (const Closure& closure : closures) {
        const bool far = closure.ratio() > limit;
        beyond += far;
        table.row({closure.words, Quantity{closure.unit.from_si(closure.misclosure), closure.unit},
                   Quantity{closure.unit.from_si(closure.u), closure.unit}, closure.ratio(),
                   rows_text(closure), far ? tell<"too large?">() : Message()});
    }
    if (beyond > 0)
        table.notes.push_back(
            tell<"%1 closures are beyond %2 times their u (0.1 % for all of them together).">(
                beyond, Message::number(format_short(limit, 3))));
    return table;
}

}  // namespace covaria::network
