// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "widgets/look/icons.h"
#include "widgets/structure_editor/plan_edits.h"

#include <QWidget>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QToolBar;
class QToolButton;
class QTreeView;

namespace codewheel {

class EmptyState;
class InlineMessage;
class InsertPanel;
class PlanModel;
class PlanSummary;

// The planned bus: insert, remove, move by drag and by keys, search, stations, groups and addresses in place;
// what is wrong stands beside it. All of it can be undone. Nothing here is sent to the bus.
class StructureEditor : public QWidget
{
    Q_OBJECT

public:
    // Both must outlive it.
    StructureEditor(ProjectDocument &document, const Catalog &catalog, QWidget *parent = nullptr);
    ~StructureEditor() override;

    // The ring that is planned here; the first one at first.
    void setRing(BusId ring);
    void choose(Place number);
    void openInsertPanel();

Q_SIGNALS:
    void chosen(codewheel::Place number);

private:
    using Slot = void (StructureEditor::*)();

    void makeTools();
    void makeSearch();
    void makeAddressing();
    void makeTree();
    void arrange();
    void connectParts();
    QAction *addTool(Icon icon, const QString &text, const QKeySequence &key, const QString &tip, Slot slot);

    void remove();
    void moveUp();
    void moveDown();
    void moveIn();
    void moveOut();
    void changeBus();
    void insert(const Participant &device, const RingPlace &place);
    void changeTo(const Participant &device);
    void search();
    void findNext() { goToFound(1); }
    void findPrevious() { goToFound(-1); }
    void goToFound(int by);
    void setAddressing();
    void goToFinding();
    void showFindings();
    void fitColumns();

    void showCurrent();
    void showProject();
    void showName();
    void say(const Result<void> &done);
    std::optional<PlanEdits::Id> current() const;
    PlanEdits::Ids selected() const;
    void makeCurrent(PlanEdits::Id id);

    ProjectDocument &m_document;
    BusId m_ring = firstRing;
    const Catalog &m_catalog;
    PlanEdits m_edits;
    PlanModel *m_model;
    QLabel *m_name; // of the ring, where the project has several
    QToolBar *m_tools;
    QList<QAction *> m_deviceActions; // need a chosen device
    QLineEdit *m_search;
    QLabel *m_found;
    std::vector<PlanEdits::Id> m_matches;
    QTreeView *m_tree;
    EmptyState *m_empty;
    InsertPanel *m_insert;
    InlineMessage *m_message;
    PlanSummary *m_summary;
    QComboBox *m_unit;
    QSpinBox *m_first;
    ProjectDocument::Gesture m_stepping; // of the first address
    QCheckBox *m_step5;
    QToolButton *m_findings;
};

} // namespace codewheel
