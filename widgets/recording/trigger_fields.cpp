// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/trigger_fields.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/trend/track_text.h"

#include <QComboBox>
#include <QSignalBlocker>

namespace codewheel {
namespace {

constexpr double largestThreshold = 1e12;
constexpr int thresholdDecimals = 3;

template <class Value>
void choose(QComboBox &box, Value value)
{
    for (int i = 0; i < box.count(); ++i)
        if (box.itemData(i).value<Value>() == value)
            box.setCurrentIndex(i);
}

QString nameOf(const RecordableEncoder &encoder)
{
    return encoder.what.isEmpty() ? encoder.name : QStringLiteral("%1  %2").arg(encoder.name, encoder.what);
}

bool isOfMessages(TriggerChoice::Kind kind)
{
    return kind == TriggerChoice::Kind::fault || kind == TriggerChoice::Kind::attention ||
           kind == TriggerChoice::Kind::message;
}

// The first sample that has reached it. What is less than a millionth of one beyond is an error of division.
std::int64_t firstBeyond(double threshold)
{
    constexpr double error = 1e-6;
    return static_cast<std::int64_t>(std::ceil(threshold - error));
}

Severity leastOf(TriggerChoice::Kind kind)
{
    return kind == TriggerChoice::Kind::fault       ? Severity::fault
           : kind == TriggerChoice::Kind::attention ? Severity::attention
                                                    : Severity::information;
}

} // namespace

TriggerFields::TriggerFields(const std::vector<RecordableEncoder> &encoders,
                             const std::vector<std::pair<BusId, QString>> &buses, QWidget *parent)
    : QWidget(parent)
    , m_encoders(encoders)
    , m_buses(buses)
    , m_kind(describe(new QComboBox(this), "recordingTrigger", tr("Begins"),
                      tr("At once, or once something happens")))
    , m_place(describe(new QComboBox(this), "triggerPlace", tr("Where"), tr("Where it has to happen")))
    , m_word(
          describe(new QComboBox(this), "triggerWord", tr("Word"), tr("The word the bit is in, or the cams")))
    , m_bit(describe(new IntegerField(this), "triggerBit", tr("Number"),
                     tr("The number of the bit, or of the cam")))
    , m_change(describe(new QComboBox(this), "triggerChange", tr("Change"), tr("What the bit becomes")))
    , m_quantity(describe(new QComboBox(this), "triggerQuantity", tr("Value"), tr("What has a threshold")))
    , m_direction(describe(new QComboBox(this), "triggerDirection", tr("Direction"),
                           tr("From which side the threshold is passed")))
    , m_value(describe(new DecimalField(this), "triggerThreshold", tr("Threshold"),
                       tr("What is beyond it already has to come back first")))
    , m_unit(describe(new QComboBox(this), "triggerUnit", tr("Unit of the threshold"),
                      tr("Units are offered as in the trend")))
{
    makeFields();
    layOutColumn(this,
                 {m_kind, m_place,
                  layOutRow({m_word, m_bit, m_change, m_quantity, m_direction, m_value, m_unit, Stretch{1}},
                            {.spacing = grid::unit, .margins = QMargins()})},
                 {.spacing = grid::unit, .margins = QMargins()});
    setFocusProxy(m_kind);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &TriggerFields::showKind);
    connect(m_place, &QComboBox::currentIndexChanged, this, &TriggerFields::showPlace);
    connect(m_word, &QComboBox::currentIndexChanged, this, &TriggerFields::showWord);
    connect(m_quantity, &QComboBox::currentIndexChanged, this, &TriggerFields::showUnits);
    connect(m_unit, &QComboBox::currentIndexChanged, this,
            [this] { m_value->setDecimals(scale().unit == TrackUnit::steps ? 0 : thresholdDecimals); });
    showKind();
}

void TriggerFields::makeFields()
{
    const auto add = [this](const QString &text, Kind kind) {
        m_kind->addItem(text, QVariant::fromValue(static_cast<int>(kind)));
    };
    add(tr("at once"), Kind::atOnce);
    add(tr("when a bit or a cam changes"), Kind::bit);
    add(tr("when a value passes a threshold"), Kind::threshold);
    add(tr("at a fault"), Kind::fault);
    add(tr("at a message of attention or a fault"), Kind::attention);
    add(tr("at any message"), Kind::message);
    m_change->addItem(tr("becomes 1"), true);
    m_change->addItem(tr("becomes 0"), false);
    for (const Channel channel : {Channel::position, Channel::speed})
        m_quantity->addItem(trackText({{}, channel, {}}), QVariant::fromValue(static_cast<int>(channel)));
    m_direction->addItem(tr("rises to"), true);
    m_direction->addItem(tr("falls below"), false);
    m_value->setRange(-largestThreshold, largestThreshold);
    m_value->setDecimals(0);
    m_value->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_value->setMaximumWidth(m_value->fontMetrics().horizontalAdvance(QString(22, u'0')));
    for (QComboBox *box : {m_place, m_word, m_change, m_quantity, m_direction, m_unit})
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
}

TriggerFields::Kind TriggerFields::kind() const
{
    return static_cast<Kind>(m_kind->currentData().toInt());
}

Place TriggerFields::place() const
{
    return m_place->currentData().value<Place>();
}

