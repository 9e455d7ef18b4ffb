// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_dialog.h"

#include "recording/recording_writer.h"
#include "vocabulary/refusal_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/recording/duration_field.h"
#include "widgets/recording/encoder_choice.h"
#include "widgets/recording/recording_file_field.h"
#include "widgets/recording/trigger_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t bytesOfMegabyte = 1'000'000;
constexpr int leastLimit = 1;            // MB
constexpr int mostLimit = 1'000'000'000; // MB
constexpr int leastToStayFree = 100;     // MB
constexpr QSize recordingSize(620, 560);
constexpr auto oftenEnoughForRoom = 1s;

IntegerField *sizeField(QWidget *parent, const char *id, const QString &name, const QString &tip, int least)
{
    auto *field = describe(new IntegerField(parent), id, name, tip);
    field->setRange(least, mostLimit);
    field->setSuffix(RecordingDialog::tr(" MB", "megabytes"));
    return field;
}

QString recordingFolder(const RecordingChoices &choices)
{
    const bool isThere = !choices.folder.isEmpty() && QFileInfo(choices.folder).isDir();
    if (isThere)
        return choices.folder;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

} // namespace

RecordingDialog::RecordingDialog(RecordingSubjects subjects, const RecordingChoices &choices, QWidget *parent)
    : QDialog(parent)
    , m_subjects(std::move(subjects))
    , m_file(new RecordingFileField(this))
    , m_encoders(new EncoderChoice(m_subjects.encoders, this))
    , m_traffic(describe(new QCheckBox(tr("&Requests, answers and words as they pass"), this),
                         "recordTraffic",
                         tr("What the trace and the terminal show; on a serial line it needs the most room")))
    , m_trigger(new TriggerFields(m_subjects.encoders, m_subjects.buses, this))
    , m_before(new DurationField(
          "recordBefore", tr("Before"),
          tr("What was shown before that is recorded too, as far as the trend keeps it"), this))
    , m_ends(describe(new QComboBox(this), "recordingEnd", tr("Ends"), tr("By hand, or after a time")))
    , m_after(new DurationField("recordAfter", tr("Duration"), tr("From the beginning, or from the trigger"),
                                this))
    , m_isKeptFor(describe(new QCheckBox(tr("Only the &last"), this), "recordOnlyLast",
                           tr("What is older gives way to what comes")))
    , m_keptFor(new DurationField("recordKeptFor", tr("Only the last"), tr("How far back the recording goes"),
                                  this))
    , m_hasSize(describe(new QCheckBox(tr("At &most"), this), "recordHasSize",
                         tr("Once it is that large, the oldest gives way to what comes")))
    , m_size(sizeField(this, "recordSize", tr("Largest size"), tr("How large the file becomes"), leastLimit))
    , m_free(sizeField(this, "recordFree", tr("Leave free"),
                       tr("So much of the disk is left to others; the recording waits where there is less"),
                       leastToStayFree))
    , m_room(wrappedLabel(this, "recordingRoom"))
    , m_message(new InlineMessage(this))
{
    setObjectName(QStringLiteral("recordingDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Record"));
    setHelpTopic(*this, "recording.md");
    m_ends->addItem(tr("when it is ended by hand"), false);
    m_ends->addItem(tr("after"), true);
    layOutParts();
    setChoices(choices);
    m_file->propose(recordingFolder(choices), m_subjects.now);
    connectParts();
    showRoom();
    m_file->setFocus();
    m_file->line().selectAll();
    resize(minimumSizeHint().expandedTo(recordingSize));
}

