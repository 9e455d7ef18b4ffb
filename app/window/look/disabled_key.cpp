// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/disabled_key.h"

#include "vocabulary/sentence.h"
#include "widgets/look/label_text.h"

#include <QAction>
#include <QKeyEvent>
#include <QMainWindow>
#include <QStatusBar>

#include <chrono>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds timeToRead{8'000};

} // namespace

DisabledKey::DisabledKey(QMainWindow &window)
    : QObject(&window)
    , m_window(window)
{
    window.installEventFilter(this);
}

// What gets here nobody has taken: neither the focus nor an action that is enabled.
bool DisabledKey::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window && event->type() == QEvent::KeyPress)
        tell(*static_cast<QKeyEvent *>(event));
    return false;
}

void DisabledKey::tell(const QKeyEvent &key)
{
    const QKeySequence pressed(key.keyCombination());
    for (const QAction *action : m_window.findChildren<QAction *>())
        if (!action->isEnabled() && action->shortcuts().contains(pressed)) {
            const QString text = sentence(tr("Not possible now: %1. %2", "action, why or what it does"),
                                          {plainLabel(action->text()), action->statusTip()});
            m_window.statusBar()->showMessage(text, static_cast<int>(timeToRead.count()));
            return;
        }
}

} // namespace codewheel
