#include "ui/document/item_move.h"

#include "core/setup/position_edit.h"

namespace covaria::ui {

bool move_item(Document& document, const SetupAddress& entry, const ItemMove& move) {
    const Eigen::Vector3d p_S = move.source.X_WS.inverse() * move.p_W;
    const std::string& path = move.source.path;
    return document.apply(
        QObject::tr("Move %1").arg(move.name),
        [&](Project& project) {
            Setup* setup = find_setup(project, entry);
            const SetupSchema* schema = find_schema(project, entry);
            if (setup && schema) write_position(*schema, *setup, path, p_S, move.step);
        },
        QStringLiteral("move:%1%2").arg(QString::fromStdString(entry.id), QString::fromStdString(path)));
}

QString place_of_coordinates(const Project& project, const SetupAddress& entry, const LayoutSource& source) {
    const SetupSchema* schema = find_schema(project, entry);
    if (!schema || source.path.empty()) return {};
    const FieldSpec* field = schema->find(source.path.substr(1, source.path.find('/', 1) - 1));
    if (!field) return {};
    std::string place = setup_path(project, entry) + source.path;
    for (std::size_t c = 0; c < field->columns.size(); ++c)
        if (field->columns[c].key == "x") place += "/" + std::to_string(c);
    return QString::fromStdString(place);
}

bool turn_item(Document& document, const SetupAddress& entry, const ItemTurn& turn) {
    const Eigen::Matrix3d R_SF = turn.source.X_WS.linear().transpose() * turn.R_WF;
    const std::string& path = turn.source.path;
    return document.apply(
        QObject::tr("Turn %1").arg(turn.name),
        [&](Project& project) {
            Setup* setup = find_setup(project, entry);
            const SetupSchema* schema = find_schema(project, entry);
            if (setup && schema) write_orientation(*schema, *setup, path, R_SF, turn.step);
        },
        QStringLiteral("turn:%1%2").arg(QString::fromStdString(entry.id), QString::fromStdString(path)));
}

}  // namespace covaria::ui
