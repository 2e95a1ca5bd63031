// Tables, heads and lists whose symbols have real subscripts. What a model displays is plain text, for
// copying and for screen readers; `typeset_role` gives the text with its scripts.
#pragma once

#include <QComboBox>
#include <QHeaderView>

#include "ui/theme/label_text.h"
#include "ui/theme/steady_delegate.h"

namespace covaria::ui {

/// Property of a view and of its head: px at its left that lie under something else.
inline constexpr char covered_width[] = "covered_width";

/// Cells: subscripts, and figures of equal width where numbers stand to the right.
class TypesetDelegate : public SteadyDelegate {
public:
    /// Names differ at their end ("... of P12, azimuth"): what has no room loses its middle, else what
    /// `elide` says.
    explicit TypesetDelegate(QObject* parent = nullptr, Qt::TextElideMode elide = Qt::ElideMiddle);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Shows a text that has no room in its cell whole, before the cell's own help.
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    Qt::TextElideMode elide_;
};

class TypesetHeader : public QHeaderView {
public:
    explicit TypesetHeader(Qt::Orientation orientation, QWidget* parent = nullptr);

protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override;
    void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override;
    QSize sectionSizeFromContents(int section) const override;

private:
    Text text_of(int section) const;
    /// Whether a head is drawn by hand: with scripts, or cut by the edge of the view.
    bool draws_text(int section) const;
};

/// A combo box with typeset entries, in its list too.
class TypesetComboBox : public QComboBox {
public:
    explicit TypesetComboBox(QWidget* parent = nullptr);
    void add_item(const Text& text, const QVariant& data = {});

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace covaria::ui