Channel TriggerFields::channel() const
{
    const QComboBox *its = kind() == Kind::threshold ? m_quantity : m_word;
    return static_cast<Channel>(its->currentData().toInt());
}

const RecordableEncoder *TriggerFields::encoder() const
{
    const auto found = std::ranges::find(m_encoders, place(), &RecordableEncoder::place);
    return found == m_encoders.end() ? nullptr : &*found;
}

TrackScale TriggerFields::scale() const
{
    const RecordableEncoder *its = encoder();
    const auto index = static_cast<std::size_t>(std::max(0, m_unit->currentIndex()));
    return its != nullptr && index < its->scales.size() ? its->scales[index] : TrackScale();
}

bool TriggerFields::lacksEncoder() const
{
    return (kind() == Kind::bit || kind() == Kind::threshold) && encoder() == nullptr;
}

void TriggerFields::showKind()
{
    const Kind kind = this->kind();
    m_place->setVisible(kind != Kind::atOnce);
    for (QWidget *field : std::initializer_list<QWidget *>{m_word, m_bit, m_change})
        field->setVisible(kind == Kind::bit);
    for (QWidget *field : std::initializer_list<QWidget *>{m_quantity, m_direction, m_value, m_unit})
        field->setVisible(kind == Kind::threshold);
    fillPlaces();
}

// The place stays where it can.
void TriggerFields::fillPlaces()
{
    const Place before = place();
    const QSignalBlocker blocker(m_place);
    m_place->clear();
    if (isOfMessages(kind())) {
        m_place->addItem(tr("anywhere"), QVariant::fromValue(Place()));
        for (const auto &[bus, name] : m_buses)
            m_place->addItem(name, QVariant::fromValue(Place{bus, {}}));
    }
    for (const RecordableEncoder &encoder : m_encoders)
        if (kind() != Kind::bit || encoder.hasWords || encoder.hasCams)
            m_place->addItem(nameOf(encoder), QVariant::fromValue(encoder.place));
    choose(*m_place, before);
    showPlace();
}

void TriggerFields::showPlace()
{
    const RecordableEncoder *its = encoder();
    const int word = m_word->currentData().toInt();
    m_word->clear();
    const auto add = [this](Channel channel) {
        m_word->addItem(channel == Channel::cams ? tr("cam") : trackText({{}, channel, {}}),
                        QVariant::fromValue(static_cast<int>(channel)));
    };
    if (its != nullptr && its->hasWords) {
        add(Channel::in);
        add(Channel::out);
    }
    if (its != nullptr && its->hasCams)
        add(Channel::cams);
    choose(*m_word, word);
    showUnits();
}

void TriggerFields::showWord()
{
    const auto bits = static_cast<int>(bitCount(static_cast<Channel>(m_word->currentData().toInt())));
    if (bits > 0)
        m_bit->setMaximum(bits - 1);
}

void TriggerFields::showUnits()
{
    const TrackUnit before = scale().unit;
    const double value = m_value->value(); // its decimals follow the unit
    const bool isFirst = m_unit->count() == 0;
    const RecordableEncoder *its = encoder();
    const auto channel = static_cast<Channel>(m_quantity->currentData().toInt());
    m_unit->clear();
    if (its == nullptr)
        return;
    for (const TrackScale &scale : its->scales) {
        m_unit->addItem(unitSymbol(scale, channel), static_cast<int>(scale.unit));
        if (!isFirst && scale.unit == before)
            m_unit->setCurrentIndex(m_unit->count() - 1);
    }
    m_value->setValue(value);
}

TriggerChoice TriggerFields::choice() const
{
    const bool isBit = kind() == Kind::bit;
    return {.kind = kind(),
            .place = place(),
            .channel = channel(),
            .bit = static_cast<unsigned>(m_bit->value()),
            .rising = (isBit ? m_change : m_direction)->currentData().toBool(),
            .value = m_value->value(),
            .unit = scale().unit};
}

void TriggerFields::setChoice(const TriggerChoice &choice)
{
    choose(*m_kind, static_cast<int>(choice.kind));
    choose(*m_place, choice.place);
    for (QComboBox *box : {m_word, m_quantity})
        choose(*box, static_cast<int>(choice.channel));
    m_bit->setValue(static_cast<int>(choice.bit));
    for (QComboBox *box : {m_change, m_direction})
        choose(*box, choice.rising);
    if (kind() == Kind::threshold)
        choose(*m_unit, static_cast<int>(choice.unit));
    m_value->setValue(choice.value);
}

std::optional<RecordingTrigger> TriggerFields::trigger() const
{
    const TriggerChoice chosen = choice();
    switch (chosen.kind) {
    case Kind::atOnce:
        return {};
    case Kind::bit:
        return BitTrigger{chosen.place, chosen.channel, chosen.bit, chosen.rising};
    case Kind::threshold:
        return ThresholdTrigger{chosen.place, chosen.channel,
                                firstBeyond(chosen.value / scale().factor(chosen.channel)), chosen.rising};
    case Kind::fault:
    case Kind::attention:
    case Kind::message:
        break;
    }
    const bool isAnywhere = chosen.place == Place();
    return MessageTrigger{isAnywhere ? std::nullopt : std::optional(chosen.place), leastOf(chosen.kind)};
}

} // namespace codewheel
