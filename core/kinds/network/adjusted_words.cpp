// Words for the directions that an adjustment leaves open: the height or place of points, a turn, the scale.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>

#include "core/kinds/network/adjusted_setup.h"
#include "core/math/decompositions.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

constexpr double least_size = 1e-4;  ///< least part that counts of a direction of length one

/// Vectors of the span of `basis` (orthonormal columns) that are zero in all rows but these.
Eigen::MatrixXd supported_on(const Eigen::MatrixXd& basis, const std::vector<std::size_t>& rows) {
    Eigen::MatrixXd outside = basis;
    for (const std::size_t i : rows) outside.row(static_cast<Eigen::Index>(i)).setZero();
    const auto svd = singular_values(Eigen::MatrixXd(outside.transpose() * outside), Eigen::ComputeFullV);
    Eigen::MatrixXd found(basis.rows(), 0);
    for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        if ((outside * svd.matrixV().col(j)).norm() > least_size) continue;
        found.conservativeResize(Eigen::NoChange, found.cols() + 1);
        found.rightCols<1>() = basis * svd.matrixV().col(j);
    }
    return found;
}

/// The part of the span of `basis` that is orthogonal to the columns of `said`.
Eigen::MatrixXd without(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& said) {
    if (said.cols() == 0) return basis;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(said);
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(said.rows(), said.cols());
    const Eigen::MatrixXd rest = basis - Q * (Q.transpose() * basis);
    const auto svd = singular_values(Eigen::MatrixXd(rest.transpose() * rest), Eigen::ComputeFullV);
    Eigen::MatrixXd left(basis.rows(), 0);
    for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        const Eigen::VectorXd v = rest * svd.matrixV().col(j);
        if (v.norm() < least_size) continue;
        left.conservativeResize(Eigen::NoChange, left.cols() + 1);
        left.rightCols<1>() = v.normalized();
    }
    return left;
}

