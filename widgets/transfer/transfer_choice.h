// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/transfer_wish.h"
#include "transfer/values_before.h"

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace codewheel {

class Buses;
class Catalog;
class ProjectDocument;

// What to transfer: from the project, from one encoder to others, previous values, or into the project.
class TransferChoice : public QWidget
{
    Q_OBJECT

public:
    enum class What : std::uint8_t { write, writeStored, store, clone, restore };

    TransferChoice(const Buses &buses, FindValuesBefore findBefore, QWidget *parent = nullptr);

    What what() const;
    void choose(What what);
    void showEncoders(); // of all buses, after they may have changed
    // The encoder whose values are cloned or restored.
    void setEncoder(Place number);
    std::optional<Place> from() const;  // of a clone
    const ValuesBefore *before() const; // null: nothing to restore
    bool withCams() const;              // for store and clone
    // The values each encoder is to get: restored, cloned, or from the project.
    std::vector<TransferWish> wishes(const Catalog &catalog, const ProjectDocument &project) const;

Q_SIGNALS:
    void changed();

private:
    void fillBefore();
    void showParts();

    const Buses &m_buses;
    FindValuesBefore m_findBefore;
    std::vector<ValuesBefore> m_befores;
    Place m_number;
    QComboBox *m_what;
    QComboBox *m_from;
    QComboBox *m_before;
    QCheckBox *m_cams;
};

} // namespace codewheel
