#include "core/kinds/network/adjusted_trials.h"

#include <algorithm>
#include <cmath>

namespace covaria::network {

namespace {

using adjustment::FewLanes;
using adjustment::ManyLanes;
using adjustment::OneLane;

/// The readings of one trial.
struct OneTrial {
    std::span<const double> x;
    OneLane operator()(std::size_t reading) const { return OneLane(x[reading]); }
};

/// The readings of trials side by side.
template <class Numbers>
struct SomeTrials {
    const double* first;
    std::size_t stride;
    Numbers operator()(std::size_t reading) const { return Numbers::load(first + reading * stride); }
};

/// Each step is as much shorter as the one before. The last digit of large coordinates may be more than that
/// part of a reading's u.
bool is_settled(double length, double before) {
    constexpr double enough = 1e-9;  // as a part of a reading's u
    return length < enough || (std::isfinite(before) && length * length < enough * before) ||
           (length < 1e-5 && length > 0.5 * before);
}

}  // namespace

template <class Numbers>
struct AdjustedTrials::Buffers {
    /// Whether the search of one trial goes on, and why it does not.
    enum class Search : char { goes_on, has_ended, has_failed };
    static constexpr std::size_t lanes = Numbers::size;
    std::vector<Numbers> moved;  ///< the state less the estimates
    std::vector<Numbers> change, scratch;
    Numbers goes_on;                           ///< 1 in lanes whose search goes on, 0 in others
    std::array<double, lanes> length, before;  ///< of the last step and the one before
    std::array<Search, lanes> search;
    std::vector<double> states;  ///< of each lane, where readings are predicted as a whole

    static Buffers& of_thread() {
        static thread_local Buffers buffers;
        return buffers;
    }

    bool has_ended(std::size_t lane) const { return search[lane] == Search::has_ended; }

    void begin(std::size_t places, std::size_t unknowns, std::size_t numbers) {
        moved.assign(places, Numbers());
        change.resize(unknowns);
        scratch.resize(numbers);
        goes_on = Numbers(1.0);
        before.fill(std::numeric_limits<double>::infinity());
        search.fill(Search::goes_on);
    }

