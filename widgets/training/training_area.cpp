// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/training_area.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int areaHeight = 260; // of the content; beyond this it scrolls

} // namespace

TrainingArea::TrainingArea(const QString &toolTip, QWidget *parent)
    : ScrolledPanel(tr("Training"), areaHeight, parent)
    , m_device(describe(new QComboBox(content()), tr("Device to train with"), toolTip))
    , m_column(layOut<QVBoxLayout>(content(), grid::unit, grid::unit))
    , m_afresh(named(new QPushButton(lineIcon(Icon::refresh), tr("Start afresh"), content()), "startAfresh"))
{
    auto *device = new QGridLayout;
    device->setHorizontalSpacing(grid::groupGap);
    device->setColumnStretch(1, 1);
    training_fields::addCaption(device, 0, tr("Device"), m_device);
    device->addWidget(m_device, 0, 1);
    m_column->addLayout(device);
    connect(m_device, &QComboBox::currentIndexChanged, this, [this] { choose(); });
    m_afresh->setAutoDefault(false);
    m_afresh->hide();
    connect(m_afresh, &QPushButton::clicked, this, &TrainingArea::afreshWanted);
}

// A field that loses the focus by being destroyed would take what is still being typed.
TrainingArea::~TrainingArea()
{
    for (QWidget *child : findChildren<QWidget *>())
        child->blockSignals(true);
}

void TrainingArea::endColumn()
{
    m_column->addWidget(m_afresh);
    m_column->addStretch(1);
}

void TrainingArea::offerAfresh(bool canBegin, const QString &toolTip)
{
    m_afresh->show();
    m_afresh->setEnabled(canBegin);
    m_afresh->setToolTip(toolTip);
}

void TrainingArea::setDevices(std::vector<Place> devices, const QString &bus)
{
    const QSignalBlocker silent(m_device);
    m_devices = std::move(devices);
    m_device->clear();
    for (const Place place : m_devices)
        m_device->addItem(place.isEmpty() ? bus : nameOf(place));
    if (m_lastChosen)
        choose(*m_lastChosen);
    content()->setEnabled(!m_devices.empty());
    choose();
}

void TrainingArea::choose()
{
    if (m_chosen)
        leave();
    const int index = m_device->currentIndex();
    m_chosen = index < 0 ? std::nullopt : std::optional(m_devices[static_cast<std::size_t>(index)]);
    if (m_chosen)
        m_lastChosen = m_chosen;
    refresh();
}

// It may have moved since the last frame.
void TrainingArea::setDevice(Place place)
{
    refresh();
    choose(place);
}

void TrainingArea::choose(Place place)
{
    const auto found = std::ranges::find(m_devices, place);
    if (found != m_devices.end())
        m_device->setCurrentIndex(static_cast<int>(found - m_devices.begin()));
}

void TrainingArea::act(const TrainingAct &what)
{
    if (m_chosen)
        Q_EMIT acted(*m_chosen, what);
}

} // namespace codewheel
