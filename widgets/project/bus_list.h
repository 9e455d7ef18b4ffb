// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/project/bus_model.h"

#include <QWidget>

#include <functional>
#include <optional>

class QAction;
class QMenu;
class QTableView;
class QToolBar;

namespace codewheel {

class BusKind;
class InlineMessage;
class ProjectDocument;

// The buses of the project, on the page "Project": they are added, renamed and removed, each as one undo
// step. Connected buses are not touched.
class BusList : public QWidget
{
    Q_OBJECT

public:
    // Whether what is connected leaves this number free for a new bus of this kind.
    using IsFree = std::function<bool(BusId bus, const QString &kind)>;

    // The document outlives the list.
    explicit BusList(ProjectDocument &document, QWidget *parent = nullptr);

    void setIsFree(IsFree isFree) { m_isFree = std::move(isFree); }
    // Which kinds of buses are offered; else all.
    void setOffers(std::function<bool(const QString &kind)> offers) { m_offers = std::move(offers); }

private:
    void makeTable();
    void makeTools();
    void arrange();
    void showKinds();
    void fillKinds();
    void add(const BusKind &kind);
    void rename();
    void askRemove();
    void remove(BusId bus);
    void showInput(const QString &wrong);
    void followProject();
    void showWhatIsPossible();
    void withdraw();
    bool takesFields();
    std::optional<BusId> chosen() const;

    ProjectDocument &m_document;
    IsFree m_isFree;
    std::function<bool(const QString &kind)> m_offers;
    BusModel *m_model;
    QToolBar *m_tools;
    QTableView *m_table;
    InlineMessage *m_message;
    QMenu *m_kinds;
    QAction *m_add = nullptr;
    QAction *m_remove = nullptr;
    QAction *m_rename = nullptr;
    std::optional<BusRow> m_question; // that the message asks about
};

} // namespace codewheel