    /// Ends the search in lanes where nothing moves any more; false where none goes on.
    bool look() {
        bool any = false;
        std::array<double, lanes> open{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            if (search[lane] != Search::goes_on) continue;
            if (!std::isfinite(length[lane]))
                search[lane] = Search::has_failed;
            else if (is_settled(length[lane], before[lane]))
                search[lane] = Search::has_ended;
            before[lane] = length[lane];
            open[lane] = search[lane] == Search::goes_on ? 1.0 : 0.0;
            any = any || open[lane] > 0.0;
        }
        goes_on = Numbers::load(open.data());
        return any;
    }
};

AdjustedTrials::AdjustedTrials(const AdjustedNetwork& network)
    : network_(network),
      near_(network),
      weighted_(network.whitening.transpose() * network.adjusted->whitened()) {
    weighted_.makeCompressed();
}

template <class Numbers>
void AdjustedTrials::set_states(Buffers<Numbers>& b) const {
    const std::size_t places = b.moved.size();
    b.states.resize(places * Buffers<Numbers>::lanes);
    std::array<double, Buffers<Numbers>::lanes> moved;
    for (std::size_t place = 0; place < places; ++place) {
        b.moved[place].store(moved.data());
        for (std::size_t lane = 0; lane < moved.size(); ++lane)
            b.states[lane * places + place] = network_.state[static_cast<Eigen::Index>(place)] + moved[lane];
    }
}

template <class Numbers, class Readings>
Numbers AdjustedTrials::whole_residual(const Readings& x, std::size_t reading,
                                       const Buffers<Numbers>& b) const {
    std::array<double, Buffers<Numbers>::lanes> r;
    x(reading).store(r.data());
    for (std::size_t lane = 0; lane < r.size(); ++lane)
        r[lane] = residual_of(network_, network_.readings[reading], r[lane],
                              b.states.data() + lane * b.moved.size());
    return Numbers::load(r.data());
}

/// The change := J₀ᵀ C⁻¹ (x − h).
template <class Numbers, class Readings>
void AdjustedTrials::set_gradient(const Readings& x, bool has_moved, Buffers<Numbers>& b) const {
    std::fill(b.change.begin(), b.change.end(), Numbers());
    if (has_moved && !near_.are_all_plain()) set_states(b);
    const int *starts = weighted_.outerIndexPtr(), *columns = weighted_.innerIndexPtr();
    const double* values = weighted_.valuePtr();
    for (std::size_t i = 0; i < near_.readings(); ++i) {
        Numbers r;
        if (has_moved && !near_.is_plain(i)) {
            r = whole_residual(x, i, b);
        } else {
            r = x(i);
            Numbers::for_packs([&](auto p) {
                r.packs[p] = near_.at_estimates(i, r.packs[p]);
                if (has_moved)
                    r.packs[p] = near_.at_state(i, r.packs[p],
                                                [&](std::size_t place) { return b.moved[place].packs[p]; });
            });
        }
        for (int e = starts[i]; e < starts[i + 1]; ++e)
            add_product(b.change[static_cast<std::size_t>(columns[e])], values[e], r);
    }
}

/// Moves the lanes that go on by the change.
template <class Numbers>
void AdjustedTrials::take_step(Buffers<Numbers>& b) const {
    using namespace real_functions;
    using Real = typename Numbers::Real;
    const Eigen::VectorXd& scale = network_.adjusted->scale();
    Numbers length, residue;
    for (std::size_t k = 0; k < b.change.size(); ++k) {
        Numbers& moved = b.moved[network_.place_of[k]];
        for (std::size_t p = 0; p < Numbers::count; ++p) {
            const Real change = select(b.goes_on.packs[p] > Real(0.0), b.change[k].packs[p], Real(0.0));
            moved.packs[p] += change;
            const Real seen = abs(change) * Real(scale[static_cast<Eigen::Index>(k)]);
            length.packs[p] = max(length.packs[p], seen);
            residue.packs[p] += change - change;  // 0, or not a number
        }
    }
    for (std::size_t p = 0; p < Numbers::count; ++p) length.packs[p] += residue.packs[p];
    length.store(b.length.data());
}

template <class Numbers, class Readings>
void AdjustedTrials::search(const Readings& x, Buffers<Numbers>& b) const {
    constexpr int most_steps = 60;
    b.begin(static_cast<std::size_t>(network_.state.size()), network_.place_of.size(),
            network_.adjusted->scratch_size());
    for (int k = 0; k < most_steps; ++k) {
        set_gradient(x, k > 0, b);
        network_.adjusted->step(b.change.data(), b.scratch.data());
        take_step(b);
        if (!b.look()) return;
    }
}

bool AdjustedTrials::find_state(std::span<const double> x, std::vector<double>& state) const {
    auto& b = Buffers<OneLane>::of_thread();
    search(OneTrial{x}, b);
    set_states(b);
    state.assign(b.states.data(), b.states.data() + b.moved.size());
    return b.has_ended(0);
}

template <class Numbers, class Put>
void AdjustedTrials::put_outputs(const Buffers<Numbers>& b, const Put& put) const {
    using Real = typename Numbers::Real;
    using std::sqrt;
    const std::size_t n = network_.place_of.size();
    for (std::size_t k = 0; k < n; ++k) {
        Numbers y = b.moved[network_.place_of[k]];
        const Real estimate(network_.state[static_cast<Eigen::Index>(network_.place_of[k])]);
        for (Real& pack : y.packs) pack += estimate;
        put(k, y);
    }
    for (std::size_t i = 0; i < network_.distances.size(); ++i) {
        const auto& [from, to] = network_.distances[i];
        const Eigen::Vector3d v = network_.position(to) - network_.position(from);
        Numbers y;
        for (std::size_t p = 0; p < Numbers::count; ++p) {
            Real squares(0.0);
            for (std::size_t c = 0; c < 3; ++c) {
                const Real along = Real(v[static_cast<Eigen::Index>(c)]) +
                                   (b.moved[3 * to + c].packs[p] - b.moved[3 * from + c].packs[p]);
                squares += along * along;
            }
            y.packs[p] = sqrt(squares);
        }
        put(n + i, y);
    }
}

bool AdjustedTrials::evaluate(std::span<const double> x, std::span<double> y) const {
    auto& b = Buffers<OneLane>::of_thread();
    search(OneTrial{x}, b);
    put_outputs(b, [&](std::size_t j, const OneLane& value) { value.store(&y[j]); });
    return b.has_ended(0);
}

template <class Numbers>
void AdjustedTrials::evaluate_some(const TrialBlock& block, std::size_t first) const {
    auto& b = Buffers<Numbers>::of_thread();
    search(SomeTrials<Numbers>{block.inputs + first, block.stride}, b);
    put_outputs(b, [&](std::size_t j, const Numbers& value) {
        value.store(block.outputs + j * block.stride + first);
    });
    for (std::size_t lane = 0; lane < Numbers::size && first + lane < block.trials; ++lane)
        block.valid[first + lane] = b.has_ended(lane) ? 1 : 0;
}

void AdjustedTrials::evaluate(const TrialBlock& block) const {
    const std::size_t lanes = (block.trials + FewLanes::size - 1) / FewLanes::size * FewLanes::size;
    if (lanes == FewLanes::size) return evaluate_some<FewLanes>(block, 0);
    // The last trials may be searched twice, with the same end.
    for (std::size_t t = 0; t < lanes; t += ManyLanes::size)
        evaluate_some<ManyLanes>(block, std::min(t, lanes - ManyLanes::size));
}

}  // namespace covaria::network
