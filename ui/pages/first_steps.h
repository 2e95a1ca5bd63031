// The first steps of a newcomer: an everyday budget from nothing to a PDF, as a table.
#pragma once

#include <array>

namespace covaria::ui {

/// Steps that are taken, as far as project and window show it.
struct StepsTaken {
    bool has_budget = false;  ///< an analysis into which a budget is typed
    bool has_quantity = false;
    bool has_statement = false;
    bool has_result = false;
    bool has_correlation = false;
    bool has_requirement = false;
    bool seen_chart = false;
    bool kept = false;
    bool seen_report = false;
    bool exported = false;
};

struct FirstStep {
    const char* title;       ///< English; `tr` in covaria::ui translates it
    const char* text;        ///< English likewise; two sentences
    const char* target;      ///< name of the widget that is meant
    const char* focus;       ///< name of the widget that gets the focus; null: the target itself
    bool StepsTaken::*done;  ///< the fact that says the step is done
};

/// The steps in their order. resources/help/first-steps.md has the same words.
const std::array<FirstStep, 10>& first_steps();

}  // namespace covaria::ui
