// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_write_bar.h"

#include "kinds/canopen/eds/typed_value.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/dictionary/object_texts.h"
#include "widgets/kinds/canopen/dictionary/object_transfers.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace codewheel {
namespace {

using OutcomeKind = canopen::SdoOutcome::Kind;

// Storing and restoring count as writes to the EEPROM, and are not read back: they do not become what is
// written.
bool isStoreOrRestore(canopen::SdoObject object)
{
    return object.index == canopen::object::store.index || object.index == canopen::object::restore.index;
}

bool isPreset(canopen::SdoObject object)
{
    constexpr std::uint16_t presetsOfSensors = 0x6010;
    return object.index == canopen::object::preset.index || object.index == presetsOfSensors;
}

bool isOfMaker(canopen::SdoObject object)
{
    return object.index >= 0x2000 && object.index < 0x6000;
}

} // namespace

ObjectWriteBar::ObjectWriteBar(ObjectTransfers &transfers, QWidget *parent)
    : QWidget(parent)
    , m_transfers(transfers)
    , m_label(new QLabel(tr("New value"), this))
    , m_field(new QLineEdit(this))
    , m_write(new QPushButton(lineIcon(Icon::write), tr("Write…"), this))
    , m_question(new InlineMessage(this))
    , m_message(new InlineMessage(this))
{
    m_label->setBuddy(m_field);
    m_field->setFont(numberFont());
    m_field->setClearButtonEnabled(true);
    named(m_field, "objectNewValue")->setAccessibleName(tr("New value of the object"));
    named(m_write, "objectWrite")->setAutoDefault(false);
    named(m_question, "objectWriteQuestion");
    named(m_message, "objectWriteMessage");
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::groupGap);
    row->addWidget(m_label);
    row->addWidget(m_field, 1);
    row->addWidget(m_write);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_question);
    column->addWidget(m_message);
    column->addLayout(row);
    connect(m_field, &QLineEdit::textChanged, this, [this] {
        if (m_step == Step::asks)
            reset();
        m_message->withdraw();
    });
    connect(m_field, &QLineEdit::returnPressed, this, &ObjectWriteBar::begin);
    connect(m_write, &QPushButton::clicked, this, &ObjectWriteBar::begin);
    connect(m_question, &InlineMessage::actionTriggered, this, &ObjectWriteBar::writeNow);
    connect(m_question, &InlineMessage::otherActionTriggered, this, &ObjectWriteBar::reset);
    connect(m_question, &InlineMessage::closed, this, &ObjectWriteBar::reset);
    connect(&transfers, &ObjectTransfers::ended, this, &ObjectWriteBar::takeEnd);
    connect(&transfers, &ObjectTransfers::refused, this, &ObjectWriteBar::takeRefused);
    connect(&transfers, &ObjectTransfers::changed, this, &ObjectWriteBar::showWhatIsPossible);
    showWhatIsPossible();
}

void ObjectWriteBar::setObject(const std::optional<canopen::FileObject> &object, std::optional<int> node)
{
    const bool isSame = node == m_node && object && m_object && object->object == m_object->object;
    m_object = object;
    m_node = node;
    if (!isSame) {
        reset();
        m_message->withdraw();
        m_field->clear();
    }
    showWhatIsPossible();
}

void ObjectWriteBar::setWhyNot(const QString &whyNot)
{
    m_whyNot = whyNot;
    if (!whyNot.isEmpty() && (m_step == Step::readsBefore || m_step == Step::asks)) // nothing was sent
        reset();
    showWhatIsPossible();
}

QString ObjectWriteBar::whyNotWritten() const
{
    if (!m_whyNot.isEmpty())
        return m_whyNot;
    if (!m_object)
        return tr("Choose an object of the table first");
    if (m_object->lacksNode)
        return tr("The file has this identifier without the number of the node: it is not written");
    if (!m_object->access)
        return tr("The file does not say whether this object can be written");
    if (!m_object->canBeWritten())
        return tr("This object can only be read");
    return m_transfers.isBusy() ? tr("Objects are being read or written") : QString();
}

