// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/cut_off.h"

#include "tests/support/painted_texts.h"
#include "widgets/look/may_elide.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTextEdit>
#include <QToolBar>

#include <algorithm>

namespace codewheel::test {
namespace {

constexpr qreal hair = 1.5; // px by which the parts of a text may be wider than the whole
const QChar dots(0x2026);

// The directions in which the content of a viewport can be scrolled.
struct Scrolled
{
    bool across = false;
    bool along = false;
};

bool canScroll(const QScrollBar &bar, Qt::ScrollBarPolicy policy)
{
    return policy != Qt::ScrollBarAlwaysOff && bar.maximum() > bar.minimum();
}

// A table of many columns is looked along; a form, a card or a log that goes on beyond its edge is not.
bool mayGoOnAcross(const QAbstractScrollArea &area)
{
    constexpr int many = 9;
    const auto *table = qobject_cast<const QTableView *>(&area);
    const bool isLog = area.inherits("codewheel::LogTable") &&
                       (table->model() == nullptr || table->model()->columnCount() < many);
    return qobject_cast<const QScrollArea *>(&area) == nullptr && !isLog;
}

Scrolled scrolled(const QWidget &widget)
{
    const auto *area = qobject_cast<const QAbstractScrollArea *>(widget.parentWidget());
    if (area == nullptr || area->viewport() != &widget)
        return {};
    if (qobject_cast<const QHeaderView *>(area) != nullptr) // goes with its table
        if (const auto *table = qobject_cast<const QAbstractScrollArea *>(area->parentWidget()))
            area = table;
    const bool isLaidOutLater = qobject_cast<const QTextEdit *>(area) != nullptr; // a long page, bit by bit
    return {mayGoOnAcross(*area) &&
                canScroll(*area->horizontalScrollBar(), area->horizontalScrollBarPolicy()),
            isLaidOutLater || canScroll(*area->verticalScrollBar(), area->verticalScrollBarPolicy())};
}

bool isWithin(const QRectF &ink, const QRectF &room, const Scrolled &by)
{
    const bool across = by.across || (ink.left() >= room.left() - hair && ink.right() <= room.right() + hair);
    const bool along = by.along || (ink.top() >= room.top() - hair && ink.bottom() <= room.bottom() + hair);
    return across && along;
}

// By the ancestors of `widget`, up to one that scrolls.
bool isClippedFromOutside(const QWidget &widget, const QRectF &ink)
{
    Scrolled by = scrolled(widget);
    for (const QWidget *in = &widget; !in->isWindow(); in = in->parentWidget()) {
        const Scrolled its = scrolled(*in->parentWidget());
        by.across = by.across || its.across;
        by.along = by.along || its.along;
        const QWidget *outside = in->parentWidget();
        const QPointF place = in == &widget ? QPointF() : QPointF(widget.mapTo(in, QPoint()));
        const QRectF there = ink.translated(place + QPointF(in->pos()));
        if (!isWithin(there, outside->rect(), by))
            return true;
    }
    return false;
}

bool mayBeElided(const QWidget &widget, const QRectF &ink)
{
    for (const QWidget *in : {&widget, static_cast<const QWidget *>(widget.parentWidget())}) {
        if (in == nullptr)
            continue;
        if (mayElide(*in))
            return true;
        if (const auto *view = qobject_cast<const QAbstractItemView *>(in);
            view != nullptr && view->viewport() == &widget &&
            mayElide(*view, view->indexAt(ink.center().toPoint()).column()))
            return true;
    }
    return false;
}

// A delegate may paint outside its cell.
bool isOutsideOfItsCell(const QWidget &widget, const QRectF &ink)
{
    const auto *view = qobject_cast<const QAbstractItemView *>(widget.parentWidget());
    if (view == nullptr || view->viewport() != &widget || qobject_cast<const QHeaderView *>(view) != nullptr)
        return false;
    const QModelIndex index = view->indexAt(ink.center().toPoint());
    return index.isValid() && !isWithin(ink, view->visualRect(index), {});
}

class Walk
{
public:
    std::vector<QString> found;

