// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/training/training_area.h"

namespace codewheel {

class LineEncoderBox;
class LineFaultsBox;
class SimulatedLine;

// What a trainer can do to a simulated serial line: to the line itself (a place without a node), and to each
// of its encoders. Used by the training dock.
class LineTrainingPanel final : public TrainingArea
{
    Q_OBJECT

public:
    explicit LineTrainingPanel(BusId bus, QWidget *parent = nullptr);

    // The line outlives the panel, or is removed first; null: not a simulated line.
    void setLine(SimulatedLine *line);
    void refresh() override;

private:
    const BusId m_bus;
    SimulatedLine *m_line = nullptr;
    LineFaultsBox *m_faults;
    LineEncoderBox *m_encoder;
};

} // namespace codewheel
