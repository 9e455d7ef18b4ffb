// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_review.h"

#include "cams/cam_fields.h"
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "vocabulary/hex.h"
#include "vocabulary/mode_text.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/look/describe.h"
#include "widgets/models/age_text.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>

#include <algorithm>

namespace codewheel {
namespace {

QString fieldText(CamField field, std::int64_t value)
{
    if (field.value != CamValue::activeCams)
        return cam_texts::position(value);
    QStringList cams;
    for (unsigned cam = 0; cam < CamProgram::cams; ++cam)
        if ((value >> cam & 1) != 0)
            cams << QString::number(cam);
    return cams.isEmpty() ? CamReview::tr("none") : cams.join(QStringLiteral(", "));
}

bool setsCams(const Step &step)
{
    return step.effect == Effect::takesCams;
}

// The encoder's value of what the word sets; nothing: not known.
std::optional<std::int64_t> valueThere(const EncoderSession &encoder, std::optional<unsigned> program,
                                       CamField field)
{
    const auto known = program ? encoder.cams(*program) : std::nullopt;
    return known ? std::optional(valueOf(known->program, field)) : std::nullopt;
}

struct Words
{
    std::vector<ReviewRow> rows;
    QStringList thereAlready;
};

// In the order in which they are sent, between those that read.
Words wordsOf(const EncoderSession &encoder, const std::vector<Step> &steps)
{
    Words words;
    if (std::ranges::none_of(steps, setsCams))
        return words;
    std::optional<unsigned> program = encoder.latest().camProgram;
    for (const Step &step : steps) {
        const CamStep cams = protocolOf(encoder.device()).camStep(step);
        if (cams.choosesProgram)
            program = cams.program;
        if (readsCams(step))
            continue;
        const auto &field = cams.field;
        const auto there = field ? valueThere(encoder, program, *field) : std::nullopt;
        words.rows.push_back({{program ? QString::number(*program) : QString(), hexWord(step.out),
                               stepText(encoder.device(), step),
                               !field  ? QString()
                               : there ? fieldText(*field, *there)
                                       : CamReview::tr("unknown")}});
        if (there && *there == cams.value && !words.thereAlready.contains(hexWord(step.out)))
            words.thereAlready << hexWord(step.out);
    }
    return words;
}

} // namespace

CamReview::CamReview(QWidget *parent)
    : JobReview("confirmWriteCams", parent)
    , m_title(new QLabel(this))
    , m_afterwardsLabel(new QLabel(tr("A&fterwards the encoder is in"), this))
    , m_afterwards(describe(new QComboBox(this), tr("Mode afterwards"),
                            tr("Cams are written in cam mode: no position is shown meanwhile. A program is "
                               "stored in EEPROM when it is left.")))
{
    QFont strong = font();
    strong.setBold(true);
    m_title->setFont(strong);
    m_afterwardsLabel->setBuddy(m_afterwards);
    addTitle(m_title);
    addOption(m_afterwardsLabel);
    addOption(m_afterwards);
    connect(m_afterwards, &QComboBox::currentIndexChanged, this, &CamReview::showContents);
}

void CamReview::offerAfterwards(const SwitchMode &before)
{
    const QSignalBlocker untilAllAreThere(m_afterwards);
    m_choices = {before};
    const auto offer = [this](const SwitchMode &mode) {
        if (std::ranges::find(m_choices, mode) == m_choices.end())
            m_choices.push_back(mode);
    };
    offer({.mode = Mode::position});
    offer({.mode = Mode::cam, .camProgram = m_programs.back().number});
    m_afterwards->clear();
    for (const SwitchMode &choice : m_choices)
        m_afterwards->addItem(modeText(choice));
}

void CamReview::review(EncoderSession &encoder, const std::vector<CamProgram> &programs,
                       const SwitchMode &before)
{
    m_programs = programs;
    offerAfterwards(before);
    for (QWidget *option : {static_cast<QWidget *>(m_afterwardsLabel), static_cast<QWidget *>(m_afterwards)})
        option->setVisible(encoder.can().cams->hasMode);
    m_title->setText(programs.size() == 1 ? tr("Write cam program %1 to the encoder at %2")
                                                .arg(programs.front().number)
                                                .arg(encoder.place().shown())
                                          : tr("Write %1 cam programs to the encoder at %2")
                                                .arg(programs.size())
                                                .arg(encoder.place().shown()));
    using Kind = ReviewColumn::Kind;
    begin(encoder,
          {{tr("Program")}, {tr("Word"), Kind::code}, {tr("Meaning")}, {tr("Encoder has"), Kind::value}},
          tr("Sends these words in this order, and reads before and after"));
    table().horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table().horizontalHeader()->setSectionResizeMode(meaningColumn, QHeaderView::Stretch);
}

QString CamReview::nothingToWrite(const EncoderSession &encoder)
{
    const QString why = outOfSightReason(encoder);
    return why.isEmpty() ? tr("The encoder is known to have all of it. There is nothing to write.")
                         : tr("The encoder had all of it when it was seen last. Whether it has it now is "
                              "not known: %1",
                              "a sentence")
                               .arg(why);
}

JobReview::Contents CamReview::contents(const EncoderSession &encoder, bool writesAll) const
{
    const WriteCams job{
        .programs = m_programs,
        .onlyWhatDiffers = !writesAll,
        .afterwards = m_choices.at(static_cast<std::size_t>(std::max(m_afterwards->currentIndex(), 0)))};
    Contents contents{.job = job};
    const auto steps = encoder.planned({job});
    const Words words = steps ? wordsOf(encoder, *steps) : Words();
    if (!steps)
        contents.problem = steps.error();
    contents.rows = words.rows;
    const auto count = words.rows.size();
    contents.write = count == 1 ? tr("&Write this word") : tr("&Write these %1 words").arg(count);
    if (count == 0)
        contents.notes << nothingToWrite(encoder);
    if (count > 0 && !writesAll)
        contents.notes << readsFirstText();
    if (count > 0)
        contents.notes << tr("Not listed are the words that read: 2020.... and the 00000000 behind each.");
    if (!writesAll && !words.thereAlready.isEmpty())
        contents.notes << tr("Sent although already there: %1. Outside cam mode the word after it would mean "
                             "something else.")
                              .arg(words.thereAlready.join(QStringLiteral(", ")));
    contents.notes << tr("A program that is changed is stored in EEPROM when it is left: one write.");
    return contents;
}

} // namespace codewheel
