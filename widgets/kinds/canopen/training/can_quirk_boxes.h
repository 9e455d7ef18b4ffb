// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/node_quirks.h"

#include <QWidget>

#include <vector>

class QCheckBox;

namespace codewheel {

// What a simulated encoder does otherwise than most, as encoders of some makes do. Part of the training
// panel.
class CanQuirkBoxes : public QWidget
{
    Q_OBJECT

public:
    explicit CanQuirkBoxes(QWidget *parent = nullptr);

    void showQuirks(const canopen::NodeQuirks &quirks);

Q_SIGNALS:
    void quirkSet(const codewheel::canopen::NamedQuirk &quirk, bool on);

private:
    std::vector<QCheckBox *> m_boxes; // as namedQuirks() has them
};

} // namespace codewheel
