// What the window shows without a project: new, open, recent files, examples with pictures.
#pragma once

#include <QStringList>
#include <QWidget>

class QGridLayout;
class QVBoxLayout;

namespace covaria::ui {

class ExampleCard;

class StartPage : public QWidget {
    Q_OBJECT
public:
    explicit StartPage(QWidget* parent = nullptr);
    void set_recent_files(const QStringList& files);

signals:
    void new_wanted();
    void open_wanted();
    void library_wanted();
    void first_steps_wanted();
    void file_wanted(const QString& file);
    /// Opens as a new project, so that the shipped file stays as it is.
    void example_wanted(const QString& file);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* make_actions();
    QWidget* make_examples();
    void add_worked_examples(QVBoxLayout& column);
    void place_cards(int in_a_row);

    QVBoxLayout* recent_ = nullptr;
    QGridLayout* examples_ = nullptr;
    QList<ExampleCard*> cards_;
    int in_a_row_ = 0;
};

}  // namespace covaria::ui