void ObjectWriteBar::showWhatIsPossible()
{
    const QString whyNot = whyNotWritten();
    const QString hint =
        tr("A number in decimal, or in hexadecimal as 1388h; a text where the object is one");
    m_write->setEnabled(whyNot.isEmpty());
    m_write->setToolTip(whyNot.isEmpty() ? tr("Reads the object, and asks before it is written (Enter)")
                                         : whyNot);
    m_field->setEnabled(m_object && m_object->canBeWritten());
    m_field->setToolTip(whyNot.isEmpty() ? hint : whyNot);
}

void ObjectWriteBar::reset()
{
    m_step = Step::nothing;
    m_question->withdraw();
}

void ObjectWriteBar::takeWrittenByOther(const canopen::HeardObject &heard)
{
    const bool isAskedAbout =
        m_step == Step::asks && m_object && heard.object == m_object->object && heard.node == m_node;
    if (!isAskedAbout)
        return;
    reset();
    m_message->showMessage(Role::attention,
                           sentence(tr("Nothing was written: another master has just written %1 to %2."),
                                    {textOf(heard.value), m_object->object.text()}));
}

bool ObjectWriteBar::isRead() const
{
    return m_object->access != canopen::FileAccess::writeOnly;
}

// As wide as the node has answered; "save" and "load" are typed as letters, too.
std::optional<std::vector<std::uint8_t>> ObjectWriteBar::typedOctets() const
{
    constexpr qsizetype signatureLetters = 4;
    const QString typed = m_field->text();
    if (isStoreOrRestore(m_object->object) &&
        (typed == QLatin1String("save") || typed == QLatin1String("load")) &&
        typed.size() == signatureLetters)
        return canopen::octetsTyped(typed, canopen::DataType::text, 0);
    const bool isWidthTold = m_before.kind == OutcomeKind::read && m_before.isSizeTold;
    return canopen::octetsTyped(typed, m_object->type, isWidthTold ? m_before.value.size() : 0);
}

void ObjectWriteBar::begin()
{
    reset();
    m_message->withdraw();
    if (!whyNotWritten().isEmpty())
        return;
    Q_EMIT begun();
    m_before = {};
    std::vector<canopen::SdoObject> before;
    if (m_asksWho)
        before = {canopen::object::vendor, canopen::object::product};
    if (isRead())
        before.push_back(m_object->object);
    if (before.empty()) {
        ask();
        return;
    }
    m_step = Step::readsBefore;
    m_lastBefore = before.back();
    m_transfers.read(before);
}

void ObjectWriteBar::ask()
{
    const auto octets = typedOctets();
    if (!octets) {
        reset();
        m_message->showMessage(
            Role::attention,
            sentence(tr("Nothing was written: \"%1\" is no value for %2, or does not fit into it."),
                     {m_field->text(), m_object->object.text()}));
        return;
    }
    m_step = Step::asks;
    m_octets = *octets;
    m_question->showMessage(Role::attention, question(*octets) + warnings(*octets), tr("W&rite it"),
                            tr("Do &not write"));
    m_question->focusSafe();
}

QString ObjectWriteBar::textOf(const std::vector<std::uint8_t> &octets) const
{
    return objectValueText(canopen::fileValueOf(m_object->type, octets), m_object->type);
}

QString ObjectWriteBar::question(const std::vector<std::uint8_t> &octets) const
{
    const QString what =
        m_object->name.isEmpty() ? m_object->object.text() : m_object->object.text() + u' ' + m_object->name;
    const QStringList parts{QString::number(m_node.value_or(0)), what, objectAccessText(m_object->access),
                            m_before.kind == OutcomeKind::read ? textOf(m_before.value) : tr("not known"),
                            textOf(octets)};
    return tr("Node %1, %2 (%3): the value is %4 and becomes %5.",
              "node, object, access, old value, new value")
        .arg(parts[0], parts[1], parts[2], parts[3], parts[4]);
}

