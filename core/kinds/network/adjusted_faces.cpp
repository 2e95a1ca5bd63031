// Both faces of a sight before the adjustment: index and collimation from each pair of readings, and what
// they contradict.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/kinds/network/closure_sums.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

/// The readings of a sight in its two faces. Their difference is 2 i of zenith angles, 2 c / sin z of
/// directions.
struct FacePair {
    std::size_t one = 0, two = 0;  ///< readings
    double sine = 1.0;             ///< sin z of a direction, 1 of a zenith angle
    double difference = 0.0;       ///< face one less face two
    double figure() const { return 0.5 * difference * sine; }
};

/// The index or collimation that all pairs of an instrument share.
struct FaceFigure {
    InstrumentFigure figure;
    std::vector<FacePair> pairs;
    bool is_declared = false;                ///< whether the set-up has a row for it
    double expected = 0.0;                   ///< as stated or fixed; 0 where there is no row
    std::size_t stated = ClosureSums::none;  ///< reading that states it
    bool is_open() const { return is_declared && figure.is_found && stated == ClosureSums::none; }

    double mean() const {
        double sum = 0.0;
        for (const FacePair& pair : pairs) sum += pair.figure();
        return sum / static_cast<double>(pairs.size());
    }
    std::vector<SignedReading> signs_of_mean() const {
        std::vector<SignedReading> signs;
        for (const FacePair& pair : pairs) {
            const double share = 0.5 * pair.sine / static_cast<double>(pairs.size());
            signs.push_back({pair.two, -share});
            signs.push_back({pair.one, share});
        }
        return signs;
    }
    /// The mean less what is stated of the figure.
    std::vector<SignedReading> signs_against_stated() const {
        std::vector<SignedReading> signs;
        if (stated != ClosureSums::none) signs.push_back({stated, -1.0});
        const auto own = signs_of_mean();
        signs.insert(signs.end(), own.begin(), own.end());
        return signs;
    }
};

class FaceFigures {
public:
    explicit FaceFigures(const ClosureSums& sums) : sums_(sums), network_(sums.network) {
        if (std::ranges::none_of(network_.readings, &AdjustedReading::face_two)) return;
        const auto sines = sines_of_sights();
        using Sight =
            std::tuple<ReadingKind, std::size_t, std::size_t, std::size_t, double, double, std::string>;
        std::map<Sight, std::array<std::vector<std::size_t>, 2>> faces;
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& r = network_.readings[i];
            if (r.kind == ReadingKind::direction || r.kind == ReadingKind::zenith_angle)
                faces[{r.kind, r.from, r.to, r.round, r.height_from, r.height_to, r.instrument}]
                     [r.face_two ? 1 : 0]
                         .push_back(i);
        }
        for (const auto& [sight, readings] : faces)
            for (std::size_t k = 0; k < std::min(readings[0].size(), readings[1].size()); ++k)
                take(readings[0][k], readings[1][k], sines);
        for (auto& [key, figure] : figures_) found.push_back(std::move(figure));
    }

    std::vector<FaceFigure> found;

private:
    using Sines = std::map<std::pair<std::size_t, std::size_t>, double>;

    /// The sine of the zenith angle of each sight that was read; levels where none was.
    Sines sines_of_sights() const {
        Sines sines;
        for (const AdjustedReading& r : network_.readings)
            if (r.kind == ReadingKind::zenith_angle) sines.try_emplace({r.from, r.to}, std::sin(r.value));
        return sines;
    }

    void take(std::size_t one, std::size_t two, const Sines& sines) {
        const AdjustedReading &a = network_.readings[one], &b = network_.readings[two];
        const bool direction = a.kind == ReadingKind::direction;
        const FigureKind kind = direction ? FigureKind::collimation : FigureKind::index;
        const auto [known, added] = figures_.try_emplace({a.instrument, kind});
        FaceFigure& figure = known->second;
        if (added) begin(a, kind, figure);
        FacePair pair{one, two};
        pair.difference = std::remainder(a.value - b.value, 2.0 * std::numbers::pi);
        const auto sine = sines.find({a.from, a.to});
        if (direction && sine != sines.end()) pair.sine = sine->second;
        figure.pairs.push_back(pair);
    }

    void begin(const AdjustedReading& reading, FigureKind kind, FaceFigure& figure) const {
        figure.figure = {reading.instrument, kind};
        for (const std::size_t f : reading.figures) {
            if (network_.figures[f].kind != kind) continue;
            figure.figure = network_.figures[f];
            figure.is_declared = true;
            figure.stated = sums_.stated(f);
            if (!figure.is_open())
                figure.expected = figure.stated == ClosureSums::none
                                      ? network_.state[static_cast<Eigen::Index>(network_.figure(f))]
                                      : network_.readings[figure.stated].value;
        }
    }

    const ClosureSums& sums_;
    const AdjustedNetwork& network_;
    std::map<std::pair<std::string, FigureKind>, FaceFigure> figures_;
};

