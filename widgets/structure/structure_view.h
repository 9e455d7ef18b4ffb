// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QIcon>
#include <QWidget>

#include <optional>
#include <vector>

class QTreeView;

namespace codewheel {

class Catalog;
class EmptyState;
class EncoderBus;
class InlineMessage;
class ProjectDocument;
class StructureModel;
class TreeFilter;

// A device as its row in the tree shows it.
struct ListedDevice
{
    Place place;
    QString name; // station, place and make
    QString bus;
    QString state;
    QString position;
    QString profile;
    QString code;
    QIcon icon;
};

// The bus structure as a tree. The panels beside it show the chosen device; Enter or a double click opens its
// monitors, or, where its state is a fault, what is wrong with it.
class StructureView : public QWidget
{
    Q_OBJECT

public:
    explicit StructureView(QWidget *parent = nullptr);

    // The bus is connected, or its devices have changed. The selection stays if its device still exists;
    // otherwise the first device is selected.
    void addBus(EncoderBus &bus);
    void removeBus(BusId bus); // shows what the project plans for it instead
    // Both must outlive the view.
    void setProject(const ProjectDocument &project, const Catalog &catalog);
    void showTitles(); // after the buses' distinguishing names have changed
    std::optional<Place> current() const;
    std::optional<BusId> currentBus() const; // the row of the bus itself
    // The selected row: that of a device, or, without a node, of a bus.
    std::optional<Place> row() const;
    bool has(Place row) const;
    QString nameOf(Place row) const;           // as the tree shows it; empty: it has no such row
    std::vector<ListedDevice> devices() const; // of all buses, in the order of the tree
    void choose(Place place);
    void choose(BusId bus); // the row of the bus itself
    void chooseRow(Place row);
    void reveal(Place row); // selects it and scrolls to it, even if it was filtered out

Q_SIGNALS:
    void chosen(codewheel::Place place);
    void opened(codewheel::Place place);
    // A row whose state is a fault was opened, or its state was clicked.
    void whyRequested(codewheel::Place row);
    // The bus does not tell the make of the chosen device: the user wants to.
    void namingRequested(codewheel::Place place);
    void menuRequested(codewheel::Place place, const QPoint &globalPosition);
    // The row of a bus itself.
    void busChosen(codewheel::BusId bus);
    void busOpened(codewheel::BusId bus);
    void busMenuRequested(codewheel::BusId bus, const QPoint &globalPosition);

private:
    void placeColumns();
    void scrollTo(BusId bus);
    void showWhetherEmpty();
    void restoreRow();
    void askForMake();
    std::optional<Place> rowOf(const QModelIndex &index) const;
    void open(const QModelIndex &index);

    StructureModel *m_model;
    QTreeView *m_tree;
    TreeFilter *m_filter;
    EmptyState *m_empty;
    InlineMessage *m_question;
    std::optional<Place> m_rowBefore; // the selection before the rows were rebuilt
    int m_levels = 0;                 // of the tree, including the master
};

} // namespace codewheel
