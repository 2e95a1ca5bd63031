// The window without a project: five questions, recent projects, examples.
#pragma once

#include <QStringList>
#include <QWidget>

#include "core/made/analysis_templates.h"

class QGridLayout;
class QHBoxLayout;
class QMenu;
class QToolButton;
class QVBoxLayout;

namespace covaria::ui {

class QuestionTile;

/// A tile leads to an analysis that has results in two clicks.
class StartPage : public QWidget {
    Q_OBJECT
public:
    explicit StartPage(QWidget* parent = nullptr);
    void set_recent_files(const QStringList& files);
    const QList<QuestionTile*>& tiles() const { return tiles_; }

signals:
    void new_wanted();
    void open_wanted();
    void import_wanted();
    void urdf_wanted();
    void library_wanted();
    void first_steps_wanted();
    void file_wanted(const QString& file);
    /// The example is wanted as a new project, so that the shipped file stays as it is.
    void example_wanted(const QString& file);
    void template_wanted(const covaria::AnalysisTemplate& wanted);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QHBoxLayout* make_head();
    QHBoxLayout* make_head_of_recent();
    QHBoxLayout* make_tiles();
    void add_tile(QHBoxLayout& row, QuestionTile* tile);
    QMenu* menu_of(AnalysisTemplate::Topic topic);
    QMenu* menu_of_files();
    static int columns_of(const QList<QWidget*>& buttons);
    void add_examples(QVBoxLayout& column);

    QGridLayout* recent_ = nullptr;
    QToolButton* all_recent_ = nullptr;  ///< lists those that have no card
    QList<QuestionTile*> tiles_;
};

}  // namespace covaria::ui
