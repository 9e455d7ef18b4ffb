// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/tool.h"

#include "widgets/look/grid.h"

#include <QAction>
#include <QEvent>
#include <QToolBar>

namespace codewheel {
namespace {

// A tool bar without room for all its words shows only icons, so that no button is out of sight.
class ToolWords final : public QObject
{
public:
    explicit ToolWords(QToolBar &bar)
        : QObject(&bar)
        , m_bar(bar)
    {
        bar.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
            fit();
        return QObject::eventFilter(watched, event);
    }

private:
    void fit()
    {
        const bool hasWords = m_bar.toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
        if (hasWords)
            m_withWords = m_bar.sizeHint().width();
        const bool fits = m_bar.width() >= m_withWords;
        if (fits != hasWords)
            m_bar.setToolButtonStyle(fits ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }

    QToolBar &m_bar;
    int m_withWords = 0; // its width when it last had them
};

} // namespace

QAction *addTool(QWidget &view, QToolBar &bar, const Tool &tool)
{
    auto *action = new QAction(lineIcon(tool.icon), tool.text, &view);
    action->setShortcut(tool.key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(tool.tip, tool.key.toString(QKeySequence::NativeText)));
    view.addAction(action);
    bar.addAction(action);
    return action;
}

void setUpToolBar(QToolBar &bar)
{
    bar.setIconSize({grid::smallIcon, grid::smallIcon});
    bar.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar.setSizePolicy(QSizePolicy::Expanding,
                      QSizePolicy::Fixed); // with icons only, it would never get room for words
    new ToolWords(bar);
}

} // namespace codewheel
