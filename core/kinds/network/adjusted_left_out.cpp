// Readings and points that an adjustment leaves out, with the reasons: by hand, gross, outliers, told by no
// reading.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/kinds/network/adjusted_closures.h"
#include "core/kinds/network/adjusted_images.h"
#include "core/kinds/network/adjusted_space_start.h"
#include "core/kinds/network/seen_figures.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

bool is_lost_without(const StatedAdjustment::Reading& reading, const std::string& point, bool plane) {
    if (plane ? !needs_plane(reading.kind) : !needs_heights(reading.kind)) return false;
    const bool of_one = reading.kind == ReadingKind::x || reading.kind == ReadingKind::y ||
                        reading.kind == ReadingKind::z || is_in_frame(reading.kind);
    return reading.from == point || (!of_one && reading.to == point) ||
           (reading.kind == ReadingKind::angle && reading.second == point);
}

void leave_out(StatedAdjustment& stated, std::size_t row, Message why) {
    stated.readings[row].left_out = true;
    stated.readings[row].why_left_out = std::move(why);
}

/// Leaves out directions that are the only one of their round: such a round has an orientation of its own, so
/// they tell nothing.
void leave_lone_directions(StatedAdjustment& stated) {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> rounds;
    for (std::size_t row = 0; row < stated.readings.size(); ++row)
        if (const StatedAdjustment::Reading& r = stated.readings[row];
            !r.left_out && r.kind == ReadingKind::direction)
            rounds[{r.from, r.round}].push_back(row);
    for (const auto& [round, rows] : rounds)
        if (rows.size() == 1)
            leave_out(stated, rows.front(),
                      tell<"the only direction of its round, whose orientation is not "
                           "known">());
}

/// The deviation of a reading that was left out from the prediction of the others, over its standard
/// uncertainty.
double test_of(const StatedAdjustment& stated, const AdjustedNetwork& made, std::size_t row) {
    StatedAdjustment with = stated;
    with.readings[row].left_out = false;
    Problems unsaid;
    std::optional<AdjustedNetwork> other = adjusted_network(with, unsaid);
    constexpr double never = std::numeric_limits<double>::infinity();
    if (!other || other->state.size() != made.state.size()) return never;
    const auto reading =
        std::ranges::find_if(other->readings, [&](const AdjustedReading& r) { return r.row == row; });
    if (reading == other->readings.end()) return never;
    StateTerms terms;
    derivatives(made, *reading, made.state.data(), terms);
    Eigen::VectorXd a = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(made.place_of.size()));
    for (const StateTerm& term : terms)
        if (const std::size_t k = made.unknown_of[term.place]; k != AdjustedNetwork::known)
            a[static_cast<Eigen::Index>(k)] += term.coefficient;
    const double u2 = reading->u * reading->u + a.dot(made.adjusted->cofactors(a));
    return std::abs(residual_of(made, *reading, reading->value, made.state.data())) / std::sqrt(u2);
}

/// The squares of how far the open directions move each point in the plane, then each height.
std::vector<double> moved_by(const AdjustedNetwork& network) {
    const Eigen::MatrixXd& open = network.unsolved->open();
    const std::size_t n = network.points.size();
    std::vector<double> moved(2 * n, 0.0);
    for (std::size_t k = 0; k < network.place_of.size(); ++k) {
        const std::size_t place = network.place_of[k];
        const double size = open.row(static_cast<Eigen::Index>(k)).squaredNorm();
        if (place < 3 * n)
            moved[place / 3 + (place % 3 == 2 ? n : 0)] += size;
        else if (place < network.tilt(0, 0))
            moved[network.rounds[place - 3 * n].station] += size;
    }
    return moved;
}

/// Whether nothing was open where the search began; where something is open at its end, the search has gone
/// to a place at which the readings no longer determine the network.
bool was_determined(const AdjustedNetwork& begun) {
    return !begun.readings.empty() &&
           adjustment::Adjustment(design_of(begun, begun.state.data()), begun.whitening, begun.datum)
                   .open()
                   .cols() == 0;
}

/// Whether residuals are so large that readings contradict each other.
bool is_far_off(const AdjustedNetwork& network) {
    constexpr double times = 10.0;  // their u
    const Eigen::VectorXd r = network.whitening * residuals_of(network, network.state.data());
    return r.squaredNorm() > times * times * static_cast<double>(r.size());
}

