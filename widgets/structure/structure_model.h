// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/participant.h"
#include "ring/snapshot.h"
#include "widgets/structure/line_branch.h"

#include <QAbstractItemModel>

#include <vector>

namespace codewheel {

class BusSession;
class Catalog;
class ProjectDocument;

// The ring as a tree: the master, below it the remote bus, below a bus terminal its local bus and its branch;
// and beside the master the serial line, with its encoders below it. Connected, states and positions follow
// the bus and rows stay; offline it is the ring that the project plans. Stations are those of the project.
// Used by StructureView.
class StructureModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum Column {
        deviceColumn,
        stateColumn,
        positionColumn,
        profileColumn,
        idCodeColumn, // on a serial line its address
        wordsColumn,
        columns
    };

    explicit StructureModel(QObject *parent = nullptr);

    // Null: offline. The session must outlive the model, or be taken away first.
    void setBus(BusSession *bus);
    // Null: no line. It must outlive the model, or be taken away first.
    void setLine(LineSession *line);
    // Both must outlive the model.
    void setProject(const ProjectDocument &project, const Catalog &catalog);

    // Nothing for the rows of the master and of the line.
    std::optional<Place> numberAt(const QModelIndex &index) const;
    QModelIndex indexOf(Place number) const;
    QModelIndex lineIndex() const;               // invalid: no line
    bool isLine(const QModelIndex &index) const; // the line itself

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    // An encoder of the line has another address: both rows are there now, then that of the first goes.
    void encoderMoved(codewheel::Place from, codewheel::Place to);

private:
    using Shown = StateWord;
    struct Node
    {
        Participant participant;
        QString name;
        QString station;
        QString profile;
        int parent = -1; // index into m_nodes; -1: below the master
        std::vector<int> children;
        Shown shown;
        std::optional<std::int64_t> position;
        bool isOld = false; // the position
    };

    void refresh();
    void rebuild();
    void followBus();
    void followProject();
    RingStructure ring() const;
    QString stationOf(const Participant &participant) const;
    Node nodeOf(const Participant &participant) const;
    Place placeOf(const Participant &participant) const;
    void showName(Place number);
    void showNames(std::size_t place, const Participant &participant);
    Shown shownOf(const Node &node, std::size_t place) const;
    Shown shownOfMaster() const;
    std::optional<Shown> faultOf(const Node &node, std::size_t place) const;
    std::size_t placeOf(const Node &node) const;
    QString ledsText(const Node &node) const;
    QVariant masterCell(int column, int role) const;
    QVariant deviceCell(const Node &node, int column, int role) const;
    QString codingText(const Node &node) const;
    QString toolTip(const Node &node) const;
    int nodeOf(const QModelIndex &index) const;
    int rowOf(int node) const;
    const std::vector<int> &childrenOf(const QModelIndex &index) const;
    void emitState(const QModelIndex &device);
    void refreshPositions();
    bool hasRing() const { return m_bus != nullptr || !m_nodes.empty(); }

    // structure_model_line.cpp
    void refreshLine();
    void insertNewEncoders();
    void removeGoneEncoders();
    const LineBranch::Row *lineRow(const QModelIndex &index) const; // null: none of an encoder of the line
    QModelIndex lineRowIndex(Place number, int column) const;
    static QVariant oldPositionLook(std::optional<std::int64_t> position, int role);
    QVariant lineCell(int column, int role) const;
    QVariant lineEncoderCell(const LineBranch::Row &row, int column, int role) const;

    BusSession *m_bus = nullptr;
    const ProjectDocument *m_project = nullptr;
    const Catalog *m_catalog = nullptr;
    std::vector<Node> m_nodes; // in ring order
    std::vector<int> m_remote; // children of the master
    Shown m_master;
    LineBranch m_line;
    Shown m_lineShown;
    std::vector<LineBranch::Row> m_lineRows; // by address
};

} // namespace codewheel
