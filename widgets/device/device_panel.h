// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/place.h"

#include <QWidget>

#include <optional>

class QTextBrowser;

namespace codewheel {

class BusSession;
class EmptyState;
class LedRow;
class NamingBar;

// What the manual says of the chosen device, and the question which one it is where the bus does not tell.
// Follows the bus structure; a typed label key shows its device instead.
class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // The bus must outlive the panel.
    explicit DevicePanel(BusSession &bus, QWidget *parent = nullptr);

    // planned: what stands there by the project, where it is not connected; it can be looked at, not named.
    void setPlace(std::optional<Place> number, std::optional<DeviceDescription> planned = {});
    // For whoever asked to name the device.
    void focusNaming();

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void showDevice();
    void fillPage();
    void showLeds();
    std::optional<DeviceDescription> shown() const;

    BusSession &m_bus;
    std::optional<Place> m_number;
    std::optional<DeviceDescription> m_planned;
    std::optional<DeviceDescription> m_toFill; // the page with, once it is seen
    NamingBar *m_naming;
    LedRow *m_leds;
    QTextBrowser *m_page;
    EmptyState *m_empty;
};

} // namespace codewheel
