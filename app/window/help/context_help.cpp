// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/context_help.h"

#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "widgets/help/help_topic.h"
#include "widgets/help/help_window.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMainWindow>
#include <QWindow>

namespace codewheel {
namespace {

constexpr auto topicOfWindow = "README.md#the-window"; // for everything without a topic of its own
constexpr auto topicOfFiles = "project.md#files";

// The file dialog that it is, or that asks it: "replace this file?".
bool isOfFiles(const QWidget *widget)
{
    for (; widget != nullptr; widget = widget->parentWidget())
        if (qobject_cast<const QFileDialog *>(widget) != nullptr)
            return true;
    return false;
}

QWindow *handleOf(QWidget *window)
{
    return window == nullptr ? nullptr : window->windowHandle();
}

} // namespace

ContextHelp::ContextHelp(QMainWindow &window, const WindowActions &actions, WindowSettings &settings)
    : QObject(&window)
    , m_window(window)
    , m_alarmStop(*actions.alarmStop)
    , m_settings(settings)
{
    connect(actions.help, &QAction::triggered, this, &ContextHelp::showForFocus);
    connect(actions.manual, &QAction::triggered, this, [this] { showTopic({}); });
    qApp->installEventFilter(this);
}

ContextHelp::~ContextHelp()
{
    qApp->removeEventFilter(this);
    if (m_help)
        keepLayout();
}

// The window's actions are unavailable while a question is open.
bool ContextHelp::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || QApplication::activeModalWidget() == nullptr)
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->key() != Qt::Key_F1 || key->modifiers() != Qt::NoModifier)
        return QObject::eventFilter(watched, event);
    showForFocus();
    return true;
}

void ContextHelp::showForFocus()
{
    const QWidget *focus = QApplication::focusWidget();
    if (const QWidget *asks = QApplication::activeModalWidget();
        asks != nullptr && (focus == nullptr || !asks->isAncestorOf(focus)))
        focus = asks; // it has only just appeared
    else if (focus == nullptr)
        focus = QApplication::activeWindow();
    QString topic = helpTopicOf(focus);
    if (topic.isEmpty())
        topic = QLatin1String(isOfFiles(focus) ? topicOfFiles : topicOfWindow);
    showTopic(topic);
}

// A question blocks all other windows, so meanwhile the help belongs to it.
void ContextHelp::showTopic(const QString &topic)
{
    if (!m_help)
        makeWindow();
    m_help->winId();
    QWindow *asks = handleOf(QApplication::activeModalWidget());
    if (QWindow *its = handleOf(m_help.get()); its->transientParent() != asks) {
        m_help->hide();
        its->setTransientParent(asks);
    }
    m_help->showTopic(topic);
    m_help->setWindowState(m_help->windowState() & ~Qt::WindowMinimized);
    m_help->show();
    m_help->raise();
    m_help->activateWindow();
}

// Not a child of the main window, which could then not be brought in front of it.
void ContextHelp::makeWindow()
{
    m_help = std::make_unique<HelpWindow>();
    m_help->setAttribute(Qt::WA_QuitOnClose, false);
    m_help->addAction(&m_alarmStop);
    if (const QByteArray layout = m_settings.helpLayout(); !layout.isEmpty())
        m_help->restoreLayout(layout);
    connect(m_help.get(), &HelpWindow::closed, this, &ContextHelp::keepLayout);
    auto *help = new QAction(m_help.get());
    help->setShortcut(QKeySequence::HelpContents);
    m_help->addAction(help);
    connect(help, &QAction::triggered, this, &ContextHelp::showForFocus);
}

void ContextHelp::keepLayout()
{
    m_settings.setHelpLayout(m_help->layoutState());
}

} // namespace codewheel
