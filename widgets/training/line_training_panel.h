// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/training/training_area.h"

namespace codewheel {

class LineEncoderBox;
class LineFaultsBox;
class SimulatedLine;

// What a trainer does to a simulated serial line: what happens to the line itself (a place without a node),
// and each of its encoders. Used by the training dock.
class LineTrainingPanel final : public TrainingArea
{
    Q_OBJECT

public:
    explicit LineTrainingPanel(BusId bus, QWidget *parent = nullptr);

    // It outlives the panel, or is taken away first; null: it is no simulated line.
    void setLine(SimulatedLine *line);
    void refresh() override;

private:
    const BusId m_bus;
    SimulatedLine *m_line = nullptr;
    LineFaultsBox *m_faults;
    LineEncoderBox *m_encoder;
};

} // namespace codewheel
