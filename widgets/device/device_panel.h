// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "ring/bus_session.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QTextBrowser;

namespace codewheel {

class EmptyState;
class LedRow;
class NamingBar;

// What the manual says of the chosen device, and the question which one it is where the bus does not tell.
// Follows the bus structure; a typed label key shows its device instead.
class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // The catalog must outlive the panel.
    explicit DevicePanel(const Catalog &catalog, QWidget *parent = nullptr);

    // The ring whose devices are named, and whose LEDs are told; null: none.
    void setRing(BusSession *ring);

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

    bool isConnected() const;

    QPointer<BusSession> m_ring;
    std::optional<Place> m_number;
    std::optional<DeviceDescription> m_planned;
    std::optional<DeviceDescription> m_toFill; // the page with, once it is seen
    NamingBar *m_naming;
    LedRow *m_leds;
    QTextBrowser *m_page;
    EmptyState *m_empty;
};

} // namespace codewheel