/// The parts of a network: points that readings connect.
std::vector<std::vector<std::size_t>> parts_of(const AdjustedNetwork& network) {
    std::vector<std::size_t> leader(network.points.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto leader_of = [&](std::size_t i) {
        while (leader[i] != i) i = leader[i] = leader[leader[i]];
        return i;
    };
    for (const AdjustedReading& r : network.readings)
        for (const std::size_t other : {r.to, r.second}) leader[leader_of(other)] = leader_of(r.from);
    std::vector<std::size_t> first_of(network.frames.size(), leader.size());
    for (const AdjustedReading& r : network.readings) {
        if (!is_in_frame(r.kind)) continue;
        std::size_t& first = first_of[r.frame];
        if (first == leader.size()) first = r.from;
        leader[leader_of(r.from)] = leader_of(first);
    }
    std::vector<std::vector<std::size_t>> found;
    std::vector<std::ptrdiff_t> number(leader.size(), -1);
    for (std::size_t p = 0; p < leader.size(); ++p) {
        std::ptrdiff_t& of = number[leader_of(p)];
        if (of < 0) {
            of = static_cast<std::ptrdiff_t>(found.size());
            found.emplace_back();
        }
        found[static_cast<std::size_t>(of)].push_back(p);
    }
    return found;
}

/// The sentence on figures of instruments that the readings cannot tell apart: zero and scale where all
/// distances are equal.
Message figures_apart(const AdjustedNetwork& network, const Eigen::VectorXd& move) {
    Message names;
    for (std::size_t f = 0; f < network.figures.size(); ++f) {
        const std::size_t k = network.unknown_of[network.figure(f)];
        if (k == AdjustedNetwork::known || std::abs(move[static_cast<Eigen::Index>(k)]) < 0.05) continue;
        const Message words = words_of(network.figures[f]);
        names = names.empty() ? words : tell<"%1 and %2">(names, words);
    }
    return tell<
        "the readings cannot tell %1 apart: add readings that see them differently, or state one of "
        "them">(names);
}

double coordinate_share(const std::vector<std::size_t>& own, std::size_t coordinates,
                        const Eigen::MatrixXd& moves) {
    double sum = 0.0;
    for (std::size_t i = 0; i < coordinates; ++i)
        sum += moves.row(static_cast<Eigen::Index>(own[i])).squaredNorm();
    return sum;
}

Message part_names(const AdjustedNetwork& network, const std::vector<std::size_t>& part) {
    if (part.size() == network.points.size()) return tell<"the whole network">();
    constexpr std::size_t most_named = 4;
    std::string names;
    for (std::size_t i = 0; i < std::min(part.size(), most_named); ++i)
        names += (i > 0 ? ", " : "") + network.points[part[i]].name;
    return part.size() > most_named ? tell<"the part with %1 and %2 more">(names, part.size() - most_named)
                                    : tell<"the part with %1">(names);
}

Message words_of_direction(const Eigen::Vector3d& d) {
    const auto number = [](double along) { return Message::number(format_short(along, 2)); };
    return tell<"the direction (%1, %2, %3)">(number(d.x()), number(d.y()), number(d.z()));
}

class OpenDirections {
public:
    OpenDirections(const AdjustedNetwork& network, const adjustment::Adjustment& adjusted)
        : network_(network), adjusted_(adjusted), open_(adjusted.open()) {}

    std::vector<Message> say() {
        say_figures();
        say_frames();
        for (std::size_t p = 0; p < network_.points.size() && open_.cols() > 0; ++p) say_point(p);
        if (open_.cols() > 0)
            for (const std::vector<std::size_t>& part : parts_of(network_)) say_part(part);
        for (Eigen::Index j = 0; j < open_.cols(); ++j) say_rest(open_.col(j));
        return std::move(said_);
    }

private:
    void say_figures() {
        for (std::size_t f = 0; f < network_.figures.size() && open_.cols() > 0; ++f) {
            const std::size_t k = network_.unknown_of[network_.figure(f)];
            if (k == AdjustedNetwork::known) continue;
            const Eigen::MatrixXd moves = supported_on(open_, {k});
            if (moves.cols() == 0) continue;
            said_.push_back(tell<"nothing tells %1: add readings that see it, or state it with u">(
                words_of(network_.figures[f])));
            open_ = without(open_, moves);
        }
    }

    void say_frames() {
        for (std::size_t f = 0; f < network_.frames.size() && open_.cols() > 0; ++f) {
            std::vector<std::size_t> own;
            for (std::size_t k = 0; k < AdjustedFrame::figures; ++k)
                if (network_.frames[f].is_found[k]) own.push_back(network_.unknown_of[network_.frame(f, k)]);
            const Eigen::MatrixXd moves = supported_on(open_, own);
            if (moves.cols() == 0) continue;
            said_.push_back(tell<"nothing tells how %1 lies: read more points in it whose places other "
                                 "readings tell, not all on a line">(words_of(network_.frames[f])));
            open_ = without(open_, moves);
        }
    }

    std::vector<std::size_t> unknowns_of(std::size_t p) const {
        std::vector<std::size_t> found;
        for (std::size_t c = 0; c < 3; ++c)
            if (const std::size_t k = network_.unknown_of[network_.at(p, c)]; k != AdjustedNetwork::known)
                found.push_back(k);
        return found;
    }

    /// Says how one point can move while all others stay, with the rounds that were read there.
    void say_point(std::size_t p) {
        std::vector<std::size_t> own = unknowns_of(p);
        if (own.empty()) return;
        const std::size_t coordinates = own.size();
        for (std::size_t r = 0; r < network_.rounds.size(); ++r)
            if (network_.rounds[r].station == p) own.push_back(network_.unknown_of[network_.orientation(r)]);
        for (std::size_t k = 0; k < network_.leaning.size(); ++k)
            if (network_.leaning[k] == p)
                own.insert(own.end(), {network_.unknown_of[network_.tilt(k, 0)],
                                       network_.unknown_of[network_.tilt(k, 1)]});
        const Eigen::MatrixXd moves = supported_on(open_, own);
        if (moves.cols() == 0) return;
        const std::string& name = network_.points[p].name;
        const bool height_only = moves.cols() == 1 && height_share(p, moves.col(0)) > 0.999;
        const bool only_turns = coordinate_share(own, coordinates, moves) < 1e-6;
        if (!is_read(p))
            said_.push_back(tell<"nothing was read of point %1: add readings to it, or take it out">(name));
        else if (only_turns)
            said_.push_back(tell<"nothing tells how the instrument at %1 stood: add directions or angles "
                                 "from there to places "
                                 "that are known">(name));
        else if (height_only)
            said_.push_back(
                tell<"nothing tells the height of %1: state it, or add a height difference, or a zenith "
                     "angle with a distance">(name));
        else if (moves.cols() >= static_cast<Eigen::Index>(coordinates))
            said_.push_back(tell<"nothing tells where %1 is: add readings to it">(name));
        else
            said_.push_back(
                tell<"point %1 can move along %2 without changing a reading: add one that sees this">(
                    name, direction_words(p, moves.col(0))));
        open_ = without(open_, moves);
    }

    bool is_read(std::size_t p) const {
        return std::ranges::any_of(network_.readings, [&](const AdjustedReading& r) {
            return network::is_read(r.kind) && (r.from == p || r.to == p || r.second == p);
        });
    }

    double height_share(std::size_t p, const Eigen::VectorXd& move) const {
        const std::size_t k = network_.unknown_of[network_.at(p, 2)];
        return k == AdjustedNetwork::known ? 0.0 : std::abs(move[static_cast<Eigen::Index>(k)]);
    }

    Eigen::Vector3d displacement(std::size_t p, const Eigen::VectorXd& move) const {
        Eigen::Vector3d d = Eigen::Vector3d::Zero();
        for (std::size_t c = 0; c < 3; ++c)
            if (const std::size_t k = network_.unknown_of[network_.at(p, c)]; k != AdjustedNetwork::known)
                d[static_cast<Eigen::Index>(c)] =
                    move[static_cast<Eigen::Index>(k)] / adjusted_.scale()[static_cast<Eigen::Index>(k)];
        return d;
    }

    Message direction_words(std::size_t p, const Eigen::VectorXd& move) const {
        const Eigen::Vector3d d = displacement(p, move).normalized();
        for (Eigen::Index c = 0; c < 3; ++c)
            if (std::abs(d[c]) > 0.999) return Message(along_axes[static_cast<std::size_t>(c)]);
        return words_of_direction(d);
    }

    /// The moves of the part as a whole: along x, y, z, turns about x, y, z, scale; they move all of its
    /// coordinates and rounds, those that are fixed too.
    Eigen::MatrixXd whole_moves(const std::vector<std::size_t>& part) const {
        Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(network_.state.size(), 7);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const std::size_t p : part) middle += network_.position(p) / double(part.size());
        for (const std::size_t p : part) {
            const Eigen::Vector3d v = network_.position(p) - middle;
            Eigen::Matrix<double, 3, 7> own;
            own << Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX().cross(v),
                Eigen::Vector3d::UnitY().cross(v), Eigen::Vector3d::UnitZ().cross(v), v;
            for (std::size_t c = 0; c < 3; ++c)
                if (network_.points[p].has(c))
                    moves.row(static_cast<Eigen::Index>(3 * p + c)) = own.row(static_cast<Eigen::Index>(c));
            turn_instruments(p, moves);
        }
        for (std::size_t f = 0; f < network_.frames.size(); ++f)
            if (std::ranges::any_of(network_.readings, [&](const AdjustedReading& r) {
                    return r.frame == f && std::ranges::find(part, r.from) != part.end();
                }))
                moves.middleRows<7>(static_cast<Eigen::Index>(network_.frame(f, 0))) =
                    moves_of_frame(network_, f, middle);
        for (std::size_t f = 0; f < network_.figures.size(); ++f)
            if (network_.figures[f].kind == FigureKind::scale && network_.figures[f].is_found)
                moves(static_cast<Eigen::Index>(network_.figure(f)), 6) = -1.0;
        return moves;
    }

    /// Adds the turns of the orientations and tilts of instruments at p, which turn with the part.
    void turn_instruments(std::size_t p, Eigen::MatrixXd& moves) const {
        // Axes of the tilts about x and y, and of the circle.
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
        for (std::size_t k = 0; k < network_.leaning.size(); ++k) {
            if (network_.leaning[k] != p) continue;
            const Eigen::AngleAxisd about_x(network_.state[static_cast<Eigen::Index>(network_.tilt(k, 0))],
                                            Eigen::Vector3d::UnitX()),
                about_y(network_.state[static_cast<Eigen::Index>(network_.tilt(k, 1))],
                        Eigen::Vector3d::UnitY());
            axes.col(1) = about_x * Eigen::Vector3d::UnitY();
            axes.col(2) = about_x * (about_y * Eigen::Vector3d::UnitZ());
            const Eigen::Matrix3d by_turn = axes.inverse();
            for (std::size_t axis = 0; axis < 2; ++axis)
                moves.row(static_cast<Eigen::Index>(network_.tilt(k, axis))).segment<3>(3) =
                    by_turn.row(static_cast<Eigen::Index>(axis));
        }
        const Eigen::Matrix3d by_turn = axes.inverse();
        for (std::size_t r = 0; r < network_.rounds.size(); ++r)
            if (network_.rounds[r].station == p)
                moves.row(static_cast<Eigen::Index>(network_.orientation(r))).segment<3>(3) =
                    (network_.clockwise ? -1.0 : 1.0) * by_turn.row(2);
    }

    void say_part(const std::vector<std::size_t>& part) {
        const Eigen::MatrixXd moves = whole_moves(part);
        // Moves are seen by the unknowns at their sizes; one that moves something fixed is no way out.
        Eigen::MatrixXd scaled = Eigen::MatrixXd::Zero(open_.rows(), 7), held(0, 7);
        for (Eigen::Index place = 0; place < moves.rows(); ++place) {
            const std::size_t k = network_.unknown_of[static_cast<std::size_t>(place)];
            if (k != AdjustedNetwork::known)
                scaled.row(static_cast<Eigen::Index>(k)) =
                    moves.row(place) * adjusted_.scale()[static_cast<Eigen::Index>(k)];
            else if (moves.row(place).squaredNorm() > 0.0) {
                held.conservativeResize(held.rows() + 1, Eigen::NoChange);
                held.bottomRows<1>() = moves.row(place);
            }
        }
        Eigen::MatrixXd said(open_.rows(), 0);
        // Simple moves come first: each is tried with those before it, which may set it off.
        for (Eigen::Index c = 0; c < 7 && said.cols() < open_.cols(); ++c) {
            const Eigen::VectorXd way = combination(scaled, held, c);
            if (way.size() == 0 || !(way.norm() > 0.0)) continue;
            const Eigen::VectorXd unit = way.normalized();
            if ((unit - open_ * (open_.transpose() * unit)).norm() > least_size) continue;
            Eigen::MatrixXd more(said.rows(), said.cols() + 1);
            more << said, unit;
            if (said.cols() > 0 && without(more, said).cols() == 0) continue;
            said = more;
            said_.push_back(whole_words(part, c));
        }
        open_ = without(open_, said);
    }

    /// The move c, with as much of those along the axes as keeps fixed ones in place and lies in the open
    /// directions; empty where nothing does.
    Eigen::VectorXd combination(const Eigen::MatrixXd& scaled, const Eigen::MatrixXd& held,
                                Eigen::Index c) const {
        const Eigen::VectorXd own = scaled.col(c);
        const Eigen::VectorXd target = own - open_ * (open_.transpose() * own);
        const Eigen::Index before = c < 3 ? 0 : 3;
        const Eigen::MatrixXd shifts = scaled.leftCols(before);
        Eigen::MatrixXd system(scaled.rows() + held.rows(), before);
        Eigen::VectorXd right(scaled.rows() + held.rows());
        const double weight = scaled.norm() / std::max(1.0, held.norm());
        system << (shifts - open_ * (open_.transpose() * shifts)), weight * held.leftCols(before);
        right << -target, -weight * held.col(c);
        Eigen::VectorXd by = Eigen::VectorXd::Zero(before);
        if (before > 0) by = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(system).solve(right);
        const Eigen::VectorXd misfit =
            before > 0 ? Eigen::VectorXd(system * by - right) : Eigen::VectorXd(-right);
        if (misfit.norm() > least_size * own.norm()) return {};
        return own + shifts * by;
    }

    Message whole_words(const std::vector<std::size_t>& part, Eigen::Index move) const {
        const Message names = part_names(network_, part);
        switch (move) {
            case 0:
            case 1:
                return tell<
                    "nothing tells where %1 is along %2: fix or state a point, or let points be of the "
                    "datum">(names, std::string(along_axes[static_cast<std::size_t>(move)]));
            case 2:
                return tell<
                    "nothing tells the height of %1: fix or state the height of a point, or let heights be "
                    "of "
                    "the datum">(names);
            case 3:
            case 4:
                return tell<
                    "%1 may tilt about %2: add zenith angles or height differences, or fix a third point">(
                    names, std::string(along_axes[static_cast<std::size_t>(move - 3)]));
            case 5:
                return tell<
                    "%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of "
                    "the datum">(names);
            default:
                return tell<
                    "nothing tells the scale of %1: add a distance, fix a second point, or let points be of "
                    "the datum">(names);
        }
    }

    void say_rest(const Eigen::VectorXd& move) {
        std::vector<std::pair<double, std::size_t>> sizes;
        for (std::size_t p = 0; p < network_.points.size(); ++p) {
            double size = 0.0;
            for (const std::size_t k : unknowns_of(p))
                size += std::pow(move[static_cast<Eigen::Index>(k)], 2);
            sizes.emplace_back(-size, p);
        }
        std::sort(sizes.begin(), sizes.end());
        if (sizes.empty() || !(sizes[0].first < 0.0)) return said_.push_back(figures_apart(network_, move));
        std::string names;
        for (std::size_t i = 0; i < std::min<std::size_t>(3, sizes.size()); ++i)
            if (-sizes[i].first > 0.05 * -sizes[0].first)
                names += (names.empty() ? "" : ", ") + network_.points[sizes[i].second].name;
        said_.push_back(
            tell<"the readings leave open a common movement of %1: add readings that tie them to the "
                 "others">(names));
    }

    const AdjustedNetwork& network_;
    const adjustment::Adjustment& adjusted_;
    Eigen::MatrixXd open_;
    std::vector<Message> said_;
};

}  // namespace

std::optional<Message> too_few_readings(const AdjustedNetwork& network) {
    if (network.figures.empty()) return {};
    std::size_t of_datum = 0;
    if (!network.datum.empty())
        for (const std::vector<std::size_t>& part : parts_of(network)) {
            const bool plane =
                std::ranges::any_of(part, [&](std::size_t p) { return network.points[p].has(0); });
            const bool heights =
                std::ranges::any_of(part, [&](std::size_t p) { return network.points[p].has(2); });
            of_datum += plane && heights ? 7 : plane ? 4 : 1;
        }
    const std::size_t unknowns = network.place_of.size() - std::min(network.place_of.size(), of_datum),
                      readings = network.readings.size();
    if (readings >= unknowns) return {};
    return tell<
        "%1 readings cannot tell %2 unknowns (coordinates less what the datum takes, orientations, "
        "figures of instruments): add %3 readings at least, or state figures with u">(readings, unknowns,
                                                                                      unknowns - readings);
}

std::vector<Message> open_directions(const AdjustedNetwork& network, const adjustment::Adjustment& adjusted) {
    return OpenDirections(network, adjusted).say();
}

}  // namespace covaria::network
