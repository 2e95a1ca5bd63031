// Ctrl+K: everything in the window and in the project that has a name.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

class QMainWindow;
class QMenu;

namespace covaria::ui {

class Document;
class HelpActions;
class PropertiesPane;
class ResultsPane;
class SearchPalette;
class Selection;
struct Findable;
struct SetupAddress;

class SearchActions : public QObject {
    Q_OBJECT
public:
    /// `go_to`: leads to a field, by its JSON pointer into the project.
    SearchActions(QMainWindow& window, Document& document, Selection& selection, ResultsPane& results,
                  PropertiesPane& properties, HelpActions& help,
                  std::function<void(const QString& path)> go_to);

    void add_to(QMenu& menu);
    SearchPalette& palette() { return *palette_; }

private:
    std::vector<Findable> findables();
    void add_commands(const QMenu& menu, std::vector<Findable>& all) const;
    void add_entry(const SetupAddress& entry, const std::string& name, const QString& kind,
                   std::vector<Findable>& all) const;
    void add_quantities(const std::string& analysis, const QString& name, std::vector<Findable>& all) const;
    void add_tabs(std::vector<Findable>& all) const;
    void add_help(std::vector<Findable>& all) const;

    QMainWindow& window_;
    Document& document_;
    Selection& selection_;
    ResultsPane& results_;
    PropertiesPane& properties_;
    HelpActions& help_;
    std::function<void(const QString&)> go_to_;
    SearchPalette* palette_;
};

}  // namespace covaria::ui
