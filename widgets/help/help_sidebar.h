// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QUrl>
#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace codewheel {

class Manual;
struct ManualHit;

// On the left of the help window: the contents of the manual, or, while there is text in the field above, the
// sections that contain all its words.
class HelpSidebar : public QWidget
{
    Q_OBJECT

public:
    HelpSidebar(const Manual &manual, QWidget *parent = nullptr);

    void focusSearch();
    void endSearch();
    QStringList words() const;       // that are searched for
    void showWhere(const QUrl &url); // in the contents

Q_SIGNALS:
    void chosen(const QUrl &url);
    void wordsChanged();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QTreeWidget *makeContents();
    void search();
    void showHits(const std::vector<ManualHit> &hits);
    void open(QTreeWidgetItem *item);
    void open(QListWidgetItem *item);

    const Manual &m_manual;
    QLineEdit *m_search;
    QStackedWidget *m_stack;
    QTreeWidget *m_contents;
    QListWidget *m_hits;
    QLabel *m_count;
    bool m_isShowing = false; // follows the page: not a choice made here
};

} // namespace codewheel
