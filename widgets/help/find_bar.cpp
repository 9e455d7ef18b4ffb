// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/find_bar.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace codewheel {
namespace {

QToolButton *makeFindButton(Icon icon, const QString &name, const QString &tip)
{
    auto *button = describe(new QToolButton, name, tip);
    button->setIcon(lineIcon(icon));
    button->setAutoRaise(true);
    return button;
}

} // namespace

FindBar::FindBar(QWidget *parent)
    : QWidget(parent)
    , m_text(describe(new QLineEdit, "helpFind", tr("Find in this page"),
                      tr("Marks this text wherever it stands on the page")))
    , m_result(new QLabel)
{
    m_text->setPlaceholderText(tr("Find in this page"));
    m_result->setObjectName(QStringLiteral("helpFindResult"));
    auto *previous = makeFindButton(Icon::up, tr("Previous"), tr("The previous one (Shift+F3)"));
    auto *next = makeFindButton(Icon::down, tr("Next"), tr("The next one (F3)"));
    auto *end = makeFindButton(Icon::cancel, tr("Close"), tr("Ends the search (Esc)"));
    layOutRow(this, {{m_text, 1}, previous, next, m_result, Stretch{1}, end},
              {grid::unit, allAround(grid::unit)});
    connect(m_text, &QLineEdit::textChanged, this, &FindBar::changed);
    connect(previous, &QToolButton::clicked, this, &FindBar::previousRequested);
    connect(next, &QToolButton::clicked, this, &FindBar::nextRequested);
    connect(end, &QToolButton::clicked, this, &FindBar::close);
    hide();
}

void FindBar::open()
{
    show();
    m_text->setFocus(Qt::ShortcutFocusReason);
    m_text->selectAll();
    Q_EMIT changed();
}

void FindBar::close()
{
    hide();
    Q_EMIT closed();
}

QString FindBar::text() const
{
    return isHidden() ? QString() : m_text->text();
}

void FindBar::showResult(int which, int of)
{
    m_result->setText(m_text->text().isEmpty() ? QString()
                      : of == 0                ? tr("Not on this page")
                                               : tr("%1 of %2", "3 of 12 places").arg(which).arg(of));
}

void FindBar::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Escape)
        close();
    else if (isEnter && event->modifiers().testFlag(Qt::ShiftModifier))
        Q_EMIT previousRequested();
    else if (isEnter)
        Q_EMIT nextRequested();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
