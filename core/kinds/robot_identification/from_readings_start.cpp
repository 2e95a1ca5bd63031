// Where the search of an identification from readings begins: base, places and balls as the nominal arm puts
// them.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/kinds/robot_identification/from_readings.h"

namespace covaria::reading_identification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class StartOfSearch {
public:
    explicit StartOfSearch(Identification& id) : id_(id), x_(identification::estimates_of(id.inputs)) {}

    void find() {
        if (id_.base_found) approach_positions();
        for (std::size_t k = 0; k < id_.fixed_places.size(); ++k) {
            if (!id_.fixed_places[k].found) continue;
            if (id_.fixed_places[k].plane)
                start_plane(k);
            else if (!id_.places[k].p[0] || !id_.places[k].p[1] || !id_.places[k].p[2])
                start_point(k);
        }
    }

private:
    /// Base and targets by turns, each where it fits the measured positions best with the nominal arm: the
    /// sum of squares falls with each turn.
    void approach_positions() {
        constexpr int most_turns = 200;
        std::vector<const Row*> first;  // the x of each position; y and z follow
        for (std::size_t i = 0; i < id_.fitted_rows; ++i)
            if (id_.rows[i].kind == RowKind::x) first.push_back(&id_.rows[i]);
        if (first.size() < 3) return;
        std::vector<Eigen::Isometry3d> flanges;
        for (const Row* row : first) {
            const auto& q = id_.poses[row->pose].q;
            flanges.push_back(link_frames(id_.robot(), q)[q.size()]);
        }
        const auto n = static_cast<Index>(first.size());
        Eigen::Matrix3Xd to(3, n), from(3, n);
        for (Index k = 0; k < n; ++k)
            for (int c = 0; c < 3; ++c) to(c, k) = first[static_cast<std::size_t>(k)][c].value;
        for (int turn = 0; turn < most_turns; ++turn) {
            for (Index k = 0; k < n; ++k)
                from.col(k) = flanges[static_cast<std::size_t>(k)] *
                              id_.arm_targets[first[static_cast<std::size_t>(k)]->target].p_F;
            id_.X_MB = Eigen::Isometry3d(Eigen::umeyama(from, to, false));
            double moved = 0.0;
            for (std::size_t t = 0; t < id_.arm_targets.size(); ++t)
                if (id_.arm_targets[t].found) moved = std::max(moved, register_target(t, first, flanges, to));
            if (moved < 1e-6 && turn > 0) return;
        }
    }

