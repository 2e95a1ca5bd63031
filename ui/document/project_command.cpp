// Merging of steps that belong together.
#include "ui/document/project_command.h"

namespace covaria::ui {

ProjectCommand::ProjectCommand(Document& document, const QString& text, ProjectSnapshot after, Merge merge)
    : QUndoCommand(text),
      document_(document),
      before_(document.kept_),
      after_(KeptProject::keep(*after, before_.get())),
      merge_(std::move(merge)) {
    age_.start();
}

bool ProjectCommand::mergeWith(const QUndoCommand* other) {
    const auto* next = static_cast<const ProjectCommand*>(other);
    const bool belongs = next->merge_.key == merge_.key && next->merge_.series == merge_.series &&
                         age_.elapsed() <= merge_.window;
    if (!belongs) return false;
    after_ = next->after_;
    age_.restart();
    setObsolete(*after_ == *before_);
    return true;
}

}  // namespace covaria::ui
