// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/found.h"
#include "widgets/connect/port_row.h"
#include "widgets/look/page.h"
#include "widgets/look/trouble.h"

#include <QStringList>

#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTableView;

namespace codewheel {

class EmptyState;
class FinderNewsModel;
class InlineMessage;

// Where to look.
struct FindWish
{
    QStringList ports{};
    QString host{}; // empty: none
    int tcpPort = 0;

    friend bool operator==(const FindWish &, const FindWish &) = default;
};

// "Who is there?": looks for whoever is at the ports and interfaces of this computer and at a host, on any
// kind of bus. It listens; what would be sent beyond that is shown and agreed to. Others carry the search
// out.
class FindPage : public Page
{
    Q_OBJECT

public:
    explicit FindPage(QWidget *parent = nullptr);
    ~FindPage() override;

    QString title() const override { return tr("Who is there?"); }
    QString effect() const override
    {
        return tr("Listens first. What would be sent after that is asked before. Nothing is written.");
    }

    // Serial ports, and what else of this computer can be listened to. One on its own is ticked, and one that
    // has been plugged in since; the others stay as they are.
    void setPorts(const std::vector<PortRow> &ports, const Trouble &trouble);
    FindWish wish() const; // fields must have been taken

    void begin(); // a search: nothing is found yet
    void add(const FinderNews &news);
    void tell(const Trouble &trouble); // of one of the places
    // Ends with askAgreed(), or not at all.
    void ask(const QStringList &places, const QStringList &announcements);
    void end();
    bool isSearching() const { return m_isSearching; }
    void setProblem(const Trouble &trouble);
    const FinderNewsModel &news() const { return *m_news; }

Q_SIGNALS:
    void portsWanted(); // the list, anew
    void searchWanted(const codewheel::FindWish &wish);
    void askAgreed();
    void cancelled();
    // `devices`: all that were found by the same link, as their kind knows them.
    void connectWanted(const codewheel::Found &found, const std::vector<codewheel::KindData> &devices);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void orderTabs();
    QWidget *makePlaces();
    QWidget *makeButtons();
    void makeTable();
    void search();
    void connectChosen();
    const Found *chosen() const; // null: none, or nobody
    std::vector<KindData> devicesAt(const QString &link) const;
    void placesChanged();
    void showWhatIsPossible();

    bool m_hasListedPorts = false;
    bool m_isSearching = false;
    bool m_isAsking = false; // whether it may send
    bool m_hasSearched = false;
    QListWidget *m_ports;
    QPushButton *m_refresh;
    QLineEdit *m_otherPort;
    QLineEdit *m_host;
    QSpinBox *m_tcpPort;
    QPushButton *m_search;
    QPushButton *m_cancel;
    QLabel *m_doing;
    InlineMessage *m_trouble;
    InlineMessage *m_message;
    FinderNewsModel *m_news;
    QTableView *m_table = nullptr;
    EmptyState *m_empty = nullptr; // in its place until a search begins
    QPushButton *m_connect = nullptr;
};

} // namespace codewheel
