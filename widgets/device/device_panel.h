// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/place.h"

#include <QWidget>

#include <optional>

class QTextBrowser;

namespace codewheel {

class Buses;
class Catalog;
class EmptyState;
class EncoderBus;
class NamingBar;

// What the manual says of the chosen device, and the question which one it is where the bus does not tell.
// Follows the bus structure; a typed label key shows its device instead.
class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // Both must outlive the panel.
    DevicePanel(const Buses &buses, const Catalog &catalog, QWidget *parent = nullptr);

    // What the views of a bus tell of the chosen device besides; above all else.
    void addRow(QWidget *row);

    // planned: what stands there by the project, where it is not connected; it can be looked at, not named.
    void setPlace(std::optional<Place> number, std::optional<DeviceDescription> planned = {});
    // For whoever asked to name the device.
    void focusNaming();

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void showDevice();
    void fillPage();
    std::optional<DeviceDescription> shown() const;

    EncoderBus *bus() const; // of the device; null: not connected

    const Buses &m_buses;
    std::optional<Place> m_number;
    std::optional<DeviceDescription> m_planned;
    std::optional<DeviceDescription> m_toFill; // the page with, once it is seen
    NamingBar *m_naming;
    QTextBrowser *m_page;
    EmptyState *m_empty;
};

} // namespace codewheel
