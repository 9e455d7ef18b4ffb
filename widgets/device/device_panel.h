// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"

#include <QWidget>

#include <optional>

class QTextBrowser;

namespace codewheel {

class BusSession;
class EmptyState;
class LedRow;
class NamingBar;
struct DeviceDescription;

// What the manual says of the chosen device, and the question which one it is where the bus does not tell.
// Follows the bus structure; a typed label key shows its device instead.
class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // The bus must outlive the panel.
    explicit DevicePanel(BusSession &bus, QWidget *parent = nullptr);

    void setPlace(std::optional<DeviceNumber> number);
    // For whoever asked to name the device.
    void focusNaming();

private:
    void showDevice();
    void showLeds();
    const DeviceDescription *shown() const;

    BusSession &m_bus;
    std::optional<DeviceNumber> m_number;
    NamingBar *m_naming;
    LedRow *m_leds;
    QTextBrowser *m_page;
    EmptyState *m_empty;
};

} // namespace codewheel
