// Where the search begins, the fit, and what it warns of.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/kinds/robot_identification/from_readings.h"
#include "core/kinds/robot_identification/input_sensitivity.h"
#include "core/math/decompositions.h"
#include "core/text/numbers.h"

namespace covaria::reading_identification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct RowRange {
    std::size_t first, last;
    std::size_t count() const { return last - first; }
};
RowRange fitted(const Identification& id) {
    return {0, id.fitted_rows};
}
RowRange held_back(const Identification& id) {
    return {id.fitted_rows, id.rows.size()};
}

VectorXd residuals_of(const Identification& id, const std::vector<double>& v, RowRange range) {
    const std::vector<double> x = identification::estimates_of(id.inputs);
    Scene<double> scene;
    scene_of<double>(id, v, x, scene);
    VectorXd r(static_cast<Index>(range.count()));
    residuals<double>(id, range.first, range.last, scene, x,
                      [&](std::size_t row, double value) { r[static_cast<Index>(row)] = value; });
    return r;
}

MatrixXd jacobian_of(const Identification& id, const std::vector<double>& v, RowRange range) {
    const std::vector<double> x = identification::estimates_of(id.inputs);
    Scene<Dual> scene;
    return identification::jacobian_of(v, range.count(), [&](const auto& at, const auto& set) {
        scene_of<Dual>(id, at, x, scene);
        residuals<Dual>(id, range.first, range.last, scene, x, set);
    });
}

identification::FitFunctions functions_of(const Identification& id) {
    return {[&id](const std::vector<double>& v) { return residuals_of(id, v, fitted(id)); },
            [&id](const std::vector<double>& v) { return jacobian_of(id, v, fitted(id)); }};
}

/// Base, places and targets take over what was found, so that rotations and tilts are small again.
void absorb(Identification& id, std::vector<double>& v) {
    Eigen::Vector3d turned = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> planes(id.fixed_places.size(), Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Unknown& u = id.unknowns[i];
        const auto k = static_cast<Index>(u.coordinate);
        if (u.kind == UnknownKind::base && k >= 3) {
            turned[k - 3] = std::exchange(v[i], 0.0);
        } else if (u.kind == UnknownKind::base) {
            id.X_MB.translation()[k] = v[i];
        } else if (u.kind == UnknownKind::target) {
            id.arm_targets[u.of].p_F[k] = v[i];
        } else if (u.kind == UnknownKind::place && id.fixed_places[u.of].plane) {
            planes[u.of][k] = std::exchange(v[i], 0.0);
        } else if (u.kind == UnknownKind::place) {
            id.fixed_places[u.of].p[k] = v[i];
        }
    }
    id.X_MB.linear() = (id.X_MB.linear() * rotation_from_zyx<double>(turned)).eval();
    for (std::size_t k = 0; k < planes.size(); ++k) {
        Place& place = id.fixed_places[k];
        if (!place.plane || planes[k].isZero(0.0)) continue;
        Eigen::Vector3d point, normal;
        put_plane<double>(place, planes[k], point, normal);
        place.p = point;
        const Eigen::Vector3d along =
            (place.axes.col(0) - normal * normal.dot(place.axes.col(0))).normalized();
        place.axes << along, normal.cross(along), normal;
    }
}

Message rows_in_words(const Identification& id, const std::vector<std::size_t>& rows) {
    constexpr std::size_t most_named = 3;
    Message words;
    for (std::size_t k = 0; k < rows.size() && k < most_named; ++k) {
        const Message& row = id.rows[rows[k]].name;
        words = words.empty() ? row : tell<"%1; %2">(words, row);
    }
    if (rows.size() > most_named) words = tell<"%1 and %2 more">(words, rows.size() - most_named);
    return words;
}

void warn_of_outlier(const Identification& id, Problems& problems) {
    const auto& s = id.statistics;
    const Row& row = id.rows[static_cast<std::size_t>(s.worst_row())];
    Message words = tell<
        "%1: the residual is %2 times its standard uncertainty (limit %3). Look at this reading first; "
        "hold it back by use = check">(row.name, Message::number(format_short(s.worst_size())),
                                       Message::number(format_short(s.limit)));
    if (!s.alike.empty())
        words =
            tell<"%1. An error of it cannot be told apart from one of %2">(words, rows_in_words(id, s.alike));
    problems.add({.severity = Severity::warning,
                  .path = row.source,
                  .message = std::move(words),
                  .remedies = {{tell<"hold it back">(), {{row.source + "/use", "check"}}}}});
}

