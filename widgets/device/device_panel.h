// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/place.h"

#include <QWidget>

#include <optional>

class QTextBrowser;

namespace codewheel {

class Buses;
class Catalog;
class EmptyState;
class EncoderBus;
class NamingBar;

// What the manual says about the chosen device, and the question which one it is where the bus does not tell.
// Follows the bus structure; typing a label key shows that device instead.
class DevicePanel : public QWidget
{
    Q_OBJECT

public:
    // Both must outlive the panel.
    DevicePanel(const Buses &buses, const Catalog &catalog, QWidget *parent = nullptr);

    // More about the chosen device from the views of its bus; goes above everything else.
    void addRow(QWidget *row);

    // planned: the device according to the project where none is connected; it can be looked at, but not
    // named.
    void setPlace(std::optional<Place> number, std::optional<DeviceDescription> planned = {});
    // For views from which the user asks to name the device.
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
    std::optional<DeviceDescription> m_toFill; // what to fill the page with once it is seen
    NamingBar *m_naming;
    QTextBrowser *m_page;
    EmptyState *m_empty;
};

} // namespace codewheel
