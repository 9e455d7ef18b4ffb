// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/page_head.h"

#include "widgets/input/form_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/may_elide.h"
#include "widgets/monitor/meaning_line.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

#include <utility>

namespace codewheel {
namespace {

// Sends Escape, since each field knows its previous value.
void giveValueBefore(QWidget &field)
{
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(&field, &press);
}

} // namespace

PageHead::PageHead(QStackedWidget &pages, QWidget &window)
    : QWidget(&window)
    , m_pages(pages)
    , m_window(window)
    , m_title(named(new MeaningLine(this), "pageTitle"))
    , m_effect(named(new MeaningLine(this), "pageEffect"))
    , m_close(describe(new QToolButton(this), "closePage", tr("Back to the monitors (Esc, Ctrl+W)")))
{
    setObjectName(QStringLiteral("pageHead"));
    m_title->setFont(textFont(TextSize::large));
    for (MeaningLine *line : {m_title, m_effect}) // names may be of any length
        allowEliding(*line);
    m_close->setIcon(lineIcon(Icon::cancel));
    m_close->setText(tr("Close", "a page"));
    m_close->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_close->setFocusPolicy(Qt::TabFocus);
    layOutColumn(this, {layOutRow({{m_title, 1}, m_close}, {.spacing = grid::margin}), m_effect},
                 {.spacing = 0, .margins = QMargins(grid::margin, grid::unit, grid::margin, 0)});
    hide();
    connect(m_close, &QToolButton::clicked, this, &PageHead::closePage);
    connect(&pages, &QStackedWidget::currentChanged, this, &PageHead::follow);
    window.installEventFilter(this);
}

void PageHead::follow()
{
    const bool needsRoom = m_pages.currentIndex() > 0;
    if (needsRoom)
        setNeedsRoom(true);
    if (auto *page = qobject_cast<Page *>(m_pages.currentWidget()); page != m_page)
        take(page);
    setNeedsRoom(needsRoom);
}

void PageHead::take(Page *page)
{
    if (m_page)
        m_page->disconnect(this);
    m_page = page;
    if (page != nullptr) {
        connect(page, &Page::headChanged, this, &PageHead::showHead);
        connect(page, &Page::closeRequested, this, &PageHead::closed);
    }
    setVisible(page != nullptr);
    showHead();
    Q_EMIT opened(page != nullptr);
}

void PageHead::setNeedsRoom(bool needs)
{
    if (std::exchange(m_needsRoom, needs) != needs)
        Q_EMIT roomChanged();
}

void PageHead::showHead()
{
    if (!m_page)
        return;
    const QString about = m_page->about();
    m_title->setText(about.isEmpty() ? m_page->title()
                                     : QStringLiteral("%1 \u2013 %2").arg(m_page->title(), about));
    m_effect->setText(m_page->effect());
}

void PageHead::closePage()
{
    const QPointer<Page> page = m_page;
    if (!page || !mayClose(*page) || page != m_page)
        return;
    page->leave();
    Q_EMIT closed();
}

// Good input is taken, as when a field is left in any other way.
bool PageHead::mayClose(Page &page)
{
    const QWidget *refused = nullptr;
    while (true) {
        const QString wrong = takeFields(page);
        QWidget *field = m_window.focusWidget(); // the refused one
        if (wrong.isEmpty() || field == nullptr || field == refused)
            break;
        if (!ask(wrong + QStringLiteral("\n\n") + tr("What is typed there will be discarded.")))
            return false;
        refused = field;
        giveValueBefore(*field);
    }
    const QString lost = page.lostByClosing();
    if (lost.isEmpty())
        return true;
    return ask(lost) && page.lostByClosing() == lost; // what was asked about may have ended meanwhile
}

bool PageHead::ask(const QString &what)
{
    QMessageBox box(QMessageBox::Question, m_page->title(), tr("Close this page?"), QMessageBox::NoButton,
                    m_page);
    box.setInformativeText(what);
    const QPushButton *close = box.addButton(tr("&Close the page"), QMessageBox::DestructiveRole);
    QPushButton *stay = box.addButton(tr("&Stay"), QMessageBox::RejectRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == close;
}

// A key reaches the window only if nothing on the way takes it: a field first restores its previous value, a
// list or a question over the page closes.
bool PageHead::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || !m_page)
        return QWidget::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->key() != Qt::Key_Escape || key->modifiers() != Qt::NoModifier)
        return QWidget::eventFilter(watched, event);
    closePage();
    return true;
}

} // namespace codewheel
