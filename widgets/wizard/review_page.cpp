// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/review_page.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "catalog/kept_values.h"
#include "catalog/protocol_rules.h"
#include "jobs/write_plan.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/dial/now_and_then.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/job/job_review.h"
#include "widgets/job/known_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/age_text.h"
#include "widgets/wizard/wanted_scale.h"

#include <QCheckBox>
#include <QRadioButton>

namespace codewheel {
namespace {

constexpr int actionColumn = 3;
constexpr int pictureWidth = 190;
constexpr int leastSteps = 4; // in sight, whatever else the page has to say

// With its age, if it is not up to date.
QString positionNow(const EncoderSession &encoder)
{
    const auto &position = encoder.latest().position;
    if (!position)
        return QChar(0x2013);
    const QString age = ageText(encoder);
    return age.isEmpty() ? numberText(*position) : QStringLiteral("%1, %2").arg(numberText(*position), age);
}

} // namespace

ReviewPage::ReviewPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Review"), parent)
    , m_changesView(named(new QTableView(this), "changes"))
    , m_picture(new NowAndThen(this))
    , m_words(new QLabel(this))
    , m_stepsView(named(new QTableView(this), "plannedWords"))
    , m_writeAll(new QCheckBox(tr("&Write all, including what is already there"), this))
    , m_writes(wrappedLabel(this, "eepromWrites"))
    , m_gate(new EepromGate(this))
    , m_note(wrappedLabel(this, "reviewNotes"))
    , m_byHand(new QRadioButton(tr("Step by step, b&y hand"), this))
    , m_byItself(new QRadioButton(tr("&Running by itself"), this))
    , m_problem(named(new InlineMessage(this), "reviewProblem"))
{
    using Kind = ReviewColumn::Kind;
    m_changes.setColumns(
        {{tr("Parameter")}, {tr("Old"), Kind::value}, {tr("New"), Kind::value}, {tr("What happens")}});
    setUpQuietTable(*m_changesView, m_changes, tr("Old and new values"));
    FittedColumns::useIn(*m_changesView, actionColumn);
    setUpQuietTable(*m_stepsView, m_steps, tr("Words that will be sent"));
    FittedColumns::useIn(*m_stepsView, StepTable::what);
    m_changesView->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_stepsView->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_stepsView->setMinimumHeight(m_stepsView->horizontalHeader()->sizeHint().height() +
                                  leastSteps * m_stepsView->verticalHeader()->defaultSectionSize());
    describe(m_byHand, "byHand", tr("Each step waits until you press Next step."));
    describe(m_byItself, "byItself", tr("The steps follow each other as the encoder confirms them."));
    m_writeAll->setToolTip(tr("Writes everything that is wanted once more."));

    m_picture->setFixedWidth(pictureWidth);
    m_picture->hide();
    QBoxLayout *sent = layOutColumn({m_changesView, m_writeAll, m_problem, m_words, {m_stepsView, 1}},
                                    {.spacing = grid::margin});
    layOutColumn(this,
                 {{layOutRow({{sent, 1}, {m_picture, 0, Qt::AlignTop}}, {.spacing = grid::margin}), 1},
                  m_writes,
                  m_gate,
                  m_note,
                  layOutRow({m_byHand, m_byItself, Stretch{}})},
                 {.spacing = grid::margin});

    setFocusProxy(m_byHand);
    connect(m_writeAll, &QCheckBox::clicked, this, [this](bool on) {
        m_setup.wish.writeAll = on;
        plan();
    });
    connect(m_gate, &EepromGate::changed, this, &WizardPage::changed);
    connect(m_byHand, &QRadioButton::toggled, this, [this](bool on) { m_setup.byHand = on; });
}

void ReviewPage::enter()
{
    m_words->setText(!m_setup.encoder->device().hasWords() ? tr("Requests that will be sent, in this order:")
                                                           : tr("Words that will be sent, in this order:"));
    describe(m_writeAll, "writeAll",
             keepsValues(m_setup.encoder->device())
                 ? tr("Each write uses up one of the writes of the encoder's EEPROM.")
                 : tr("It costs no EEPROM write: the encoder keeps no value without supply."));
    m_writeAll->setChecked(m_setup.wish.writeAll);
    (m_setup.byHand ? m_byHand : m_byItself)->setChecked(true);
    plan();
}

void ReviewPage::plan()
{
    const EncoderSession &encoder = *m_setup.encoder;
    const WritePlan plan = planWrite(encoder, m_setup.wish);
    std::vector<ReviewRow> rows;
    for (const WriteRow &row : plan.rows)
        if (!row.goesAlong || row.isInStepOfOthers())
            rows.push_back(
                {{parameterName(&encoder.device(), row.wanted.parameter),
                  knownText(encoder.device(), row.known), valueWithUnit(encoder.device(), row.wanted),
                  row.isThere                ? tr("already there, not written")
                  : row.isOnlyStored         ? tr("in force already, only stored")
                  : row.isRearmed            ? tr("already there, written if used up")
                  : row.isInStepOfOthers()   ? tr("not wanted, goes along")
                  : plan.job.onlyWhatDiffers ? tr("read, written if it differs")
                                             : tr("written")}});
    showPicture();
    if (const auto position = m_setup.wish.setPositionTo) {
        rows.push_back({{parameterName(Parameter::preset), positionNow(encoder), numberText(*position),
                         tr("the position is set to it")}});
    }
    m_changes.show(std::move(rows));

    m_mayGoOn = !plan.jobs.empty();
    const int writes = eepromWritesOf(plan.steps, encoder.device());
    m_writes->setText(eepromCostText(encoder, writes));
    if (m_mayGoOn) {
        m_steps.showSteps(encoder.device(), plan.steps);
        m_gate->setWrites(*m_setup.encoder, writes);
        m_problem->withdraw();
    } else {
        m_steps.begin();
        m_problem->showMessage(Role::attention, plan.refusal ? refusalText(*plan.refusal) : nothingToWrite());
    }
    const bool setsPosition = m_setup.wish.initialisePreset || m_setup.wish.setPositionTo;
    if (m_mayGoOn && setsPosition && encoder.latest().state == EncoderState::error)
        m_problem->showMessage(Role::attention,
                               tr("The encoder gives no valid position now. If that stays so, the values are "
                                  "written, and the position is not set."));
    if (encoder.latest().mode == Mode::cam && m_mayGoOn) {
        m_mayGoOn = false;
        m_problem->showMessage(
            Role::attention, tr("The encoder is in cam mode, which refuses parameters. Switch it to position "
                                "mode first, with the functions of the parameter panel."));
    }
    const bool modeMissing =
        encoder.device().mayHaveModes() && m_setup.wish.initialisePreset && !encoder.latest().mode;
    if (modeMissing) {
        m_mayGoOn = false;
        m_problem->showMessage(
            Role::attention,
            tr("The position cannot be set: the mode of the encoder is not known, and in cam "
               "mode the same word sets a cam. Say on the page What is known that it is in "
               "position mode, or do not set the position."));
    }
    m_note->setText(notes(plan).join(u'\n'));
    Q_EMIT changed();
}

QString ReviewPage::nothingToWrite() const
{
    const QString why = outOfSightReason(*m_setup.encoder);
    return why.isEmpty()
               ? tr("The encoder has all of these values already: there is nothing to write. Go back and "
                    "change a value, or write all.")
               : tr("The encoder had all of these values when it was seen last. Whether it has them now is "
                    "not known: %1",
                    "a sentence")
                     .arg(why);
}

// Only where the position is set.
void ReviewPage::showPicture()
{
    const WriteWish &wish = m_setup.wish;
    m_picture->setVisible(wish.initialisePreset || wish.setPositionTo);
    m_picture->setEncoder(*m_setup.encoder);
    const ValueOf valueThen = [this](Parameter its) { return valueThenOf(m_setup, its); };
    if (wish.setPositionTo)
        m_picture->setThen(wish.setPositionTo, {}, valueThen);
    else
        m_picture->setThenByPreset(valueThen);
}

bool ReviewPage::mayGoOn() const
{
    return m_mayGoOn && m_gate->isOpen();
}

QStringList ReviewPage::notes(const WritePlan &plan) const
{
    QStringList notes;
    for (const ValueNote &note : plan.notes)
        notes << noteText(note);
    return notes << verificationNote();
}

QString ReviewPage::verificationNote() const
{
    if (m_setup.encoder->can().reads)
        return tr("Afterwards each written value is read back.");
    return activatesByRun(m_setup.encoder->device())
               ? tr("This encoder cannot be read: its confirmation, and operation after run, are the "
                    "evidence.")
               : tr("This encoder cannot be read: its confirmation is the evidence.");
}

} // namespace codewheel
