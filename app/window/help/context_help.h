// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <memory>

class QAction;
class QMainWindow;

namespace codewheel {

class HelpWindow;
class WindowActions;
class WindowSettings;

// F1: opens the manual at what has the focus, in any window of the program, even while a question is open.
class ContextHelp : public QObject
{
    Q_OBJECT

public:
    // All outlive it.
    ContextHelp(QMainWindow &window, const WindowActions &actions, WindowSettings &settings);
    ~ContextHelp() override;

    void showForFocus();
    void showTopic(const QString &topic); // empty: the first page
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeWindow();
    void keepLayout();

    QMainWindow &m_window;
    QAction &m_alarmStop;
    WindowSettings &m_settings;
    std::unique_ptr<HelpWindow> m_help; // null: not asked for yet
};

} // namespace codewheel