/// Says what is open of points in a plane, where the search has no end next to it.
void say_hardly_told(AdjustedNetwork& network, Problems& problems) {
    AdjustedNetwork flat = network;
    if (!put_into_planes(flat)) return;
    Problems of_flat;
    adjust(flat, of_flat);
    if (!flat.unsolved) return;
    network = std::move(flat);
    problems = std::move(of_flat);
}

/// Adjusts from the beginning; where least squares do not lead to a place of every point, once more robustly,
/// then from places that approximate coordinates have no part in.
void adjust_from_start(AdjustedNetwork& network, bool robust, Problems& problems) {
    const Eigen::VectorXd start = network.state;
    if (robust) start_robustly(network);
    Problems own;
    adjust(network, own);
    const auto again_from = [&](const auto& begin) {
        if (!own.has_errors()) return;
        AdjustedNetwork again = network;
        again.state = start;
        again.adjusted = again.unsolved = nullptr;
        if (!begin(again)) return;
        Problems of_again;
        adjust(again, of_again);
        if (of_again.has_errors()) return;
        network = std::move(again);
        own = {};
    };
    if (!robust)
        again_from([](AdjustedNetwork& again) {
            start_robustly(again);
            return true;
        });
    again_from(lay_anew_in_space);
    if (!own.has_errors()) return take_stated_sides(network);
    if (!network.unsolved) say_hardly_told(network, own);
    problems.take(own, "");
}

bool is_gross(const AdjustedNetwork& network, const std::optional<double>& limit) {
    return limit && std::ranges::any_of(network.readings, [&](const AdjustedReading& r) {
               return r.row != AdjustedReading::no_round && std::abs(offset_of(network, r)) > *limit;
           });
}

Message contradiction(const AdjustedNetwork& made, std::size_t reading, const Message& size) {
    const Message alike = alike_words(made, reading);
    return alike.empty()
               ? tell<"it contradicts the others: %1">(size)
               : tell<"it contradicts the others: %1; it cannot be told apart from %2">(size, alike);
}

void propose_mistakes(const AdjustedNetwork& network, Problems& problems) {
    for (Message& words : likely_mistakes(network))
        problems.warning(adjustment_fields().place(&StatedAdjustment::readings), std::move(words));
}

/// Where the readings told every place at the beginning, those that contradict each other have led the
/// search to where they do not: what is open there is not what is wrong.
void say_astray(AdjustedNetwork& network, Problems& own, Problems& problems) {
    AdjustedNetwork begun = network;
    begun.state = begun.stated;
    if (network.unsolved && !(is_far_off(network) && was_determined(begun))) return;
    propose_mistakes(begun, problems);
    if (!network.unsolved) return;
    own = {};
    own.error(
        adjustment_fields().place(&StatedAdjustment::readings),
        tell<"the readings contradict each other so much that the search for the places of the points went "
             "astray: "
             "look for exchanged or mistyped readings, for a unit or the sense of angles that was mixed up, "
             "and for coordinates that are far off">());
}

class Selection {
public:
    Selection(StatedAdjustment stated, Problems& problems) : stated_(std::move(stated)), problems_(problems) {
        kept_.assign(stated_.readings.size(), 0);
    }

    std::optional<AdjustedNetwork> run() {
        if (stated_.leaves_undetermined) leave_lone_directions(stated_);
        const std::size_t most = 2 * stated_.readings.size() + stated_.points.size() + 3;
        for (std::size_t k = 0; k < most; ++k) {
            Problems own;
            again_ = false;
            std::optional<AdjustedNetwork> made = attempt(own);
            if (again_) continue;
            problems_.take(own, "");
            if (own.has_errors() || !made) return {};
            tell_left_out(*made);
            return made;
        }
        return {};
    }

private:
    std::optional<AdjustedNetwork> attempt(Problems& own) {
        std::optional<AdjustedNetwork> made = adjusted_network(stated_, own);
        if (!made) {
            again_ = take_back();
            return {};
        }
        if (!std::exchange(compared_, true)) check_closures(*made, problems_);
        if (const auto campaigns = campaigns_of(stated_); !campaigns.empty())
            take_seen_elsewhere(*made, campaigns, own);
        if (own.has_errors()) return {};
        find_start(*made, own);
        if (own.has_errors()) {
            again_ = take_back() || (stated_.leaves_undetermined && leave_unplaced(*made));
            return {};
        }
        AdjustedNetwork begun = stated_.gross_limit || stated_.robust ? *made : AdjustedNetwork();
        adjust_from_start(*made, stated_.robust, own);
        if (own.has_errors()) {
            again_ = take_back() || leave_undetermined(begun, *made) || leave_gross(begun);
            if (!again_) say_astray(*made, own, problems_);
            return {};
        }
        again_ = (is_gross(*made, stated_.gross_limit) && leave_gross(begun)) || leave_outliers(begun, *made);
        return made;
    }

