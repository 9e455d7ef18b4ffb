// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/transfer_plan.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace codewheel {

class Buses;

// What has to be known or agreed to of the EEPROMs that a transfer writes to: a sentence for each encoder
// that gives cause for concern; beyond what its manual speaks of a tick, and beyond what it guarantees its
// place typed. Hidden where there is nothing to say. In TransferPage and ReplaceWriteStep, which ask
// isOpen().
class EepromGates : public QWidget
{
    Q_OBJECT

public:
    explicit EepromGates(const Buses &buses, QWidget *parent = nullptr);

    // What was agreed to holds for the encoders it was asked of.
    void setPlan(const TransferPlan &plan);
    bool isOpen() const;

Q_SIGNALS:
    void changed(); // isOpen()

private:
    const Buses &m_buses;
    std::vector<Place> m_asked; // to be ticked
    std::vector<Place> m_typed; // to be typed
    QLabel *m_text;
    QCheckBox *m_nevertheless;
    QLineEdit *m_places;
};

} // namespace codewheel
