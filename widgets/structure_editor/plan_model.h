// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/structure_editor/plan_edits.h"

#include <QAbstractItemModel>

#include <memory>
#include <unordered_map>

namespace codewheel {

// The planned bus as a tree, in the columns of its kind. Follows the project with the fewest row changes, so
// that a view keeps what is expanded and selected, whatever is done or undone. Cells are edited in place;
// devices are moved by dragging if the kind has an order.
class PlanModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    using Id = ProjectDocument::DeviceId;

    // They must outlive the model.
    explicit PlanModel(PlanEdits &edits, QObject *parent = nullptr);
    ~PlanModel() override;

    void setBus(BusId bus, const QString &kind = {}); // as PlanEdits
    std::optional<Id> idAt(const QModelIndex &index) const;
    QModelIndex indexOf(Id id, int column = 0) const;
    const PlanColumn &columnAt(int column) const { return m_columns[static_cast<std::size_t>(column)]; }
    // What is wrong with a text for this cell; empty: nothing is.
    QString complaint(const QModelIndex &index, const QString &text) const;
    // Devices whose place or texts contain this text, in the order of the bus.
    std::vector<Id> find(const QString &text) const;
    std::vector<Id> withFindings() const;

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
    // Does the moving itself; returns false, so that the view removes nothing.
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
        PlanRow shown;
    };
    struct Target; // the tree as it is to be

    void follow();
    void arrange(Node &parent, const Target &target);
    void moveTo(Node &node, Node &parent, int row);
    void insertAt(Node &parent, int row, Id id, const Target &target);
    void removeOthers(Node &parent, const Target &target);
    void showRows(Node &parent, const Target &target);
    void showColumns();
    static void countRows(Node &parent);

    Node *nodeAt(const QModelIndex &index) const;
    QModelIndex indexOf(const Node &node, int column) const;
    QString display(const PlanRow &row, const PlanColumn &column) const;
    static QVariant decoration(const PlanRow &row, const PlanColumn &column);
    static QString toolTip(const PlanRow &row, const PlanColumn &column);

    PlanEdits &m_edits;
    ProjectDocument &m_document;
    std::vector<PlanColumn> m_columns;
    Node m_root;
    std::unordered_map<Id, Node *> m_nodes;
};

} // namespace codewheel
