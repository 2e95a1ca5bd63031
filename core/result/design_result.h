// Result of the search for a design. Plain data; numbers of outputs are SI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/model/output_quantity.h"
#include "core/result/design_places.h"
#include "core/text/typeset_message.h"

namespace covaria {

/// A number that was chosen.
struct DesignValue {
    TypesetMessage title;  ///< "Targets, B: x"
    Unit unit = {};        ///< unit of the following
    double from = 0.0, to = 0.0;
    double before = 0.0, chosen = 0.0;
    double tolerance = 0.0;
    std::optional<double> cost{};  ///< cost of a reduction
    /// Chosen at an end of what was allowed: a wider range can give a better design. The upper end of a
    /// reduction is no limit: it is left as it was.
    bool is_at_end() const;
};

/// A candidate row that was kept.
struct DesignRow {
    std::size_t row = 0;  ///< row from 0, of the table and the CSV file behind it
    Message name;
    bool fixed = false;
    bool added = false;               ///< row of the CSV file
    std::optional<double> without{};  ///< objective of the design without this row; empty: it has no result
    std::optional<double> price{};    ///< set where the objective is about cost
};

/// Gain by a row of the table, kept or not, with the others as chosen.
struct DesignGain {
    std::size_t row = 0;
    Message name;
    bool kept = false;
    /// Part by which the objective is smaller with it than without it; empty: one of the two has no result.
    std::optional<double> gain{};
    std::optional<Eigen::Vector3d> place{};  ///< m, in W; empty: it stands nowhere in space
};

/// A certificate, an instrument's statement, readings: components of one origin, by the budget of what was
/// found.
struct DesignSource {
    Message origin;
    /// Part by which the objective would be smaller if they had no uncertainty, by first order and with the
    /// weights of an adjustment as they are.
    double gain = 0.0;
};

/// An output that was looked at.
struct DesignGoal {
    OutputQuantity output;
    std::optional<double> target{};       ///< the target uncertainty
    std::optional<double> before{};       ///< U of the present design, first order; empty: it has no result
    double after = 0.0;                   ///< U of the chosen design, first order
    std::optional<double> monte_carlo{};  ///< U of the chosen design
    std::optional<bool> validated{};      ///< JCGM 101 clause 8
    bool is_close = false;                ///< other trials could give the other verdict on that
    std::optional<double>
        price_of_target{};  ///< by reductions: what the target costs, per SI unit less of it
    /// Whether the target is met; where clause 8 does not validate first order, also by Monte Carlo.
    bool met() const;
};

/// An improvement on the way.
struct DesignStep {
    std::uint64_t evaluation = 0;
    Message search;                ///< "greedy", "exchange", "start 3"
    double objective = 0.0;        ///< or the cost, where it is about cost
    std::vector<double> values{};  ///< values of the variables
};

/// The best objective that was found with so many rows.
struct DesignCount {
    std::size_t rows = 0;
    double objective = 0.0;
};

/// Cost of the reductions when all targets are so much wider.
struct DesignCost {
    double largest_ratio = 1.0;  ///< U/target
    double cost = 0.0;
};

struct DesignReason {
    Message reason;
    std::uint64_t count = 0;
};

struct DesignResult {
    std::string id, name, analysis;
    std::string objective_words;     ///< "largest U/target"
    bool found = false;              ///< false: nothing that was tried has a result
    bool proved = false;             ///< all choices of rows were evaluated
    std::optional<double> before{};  ///< objective of the present design; empty: it has no result
    Message why_not_before;          ///< then why
    double objective = 0.0;          ///< largest U/target, where it is about cost
    std::vector<DesignValue> values;
    std::vector<DesignRow> rows;  ///< rows that are kept, in their order
    std::size_t candidates = 0;
    std::vector<DesignGain> gains;      ///< gains of all candidate rows
    std::vector<DesignSource> sources;  ///< sources by falling gain
    std::vector<DesignGoal> goals;
    std::vector<DesignCount> curve;
    std::vector<DesignStep> path;
    std::optional<double> cost{};   ///< cost of the reductions or rows
    std::vector<DesignCost> front;  ///< costs by rising ratio
    std::uint64_t evaluations = 0;
    std::vector<DesignReason> reasons;            ///< why evaluations had no result, by falling count
    std::uint64_t trials = 0, failed_trials = 0;  ///< trials of the verification
    Message not_verified;                         ///< why there is none
    std::uint64_t seed = 0;
    double coverage_probability = 0.95;
    std::string fingerprint;  ///< that of the analysis that was searched from
    DesignPlaces places;      ///< places of what was found; no part of files

    /// Found, and every goal with a target meets it.
    bool met() const;
};

/// Whether it was found, and a candidate or something that its variables move has a place to be shown at.
bool stands_in_space(const DesignResult& design);

}  // namespace covaria
