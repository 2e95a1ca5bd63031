// Positions and orientations changed by dragging things in a picture.
#pragma once

#include <QString>

#include "core/model/layout.h"
#include "ui/document/document.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

struct ItemMove {
    QString name;         ///< the item's name, for the undo list
    LayoutSource source;  ///< the place that states its position
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    double step = 1e-3;  ///< the position is meant to this, m
};

/// Moves of one thing that follow each other merge into one undo step, until `Document::end_merging`.
/// False where the entry has no such position or it stays where it was.
bool move_item(Document& document, const SetupAddress& entry, const ItemMove& move);

/// Place in the project of the coordinates of what a picture shows: the cell of x in its row, or the pose;
/// empty where no field of the entry gives them.
QString place_of_coordinates(const Project& project, const SetupAddress& entry, const LayoutSource& source);

struct ItemTurn {
    QString name;
    LayoutSource source;  ///< the place that states its pose
    Eigen::Matrix3d R_WF = Eigen::Matrix3d::Identity();
    double step = 1e-3;  ///< the orientation is meant to this, rad
};

/// Turns of one thing merge and fail as moves do.
bool turn_item(Document& document, const SetupAddress& entry, const ItemTurn& turn);

}  // namespace covaria::ui
