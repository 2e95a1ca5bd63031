#include "core/kinds/network/adjusted_checks.h"

#include <cmath>

#include "core/text/numbers.h"

namespace covaria::network {

namespace {

constexpr double coverage_factor = 2.0;  ///< of E_n, by which it is defined

std::string words_of_distance(const AdjustedNetwork& network, std::size_t distance) {
    const auto& [from, to] = network.distances[distance];
    return network.points[from].name + "–" + network.points[to].name;
}

}  // namespace

double HeldLength::normalised_error() const {
    return std::abs(difference()) / (coverage_factor * u);
}

Eigen::VectorXd gradient_of_distance(const AdjustedNetwork& network, std::size_t distance,
                                     const double* state) {
    const auto& [from, to] = network.distances[distance];
    const auto place = [&](std::size_t point) {
        return Eigen::Map<const Eigen::Vector3d>(state + 3 * point);
    };
    const Eigen::Vector3d unit = (place(to) - place(from)).normalized();
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(network.place_of.size()));
    for (std::size_t c = 0; c < 3; ++c)
        for (const auto& [point, sign] : {std::pair(to, 1.0), std::pair(from, -1.0)})
            if (const std::size_t k = network.unknown_of[network.at(point, c)]; k != AdjustedNetwork::known)
                gradient[static_cast<Eigen::Index>(k)] += sign * unit[static_cast<Eigen::Index>(c)];
    return gradient;
}

std::vector<HeldLength> held_lengths(const AdjustedNetwork& network) {
    std::vector<HeldLength> held;
    if (!network.adjusted) return held;
    for (const ReferenceLength& reference : network.references) {
        const auto& [from, to] = network.distances[reference.distance];
        const Eigen::VectorXd g = gradient_of_distance(network, reference.distance, network.state.data());
        const double variance = std::max(0.0, g.dot(network.adjusted->cofactors(g)));
        held.push_back({reference.distance, (network.position(to) - network.position(from)).norm(),
                        reference.length, std::hypot(std::sqrt(variance), reference.u)});
    }
    return held;
}

Table held_lengths_table(const AdjustedNetwork& network, const std::vector<HeldLength>& held) {
    const Unit mm = Unit::of("mm"), um = Unit::of("um");
    Table table{"check-lengths", known_text<"Calibrated lengths held back from the adjustment">()};
    table.add(known_text<"Distance">());
    table.add(known_text<"as adjusted">()).in(mm).figure(8);
    table.add(known_text<"reference">()).in(mm).figure(8);
    table.add(known_text<"adjusted less reference">()).in(um).figure(3);
    table.add(known_text<"U of the difference (k = 2)">()).in(um).figure(2);
    table.add("E_n").symbol().figure(2);
    for (const HeldLength& length : held)
        table.row({words_of_distance(network, length.distance), length.adjusted, length.reference,
                   length.difference(), coverage_factor * length.u, length.normalised_error()});
    table.notes = {
        tell<"E_n = |d|/U: up to 1 the network agrees with the length. No reading knows it, so that it also "
             "speaks for or against what all readings have in common: the scale of distances.">()};
    return table;
}

void check_held_lengths(const AdjustedNetwork& network, Problems& problems) {
    for (const HeldLength& length : held_lengths(network))
        if (length.normalised_error() > 1.0)
            problems.warning(
                adjustment_fields().place(&StatedAdjustment::distances),
                tell<"%1 as adjusted differs from its reference by %2 µm, with E_n = %3: look for a wrong "
                     "scale of distances, a wrong reference, or uncertainties that are too small">(
                    words_of_distance(network, length.distance),
                    Message::number(format_significant(1e6 * length.difference(), 3)),
                    Message::number(format_significant(length.normalised_error(), 2))));
}

}  // namespace covaria::network
