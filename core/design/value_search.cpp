#include "core/design/value_search.h"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "core/propagation/parallel_blocks.h"
#include "core/random/uniforms.h"

namespace covaria::detail {

namespace {

constexpr int polishings = 8;
constexpr double polished = 1e-11;  ///< relative improvement below which a start is at its optimum
constexpr std::size_t tried_starts = 50;

/// Result of one start.
struct StartResult {
    std::vector<double> place;  ///< place in the unit cube
    double merit = std::numeric_limits<double>::infinity();
    bool feasible = false;
    SearchNotes notes;
};

std::vector<double> values_at(const std::vector<StudyAxis>& axes, const std::vector<double>& place) {
    std::vector<double> values;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const double t = std::clamp(place[i], 0.0, 1.0);
        values.push_back(t == 1.0 ? axes[i].to : axes[i].from + t * (axes[i].to - axes[i].from));
    }
    return values;
}

/// A start: place of the unit cube -> objective, on one thread.
class Start {
public:
    Start(SearchBook& book, const std::vector<std::size_t>& rows, const std::vector<double>& from,
          std::size_t number, std::uint64_t budget)
        : book_(book),
          rows_(rows),
          from_(from),
          number_(number),
          budget_(budget),
          variables_(book.design().design.variables.size()),
          judge_(book.judges().lend()) {}

    /// False: stopped.
    bool run(StartResult& result) {
        result_ = &result;
        result.place.assign(variables_, 0.5);
        search_ = number_ == 0   ? tell<"from the present values">()
                  : number_ == 1 ? tell<"global search">()
                                 : tell<"start %1">(number_);
        try {
            if (number_ == 0)
                judged_at(first_place());
            else
                random_place();
            if (number_ == 1) search_globally();
            polish();
        } catch (const nlopt::forced_stop&) {  // or all evaluations are spent
        }
        return !stopped_;
    }

private:
    Judged judged_at(const std::vector<double>& place) {
        if (result_->notes.evaluations >= budget_) throw nlopt::forced_stop();
        const Candidate candidate{values_at(book_.design().numbers.axes, place), rows_};
        Judged judged = judge_->judge(candidate);
        result_->notes.add(candidate, judged, search_, book_.is_whole(candidate));
        if (judged.merit() < result_->merit) {
            result_->merit = judged.merit();
            result_->feasible = judged.feasible();
            result_->place = place;
        }
        stopped_ = !book_.advance(judged, true);
        if (stopped_) throw nlopt::forced_stop();
        return judged;
    }
    double merit_of(const std::vector<double>& place) { return judged_at(place).merit(); }

    std::vector<double> first_place() const {
        std::vector<double> place;
        for (std::size_t i = 0; i < variables_; ++i) {
            const StudyAxis& axis = book_.design().numbers.axes[i];
            place.push_back(std::clamp((from_[i] - axis.from) / (axis.to - axis.from), 0.0, 1.0));
        }
        return place;
    }

    /// Goes to the first of some random places that is feasible; else to the one that violates least.
    void random_place() {
        std::vector<double> place(variables_);
        for (std::size_t t = 0; t < tried_starts; ++t) {
            uniforms(book_.design().design.seed, DrawPurpose::design_starts,
                     static_cast<std::uint32_t>(number_), t * variables_, place);
            if (judged_at(place).feasible()) return;
        }
    }

    static double objective(const std::vector<double>& place, std::vector<double>&, void* self) {
        return static_cast<Start*>(self)->merit_of(place);
    }

    nlopt::opt method(nlopt::algorithm algorithm) {
        nlopt::opt opt(algorithm, static_cast<unsigned>(variables_));
        opt.set_lower_bounds(0.0);
        opt.set_upper_bounds(1.0);
        opt.set_min_objective(objective, this);
        return opt;
    }

    /// However it ends, the best that was evaluated counts.
    static void optimise(nlopt::opt& opt, std::vector<double> from) {
        double merit = 0.0;
        try {
            opt.optimize(from, merit);
        } catch (const nlopt::forced_stop&) {
            throw;
        } catch (const std::exception&) {  // rounding is in the way, a step has vanished
        }
    }

