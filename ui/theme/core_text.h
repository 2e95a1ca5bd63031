// Texts that are declared in core (titles, help, choices, heads of tables), in the language of the window.
// The only place that translates them: context "core" of the catalogues, filled from the registries by
// app/texts.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/plot_specification.h"
#include "core/text/text.h"

namespace covaria::ui {

inline constexpr const char* core_context = "core";

/// Text of the core in the window's language; names and symbols that no catalogue has stay as they are.
QString core_text(std::string_view english);
/// The same as UTF-8.
std::string core_words(std::string_view english);
/// The same for a title; one with scripts stays as it is.
Text core_title(const Text& english);
/// The charts of models and assets in the window's language: titles, axes, legends, marks.
std::vector<PlotSpecification> core_plots(std::vector<PlotSpecification> english);

}  // namespace covaria::ui
