// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_choice.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "transfer/project_places.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/project/project_document.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int shortestText = 12; // characters

// All that is planned or known of devices, including those outside the project, by number.
std::vector<ProjectDevice> plannedDevices(const ProjectDocument &project)
{
    std::vector<ProjectDevice> devices;
    project.forEachDevice([&](Place number, const ProjectDevice &device) {
        devices.push_back(device);
        devices.back().standAt(number);
    });
    std::ranges::sort(devices, {}, [](const ProjectDevice &device) { return device.place(); });
    return devices;
}

} // namespace

TransferChoice::TransferChoice(const Buses &buses, FindValuesBefore findBefore, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_findBefore(std::move(findBefore))
    , m_what(describe(new QComboBox(this), "transferWhat", tr("What is transferred"),
                      tr("What is transferred. Nothing is sent by choosing.")))
    , m_from(describe(new QComboBox(this), "cloneFrom", tr("Encoder whose values the others get"),
                      tr("The encoder whose values the others get, as far as they are known")))
    , m_before(describe(new QComboBox(this), "valuesBefore", tr("Earlier values"),
                        tr("What the encoder had before this program wrote to it")))
    , m_cams(describe(new QCheckBox(tr("Cam &programs too"), this), "withCams",
                      tr("Cam programs are read in the cam mode of each; leaving one that was changed before "
                         "costs an EEPROM write.")))
{
    // In the order of `What`.
    m_what->addItems({tr("Write what the project wants"), tr("Write what the project has stored"),
                      tr("Store in the project what encoders have"),
                      tr("Give the values of one encoder to others"), tr("Restore earlier values")});
    for (QComboBox *box : {m_what, m_from, m_before}) { // they give way in a narrow window
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(shortestText);
    }
    auto *label = new QLabel(tr("&Transfer"), this);
    label->setBuddy(m_what);
    layOutRow(this, {label, {m_what, 1}, {m_from, 1}, {m_before, 1}, m_cams},
              {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_what);
    showEncoders();
    showParts();
    connect(m_what, &QComboBox::currentIndexChanged, this, [this] {
        showParts();
        Q_EMIT changed();
    });
    connect(m_from, &QComboBox::currentIndexChanged, this, &TransferChoice::changed);
    connect(m_before, &QComboBox::currentIndexChanged, this, &TransferChoice::changed);
    connect(m_cams, &QCheckBox::toggled, this, &TransferChoice::changed);
}

TransferChoice::What TransferChoice::what() const
{
    return static_cast<What>(m_what->currentIndex());
}

void TransferChoice::choose(What what)
{
    m_what->setCurrentIndex(static_cast<int>(what));
    showParts();
}

void TransferChoice::setEncoder(Place number)
{
    m_number = number;
    if (const int row = m_from->findData(number.key()); row >= 0)
        m_from->setCurrentIndex(row);
    if (what() == What::restore)
        fillBefore();
}

std::optional<Place> TransferChoice::from() const
{
    return Place::parse(m_from->currentData().toString());
}

const ValuesBefore *TransferChoice::before() const
{
    const int row = m_before->currentIndex();
    return row < 0 || m_befores.empty() ? nullptr : &m_befores[static_cast<std::size_t>(row)];
}

bool TransferChoice::withCams() const
{
    return m_cams->isChecked();
}

std::vector<TransferWish> TransferChoice::wishes(const Catalog &catalog, const ProjectDocument &project) const
{
    std::vector<TransferWish> wishes;
    const ProjectPlaces places(project.project(), m_buses);
    if (what() == What::restore) {
        if (const ValuesBefore *values = before())
            wishes.push_back(wishToRestore(*values, places));
        return wishes;
    }
    if (what() == What::clone) {
        const auto model = from();
        const EncoderSession *of = model ? m_buses.encoder(*model) : nullptr;
        for (const Place number : m_buses.places())
            if (const EncoderSession *to = m_buses.encoder(number);
                of && to && number != *model && to->can().writes)
                wishes.push_back(wishToClone(*of, *to, withCams()));
        return wishes;
    }
    const TransferSource source = what() == What::write ? TransferSource::wanted : TransferSource::stored;
    for (const ProjectDevice &device : plannedDevices(project)) {
        TransferWish wish = wishOf(device, source, places, catalog);
        if (!wish.values.empty() || !wish.cams.empty())
            wishes.push_back(std::move(wish));
    }
    return wishes;
}

void TransferChoice::showEncoders()
{
    const QSignalBlocker blocker(m_from);
    const QString before = m_from->currentData().toString();
    m_from->clear();
    for (const Place number : m_buses.places())
        if (const EncoderSession *encoder = m_buses.encoder(number); encoder && encoder->can().writes)
            m_from->addItem(QStringLiteral("%1 %2").arg(number.shown(), encoder->device().fullName()),
                            number.key());
    m_from->setCurrentIndex(std::max(0, m_from->findData(before)));
}

void TransferChoice::fillBefore()
{
    const QSignalBlocker blocker(m_before);
    m_befores = m_findBefore(m_number);
    m_before->clear();
    const EncoderSession *encoder = m_buses.encoder(m_number);
    for (const ValuesBefore &before : m_befores)
        m_before->addItem(QStringLiteral("%1  %2: %3")
                              .arg(before.place.shown(), timeOf(before, m_buses.now(before.place)),
                                   textOf(before, encoder ? &encoder->device() : nullptr)));
    m_before->setEnabled(!m_befores.empty());
    if (m_befores.empty() && encoder)
        m_before->addItem(refusalText(whyNothingBefore(*encoder)));
}

void TransferChoice::showParts()
{
    const What chosen = what();
    m_from->setVisible(chosen == What::clone);
    m_before->setVisible(chosen == What::restore);
    m_cams->setVisible(chosen == What::clone || chosen == What::store);
    if (chosen == What::restore)
        fillBefore();
}

} // namespace codewheel
