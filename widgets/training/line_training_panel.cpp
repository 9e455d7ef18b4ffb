// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/line_training_panel.h"

#include "simulator/simulated_line.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/training/line_encoder_box.h"
#include "widgets/training/line_faults_box.h"
#include "widgets/training/training_fields.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int lineTrainingHeight = 260; // the rest is scrolled to

} // namespace

LineTrainingPanel::LineTrainingPanel(BusId bus, QWidget *parent)
    : QScrollArea(parent)
    , m_bus(bus)
    , m_content(new QWidget(this))
    , m_device(describe(new QComboBox(m_content), tr("Device to train with"),
                        tr("The simulated line, or the encoder on it, that is moved and disturbed here")))
    , m_faults(new LineFaultsBox(m_content))
    , m_encoder(new LineEncoderBox(m_content))
{
    setAccessibleName(tr("Training"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    auto *column = new QVBoxLayout(m_content);
    column->setContentsMargins(grid::unit, grid::unit, grid::unit, grid::unit);
    column->setSpacing(grid::unit);
    auto *device = new QGridLayout;
    device->setHorizontalSpacing(grid::groupGap);
    device->setColumnStretch(1, 1);
    training_fields::addCaption(device, 0, tr("Device"), m_device);
    device->addWidget(m_device, 0, 1);
    column->addLayout(device);
    column->addWidget(m_faults);
    column->addWidget(m_encoder);
    column->addStretch(1);
    setWidget(m_content);
    connect(m_device, &QComboBox::currentIndexChanged, this, &LineTrainingPanel::refresh);
    connect(m_faults, &LineFaultsBox::acted, this, &LineTrainingPanel::act);
    connect(m_encoder, &LineEncoderBox::acted, this, &LineTrainingPanel::act);
    listDevices();
}

void LineTrainingPanel::setLine(SimulatedLine *line)
{
    const auto before = chosen();
    m_line = line;
    listDevices();
    if (before)
        setDevice(*before);
    refresh();
}

void LineTrainingPanel::listDevices()
{
    const QSignalBlocker silent(m_device);
    m_devices.clear();
    m_device->clear();
    if (m_line != nullptr) {
        m_devices.push_back({m_bus, {}});
        for (const LineAddress address : m_line->addresses())
            m_devices.push_back({m_bus, address.node()});
    }
    for (const Place place : m_devices)
        m_device->addItem(place.isEmpty() ? tr("Serial line") : place.toString());
    m_content->setEnabled(m_line != nullptr);
}

std::optional<Place> LineTrainingPanel::chosen() const
{
    const int index = m_device->currentIndex();
    return index < 0 ? std::nullopt : std::optional(m_devices[static_cast<std::size_t>(index)]);
}

void LineTrainingPanel::setDevice(Place place)
{
    const auto found = std::ranges::find(m_devices, place);
    if (found != m_devices.end())
        m_device->setCurrentIndex(static_cast<int>(found - m_devices.begin()));
}

void LineTrainingPanel::refresh()
{
    const auto place = chosen();
    m_faults->setVisible(!place || place->isEmpty());
    m_encoder->setVisible(place && !place->isEmpty());
    if (m_line == nullptr || !place)
        return;
    if (place->isEmpty())
        m_faults->showLine(*m_line);
    else
        m_encoder->showEncoder(*m_line, LineAddress::of(place->node));
}

void LineTrainingPanel::act(const QString &what)
{
    if (const auto place = chosen())
        Q_EMIT acted(*place, what);
}

QSize LineTrainingPanel::sizeHint() const
{
    const QSize content = m_content->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width(),
            std::min(content.height(), lineTrainingHeight)};
}

} // namespace codewheel
