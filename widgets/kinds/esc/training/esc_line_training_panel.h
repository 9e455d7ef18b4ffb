// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_line_address.h"
#include "widgets/training/training_area.h"

#include <vector>

namespace codewheel {

class EscEncoderBox;
class EscLineFaultsBox;
class SimulatedEscLine;

// What a trainer can do to a simulated serial line: to the line itself (a place without a node), and to each
// of its encoders. Used by the training dock.
class EscLineTrainingPanel final : public TrainingArea
{
    Q_OBJECT

public:
    explicit EscLineTrainingPanel(BusId bus, QWidget *parent = nullptr);

    // The line outlives the panel, or is removed first; null: not a simulated line.
    void setLine(SimulatedEscLine *line);
    void refresh() override;

private:
    void listEncoders();
    void followAddresses();

    const BusId m_bus;
    SimulatedEscLine *m_line = nullptr;
    std::vector<EscLineAddress> m_addresses; // listed, by encoder
    EscLineFaultsBox *m_faults;
    EscEncoderBox *m_encoder;
};

} // namespace codewheel