void warn(const Identification& id, Problems& problems) {
    const auto& s = id.statistics;
    const double condition = condition_of(s);
    if (condition >= identification::most_condition)
        problems.warning(
            fields().place(&Identification::stated_poses),
            tell<"these poses hardly tell %1 apart (condition %2): turn more joints further, or "
                 "hold one of them">(least_told(s, id.names()), Message::number(format_short(condition, 2))));
    if (id.simulated) return;
    if (s.has_outlier()) warn_of_outlier(id, problems);
    if (!s.scatters_too_much()) return;
    Problem problem{
        .severity = Severity::warning,
        .path = id.rows.front().source.substr(0, id.rows.front().source.find('/', 1)),
        .message = tell<
            "the residuals are %1 times as large as the uncertainties of the readings explain: there is "
            "more than these (a joint's elasticity, temperature, an outlier), and the uncertainty of the "
            "parameters is stated too small">(Message::number(format_short(s.scatter)))};
    if (id.uncertainties == evidence::UncertaintiesFrom::stated && s.evidence.readings)
        problem.remedies = {remedy_as_seen(fields().place(&Identification::uncertainties))};
    problems.add(std::move(problem));
}

/// Residuals of a range of rows by components, the unknowns as they are.
MatrixXd residual_sensitivity(const Identification& id, RowRange range) {
    return scaled_sensitivity(id.inputs, range.count(), [&](const EstimatedInputs& x, const auto& set) {
        Scene<Dual> scene;
        scene_of<Dual>(id, id.solution, x, scene);
        residuals<Dual>(id, range.first, range.last, scene, x, set);
    });
}

/// Without the scale that distances share, which no weight can lessen.
double own_uncertainty(const Identification& id, const Row& row) {
    if (row.kind != RowKind::from_point && row.kind != RowKind::from_plane &&
        row.kind != RowKind::between_poses)
        return standard_uncertainty_of(id.inputs, row.input);
    const std::size_t own = id.inputs.quantities[row.input].shares.front().component;
    return id.inputs.components[own].distribution.standard_uncertainty();
}

struct Weights {
    VectorXd w;          ///< of the rows of the fit
    bool exact = false;  ///< no reading has an uncertainty: all are alike
};

/// Readings that are exact among others that are not have a thousand times the weight of the best of these.
Weights weights_of(const Identification& id) {
    Weights weights{VectorXd(static_cast<Index>(id.fitted_rows))};
    double least = infinity;
    for (std::size_t i = 0; i < id.fitted_rows; ++i)
        if (const double u = own_uncertainty(id, id.rows[i]); u > 0.0) least = std::min(least, u);
    weights.exact = !(least < infinity);
    for (std::size_t i = 0; i < id.fitted_rows; ++i) {
        const double u = own_uncertainty(id, id.rows[i]);
        weights.w[static_cast<Index>(i)] = weights.exact ? 1.0 : u > 0.0 ? 1.0 / u : 1e3 / least;
    }
    return weights;
}

/// Relative standard uncertainty of the size of the arm: of all its lengths together, while targets and
/// surroundings follow as they can. A factor changes a reading by what is read, not by what an arm that
/// is only about right lets expect: the residuals count as well. `v`: values of the unknowns.
double scale_uncertainty(const Identification& id, const Weights& weights, const std::vector<double>& v) {
    const MatrixXd A = weights.w.asDiagonal() * jacobian_of(id, v, fitted(id));
    VectorXd moved = weights.w.cwiseProduct(residuals_of(id, v, fitted(id)));
    double by_single_lengths = 0.0;
    MatrixXd others(A.rows(), 0);
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Unknown& u = id.unknowns[i];
        const auto column = static_cast<Index>(i);
        if (u.kind == UnknownKind::parameter && is_length(u.parameter)) {
            moved += A.col(column) * v[i];
            by_single_lengths = std::hypot(by_single_lengths, A.col(column).norm() * v[i]);
        }
        if (u.kind == UnknownKind::parameter || u.kind == UnknownKind::compliance) continue;
        if (!(A.col(column).norm() > 0.0)) continue;
        others.conservativeResize(Eigen::NoChange, others.cols() + 1);
        others.rightCols<1>() = A.col(column).normalized();
    }
    if (!(by_single_lengths > 0.0)) return 0.0;
    VectorXd rest = moved;
    if (others.cols() > 0) rest -= others * others.completeOrthogonalDecomposition().solve(moved);
    // Exact readings are taken to be good to a hundred thousandth of the lengths.
    return (weights.exact ? 1e-5 * by_single_lengths : 1.0) / rest.norm();
}

class FitToReadings {
public:
    FitToReadings(Identification& id, Problems& problems) : id_(id), problems_(problems) {}

