// Tables without frame and grid: a line below the head and thin ones below the rows, which the style draws.
#pragma once

class QTableView;

namespace covaria::ui {

/// px above and below the text of a row: 28 px high on the stage, 24 in the inspector, at the usual size.
enum class RowRoom { stage = 12, inspector = 8 };
/// Rows grow with the font of the view.
void make_quiet(QTableView& view, RowRoom room = RowRoom::stage);

}  // namespace covaria::ui
