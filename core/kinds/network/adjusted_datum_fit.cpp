#include "core/kinds/network/adjusted_datum_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/text/numbers.h"

namespace covaria::network {

namespace {

using Complex = std::complex<double>;

/// The points of the datum by number, with their places in the plane as typed and as the readings draw them.
struct DatumPoints {
    std::vector<std::size_t> points;
    std::vector<Complex> typed, drawn;
};

DatumPoints datum_points(const AdjustedNetwork& network) {
    DatumPoints found;
    for (std::size_t p = 0; p < network.points.size(); ++p) {
        const AdjustedPoint& point = network.points[p];
        if (point.role[0] != CoordinateRole::datum || point.role[1] != CoordinateRole::datum) continue;
        if (!point.typed[0] || !point.typed[1]) continue;
        found.points.push_back(p);
        found.typed.emplace_back(*point.typed[0], *point.typed[1]);
        found.drawn.emplace_back(network.position(p).x(), network.position(p).y());
    }
    return found;
}

std::optional<DatumFit> fit(const std::vector<Complex>& drawn, const std::vector<Complex>& typed) {
    if (typed.size() < 3) return {};
    const double n = static_cast<double>(typed.size());
    Complex middle_drawn, middle_typed, product;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        middle_drawn += drawn[i] / n;
        middle_typed += typed[i] / n;
    }
    double of_drawn = 0.0, of_typed = 0.0;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        const Complex a = drawn[i] - middle_drawn, b = typed[i] - middle_typed;
        product += std::conj(a) * b;
        of_drawn += std::norm(a);
        of_typed += std::norm(b);
    }
    if (!(of_drawn > 0.0) || !(of_typed > 0.0)) return {};
    const double left = 1.0 - std::norm(product) / (of_drawn * of_typed);
    return DatumFit{std::abs(product) / of_drawn, std::sqrt(std::max(0.0, left))};
}

constexpr double agrees = 0.05;  ///< misfit of coordinates that are typed roughly
constexpr double far_less = 0.2;

bool explains(const std::optional<DatumFit>& of_mistake, const DatumFit& as_typed) {
    return of_mistake && of_mistake->misfit < agrees && of_mistake->misfit < far_less * as_typed.misfit;
}

bool reads_angles(const AdjustedNetwork& network) {
    return std::ranges::any_of(network.readings, [](const AdjustedReading& r) {
        return r.kind == ReadingKind::direction || r.kind == ReadingKind::angle ||
               r.kind == ReadingKind::azimuth;
    });
}

Message words_of_size(const DatumFit& fit) {
    struct Unit {
        double ratio;
        Message words;
    };
    const Unit units[]{{1e-3, tell<"lengths in mm that were typed as m">()},
                       {1e3, tell<"coordinates in mm that were typed as m">()},
                       {0.3048, tell<"lengths in feet that were typed as m">()},
                       {1.0 / 0.3048, tell<"coordinates in feet that were typed as m">()}};
    const Message ratio = Message::number(format_significant(1.0 / fit.scale, 4));
    for (const Unit& unit : units)
        if (std::abs(fit.scale / unit.ratio - 1.0) < 0.03)
            return tell<
                "the readings draw a network %1 times as large as the approximate coordinates of the "
                "datum do: look for %2">(ratio, unit.words);
    return tell<
        "the readings draw a network %1 times as large as the approximate coordinates of the datum do: "
        "look for a wrong unit or scale">(ratio);
}

/// What two points exchanged, or one typed wrongly, would explain; nothing where neither does.
Message words_of_points(const AdjustedNetwork& network, const DatumPoints& datum, const DatumFit& as_typed) {
    constexpr std::size_t most_points = 100;
    const std::size_t n = datum.points.size();
    const auto name = [&](std::size_t i) { return network.points[datum.points[i]].name; };
    if (n > most_points) return {};
    for (std::size_t a = 0; n > 3 && a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b) {
            std::vector<Complex> exchanged = datum.typed;
            std::swap(exchanged[a], exchanged[b]);
            if (explains(fit(datum.drawn, exchanged), as_typed))
                return tell<
                    "the approximate coordinates of the datum agree with the readings if those of %1 and "
                    "%2 are exchanged">(name(a), name(b));
        }
    for (std::size_t a = 0; n > 4 && a < n; ++a) {
        std::vector<Complex> drawn = datum.drawn, typed = datum.typed;
        drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(a));
        typed.erase(typed.begin() + static_cast<std::ptrdiff_t>(a));
        if (explains(fit(drawn, typed), as_typed))
            return tell<
                "the approximate coordinates of the datum agree with the readings but for those of %1: "
                "look for a mistyped one">(name(a));
    }
    return {};
}

}  // namespace

std::optional<DatumFit> datum_fit(const AdjustedNetwork& network) {
    const DatumPoints datum = datum_points(network);
    return fit(datum.drawn, datum.typed);
}

void check_datum(const AdjustedNetwork& network, Problems& problems) {
    const DatumPoints datum = datum_points(network);
    const auto as_typed = fit(datum.drawn, datum.typed);
    if (!as_typed) return;
    Message words;
    if (as_typed->misfit < agrees) {
        constexpr double about_one = 0.1;
        if (std::abs(std::log(as_typed->scale)) > about_one) words = words_of_size(*as_typed);
    } else {
        std::vector<Complex> mirrored = datum.drawn;
        for (Complex& at : mirrored) at = std::conj(at);
        if (explains(fit(mirrored, datum.typed), *as_typed))
            words =
                reads_angles(network)
                    ? tell<
                          "the readings draw the mirror image of what the approximate coordinates of the "
                          "datum "
                          "do: the sense of angles, clockwise or counter-clockwise, is probably the other "
                          "one, or x and y are exchanged">()
                    : tell<
                          "the readings draw the mirror image of what the approximate coordinates of the "
                          "datum "
                          "do: x and y are probably exchanged">();
        else
            words = words_of_points(network, datum, *as_typed);
    }
    if (words.empty()) return;
    problems.warning(
        adjustment_fields().place(&StatedAdjustment::points, network.points[datum.points[0]].row),
        std::move(words));
}

}  // namespace covaria::network
