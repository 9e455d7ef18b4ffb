// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "ring/ring_edit.h"
#include "widgets/project/project_document.h"
#include "widgets/structure_editor/plan_row.h"

#include <QAbstractItemModel>

#include <memory>
#include <unordered_map>

namespace codewheel {

// The planned ring as a tree: below a bus terminal its local bus, then its branch. Follows the project by the
// smallest changes of rows, so that a view keeps what is open and selected, whatever was done or undone.
// Station, group, serial number, note and addresses are edited in place; devices are moved by dragging.
class PlanModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    using Id = ProjectDocument::DeviceId;
    enum Column {
        numberColumn,
        stationColumn,
        groupColumn,
        deviceColumn,
        profileColumn,
        idCodeColumn,
        wordsColumn,
        inColumn,
        outColumn,
        serialColumn,
        noteColumn,
        findingsColumn,
        columns
    };

    // Both must outlive the model.
    PlanModel(ProjectDocument &document, const Catalog &catalog, QObject *parent = nullptr);
    ~PlanModel() override;

    void setRing(BusId ring); // the first one at first
    std::optional<Id> idAt(const QModelIndex &index) const;
    QModelIndex indexOf(Id id, int column = numberColumn) const;
    const PlanRow &rowAt(const QModelIndex &index) const;
    // What is wrong with a text for this cell; empty: nothing.
    QString complaint(const QModelIndex &index, const QString &text) const;
    // Devices whose number, station, group, serial number, note, name or ID code have this text, in ring
    // order.
    std::vector<Id> find(const QString &text) const;
    std::vector<Id> withFindings() const; // in ring order

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    // Moves by itself; answers false, so that the view removes nothing.
    bool dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int column,
                      const QModelIndex &parent) override;

Q_SIGNALS:
    void refused(const codewheel::Refusal &why); // what was dropped
    void badInput(const QString &sentence);      // what was typed

private:
    struct Node
    {
        Id id = 0;
        Node *parent = nullptr;
        int row = 0;
        std::vector<std::unique_ptr<Node>> children;
        std::size_t localDevices = 0; // the first of them; behind them the branch
        PlanRow shown;
    };
    struct Target; // the tree as it shall be

    void follow();
    void arrange(Node &parent, const Target &target);
    void moveTo(Node &node, Node &parent, int row);
    void insertAt(Node &parent, int row, Id id, const Target &target);
    void removeOthers(Node &parent, const Target &target);
    void showRows(Node &parent, const Target &target);
    static void countRows(Node &parent);

    Node *nodeAt(const QModelIndex &index) const;
    QModelIndex indexOf(const Node &node, int column) const;
    QVariant display(const PlanRow &row, int column) const;
    static QVariant decoration(const PlanRow &row, int column);
    static QString toolTip(const PlanRow &row, int column);
    std::optional<RingPlace> dropPlace(const Participant &device, int row, const QModelIndex &parent) const;
    void setAddress(Id id, bool isIn, const QString &text);

    ProjectDocument &m_document;
    BusId m_ring = firstRing;
    const Catalog &m_catalog;
    AddressRules::Unit m_unit = AddressRules::Unit::byte; // in the header
    Node m_root;
    std::unordered_map<Id, Node *> m_nodes;
};

} // namespace codewheel
