// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "widgets/models/table_model_base.h"

#include <QString>

#include <optional>

namespace codewheel {

class ProjectDocument;

struct BusRow
{
    BusId bus;
    QString name;
    QString kind; // in the user's language
    QString link;
    int devices = 0;

    friend bool operator==(const BusRow &, const BusRow &) = default;
};

// The buses of the project, whose names are edited in place. Surviving rows keep their identity, so that
// typing in one is not disturbed by other changes.
class BusModel : public TableModelBase<BusRow>
{
    Q_OBJECT

public:
    enum Column { name, kind, link, devices };

    // The document outlives the model.
    explicit BusModel(ProjectDocument &document, QObject *parent = nullptr);

    std::optional<int> rowOf(BusId bus) const;
    // What is wrong with the text for this cell; empty: nothing is.
    QString complaint(const QModelIndex &index, const QString &text) const;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

protected:
    std::span<const ColumnHead> heads() const override;
    QVariant cell(const BusRow &row, int column, int role) const override;

private:
    std::vector<BusRow> planned() const;
    void followProject();

    ProjectDocument &m_document;
};

} // namespace codewheel