    /// The mean of where each pose puts it in the frame of the last link; by how much that moves it.
    double register_target(std::size_t t, const std::vector<const Row*>& rows,
                           const std::vector<Eigen::Isometry3d>& flanges, const Eigen::Matrix3Xd& to) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        int count = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (rows[k]->target != t) continue;
            sum += (id_.X_MB * flanges[k]).inverse() * to.col(static_cast<Index>(k));
            ++count;
        }
        if (count == 0) return 0.0;
        const Eigen::Vector3d before = std::exchange(id_.arm_targets[t].p_F, sum / count);
        return (id_.arm_targets[t].p_F - before).norm();
    }

    struct Seen {
        std::vector<Eigen::Vector3d> from;
        std::vector<double> distances;
    };

    Seen seen_from(std::size_t place) {
        Scene<double> scene;
        scene_of<double>(id_, values_of(id_), x_, scene);
        Seen seen;
        for (std::size_t i = 0; i < id_.fitted_rows; ++i) {
            const Row& row = id_.rows[i];
            if ((row.kind != RowKind::from_point && row.kind != RowKind::from_plane) || row.to != place)
                continue;
            seen.from.push_back(place_of<double>(id_, scene, id_.poses[row.pose], row.target, x_));
            seen.distances.push_back(row.value);
        }
        return seen;
    }

    /// |p|² − L² = 2 p·o + (z² − o·o) − 2 L z: linear in the point o, its square, and a zero z.
    void start_point(std::size_t place) {
        const Seen seen = seen_from(place);
        const auto n = static_cast<Index>(seen.from.size());
        if (n < 4) return;
        const Eigen::Vector3d middle = mean(seen.from);
        const bool zero =
            std::ranges::any_of(id_.rows, [&](const Row& r) { return r.to == place && r.zero != nothing; });
        MatrixXd A(n, zero ? 5 : 4);
        VectorXd b(n);
        for (Index k = 0; k < n; ++k) {
            const Eigen::Vector3d p = seen.from[static_cast<std::size_t>(k)] - middle;
            const double L = seen.distances[static_cast<std::size_t>(k)];
            A.row(k).head<3>() = 2.0 * p.transpose();
            A(k, 3) = 1.0;
            if (zero) A(k, 4) = -2.0 * L;
            b[k] = p.squaredNorm() - L * L;
        }
        const VectorXd solution = A.colPivHouseholderQr().solve(b);
        if (solution.allFinite()) id_.fixed_places[place].p = middle + solution.head<3>();
    }

    static Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : points) sum += p;
        return sum / static_cast<double>(points.size());
    }

    /// p·n − h = distance by least squares, linear in n and h where distances differ; the plane of least
    /// squares through the places where they do not.
    void start_plane(std::size_t k) {
        const Seen seen = seen_from(k);
        if (seen.from.size() < 3) return;
        Place& place = id_.fixed_places[k];
        const Eigen::Vector3d middle = mean(seen.from);
        Eigen::Vector3d normal = plane_by_touches(seen, middle);
        if (id_.places[k].normal[0] || id_.places[k].normal[1] || id_.places[k].normal[2])
            normal = place.axes.col(2);
        for (int step = 0; step < 50; ++step) {
            Eigen::Vector3d moved = Eigen::Vector3d::Zero();
            if (!improve(seen, middle, normal, moved)) break;
            if (moved.norm() < 1e-9) break;
        }
        double offset = 0.0;
        for (std::size_t i = 0; i < seen.from.size(); ++i)
            offset += (normal.dot(seen.from[i] - middle) - seen.distances[i]) /
                      static_cast<double>(seen.from.size());
        place.p = middle + offset * normal;
        const Eigen::Vector3d along = normal.unitOrthogonal();
        place.axes << along, normal.cross(along), normal;
    }

    static Eigen::Vector3d plane_by_touches(const Seen& seen, const Eigen::Vector3d& middle) {
        Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
        Eigen::Vector3d towards = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < seen.from.size(); ++i) {
            const Eigen::Vector3d p = seen.from[i] - middle;
            M += p * p.transpose();
            towards += p * seen.distances[i];
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(M);
        const Eigen::Vector3d thin = solver.eigenvectors().col(0);
        const double spread = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
        const Eigen::Vector3d steep = M.ldlt().solve(towards);  // gradient of the distance
        const bool touches = towards.norm() < 1e-3 * spread * std::sqrt(M.trace());
        if (!touches && steep.allFinite() && steep.norm() > 0.5) return steep.normalized();
        return thin.dot(middle) < 0.0 ? Eigen::Vector3d(thin) : Eigen::Vector3d(-thin);
    }

    /// A step of Gauss and Newton for the two tilts and the offset of a plane.
    static bool improve(const Seen& seen, const Eigen::Vector3d& middle, Eigen::Vector3d& normal,
                        Eigen::Vector3d& moved) {
        const Eigen::Vector3d a = normal.unitOrthogonal(), b = normal.cross(a);
        Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
        Eigen::Vector3d g = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < seen.from.size(); ++i) {
            const Eigen::Vector3d p = seen.from[i] - middle, row(a.dot(p), b.dot(p), -1.0);
            N += row * row.transpose();
            g += row * (seen.distances[i] - normal.dot(p));
        }
        const Eigen::LDLT<Eigen::Matrix3d> factor(N);
        moved = factor.solve(g);
        if (factor.info() != Eigen::Success || !moved.allFinite()) return false;
        normal = (normal + moved[0] * a + moved[1] * b).normalized();
        return true;
    }

    Identification& id_;
    std::vector<double> x_;
};

}  // namespace

std::vector<double> values_of(const Identification& id) {
    std::vector<double> v;
    for (const Unknown& u : id.unknowns) {
        const auto k = static_cast<Index>(u.coordinate);
        switch (u.kind) {
            case UnknownKind::base:
                v.push_back(k < 3 ? id.X_MB.translation()[k] : 0.0);
                break;
            case UnknownKind::place:
                v.push_back(id.fixed_places[u.of].plane ? 0.0 : id.fixed_places[u.of].p[k]);
                break;
            case UnknownKind::target:
                v.push_back(id.arm_targets[u.of].p_F[k]);
                break;
            case UnknownKind::parameter:
                v.push_back(id.robot().joints()[u.of].values[u.parameter]);
                break;
            case UnknownKind::zero:
            case UnknownKind::compliance:
                v.push_back(0.0);
                break;
        }
    }
    return v;
}

void find_start(Identification& id) {
    StartOfSearch(id).find();
}

}  // namespace covaria::reading_identification
