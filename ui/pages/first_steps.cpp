#include "ui/pages/first_steps.h"

#include <QtGlobal>

namespace covaria::ui {

const std::array<FirstStep, 10>& first_steps() {
    static const std::array<FirstStep, 10> steps{{
        {QT_TR_NOOP("Add an analysis"),
         QT_TR_NOOP("The plus sign in the toolbar adds what a project consists of. Choose Measurement "
                    "equation from its menu."),
         "add_button", nullptr, &StepsTaken::has_budget},
        {QT_TR_NOOP("Name the quantities"),
         QT_TR_NOOP("Replace the equation in the field Equations by yours, such as l = l_S + d. Every name "
                    "that it uses becomes a row of the budget when you leave the field."),
         "equations", nullptr, &StepsTaken::has_quantity},
        {QT_TR_NOOP("State an uncertainty"),
         QT_TR_NOOP("Type the estimate of each quantity into its row, such as 50 mm, and what is known of "
                    "it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as "
                    "they are typed."),
         "budget", nullptr, &StepsTaken::has_statement},
        {QT_TR_NOOP("See the result"),
         QT_TR_NOOP("The result is there when every quantity has its uncertainty, above the budget and in "
                    "the tab Results. It follows every change at once."),
         "results_table", nullptr, &StepsTaken::has_result},
        {QT_TR_NOOP("Correlate two quantities"),
         QT_TR_NOOP("Select two rows of the budget, the second with Ctrl, and type their correlation "
                    "coefficient r into the field below, such as 0.5. The result takes it into account at "
                    "once."),
         "correlation", "budget", &StepsTaken::has_correlation},
        {QT_TR_NOOP("State a requirement"),
         QT_TR_NOOP("Type the uncertainty that must not be exceeded as Target uncertainty. The verdict "
                    "below it, and in the table of results, follows every change."),
         "targetUncertainty", nullptr, &StepsTaken::has_requirement},
        {QT_TR_NOOP("See what contributes most"),
         QT_TR_NOOP("The tab Contributions has them as a table and as a chart, the largest first. "
                    "What is at the top is worth improving."),
         "contributions_chart", nullptr, &StepsTaken::seen_chart},
        {QT_TR_NOOP("Keep and compare"),
         QT_TR_NOOP("Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab "
                    "Compare shows the results before and after beside each other."),
         "keep_before_button", nullptr, &StepsTaken::kept},
        {QT_TR_NOOP("Look at the report"),
         QT_TR_NOOP("The tab Document shows the pages as they are printed, of the report or of the "
                    "certificate. It has results that are up to date only: run the analysis first (F5)."),
         "report_pages", nullptr, &StepsTaken::seen_report},
        {QT_TR_NOOP("Save it as PDF"),
         QT_TR_NOOP(
             "Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that "
             "Covaria can open it again. While the tab Document shows the certificate, the button writes "
             "that; it is also in the menu File under Export."),
         "export_pdf_button", nullptr, &StepsTaken::exported},
    }};
    return steps;
}

}  // namespace covaria::ui
