// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/recent_file.h"

#include <QScrollArea>

#include <vector>

class QAction;
class QBoxLayout;
class QLabel;
class QToolButton;

namespace codewheel {

class RecentList;
class StartEntry;

// What can be done while no bus is connected, in the middle of the window: the training bus, connecting,
// opening a project or a recent one, replacing an encoder. Does nothing by itself.
class StartPage : public QScrollArea
{
    Q_OBJECT

public:
    explicit StartPage(QWidget *parent = nullptr);

    // The open project; empty: none has a file.
    void setProject(const QString &file);
    // The project of the last session; no path: none is offered.
    void setLast(const RecentFile &file);
    void setRecent(const std::vector<RecentFile> &files);
    QWidget *connectEntry() const; // for attaching a menu of buses

    QAction *reopen;
    QAction *training;
    QAction *connectBus;
    QAction *open;
    QAction *recent;
    QAction *replace;
    QAction *find;

Q_SIGNALS:
    void recentRequested(const QString &path);
    void removeRequested(const QString &path);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    void makeEntries(QBoxLayout &column);
    void makeRecent(QBoxLayout &column);

    QWidget *m_content;
    QLabel *m_heading;
    QLabel *m_project;
    QBoxLayout *m_columns; // entries and recent files, side by side where there is room
    std::vector<StartEntry *> m_entries;
    QWidget *m_recent = nullptr;
    RecentList *m_list = nullptr;
    QToolButton *m_remove = nullptr;
};

} // namespace codewheel
