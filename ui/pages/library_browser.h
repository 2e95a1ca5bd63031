// Everything that can be begun from: templates of analyses, shipped examples, the assets of the library, with
// search and pictures.
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "core/made/analysis_templates.h"
#include "core/project/project.h"

class QLineEdit;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace covaria::ui {

class LibraryBrowser : public QDialog {
    Q_OBJECT
public:
    explicit LibraryBrowser(QWidget* parent = nullptr);

    /// Reads library and examples anew.
    void fill();
    /// Shows one collection by its title; all for an empty one.
    void show_collection(const QString& title);

    QLineEdit& search() { return *search_; }
    QListWidget& collections() { return *collections_; }
    QListWidget& cards() { return *cards_; }
    QTextBrowser& details() { return *details_; }
    QPushButton& take_button() { return *take_; }
    static QString templates_title();
    static QString examples_title();

signals:
    /// The example is wanted as a new project.
    void example_wanted(const QString& file);
    void template_wanted(const covaria::AnalysisTemplate& wanted);
    void asset_wanted(const covaria::AssetEntry& asset);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Entry {
        QString title, collection, summary, notes, picture, icon;
        QString example = {};                        ///< path of its file
        const AnalysisTemplate* analysis = nullptr;  ///< the template it stands for
        std::optional<AssetEntry> asset = {};
        std::vector<std::string> texts = {};  ///< searched ones: shown and English, folded
    };
    void add_templates();
    void add_examples(const std::string& subfolder, const QString& collection);
    void add_assets();
    void refresh_cards();
    void refresh_details();
    void take();
    const Entry* current() const;

    std::vector<Entry> entries_;
    QLineEdit* search_;
    QListWidget* collections_;
    QListWidget* cards_;
    QTextBrowser* details_;
    QPushButton* take_;
};

}  // namespace covaria::ui
