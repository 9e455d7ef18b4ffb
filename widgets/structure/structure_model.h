// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/structure/bus_branch.h"

#include <QAbstractItemModel>
#include <QHash>

namespace codewheel {

class Catalog;
struct PlannedBus;

// The buses as a tree, connected or planned alike: each bus with its devices below it. For connected buses,
// states and positions follow the bus and rows stay; for the others it shows the project's plan. Stations
// come from the project. Used by StructureView.
class StructureModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum Column {
        deviceColumn,
        stateColumn,
        positionColumn,
        profileColumn,
        codeColumn, // that identifies it on its bus: ID code, address
        wordsColumn,
        columns
    };
    enum Role {
        nameRole = Qt::UserRole, // the station, else the place and the name of the device
        detailRole,              // place and name behind a station
        isBehindBreakRole,       // the fault of the bus is between it and the device before it
        isFaultRole,             // the state of the row is a fault
        isAttentionRole,         // it asks for attention
    };

    explicit StructureModel(QObject *parent = nullptr);

    // The bus is connected, or its devices have changed. It must outlive the model, or be removed first.
    void addBus(EncoderBus &bus);
    // Shows what the project plans instead. Does nothing if the bus is not here.
    void removeBus(BusId bus);
    // Both must outlive the model.
    void setProject(const ProjectDocument &project, const Catalog &catalog);

    // The buses' distinguishing names have changed (nameAmongOthers()).
    void showTitles();

    std::optional<Place> placeAt(const QModelIndex &index) const; // nothing for the row of a bus
    std::optional<BusId> busAt(const QModelIndex &index) const;   // nothing for the row of a device
    QModelIndex indexOf(Place place) const;
    QModelIndex indexOf(BusId bus) const;
    // Its bus does not tell which make it is, nobody has named it, and several are possible.
    bool makeIsOpen(Place place) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    // For a device: its place, and a text with name, state and position.
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    // A device has a new place: both rows exist now, then the old one is removed.
    void deviceMoved(codewheel::Place from, codewheel::Place to);

private:
    using Row = BusBranch::Row;
    // Where a row is; without a row: that of the bus.
    struct Where
    {
        std::size_t branch = 0;
        std::optional<std::size_t> row{};
    };

    void rebuild() { show(branches()); }
    void show(std::vector<BusBranch> branches);
    std::vector<BusBranch> branches();
    bool isShown(const PlannedBus &bus) const;
    void noteWhere();
    void followProject();
    void followBus(EncoderBus &bus);
    void followWords(EncoderBus &bus);
    std::vector<EncoderBus *> connected() const;
    BusBranch *find(BusId bus);
    const BusBranch *find(BusId bus) const;
    const Where *whereIs(const QModelIndex &index) const;
    const Row *rowAt(const QModelIndex &index) const; // null: not the row of a device
    QModelIndex indexOf(const BusBranch &branch, std::size_t row, int column) const;
    QModelIndex indexOf(const BusBranch &branch, int column) const;

    void refresh(BusId bus);
    void refreshRow(const BusBranch &branch, Row &row, const NodeState &state);
    void takeNodes(BusId bus, std::optional<std::pair<Place, Place>> moved = std::nullopt);
    void showNames(BusBranch &branch, const std::vector<BusNode> &nodes);
    void insertNew(BusBranch &branch, const std::vector<BusNode> &nodes);
    void removeGone(BusBranch &branch, const std::vector<BusNode> &nodes);

    static QVariant busCell(const BusBranch &branch, int column, int role);
    static QVariant deviceCell(const BusBranch &branch, const Row &row, int column, int role);
    static QString shownPosition(const BusBranch &branch, const Row &row);
    static QString toolTip(const BusBranch &branch, const Row &row);

    const ProjectDocument *m_project = nullptr;
    const Catalog *m_catalog = nullptr;
    std::vector<BusBranch> m_branches; // by number
    QHash<quintptr, Where> m_where;    // by id
    quintptr m_lastId = 0;
};

} // namespace codewheel
