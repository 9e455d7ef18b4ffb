// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/recording/recording_choices.h"
#include "widgets/recording/recording_subjects.h"

class QComboBox;

namespace codewheel {

// When a recording begins: at once, or by which trigger.
class TriggerFields : public QWidget
{
    Q_OBJECT

public:
    TriggerFields(const std::vector<RecordableEncoder> &encoders,
                  const std::vector<std::pair<BusId, QString>> &buses, QWidget *parent);

    TriggerChoice choice() const;
    void setChoice(const TriggerChoice &choice);
    std::optional<RecordingTrigger> trigger() const; // nothing: at once
    bool lacksEncoder() const;                       // there is none that could be its place

private:
    using Kind = TriggerChoice::Kind;

    void makeFields();
    Kind kind() const;
    Place place() const;
    Channel channel() const; // of a threshold, or a bit
    TrackScale scale() const;
    const RecordableEncoder *encoder() const;
    void showKind();
    void fillPlaces();
    void showPlace();
    void showWord();
    void showUnits();

    const std::vector<RecordableEncoder> m_encoders;
    const std::vector<std::pair<BusId, QString>> m_buses;
    QComboBox *m_kind;
    QComboBox *m_place;
    QComboBox *m_word; // whose bit
    IntegerField *m_bit;
    QComboBox *m_change;
    QComboBox *m_quantity;
    QComboBox *m_direction;
    DecimalField *m_value;
    QComboBox *m_unit;
};

} // namespace codewheel
