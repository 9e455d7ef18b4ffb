// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_details.h"

#include "vocabulary/refusal_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/recording/recording_texts.h"
#include "widgets/trend/ticks.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr int longestRecordedNote = 200; // characters
constexpr int detailsWidth = 460;

QString dayAndTime(Instant at)
{
    const auto since1970 = std::chrono::duration_cast<std::chrono::milliseconds>(at).count();
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(since1970), QLocale::ShortFormat);
}

QString stateText(const ShownRecording &recording)
{
    if (recording.waits && recording.plan.trigger)
        return RecordingDetails::tr("waits for: %1", "trigger").arg(triggerText(*recording.plan.trigger));
    if (!recording.span)
        return RecordingDetails::tr("records; no encoder shows anything as yet");
    return recording.span->to == Instant::max()
               ? RecordingDetails::tr("records until it is ended")
               : RecordingDetails::tr("records until %1").arg(dayAndTime(recording.span->to));
}

QString encodersText(const RecordingPlan &plan)
{
    QStringList places;
    for (const Place place : plan.places)
        places << place.shown();
    const QString which =
        places.isEmpty() ? RecordingDetails::tr("all encoders") : places.join(QStringLiteral(", "));
    return plan.withTraffic ? RecordingDetails::tr("%1, with requests and answers", "encoders").arg(which)
                            : RecordingDetails::tr("%1, without requests and answers", "encoders").arg(which);
}

QString sizeWithLimitText(const ShownRecording &recording)
{
    const RecordingSettings &settings = recording.plan.settings;
    QStringList parts{sizeText(recording.status.bytes)};
    if (settings.largestSize > 0)
        parts << RecordingDetails::tr("at most %1", "size").arg(sizeText(settings.largestSize));
    if (settings.keptFor > Instant(0))
        parts << RecordingDetails::tr("only the last %1", "duration")
                     .arg(roughDurationText(settings.keptFor, QLocale()));
    return parts.join(QStringLiteral("; "));
}

QString fullText(const ShownRecording &recording)
{
    const RecordingStatus &status = recording.status;
    const RecordingSettings &settings = recording.plan.settings;
    if (!status.timeUntilFull)
        return RecordingDetails::tr("not known as yet");
    const QString time = roughDurationText(*status.timeUntilFull, QLocale());
    const bool isBySize = settings.largestSize > 0 &&
                          settings.largestSize - status.bytes < status.freeBytes - settings.leastFree;
    if (isBySize)
        return RecordingDetails::tr("largest size in %1, then the oldest gives way").arg(time);
    if (settings.keptFor > Instant(0) && *status.timeUntilFull > settings.keptFor)
        return RecordingDetails::tr("never: the oldest gives way before");
    return RecordingDetails::tr("disk full in %1").arg(time);
}

} // namespace