    /// Controlled random search (Price; Kaelo and Ali 2006), on half of the evaluations.
    void search_globally() {
        nlopt::srand(static_cast<unsigned long>(book_.design().design.seed));
        nlopt::opt opt = method(nlopt::GN_CRS2_LM);
        opt.set_maxeval(static_cast<int>(std::min<std::uint64_t>(budget_ / 2, 1'000'000'000)));
        opt.set_ftol_rel(1e-6);
        optimise(opt, result_->place);
    }

    /// Rowan's subplex and, at kinks of a largest ratio, linear models of the ratios (Powell's COBYLA) in
    /// turn, until neither finds anything better.
    void polish() {
        double step = 0.25;
        for (int i = 0; i < polishings; ++i) {
            const double before = result_->merit;
            nlopt::opt opt = method(nlopt::LN_SBPLX);
            opt.set_initial_step(step);
            opt.set_xtol_abs(1e-10);
            opt.set_ftol_rel(1e-13);
            optimise(opt, result_->place);
            if (has_kinks()) flatten(step);
            if (before - result_->merit <= polished * std::abs(before)) break;
            step = std::max(0.01, 0.4 * step);
        }
    }

    bool has_kinks() const {
        return book_.design().design.objective == DesignObjective::largest &&
               book_.design().outputs.size() > 1 && result_->feasible;
    }

    /// Smallest z with all ratios at most z: smooth, where the largest of them is not.
    struct Level {
        Start* start;
        References references;
    };
    static double level(const std::vector<double>& x, std::vector<double>&, void*) { return x.back(); }
    static void ratios(unsigned count, double* above, unsigned n, const double* x, double*, void* data) {
        const Level& level = *static_cast<Level*>(data);
        const std::vector<double> place(x, x + n - 1);
        const Judged judged = level.start->judged_at(place);
        for (unsigned k = 0; k < count; ++k)
            above[k] = judged.feasible() ? judged.expanded[k] / level.references[k] - x[n - 1] : 1e3;
    }

    void flatten(double step) {
        Level data{this, judge_->references()};
        const auto n = static_cast<unsigned>(variables_ + 1);
        const std::size_t outputs = data.references.size();
        nlopt::opt opt(nlopt::LN_COBYLA, n);
        std::vector<double> low(n, 0.0), high(n, 1.0), steps(n, 0.2 * step), x = result_->place;
        high.back() = 2.0 * result_->merit;
        steps.back() = 0.2 * step * result_->merit;
        x.push_back(result_->merit);
        opt.set_lower_bounds(low);
        opt.set_upper_bounds(high);
        opt.set_initial_step(steps);
        opt.set_min_objective(level, nullptr);
        opt.add_inequality_mconstraint(ratios, &data, std::vector<double>(outputs, 1e-12));
        opt.set_xtol_rel(1e-9);
        opt.set_maxeval(static_cast<int>(200 * n));
        optimise(opt, std::move(x));
    }

    SearchBook& book_;
    const std::vector<std::size_t>& rows_;
    const std::vector<double>& from_;
    std::size_t number_;
    std::uint64_t budget_;
    std::size_t variables_;
    std::shared_ptr<CandidateJudge> judge_;
    Message search_;
    StartResult* result_ = nullptr;
    bool stopped_ = false;
};

}  // namespace

FoundValues find_values(SearchBook& book, const std::vector<std::size_t>& rows,
                        const std::vector<double>& from) {
    const std::size_t starts = book.design().design.starts + 1;  // local starts and the global search
    const std::uint64_t share = std::max<std::uint64_t>(1, book.left() / starts);
    FoundValues found;
    double best = std::numeric_limits<double>::infinity();
    OrderedWork<StartResult> work;
    work.units = starts;
    work.make_partial = [] { return StartResult{}; };
    work.make_worker = [&] {
        return [&book, &rows, &from, share](std::uint64_t number, StartResult& result) {
            result = {};
            return Start(book, rows, from, static_cast<std::size_t>(number), share).run(result);
        };
    };
    work.merge = [&](std::uint64_t, StartResult& result) {
        book.merge(result.notes);
        if (result.merit < best) {
            best = result.merit;
            found = {values_at(book.design().numbers.axes, result.place), result.feasible};
        }
        return true;
    };
    if (run_in_order(work, book.monitor()) == WorkEnd::cancelled) throw Stopped{};
    return found;
}

}  // namespace covaria::detail
