// Pictures of the scenes that a report asks for.
#pragma once

#include <QImage>
#include <QSize>
#include <vector>

#include "core/model/layout.h"
#include "core/report/report.h"

namespace covaria::ui {

/// Draws scenes of evaluated analyses off screen, in the language of the project, with one renderer for all
/// of them. Usable on any thread.
class ScenePictures {
public:
    /// `source` must outlive this object.
    explicit ScenePictures(const ReportSource& source);
    ~ScenePictures();

    /// A null image if the block names an unknown analysis or the machine cannot render; `problem` then says
    /// why.
    QImage render(const SceneBlock& block, QSize size);
    const Message& problem() const { return problem_; }
    const DocumentLanguage& language() const { return language_; }

private:
    struct Renderer;
    const MadeProject& made_;
    const std::vector<EvaluatedAnalysis>& analyses_;
    std::vector<LayoutMesh> context_;
    std::unique_ptr<Renderer> renderer_;
    DocumentLanguage language_;
    Message problem_;
};

}  // namespace covaria::ui
