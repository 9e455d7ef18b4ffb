// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QScrollArea>

#include <optional>
#include <vector>

class QComboBox;

namespace codewheel {

class LineEncoderBox;
class LineFaultsBox;
class SimulatedLine;

// What a trainer does to a simulated serial line: what befalls the line itself, and each of its encoders.
// Used by the training dock.
class LineTrainingPanel : public QScrollArea
{
    Q_OBJECT

public:
    explicit LineTrainingPanel(BusId bus, QWidget *parent = nullptr);

    // It outlives the panel, or is taken away first; null: it is no simulated line.
    void setLine(SimulatedLine *line);
    // Chooses this encoder, or without a node the line itself.
    void setDevice(Place place);
    // Shows how it stands; called by the window with every picture.
    void refresh();

    QSize sizeHint() const override;

Q_SIGNALS:
    void acted(codewheel::Place place, const QString &what);

private:
    void listDevices();
    std::optional<Place> chosen() const;
    void act(const QString &what);

    const BusId m_bus;
    SimulatedLine *m_line = nullptr;
    std::vector<Place> m_devices; // by index of the field; without a node it is the line itself
    QWidget *m_content;
    QComboBox *m_device;
    LineFaultsBox *m_faults;
    LineEncoderBox *m_encoder;
};

} // namespace codewheel
