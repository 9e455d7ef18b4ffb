// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "widgets/look/page.h"
#include "widgets/look/tool.h"
#include "widgets/structure_editor/plan_edits.h"

#include <QPointer>

#include <map>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolBar;
class QToolButton;
class QTreeView;
class QVBoxLayout;

namespace codewheel {

class EmptyState;
class InlineMessage;
class InsertPanel;
class PlanModel;

// The planned bus: insert, remove, move by dragging and by keys, search, edit stations, groups and addresses
// in place; problems are shown beside them. Everything can be undone. Nothing here is sent to the bus.
class StructureEditor : public Page
{
    Q_OBJECT

public:
    // Both must outlive it.
    StructureEditor(ProjectDocument &document, const Catalog &catalog, QWidget *parent = nullptr);

    // The bus to plan here, initially the first ring. `kind` and `name`: for one that is not planned yet.
    void setBus(BusId bus, const QString &kind = {}, const QString &name = {});
    BusId bus() const { return m_edits.bus(); }
    // The kind's own fields for a bus, below the editor.
    void addFields(BusId bus, QWidget *fields);
    // A device that is planned, or else connected: what is inserted takes its place.
    void choose(Place number);
    void openInsertPanel();
    QString title() const override { return tr("Bus structure"); }
    QString about() const override;
    QString effect() const override { return tr("Edits the planned bus. Nothing is sent here."); }

Q_SIGNALS:
    void chosen(codewheel::Place number);
    void busChosen(codewheel::BusId bus);

private:
    using Slot = void (StructureEditor::*)();

    void makeTools();
    void makeSearch();
    void makeTree();
    void arrange();
    void connectParts();
    QAction *addTool(const Tool &tool, Slot slot);

    template <PlanStep step>
    void move();
    void remove();
    void insert(const Participant &device, const KindData &where);
    void changeTo(const Participant &device);
    void search();
    void findNext() { goToFound(1); }
    void findPrevious() { goToFound(-1); }
    void goToFound(int by);
    void goToFinding();
    void showFindings();
    void showFindingsOfCurrent();
    void fitColumns();
    void widenPlaces();

    void showCurrent();
    void showProject();
    void showBuses();
    void showWhetherEmpty();
    void showPlace();
    QString busName() const;
    void showKind();
    void say(const Result<void> &done);
    std::optional<PlanEdits::Id> current() const;
    PlanEdits::Ids selected() const;
    void makeCurrent(PlanEdits::Id id);

    ProjectDocument &m_document;
    PlanEdits m_edits;
    PlanModel *m_model;
    QLabel *m_busLabel;
    QComboBox *m_bus; // if the project has several
    std::vector<BusId> m_buses;
    QString m_name;                   // of a bus that is not planned yet
    std::optional<Place> m_connected; // chosen, and not planned
    QToolBar *m_tools;
    QList<QAction *> m_deviceActions; // need a chosen device
    QList<QAction *> m_orderActions;  // of these, only if the kind has an order
    QLineEdit *m_search;
    QLabel *m_found;
    std::vector<PlanEdits::Id> m_matches;
    QTreeView *m_tree;
    EmptyState *m_empty;
    InsertPanel *m_insert;
    InlineMessage *m_message;
    QToolButton *m_findings;
    QLabel *m_finding;
    QVBoxLayout *m_below; // the tree
    std::map<BusId, QPointer<QWidget>> m_fields;
};

} // namespace codewheel
