// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/device/device_panel.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"
#include "widgets/device/device_html.h"
#include "widgets/device/naming_bar.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QTextBrowser>
#include <QVBoxLayout>

#include <utility>

namespace codewheel {

DevicePanel::DevicePanel(const Buses &buses, const Catalog &catalog, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_naming(new NamingBar(catalog, this))
    , m_page(describe(new QTextBrowser(this), "devicePage", tr("What the manual says of the device"),
                      tr("Pins, LEDs, limits, label key and parameters, with the chapter of the manual")))
    , m_empty(new EmptyState(Icon::encoder, tr("No description"), QString(), this))
{
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setTabChangesFocus(true);
    m_page->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

    auto *rows = layOut<QVBoxLayout>(this, grid::margin, grid::margin);
    rows->addWidget(m_naming);
    rows->addWidget(m_page, 1);
    rows->addWidget(m_empty, 1);
    setFocusProxy(m_naming);
    connect(&buses, &Buses::changed, this, [this] { setPlace(m_number, m_planned); });
    connect(m_naming, &NamingBar::lookedUp, this, &DevicePanel::showDevice);
    showDevice();
}

void DevicePanel::addRow(QWidget *row)
{
    static_cast<QVBoxLayout *>(layout())->insertWidget(0, row);
}

EncoderBus *DevicePanel::bus() const
{
    return m_number ? m_buses.open(m_number->bus) : nullptr;
}

void DevicePanel::setPlace(std::optional<Place> number, std::optional<DeviceDescription> planned)
{
    m_number = number;
    m_planned = std::move(planned);
    m_naming->setPlace(m_planned ? nullptr : bus(), number);
    showDevice();
}

void DevicePanel::focusNaming()
{
    m_naming->focusKey();
}

std::optional<DeviceDescription> DevicePanel::shown() const
{
    if (const LabelMatch *looked = m_naming->looked())
        return describedDevice(*looked);
    if (m_planned)
        return m_planned;
    const EncoderSession *encoder = m_number ? m_buses.encoder(*m_number) : nullptr;
    return encoder ? std::optional(encoder->device()) : std::nullopt;
}

void DevicePanel::showDevice()
{
    const std::optional<DeviceDescription> device = shown();
    m_page->setVisible(device.has_value());
    m_empty->setVisible(!device);
    m_toFill = device;
    if (device && visibleRegion().isEmpty())
        m_page->clear();
    else if (device)
        fillPage();
    else if (bus() != nullptr && isCoupler(*bus(), *m_number))
        m_empty->setTexts(tr("%1 is a bus terminal").arg(m_number->toString()),
                          tr("It connects the devices behind it to the ring; there is nothing to describe."));
    else if (m_number)
        m_empty->setTexts(tr("There is no description of %1").arg(m_number->toString()),
                          tr("Put one into the folder codewheel/devices of your data folder, or type the key "
                             "on its label to look one up."));
    else
        m_empty->setTexts(tr("No device is chosen"),
                          tr("Choose one in the bus structure, or type the key on a label to look one up."));
}

// Laying it out takes long, so a panel that nobody sees puts it off.
void DevicePanel::fillPage()
{
    if (m_toFill)
        m_page->setHtml(deviceHtml(*std::exchange(m_toFill, std::nullopt)));
}

// Not in showEvent(), which also comes when the panel is behind another tab.
void DevicePanel::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    if (m_toFill)
        QMetaObject::invokeMethod(this, &DevicePanel::fillPage, Qt::QueuedConnection);
}

} // namespace codewheel
