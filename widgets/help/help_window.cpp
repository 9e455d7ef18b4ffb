// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_window.h"

#include "widgets/help/find_bar.h"
#include "widgets/help/help_browser.h"
#include "widgets/help/help_sidebar.h"
#include "widgets/help/help_topic.h"
#include "widgets/help/manual_search.h"
#include "widgets/look/describe.h"
#include "widgets/look/layouts.h"
#include "widgets/look/tool.h"

#include <QAction>
#include <QByteArray>
#include <QDataStream>
#include <QIODevice>
#include <QKeyEvent>
#include <QScreen>
#include <QSplitter>
#include <QToolBar>

namespace codewheel {
namespace {

constexpr QSize firstHelpSize(960, 700);
constexpr QSize desktopFrame(40, 60); // what desktops reserve for themselves
constexpr int firstContentsWidth = 250;

} // namespace

HelpWindow::HelpWindow(QWidget *parent)
    : QWidget(parent, Qt::Window)
    , m_sidebar(new HelpSidebar(m_manual))
    , m_page(new HelpBrowser(m_manual))
    , m_find(new FindBar)
    , m_splitter(new QSplitter)
{
    setObjectName(QStringLiteral("helpWindow"));
    setWindowTitle(tr("Manual"));
    setHelpTopic(*this, "help.md");
    auto *right = new QWidget;
    layOutColumn(right, {{m_page, 1}, m_find}, {0, allAround(0)});
    m_splitter->addWidget(m_sidebar);
    m_splitter->addWidget(right);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setChildrenCollapsible(false);
    layOutColumn(this, {makeTools(), {m_splitter, 1}}, {0, allAround(0)});
    makeFinding();
    connect(m_sidebar, &HelpSidebar::chosen, this, &HelpWindow::open);
    connect(m_page, &HelpBrowser::sourceChanged, m_sidebar, &HelpSidebar::showWhere);
    resize(firstHelpSize.boundedTo(screen()->availableSize() - desktopFrame));
    m_splitter->setSizes({firstContentsWidth, width() - firstContentsWidth});
    if (!m_manual.isThere())
        tellMissing();
}

QToolBar *HelpWindow::makeTools()
{
    auto *bar = new QToolBar(this);
    setUpToolBar(*bar);
    QAction *back =
        addTool(*this, *bar,
                {Icon::back, tr("Back"), QKeySequence(Qt::ALT | Qt::Key_Left), tr("To the page before")});
    QAction *forward = addTool(*this, *bar,
                               {Icon::next, tr("Forward"), QKeySequence(Qt::ALT | Qt::Key_Right),
                                tr("To the page you came back from")});
    QAction *first = addTool(*this, *bar,
                             {Icon::home, tr("First page"), QKeySequence(Qt::ALT | Qt::Key_Home),
                              tr("To the first page of the manual")});
    bar->addSeparator();
    QAction *search = addTool(*this, *bar,
                              {Icon::search, tr("Search"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F),
                               tr("Searches all pages")});
    QAction *find = addTool(*this, *bar,
                            {Icon::filter, tr("Find in this page"), QKeySequence(Qt::CTRL | Qt::Key_F),
                             tr("Marks a text on this page")});
    back->setEnabled(false);
    forward->setEnabled(false);
    connect(m_page, &HelpBrowser::backwardAvailable, back, &QAction::setEnabled);
    connect(m_page, &HelpBrowser::forwardAvailable, forward, &QAction::setEnabled);
    connect(back, &QAction::triggered, m_page, &HelpBrowser::backward);
    connect(forward, &QAction::triggered, m_page, &HelpBrowser::forward);
    connect(first, &QAction::triggered, this, [this] { open(Manual::firstPage()); });
    connect(search, &QAction::triggered, m_sidebar, &HelpSidebar::focusSearch);
    connect(find, &QAction::triggered, m_find, &FindBar::open);
    return bar;
}

void HelpWindow::makeFinding()
{
    const auto onKey = [this](const QKeySequence &key, bool forward) {
        auto *step = new QAction(forward ? tr("Next match") : tr("Previous match"), this);
        step->setShortcut(key);
        addAction(step);
        connect(step, &QAction::triggered, this, [this, forward] { goToMark(forward); });
    };
    onKey(QKeySequence(Qt::Key_F3), true);
    onKey(QKeySequence(Qt::SHIFT | Qt::Key_F3), false);
    connect(m_find, &FindBar::changed, this, [this] {
        showMarks();
        m_find->showResult(m_page->goToFirstMark(), m_page->marked());
    });
    connect(m_find, &FindBar::nextRequested, this, [this] { goToMark(true); });
    connect(m_find, &FindBar::previousRequested, this, [this] { goToMark(false); });
    connect(m_find, &FindBar::closed, this, [this] {
        showMarks();
        m_page->setFocus();
    });
    connect(m_sidebar, &HelpSidebar::wordsChanged, this, &HelpWindow::showMarks);
}

// Find in the page takes precedence over the search of all pages.
void HelpWindow::showMarks()
{
    m_page->mark(m_find->text().isEmpty() ? m_sidebar->words() : QStringList{m_find->text()});
}

void HelpWindow::goToMark(bool forward)
{
    const int which = m_page->goToMark(forward);
    m_find->showResult(which, m_page->marked());
}

void HelpWindow::showTopic(const QString &topic)
{
    m_sidebar->endSearch();
    open(Manual::url(topic.isEmpty() ? QStringLiteral("README.md") : topic));
    m_page->setFocus();
}

void HelpWindow::open(const QUrl &url)
{
    if (!m_manual.isThere())
        return;
    m_page->setSource(url);
    if (!m_sidebar->words().isEmpty())
        m_page->goToFirstMark();
}

QUrl HelpWindow::shown() const
{
    return m_page->source();
}

void HelpWindow::tellMissing()
{
    m_page->setPlainText(tr("The manual is not there: %1 is missing. It comes with the program; build or "
                            "install the program again.")
                             .arg(Manual::file()));
}

QByteArray HelpWindow::layoutState() const
{
    QByteArray state;
    QDataStream out(&state, QIODevice::WriteOnly);
    out << saveGeometry() << m_splitter->saveState();
    return state;
}

void HelpWindow::restoreLayout(const QByteArray &state)
{
    QByteArray geometry;
    QByteArray widths;
    QDataStream in(state);
    in >> geometry >> widths;
    restoreGeometry(geometry);
    m_splitter->restoreState(widths);
}

void HelpWindow::closeEvent(QCloseEvent *event)
{
    QWidget::closeEvent(event);
    Q_EMIT closed();
}

void HelpWindow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
