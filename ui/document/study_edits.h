// Adding, changing and removing studies of an analysis, each as one undo step.
#pragma once

#include <functional>
#include <string>

#include "ui/document/document.h"

namespace covaria::ui {

/// Id of the new study: it varies the first number that the analysis offers.
std::string add_study(Document& document, const std::string& analysis);
std::string duplicate_study(Document& document, const std::string& analysis, const std::string& study);
void remove_study(Document& document, const std::string& analysis, const std::string& study);
/// `merge_key`: changes of one field that follow each other closely are one step.
void change_study(Document& document, const std::string& analysis, const std::string& study,
                  const std::function<void(Study&)>& edit, const QString& merge_key = {});
/// Null when there is none.
const Study* find_study(const Project& project, const std::string& analysis, const std::string& study);

}  // namespace covaria::ui