RecordingDetails::RecordingDetails(QWidget *parent)
    : QDialog(parent, Qt::Tool)
    , m_file(named(new QLineEdit(this), "recordingFileNow"))
    , m_message(new InlineMessage(this))
    , m_note(describe(new QLineEdit(this), "recordingNote", tr("Note"),
                      tr("What happens now: comes into the recording, and into the trend (Return)")))
    , m_add(describe(new QPushButton(tr("&Add note"), this), "addRecordingNote",
                     tr("Puts the note at this moment (Return)")))
{
    setObjectName(QStringLiteral("recordingDetails"));
    setWindowTitle(tr("Recording"));
    setHelpTopic(*this, "recording.md#while-it-runs");
    m_note->setMaxLength(longestRecordedNote);
    m_note->setFocus();
    m_note->setPlaceholderText(tr("What happens now"));
    m_add->setAutoDefault(false);
    auto *form = makeForm(nullptr, grid::unit);
    m_file->setReadOnly(true);
    form->addRow(tr("File"), m_file);
    addRow(*form, Row::state, "recordingStateNow", tr("State"));
    addRow(*form, Row::encoders, "recordingEncodersNow", tr("Encoders"));
    addRow(*form, Row::since, "recordingSince", tr("Since"));
    addRow(*form, Row::size, "recordingSizeNow", tr("Size"));
    addRow(*form, Row::free, "recordingFreeNow", tr("Free on the disk"));
    addRow(*form, Row::full, "recordingFull", tr("Full"));
    addRow(*form, Row::lost, "recordingLost", tr("Lost values"));
    layOutColumn(this,
                 {m_message,
                  {form, 1},
                  layOutRow({{m_note, 1}, m_add}, {.spacing = grid::unit, .margins = QMargins()})},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    makeButtons();
    resize(std::max(detailsWidth, minimumSizeHint().width()), sizeHint().height());
}

void RecordingDetails::addRow(QFormLayout &form, Row row, const char *id, const QString &title)
{
    QLabel *value = describe(wrappedLabel(this), id, title, QString());
    value->setTextFormat(Qt::PlainText);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form.addRow(title, value);
    m_values[row] = value;
}

void RecordingDetails::makeButtons()
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_fire = buttons->addButton(tr("&Record now"), QDialogButtonBox::ActionRole);
    describe(m_fire, "fireRecording", tr("Begins without waiting any longer for the trigger"));
    auto *end = buttons->addButton(tr("&End recording"), QDialogButtonBox::ActionRole);
    describe(end, "endRecording", tr("Writes what has come, and closes the file"));
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("The recording goes on (Esc)"));
    for (QAbstractButton *button : buttons->buttons())
        static_cast<QPushButton *>(button)->setAutoDefault(false);
    layout()->addWidget(buttons);
    connect(m_fire, &QPushButton::clicked, this, &RecordingDetails::fireWanted);
    connect(end, &QPushButton::clicked, this, &RecordingDetails::endWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_note, &QLineEdit::returnPressed, this, &RecordingDetails::takeNote);
    connect(m_add, &QPushButton::clicked, this, &RecordingDetails::takeNote);
    connect(m_note, &QLineEdit::textChanged, this,
            [this](const QString &text) { m_add->setEnabled(!text.trimmed().isEmpty()); });
    m_add->setEnabled(false);
}

void RecordingDetails::showRow(Row row, const QString &text)
{
    QLabel *label = m_values.at(row);
    if (label->text() != text)
        label->setText(text);
}

void RecordingDetails::showRecording(const ShownRecording &recording)
{
    const RecordingStatus &status = recording.status;
    const bool isWritten = status.written > Instant(0);
    const QString nothing = QStringLiteral("\u2013");
    if (const QString file = QDir::toNativeSeparators(recording.plan.settings.file); m_file->text() != file) {
        m_file->setText(file);
        describe(m_file, tr("File"), file);
    }
    showRow(Row::state, stateText(recording));
    showRow(Row::encoders, encodersText(recording.plan));
    showRow(Row::since, recording.span && isWritten
                            ? tr("%1, for %2", "date and time, duration")
                                  .arg(dayAndTime(recording.span->from),
                                       countedText(status.written - recording.span->from))
                            : nothing);
    showRow(Row::size, sizeWithLimitText(recording));
    showRow(Row::free, status.freeBytes > 0
                           ? tr("%1, of which %2 stay free", "sizes")
                                 .arg(sizeText(status.freeBytes), sizeText(recording.plan.settings.leastFree))
                           : nothing);
    showRow(Row::full, fullText(recording));
    showRow(Row::lost,
            status.lost == 0 ? tr("none") : QLocale().toString(static_cast<qulonglong>(status.lost)));
    m_fire->setVisible(recording.waits);
    showProblem(status.problem);
    // Lines that are broken may need more than there was.
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

void RecordingDetails::showProblem(const std::optional<Refusal> &problem)
{
    if (problem) {
        const QString sentence = refusalText(*problem);
        if (!m_tellsProblem || m_message->sentence() != sentence)
            m_message->showMessage(Role::attention, tr("%1 What comes meanwhile is kept in memory, as far as "
                                                       "there is room, and written once that is over.")
                                                        .arg(sentence));
    } else if (m_tellsProblem)
        m_message->withdraw();
    m_tellsProblem = problem.has_value();
}

void RecordingDetails::tellThatItRuns()
{
    if (!m_tellsProblem)
        m_message->showMessage(Role::attention,
                               tr("This recording runs already. End it before you begin another one."));
}

void RecordingDetails::takeNote()
{
    const QString text = m_note->text().simplified();
    if (text.isEmpty())
        return;
    m_note->clear();
    Q_EMIT noteWanted(text);
}

} // namespace codewheel
