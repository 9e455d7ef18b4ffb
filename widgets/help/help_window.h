// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/manual.h"

#include <QWidget>

class QSplitter;
class QToolBar;

namespace codewheel {

class FindBar;
class HelpBrowser;
class HelpSidebar;

// The manual in a modeless window of its own: contents, search of all pages, find in the page, back and
// forward.
class HelpWindow : public QWidget
{
    Q_OBJECT

public:
    explicit HelpWindow(QWidget *parent = nullptr);

    const Manual &manual() const { return m_manual; }
    // In the form of setHelpTopic(); empty: the first page.
    void showTopic(const QString &topic);
    QUrl shown() const;

    // Size, and the width of the contents.
    QByteArray layoutState() const;
    void restoreLayout(const QByteArray &state);

Q_SIGNALS:
    void closed();

protected:
    void closeEvent(QCloseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QToolBar *makeTools();
    void makeFinding();
    void open(const QUrl &url);
    void showMarks();
    void goToMark(bool forward);
    void tellMissing();

    const Manual m_manual;
    HelpSidebar *m_sidebar;
    HelpBrowser *m_page;
    FindBar *m_find;
    QSplitter *m_splitter;
};

} // namespace codewheel