    void leave_point(const AdjustedNetwork& network, std::size_t p, bool plane) {
        StatedAdjustment::Point& point = stated_.points[network.points[p].row];
        (plane ? point.plane : point.height) = CoordinateRole::none;
        const Message why = tell<"nothing tells them">(),
                      what = plane ? tell<"x and y of %1">(point.name) : tell<"the height of %1">(point.name);
        points_.push_back({what, plane ? why : tell<"nothing tells it">(),
                           adjustment_fields().place(&StatedAdjustment::points, network.points[p].row)});
        for (std::size_t row = 0; row < stated_.readings.size(); ++row)
            if (const StatedAdjustment::Reading& r = stated_.readings[row];
                !r.left_out && is_lost_without(r, point.name, plane))
                leave_out(stated_, row,
                          plane ? tell<"its point %1 is left out">(point.name)
                                : tell<"the height of %1 is left out">(point.name));
        leave_lone_directions(stated_);
    }

    bool leave_unplaced(const AdjustedNetwork& network) {
        for (const std::size_t p : network.unplaced) leave_point(network, p, true);
        return !network.unplaced.empty();
    }

    /// Leaves out the point that the open directions move most, if they are not of the network as a whole.
    bool leave_undetermined(const AdjustedNetwork& begun, const AdjustedNetwork& network) {
        if (!stated_.leaves_undetermined || !network.unsolved || was_determined(begun)) return false;
        const std::size_t n = network.points.size();
        const std::vector<double> moved = moved_by(network);
        const auto worst = std::ranges::max_element(moved);
        if (worst == moved.end() || !(*worst > 0.0)) return false;
        const auto part = static_cast<std::size_t>(worst - moved.begin());
        const std::size_t first = part < n ? 0 : n;
        std::size_t found = 0, moving = 0;
        for (std::size_t p = 0; p < n; ++p) {
            if (!network.points[p].is_found(first == 0 ? 0 : 2)) continue;
            ++found;
            moving += moved[first + p] > 1e-3 * *worst;
        }
        if (found > 1 && 2 * moving > found + 1) return false;
        leave_point(network, part % n, first == 0);
        return true;
    }

    /// Leaves out readings that miss by more than the limit. Approximate coordinates may be bad, so they are
    /// compared with where a robust adjustment leads from them.
    bool leave_gross(AdjustedNetwork begun) {
        if (!stated_.gross_limit || begun.readings.empty()) return false;
        start_robustly(begun);
        bool any = false;
        for (const AdjustedReading& r : begun.readings) {
            if (r.row == AdjustedReading::no_round) continue;
            const double offset = std::abs(offset_of(begun, r));
            if (!(offset > *stated_.gross_limit)) continue;
            leave_out(stated_, r.row,
                      tell<"it misses what the others agree on by %1 m, more than %2 m">(
                          Message::number(format_significant(offset, 3)),
                          Message::number(format_short(*stated_.gross_limit, 6))));
            any = true;
        }
        if (any && stated_.leaves_undetermined) leave_lone_directions(stated_);
        return any;
    }

    /// Leaves out outliers: first all readings that a robust adjustment contradicts, then the largest one
    /// after the other; at last those that agree after all come back.
    bool leave_outliers(const AdjustedNetwork& begun, const AdjustedNetwork& made) {
        if (!stated_.robust) return false;
        if (!began_) {
            began_ = true;
            if (leave_contradicting(begun, made)) return true;
        }
        const adjustment::Reliability found = reliability_of(made);
        std::size_t worst = made.readings.size();
        for (std::size_t i = 0; i < made.readings.size(); ++i)
            if (const std::size_t row = made.readings[i].row;
                row != AdjustedReading::no_round && !kept_[row] && found.readings[i].controlled &&
                std::abs(found.readings[i].w) > adjustment::outlier_limit() &&
                (worst == made.readings.size() ||
                 std::abs(found.readings[i].w) > std::abs(found.readings[worst].w)))
                worst = i;
        if (worst == made.readings.size()) return bring_back(made);
        last_ = {made.readings[worst].row};
        leave_out(
            stated_, last_[0],
            contradiction(
                made, worst,
                tell<"|w| = %1">(Message::number(format_significant(std::abs(found.readings[worst].w), 3)))));
        return true;
    }