QString ObjectWriteBar::warnings(const std::vector<std::uint8_t> &octets) const
{
    QString text;
    if (isStoreOrRestore(m_object->object))
        text += u' ' + tr("It counts as a write to the EEPROM.");
    if (isPreset(m_object->object))
        text += u' ' + tr("It sets the position at once.");
    if (isOfMaker(m_object->object))
        text +=
            u' ' + tr("It is an object of the maker: it may set the position, change number or rate, or be "
                      "stored at once. Look into the manual of the encoder.");
    const canopen::FileValue value = canopen::fileValueOf(m_object->type, octets);
    if (const auto limit = canopen::limitBroken(*m_object, value, m_node))
        text += u' ' + sentence(tr("It is outside of the limits of the file: %1."),
                                {objectValueText(*limit, m_object->type)});
    if (!m_doubt.isEmpty())
        text += u' ' + m_doubt;
    return text;
}

void ObjectWriteBar::writeNow()
{
    m_question->withdraw();
    if (std::exchange(m_step, Step::nothing) != Step::asks || !whyNotWritten().isEmpty())
        return;
    m_step = Step::writes;
    m_transfers.write(m_object->object, m_octets);
}

void ObjectWriteBar::takeEnd(const canopen::SdoRequest &request, const canopen::SdoOutcome &outcome)
{
    const bool isWrite = request.value.has_value();
    const bool isOfObject = m_object && request.object == m_object->object;
    if (m_step == Step::readsBefore && !isWrite)
        takeBefore(request.object, outcome);
    else if (m_step == Step::writes && isWrite && isOfObject)
        takeWritten(outcome);
    else if (m_step == Step::readsBack && !isWrite && isOfObject)
        tellReadBack(outcome);
}

void ObjectWriteBar::takeBefore(canopen::SdoObject object, const canopen::SdoOutcome &outcome)
{
    const bool isOfObject = object == m_object->object;
    if (isOfObject)
        m_before = outcome;
    if (outcome.kind == OutcomeKind::noAnswer || outcome.kind == OutcomeKind::notSent) {
        reset();
    } else if (isOfObject && canopen::isMissing(outcome)) {
        reset();
        tellAborted(outcome);
    } else if (object == m_lastBefore) {
        ask();
    }
}

// What is read back is not, once the link is gone.
void ObjectWriteBar::takeRefused()
{
    if (m_step == Step::readsBack)
        tellReadBack({.kind = OutcomeKind::notSent});
    reset();
}

void ObjectWriteBar::takeWritten(const canopen::SdoOutcome &outcome)
{
    m_step = Step::nothing;
    m_isAcknowledged = outcome.kind == OutcomeKind::written;
    if (outcome.kind == OutcomeKind::aborted) {
        tellAborted(outcome);
    } else if (outcome.kind == OutcomeKind::notSent) {
        m_message->showMessage(Role::attention, tr("Nothing was sent."));
    } else if (isRead() && !isStoreOrRestore(m_object->object)) {
        m_step = Step::readsBack;
        m_transfers.read({m_object->object});
    } else if (m_isAcknowledged) {
        m_message->showMessage(Role::running, tr("Accepted, not read back."));
    } else {
        m_message->showMessage(Role::attention, tr("No answer: whether it was written is not known."));
    }
}

void ObjectWriteBar::tellAborted(const canopen::SdoOutcome &outcome)
{
    m_message->showMessage(Role::attention,
                           refusalText({RefusalKind::device,
                                        CanopenRefusalId::sdoAborted,
                                        {m_object->object.text(), Word{outcome.abortCode}}}));
}

// Without an acknowledgement, the value of before tells nothing.
void ObjectWriteBar::tellReadBack(const canopen::SdoOutcome &outcome)
{
    m_step = Step::nothing;
    const bool isKnown = outcome.kind == OutcomeKind::read;
    const bool isThere = isKnown && outcome.value == m_octets;
    const bool wasThere = m_before.kind == OutcomeKind::read && m_before.value == m_octets;
    if (isThere && (m_isAcknowledged || !wasThere))
        m_message->showMessage(Role::running, tr("Written, and read back."));
    else if (!isKnown && m_isAcknowledged)
        m_message->showMessage(Role::running, tr("Accepted, not read back."));
    else if (!isKnown || isThere)
        m_message->showMessage(Role::attention, tr("No answer: whether it was written is not known."));
    else
        m_message->showMessage(Role::attention,
                               sentence(tr("Another value is read back: %1."), {textOf(outcome.value)}));
}

} // namespace codewheel