void RecordingDialog::layOutParts()
{
    auto *content = new QWidget(this);
    auto *form = makeForm(content, grid::margin, grid::margin);
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const auto row = [](LayoutParts parts) {
        return layOutRow(parts, {.spacing = grid::unit, .margins = QMargins()});
    };
    form->addRow(tr("&File"), m_file);
    form->addRow(tr("Encoders"), m_encoders);
    form->addRow(QString(), m_traffic);
    form->addRow(tr("&Begins"), m_trigger);
    form->addRow(tr("B&efore"), m_before);
    auto *ends = new QLabel(tr("E&nds"), content);
    ends->setBuddy(m_ends);
    form->addRow(ends, row({m_ends, m_after, Stretch{1}}));
    form->addRow(m_isKeptFor, row({m_keptFor, Stretch{1}}));
    form->addRow(m_hasSize, row({m_size, Stretch{1}}));
    auto *free = new QLabel(tr("Lea&ve free"), content);
    free->setBuddy(m_free);
    form->addRow(free, row({m_free, Stretch{1}}));
    layOutColumn(this, {{new ContentScrollArea(content, this), 1}, m_room, m_message},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    makeButtons();
}

void RecordingDialog::makeButtons()
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    auto *record = buttons->addButton(tr("Re&cord"), QDialogButtonBox::AcceptRole);
    record->setIcon(lineIcon(Icon::record));
    describe(record, "beginRecording",
             tr("Makes the file, and begins or waits for the trigger; sends nothing"));
    record->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Records nothing (Esc)"));
    layout()->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &RecordingDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void RecordingDialog::connectParts()
{
    connect(m_file, &RecordingFileField::changed, this, &RecordingDialog::showRoom);
    connect(m_encoders, &EncoderChoice::changed, this, &RecordingDialog::showRoom);
    connect(m_keptFor, &DurationField::changed, this, &RecordingDialog::showRoom);
    for (QCheckBox *box : {m_traffic, m_isKeptFor, m_hasSize})
        connect(box, &QCheckBox::toggled, this, &RecordingDialog::showRoom);
    for (QSpinBox *box : {m_size, m_free})
        connect(box, &QSpinBox::valueChanged, this, &RecordingDialog::showRoom);
    connect(m_isKeptFor, &QCheckBox::toggled, m_keptFor, &QWidget::setEnabled);
    connect(m_hasSize, &QCheckBox::toggled, m_size, &QWidget::setEnabled);
    connect(m_ends, &QComboBox::currentIndexChanged, this,
            [this] { m_after->setVisible(m_ends->currentData().toBool()); });
    connect(&m_often, &QTimer::timeout, this, &RecordingDialog::showRoom);
    m_often.start(oftenEnoughForRoom);
}

void RecordingDialog::setChoices(const RecordingChoices &choices)
{
    m_encoders->setPlaces(choices.places);
    m_traffic->setChecked(choices.withTraffic);
    m_trigger->setChoice(choices.trigger);
    m_before->setValue(choices.before);
    m_ends->setCurrentIndex(m_ends->findData(choices.endsByItself));
    m_after->setValue(choices.after);
    m_after->setVisible(choices.endsByItself);
    m_isKeptFor->setChecked(choices.isKeptFor);
    m_keptFor->setValue(choices.keptFor);
    m_keptFor->setEnabled(choices.isKeptFor);
    m_hasSize->setChecked(choices.hasLargestSize);
    m_size->setValue(choices.largestSize);
    m_size->setEnabled(choices.hasLargestSize);
    m_free->setValue(choices.leastFree);
}

RecordingChoices RecordingDialog::choices() const
{
    return {.folder = QFileInfo(m_file->file()).path(),
            .places = m_encoders->places(),
            .withTraffic = m_traffic->isChecked(),
            .trigger = m_trigger->choice(),
            .before = m_before->value(),
            .after = m_after->value(),
            .endsByItself = m_ends->currentData().toBool(),
            .keptFor = m_keptFor->value(),
            .isKeptFor = m_isKeptFor->isChecked(),
            .largestSize = m_size->value(),
            .hasLargestSize = m_hasSize->isChecked(),
            .leastFree = m_free->value()};
}

RecordingPlan RecordingDialog::plan() const
{
    const RecordingChoices chosen = choices();
    RecordingPlan plan{.settings = {.file = m_file->file()}};
    plan.settings.keptFor = chosen.isKeptFor ? chosen.keptFor : Instant(0);
    plan.settings.largestSize = chosen.hasLargestSize ? chosen.largestSize * bytesOfMegabyte : 0;
    plan.settings.leastFree = chosen.leastFree * bytesOfMegabyte;
    plan.places = chosen.places;
    plan.withTraffic = chosen.withTraffic;
    plan.trigger = m_trigger->trigger();
    plan.extent = {chosen.before, chosen.endsByItself ? std::optional(chosen.after) : std::nullopt};
    return plan;
}

RecordingRoom RecordingDialog::room() const
{
    const RecordingPlan its = plan();
    return {.free = freeBytesAt(its.settings.file),
            .leastFree = its.settings.leastFree,
            .keptFor = its.settings.keptFor,
            .largestSize = its.settings.largestSize,
            .bytesPerSecond = m_subjects.bytesPerSecond(its.places, its.withTraffic)};
}

void RecordingDialog::showRoom()
{
    const QString text = QFileInfo(QFileInfo(m_file->file()).path()).isDir() ? roomText(room()) : QString();
    if (m_room->text() != text)
        m_room->setText(text);
}

// What is not given as yet, at the field where it belongs.
bool RecordingDialog::complain()
{
    const auto say = [this](const QString &sentence, QWidget &field) {
        m_message->showMessage(Role::attention, sentence);
        field.setFocus();
        return true;
    };
    if (m_encoders->isNone())
        return say(tr("Tick the encoders that are to be recorded, or choose all."), *m_encoders);
    if (m_trigger->lacksEncoder())
        return say(
            tr("No encoder is there that could begin the recording: connect one first, or let it begin "
               "at once."),
            *m_trigger);
    if (m_ends->currentData().toBool() && m_after->value() <= Instant(0))
        return say(tr("Say how long it is to record."), *m_after);
    if (m_isKeptFor->isChecked() && m_keptFor->value() <= Instant(0))
        return say(tr("Say how far back it is to go."), *m_keptFor);
    return false;
}

// What is being typed counts; if refused, it stays to be corrected.
void RecordingDialog::accept()
{
    m_message->withdraw();
    if (!takeFields(*this).isEmpty() || complain())
        return;
    if (const auto begun = m_subjects.begin(plan()); !begun)
        m_message->showMessage(Role::fault, refusalText(begun.error()));
    else
        QDialog::accept();
}

} // namespace codewheel