    bool leave_contradicting(AdjustedNetwork begun, const AdjustedNetwork& made) {
        start_robustly(begun);
        const Eigen::VectorXd residuals = begun.whitening * residuals_of(begun, begun.state.data());
        last_.clear();
        for (std::size_t i = 0; i < begun.readings.size(); ++i) {
            const double size = std::abs(residuals[static_cast<Eigen::Index>(i)]);
            const std::size_t row = begun.readings[i].row;
            if (row == AdjustedReading::no_round || !(size > 2.0 * adjustment::outlier_limit())) continue;
            leave_out(stated_, row,
                      contradiction(made, i,
                                    tell<"%1 times its u in a robust adjustment">(
                                        Message::number(format_significant(size, 3)))));
            last_.push_back(row);
        }
        return !last_.empty();
    }

    /// Takes back the readings left out last, because the network needs them; they stay from then on.
    bool take_back() {
        for (const std::size_t row : last_) {
            stated_.readings[row].left_out = false;
            kept_[row] = 1;
        }
        return !std::exchange(last_, {}).empty();
    }

    bool bring_back(const AdjustedNetwork& made) {
        last_.clear();
        double best = adjustment::outlier_limit();
        std::size_t brought = stated_.readings.size();
        for (std::size_t row = 0; row < stated_.readings.size(); ++row) {
            if (!stated_.readings[row].left_out || stated_.readings[row].why_left_out.empty()) continue;
            if (const double test = test_of(stated_, made, row); test < best) {
                best = test;
                brought = row;
            }
        }
        if (brought == stated_.readings.size()) return false;
        stated_.readings[brought].left_out = false;
        kept_[brought] = 1;
        return true;
    }

    void tell_left_out(AdjustedNetwork& made) {
        made.left_out.insert(made.left_out.begin(), points_.begin(), points_.end());
        constexpr std::size_t most_said = 5;
        std::size_t count = 0;
        for (const LeftOut& out : made.left_out) {
            if (out.why == tell<"by hand">() || ++count > most_said) continue;
            problems_.warning(out.source, tell<"%1 is left out: %2">(out.what, out.why));
        }
        if (count > most_said)
            problems_.warning(adjustment_fields().place(&StatedAdjustment::readings),
                              tell<"and %1 more are left out, listed with their reasons">(count - most_said));
    }

    StatedAdjustment stated_;
    Problems& problems_;
    std::vector<LeftOut> points_;
    std::vector<char> kept_;         ///< whether each reading came back
    std::vector<std::size_t> last_;  ///< readings that were left out in the last round
    bool again_ = false, began_ = false, compared_ = false;
};

}  // namespace

Message alike_words(const AdjustedNetwork& network, std::size_t reading) {
    constexpr double alike = 0.98;
    constexpr std::size_t most_named = 3;
    const adjustment::SparseRows& A = network.adjusted->whitened();
    const auto i = static_cast<Eigen::Index>(reading);
    const Eigen::VectorXd row = A.row(i).transpose();
    const Eigen::VectorXd c = A * network.adjusted->step(row);
    const double own = 1.0 - c[i];
    Message names;
    std::size_t count = 0;
    for (Eigen::Index j = 0; j < A.rows(); ++j) {
        if (j == i || count == most_named || std::abs(c[j]) < 1e-9) continue;
        const auto k = static_cast<std::size_t>(j);
        const double other = 1.0 - network.adjusted->cofactor_of_readings(k, k);
        if (!(c[j] * c[j] > alike * alike * own * other) || !(other > 1e-6)) continue;
        const Message words = words_of(network, network.readings[k]);
        names = names.empty() ? words : tell<"%1, %2">(names, words);
        ++count;
    }
    return names;
}

std::optional<AdjustedNetwork> adjust_stated(StatedAdjustment stated, Problems& problems) {
    stated.take_elevations();
    return Selection(std::move(stated), problems).run();
}

}  // namespace covaria::network