/// Compares each pair with the pair in the middle, where no figure is known that all of them share.
void compare_pairs(ClosureSums& sums, const FaceFigure& figure) {
    std::vector<FacePair> order = figure.pairs;
    std::ranges::stable_sort(order, {}, &FacePair::figure);
    const FacePair& middle = order[order.size() / 2];
    const auto words = [&](const FacePair& pair) {
        return words_of(sums.network, sums.network.readings[pair.one]);
    };
    for (const FacePair& pair : figure.pairs) {
        if (pair.one == middle.one) continue;
        const double by = middle.sine / pair.sine;
        sums.add(tell<"%1 in both faces, as %2">(words(pair), words(middle)),
                 {{middle.one, -by}, {middle.two, by}, {pair.one, 1.0}, {pair.two, -1.0}},
                 pair.difference - by * middle.difference);
    }
}

void compare_with_stated(ClosureSums& sums, const FaceFigure& figure) {
    for (const FacePair& pair : figure.pairs) {
        std::vector<SignedReading> signs{{pair.one, 1.0}, {pair.two, -1.0}};
        if (figure.stated != ClosureSums::none)
            signs.insert(signs.begin(), {figure.stated, -2.0 / pair.sine});
        sums.add(tell<"%1 in both faces">(words_of(sums.network, sums.network.readings[pair.one])), signs,
                 pair.difference - 2.0 * figure.expected / pair.sine);
    }
}

}  // namespace

void compare_faces(ClosureSums& sums) {
    for (const FaceFigure& figure : FaceFigures(sums).found) {
        figure.is_declared && !figure.is_open() ? compare_with_stated(sums, figure)
                                                : compare_pairs(sums, figure);
        const bool says_more = figure.is_declared ? !figure.is_open() && figure.pairs.size() > 1 : true;
        if (says_more)
            sums.add(tell<"%1 from both faces of %2 sights">(words_of(figure.figure), figure.pairs.size()),
                     figure.signs_against_stated(), figure.mean() - figure.expected);
    }
}

std::optional<Table> faces_table(const AdjustedNetwork& network) {
    const ClosureSums sums(network);
    const std::vector<FaceFigure> figures = FaceFigures(sums).found;
    if (figures.empty()) return {};
    const Unit unit = unit_of_residual(ReadingKind::zenith_angle);
    const auto angle = [&](double value) { return Cell(Quantity{unit.from_si(value), unit}); };
    Table table{"faces", known_text<"Both faces before the adjustment">()};
    table.add(known_text<"Figure">());
    table.add(known_text<"sights">()).figure(8);
    table.add(known_text<"from both faces">()).figure(3);
    table.add(known_text<"u of that">()).figure(2);
    table.add(known_text<"stated">()).figure(3);
    table.add(known_text<"u as stated">()).figure(2);
    table.add(known_text<"remark">());
    for (const FaceFigure& f : figures) {
        const double off = std::abs(f.mean() - f.expected) / sums.u_of(f.signs_against_stated());
        const bool far = !f.is_open() && off > adjustment::outlier_limit();
        table.row({words_of(f.figure), static_cast<double>(f.pairs.size()), angle(f.mean()),
                   angle(sums.u_of(f.signs_of_mean())),
                   f.is_declared && !f.is_open() ? angle(f.expected) : Cell(),
                   f.stated != ClosureSums::none ? angle(network.readings[f.stated].u) : Cell(),
                   !far            ? Message()
                   : f.is_declared ? tell<"not as stated?">()
                                   : tell<"state it among the figures of instruments">()});
    }
    table.notes.push_back(
        tell<"Index (z₁ + z₂ − 400 gon)/2 and collimation (a₁ − a₂ ± 200 gon)/2 · sin z of the "
             "sights that were read in both faces.">());
    return table;
}

}  // namespace covaria::network
