// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/recent_file.h"

#include <QListWidget>

#include <vector>

namespace codewheel {

// Why it cannot be opened; empty: it can be.
QString whyNotOpened(RecentFile::State state);

// The projects that were open last, each with its folder. One that cannot be opened is grey and says why; any
// can be taken off the list. As high as its rows: its container scrolls.
class RecentList : public QListWidget
{
    Q_OBJECT

public:
    explicit RecentList(QWidget *parent = nullptr);

    void setFiles(const std::vector<RecentFile> &files);
    void removeCurrent(); // emits the request
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void openRequested(const QString &path);
    void removeRequested(const QString &path);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void show(QListWidgetItem &item, const RecentFile &file);
    void open(int row);

    std::vector<RecentFile> m_files;
};

} // namespace codewheel
