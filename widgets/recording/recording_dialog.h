// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/recording/recording_choices.h"
#include "widgets/recording/recording_subjects.h"
#include "widgets/recording/recording_texts.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace codewheel {

class DurationField;
class EncoderChoice;
class InlineMessage;
class RecordingFileField;
class TriggerFields;

// File > Record: what is recorded, to which file, when it begins and ends, and its limits. Stays open, and
// says why, where it cannot be begun.
class RecordingDialog : public QDialog
{
    Q_OBJECT

public:
    RecordingDialog(RecordingSubjects subjects, const RecordingChoices &choices, QWidget *parent);

    RecordingChoices choices() const;
    void accept() override;

private:
    void layOutParts();
    void makeButtons();
    void connectParts();
    void setChoices(const RecordingChoices &choices);
    RecordingPlan plan() const;
    RecordingRoom room() const;
    void showRoom();
    bool complain();

    const RecordingSubjects m_subjects;
    RecordingFileField *m_file;
    EncoderChoice *m_encoders;
    QCheckBox *m_traffic;
    TriggerFields *m_trigger;
    DurationField *m_before;
    QComboBox *m_ends;
    DurationField *m_after;
    QCheckBox *m_isKeptFor;
    DurationField *m_keptFor;
    QCheckBox *m_hasSize;
    QSpinBox *m_size;
    QSpinBox *m_free;
    QLabel *m_room;
    InlineMessage *m_message;
    QTimer m_often; // for what changes by itself: room and rate
};

} // namespace codewheel
