// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/replace_device_step.h"

#include "bus/buses.h"
#include "bus/participant.h"
#include "catalog/catalog.h"
#include "transfer/transfer_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include <algorithm>

namespace codewheel {
namespace {

// Of an encoder with words its make decides what they mean; one that is asked tells what it has.
bool canBeChosen(const DeviceDescription &device)
{
    return !device.isGeneric() || !device.hasWords();
}

bool isNamed(const DeviceDescription *device)
{
    return device != nullptr && !device->isGeneric();
}

} // namespace

const DeviceDescription *deviceBefore(const Replacing &replacing)
{
    if (const auto *planned = replacing.catalog.find(replacing.before.participant.deviceKey))
        return planned;
    const EncoderSession *connected = replacing.buses.encoder(replacing.place);
    return connected != nullptr ? &connected->device() : nullptr;
}

ReplaceDeviceStep::ReplaceDeviceStep(Replacing &replacing, QWidget *parent)
    : ReplaceStep(replacing, tr("New encoder"), parent)
    , m_planned(wrappedLabel(this))
    , m_key(describe(new QLineEdit(this), "replaceKey", tr("Key on the label of the new encoder"),
                     tr("Type the key on the label. Spaces, dots and dashes do not matter.")))
    , m_choice(describe(new QComboBox(this), "replaceChoice", tr("New encoder"),
                        tr("The encoders of the catalog that fit this place")))
    , m_serial(describe(
          new QLineEdit(this), "replaceSerial", tr("Serial number of the new encoder"),
          tr("From its label; EEPROM writes are counted by it where the encoder does not report one")))
    , m_differences(wrappedLabel(this, "replaceDifferences"))
    , m_message(new InlineMessage(this))
{
    m_key->setClearButtonEnabled(true);
    m_serial->setText(replacing.now.serialNumber);
    auto *fields = new QFormLayout;
    fields->addRow(tr("&Label key"), m_key);
    fields->addRow(tr("Enc&oder"), m_choice);
    fields->addRow(tr("&Serial number"), m_serial);
    layOutColumn(this, {m_planned, fields, m_message, m_differences, Stretch{1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_key);
    connect(m_key, &QLineEdit::textChanged, this, &ReplaceDeviceStep::readKey);
    connect(m_key, &QLineEdit::editingFinished, this, &ReplaceDeviceStep::tellProblem);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &ReplaceDeviceStep::take);
    connect(m_serial, &QLineEdit::textChanged, this, &ReplaceDeviceStep::take);
}

// A field that loses the focus with it has nothing to tell any more.
ReplaceDeviceStep::~ReplaceDeviceStep()
{
    m_key->disconnect(this);
}

void ReplaceDeviceStep::enter()
{
    const ProjectDevice &before = m_replacing.before;
    const DeviceDescription *device = deviceBefore(m_replacing);
    const QString serial = before.label.serialNumber;
    const bool isPlanned = device == m_replacing.catalog.find(before.participant.deviceKey);
    m_planned->setText(
        (isPlanned ? tr("At %1 the project has: %2%3. Switch the supply off, replace the encoder, and switch "
                        "it on again.")
                   : tr("At %1 the bus has: %2%3. Switch the supply off, replace the encoder, and switch it "
                        "on again."))
            .arg(m_replacing.place.shown(), participantName(device),
                 serial.isEmpty() ? QString() : tr(", serial number %1").arg(serial)));
    m_key->setPlaceholderText(exampleOfKey());
    if (m_choice->count() == 0)
        fillChoices();
    else
        showDifferences();
}

Result<void> ReplaceDeviceStep::canBe(const DeviceDescription &device) const
{
    const Place place = m_replacing.place;
    const EncoderBus *bus = m_replacing.buses.busOf(place);
    return bus ? bus->canBe(place, device) : tl::unexpected(m_replacing.buses.whyNotThere(place));
}

// Of an encoder that fits the place.
QString ReplaceDeviceStep::exampleOfKey() const
{
    for (const DeviceDescription &device : m_replacing.catalog.devices())
        if (device.orderingKey && canBe(device))
            return device.orderingKey->example;
    return {};
}

void ReplaceDeviceStep::fillChoices()
{
    const QSignalBlocker blocker(m_choice);
    for (const DeviceDescription &device : m_replacing.catalog.devices())
        if (canBeChosen(device) && device.capabilities.writes && canBe(device))
            m_choice->addItem(device.fullName(), device.key);
    const EncoderSession *connected = m_replacing.buses.encoder(m_replacing.place);
    int like = m_choice->findData(m_replacing.before.participant.deviceKey);
    if (like < 0 && connected != nullptr) // in no project
        like = m_choice->findData(connected->device().key);
    m_choice->setCurrentIndex(std::max(0, like));
    m_key->setText(m_replacing.key);
    take();
}

void ReplaceDeviceStep::readKey(const QString &typed)
{
    m_message->withdraw();
    m_matches.clear();
    m_problem.reset();
    if (!typed.trimmed().isEmpty()) {
        if (auto matches = findByLabel(m_replacing.catalog, typed))
            m_matches = std::move(*matches);
        else
            m_problem = matches.error();
    }
    for (const LabelMatch &match : m_matches)
        if (const int row = m_choice->findData(match.device->key); row >= 0) {
            m_choice->setCurrentIndex(row);
            take();
            return;
        }
    if (!m_matches.empty())
        if (const auto can = canBe(*m_matches.front().device); !can)
            m_message->showMessage(Role::attention, refusalText(can.error()));
    take();
}

// While a key is being typed it is always incomplete, so that is reported only when the typing ends.
void ReplaceDeviceStep::tellProblem()
{
    if (m_problem)
        m_message->showMessage(Role::attention, refusalText(*m_problem));
}

void ReplaceDeviceStep::take()
{
    Replacement &now = m_replacing.now;
    const QString key = m_choice->currentData().toString();
    now.device = m_replacing.catalog.find(key);
    now.turns = 0;
    now.stepsPerTurn = 0;
    for (const LabelMatch &match : m_matches)
        if (match.device->key == key) {
            now.turns = match.turns;
            now.stepsPerTurn = match.stepsPerTurn;
        }
    now.serialNumber = m_serial->text().trimmed();
    m_replacing.key = m_key->text();
    showDifferences();
    Q_EMIT changed();
}

void ReplaceDeviceStep::showDifferences()
{
    const Replacement &now = m_replacing.now;
    if (now.device == nullptr) {
        m_differences->setText(tr("The catalog has no encoder for this place."));
        return;
    }
    const ProjectDevice &before = m_replacing.before;
    const DeviceDescription *device = m_replacing.catalog.find(before.participant.deviceKey);
    const auto differences = differencesOf(before, device, now);
    m_differences->setText(
        !differences.areNone() ? transfer_words::differences(differences, now).join(u'\n')
        : isNamed(device)
            ? tr("It fits: as far as the project shows, it is like the previous one.")
            : tr("The project does not say which encoder was here before: whether this one is like it is "
                 "not known. Compare the labels."));
}

// A key that stands for no encoder of this place must not be ignored.
bool ReplaceDeviceStep::leave()
{
    tellProblem();
    const bool isOther =
        !m_matches.empty() && std::ranges::none_of(m_matches, [this](const LabelMatch &match) {
            return match.device == m_replacing.now.device;
        });
    if (isOther)
        m_message->showMessage(
            Role::attention, tr("The key is not that of the chosen encoder. Choose the encoder of the label, "
                                "or clear the key."));
    return !m_problem && !isOther;
}

} // namespace codewheel