    bool run() {
        weights_ = weights_of(id_);
        if (!id_.simulated) find_start(id_);
        // The surroundings follow the nominal arm first: what the rows can tell is judged where they are.
        Identification nominal = id_;
        std::erase_if(nominal.unknowns, [](const Unknown& u) {
            return u.kind == UnknownKind::parameter || u.kind == UnknownKind::compliance;
        });
        settle(nominal);
        id_.X_MB = nominal.X_MB;
        id_.fixed_places = nominal.fixed_places;
        id_.arm_targets = nominal.arm_targets;
        candidates_ = id_.unknowns;
        held_by_definition_ = id_.held;
        give_the_scale(values_of(id_));
        std::vector<double> v = values_of(id_);
        if (!choose_and_search(nominal, v)) return false;
        // Where the nominal arm misses the planes by what it is off, only the solution shows it.
        if (give_the_scale(v) && !choose_and_search(nominal, v)) return false;
        absorb(id_, v);
        id_.solution = v;
        const MatrixXd design = jacobian_of(id_, v, fitted(id_));
        const auto gain = identification::gain_of(weights_.w.asDiagonal() * design, weights_.w);
        if (!gain)
            return refuse(tell<"at the solution the unknowns cannot be told apart; hold one of those that "
                               "the table of observability names">());
        id_.gain = gain->gain;
        find_statistics(*gain, design, nominal);
        warn(id_, problems_);
        return true;
    }

private:
    /// What the rows can tell is chosen at the nominal arm, and again where that leads.
    bool choose_and_search(const Identification& nominal, std::vector<double>& v) {
        constexpr int most_choices = 4;
        std::vector<double> at = start(nominal, candidates_);
        for (int choice = 0; choice < most_choices; ++choice) {
            const auto told = choose(at);
            if (choice > 0 && told == told_) break;
            told_ = told;
            if (!search(at, v)) return false;
            for (std::size_t i = 0; i < told_.size(); ++i) at[told_[i]] = v[i];
        }
        take_told(at, v);
        return true;
    }

    /// `at`: values of all candidates.
    std::vector<std::size_t> choose(const std::vector<double>& at) {
        id_.unknowns = candidates_;
        const MatrixXd A = weights_.w.asDiagonal() * jacobian_of(id_, at, fitted(id_));
        auto [told, held] = identification::told_apart(A, id_.names(), tell<"changes no reading">());
        id_.held = held_by_definition_;
        id_.held.insert(id_.held.end(), held.begin(), held.end());
        return told;
    }

    void take_told(const std::vector<double>& at, std::vector<double>& v) {
        id_.unknowns.clear();
        v.clear();
        for (const std::size_t i : told_) {
            id_.unknowns.push_back(candidates_[i]);
            v.push_back(at[i]);
        }
        for (std::size_t i = 0; i < candidates_.size(); ++i)
            if (!std::ranges::binary_search(told_, i)) put_as_stated(candidates_[i]);
    }

    bool search(const std::vector<double>& at, std::vector<double>& v) {
        take_told(at, v);
        if (!id_.has_kind(UnknownKind::parameter) && !id_.has_kind(UnknownKind::compliance))
            return refuse(
                tell<"no parameter of the arm can be told from these readings: every one of them is "
                     "coupled with others or held">());
        if (id_.fitted_rows <= id_.unknowns.size())
            return refuse(
                tell<"the fit has %1 readings, no more than there are unknowns to find (%2): measure "
                     "more, or hold parameters">(id_.fitted_rows, id_.unknowns.size()));
        return minimise(functions_of(id_), weights_.w, v) ||
               refuse(tell<
                      "the fit does not converge: look for exchanged poses, readings of the wrong sign or in "
                      "another unit, a base far from where the robot says it stands, and for a nominal robot "
                      "that is another arm">());
    }

    /// An unknown that is held has the value that the set-up states, and not the one at which the search
    /// began.
    void put_as_stated(const Unknown& u) {
        const auto k = static_cast<Index>(u.coordinate);
        if (u.kind == UnknownKind::target) id_.arm_targets[u.of].p_F[k] = id_.targets[u.of].p[k];
        if (u.kind == UnknownKind::base && k < 3)
            id_.X_MB.translation()[k] = id_.robot().X_WB().translation()[k];
        if (u.kind != UnknownKind::place || id_.fixed_places[u.of].plane) return;
        if (const auto& stated = id_.places[u.of].p[u.coordinate]) id_.fixed_places[u.of].p[k] = *stated;
    }

    bool refuse(const Message& message) {
        problems_.error(fields().place(&Identification::stated_poses), message);
        return false;
    }

