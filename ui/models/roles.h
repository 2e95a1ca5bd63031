// Roles of Covaria's item models beyond those of Qt.
#pragma once

#include <Qt>

namespace covaria::ui {

enum Role : int {
    sort_role = Qt::UserRole + 1,  ///< the number or text to sort by
    path_role,                     ///< JSON pointer into the project
    id_role,          ///< id of an asset or analysis; symbol of a quantity; head of a column without its unit
    state_role,       ///< int of RunState
    category_role,    ///< category of a row of the project tree
    problem_role,     ///< problem of the item, in words; empty when there is none
    severity_role,    ///< int of Severity
    worst_role,       ///< int of Severity: of the problems that problem_role says
    incomplete_role,  ///< bool: nothing is wrong with it, but something that must be given is not
    choices_role,     ///< QStringList of what the cell may be set to
    group_role,       ///< name of the group of an output or input quantity ("pose 7")
    exact_role,       ///< double: the number of the cell with full precision; QString: the whole of a text
                      ///< that is shown shorter; invalid: what is shown is exact
    verdict_role,     ///< how many requirements of an analysis are not met, in words; empty: none
    help_role,        ///< anchor of the item's help on its page
    index_role,       ///< index among the result's outputs
    count_role,       ///< int: how many requirements are not met, or what is missing; 0: no number is shown
    met_role,         ///< bool: all that is required of an analysis is met
    icon_role,        ///< name of an icon: of the model of an analysis
    shape_role,       ///< title of a distribution, in English
    hint_role,        ///< what may be typed into an empty cell, shown faint
    fraction_role,    ///< double, 0 to 1: of the largest share of a budget
};

}  // namespace covaria::ui
