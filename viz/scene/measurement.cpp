// Distances and angles between items of a scene, by the joint covariance of the result that it shows.
#include "viz/scene/measurement.h"

#include <algorithm>

#include "core/result/point_measures.h"
#include "viz/scene/pick.h"

namespace covaria {
namespace {

const PointCoordinates* coordinates_in(const Scene& scene, const std::string& id) {
    for (const ScenePoint& point : scene.points)
        if (point.item.id == id && point.coordinates) return &*point.coordinates;
    return nullptr;
}

PointMeasure measured(const std::vector<Eigen::Vector3d>& at, const Eigen::MatrixXd& covariance) {
    return at.size() == 2 ? measured_distance(at[0], at[1], covariance)
                          : measured_angle(at[0], at[1], at[2], covariance);
}

void refuse(Measurement& made, NotStated reason, std::size_t place) {
    made.reason = reason;
    made.place = made.names[place];
}

/// u of a measurement between places that are all quantities of the result.
void add_uncertainty(Measurement& made, const UncertaintyResult& result,
                     const std::vector<PointCoordinates>& points) {
    const auto covariance = JointCovariance(result).of(points);
    if (!covariance) {
        made.reason = NotStated::not_finite;
        return;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        if (covariance->block<3, 3>(row, row).isZero(0)) return refuse(made, NotStated::constant, i);
    }
    const PointMeasure measure = measured(made.at, *covariance);
    if (measure.linear)
        made.u = measure.standard_uncertainty;
    else
        made.reason = NotStated::not_linear;
}

}  // namespace

std::optional<std::string> place_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                    const std::function<bool(Layer)>& shown, double reach) {
    const auto is_place = [&](Layer layer) {
        return (layer == Layer::points || layer == Layer::frames) && shown(layer);
    };
    return pick_item(scene, camera, size, pixel, is_place, reach);
}

std::optional<Measurement> measure(const Scene& scene, const UncertaintyResult* result,
                                   const std::vector<std::string>& ids) {
    if (ids.size() != 2 && ids.size() != 3) return std::nullopt;
    Measurement made;
    std::vector<PointCoordinates> points;
    std::optional<std::size_t> unknown;
    for (const std::string& id : ids) {
        const SceneItem* item = find_item(scene, id);
        if (!item) return std::nullopt;
        made.names.push_back(name_of(*item));
        made.at.push_back(item->position);
        const PointCoordinates* coordinates = coordinates_in(scene, id);
        if (coordinates)
            points.push_back(*coordinates);
        else if (!unknown)
            unknown = made.names.size() - 1;
    }
    const auto count = static_cast<Eigen::Index>(3 * ids.size());
    made.value = measured(made.at, Eigen::MatrixXd::Zero(count, count)).value;
    if (!result)
        made.reason = NotStated::no_result;
    else if (unknown)
        refuse(made, NotStated::no_quantities, *unknown);
    else
        add_uncertainty(made, *result, points);
    return made;
}

}  // namespace covaria