    void look(QWidget &widget)
    {
        lookAtTexts(widget);
        lookAtSize(widget);
        if (auto *area = qobject_cast<QAbstractScrollArea *>(&widget))
            lookAcross(*area);
        if (auto *box = qobject_cast<QComboBox *>(&widget))
            lookAtItems(*box);
        if (auto *bar = qobject_cast<QTabBar *>(&widget))
            lookAtTabs(*bar);
        if (auto *label = qobject_cast<QLabel *>(&widget))
            lookAtLines(*label);
        if (widget.objectName() == QStringLiteral("qt_toolbar_ext_button") ||
            widget.objectName() == QStringLiteral("qt_menubar_ext_button"))
            tell(*widget.parentWidget(), QStringLiteral("has no room for all of its actions"));
    }

private:
    void tell(const QWidget &widget, const QString &what)
    {
        QString path;
        for (const QWidget *in = &widget; in != nullptr && path.count(QLatin1Char('<')) < 3;
             in = in->parentWidget())
            path += QStringLiteral(" < %1 \"%2\"")
                        .arg(QLatin1String(in->metaObject()->className()),
                             in->objectName().isEmpty() ? in->accessibleName() : in->objectName());
        found.push_back(what + path);
    }

    void lookAtTexts(QWidget &widget)
    {
        if (qobject_cast<const QStatusBar *>(&widget) != nullptr)
            return; // draws its hint below the widget that shows it
        const Scrolled by = scrolled(widget);
        for (const PaintedText &painted : paintedTexts(widget)) {
            const auto *button = qobject_cast<const QAbstractButton *>(&widget);
            const bool isItsOwn = button != nullptr && button->text().contains(dots);
            if (painted.text.contains(dots) && !isItsOwn && !mayBeElided(widget, painted.ink))
                tell(widget, QStringLiteral("elided: \"%1\"").arg(painted.text));
            else if (!isWithin(painted.ink, painted.room, by) || isOutsideOfItsCell(widget, painted.ink) ||
                     isClippedFromOutside(widget, painted.ink))
                tell(widget, QStringLiteral("clipped: \"%1\"").arg(painted.text));
        }
    }

    // Qt's own widgets ask for room they do not paint in.
    void lookAtSize(const QWidget &widget)
    {
        const bool isPaintedByUs = QByteArrayView(widget.metaObject()->className()).startsWith("codewheel::");
        if (!isPaintedByUs || qobject_cast<const QLineEdit *>(&widget) != nullptr ||
            qobject_cast<const QAbstractScrollArea *>(&widget) != nullptr)
            return;
        const QSize least = widget.minimumSizeHint();
        const QSizePolicy policy = widget.sizePolicy();
        if ((policy.horizontalPolicy() != QSizePolicy::Ignored && widget.width() < least.width()) ||
            (policy.verticalPolicy() != QSizePolicy::Ignored && widget.height() < least.height()))
            tell(widget, QStringLiteral("is %1 x %2 and needs %3 x %4")
                             .arg(widget.width())
                             .arg(widget.height())
                             .arg(least.width())
                             .arg(least.height()));
    }

    // What is beyond its edge is not painted.
    void lookAcross(const QAbstractScrollArea &area)
    {
        const QScrollBar &bar = *area.horizontalScrollBar();
        if (!mayGoOnAcross(area) && bar.maximum() > bar.minimum())
            tell(area, QStringLiteral("goes on beyond its edge by %1").arg(bar.maximum() - bar.minimum()));
    }

    void lookAtItems(const QComboBox &box)
    {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.editable = box.isEditable();
        const int room =
            box.style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
                .width();
        for (int i = 0; i < box.count(); ++i) {
            const int icon = box.itemIcon(i).isNull() ? 0 : box.iconSize().width() + 4;
            if (box.fontMetrics().horizontalAdvance(box.itemText(i)) + icon > room + hair && !mayElide(box))
                tell(box, QStringLiteral("too narrow for \"%1\"").arg(box.itemText(i)));
        }
    }

    void lookAtTabs(const QTabBar &bar)
    {
        for (int i = 0; i < bar.count(); ++i)
            if (bar.isTabVisible(i) && !bar.rect().contains(bar.tabRect(i)))
                tell(bar, QStringLiteral("tab out of sight: \"%1\"").arg(bar.tabText(i)));
    }

    void lookAtLines(const QLabel &label)
    {
        if (label.wordWrap() && label.heightForWidth(label.width()) > label.height())
            tell(label, QStringLiteral("too low for \"%1\"").arg(label.text()));
    }
};

// A dock behind another one counts as visible, but lies outside the window.
bool isBehind(const QWidget &widget)
{
    for (const QWidget *in = &widget; !in->isWindow(); in = in->parentWidget())
        if (qobject_cast<const QDockWidget *>(in) != nullptr)
            return !in->parentWidget()->rect().intersects(in->geometry());
    return false;
}

} // namespace

std::vector<QString> cutOff(QWidget &part)
{
    Walk walk;
    walk.look(part);
    for (auto *widget : part.findChildren<QWidget *>())
        if (widget->isVisible() && widget->window() == part.window() && !isBehind(*widget))
            walk.look(*widget);
    return std::move(walk.found);
}

} // namespace codewheel::test