    /// Where the readings hardly tell the size of the arm, its longest length takes part with its nominal
    /// value and the uncertainty that the robot states of it. A robot that states none has it held where
    /// nothing else is left: a short one, held at a value that is only about right, would let the arm be of
    /// any size.
    bool give_the_scale(const std::vector<double>& v) {
        constexpr double hardly = 1e-3, not_at_all = 0.05;
        const double u = id_.scale_note.empty() ? scale_uncertainty(id_, weights_, v) : 0.0;
        if (u < hardly) return false;
        const auto length_of = [&](const Unknown& unknown) {
            return unknown.kind == UnknownKind::parameter && is_length(unknown.parameter)
                       ? std::abs(id_.robot().joints()[unknown.of].values[unknown.parameter])
                       : 0.0;
        };
        const auto longest = std::ranges::max_element(candidates_, {}, length_of);
        if (longest == candidates_.end() || !(length_of(*longest) > 0.0)) return false;
        const Message name = id_.name_of(*longest);
        if (add_nominal(id_, *longest)) {
            weights_ = weights_of(id_);
            id_.scale_note = tell<
                "The readings hardly tell the scale: all lengths may be larger by one factor. "
                "%1 takes part with its nominal value, as uncertain as the nominal robot "
                "states">(name);
        } else {
            if (u < not_at_all) return false;
            held_by_definition_.push_back(
                {name,
                 tell<"gives the scale, which the readings do not tell: all lengths of the arm may be larger "
                      "by one factor">()});
            id_.scale_note = tell<
                "The readings do not tell the scale: all lengths may be larger by one factor. %1 "
                "is held at its nominal value, of which the nominal robot states no uncertainty: "
                "the other lengths are no more certain than it is">(name);
            candidates_.erase(longest);
        }
        problems_.warning(
            fields().place(&Identification::distances),
            tell<"%1. A length that is known gives the scale: distances between poses, or from several "
                 "known points">(id_.scale_note));
        id_.unknowns = candidates_;
        return true;
    }

    /// Finds the surroundings with the nominal arm; where that fails they stay where they began.
    void settle(Identification& nominal) {
        const MatrixXd A =
            weights_.w.asDiagonal() * jacobian_of(nominal, values_of(nominal), fitted(nominal));
        const auto told = identification::told_apart(A, nominal.names(), {}).unknowns;
        std::vector<Unknown> unknowns;
        for (const std::size_t i : told) unknowns.push_back(nominal.unknowns[i]);
        nominal.unknowns = std::move(unknowns);
        std::vector<double> v = values_of(nominal);
        std::vector<double> found = v;
        if (minimise(functions_of(nominal), weights_.w, found)) v = std::move(found);
        absorb(nominal, v);
        nominal.solution = v;
    }

    /// Values of the candidates; zeros begin where the nominal arm has them.
    std::vector<double> start(const Identification& nominal, const std::vector<Unknown>& candidates) {
        id_.unknowns = candidates;
        std::vector<double> v = values_of(id_);
        for (std::size_t i = 0; i < v.size(); ++i)
            for (std::size_t k = 0; k < nominal.unknowns.size(); ++k)
                if (candidates[i].kind == UnknownKind::zero &&
                    nominal.unknowns[k].kind == UnknownKind::zero &&
                    candidates[i].of == nominal.unknowns[k].of)
                    v[i] = nominal.solution[k];
        return v;
    }

    void find_statistics(const identification::Gain& gain, const MatrixXd& design,
                         const Identification& nominal) {
        const MatrixXd from_inputs = residual_sensitivity(id_, fitted(id_));
        take_statistics(id_.statistics, gain, residuals_of(id_, id_.solution, fitted(id_)), design,
                        from_inputs, weights_.w, identification::TestBy::covariance);
        id_.inverse_u = identification::inverse_uncertainties(id_.statistics.covariance);
        if (!id_.simulated) find_evidence(id_, design, from_inputs);
        const RowRange checks = held_back(id_);
        if (checks.count() == 0) return;
        const MatrixXd D = jacobian_of(id_, id_.solution, checks) * (id_.gain * from_inputs) -
                           residual_sensitivity(id_, checks);
        id_.deviations = -residuals_of(id_, id_.solution, checks);
        id_.before = -residuals_of(nominal, nominal.solution, held_back(nominal));
        id_.u_deviations = D.rowwise().norm();
    }

    Identification& id_;
    Problems& problems_;
    Weights weights_;
    std::vector<Unknown> candidates_;
    std::vector<HeldParameter> held_by_definition_;  ///< by the arm's definition, by the user, for the scale
    std::vector<std::size_t> told_;                  ///< by index in the candidates
};

}  // namespace

bool fit(Identification& id, Problems& problems) {
    return FitToReadings(id, problems).run();
}

}  // namespace covaria::reading_identification
